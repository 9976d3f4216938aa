//! Params: what they change, held against mechanisms in which they are numbers; and how everything follows them, held against
//! differences of high order, on random mechanisms and on some that are compiled.

use mech_compiler::compile;
use mech_compiler::evaluate::{Machine, Stop, sensitivities};
use mech_compiler::model::{AtChangePoints, AxisId, JointId, JointKind, Method, Model};
use mech_compiler::program::ParamRates;
use mech_compiler::program::{Position, Program, Watch};
use mech_runtime::Pose;
use mech_test_support::{
    Dice, Sample, apart, cases, coordinate, differences, for_all, in_own_frames, known, reach,
    samples, scale, size, vary, with_ground, with_own_params, with_params, worst_gap,
    worst_stretch,
};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A step of a param.
const STEP: f64 = 1e-3;

/// How many random mechanisms a test tries.
const CASES: u64 = 60;

/// A random mechanism with params.
fn with_random_params(Sample { grown, mut dice }: Sample) -> (Model, Dice) {
    let mut model = grown.model;
    let params = 1 + dice.below(2);
    vary(&mut model, &mut dice, params);
    model.effects.sensitivity = true;
    if dice.once_in(3) {
        model.method = Some(Method::Newton);
    }
    (model, dice)
}

/// Moves the motors somewhere.
fn wander(machine: &mut Machine<'_, f64>, program: &Program, dice: &mut Dice) {
    let motors: Vec<f64> = machine.position().motors[..program.motors.len()]
        .iter()
        .map(|motor| motor + dice.between(-0.7, 0.7))
        .collect();
    let _ = machine.move_toward(&motors);
}

/// Where everything is that a mechanism reports: the angle, x and y of each link, the places of points, the coordinates of joints.
struct Places {
    links: Vec<[f64; 3]>,
    points: Vec<[f64; 2]>,
    joints: Vec<f64>,
}

/// By the definitions, from poses and params alone.
fn places(
    model: &Model,
    program: &Program,
    at: &Position<f64>,
    what: &(Vec<AxisId>, Vec<JointId>),
) -> Places {
    let there = with_params(model, &at.motors[program.motors.len()..]);
    let poses = with_ground(&there, &at.poses);
    let point = |&id: &AxisId| {
        let axis = there.axis(id);
        Pose::from(poses[axis.link.index()]).apply(axis.at)
    };
    let (points, joints) = what;
    let coordinate = |&joint: &JointId| coordinate(&there, &poses, joint).0;
    let links = at.poses.iter();
    let link = |[cos, sin, x, y]: &[f64; 4]| [sin.atan2(*cos), *x, *y];
    Places {
        links: links.map(link).collect(),
        points: points.iter().map(point).collect(),
        joints: joints.iter().map(coordinate).collect(),
    }
}

/// All numbers in a row; of each, whether it is an angle.
fn row(places: &Places, model: &Model, joints: &[JointId]) -> Vec<(f64, bool)> {
    let links =
        places.links.iter().flat_map(|[angle, x, y]| [(*angle, true), (*x, false), (*y, false)]);
    let points = places.points.iter().flatten().map(|&number| (number, false));
    let turns = |joint: &JointId| matches!(model.joint(*joint).kind, JointKind::Revolute(..));
    let joints = places.joints.iter().zip(joints).map(|(&number, joint)| (number, turns(joint)));
    links.chain(points).chain(joints).collect()
}

fn rates_in_a_row(followed: &ParamRates<f64>) -> Vec<f64> {
    let links = followed.links.iter().flatten();
    let points = followed.points.iter().flatten();
    links.chain(points).chain(&followed.joints).copied().collect()
}

/// First differences of fourth order; angles are followed over whole turns.
fn difference(f: [(f64, bool); 5], step: f64) -> f64 {
    let middle = f[2].0;
    let f = f.map(|(value, is_angle)| {
        let turns = if is_angle { ((value - middle) / TAU).round() } else { 0.0 };
        value - TAU * turns
    });
    differences(f, step)[0]
}

/// What was compared.
#[derive(Debug, Default)]
struct Seen {
    compared: u64,
    singular: usize,
    blocked: usize,
    /// The greatest error, as a part of what the differences explain.
    worst: f64,
}

/// Compares sensitivities with differences of assembled positions.
fn compare(model: &Model, dice: &mut Dice, seen: &mut Seen) -> Result<(), TestCaseError> {
    let Ok(compiled) = compile(model) else {
        return Err(TestCaseError::reject("it does not compile"));
    };
    let sensitive = compiled.sensitive.expect("it was asked for");
    let program = &compiled.program;
    let known = sensitive.sensitivity().expect("it was asked for");
    let what = (known.points.clone(), known.joints.clone());
    let mut machine = Machine::<f64>::new(program);
    for _ in 0..3 {
        wander(&mut machine, program, dice);
        let at = machine.position().clone();
        // At a change point they are not determined, and within rounding of it neither.
        let stands =
            |watch: &Watch| at.state[watch.sine].powi(2) <= at.state[watch.rounding_square];
        if program.watches.iter().any(stands) {
            seen.singular += 1;
            continue;
        }
        let exact = match sensitivities(&sensitive, &at) {
            Ok(exact) => exact,
            Err(Stop::Singular(_)) => {
                seen.singular += 1;
                continue;
            }
            Err(stop) => panic!("{stop:?}"),
        };
        let params = machine.params().to_vec();
        for (param, followed) in exact.iter().enumerate() {
            let five = |step: f64| -> Option<[Vec<(f64, bool)>; 5]> {
                let found = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|part: f64| {
                    let mut params = params.clone();
                    params[param] += part * step;
                    let mut machine = Machine::new(program);
                    machine.put_back(at.clone());
                    machine.set_params(&params).ok()?;
                    let places = places(model, program, machine.position(), &what);
                    Some(row(&places, model, &what.1))
                });
                let [Some(a), Some(b), Some(c), Some(d), Some(e)] = found else {
                    return None;
                };
                Some([a, b, c, d, e])
            };
            let (Some(fine), Some(coarse)) = (five(STEP), five(2.0 * STEP)) else {
                // It is too near a limit to be changed in both directions.
                seen.blocked += 1;
                continue;
            };
            let extent = size(model)
                + fine[2].iter().fold(1.0, |most: f64, (number, _)| most.max(number.abs()));
            for (index, exact) in rates_in_a_row(followed).into_iter().enumerate() {
                let near = difference(fine.each_ref().map(|row| row[index]), STEP);
                let far = difference(coarse.each_ref().map(|row| row[index]), 2.0 * STEP);
                let most = (near - far).abs() + 1e-12 * extent / STEP;
                let off = (near - exact).abs();
                prop_assert!(
                    off <= most,
                    "param {param}, number {index}: {exact} exact, {near} by differences, off by {off:e}, explained {most:e}"
                );
                seen.worst = seen.worst.max(off / most);
                seen.compared += 1;
            }
        }
    }
    Ok(())
}

#[test]
fn sensitivities_of_random_mechanisms_are_those_of_their_positions() {
    let seen = std::cell::RefCell::new(Seen::default());
    let cases = u32::try_from(cases(CASES)).expect("not so many");
    let config = ProptestConfig {
        max_global_rejects: 10 * cases,
        failure_persistence: None,
        ..ProptestConfig::with_cases(cases)
    };
    proptest!(config, |(sample in samples(1..=8))| {
        let (model, mut dice) = with_random_params(sample);
        compare(&model, &mut dice, &mut seen.borrow_mut())?;
    });
    println!("{seen:?}");
    assert!(seen.borrow().compared > 20 * u64::from(cases));
}

/// A mechanism moves as one in which the params are numbers, closes as well, and comes back to where it was.
#[test]
fn params_are_numbers_that_may_be_changed() {
    let (mut moved, mut changed, mut blocked) = (0, 0, 0);
    let mut worst = [0.0_f64; 3];
    for_all(CASES, &samples(1..=8), |sample| {
        let (model, mut dice) = with_random_params(sample);
        let (Ok(with), Ok(without)) = (
            compile(&model),
            compile(&with_params(&model, &model.params.values().collect::<Vec<_>>())),
        ) else {
            return;
        };
        let (mut own, mut other) =
            (Machine::<f64>::new(&with.program), Machine::<f64>::new(&without.program));
        let count = with.program.motors.len();
        for _ in 0..6 {
            let motors: Vec<f64> = own.position().motors[..count]
                .iter()
                .map(|motor| motor + dice.between(-0.3, 0.3))
                .collect();
            if other.move_to(&motors).is_err() {
                break;
            }
            if let Err(stop) = own.move_to(&motors) {
                panic!("{stop:?} where a number is none in the way");
            }
            let extent = size(&model) + reach(&own.position().poses);
            worst[0] = worst[0].max(apart(&own.position().poses, &other.position().poses) / extent);
            moved += 1;
        }
        let before = own.position().clone();
        let params = own.params().to_vec();
        let wanted: Vec<f64> = params.iter().map(|value| value * dice.between(0.7, 1.4)).collect();
        if own.set_params(&wanted).is_err() {
            assert_eq!(*own.position(), before, "what fails leaves it as it was");
            blocked += 1;
            return;
        }
        let there = with_params(&model, &wanted);
        let poses = with_ground(&there, &own.position().poses);
        let extent = size(&there) + reach(&poses);
        worst[1] = worst[1].max(worst_gap(&there, &poses) / extent).max(worst_stretch(&poses));
        if own.set_params(&params).is_ok() {
            worst[2] = worst[2].max(apart(&own.position().poses, &before.poses) / extent);
            changed += 1;
        }
    });
    println!(
        "{moved} moves, {changed} changes, {blocked} blocked; apart, open and not back: {worst:?}"
    );
    assert!(moved > cases(CASES) && changed > cases(CASES) / 2, "{moved} {changed}");
    assert!(worst[0] < 1e-11 && worst[1] < 1e-13 && worst[2] < 1e-11, "{worst:?}");
}

/// A value that is set is as good as one that is declared.
#[test]
fn what_is_set_might_have_been_declared() {
    let mut compared = 0;
    let mut worst = 0.0_f64;
    for_all(CASES, &samples(1..=8), |sample| {
        let (drawn, mut dice) = with_random_params(sample);
        let mut model = {
            let mut plain = drawn.clone();
            plain.params = mech_compiler::model::Params::default();
            for axis in &mut plain.axes {
                axis.formulas = [None; 2];
                axis.direction_formulas = [None; 2];
            }
            plain.effects.sensitivity = false;
            in_own_frames(&plain, &mut dice).0
        };
        // What rolls on while a param changes does not begin where it would have begun.
        if model.joints.iter().any(|joint| joint.kind.rolls()) {
            return;
        }
        vary(&mut model, &mut dice, 1);
        let Ok(compiled) = compile(&model) else {
            return;
        };
        let wanted = [model.params.all()[0].value * dice.between(0.95, 1.05)];
        let mut machine = Machine::<f64>::new(&compiled.program);
        let Ok(declared) = compile(&with_params(&model, &wanted)) else {
            return;
        };
        if machine.set_params(&wanted).is_err() {
            return;
        }
        let other = Machine::<f64>::new(&declared.program);
        let off = apart(&machine.position().poses, &other.position().poses);
        // Another assembly may be nearer to the one that is described.
        if off > 0.5 {
            return;
        }
        worst = worst.max(off / size(&model));
        compared += 1;
    });
    println!("{compared} compared, {worst:e} apart");
    assert!(compared > cases(CASES) / 4, "{compared}");
    assert!(worst < 1e-11, "{worst:e}");
}

/// Ten times as large or a tenth, a mechanism is the same mechanism: tolerances follow its size.
#[test]
fn tolerances_follow_the_size() {
    let mut compared = 0;
    let mut worst = [0.0_f64; 2];
    for_all(CASES, &samples(1..=8), |Sample { grown, mut dice }| {
        let mut model = grown.model;
        let turns = |model: &Model| {
            let joints = model.motors.iter().map(|motor| model.joint(motor.joint).kind);
            joints.into_iter().all(|kind| matches!(kind, JointKind::Revolute(..)))
        };
        if !turns(&model) {
            return;
        }
        scale(&mut model);
        let Ok(compiled) = compile(&model) else {
            return;
        };
        for factor in [0.1, 0.5, 2.0, 10.0] {
            let mut own = Machine::<f64>::new(&compiled.program);
            let mut large = Machine::<f64>::new(&compiled.program);
            large.set_params(&[factor]).unwrap_or_else(|stop| panic!("{factor}: {stop:?}"));
            let there = with_params(&model, &[factor]);
            for _ in 0..8 {
                let motors: Vec<f64> = own.position().motors[..model.motors.len()]
                    .iter()
                    .map(|motor| motor + dice.between(-1.5, 1.5))
                    .collect();
                let outcomes = [own.move_toward(&motors), large.move_toward(&motors)];
                assert!(outcomes.iter().all(Result::is_ok), "{outcomes:?}");
                let stopped = outcomes.map(|outcome| outcome.is_ok_and(|stop| stop.is_some()));
                assert_eq!(stopped[0], stopped[1], "{factor}");
                if stopped[0] {
                    // At a limit rounding is magnified.
                    break;
                }
                let poses = with_ground(&there, &large.position().poses);
                let extent = size(&there) + reach(&poses);
                worst[0] =
                    worst[0].max(worst_gap(&there, &poses) / extent).max(worst_stretch(&poses));
                let same: Vec<[f64; 4]> = own
                    .position()
                    .poses
                    .iter()
                    .map(|[cos, sin, x, y]| [*cos, *sin, factor * x, factor * y])
                    .collect();
                worst[1] = worst[1].max(apart(&same, &large.position().poses) / extent);
                compared += 1;
            }
        }
    });
    println!("{compared} compared; open and apart: {worst:?}");
    assert!(compared > cases(CASES), "{compared}");
    assert!(worst[0] < 1e-13 && worst[1] < 1e-9, "{worst:?}");
}

/// However loops are solved, and however change points are passed: those that a param has a part in close exactly.
#[test]
fn params_go_with_every_method() {
    let methods = [Method::Linear, Method::NewtonSteps(2), Method::Newton];
    let passing = [AtChangePoints::KeepBranch, AtChangePoints::Stop];
    let (mut changed, mut worst) = (0, 0.0_f64);
    for_all(CASES, &samples(1..=8), |sample| {
        let (mut model, mut dice) = with_random_params(sample);
        match dice.below(4) {
            3 => {
                model.method = None;
                model.accuracy = Some(1e-5);
                for motor in &mut model.motors {
                    motor.step = Some(0.01);
                }
            }
            method => {
                model.method = Some(methods[method]);
                model.predictor = if method == 2 { 0 } else { 2 };
            }
        }
        if dice.once_in(3) {
            model.change_points = *dice.pick(&passing);
        }
        let Ok(compiled) = compile(&model) else {
            return;
        };
        let mut machine = Machine::<f64>::new(&compiled.program);
        for round in 0..12 {
            let motors: Vec<f64> = machine.position().motors[..model.motors.len()]
                .iter()
                .map(|motor| motor + dice.between(-0.01, 0.01))
                .collect();
            let _ = machine.move_to(&motors);
            let params: Vec<f64> = machine.params().to_vec();
            let wanted: Vec<f64> =
                params.iter().map(|value| value * dice.between(0.98, 1.02)).collect();
            if round % 2 == 0 && machine.set_params(&wanted).is_ok() {
                changed += 1;
            }
            let there = with_params(&model, machine.params());
            let poses = with_ground(&there, &machine.position().poses);
            let extent = size(&there) + reach(&poses);
            worst = worst.max(worst_gap(&there, &poses) / extent);
        }
    });
    println!("{changed} changes, open by {worst:e}");
    assert!(changed > 4 * cases(CASES), "{changed}");
    // What one linear step of a small move leaves open.
    assert!(worst < 1e-4, "{worst:e}");
}

/// Mechanisms that are compiled by text: coupled and tied loops follow params too.
#[test]
fn sensitivities_of_special_mechanisms_are_those_of_their_positions() {
    let mut seen = Seen::default();
    let (mut dice, mut refused) = (Dice::new(7), 0);
    for mut model in known().into_iter().chain(with_own_params()) {
        for motor in &mut model.motors {
            motor.range = None;
        }
        if model.params.is_empty() {
            scale(&mut model);
        }
        model.show = None;
        model.effects.sensitivity = true;
        for _ in 0..4 {
            match compare(&model, &mut dice, &mut seen) {
                Ok(()) => {}
                Err(TestCaseError::Reject(_)) => refused += 1,
                Err(TestCaseError::Fail(reason)) => panic!("{}: {reason}", model.name),
            }
        }
    }
    println!("{seen:?}, {refused} refused");
    assert!(seen.compared > 1000 && refused <= 16, "{seen:?}");
}
