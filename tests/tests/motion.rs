//! Random mechanisms in random motion: no value of a motor makes a mechanism panic, come apart, bend a link or change
//! its branch unseen.
//!
//! A case is one mechanism and one segment of its motion: `MECH_CASES=1000000` for a million of them.

use mech_compiler::compile;
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::{AtChangePoints, Method, Model, Precision};
use mech_compiler::program::{Position, Program};
use mech_runtime::Real;
use mech_test_support::{
    Dice, apart, driven_elsewhere, grow, lengths, with_ground, worst_gap, worst_stretch,
};
use std::f64::consts::SQRT_2;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Segments of the motion of one mechanism.
const SEGMENTS: u64 = 40;
/// In all tests a gap or an error of this many units of rounding of the mechanism's size passes for rounding.
const ROUNDING: f64 = 64.0;
/// A limit is found to this many units of rounding: 1e-12 in double precision.
const LIMIT: f64 = 4500.0;
/// More failures than this are not reported.
const MOST_REPORTED: usize = 100;

const METHODS: [Method; 5] =
    [Method::Exact, Method::Newton, Method::Exact, Method::NewtonSteps(4), Method::Linear];

fn cases() -> u64 {
    mech_test_support::cases(1_000)
}

/// A random mechanism and its method.
struct Subject {
    model: Model,
    program: Program,
    dice: Dice,
    size: f64,
}

impl Subject {
    fn of(seed: u64, method: Method, precision: Precision, wanted: Wanted) -> Option<Self> {
        let mut dice = Dice::new(seed);
        let additions = 1 + dice.below(8);
        let mut model = grow(&mut dice, additions).model;
        // Of coupled loops, a leap and small steps stop at different places beside a change point.
        if dice.once_in(3) && wanted != Wanted::SameEnd {
            model = driven_elsewhere(&model, &mut dice).unwrap_or(model);
        }
        model.method = Some(method);
        model.precision = precision;
        model.change_points = *dice.pick(&[
            AtChangePoints::GoOn,
            AtChangePoints::GoOn,
            AtChangePoints::KeepBranch,
            AtChangePoints::Stop,
        ]);
        let program = compile(&model).ok()?.program;
        // The lengths of all links together.
        let size = lengths(&model).sum();
        Some(Self { model, program, dice, size })
    }
}

fn poses<T: Real>(position: &Position<T>) -> Vec<[f64; 4]> {
    let pose = |pose: &[T; 4]| pose.map(Real::to_f64);
    position.poses.iter().map(pose).collect()
}

/// Every bit of a position.
fn bits<T: Real>(position: &Position<T>) -> Vec<u64> {
    let numbers = position.poses.iter().flatten();
    let numbers = numbers.chain(&position.motors).chain(&position.state);
    numbers
        .map(|number| number.to_f64().to_bits())
        .chain(position.turns.iter().map(|turns| u64::from(turns.unsigned_abs())))
        .collect()
}

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    /// Whatever a motion does to a mechanism but what follows.
    Sound,
    /// In one leap it comes where it comes in small steps.
    SameEnd,
}

/// What a segment does.
#[derive(Clone, Copy, Debug)]
enum Segment {
    Small,
    Leap,
    Back,
    OneMotor,
    Toward,
    Extreme,
    NotFinite,
}

/// What a method promises about the gaps it leaves, as a part of the size.
fn largest_gap<T: Real>(method: Method) -> f64 {
    match method {
        Method::Linear => 1e-2,
        _ => ROUNDING * T::EPSILON,
    }
}

/// The lengths that rounding is relative to: of the links, and of the coordinates of what they are joined by.
fn extent(subject: &Subject, poses: &[[f64; 4]]) -> f64 {
    let axes = subject.model.axes.iter().map(|axis| {
        let ([u, v], [cos, sin, x, y]) = (axis.at, poses[axis.link.index()]);
        (x + cos * u - sin * v).hypot(y + sin * u + cos * v)
    });
    subject.size + axes.sum::<f64>()
}

/// The mechanism is whole: finite, closed, and every link as long as it was declared.
fn check_whole<T: Real>(subject: &Subject, position: &Position<T>) -> Result<(), String> {
    let poses = with_ground(&subject.model, &poses(position));
    if poses.iter().flatten().any(|number| !number.is_finite()) {
        return Err("a pose is not finite".to_owned());
    }
    if position.state.iter().any(|number| !number.is_finite()) {
        return Err("what is carried is not finite".to_owned());
    }
    let method = subject.model.method.unwrap_or_default();
    // A linear step turns to first order: what it promises for gaps, it promises for lengths.
    let most = match method {
        Method::Linear => largest_gap::<T>(method),
        _ => 16.0 * T::EPSILON,
    };
    let stretch = worst_stretch(&poses);
    if stretch > most {
        return Err(format!("a link is stretched by {:.1} eps", stretch / T::EPSILON));
    }
    let size = extent(subject, &poses);
    let gap = worst_gap(&subject.model, &poses);
    // In each coordinate.
    if gap > SQRT_2 * largest_gap::<T>(method) * size {
        return Err(format!(
            "a gap of {gap:e}: {:.1} eps of the size {size}",
            gap / size / T::EPSILON
        ));
    }
    Ok(())
}

/// Values for the motors.
fn target<T: Real>(dice: &mut Dice, segment: Segment, now: &[T], before: &[T]) -> Vec<T> {
    const EXTREMES: [f64; 10] =
        [0.0, -0.0, 1e-300, 5e-324, 300.0, -1e9, 1e15, 1e38, -1e300, f64::MAX];
    let one = dice.below(now.len().max(1));
    let near =
        |dice: &mut Dice, value: &T, most: f64| *value + T::from_f64(dice.between(-most, most));
    let mut motors: Vec<T> = match segment {
        Segment::Small => now.iter().map(|value| near(dice, value, 0.05)).collect(),
        Segment::Leap | Segment::Toward => now.iter().map(|value| near(dice, value, 7.0)).collect(),
        Segment::Back => before.to_vec(),
        Segment::OneMotor | Segment::Extreme | Segment::NotFinite => now.to_vec(),
    };
    if let Some(motor) = motors.get_mut(one) {
        match segment {
            Segment::OneMotor => *motor = near(dice, motor, 7.0),
            Segment::Extreme => *motor = T::from_f64(*dice.pick(&EXTREMES)),
            Segment::NotFinite => {
                let not = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
                *motor = T::from_f64(*dice.pick(&not));
            }
            _ => {}
        }
    }
    motors
}

/// Goes to these values in small steps; says whether it came there.
fn in_small_steps<T: Real>(machine: &mut Machine<T>, motors: &[T]) -> Result<(), (u32, Stop)> {
    let start = machine.position().motors.clone();
    let displacement =
        start.iter().zip(motors).map(|(from, to)| (*to - *from).abs().to_f64()).fold(0.0, f64::max);
    let steps = (1_u32..400).find(|steps| f64::from(*steps) * 0.03 > displacement).unwrap_or(400);
    for step in 1..steps {
        let part = T::from_f64(f64::from(step) / f64::from(steps));
        let between: Vec<T> =
            start.iter().zip(motors).map(|(from, to)| *from + (*to - *from) * part).collect();
        machine.move_to(&between).map_err(|stop| (step, stop))?;
    }
    machine.move_to(motors).map_err(|stop| (steps, stop))
}

/// How much faster than a motor anything moves here, for a small motion of the motors: what rounding is multiplied by.
fn sensitivity<T: Real>(program: &Program, at: &Position<T>) -> f64 {
    let small = T::EPSILON.sqrt();
    let mut most = 1.0_f64;
    for motor in 0..at.motors.len() {
        for displacement in [small, -small] {
            let mut machine = Machine::new(program);
            machine.put_back(at.clone());
            let mut motors = at.motors.clone();
            motors[motor] = motors[motor] + T::from_f64(displacement);
            let displacement = (motors[motor] - at.motors[motor]).to_f64();
            if machine.move_to(&motors).is_ok() && displacement != 0.0 {
                most = most.max(apart(&poses(at), &poses(machine.position())) / displacement.abs());
            } else {
                // It is at its limit: a root is there, and half of the digits are gone.
                most = most.max(1.0 / small);
            }
        }
    }
    most
}

/// In one leap it comes where it comes in small steps.
fn same_end<T: Real>(
    subject: &Subject,
    start: &Position<T>,
    end: &Position<T>,
) -> Result<(), String> {
    let mut machine = Machine::new(&subject.program);
    machine.put_back(start.clone());
    if let Err((step, stop)) = in_small_steps(&mut machine, &end.motors) {
        // A leap may end at a limit: which is where it is to rounding.
        let _ = machine.move_toward(&end.motors);
        let reached = &machine.position().motors;
        let short = reached.iter().zip(&end.motors).any(|(reached, end)| {
            let limit = LIMIT * T::EPSILON * (1.0 + end.to_f64().abs());
            (*reached - *end).abs().to_f64() > limit
        });
        if short {
            return Err(format!(
                "a leap passes where small steps are stopped, {stop:?} at step {step}; they reach {reached:?}, not {:?}",
                end.motors
            ));
        }
    }
    let off = apart(&poses(machine.position()), &poses(end));
    if off == 0.0 {
        return Ok(());
    }
    let size = subject.size + 1.0;
    // What slides away to infinity as 1/δ has lost all its digits at last.
    let extent = extent(subject, &with_ground(&subject.model, &poses(end)));
    if extent * T::EPSILON.sqrt() > size {
        return Ok(());
    }
    let most = ROUNDING * T::EPSILON * size * sensitivity(&subject.program, end);
    if off > most {
        return Err(format!(
            "a leap ends {off:e} from where small steps do; rounding explains {most:e}"
        ));
    }
    Ok(())
}

/// The values are on the straight line between two others.
fn between<T: Real>(from: &[T], values: &[T], to: &[T]) -> bool {
    from.iter()
        .zip(values)
        .zip(to)
        .all(|((from, value), to)| (from <= value && value <= to) || (to <= value && value <= from))
}

/// Moves a mechanism through its segments.
fn move_in_segments<T: Real>(
    subject: &mut Subject,
    wanted: Wanted,
    report: &mut impl FnMut(u64, Segment, String),
) {
    let program = subject.program.clone();
    let mut machine = Machine::<T>::new(&program);
    let mut before = machine.position().motors.clone();
    for number in 0..SEGMENTS {
        let segment = match subject.dice.below(16) {
            0..=3 => Segment::Small,
            4..=7 => Segment::Leap,
            8 | 9 => Segment::Back,
            10 | 11 => Segment::OneMotor,
            12 | 13 => Segment::Toward,
            14 => Segment::Extreme,
            _ => Segment::NotFinite,
        };
        let start = machine.position().clone();
        let motors = target(&mut subject.dice, segment, &start.motors, &before);
        let finite = motors.iter().all(|motor| motor.is_finite());
        let fail = &mut |text: String| {
            let text = format!("{text}; from {:?} to {motors:?}", start.motors);
            report(number, segment, text);
        };
        if let Segment::Toward = segment {
            match machine.move_toward(&motors) {
                Ok(_) if !between(&start.motors, &machine.position().motors, &motors) => {
                    fail(format!(
                        "it is sent towards a place and goes to {:?}",
                        machine.position().motors
                    ));
                }
                Ok(None) if machine.position().motors != motors => {
                    fail("it says that it is there and is not".to_owned());
                }
                Ok(_) => {}
                Err(stop) => fail(format!("it does not go towards finite values: {stop:?}")),
            }
        } else {
            match (machine.move_to(&motors), finite) {
                (Ok(()), false) => fail("it goes to what is not finite".to_owned()),
                (Err(Stop::NotFinite(_)), true) => fail("finite values are refused".to_owned()),
                (Ok(()), true) if machine.position().motors != motors => {
                    fail("its motors are not where they were sent".to_owned());
                }
                (Err(_), _) if bits(machine.position()) != bits(&start) => {
                    fail("a refused move changes it".to_owned());
                }
                _ => {}
            }
        }
        let end = machine.position().clone();
        let leapt =
            matches!(segment, Segment::Leap | Segment::OneMotor | Segment::Back | Segment::Toward);
        if bits(&end) != bits(&start) {
            let found = match wanted {
                Wanted::Sound => check_whole(subject, &end),
                Wanted::SameEnd if leapt => same_end(subject, &start, &end),
                Wanted::SameEnd => Ok(()),
            };
            if let Err(text) = found {
                fail(text);
            }
        }
        if let Segment::Extreme = segment {
            machine = Machine::new(&program);
        }
        before = start.motors;
    }
}

/// All failures of the mechanisms of the first seeds.
fn failures(precision: Precision, only: &[Method], wanted: Wanted) -> Vec<String> {
    let mut failures = Vec::new();
    for seed in mech_test_support::seeds(cases().div_ceil(SEGMENTS)) {
        let method = METHODS[usize::try_from(seed).unwrap_or(0) % METHODS.len()];
        if !only.contains(&method) {
            continue;
        }
        let Some(mut subject) = Subject::of(seed, method, precision, wanted) else {
            failures.push(format!("seed {seed}: it does not compile"));
            continue;
        };
        let change_points = subject.model.change_points;
        let mut report = |number: u64, segment: Segment, text: String| {
            failures.push(format!(
                "seed {seed}, {method:?}, {change_points:?}, {number} {segment:?}: {text}"
            ));
        };
        let panicked = catch_unwind(AssertUnwindSafe(|| match precision {
            Precision::F32 => move_in_segments::<f32>(&mut subject, wanted, &mut report),
            Precision::F64 => move_in_segments::<f64>(&mut subject, wanted, &mut report),
        }));
        if panicked.is_err() {
            failures.push(format!("seed {seed}, {method:?}: it panics"));
        }
    }
    failures
}

#[track_caller]
fn assert_none(only: &[Method], wanted: Wanted) {
    let mut failures_of_both = failures(Precision::F64, only, wanted);
    failures_of_both.extend(failures(Precision::F32, only, wanted));
    let first: Vec<&str> =
        failures_of_both.iter().take(MOST_REPORTED).map(String::as_str).collect();
    assert!(
        failures_of_both.is_empty(),
        "{} failures:\n{}",
        failures_of_both.len(),
        first.join("\n")
    );
}

#[test]
fn in_closed_form_it_stays_whole_wherever_it_is_sent() {
    assert_none(&[Method::Exact], Wanted::Sound);
}

#[test]
fn by_newton_it_stays_whole_wherever_it_is_sent() {
    assert_none(&[Method::Newton], Wanted::Sound);
}

#[test]
fn in_four_rounds_it_stays_whole_wherever_it_is_sent() {
    assert_none(&[Method::NewtonSteps(4)], Wanted::Sound);
}

#[test]
fn by_linear_steps_it_stays_whole_wherever_it_is_sent() {
    assert_none(&[Method::Linear], Wanted::Sound);
}

#[test]
fn in_closed_form_a_leap_ends_where_small_steps_do() {
    assert_none(&[Method::Exact], Wanted::SameEnd);
}

#[test]
fn by_newton_a_leap_ends_where_small_steps_do() {
    assert_none(&[Method::Newton], Wanted::SameEnd);
}
