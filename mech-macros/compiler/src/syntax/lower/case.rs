//! The values of motors and the times for which a condition has to hold.

use super::angle::{is_angle, is_degrees_perhaps, is_half_in_degrees};
use super::constant::TIME;
use super::draft::Draft;
use super::find;
use super::reader::Reader;
use crate::bug::bug;
use crate::model::Case;
use crate::syntax::Place;
use crate::syntax::ast::{CaseExpr, Expr, Name};

/// Why numbers of a requirement may not depend on params.
pub(super) const WHY_FIXED: &str = "what is expected is proved at compile time";

/// A value may be beyond the end of its motor's range by this part of it, as it is computed in another way.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The times for which a condition has to hold.
pub(super) struct Times {
    pub(super) ends: [f64; 2],
    pub(super) place: Place,
}

/// The values of motors and the times for which a condition has to hold: none of them is given twice.
pub(super) fn lower_cases(
    reader: &mut Reader,
    draft: &mut Draft,
    given: &[CaseExpr],
) -> Option<(Vec<Case>, Option<Times>)> {
    let (mut cases, mut times): (Vec<Option<Case>>, Option<Option<Times>>) = Default::default();
    for case in given {
        let is_again = if is_time(draft, &case.motor) {
            let lowered = lower_times(reader, draft, case);
            times.replace(lowered).is_some()
        } else {
            let lowered = lower_case(reader, draft, case);
            let motor = lowered.as_ref().map(|case| case.motor);
            let mut known = cases.iter().flatten();
            let is_again = known.any(|known| Some(known.motor) == motor);
            cases.push(lowered);
            is_again
        };
        if is_again {
            let name = &case.motor;
            let text = format!("the values of `{name}` are given twice; remove one of the two");
            return reader.report.refuse(name.place(), text);
        }
    }
    let cases: Option<Vec<Case>> = cases.into_iter().collect();
    Some((cases?, times.map_or(Some(None), |times| times.map(Some))?))
}

/// Whether a name stands for the time. A joint of that name comes first.
fn is_time(draft: &Draft, name: &Name) -> bool {
    let mut joints = draft.model.joints.iter();
    name.uses.is_empty() && name.name == TIME && !joints.any(|joint| joint.name == TIME)
}

/// The times for which a condition has to hold.
fn lower_times(reader: &mut Reader, draft: &Draft, case: &CaseExpr) -> Option<Times> {
    let [first, last] = [&case.values[0], &case.values[case.values.len() - 1]];
    let place = first.place.to(last.place);
    if draft.model.lawful_motors().next().is_none() {
        if !reader.report.is_empty() {
            // It may be what is wrong with a law.
            return None;
        }
        let text = format!("no motor follows a law of the time, so `{TIME}` decides nothing");
        return reader.report.refuse(case.motor.place(), text);
    }
    let mut numbers = case.values.iter();
    if numbers.any(|number| is_angle(reader.report, number, "a time")) {
        return None;
    }
    let mut fixed = reader.fixed(WHY_FIXED);
    let ends = [first, last].map(|number| fixed.value(number));
    let ends = [ends[0]?, ends[1]?];
    if ends[0] > ends[1] {
        let text = format!("these times end before they begin; write `{last} ..= {first}`");
        return reader.report.refuse(place, text);
    }
    Some(Times { ends, place })
}

/// The values of a motor for which a condition has to hold.
fn lower_case(reader: &mut Reader, draft: &mut Draft, case: &CaseExpr) -> Option<Case> {
    let motor = find::motor(reader, draft, &case.motor)?;
    let joint = draft.model.motor(motor).joint;
    let numbers: Vec<&Expr> = case.values.iter().collect();
    let is_turning = draft.model.turns(joint);
    let is_told = if is_turning {
        is_half_in_degrees(reader.report, &numbers)
    } else {
        let mut numbers = numbers.iter();
        numbers.any(|number| is_angle(reader.report, number, "a length"))
    };
    if is_told {
        return None;
    }
    let mut fixed = reader.fixed(WHY_FIXED);
    let values: Option<Vec<f64>> = case.values.iter().map(|value| fixed.value(value)).collect();
    let values = values?;
    let (Some(&low), Some(&high)) = (values.first(), values.last()) else {
        bug!("a case without values was read");
    };
    let [first, last] = [&case.values[0], &case.values[case.values.len() - 1]];
    let place = first.place.to(last.place);
    let name = &case.motor;
    for (expr, value) in case.values.iter().zip(&values) {
        if is_turning && is_degrees_perhaps(reader.report, expr, *value) {
            return None;
        }
    }
    if low > high {
        let text =
            format!("these values of `{name}` end before they begin; write `{last} ..= {first}`");
        return reader.report.refuse(place, text);
    }
    if let Some(range) = draft.model.motor(motor).range {
        let slack = ROUNDING * range.low.abs().max(range.high.abs());
        if low < range.low - slack || high > range.high + slack {
            let written = &draft.motors[motor.index()].range;
            let text = format!("motor `{name}` does not go there: its range is `{written}`");
            return reader.report.refuse(place, text);
        }
    }
    let origin = draft.places.note(place);
    Some(Case { motor, ends: [low, high], origin })
}
