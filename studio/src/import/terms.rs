//! What of a text is written only if the compiler takes it: allowances, ranges and laws.

use super::drawing::{Drawing, Motor, Speed};
use super::omission::Omission;
use super::writing::{self, FileKind};
use crate::document::{Document, Reading, Source};
use crate::failure::Failure;
use crate::motion::{Drive, Mover, Span};

/// In which order allowances are tried: `coupled`, `redundant`.
const ALLOWANCES: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];
/// For how many turns of the fastest input laws are tried, if not all are back sooner.
const TURNS: f64 = 64.0;
/// How many steps a turn of the fastest input is tried in.
const STEPS: f64 = 90.0;
/// Speeds are compared in thousandths.
const THOUSANDTHS: f64 = 1000.0;

/// What of a text is written only if the compiler takes it.
#[derive(Clone, Debug)]
pub(super) struct Terms {
    pub(super) is_coupled: bool,
    pub(super) is_redundant: bool,
    /// Whether each motor has its range.
    pub(super) ranges: Vec<bool>,
    /// Whether motors follow their speeds by laws.
    pub(super) has_laws: bool,
}

/// The least allowances with which a drawing moves, and all ranges that can be proved then. Several inputs follow their speeds, which
/// together decide what is drawn, if not all of them go through ranges, as films do; one alone can be moved at any speed. If the drawing does
/// not move, nothing of it is written.
pub(super) fn agreed(drawing: &Drawing, omissions: &mut Vec<Omission>) -> Result<Terms, Failure> {
    let mut terms = Terms {
        is_coupled: false,
        is_redundant: false,
        ranges: vec![false; drawing.motors.len()],
        has_laws: false,
    };
    let mut moves = false;
    for [is_coupled, is_redundant] in ALLOWANCES {
        let tried = Terms {
            is_coupled,
            is_redundant,
            ..terms.clone()
        };
        moves = moving(drawing, &tried)?.is_some();
        if moves {
            terms = tried;
            break;
        }
    }
    if moves {
        prove_ranges(drawing, &mut terms, omissions)?;
        follow_laws(drawing, &mut terms, omissions)?;
    }
    Ok(terms)
}

/// Gives motors the ranges that can be proved: all together, or one after the other.
fn prove_ranges(
    drawing: &Drawing,
    terms: &mut Terms,
    omissions: &mut Vec<Omission>,
) -> Result<(), Failure> {
    let wanted: Vec<bool> = drawing
        .motors
        .iter()
        .map(|motor| motor.stroke.is_some())
        .collect();
    if !wanted.contains(&true) {
        return Ok(());
    }
    let all = Terms {
        ranges: wanted.clone(),
        ..terms.clone()
    };
    if moving(drawing, &all)?.is_some() {
        *terms = all;
        return Ok(());
    }
    let names = writing::joint_names(drawing)?;
    for (number, motor) in drawing
        .motors
        .iter()
        .enumerate()
        .filter(|(number, _)| wanted[*number])
    {
        let mut more = terms.clone();
        more.ranges[number] = true;
        if moving(drawing, &more)?.is_some() {
            *terms = more;
            continue;
        }
        let name = &names[motor.joint];
        let what = "that its whole stroke is free cannot be proved, so it has no range";
        omissions.push(Omission::new(format!("motor `{name}`"), what));
    }
    Ok(())
}

/// Lets several inputs follow their speeds, if they can do so together.
fn follow_laws(
    drawing: &Drawing,
    terms: &mut Terms,
    omissions: &mut Vec<Omission>,
) -> Result<(), Failure> {
    let Some(times) = Times::of(&drawing.motors) else {
        return Ok(());
    };
    let mut motors = drawing.motors.iter().zip(&terms.ranges);
    if motors.all(|(motor, has_range)| *has_range || motor.rounds().is_none()) {
        return Ok(());
    }
    let lawful = Terms {
        has_laws: true,
        ..terms.clone()
    };
    let found = moving(drawing, &lawful)?;
    if found.map_or(Ok(false), |reading| follows(&reading, times))? {
        *terms = lawful;
    } else {
        let what = "they cannot go on together at their speeds, so their motors have no laws";
        omissions.push(Omission::new("inputs", what));
    }
    Ok(())
}

/// Whether all motors can follow their laws.
fn follows(reading: &Reading, times: Times) -> Result<bool, Failure> {
    let Ok(compiled) = &reading.result else {
        return Ok(false);
    };
    let model = &reading.model;
    let span = Span {
        from: Some(0.0.into()),
        to: Some(times.tried.into()),
    };
    let drive = Drive::new(model, compiled, None, span, &[])?;
    let mut machine = Mover::new(model, compiled);
    let mut part = 0.0;
    while part < 1.0 {
        if drive.move_to(model, compiled, &mut machine, part).is_err() {
            return Ok(false);
        }
        part += times.step / times.tried;
    }
    Ok(true)
}

/// What the compiler makes of a drawing on these terms, if that moves.
fn moving(drawing: &Drawing, terms: &Terms) -> Result<Option<Reading>, Failure> {
    let text = writing::text(drawing, terms, "Trial", FileKind::Mechanism)?;
    let document = Document::of(Source::new("trial.mech", text));
    let reading = document.analyse(document.choose(None)?)?;
    Ok(reading.result.is_ok().then_some(reading))
}

/// Times of several inputs, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Times {
    /// After which all of them are back where they started, if that is soon.
    pub(super) back: Option<f64>,
    /// For how long laws are tried, and in what steps.
    tried: f64,
    step: f64,
}

impl Times {
    /// The times of these motors, if several have laws.
    pub(super) fn of(motors: &[Motor]) -> Option<Self> {
        let rates: Vec<f64> = motors.iter().filter_map(Motor::rounds).collect();
        if rates.len() < 2 {
            return None;
        }
        let fastest = rates.iter().copied().fold(0.0, f64::max);
        let longest = 60.0 * TURNS / fastest;
        let common = rates.iter().try_fold(0.0, |common, rate| {
            let thousandths = rate * THOUSANDTHS;
            let whole = thousandths.round();
            ((thousandths - whole).abs() < 1e-6).then(|| divisor(whole, common))
        });
        let back = common.map(|common| 60.0 * THOUSANDTHS / common);
        let back = back.filter(|back| *back <= longest);
        Some(Self {
            back,
            tried: back.unwrap_or(longest),
            step: 60.0 / fastest / STEPS,
        })
    }
}

impl Motor {
    /// How often it is back where it started, in a minute, if a law can say how it moves.
    pub(super) fn rounds(&self) -> Option<f64> {
        match (self.speed?, self.stroke) {
            (Speed::Turns(turns), _) => Some(turns.abs()),
            (Speed::Cycles(cycles), Some(_)) => Some(cycles),
            (Speed::Cycles(_), None) | (Speed::Way(_), _) => None,
        }
    }
}

/// The greatest common divisor of whole numbers.
fn divisor(a: f64, b: f64) -> f64 {
    if b == 0.0 { a } else { divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_back_after_their_common_period() {
        let back = |rates: &[f64]| {
            let motor = |turns: &f64| Motor {
                joint: 0,
                stroke: None,
                speed: Some(Speed::Turns(*turns)),
            };
            let motors: Vec<Motor> = rates.iter().map(motor).collect();
            Times::of(&motors).and_then(|times| times.back)
        };
        assert_eq!(back(&[15.0, -15.0, 15.0, 18.0]), Some(20.0));
        assert_eq!(back(&[0.5, 0.75]), Some(240.0));
        assert_eq!(back(&[15.0]), None);
        assert_eq!(back(&[15.0, 15.001]), None);
        assert_eq!(back(&[15.0, std::f64::consts::PI]), None);
    }
}
