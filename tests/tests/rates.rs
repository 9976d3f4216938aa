//! Velocities and accelerations: exact, held against finite differences of positions, on random mechanisms and on those of the
//! zoo and the gallery.

use mech_compiler::compile;
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::{Effects, LinkId, Method, Model, Precision, Shown};
use mech_compiler::program::{Position, Program};
use mech_test_support::{
    Dice, Sample, add_cam, cases, coupled_samples, differences, for_all, grow, known, samples,
    seeds, shuffled, size, with_own_params,
};

/// A step of the time, in which motors move about a unit a unit.
const STEP: f64 = 1e-3;

/// How many mechanisms a test tries.
const CASES: u64 = 60;

/// What was compared.
#[derive(Debug, Default)]
struct Seen {
    compared: u64,
    singular: usize,
    /// The greatest error, as a part of what the differences explain.
    worst: f64,
}

/// The pose numbers of all links, in a row: angles by their directions.
fn numbers(position: &Position<f64>) -> Vec<[f64; 4]> {
    position.poses.clone()
}

/// The positions at five equal steps of the time round now, if it moves through all of them.
fn five(
    program: &Program,
    at: &Position<f64>,
    (rates, seconds): (&[f64], &[f64]),
    step: f64,
) -> Option<[Vec<[f64; 4]>; 5]> {
    let mut found = Vec::new();
    for index in -2..=2 {
        let time = f64::from(index) * step;
        let motors: Vec<f64> = (0..rates.len())
            .map(|motor| {
                at.motors[motor] + rates[motor] * time + 0.5 * seconds[motor] * time * time
            })
            .collect();
        let mut machine = Machine::new(program);
        machine.put_back(at.clone());
        machine.move_to(&motors).ok()?;
        found.push(numbers(machine.position()));
    }
    found.try_into().ok()
}

/// Angular and linear rates, first and second, by differences.
fn by_differences(five: &[Vec<[f64; 4]>; 5], link: usize, step: f64) -> [[f64; 3]; 2] {
    let part = |part: usize| differences(five.each_ref().map(|poses| poses[link][part]), step);
    let [cos, sin, x, y] = [0, 1, 2, 3].map(part);
    let [c, s, ..] = five[2][link];
    // The angle's rates from those of its cosine and sine.
    let turning = [c * sin[0] - s * cos[0], c * sin[1] - s * cos[1]];
    [[turning[0], x[0], y[0]], [turning[1], x[1], y[1]]]
}

/// Compares rates with differences where the model has moved to.
fn compare(model: &Model, dice: &mut Dice, places: usize, seen: &mut Seen) {
    let Ok(compiled) = compile(model) else {
        return;
    };
    let moving = compiled.moving.expect("velocities were asked for");
    let mut machine = Machine::<f64>::new(&moving);
    let count = moving.motors.len();
    for _ in 0..places {
        let motors: Vec<f64> =
            machine.position().motors.iter().map(|motor| motor + dice.between(-0.7, 0.7)).collect();
        let _ = machine.move_toward(&motors);
        let rates: Vec<f64> = (0..count).map(|_| dice.between(-1.0, 1.0)).collect();
        let seconds: Vec<f64> = (0..count).map(|_| dice.between(-1.0, 1.0)).collect();
        let at = machine.position().clone();
        let moved = match machine.motion(&rates, &seconds) {
            Ok(moved) => moved,
            Err(Stop::Singular(_)) => {
                seen.singular += 1;
                continue;
            }
            Err(stop) => panic!("{}: {stop:?}", model.name),
        };
        let given = (&rates[..], &seconds[..]);
        let fine = five(&compiled.program, &at, given, STEP);
        let coarse = five(&compiled.program, &at, given, 2.0 * STEP);
        let (Some(fine), Some(coarse)) = (fine, coarse) else {
            // It is too near a limit to be moved in both directions.
            continue;
        };
        let accelerations = moved.accelerations.expect("accelerations were asked for");
        for link in 0..moving.links.len() {
            let (near, far) =
                (by_differences(&fine, link, STEP), by_differences(&coarse, link, 2.0 * STEP));
            for (order, exact) in [moved.velocities[link], accelerations[link]].iter().enumerate() {
                for part in 0..3 {
                    // The difference of two step lengths tells what the differences are worth, and rounding does.
                    let truncation = (near[order][part] - far[order][part]).abs();
                    let extent =
                        size(model) + fine[2][link][2].abs() + fine[2][link][3].abs() + 1.0;
                    let rounding =
                        1e-12 * extent / STEP.powi(i32::try_from(order).unwrap_or(0) + 1);
                    let most = truncation + rounding;
                    let off = (near[order][part] - exact[part]).abs();
                    assert!(
                        off <= most,
                        "{}, link {}, order {}, part {part}: {} exact, {} by differences, off by {off:e}, explained {most:e}",
                        model.name,
                        moving.links[link],
                        order + 1,
                        exact[part],
                        near[order][part],
                    );
                    seen.worst = seen.worst.max(off / most);
                    seen.compared += 1;
                }
            }
        }
    }
}

fn with_effects(model: &mut Model) {
    model.effects = Effects { velocity: true, acceleration: true, ..Effects::default() };
}

#[test]
fn rates_of_random_mechanisms_are_those_of_their_positions() {
    let mut seen = Seen::default();
    for_all(CASES, &samples(1..=8), |Sample { grown, mut dice }| {
        let mut model = grown.model;
        with_effects(&mut model);
        model.precision = Precision::F64;
        if dice.once_in(3) {
            model.method = Some(Method::Newton);
        }
        compare(&model, &mut dice, 6, &mut seen);
    });
    println!("{seen:?}");
    assert!(seen.compared > 20 * cases(CASES));
}

#[test]
fn rates_of_what_is_solved_together_are_those_of_its_positions() {
    let mut seen = Seen::default();
    for_all(CASES / 2, &coupled_samples(1..=3), |Sample { mut grown, mut dice }| {
        with_effects(&mut grown.model);
        compare(&grown.model, &mut dice, 4, &mut seen);
    });
    println!("{seen:?}");
    assert!(seen.compared > 20 * cases(CASES / 2));
}

#[test]
fn rates_of_followers_are_those_of_their_positions() {
    let mut seen = Seen::default();
    // By seeds: where a shaft slides by many periods of its law within a step, differences say nothing.
    for seed in seeds(cases(CASES)) {
        let mut dice = Dice::new(seed);
        let additions = 1 + dice.below(6);
        let mut model = grow(&mut dice, additions).model;
        with_effects(&mut model);
        for _ in 0..=dice.below(3) {
            add_cam(&mut model, &mut dice);
        }
        if model.cams().next().is_some() {
            compare(&shuffled(&model, &mut dice), &mut dice, 4, &mut seen);
        }
    }
    println!("{seen:?}");
    assert!(seen.compared > 20 * cases(CASES));
}

#[test]
fn what_is_shown_moves_as_it_does_in_the_whole() {
    let mut compared = 0;
    for_all(CASES, &samples(2..=7), |Sample { grown, mut dice }| {
        let mut whole = grown.model;
        with_effects(&mut whole);
        let links: Vec<LinkId> = whole.declared_links().collect();
        let link = *dice.pick(&links);
        let mut part = whole.clone();
        part.show = Some(vec![Shown::Link(link)]);
        let (Ok(whole), Ok(part)) = (compile(&whole), compile(&part)) else {
            return;
        };
        let (whole, part) = (whole.moving.expect("asked"), part.moving.expect("asked"));
        let (mut all, mut one) = (Machine::<f64>::new(&whole), Machine::<f64>::new(&part));
        for _ in 0..4 {
            let mut near = |_: usize| dice.between(-0.3, 0.3);
            let motors: Vec<f64> = (0..whole.motors.len()).map(&mut near).collect();
            let rates: Vec<f64> = (0..whole.motors.len()).map(&mut near).collect();
            if all.move_to(&motors).is_err() || one.move_to(&motors).is_err() {
                continue;
            }
            let (Ok(expected), Ok(found)) =
                (all.motion(&rates, &rates), one.motion(&rates, &rates))
            else {
                continue;
            };
            let place = |program: &Program| program.place_of(link).expect("it is shown");
            let (a, b) = (place(&whole), place(&part));
            let orders = [
                (expected.velocities[a], found.velocities[b]),
                (expected.accelerations.expect("asked")[a], found.accelerations.expect("asked")[b]),
            ];
            for (expected, found) in orders {
                for (expected, found) in expected.into_iter().zip(found) {
                    assert!(
                        (expected - found).abs() <= 1e-9 * (1.0 + expected.abs()),
                        "{found} instead of {expected}"
                    );
                    compared += 1;
                }
            }
        }
    });
    assert!(compared > 5 * cases(CASES), "{compared}");
}

#[test]
fn rates_of_the_zoo_and_the_gallery_are_those_of_their_positions() {
    let mut seen = Seen::default();
    let mut dice = Dice::new(5);
    for mut model in known().into_iter().chain(with_own_params()) {
        with_effects(&mut model);
        compare(&model, &mut dice, 12, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.compared > 1000);
}
