//! Motors, their ranges and steps.

use super::angle::{ask_about_degrees, is_angle, is_half_in_degrees, is_in_degrees, is_in_rpm};
use super::constant::TIME;
use super::coordinate::is_drawn;
use super::draft::{Draft, WrittenMotor};
use super::quantity::Quantity;
use super::reader::{Argument, Nature, Reader};
use super::report::{Report, StatementPlace};
use super::value::format_number;
use super::{find, law, rolling};
use crate::model::{self, JointId, JointKind, Model, Range};
use crate::syntax::ast::{Expr, Motor, Name, StartClause};

/// The greatest relative difference between two numbers that are equal but were computed differently.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, motor: &Motor) {
    let joint = find_driven(reader, draft, &motor.joint);
    let kind = joint.map(|joint| draft.model.joint(joint).kind);
    let ends = motor.range.iter().flatten();
    let numbers: Vec<&Expr> = ends.chain(&motor.step).collect();
    let is_told = match kind {
        Some(JointKind::Revolute(..)) => is_half_in_degrees(reader.report, &numbers),
        Some(JointKind::Prismatic(..)) => {
            let mut numbers = numbers.iter();
            numbers.any(|number| is_angle(reader.report, number, "a length"))
        }
        _ => false,
    };
    if is_told {
        return;
    }
    let range = range(reader, draft, motor);
    let step = step(reader, motor);
    let written = motor.law.as_ref();
    let nature = kind.map(|kind| Nature {
        of: Argument::Time,
        is_angle: !matches!(kind, JointKind::Prismatic(..)),
    });
    let factors = [Quantity::fixed(1.0); 2];
    let law = written.and_then(|law| law::read(reader, draft, law, TIME, factors, nature));
    if let (Some(written), Some(law)) = (written, law)
        && is_in_rpm(written)
        && draft.model.law(law).is_fixed()
    {
        let text =
            format!("a speed is no place: by this law it never moves; write `{written} * t`");
        return reader.report.error(written.place, text);
    }
    if let (Some(written), Some(JointKind::Prismatic(..))) = (written, kind)
        && is_in_rpm(written)
    {
        let text = format!(
            "`{written}` is a speed of turning, and `{}` slides; leave `rpm` out",
            motor.joint
        );
        return reader.report.error(written.place, text);
    }
    if let (Some(written), Some(law)) = (written, law)
        && is_in_degrees(written)
        && draft.model.law(law).is_fixed()
    {
        let name = &motor.joint;
        let text = format!(
            "by this law motor `{name}` never moves; write `motor {name}; start {{ {name} = {written}; }}` if it starts there"
        );
        return reader.report.error(written.place, text);
    }
    let Some(joint) = joint else {
        return;
    };
    if let (Some(range), Some(ends)) = (range, &motor.range)
        && let Some(JointKind::Revolute(..)) = kind
    {
        ask_about_degrees(reader.report, ends, range);
    }
    let origin = draft.note(&motor.joint.name);
    draft.model.motors.push(model::Motor { joint, origin, range, step, law });
    let written = motor.range.as_ref();
    let written = written.map(|[low, high]| format!("{low} ..= {high}"));
    draft.motors.push(WrittenMotor {
        statement: reader.report.statement(),
        range: written.unwrap_or_default(),
    });
}

/// The joint of this name, if a motor can drive it.
fn find_driven(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<JointId> {
    let joint = find::joint(reader, draft, name)?;
    let kind = draft.model.joint(joint).kind;
    let text = if let Some(word) = rolling::word_for(kind) {
        format!(
            "`{name}` is a {word}, which carries no motor; {}",
            rolling::motor_remedy(&draft.model, joint)
        )
    } else if let JointKind::Weld(..) = kind {
        format!(
            "`{name}` is a weld, which does not move; make it a `revolute`, or put the motor on another joint"
        )
    } else if draft.model.motor_of(joint).is_some() {
        format!("joint `{name}` has a motor already; remove one of the two")
    } else {
        return Some(joint);
    };
    reader.report.refuse(name.place(), text)
}

fn range(reader: &mut Reader, draft: &mut Draft, motor: &Motor) -> Option<Range> {
    let what = format!("motor `{}`", motor.joint);
    ordered_range(reader, draft, motor.range.as_ref()?, &what)
}

/// The range of a motor, or of something else that moves (`what`), if it ends after it begins.
pub(super) fn ordered_range(
    reader: &mut Reader,
    draft: &mut Draft,
    [from, to]: &[Expr; 2],
    what: &str,
) -> Option<Range> {
    let (low, high) = (reader.value(from), reader.value(to));
    let (low, high) = (low?, high?);
    let place = from.place.to(to.place);
    if low < high {
        let origin = draft.places.note(place);
        return Some(Range { low, high, origin });
    }
    let text = if low > high {
        format!("the range of {what} ends before it begins; write `{to} ..= {from}`")
    } else {
        format!(
            "{what} cannot move in a range of one value; give the range another end, or leave it out"
        )
    };
    reader.report.refuse(place, text)
}

fn step(reader: &mut Reader, motor: &Motor) -> Option<f64> {
    let step = motor.step.as_ref()?;
    let value = reader.value(step)?;
    if value > 0.0 {
        return Some(value);
    }
    let text =
        format!("the step of motor `{}` must be greater than zero, not `{step}`", motor.joint);
    reader.report.refuse(step.place, text)
}

/// Complains about a value at which a joint starts, if its motor does not go there.
pub(super) fn check_start(
    clause: &StartClause,
    joint: JointId,
    value: f64,
    draft: &Draft,
    report: &mut Report,
) {
    let Some((range, written)) = left(joint, value, draft) else {
        return;
    };
    let (place, text) = if is_drawn(&draft.model, joint) {
        let text = outside_as_drawn(&draft.model, joint, range, written);
        (draft.places.get(range.origin), text)
    } else {
        let text = format!(
            "motor `{}` starts at `{}`, outside its range; choose a start within `{written}`, or widen the range",
            clause.name, clause.value
        );
        (clause.value.place, text)
    };
    report.error(place, text);
}

/// Complains about a law that starts where its motor does not go.
pub(super) fn check_law(joint: JointId, value: f64, draft: &Draft, report: &mut Report) {
    let Some((range, written)) = left(joint, value, draft) else {
        return;
    };
    let text = format!(
        "motor `{}` starts at {} by its law, outside its range; widen `{written}`, or change the law",
        draft.model.joint(joint).name,
        format_number(value)
    );
    report.error(draft.places.get(range.origin), text);
}

/// Complains about motors that start at zero because nothing else was said, and do not go there.
pub(super) fn check_unlisted(draft: &Draft, report: &mut Report) {
    // A start may also be missing because of an error in it.
    if !report.is_empty() {
        return;
    }
    let model = &draft.model;
    for (joint, motor) in model.motors.iter().map(|motor| motor.joint).zip(&draft.motors) {
        let Some((range, written)) = left(joint, 0.0, draft) else {
            continue;
        };
        if model.start.values.iter().any(|start| start.joint == joint) {
            continue;
        }
        let name = &model.joint(joint).name;
        let text = if is_drawn(model, joint) {
            outside_as_drawn(model, joint, range, written)
        } else {
            format!(
                "motor `{name}` starts at 0, outside its range, as `start` says nothing else; \
                     write `{name} = ...;` in `start` with a value within `{written}`, or widen it"
            )
        };
        report.enter(StatementPlace::of_mechanism(motor.statement), None);
        report.error(draft.places.get(range.origin), text);
    }
}

fn outside_as_drawn(model: &Model, joint: JointId, range: Range, written: &str) -> String {
    let name = &model.joint(joint).name;
    let ends = written.split_once(" ..= ").map(|(low, high)| {
        let end = if range.low > 0.0 { low } else { high };
        let zero = if end.ends_with("deg") { "0 deg" } else { "0" };
        if range.low > 0.0 { format!("{zero} ..= {high}") } else { format!("{low} ..= {zero}") }
    });
    let wider = ends.unwrap_or_default();
    format!(
        "motor `{name}` starts at 0, where it is drawn, outside its range; write `{wider}`, which holds 0"
    )
}

/// The range of a joint's motor that a value is outside of, and how it is written.
fn left(joint: JointId, value: f64, draft: &Draft) -> Option<(Range, &str)> {
    let mut motors = draft.model.motors.iter();
    let number = motors.position(|motor| motor.joint == joint)?;
    let range = draft.model.motors[number].range?;
    (!within(value, range)).then_some((range, &draft.motors[number].range))
}

/// Whether a value is in a range, ends included: `90 deg` is also where `PI / 2` is.
fn within(value: f64, range: Range) -> bool {
    let Range { low, high, .. } = range;
    let slack = ROUNDING * low.abs().max(high.abs());
    value >= low - slack && value <= high + slack
}
