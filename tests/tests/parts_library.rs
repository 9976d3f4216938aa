//! The parts of the library do what they are known for; views tell what the mechanism tells.

use mech_runtime::{Mechanism, Point2};
use std::f64::consts::{PI, TAU};

include!(concat!(env!("OUT_DIR"), "/parts_library.rs"));

fn apart(a: Point2<f64>, b: [f64; 2]) -> f64 {
    (a.x - b[0]).hypot(a.y - b[1])
}

#[test]
fn the_inversor_draws_a_straight_line() {
    let mut inversor = Inversor::new();
    for step in -60..=30 {
        inversor.move_to([60_f64.to_radians() + f64::from(step).to_radians()]).expect("it turns");
        // (25 - 6.25) / 4, with arms of 5, sides of 2.5 and a crank of 2.
        let x = inversor.it().upper_far_tip().x;
        assert!((x - 4.6875).abs() < 1e-12, "{x}");
    }
}

#[test]
fn a_pantograph_copies() {
    let mut copier = Copier::new();
    for step in 0..20 {
        let swing = f64::from(step) * 0.05;
        copier.move_to([2.0 + swing, -2.0 + 1.2 * swing.sin()]).expect("it moves");
        let (tracer, guide) = (copier.it().follower_tracer(), copier.it().inner_guide());
        assert!(apart(tracer, [1.5 * guide.x, 1.5 * guide.y]) < 1e-12);
    }
}

#[test]
fn a_scissor_lift_stays_level() {
    let mut lift = Lift::new();
    for degrees in [15.0_f64, 30.0, 45.0, 60.0] {
        let angle = degrees.to_radians();
        lift.move_to([angle; 2]).expect("it rises");
        let top = lift.high().top();
        assert!(top.rotation.angle().abs() < 1e-12);
        assert!((top.translation.y - 4.0 * angle.sin()).abs() < 1e-12);
    }
}

#[test]
fn legs_differ_in_phase_alone() {
    let mut legs = Legs::new();
    let mut feet = [Vec::new(), Vec::new()];
    for step in 0..24 {
        legs.move_to([f64::from(step) * TAU / 24.0]).expect("it walks");
        let jansen: Vec<_> = (0..6).map(|k| legs.jansen(k).foot_tip()).collect();
        let klann: Vec<_> = (0..4).map(|k| legs.klann(k).leg_foot()).collect();
        feet[0].push(jansen);
        feet[1].push(klann);
        let (large, scaled) = (legs.large().leg_foot(), legs.scaled().leg_foot());
        assert!((large - scaled).norm() < 1e-12);
        assert!((large - 10.0 * legs.klann(0).leg_foot().coords).coords.norm() < 1e-12);
    }
    for step in 0..24 {
        for k in 0..6 {
            let ahead = feet[0][(step + 4 * k) % 24][0];
            assert!((feet[0][step][k] - ahead).norm() < 1e-9, "{k} at {step}");
        }
        for k in 0..4 {
            let ahead = feet[1][(step + 6 * k) % 24][0];
            assert!((feet[1][step][k] - ahead).norm() < 1e-9, "{k} at {step}");
        }
    }
    // As published: the foot of Jansen's leg at the start, and Klann's stride.
    assert!(apart(feet[0][0][0], [-43.16, -91.757]) < 2e-3, "{}", feet[0][0][0]);
    let x = |feet: &Vec<Point2<f64>>| feet[0].x;
    let (least, most) = feet[1]
        .iter()
        .map(x)
        .fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    assert!((most - least - 1.009).abs() < 0.02, "{}", most - least);
}

#[test]
fn a_mirrored_leg_is_the_mirror_image_of_the_other_turn() {
    let (mut legs, mut image) = (Legs::new(), Legs::new());
    for step in 0..24 {
        let angle = f64::from(step) * TAU / 24.0;
        legs.move_to([angle]).expect("it walks");
        // A mirrored crank pin is at half a turn less the angle.
        image.move_to([-angle]).expect("it walks");
        let (a, b) = (legs.jansen(2).foot_tip(), image.mirror(2).foot_tip());
        assert!(apart(b, [-a.x, a.y]) < 1e-10, "{a} {b}");
        assert!((legs.jansen(2).heel() + image.mirror(2).heel()).abs() < 1e-10);
    }
}

#[test]
fn a_planetary_stage_reduces_exactly() {
    let mut gears = Gears::new();
    gears.move_to([60.0 * TAU]).expect("it turns");
    // 1 + 48 / 12 turns of the sun for one of the arm.
    assert!((gears.arm_turns() - 12.0 * TAU).abs() < 1e-9);
}

#[test]
fn a_geneva_wheel_steps_and_dwells() {
    let mut index = Index::new();
    let start = index.it().index();
    for turn in 1..=3 {
        index.move_to([f64::from(turn) * TAU]).expect("it turns");
        let turned = index.it().index() - start;
        let whole = f64::from(turn) * PI / 2.0;
        let off = (turned - whole).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-9, "{turned}");
    }
    index.move_to([3.0 * TAU + PI]).expect("it turns");
    let dwelling = index.it().index();
    index.move_to([3.0 * TAU + PI + 0.5]).expect("it turns");
    assert!((index.it().index() - dwelling).abs() < 1e-9);
}

#[test]
fn an_oldham_coupling_turns_alike() {
    let mut coupled = Coupled::new();
    for step in 0..40 {
        let angle = f64::from(step) * 0.1;
        coupled.move_to([angle]).expect("it turns");
        let off = (coupled.it().output() - angle).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-12);
    }
}

#[test]
fn a_toggle_presses() {
    let mut press = Press::new();
    for degrees in [-60.0_f64, -70.0, -80.0, -89.0] {
        let angle = degrees.to_radians();
        press.move_to([angle]).expect("it presses");
        let (x, y) = (angle.cos(), angle.sin());
        let depth = -y + (1.5_f64 * 1.5 - x * x).sqrt();
        assert!((press.it().guide() - depth).abs() < 1e-12);
    }
}

#[test]
fn pistons_follow_the_crank() {
    let mut engine = Engine::new();
    for step in 0..36 {
        let angle = f64::from(step) * TAU / 36.0;
        engine.move_to([angle]).expect("it turns");
        for k in 0..2 {
            let bore = PI / 4.0 + PI / 2.0 * f64::from(u8::try_from(k).expect("small"));
            let (along, across) = (0.5 * (angle - bore).cos(), 0.5 * (angle - bore).sin());
            let expected = along + (1.8_f64 * 1.8 - across * across).sqrt();
            assert!((engine.bank(k).bore() - expected).abs() < 1e-12);
        }
    }
}

#[test]
fn views_reach_everything() {
    let mut hands = Hands::new();
    hands.move_to([0.0, 0.3, 0.0, 0.1, 0.0, 0.2]).expect("nothing is in the way");
    let tip = hands.hand(1).finger(1).bone_tip();
    let (wrist, root) = (0.3_f64, 0.5_f64);
    let expected = [
        10.0 + wrist.cos() - 2.0 * wrist.sin() - 2.0 * root.sin(),
        wrist.sin() + 2.0 * wrist.cos() + 2.0 * root.cos(),
    ];
    assert!(apart(tip, expected) < 1e-12);
    assert!((hands.hand(1).finger(1).root() - 0.2).abs() < 1e-15);
    // Loads belong to one finger each.
    let calm = hands.torques().expect("it is regular");
    hands.hand_mut(0).finger_mut(1).set_push([0.0, 3.0]).expect("it is finite");
    assert_eq!(hands.hand(0).finger(1).push(), [0.0, 3.0]);
    assert_eq!(hands.hand(0).finger(0).push(), [0.0; 2]);
    let pushed = hands.torques().expect("it is regular");
    let changed: Vec<bool> = calm.iter().zip(&pushed).map(|(a, b)| a != b).collect();
    assert_eq!(changed, [true, false, false, true, false, false]);
    // What only some instances have is optional.
    let traces =
        [0, 1].map(|k| hands.hand(1).finger(k).bone_tip_trace().map(mech_runtime::Trace::len));
    assert_eq!(traces, [None, Some(1)]);
    assert_eq!(Hands::MOTORS[3], "hand[0].finger[1].root");
}

#[test]
#[should_panic(expected = "`finger` has 2 instances; there is no `finger(2)`")]
fn there_is_no_third_finger() {
    let _ = Hands::new().hand(0).finger(2);
}
