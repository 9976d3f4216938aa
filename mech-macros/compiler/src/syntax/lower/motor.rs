//! Motors, their ranges and steps.

use super::Lowering;
use super::law;
use super::report::StatementPlace;
use super::rolling;
use super::value::format_number;
use crate::model::{self, JointId, JointKind, Range};
use crate::syntax::ast::{Expr, Motor, Name};

/// The greatest relative difference between two numbers that are equal but were computed differently.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A range as it was written, for messages about the start.
pub(super) struct WrittenRange {
    joint: JointId,
    range: Range,
    written: String,
    /// The number of the motor's statement.
    statement: usize,
}

impl Lowering {
    pub(super) fn lower_motor(&mut self, motor: &Motor) {
        let joint = self.find_driven(&motor.joint);
        let range = self.range(motor);
        let step = self.step(motor);
        let law = motor.law.as_ref();
        let law = law.and_then(|law| self.law(law, law::TIME));
        let Some(joint) = joint else {
            return;
        };
        if let (Some(range), Some(ends @ [low, high])) = (range, &motor.range) {
            if let JointKind::Revolute(..) = self.model.joint(joint).kind {
                self.ask_about_degrees(ends, range);
            }
            self.ranges.push(WrittenRange {
                joint,
                range,
                written: format!("{low} ..= {high}"),
                statement: self.report.statement(),
            });
        }
        let origin = self.note(&motor.joint.name);
        self.model.motors.push(model::Motor {
            joint,
            origin,
            range,
            step,
            law,
        });
        if law.is_some() {
            self.lawful.push((joint, self.report.statement()));
        }
    }

    /// The joint of this name, if a motor can drive it.
    fn find_driven(&mut self, name: &Name) -> Option<JointId> {
        let joint = self.find_joint(name)?;
        let kind = self.model.joint(joint).kind;
        let text = if let Some(word) = rolling::word_for(kind) {
            format!(
                "`{name}` is a {word}, which carries no motor; {}",
                self.motor_remedy(joint)
            )
        } else if let JointKind::Weld(..) = kind {
            format!(
                "`{name}` is a weld, which does not move; make it a `revolute`, or put the motor on another joint"
            )
        } else if self.model.motor_of(joint).is_some() {
            format!("joint `{name}` has a motor already; remove one of the two")
        } else {
            return Some(joint);
        };
        self.report.error(name.place(), text);
        None
    }

    fn range(&mut self, motor: &Motor) -> Option<Range> {
        let [from, to] = motor.range.as_ref()?;
        let (low, high) = (self.value(from), self.value(to));
        let (low, high) = (low?, high?);
        let name = &motor.joint;
        let place = from.place.to(to.place);
        if low < high {
            let origin = self.places.note(place);
            return Some(Range { low, high, origin });
        }
        let text = if low > high {
            format!("the range of motor `{name}` ends before it begins; write `{to} ..= {from}`")
        } else {
            format!(
                "motor `{name}` cannot move in a range of one value; give the range another end, or leave it out"
            )
        };
        self.report.error(place, text);
        None
    }

    fn step(&mut self, motor: &Motor) -> Option<f64> {
        let step = motor.step.as_ref()?;
        let value = self.value(step)?;
        if value > 0.0 {
            return Some(value);
        }
        let text = format!(
            "the step of motor `{}` must be greater than zero, not `{step}`",
            motor.joint
        );
        self.report.error(step.place, text);
        None
    }

    /// Complains about a value at which a joint starts, if its motor does not go there.
    pub(super) fn check_in_range(&mut self, name: &Name, joint: JointId, start: (f64, &Expr)) {
        let (value, expr) = start;
        let ranged = self.ranges.iter().find(|ranged| ranged.joint == joint);
        let Some(ranged) = ranged.filter(|ranged| !within(value, ranged.range)) else {
            return;
        };
        let written = &ranged.written;
        let text = if self.is_drawn(joint) {
            self.outside_as_drawn(ranged)
        } else {
            format!(
                "motor `{name}` starts at `{expr}`, outside its range; choose a start within `{written}`, or widen the range"
            )
        };
        self.report.error(expr.place, text);
    }

    /// Complains about a law that starts where its motor does not go.
    pub(super) fn check_law_in_range(&mut self, name: &str, joint: JointId, value: f64) {
        let ranged = self.ranges.iter().find(|ranged| ranged.joint == joint);
        let Some(ranged) = ranged.filter(|ranged| !within(value, ranged.range)) else {
            return;
        };
        let text = format!(
            "motor `{name}` starts at {} by its law, outside its range; widen `{}`, or change the law",
            format_number(value),
            ranged.written
        );
        self.report
            .error(self.places.get(ranged.range.origin), text);
    }

    /// Complains about motors that start at zero because nothing else was said, and do not go there.
    pub(super) fn check_unlisted(&mut self) {
        // A start may also be missing because of an error in it.
        if !self.report.is_empty() {
            return;
        }
        for ranged in &self.ranges {
            let mut listed = self.model.start.values.iter();
            if listed.any(|start| start.joint == ranged.joint) || within(0.0, ranged.range) {
                continue;
            }
            let WrittenRange { joint, written, .. } = ranged;
            let name = &self.model.joint(*joint).name;
            let text = if self.is_drawn(*joint) {
                self.outside_as_drawn(ranged)
            } else {
                format!(
                    "motor `{name}` starts at 0, outside its range, as `start` says nothing else; \
                     write `{name} = ...;` in `start` with a value within `{written}`, or widen it"
                )
            };
            self.report
                .enter(StatementPlace::of_mechanism(ranged.statement), None);
            self.report
                .error(self.places.get(ranged.range.origin), text);
        }
    }

    fn outside_as_drawn(&self, ranged: &WrittenRange) -> String {
        let name = &self.model.joint(ranged.joint).name;
        format!(
            "motor `{name}` starts at 0, where it is drawn, outside its range; widen `{}` so that it holds 0",
            ranged.written
        )
    }
}

/// Whether a value is in a range, ends included: `90 deg` is also where `PI / 2` is.
fn within(value: f64, range: Range) -> bool {
    let Range { low, high, .. } = range;
    let slack = ROUNDING * low.abs().max(high.abs());
    value >= low - slack && value <= high + slack
}
