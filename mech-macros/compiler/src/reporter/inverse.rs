//! Motors that cannot follow a point.

use super::Words;
use super::wording::and;
use crate::bug::bug;
use crate::model::{Inverse, MotorId, Origin};
use crate::repair::Offers;
use crate::structure::InverseTrouble;

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
            InverseTrouble::Bound => (
                None,
                format!("{motors} do not determine {where_it_is}: it is held on a path"),
            ),
            InverseTrouble::DeadStart { unknowns } => (
                None,
                format!(
                    "at the start {motors} cannot move `{what}` every way: the loop of {} is at a dead point there",
                    self.joints(unknowns)
                ),
            ),
            InverseTrouble::Coupled { waiting } => (
                None,
                format!(
                    "loops wait for each other where `{what}` is given: of {}",
                    self.joints(waiting)
                ),
            ),
        };
        let help = match trouble {
            InverseTrouble::DeadStart { .. } => self.start_elsewhere(offers),
            _ => self.help(offers),
        };
        (origin.unwrap_or(inverse.origin), text + &help)
    }

    /// The statement with these motors instead.
    pub(super) fn follow_line(&self, motors: &[MotorId]) -> String {
        let what = self.inverse().name(self.model);
        let names: Vec<&str> = motors
            .iter()
            .map(|motor| self.name_of_motor(*motor))
            .collect();
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
