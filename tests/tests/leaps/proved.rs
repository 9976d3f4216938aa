//! What was proved to be free is: every position within the declared ranges is reached, closed, and where the judge has it.

use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::JointKind;
use mech_compiler::program::Position;
use mech_test_support::journeys::{Family, Subject, apart};
use mech_test_support::judge::{Curve, End};
use mech_test_support::{Dice, cases, seeds, worst_gap, worst_stretch};

/// Random positions of each mechanism.
const POSITIONS: u32 = 200;
/// Of these so many are held against the judge.
const JUDGED: u32 = 12;

/// A mechanism that was proved: the same text with ranges on some of its motors, narrower and narrower until it compiles.
fn with_ranges(text: &str, dice: &mut Dice) -> Option<Subject> {
    let free = Subject::read(text).ok()?;
    let motors = free.model.motors.iter().enumerate();
    let motors = motors.map(|(number, motor)| {
        let ends = [dice.between(-3.0, 0.0), dice.between(0.0, 3.0)];
        let is_free = number > 0 && !free.slides(number) && dice.once_in(3);
        (&free.model.joint(motor.joint).name, ends, is_free)
    });
    let motors: Vec<_> = motors.collect();
    [1.0, 0.3, 0.1, 0.03].into_iter().find_map(|narrower| {
        let mut text = text.to_owned();
        for (joint, ends, _) in motors.iter().filter(|(.., is_free)| !is_free) {
            let [low, high] = ends.map(|end| end * narrower);
            let plain = format!("motor {joint};");
            text = text.replace(&plain, &format!("motor {joint} in {low:?} ..= {high:?};"));
        }
        Subject::read(&text).ok()
    })
}

/// What does not hold at a position.
fn fault(subject: &Subject, at: &Position<f64>) -> Option<String> {
    let poses = subject.poses(at);
    let gap = worst_gap(&subject.model, &poses) / subject.extent(&poses);
    let stretch = worst_stretch(&poses);
    let holds = gap <= 1e-9 && stretch <= 1e-12;
    (!holds).then(|| format!("a gap of {gap:e}, a link stretched by {stretch:e}"))
}

/// A position within all ranges. A motor that turns and has none may be anywhere: a little away, for the judge; else many turns.
fn within(subject: &Subject, dice: &mut Dice, at: &[f64], near: bool) -> Vec<f64> {
    let motors = subject.model.motors.iter().zip(at);
    let values = motors.map(|(motor, at)| match motor.range {
        Some(range) if dice.once_in(3) => *dice.pick(&[range.low, range.high]),
        Some(range) => dice.between(range.low, range.high),
        None if near => at + dice.between(-4.0, 4.0),
        None => dice.between(-400.0, 400.0),
    });
    values.collect()
}

/// What is wrong with a proved mechanism.
fn unsound(subject: &Subject, seed: u64) -> Option<String> {
    let mut dice = Dice::new(seed);
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    for number in 0..POSITIONS {
        let start = machine.position().clone();
        let judged = number < JUDGED;
        let to = within(subject, &mut dice, &start.motors, judged);
        let program = &subject.compiled.program;
        let in_pieces = !program.watches.is_empty() || !program.follows.is_empty();
        if let Err(stop) = machine.move_to(&to) {
            // What is still watched, or counts turns, may be refused many turns at once.
            if in_pieces && stop == Stop::TooFar {
                continue;
            }
            return Some(format!("from {:?} to {to:?}: {stop:?}", start.motors));
        }
        if let Some(text) = fault(subject, machine.position()) {
            return Some(format!("from {:?} to {to:?}: {text}", start.motors));
        }
        if judged && let Err(text) = agrees(subject, &start, &machine, &to) {
            return Some(format!("from {:?} to {to:?}: {text}", start.motors));
        }
    }
    None
}

/// Whether the judge comes where a machine is that went to a place.
fn agrees(
    subject: &Subject,
    start: &Position<f64>,
    machine: &Machine<'_, f64>,
    to: &[f64],
) -> Result<(), String> {
    let judge = subject.judge_at(start);
    let curve = Curve::new(&judge, &judge.start(), [&start.motors, to]);
    let poses = subject.poses(machine.position());
    let there = curve.at(1.0).map(|(place, _)| judge.poses(&place));
    let off = there.map(|there| apart(&there, &poses, subject.extent(&poses)));
    match (curve.end, off) {
        (End::RunsAway(_) | End::GivesUp(..), _) => Ok(()),
        (End::Arrives, Some(off)) if off <= 1e-5 => Ok(()),
        (end, off) => Err(format!("the judge {end:?}, off by {off:?}")),
    }
}

#[test]
fn what_is_proved_is_free_everywhere() {
    let (mut proved, mut wrong) = (0, Vec::new());
    for seed in seeds(cases(12)) {
        let mut dice = Dice::new(seed);
        let text = Family::Wild.text(&mut dice, false);
        let Some(subject) = with_ranges(&text, &mut dice) else {
            continue;
        };
        proved += 1;
        if let Some(text) = unsound(&subject, seed) {
            wrong.push(format!("seed {seed}, {text}\n{}", subject.text));
        }
    }
    println!("{proved} proved, {} of them wrong", wrong.len());
    assert!(
        wrong.is_empty(),
        "{} of {proved} are not free\n{}",
        wrong.len(),
        wrong[..3.min(wrong.len())].join("\n")
    );
    assert!(proved > 0, "none was proved");
}

/// A motor without a range may go anywhere: what compiles is free everywhere, what has a dead point is refused.
#[test]
fn behind_a_motor_without_a_range() {
    for ratio in ["20 : 40", "1 : 40", "1 : 1", "40 : 20", "17 : 40", "100 : 1", "1 : -7"] {
        // It has a dead point.
        let text = include_str!("../../cases/leaps/unsound.txt").replace("RATIO", ratio);
        assert!(Subject::read(&text).is_err(), "behind {ratio} it compiles");
    }
    let mut wrong = Vec::new();
    let crank = include_str!("../../cases/leaps/unsound.txt")
        .replace("(2.6, 0)", "(4, 0)")
        .replace("b = (2, 0)", "b = (0.5, 0)");
    for ratio in ["20 : 40", "1 : 2", "1 : 40", "100 : 1"] {
        let subject = Subject::with(&crank, "RATIO", ratio).text;
        let subject = Subject::read(&subject.replace("20 deg", "25 deg"))
            .expect("a crank that turns all the way round");
        wrong.extend(unsound(&subject, 1).map(|text| format!("a crank behind {ratio}: {text}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A bar that a pinion moves which may turn for ever cannot be free in a loop.
#[test]
fn behind_a_rack_whose_pinion_has_no_range() {
    for radius in ["20", "1", "0.1", "0.01"] {
        let text = include_str!("../../cases/leaps/rack-rocker.txt").replace("RATIO", radius);
        let text = format!(
            "{text} link other; joint z = revolute(ground, other) at (9, 0); motor z in 0 ..= 1;"
        );
        assert!(Subject::read(&text).is_err(), "of radius {radius} it compiles");
    }
}

/// However far, a crank points where its motor says.
#[test]
fn arms_turn_as_far_as_their_motors() {
    let subject = Subject::of(include_str!("../../cases/leaps/arm.txt"));
    assert!(matches!(subject.model.joints[0].kind, JointKind::Revolute(..)));
    for far in [1.0, 7.0, -300.0, 2e4, 1e6, -1e9, 1e12] {
        let mut machine = Machine::<f64>::new(&subject.compiled.program);
        assert_eq!(machine.move_to(&[far, 0.5]), Ok(()), "to {far}");
        let [cos, sin, ..] = subject.poses(machine.position())[1];
        let off = (cos - libm::cos(far)).hypot(sin - libm::sin(far));
        assert!(off < 1e-12, "to {far}: off by {off:e}");
    }
    let subject = Subject::of(include_str!("../../cases/leaps/whitworth.txt"));
    let wrong = unsound(&subject, 1);
    assert!(wrong.is_none(), "{wrong:?}");
}
