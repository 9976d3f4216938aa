//! Motors that cannot follow a point.

use super::Words;
use super::wording::and;
use crate::bug::bug;
use crate::digits::significant;
use crate::model::{Inverse, JointId, MotorId, Origin};
use crate::repair::Offers;
use crate::structure::{InverseTrouble, RangeTrouble, TrajectoryStop};

impl Words<'_> {
    pub(super) fn cannot_follow(
        &self,
        trouble: &InverseTrouble,
        offers: &Offers,
    ) -> (Origin, String) {
        let inverse = self.inverse();
        let what = inverse.name(self.model);
        let where_it_is = if inverse.gives_angle() {
            format!("where `{what}` is, or at which angle")
        } else {
            format!("where `{what}` is")
        };
        let motors = and(&self.names_of_motors(&inverse.motors));
        let (origin, text) = match trouble {
            InverseTrouble::Idle { motors } => {
                let verb = if motors.len() == 1 { "has" } else { "have" };
                let names = and(&self.names_of_motors(motors));
                let named = inverse.motors.iter().zip(&inverse.named);
                let mut named = named.filter(|(motor, _)| motors.contains(motor));
                (
                    named.next().map(|(_, origin)| *origin),
                    format!("{names} {verb} no part in {where_it_is}"),
                )
            }
            InverseTrouble::Bound => {
                (None, format!("{motors} do not determine {where_it_is}: it is held on a path"))
            }
            InverseTrouble::DeadStart { unknowns } if unknowns.is_empty() => (
                None,
                format!("at the start {motors} cannot move `{what}` every way; start elsewhere"),
            ),
            InverseTrouble::DeadStart { unknowns } => (
                None,
                format!(
                    "at the start {motors} cannot move `{what}` every way: the loop of {} is at a dead point there",
                    self.joints(unknowns)
                ),
            ),
            InverseTrouble::StartsOutside { given, start } => (
                Some(inverse.region[*given].origin),
                format!(
                    "`{what}` starts outside of this range: {} is {} there",
                    Inverse::GIVEN[*given],
                    given_value(*given, *start)
                ),
            ),
            InverseTrouble::Region { motor, unknowns, trouble, proved } => (
                inverse.given_by(*motor).map(|given| inverse.region[given].origin),
                self.region(*motor, unknowns, trouble, proved),
            ),
            InverseTrouble::Coupled { waiting } => (
                None,
                format!(
                    "loops wait for each other where `{what}` is given: of {}",
                    self.joints(waiting)
                ),
            ),
            InverseTrouble::Trajectory { time, given, stop } => {
                let path = inverse.trajectory.first();
                (path.map(|law| self.model.law(*law).origin), self.path(*time, given, stop))
            }
        };
        let help = match trouble {
            InverseTrouble::DeadStart { .. } => self.start_elsewhere(offers),
            _ => self.help(offers),
        };
        (origin.unwrap_or(inverse.origin), text + &help)
    }

    /// Why a region is not proved.
    fn region(
        &self,
        motor: MotorId,
        unknowns: &[JointId],
        trouble: &RangeTrouble,
        proved: &[[f64; 2]],
    ) -> String {
        let inverse = self.inverse();
        let what = inverse.name(self.model);
        let not_proved =
            format!("it could not be proved that `{what}` comes to all of these places");
        let why = match trouble {
            RangeTrouble::Blocked { limit, others, .. } => {
                let others = others.iter().map(|(other, value)| {
                    format!(", where {}", self.is_at(*other, *value, ["is", "is at"]))
                });
                let others: String = others.collect();
                return format!(
                    "`{what}` does not come to all of these places: it is stopped at {}{others}\nnote: there {} close the loop{}",
                    self.is_at(motor, *limit, ["="; 2]),
                    self.the_joints(unknowns, ["cannot", "cannot"]),
                    self.smaller_region(proved)
                );
            }
            RangeTrouble::Cam(cam) => {
                format!("there is no proof for cams, and {} is a cam", self.joint(*cam))
            }
            RangeTrouble::Stops => format!(
                "the loop of {} has a change point there, and `at change points stop` was declared",
                self.joints(unknowns)
            ),
            RangeTrouble::Undecided { .. } => format!(
                "it could not be decided whether the loop of {} closes everywhere there",
                self.joints(unknowns)
            ),
            RangeTrouble::Iterated => format!(
                "the loop of {} is solved by iteration, for which there is no proof",
                self.joints(unknowns)
            ),
            RangeTrouble::Varies { param } => {
                format!("param `{}` may change the shape of the mechanism", self.param(*param))
            }
            RangeTrouble::Missing => "a motor that does not follow has no range".to_owned(),
        };
        format!(
            "{not_proved}: {why}{}\nhelp: leave `in` out; every way is then tested as it is made",
            self.smaller_region(proved)
        )
    }

    /// Why a point does not come along its path.
    fn path(&self, time: f64, given: &[f64], stop: &TrajectoryStop) -> String {
        let what = self.inverse().name(self.model);
        let given = given.iter().enumerate();
        let given: Vec<String> = given.map(|(given, value)| given_value(given, *value)).collect();
        let why = match stop {
            TrajectoryStop::Loop(joints) if joints.is_empty() => "a loop does not close".to_owned(),
            TrajectoryStop::Loop(joints) => {
                format!("{} close the loop", self.the_joints(joints, ["cannot", "cannot"]))
            }
            TrajectoryStop::Region(given) => format!("{} leaves its range", Inverse::GIVEN[*given]),
            TrajectoryStop::Range(motor) => {
                format!("motor `{}` would leave its range", self.name_of_motor(*motor))
            }
            TrajectoryStop::Apart => "the motors cannot follow it".to_owned(),
            TrajectoryStop::Law => "one of these is no number".to_owned(),
            TrajectoryStop::TooLarge => "that is too far away".to_owned(),
        };
        format!(
            "`{what}` does not come along its path: at t = {} it would be at ({}), and there {why}\nhelp: write a path that stays where \
             `{what}` comes, or begin nearer to it",
            significant(time, DIGITS, None),
            given.join(", ")
        )
    }

    /// The value of what is given in place of a motor, or of the motor itself: each with a verb.
    fn is_at(&self, motor: MotorId, value: f64, [is, is_at]: [&str; 2]) -> String {
        if let Some(given) = self.inverse().given_by(motor) {
            let value = given_value(given, value);
            return format!("{} {is} {value}", Inverse::GIVEN[given]);
        }
        let value = self.motor_value(motor, value);
        format!("`{}` {is_at} {value}", self.name_of_motor(motor))
    }

    /// The help about a smaller region that was proved.
    fn smaller_region(&self, proved: &[[f64; 2]]) -> String {
        if proved.is_empty() {
            return String::new();
        }
        let ranges = proved.iter().enumerate().map(|(given, ends)| {
            let [low, high] = ends.map(|end| given_value(given, end));
            format!("{low} ..= {high}")
        });
        let ranges: Vec<String> = ranges.collect();
        let what = self.inverse().name(self.model);
        format!("\nhelp: `{what}` comes to all of `in ({})`", ranges.join(", "))
    }

    /// The statement with these motors instead.
    pub(super) fn follow_line(&self, motors: &[MotorId]) -> String {
        let what = self.inverse().name(self.model);
        let names: Vec<&str> = motors.iter().map(|motor| self.name_of_motor(*motor)).collect();
        format!("write `follow {what} by {};`", names.join(", "))
    }

    fn inverse(&self) -> &Inverse {
        let Some(inverse) = &self.model.inverse else {
            bug!("motors follow nothing");
        };
        inverse
    }

    fn name_of_motor(&self, motor: MotorId) -> &str {
        &self.model.joint(self.model.motor(motor).joint).name
    }

    fn names_of_motors(&self, motors: &[MotorId]) -> Vec<String> {
        let names = motors.iter().map(|motor| self.name_of_motor(*motor));
        names.map(|name| format!("`{name}`")).collect()
    }
}

/// So many digits of a number are told.
const DIGITS: i32 = 4;

/// A value of what is given, as one would write it.
fn given_value(given: usize, value: f64) -> String {
    let (value, unit) = match given {
        Inverse::ANGLE => (value.to_degrees(), " deg"),
        _ => (value, ""),
    };
    format!("{}{unit}", significant(value, DIGITS, None))
}
