//! Forces: three ways to find them (virtual work, the equilibrium of each link, reduced inertia) must agree, each link must obey
//! Newton and Euler, and torques at rest must be the slope of the energy: on random mechanisms with random masses, springs, dampers
//! and loads, and on those of the zoo.

mod acts;
mod falls;
mod flat;
mod random_actions;

use acts::{by_actions, by_joints, follow, scene_point};
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::Model;
use mech_compiler::program::{Forces, Inertia, InverseDynamics};
use mech_compiler::{Compiled, compile};
use mech_test_support::{
    Dice, Sample, coupled_samples, differences, for_all, known, reach, samples, size,
};
use proptest::prelude::*;
use random_actions::load_up;

#[derive(Debug, Default)]
struct Seen {
    places: usize,
    singular: usize,
    torques: usize,
    links: usize,
    slopes: usize,
}

/// Where a mechanism is, and what it is given there.
struct Given {
    rates: Vec<f64>,
    seconds: Vec<f64>,
    loads: Vec<f64>,
    /// The angle of each revolute joint, over any number of turns.
    angles: Vec<f64>,
}

fn check(model: &Model, dice: &mut Dice, places: usize, seen: &mut Seen) {
    let Ok(compiled) = compile(model) else {
        return;
    };
    let (Some(inverse_dynamics), Some(inertia), Some(holding)) =
        (&compiled.forced.inverse_dynamics, &compiled.forced.inertia, &compiled.forced.holding)
    else {
        return;
    };
    let mut machine = Machine::<f64>::new(&compiled.program);
    let count = compiled.program.motors.len();
    let mut angles = vec![0.0; model.joints.len()];
    follow(&mut angles, model, machine.position());
    for _ in 0..places {
        let steps: Vec<f64> =
            (0..machine.position().motors.len()).map(|_| dice.between(-0.7, 0.7) / 64.0).collect();
        for _ in 0..64 {
            let motors = machine.position().motors.iter().zip(&steps);
            let motors: Vec<f64> = motors.map(|(motor, step)| motor + step).collect();
            let _ = machine.move_toward(&motors);
            follow(&mut angles, model, machine.position());
        }
        let mut some =
            |count: usize| -> Vec<f64> { (0..count).map(|_| dice.between(-1.0, 1.0)).collect() };
        let given = Given {
            rates: some(count),
            seconds: some(count),
            loads: some(model.actions.load_names().len()),
            angles: angles.clone(),
        };
        let at = machine.position().clone();
        let found = |program, rates: &[f64], seconds: &[f64]| {
            let mut machine = Machine::<f64>::new(program);
            machine.put_back(at.clone());
            machine.forces(rates, seconds, &given.loads)
        };
        let zero = vec![0.0; count];
        let moving = found(inverse_dynamics, &given.rates, &given.seconds);
        let Forces::InverseDynamics(moving) = (match moving {
            Err(Stop::Singular(_)) => {
                seen.singular += 1;
                continue;
            }
            other => other.unwrap_or_else(|stop| panic!("{}: {stop:?}", model.name)),
        }) else {
            panic!("not what it takes to move");
        };
        let (
            Ok(Forces::InverseDynamics(resting)),
            Ok(Forces::Holding(held)),
            Ok(Forces::Inertia(felt)),
        ) = (
            found(inverse_dynamics, &zero, &zero),
            found(holding, &zero, &zero),
            found(inertia, &given.rates, &zero),
        )
        else {
            panic!("{}: some forces are found and some are not", model.name);
        };
        let reach = size(model) + reach(&at.poses);
        let [most_moving, most_resting] = [&moving, &resting].map(|found| largest(found, reach));
        if most_moving.max(most_resting) > 1e6 * reach {
            // So near a dead point that what is left of them is rounding.
            seen.singular += 1;
            continue;
        }
        seen.places += 1;
        let agree = |found: &[f64], expected: &[f64], scale: f64, what: &str| {
            for (found, expected) in found.iter().zip(expected) {
                assert!(
                    (found - expected).abs() <= 1e-10 * scale,
                    "{}: {what}: {found}, not {expected}, of {scale}",
                    model.name
                );
            }
        };
        agree(&resting.torques, &held, most_resting, "torques at rest");
        let felt = by_inertia(&felt, &given.seconds);
        agree(&moving.torques, &felt, most_moving, "torques in motion");
        seen.torques += 2 * count;
        let found = (&at, &given);
        newton_and_euler(model, &compiled, found, &moving, most_moving, seen);
        slopes(model, &compiled, (&at, &held, &given), most_resting, seen);
    }
}

/// How large the forces are that cancel: near a dead point they are larger than what is left of them.
fn largest(inverse_dynamics: &InverseDynamics<f64>, reach: f64) -> f64 {
    let reactions = inverse_dynamics.reactions.iter();
    let reactions = reactions.map(|[x, y, torque]| x.hypot(*y) * reach + torque.abs());
    reactions.fold(1.0, f64::max)
}

/// What the motors have to do by their reduced inertia.
fn by_inertia(felt: &Inertia<f64>, seconds: &[f64]) -> Vec<f64> {
    let rows = felt.matrix.iter().zip(&felt.drive);
    let torque = |(row, drive): (&Vec<f64>, &f64)| {
        let inertia: f64 = row.iter().zip(seconds).map(|(part, second)| part * second).sum();
        inertia - drive
    };
    rows.map(torque).collect()
}

type Position = mech_compiler::program::Position<f64>;

/// Each link: forces are mass times acceleration, and moments about its centre are inertia times angular acceleration.
fn newton_and_euler(
    model: &Model,
    compiled: &Compiled,
    (at, given): (&Position, &Given),
    inverse_dynamics: &InverseDynamics<f64>,
    scale: f64,
    seen: &mut Seen,
) {
    let mut machine = Machine::<f64>::new(compiled.moving.as_ref().expect("asked for"));
    machine.put_back(at.clone());
    let moved = machine.motion(&given.rates, &given.seconds).expect("it is regular");
    let accelerations = moved.accelerations.as_ref().expect("asked for");
    let (mut acts, rolls) = by_joints(model, at, inverse_dynamics);
    acts.extend(by_actions(model, (at, given), &moved));
    for (index, link) in model.declared_links().enumerate() {
        let mass = model.link(link).mass.expect("all have one");
        let center = scene_point(at, link, mass.center);
        let [_, _, u, v] = at.poses[index];
        let ([turning, ..], [change, x, y]) = (moved.velocities[index], accelerations[index]);
        let arm = [center[0] - u, center[1] - v];
        let acceleration = [
            x - change * arm[1] - turning * turning * arm[0],
            y + change * arm[0] - turning * turning * arm[1],
        ];
        let gravity = model.actions.gravity.unwrap_or_default();
        let mut sums = [
            mass.mass * (gravity[0] - acceleration[0]),
            mass.mass * (gravity[1] - acceleration[1]),
            -mass.inertia * change,
        ];
        for (_, point, force, torque) in acts.iter().filter(|(on, ..)| *on == link) {
            let arm = [point[0] - center[0], point[1] - center[1]];
            sums[0] += force[0];
            sums[1] += force[1];
            sums[2] += arm[0] * force[1] - arm[1] * force[0] + torque;
        }
        let count = if rolls.contains(&link) { 2 } else { 3 };
        let scale = [scale / size(model), scale / size(model), scale];
        for (sum, scale) in sums.iter().zip(scale).take(count) {
            assert!(
                sum.abs() <= 1e-10 * scale.max(scale * size(model)),
                "{}, link {}: {sums:?} of {scale}",
                model.name,
                model.link(link).name
            );
            seen.links += 1;
        }
    }
}

/// Without loads, torques at rest are the slope of the potential energy.
fn slopes(
    model: &Model,
    compiled: &Compiled,
    (at, held, given): (&Position, &[f64], &Given),
    scale: f64,
    seen: &mut Seen,
) {
    let inertia = compiled.forced.inertia.as_ref().expect("asked for");
    let inverse_dynamics = compiled.forced.inverse_dynamics.as_ref().expect("asked for");
    let zero = vec![0.0; held.len()];
    let unloaded = vec![0.0; given.loads.len()];
    let step = 1e-3;
    for motor in 0..held.len() {
        let energy = |displacement: f64| {
            let mut machine = Machine::<f64>::new(inertia);
            machine.put_back(at.clone());
            let mut motors = at.motors.clone();
            motors[motor] += displacement;
            machine.move_to(&motors).ok()?;
            match machine.forces(&zero, &zero, &unloaded) {
                Ok(Forces::Inertia(felt)) => Some(felt.energy[1]),
                _ => None,
            }
        };
        let slope = |step: f64| {
            let [a, b, d, e] = [-2.0, -1.0, 1.0, 2.0].map(|part| energy(part * step));
            let [slope, _] = differences([a?, b?, 0.0, d?, e?], step);
            Some(slope)
        };
        let (Some(fine), Some(coarse)) = (slope(step), slope(2.0 * step)) else {
            continue;
        };
        let mut machine = Machine::<f64>::new(inverse_dynamics);
        machine.put_back(at.clone());
        let Ok(Forces::InverseDynamics(resting)) = machine.forces(&zero, &zero, &unloaded) else {
            continue;
        };
        let explained = (fine - coarse).abs() + 1e-9 * scale;
        let off = (fine - resting.torques[motor]).abs();
        assert!(
            off <= explained,
            "{}: torque {}, slope {fine}, explained {explained:e}",
            model.name,
            resting.torques[motor]
        );
        seen.slopes += 1;
    }
}

#[test]
fn forces_in_random_mechanisms_obey_newton_and_euler_and_virtual_work() {
    let mut seen = Seen::default();
    let mechanisms = prop_oneof![3 => samples(1..=7), 1 => coupled_samples(0..=3)];
    for_all(200, &mechanisms, |Sample { mut grown, mut dice }| {
        load_up(&mut grown.model, &mut dice);
        check(&grown.model, &mut dice, 4, &mut seen);
    });
    println!("{seen:?}");
    let cases = usize::try_from(mech_test_support::cases(200)).expect("not so many");
    assert!(seen.places > cases, "{seen:?}");
}

#[test]
fn forces_in_the_zoo_and_the_gallery_do_too() {
    let mut seen = Seen::default();
    let mut dice = Dice::new(11);
    for mut model in known() {
        load_up(&mut model, &mut dice);
        check(&model, &mut dice, 8, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.places > 50, "{seen:?}");
}
