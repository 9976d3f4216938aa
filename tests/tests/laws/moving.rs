//! Random mechanisms whose motors follow laws.

use super::EFFECTS;
use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LawId, Method, Model, Precision};
use mech_test_support::{Dice, Sample, cases, differences, for_all, samples, size};

/// A mechanism whose motors all follow smooth laws from where they start.
fn with_laws(mut model: Model, dice: &mut Dice) -> Model {
    model.effects = EFFECTS;
    model.precision = Precision::F64;
    if dice.once_in(3) {
        model.method = Some(Method::Newton);
    }
    for motor in 0..model.motors.len() {
        let (speed, pace) = (dice.between(-0.7, 0.7), dice.between(0.3, 1.5));
        let start = model.start.value(model.motors[motor].joint);
        let text = match dice.below(3) {
            0 => format!("{start} + {speed} * sin({pace} * t)"),
            1 => format!("{start} + {speed} * t / (1 + t * t)"),
            _ => format!("{start} + {speed} * (1 - exp(-t * t))"),
        };
        model.motors[motor].law = Some(LawId::new(model.laws.len()));
        model.laws.push(mech_test_support::law(&text));
    }
    model
}

#[test]
fn velocities_in_time_are_those_of_positions_in_time() {
    let mut compared = 0;
    for_all(200, &samples(1..=6), |Sample { grown, mut dice }| {
        compared += compare(grown.model, &mut dice);
    });
    println!("{compared} compared");
    assert!(compared > 10 * cases(200));
}

/// Compares velocities and accelerations with differences of positions in time; gives how many were compared.
fn compare(model: Model, dice: &mut Dice) -> u64 {
    const STEP: f64 = 1e-3;
    let model = with_laws(model, dice);
    let Ok(compiled) = compile(&model) else {
        return 0;
    };
    let moving = compiled.moving.expect("velocities were asked for");
    let timing = compiled.timing.expect("motors have laws");
    let at = |time: f64, order: usize| -> Vec<f64> {
        let all = timing.at(time, &[]);
        all.iter().map(|values| values[order]).collect()
    };
    let mut compared = 0;
    for _ in 0..4 {
        let time = dice.between(0.1, 1.0);
        let mut machine = Machine::<f64>::new(&moving);
        if machine.move_to(&at(time, 0)).is_err() {
            continue;
        }
        let Ok(found) = machine.motion(&at(time, 1), &at(time, 2)) else {
            continue;
        };
        let there = machine.position().clone();
        let poses = |time: f64| {
            let mut machine = Machine::<f64>::new(&moving);
            machine.put_back(there.clone());
            machine.move_to(&at(time, 0)).ok()?;
            Some(machine.position().poses.clone())
        };
        let sampled = |step: f64| -> Option<Vec<_>> {
            (-2..=2)
                .map(|number| poses(time + f64::from(number) * step))
                .collect()
        };
        let (Some(fine), Some(coarse)) = (sampled(STEP), sampled(2.0 * STEP)) else {
            continue;
        };
        let accelerations = found.accelerations.expect("accelerations were asked for");
        for link in 0..moving.links.len() {
            for (number, part) in [(1, 2), (2, 3)] {
                let of = |poses: &Vec<Vec<[f64; 4]>>, step| {
                    differences(std::array::from_fn(|index| poses[index][link][part]), step)
                };
                let (near, far) = (of(&fine, STEP), of(&coarse, 2.0 * STEP));
                let exact = [found.velocities[link][number], accelerations[link][number]];
                let reach = size(&model) + there.poses[link][part].abs() + 1.0;
                for (order, power) in [(0, 1), (1, 2)] {
                    let most = (near[order] - far[order]).abs() + 1e-12 * reach / STEP.powi(power);
                    assert!(
                        (near[order] - exact[order]).abs() <= most,
                        "link {link}, order {order}: {} instead of {}, explained {most:e}",
                        exact[order],
                        near[order]
                    );
                    compared += 1;
                }
            }
        }
    }
    compared
}
