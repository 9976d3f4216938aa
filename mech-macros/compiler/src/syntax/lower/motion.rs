//! Motions in segments, as sums of staircases: one for each segment that moves.

use super::angle::{is_angle, is_degrees_perhaps, is_in_rpm};
use super::constant::Passing;
use super::quantity::Quantity;
use super::reader::{Argument, Nature, Reader};
use super::value::format_number;
use crate::model::{Formula, Number};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, MotionExpr, SegmentExpr, Way};
use mech_core::{MotionLaw, Staircase};
use std::f64::consts::TAU;

/// The law of a segment that names none.
const USUAL: MotionLaw = MotionLaw::Cycloidal;
/// Angles that differ less are one, and heights of which no more is left than this part.
const SLACK: f64 = 1e-9;
/// Why a number of a motion may not depend on a param.
const WHY_FIXED: &str = "what a segment takes stays as it is; its height may depend on one";

/// A segment that moves.
struct Climb {
    /// Where it begins.
    at: f64,
    /// How long it takes.
    span: f64,
    /// By how much it goes on.
    height: Quantity,
    law: MotionLaw,
}

/// How a motion goes on after its last segment.
#[derive(Clone, Copy)]
enum Round {
    /// It stays where it is.
    Once,
    /// It begins anew after so much.
    Every(f64),
}

/// A motion in segments, as a function of the variable of the law that is read.
pub(super) fn read(reader: &mut Reader, motion: &MotionExpr, place: Place) -> Option<Quantity> {
    let nature = reader.law.as_ref().and_then(|law| law.nature);
    let begin = match &motion.from {
        Some(from) => height(reader, from, nature),
        None => Some(Quantity::fixed(0.0)),
    };
    let spans: Vec<Option<f64>> = motion
        .segments
        .iter()
        .map(|segment| match &segment.span {
            Some(span) => self::span(reader, span, nature),
            None => Some(0.0),
        })
        .collect();
    let heights: Vec<Option<Quantity>> = motion
        .segments
        .iter()
        .map(|segment| match &segment.way {
            Way::Rise(of) => positive_height(reader, of, nature, "fall"),
            Way::Fall(of) => {
                let height = positive_height(reader, of, nature, "rise")?;
                Some(height.negative(reader.formulas()))
            }
            Way::Return | Way::Dwell => Some(Quantity::fixed(0.0)),
        })
        .collect();
    let begin = begin?;
    let spans = spans.into_iter().collect::<Option<Vec<f64>>>()?;
    let heights = heights.into_iter().collect::<Option<Vec<Quantity>>>()?;
    let (climbs, rest, sum) = climbs(reader, &motion.segments, &spans, &heights)?;
    let total: f64 = spans.iter().sum();
    let round = round(reader, motion, nature, [total, rest], place)?;
    let turns = nature.is_some_and(|nature| nature.of == Argument::Angle);
    if let Some(sum) = sum.formula
        && turns
        && !motion.repeats
        && !reader.formulas().is_always_zero(sum)
    {
        let text = "its heights depend on params, so that it may not come back to where it began; end it with `return over ...`";
        return reader.report.refuse(place, text);
    }
    let mut value = begin;
    for climb in climbs {
        let stairs = stairs(reader, &climb, round);
        let part = climb.height.times(stairs, reader.formulas());
        value = value.plus(part, reader.formulas());
    }
    Some(value)
}

/// The segments that move, and how far all of them go together: at the start, and as a formula.
fn climbs(
    reader: &mut Reader,
    segments: &[SegmentExpr],
    spans: &[f64],
    heights: &[Quantity],
) -> Option<(Vec<Climb>, f64, Quantity)> {
    let (mut at, mut sum) = (0.0, Quantity::fixed(0.0));
    let sizes = heights.iter().filter_map(|height| height.value);
    let all: f64 = sizes.map(f64::abs).sum();
    // Zero where only rounding is left.
    let far = |sum: Quantity| sum.value.filter(|sum| sum.abs() > SLACK * all).unwrap_or(0.0);
    let mut climbs = Vec::new();
    let last = segments.len() - 1;
    for (number, (segment, &span)) in segments.iter().zip(spans).enumerate() {
        let height = match segment.way {
            Way::Dwell if segment.span.is_none() && number < last => {
                let text =
                    "only the last `dwell` may leave out how long it takes; give a number after it";
                return reader.report.refuse(segment.place, text);
            }
            Way::Dwell => None,
            Way::Return if far(sum) == 0.0 && sum.formula.is_none() => {
                let text =
                    "it is where it began already; write `dwell` here, or a `rise` before it";
                return reader.report.refuse(segment.place, text);
            }
            Way::Return => Some(sum.negative(reader.formulas())),
            Way::Rise(_) | Way::Fall(_) => Some(heights[number]),
        };
        if let Some(height) = height {
            sum = match segment.way {
                Way::Return => Quantity::fixed(0.0),
                _ => sum.plus(height, reader.formulas()),
            };
            climbs.push(Climb { at, span, height, law: segment.law.unwrap_or(USUAL) });
        }
        at += span;
    }
    Some((climbs, far(sum), sum))
}

/// A number of a motion outside of its law: without the law's variable.
fn apart<'r>(reader: &'r mut Reader) -> Reader<'r> {
    let passing = Passing { variable: None, ..reader.passing };
    Reader { passing, ..reader.fixed(WHY_FIXED) }
}

/// How long a segment takes.
fn span(reader: &mut Reader, of: &Expr, nature: Option<Nature>) -> Option<f64> {
    let value = apart(reader).value(of)?;
    let argument = nature.map(|nature| nature.of);
    let what = match argument {
        Some(Argument::Time) => Some("a time"),
        Some(Argument::Length) => Some("a length"),
        Some(Argument::Angle) | None => None,
    };
    let is_told = match what {
        Some(what) => is_angle(reader.report, of, what),
        None => argument.is_some() && is_degrees_perhaps(reader.report, of, value),
    };
    if is_told {
        return None;
    }
    if value > 0.0 {
        return Some(value);
    }
    let text = format!("a segment takes more than zero, not `{of}`");
    reader.report.refuse(of.place, text)
}

/// A height that the follower goes to or from: it may depend on params.
fn height(reader: &mut Reader, of: &Expr, nature: Option<Nature>) -> Option<Quantity> {
    let known = {
        let passing = Passing { variable: None, ..reader.passing };
        let mut inner = Reader { passing, ..reader.again() };
        inner.quantity(of)?
    };
    let known = reader.in_this_law(known);
    let is_told = match nature {
        Some(Nature { is_angle: true, .. }) if is_in_rpm(of) => {
            is_angle(reader.report, of, "an angle")
        }
        Some(Nature { is_angle: true, .. }) => {
            known.value.is_some_and(|value| is_degrees_perhaps(reader.report, of, value))
        }
        Some(_) => is_angle(reader.report, of, "a length"),
        None => false,
    };
    (!is_told).then_some(known)
}

/// A height that is greater than zero, unless it depends on a param. `other` is the word for the opposite way.
fn positive_height(
    reader: &mut Reader,
    of: &Expr,
    nature: Option<Nature>,
    other: &str,
) -> Option<Quantity> {
    let known = height(reader, of, nature)?;
    let value = known.value.unwrap_or(1.0);
    // A param may have another value later.
    if value > 0.0 || known.formula.is_some() {
        return Some(known);
    }
    let remedy = if value == 0.0 {
        "write `dwell` where nothing moves".to_owned()
    } else {
        format!("write `{other}` for the opposite way")
    };
    let text = format!("a height is greater than zero, not `{of}`; {remedy}");
    reader.report.refuse(of.place, text)
}

/// How a motion goes on after all segments, which take so much, and after which it is so far from where it began.
fn round(
    reader: &mut Reader,
    motion: &MotionExpr,
    nature: Option<Nature>,
    [total, rest]: [f64; 2],
    place: Place,
) -> Option<Round> {
    let last = motion.segments.last();
    let open = last.filter(|segment| segment.span.is_none());
    let turns = nature.is_some_and(|nature| nature.of == Argument::Angle);
    if let Some(open) = open
        && (motion.repeats || !turns)
    {
        let text = if motion.repeats {
            "how long it stays before it begins anew is not said; give a number after `dwell`"
        } else {
            "after its last segment it stays where it is; leave this `dwell` out"
        };
        return reader.report.refuse(open.place, text);
    }
    if !turns {
        return Some(if motion.repeats { Round::Every(total) } else { Round::Once });
    }
    let degrees = |angle: f64| format_number((angle.to_degrees() * 1e6).round() / 1e6);
    if motion.repeats {
        let times = (TAU / total).round();
        if times < 1.0 || (times * total - TAU).abs() > SLACK {
            let text = format!(
                "its segments take {} deg, which is no whole part of a turn; change what they take, or leave `repeat` out",
                degrees(total)
            );
            return reader.report.refuse(place, text);
        }
        return Some(Round::Every(TAU / times));
    }
    if total > TAU + SLACK {
        let text = format!(
            "its segments take {} deg, and a turn has 360 deg; make some of them shorter",
            degrees(total)
        );
        return reader.report.refuse(place, text);
    }
    if rest != 0.0 {
        let text = format!(
            "after a turn of the shaft it is not where it began, but {} away; add `return over ...`, or `repeat` if it goes on so",
            format_number(rest)
        );
        return reader.report.refuse(place, text);
    }
    if open.is_none() && total < TAU - SLACK {
        let text = format!(
            "its segments take {} deg of a turn; add `dwell` for the rest, or `repeat` if the turn has several such parts",
            degrees(total)
        );
        return reader.report.refuse(place, text);
    }
    Some(Round::Every(TAU))
}

/// The part of a climb that is done.
fn stairs(reader: &mut Reader, climb: &Climb, round: Round) -> Quantity {
    let variable = reader.variable();
    let moved = variable.plus(Quantity::fixed(-climb.at), reader.formulas());
    let (stairs, unit, share) = match round {
        Round::Once => (Staircase::single(climb.law, 0), climb.span, 1.0),
        Round::Every(after) => {
            (Staircase::endless(climb.law, 0), after, (climb.span / after).min(1.0))
        }
    };
    let place = moved.over(Quantity::fixed(unit), reader.formulas());
    let place = place.as_formula(reader.formulas());
    let formula = Formula::Stairs(stairs, place, Number::new(share));
    Quantity { value: None, formula: Some(reader.formulas().add(formula)) }
}
