//! Forces in generated code, against what textbooks say and against the interpreter.

use mech_compiler::evaluate::Machine;
use mech_compiler::program::Forces;
use mech_runtime::Cause;
use mech_test_support::mechanism_of;
use std::f64::consts::{FRAC_PI_2, PI};

include!(concat!(env!("OUT_DIR"), "/statics.rs"));

#[test]
fn a_press_needs_the_torque_that_textbooks_say() {
    let mut press = Press::new();
    press.set_work([-100.0, 0.0]).expect("finite");
    for degrees in [10, 45, 90, 140, 220, 300] {
        let angle = f64::from(degrees).to_radians();
        let [torque] = press.hold_at([angle]).expect("it turns");
        // Norton, Design of Machinery: F r (sin θ + (r / l) sin θ cos θ / cos φ).
        let lean = (0.5 * angle.sin() / 2.0).asin();
        let expected = -100.0 * 0.5 * (angle.sin() + 0.25 * angle.sin() * angle.cos() / lean.cos());
        assert!((torque - expected).abs() < 1e-12 * 100.0, "{degrees}: {torque}, not {expected}");
        let forces = press.forces([0.0], [0.0]).expect("it is regular");
        assert!((forces.torques[0] - torque).abs() < 1e-12 * 100.0);
        // The rod is a strut: what it carries points along it, and the bed takes what is across.
        let [_, _, small, bed] = forces.reactions;
        let thrust = 100.0 / lean.cos();
        assert!((small.x.hypot(small.y) - thrust).abs() < 1e-10, "{small:?}");
        assert!(
            (bed.y.abs() - 100.0 * lean.tan().abs()).abs() < 1e-10 && bed.x.abs() < 1e-12,
            "{bed:?}"
        );
        // Between the rod and the normal of the slide.
        assert!((forces.transmission[0] - (FRAC_PI_2 - lean.abs())).abs() < 1e-12, "{forces:?}");
        let [advantage] = press.work_advantage([1.0, 0.0]).expect("it is regular");
        assert!((advantage * torque + 100.0).abs() < 1e-9 * 100.0, "{advantage}");
    }
    assert_eq!(Press::JOINTS.map(|joint| joint.name), ["turn", "big", "small", "bed"]);
}

#[test]
fn at_the_dead_centre_the_advantage_is_infinite_and_no_torque_is_needed() {
    let mut press = Press::new();
    press.set_work([-100.0, 0.0]).expect("finite");
    let [torque] = press.hold_at([0.0]).expect("it turns");
    assert!(torque.abs() < 1e-13, "{torque}");
    let [advantage] = press.work_advantage([1.0, 0.0]).expect("the crank is the motor");
    assert!(advantage.abs() > 1e14, "{advantage}");
}

#[test]
fn at_a_dead_point_forces_are_an_error() {
    let mut engine = Engine::new();
    let _ = engine.move_toward([3.0]).expect("finite");
    assert!((engine.motors()[0] - 2.5).abs() < 1e-9);
    assert_eq!(engine.torques().map_err(|blocked| blocked.cause), Err(Cause::Singular));
    assert!(engine.forces([0.0], [0.0]).is_err());
    assert!(engine.motor_accelerations([0.0]).is_err());
    let before = engine;
    assert!(engine.simulate(0.01, [0.0]).is_err());
    assert_eq!(engine, before);
}

#[test]
fn gears_pass_torque_by_their_ratio_and_push_their_shafts_apart() {
    let mut hoist = Hoist::new();
    // The arm of the weight hangs out to one side.
    let [torque] = hoist.hold_at([core::f32::consts::PI]).expect("it turns");
    // The drum has turned back by a quarter: its weight is at x = +1.5.
    let weight = 4.0 * 10.0 * 1.5;
    assert!((torque.abs() - weight / 2.0).abs() < 1e-4, "{torque}");
    let forces = hoist.forces([0.0], [0.0]).expect("regular");
    // Teeth push with torque over pitch radius, 1 and 2, across the line of centres; the pinion's bearing pushes back.
    let [bearing, axle, mesh] = forces.reactions;
    assert!((mesh.y.abs() - weight / 2.0).abs() < 1e-4 && mesh.x.abs() < 1e-5, "{mesh:?}");
    assert!((bearing.y - mesh.y).abs() < 1e-4, "{bearing:?}");
    assert!((axle.y + mesh.y - 40.0).abs() < 1e-3, "{axle:?}");
    let [advantage] = hoist.brake_advantage().expect("regular");
    assert!((advantage - 2.0).abs() < 1e-6, "{advantage}");
    // A brake that holds the weight leaves nothing to the motor.
    hoist.set_brake(-torque * advantage).expect("finite");
    let [held] = hoist.torques().expect("regular");
    assert!(held.abs() < 1e-3, "{held}");
}

#[test]
fn loads_that_are_not_finite_are_refused() {
    let mut press = Press::new();
    press.set_work([1.0, 2.0]).expect("finite");
    let refused = press.set_work([f64::NAN, 0.0]);
    assert_eq!(
        refused.map_err(|blocked| (blocked.place, blocked.cause)),
        Err(("work", Cause::NotFinite))
    );
    assert_eq!(press.work(), [1.0, 2.0]);
    assert!(press.work_advantage([0.0, 0.0]).is_err());
    assert!(press.forces([f64::INFINITY], [0.0]).is_err());
}

#[test]
fn generated_code_finds_what_the_interpreter_finds() {
    let (_, press) = mechanism_of::<Press>(include_str!("subjects/statics/press.mech"));
    let (_, engine) = mechanism_of::<Engine>(include_str!("subjects/statics/engine.mech"));
    let mut generated = Press::new();
    generated.set_work([-3.0, 1.0]).expect("finite");
    let inverse_dynamics = press.forced.inverse_dynamics.as_ref().expect("asked for");
    let mut machine = Machine::<f64>::new(inverse_dynamics);
    let mut driven = Engine::new();
    let inertia = engine.forced.inertia.as_ref().expect("asked for");
    let mut other = Machine::<f64>::new(inertia);
    for step in 0..40 {
        let angle = f64::from(step) * 0.15;
        generated.move_to([angle]).expect("it turns");
        machine.move_to(&[angle]).expect("it turns");
        let found = generated.forces([1.5], [0.3]).expect("regular");
        let Ok(Forces::InverseDynamics(expected)) = machine.forces(&[1.5], &[0.3], &[-3.0, 1.0])
        else {
            panic!("it is regular");
        };
        assert_eq!(found.torques[..], expected.torques[..]);
        let reactions = found.reactions.map(|reaction| [reaction.x, reaction.y, reaction.torque]);
        assert_eq!(reactions[..], expected.reactions[..]);
        assert_eq!(found.transmission[..], expected.transmission[..]);
        let value = 2.0 + 0.4 * (angle / PI).sin();
        driven.move_to([value]).expect("it slides");
        driven.set_rates([0.7]).expect("finite");
        other.move_to(&[value]).expect("it slides");
        let Ok(Forces::Inertia(felt)) = other.forces(&[0.7], &[0.0], &[]) else {
            panic!("it is regular");
        };
        assert_eq!(driven.energy().expect("regular"), felt.energy);
        let second = driven.motor_accelerations([2.0]).expect("regular")[0];
        let expected = (2.0 + felt.drive[0]) / felt.matrix[0][0];
        assert!((second - expected).abs() <= 1e-14 * expected.abs());
    }
}
