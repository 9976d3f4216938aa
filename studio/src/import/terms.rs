//! Terms: allowances, ranges and laws, which are written only if the compiler takes them.

use super::drawing::{Drawing, Omission, Times};
use super::writing::{self, FileKind, Terms};
use crate::document::{Document, Reading, Source};
use crate::failure::Failure;
use crate::motion::{Drive, Mover, Span};

/// In which order allowances are tried: `coupled`, `redundant`.
const ALLOWANCES: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

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
        let tried = Terms { is_coupled, is_redundant, ..terms.clone() };
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
    let wanted: Vec<bool> = drawing.motors.iter().map(|motor| motor.stroke.is_some()).collect();
    if !wanted.contains(&true) {
        return Ok(());
    }
    let all = Terms { ranges: wanted.clone(), ..terms.clone() };
    if moving(drawing, &all)?.is_some() {
        *terms = all;
        return Ok(());
    }
    let names = writing::joint_names(drawing)?;
    for (number, motor) in drawing.motors.iter().enumerate().filter(|(number, _)| wanted[*number]) {
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
    let lawful = Terms { has_laws: true, ..terms.clone() };
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
    let span = Span { from: Some(0.0.into()), to: Some(times.tried.into()) };
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

/// Analyses a drawing on these terms; none if it does not move.
fn moving(drawing: &Drawing, terms: &Terms) -> Result<Option<Reading>, Failure> {
    let text = writing::text(drawing, terms, "Trial", FileKind::Mechanism)?;
    let document = Document::of(Source::new("trial.mech", text));
    let reading = document.analyse(document.choose(None)?)?;
    Ok(reading.result.is_ok().then_some(reading))
}
