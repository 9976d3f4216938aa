//! One leap against its own small steps, and the judge between them.

use super::closure::fault;
use super::reading::{Subject, bits};
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::program::Position;
use mech_test_support::journeys::off;
use mech_test_support::judge::{Curve, End};
use std::time::{Duration, Instant};

/// How a leap is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// It passes where small steps stop.
    LeapPasses,
    /// It ends in another assembly.
    OtherAssembly,
    /// It ends with a wheel turned by another number of turns.
    WheelTurned,
    /// It is refused as too far, and small steps come there.
    TooFar,
    /// It stops where small steps pass.
    LeapStops,
    /// Both stop, the leap elsewhere.
    OtherPlace,
    /// Both stop at the same place, for other reasons.
    OtherReason,
    /// Small steps are themselves wrong, by finer ones and by the judge.
    StepsWrong,
    /// Something does not close.
    Open,
    /// A refused move changes something.
    Changed,
    /// Where it stopped before its target, it goes farther when it is sent there again.
    GoesFarther,
    /// Finer steps and the judge do not settle it: not counted.
    Undecided,
}

/// What was found on one move.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    pub(crate) kind: Kind,
    pub(crate) text: String,
}

/// Where a move ended.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) at: Position<f64>,
    /// The part of the move, and why no more of it.
    pub(crate) stop: Option<(f64, Stop)>,
}

/// The same place, as a part of the size and of the move.
const SAME: f64 = 1e-6;
/// No random move is compared that takes more steps than this.
pub(crate) const MOST_STEPS: f64 = 8_000.0;

/// Nobody waits longer for the steps of one move: where each of them takes a second, nothing is decided.
const PATIENCE: Duration = Duration::from_secs(5);

/// The part of a move that was made.
fn part(from: &[f64], to: &[f64], at: &[f64]) -> f64 {
    let longest = from
        .iter()
        .zip(to)
        .zip(at)
        .map(|((from, to), at)| (to - from, at - from));
    let (distance, covered) = longest.fold((0.0_f64, 0.0), |most: (f64, f64), one| {
        if one.0.abs() > most.0.abs() {
            one
        } else {
            most
        }
    });
    if distance == 0.0 {
        1.0
    } else {
        covered / distance
    }
}

/// At which part of a move the judge stops, if it does, and where that is.
type Judged = (Option<f64>, Vec<[f64; 4]>);

/// The greatest motion of a motor.
pub(crate) fn length(from: &[f64], to: &[f64]) -> f64 {
    from.iter()
        .zip(to)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// A place between two others.
fn between(from: &[f64], to: &[f64], part: f64) -> Vec<f64> {
    from.iter()
        .zip(to)
        .map(|(from, to)| from + (to - from) * part)
        .collect()
}

/// In one move.
pub(crate) fn in_a_leap(subject: &Subject, start: &Position<f64>, to: &[f64]) -> Outcome {
    let mut machine = Machine::new(&subject.compiled.program);
    machine.put_back(start.clone());
    let stop = machine.move_to(to).err().map(|stop| {
        let _ = machine.move_toward(to);
        (part(&start.motors, to, &machine.position().motors), stop)
    });
    Outcome {
        at: machine.position().clone(),
        stop,
    }
}

/// In so many steps; nothing, if that takes too long.
pub(crate) fn in_steps(
    subject: &Subject,
    start: &Position<f64>,
    to: &[f64],
    steps: f64,
) -> Option<Outcome> {
    let begin = Instant::now();
    let mut machine = Machine::new(&subject.compiled.program);
    machine.put_back(start.clone());
    let mut stop = None;
    let mut step = 1.0;
    while step <= steps && stop.is_none() {
        if begin.elapsed() > PATIENCE {
            return None;
        }
        let goal = if step == steps {
            to.to_vec()
        } else {
            between(&start.motors, to, step / steps)
        };
        if let Err(why) = machine.move_to(&goal) {
            let _ = machine.move_toward(&goal);
            stop = Some((part(&start.motors, to, &machine.position().motors), why));
        }
        step += 1.0;
    }
    Some(Outcome {
        at: machine.position().clone(),
        stop,
    })
}

/// Whether two poses are far apart, and the first link that is, with how far.
fn apart(subject: &Subject, a: &[[f64; 4]], b: &[[f64; 4]], most: f64) -> Option<(usize, f64)> {
    offs(subject, a, b).enumerate().find(|(_, off)| *off > most)
}

/// How far each link is off: in radians, or in sizes.
fn offs(subject: &Subject, a: &[[f64; 4]], b: &[[f64; 4]]) -> impl Iterator<Item = f64> {
    let extent = subject.extent(b);
    a.iter().zip(b).map(move |(a, b)| off(a, b, extent))
}

/// How much rounding may do to a position: more where it is near a dead point.
pub(crate) fn rounding(subject: &Subject, at: &Position<f64>) -> f64 {
    let small = 1e-7;
    let poses = subject.poses(at);
    let mut most = 1.0_f64;
    for motor in 0..at.motors.len() {
        for distance in [small, -small] {
            let mut machine = Machine::new(&subject.compiled.program);
            machine.put_back(at.clone());
            let mut goal = at.motors.clone();
            goal[motor] += distance;
            let slope = match machine.move_to(&goal) {
                Ok(()) => {
                    let there = subject.poses(machine.position());
                    offs(subject, &poses, &there).fold(0.0, f64::max) / small
                }
                Err(_) => 1e8,
            };
            most = most.max(slope);
        }
    }
    // Of the motors' values themselves, too: they may be large.
    let values = at
        .motors
        .iter()
        .fold(1.0_f64, |most, value| most.max(value.abs()));
    (1e4 * f64::EPSILON * most * values).clamp(SAME, 1e-2)
}

/// The same stop, whatever the loop that is named: several may be at their ends together.
fn same_reason(a: Stop, b: Stop) -> bool {
    let closes = |stop| matches!(stop, Stop::Open(_) | Stop::DeadPoint(_));
    closes(a) && closes(b) || std::mem::discriminant(&a) == std::mem::discriminant(&b)
}

/// How `a` differs from `b`, which is believed.
fn difference(
    subject: &Subject,
    a: &Outcome,
    b: &Outcome,
    distance: f64,
) -> Option<(Kind, String)> {
    let same = (SAME * (1.0 + distance)).max(1e-9) / distance;
    match (a.stop, b.stop) {
        (None, None) => {
            let (there, here) = (subject.poses(&a.at), subject.poses(&b.at));
            let (link, off) = apart(subject, &there, &here, SAME)?;
            if off <= rounding(subject, &b.at) {
                return None;
            }
            let kind = if subject.is_rolling(link) {
                Kind::WheelTurned
            } else {
                Kind::OtherAssembly
            };
            Some((kind, format!("link {link} is off by {off:.2e}")))
        }
        // At a limit that is the target itself, either may be right.
        (None, Some((part, _))) | (Some((part, _)), None) if 1.0 - part <= same => None,
        (None, Some((part, stop))) => Some((
            Kind::LeapPasses,
            format!("steps stop at {part:.9} of the move, {stop:?}"),
        )),
        (Some((part, Stop::TooFar)), None) => {
            Some((Kind::TooFar, format!("TooFar at {part:.9} of the move")))
        }
        (Some((part, stop)), None) => Some((
            Kind::LeapStops,
            format!("the leap stops at {part:.9} of the move, {stop:?}"),
        )),
        (Some((first, why)), Some((second, reason))) => {
            let verdict_text = format!(
                "the leap stops at {first:.9} of the move, {why:?}, steps at {second:.9}, {reason:?}"
            );
            if (first - second).abs() > same {
                let kind = if why == Stop::TooFar {
                    Kind::TooFar
                } else {
                    Kind::OtherPlace
                };
                Some((kind, verdict_text))
            } else if !same_reason(why, reason) {
                Some((Kind::OtherReason, verdict_text))
            } else {
                None
            }
        }
    }
}

/// How many steps are small: none turns a link by much where the move begins.
fn small_steps(subject: &Subject, start: &Position<f64>, to: &[f64]) -> f64 {
    let distance = length(&start.motors, to);
    let poses = subject.poses(start);
    let speed = |nudge: f64| {
        let there = in_a_leap(
            subject,
            start,
            &between(&start.motors, to, nudge / distance),
        );
        offs(subject, &poses, &subject.poses(&there.at)).fold(0.0, f64::max) / nudge.abs()
    };
    // It may be blocked on one side.
    let speed = speed(1e-6).max(speed(-1e-6));
    (speed * distance / 0.05).max(1000.0).round()
}

/// The target of a move, or as much of it as takes no more than this many small steps.
pub(crate) fn shorten(subject: &Subject, start: &Position<f64>, to: &[f64], most: f64) -> Vec<f64> {
    if length(&start.motors, to) == 0.0 {
        return to.to_vec();
    }
    let part = most / small_steps(subject, start, to);
    if part < 1.0 {
        between(&start.motors, to, part)
    } else {
        to.to_vec()
    }
}

/// What the judge finds on this move.
fn judge_move(subject: &Subject, start: &Position<f64>, to: &[f64]) -> Option<Judged> {
    let judge = subject.judge_at(start);
    let curve = Curve::new(&judge, &judge.start(), [&start.motors, to]);
    let poses = |part| Some(judge.poses(&curve.at(part)?.0));
    match curve.end {
        End::Arrives => Some((None, poses(1.0)?)),
        End::Stops(part) => Some((Some(part), poses(part)?)),
        End::RunsAway(_) | End::GivesUp(..) => None,
    }
}

/// Whether the judge agrees with where a move ended.
fn agrees(subject: &Subject, verdict: &Judged, outcome: &Outcome, distance: f64) -> bool {
    let same = (1e-5 * (1.0 + distance)).max(1e-9) / distance;
    match (verdict.0, outcome.stop) {
        (None, None) => {
            let poses = subject.poses(&outcome.at);
            apart(
                subject,
                &verdict.1,
                &poses,
                rounding(subject, &outcome.at).max(1e-5),
            )
            .is_none()
        }
        (Some(part), None) | (None, Some((part, _))) => 1.0 - part <= same,
        (Some(a), Some((b, _))) => (a - b).abs() <= same,
    }
}

/// A leap from a position, and all that is promised about it. Gives where small steps led, if they can be believed.
pub(crate) fn compare(
    subject: &Subject,
    start: &Position<f64>,
    to: &[f64],
) -> (Vec<Finding>, Option<Position<f64>>) {
    let mut findings = Vec::new();
    let mut find = |kind, text: String| {
        let text = format!("from {:?} to {to:?}: {text}", start.motors);
        findings.push(Finding { kind, text });
    };
    let distance = length(&start.motors, to);
    if distance < 1e-9 {
        return (findings, None);
    }
    let mut machine = Machine::new(&subject.compiled.program);
    machine.put_back(start.clone());
    if machine.move_to(to).is_err() {
        if bits(machine.position()) != bits(start) {
            find(Kind::Changed, "a refused move changes it".to_owned());
        }
        let _ = machine.move_toward(to);
        let first = machine.position().motors.clone();
        let _ = machine.move_toward(to);
        let farther = length(&first, &machine.position().motors);
        if farther > SAME * (1.0 + distance) {
            find(
                Kind::GoesFarther,
                format!("it stops at {first:?} and then goes on by {farther:.2e}"),
            );
        }
    }
    let leap = in_a_leap(subject, start, to);
    if let Some(text) = fault(subject, &leap.at) {
        find(Kind::Open, text);
    }
    let count = small_steps(subject, start, to);
    let Some(steps) = in_steps(subject, start, to, count) else {
        find(Kind::Undecided, format!("{count} steps take too long"));
        return (findings, None);
    };
    if let Some(text) = fault(subject, &steps.at) {
        find(Kind::Open, format!("in {count} steps: {text}"));
    }
    if let Some((part, Stop::TooFar)) = steps.stop {
        // However small the steps are, too far: only the judge can tell.
        let farther = match judge_move(subject, start, to) {
            Some((None, _)) => Some(1.0),
            Some((Some(judged), _)) => Some(judged),
            None => None,
        };
        if let Some(farther) = farther.filter(|farther| *farther > part + 1e-3) {
            let text =
                format!("{count} steps end TooFar at {part:.9}, the judge comes to {farther:.9}");
            find(Kind::TooFar, text);
        }
        let believed = before_the_end(subject, start, to, steps, count);
        return (findings, believed);
    }
    let Some((kind, text)) = difference(subject, &leap, &steps, distance) else {
        return (findings, before_the_end(subject, start, to, steps, count));
    };
    let Some(finer) = in_steps(subject, start, to, 4.0 * count + 3.0) else {
        find(
            Kind::Undecided,
            format!("{text}; finer steps take too long"),
        );
        return (findings, None);
    };
    let stable = difference(subject, &steps, &finer, distance).is_none();
    let verdict = judge_move(subject, start, to);
    let by_judge = |outcome: &Outcome| {
        verdict
            .as_ref()
            .map(|verdict| agrees(subject, verdict, outcome, distance))
    };
    let (for_leap, for_finer) = (by_judge(&leap), by_judge(&finer));
    let verdict_text = match &verdict {
        None => "the judge gives up".to_owned(),
        Some((None, _)) => {
            format!("the judge arrives, with the leap {for_leap:?}, with finer steps {for_finer:?}")
        }
        Some((Some(part), _)) => format!("the judge stops at {part:.9}"),
    };
    let text = format!("{text}; {count} steps, finer ones agree {stable}; {verdict_text}");
    let kind = match (stable, for_leap, for_finer) {
        // The judge has the last word where it has one, finer steps where it has none.
        (_, _, Some(true)) if !stable && difference(subject, &leap, &finer, distance).is_none() => {
            Kind::StepsWrong
        }
        (_, Some(true), Some(false)) => Kind::StepsWrong,
        // With the last one: whom nobody agrees with, not even its own steps, is wrong.
        (_, Some(_), Some(true)) | (true, None, None) | (false, Some(false), Some(false)) => kind,
        _ => Kind::Undecided,
    };
    find(kind, text);
    if for_finer != Some(true) && !stable {
        return (findings, None);
    }
    let believed = before_the_end(subject, start, to, finer, count);
    (findings, believed)
}

/// Where a move ended; if that is at a limit, a little before it.
fn before_the_end(
    subject: &Subject,
    start: &Position<f64>,
    to: &[f64],
    outcome: Outcome,
    steps: f64,
) -> Option<Position<f64>> {
    match outcome.stop {
        None => Some(outcome.at),
        Some((part, _)) => {
            let short = between(&start.motors, to, 0.97 * part);
            in_steps(subject, start, &short, steps).map(|outcome| outcome.at)
        }
    }
}
