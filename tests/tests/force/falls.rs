//! Steps of time under forces, against Newton's and Euler's laws on the joints' equations.

use super::acts::follow;
use super::random_actions::load_up;
use mech_compiler::compile;
use mech_compiler::model::{JointKind, Model};
use mech_runtime::{Cause, GaussLegendre, Real, Scalar};
use mech_test_support::judge::{Fall, Judge};
use mech_test_support::sketch::Sketch;
use mech_test_support::{Dice, Simulated, cases, model, seeds, size, symmetric, with_ground};

/// So many steps are made with each mechanism at most, and every so often one is judged.
const STEPS: u32 = 250;
const JUDGED: u32 = 50;
/// The judge's steps in one.
const PARTS: u32 = 64;
/// Where links move so many units for a unit of the motor's, a dead point is near: there no motor tells where it goes.
const DEAD: f64 = 100.0;

/// No motor goes farther in a step of use: in radians, or as a part of the mechanism.
const LONGEST: f64 = 0.3;

#[derive(Debug, Default)]
struct Seen {
    mechanisms: usize,
    judged: usize,
    dead: usize,
    early: Vec<String>,
    /// Ended beside a dead point, which the error does not say.
    unnamed: Vec<String>,
    worst: f64,
}

/// Steps of one mechanism, its masses and its rates being random.
fn fall<T: Scalar, const M: usize>(text: &str, model: &Model, dice: &mut Dice, seen: &mut Seen) {
    let Ok(compiled) = compile(model) else { return };
    let (Some(inertia), size) = (&compiled.forced.inertia, size(model)) else {
        return;
    };
    let number = <T as Real>::from_f64;
    let slides: [Option<f64>; M] = std::array::from_fn(|motor| {
        let joint = model.joint(model.motors[motor].joint);
        matches!(joint.kind, JointKind::Prismatic(..)).then_some(size)
    });
    let mut machine = Simulated::<T, M>::new(&compiled.program, inertia, slides);
    let unit = (size / 10.0).sqrt();
    machine.rates = slides
        .map(|slide| number(dice.between(-1.5, 1.5) / unit * slide.map_or(1.0, |size| 0.3 * size)));
    let time = unit * *dice.pick(&[0.001, 0.003, 0.01, 0.03, 0.06]);
    let method = *dice.pick(&[GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6]);
    seen.mechanisms += 1;
    let mut angles = vec![0.0; model.joints.len()];
    follow(&mut angles, model, &machine.in_f64());
    for step in 0..STEPS {
        let (before, rates) = (machine.in_f64(), machine.rates.map(Real::to_f64));
        let outcome = machine.step(method, number(time), [T::ZERO; M]);
        let is_far = rates
            .iter()
            .zip(&slides)
            .any(|(rate, slide)| (time * rate).abs() > LONGEST * slide.unwrap_or(1.0));
        if is_far {
            // Something runs away.
            return;
        }
        if outcome.is_ok() && step % JUDGED != 0 {
            follow(&mut angles, model, &machine.in_f64());
            continue;
        }
        let poses = with_ground(model, &before.poses);
        let judge = Judge::new(model, &compiled.structure.rollings, &poses, &before.motors);
        let run = |parts: u32| {
            let mut fall = Fall::new(&judge, &rates, &angles);
            let ended = (0..parts).all(|_| fall.step(time / f64::from(parts)).is_some());
            ended.then_some(fall)
        };
        let apart = |a: &[f64], b: &[f64]| {
            let all = a.iter().zip(b).zip(&slides);
            let parts = all.map(|((a, b), slide)| (a - b).abs() / slide.unwrap_or(1.0));
            parts.fold(0.0, f64::max)
        };
        let (fine, coarse) = (run(PARTS), run(1));
        let Some(fine) = fine.filter(|fine| fine.gain < DEAD) else {
            seen.dead += 1;
            if let Err(blocked) = outcome {
                if !matches!(blocked.cause, Cause::Open | Cause::DeadPoint | Cause::Singular) {
                    seen.unnamed
                        .push(format!("{:?}, step {step} of {time}\n{text}", blocked.cause));
                }
                return;
            }
            follow(&mut angles, model, &machine.in_f64());
            continue;
        };
        let way = apart(&fine.motors(), &before.motors).max(time * apart(&rates, &[0.0; M]));
        if let Err(blocked) = outcome {
            // A step that is too long for anybody is no early end.
            let made =
                coarse.is_some_and(|coarse| apart(&coarse.motors(), &fine.motors()) < 0.1 * way);
            if made {
                seen.early.push(format!(
                    "{:?}, step {step} of {time} by {method:?}, rates {rates:?}\n{text}",
                    blocked.cause
                ));
            }
            return;
        }
        let off = apart(&machine.in_f64().motors, &fine.motors()) / way;
        // The step's own error is that of steps half as long, and more.
        let own =
            coarse.map_or(f64::INFINITY, |coarse| apart(&coarse.motors(), &fine.motors()) / way);
        if fine.gain < 0.2 * DEAD && own < 1e-3 && method != GaussLegendre::Order2 {
            seen.worst = seen.worst.max(off);
        }
        seen.judged += 1;
        follow(&mut angles, model, &machine.in_f64());
    }
}

fn random<T: Scalar>(families: &[fn(&mut Dice) -> Sketch], count: u64, single: bool) -> Seen {
    let mut seen = Seen::default();
    // The judge takes as long for one of them as other tests for five.
    for seed in seeds(cases(5 * count) / 5) {
        let mut dice = Dice::new(seed);
        let mut sketch = dice.pick(families)(&mut dice);
        sketch.single = single;
        let text = sketch.text(&mut dice);
        let mut model = model(&text);
        load_up(&mut model, &mut dice);
        model.actions.loads.clear();
        match model.motors.len() {
            1 => fall::<T, 1>(&text, &model, &mut dice, &mut seen),
            2 => fall::<T, 2>(&text, &model, &mut dice, &mut seen),
            3 => fall::<T, 3>(&text, &model, &mut dice, &mut seen),
            _ => {}
        }
    }
    println!(
        "{} mechanisms, {} steps judged, {} beside dead points, {} ended early, {} unnamed, off by {:e}",
        seen.mechanisms,
        seen.judged,
        seen.dead,
        seen.early.len(),
        seen.unnamed.len(),
        seen.worst
    );
    seen
}

const GENERIC: [fn(&mut Dice) -> Sketch; 2] = [symmetric::generic, symmetric::fast];
const EQUAL: [fn(&mut Dice) -> Sketch; 2] = [symmetric::symmetric, symmetric::row];

#[test]
fn steps_of_time_are_those_of_newton_and_euler_and_are_made_where_these_go_on() {
    let seen = random::<f64>(&GENERIC, 60, false);
    assert!(seen.early.is_empty() && seen.unnamed.is_empty(), "{seen:?}");
    assert!(seen.judged > 100 && seen.worst < 1e-3, "{seen:?}");
}

#[test]
fn steps_of_time_pass_the_change_points_of_equal_lengths() {
    let seen = random::<f64>(&EQUAL, 20, false);
    assert!(seen.early.is_empty() && seen.unnamed.is_empty(), "{seen:?}");
    assert!(seen.judged > 50 && seen.worst < 1e-3, "{seen:?}");
}

/// So near a change point that forces have no limit in single precision, and none that rounding leaves, the motion stops and says so.
fn in_single_precision(families: &[fn(&mut Dice) -> Sketch]) {
    let seen = random::<f32>(families, 6, true);
    let says_so = |stop: &String| stop.starts_with("Singular");
    assert!(seen.early.iter().all(says_so), "{seen:?}");
    assert!(10 * seen.early.len() <= seen.mechanisms, "{seen:?}");
    assert!(seen.unnamed.is_empty(), "{seen:?}");
    assert!(seen.judged > 20 && seen.worst < 1e-2, "{seen:?}");
}

#[test]
fn steps_of_time_are_made_in_single_precision() {
    in_single_precision(&GENERIC);
}

#[test]
fn steps_of_time_of_equal_lengths_are_made_in_single_precision() {
    in_single_precision(&EQUAL);
}
