//! Messages about accuracy.

use super::Words;
use crate::model::{MotorId, Origin, Precision};
use crate::structure::Extreme;

impl Words<'_> {
    fn scalar(&self) -> &'static str {
        match self.model.precision {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
        }
    }

    pub(super) fn too_large(&self) -> String {
        let scalar = self.scalar();
        if self.model.fits() && self.model.scale_trouble().is_some() {
            let [_, most] = self.model.precision.lengths();
            return format!(
                "a length of this mechanism is too large for `{scalar}`: its loops are solved with fourth powers of lengths\nhelp: \
                 use a larger unit, in which no length is greater than {most:e}"
            );
        }
        format!(
            "a length or a position of this mechanism, or its square, is beyond the range of `{scalar}`"
        )
    }

    pub(super) fn overflow(&self, culprit: Option<Extreme>) -> (Origin, String) {
        let (scalar, model) = (self.scalar(), self.model);
        let (origin, what) = match culprit {
            Some(Extreme::Mass(link)) => {
                (self.at_link(Some(&link)), format!("the mass of {}", self.link(link)))
            }
            Some(Extreme::Spring(number)) => {
                let spring = &model.actions.springs[number];
                (spring.origin, format!("spring `{}`", spring.name))
            }
            Some(Extreme::Damper(number)) => {
                let damper = &model.actions.dampers[number];
                (damper.origin, format!("damper `{}`", damper.name))
            }
            Some(Extreme::Gravity) => (model.origin, "`gravity`".to_owned()),
            Some(Extreme::Law(motor)) => {
                let name = &model.joint(model.motor(motor).joint).name;
                (model.motor(motor).origin, format!("the law of motor `{name}`"))
            }
            None => (model.origin, "this mechanism".to_owned()),
        };
        let double = match model.precision {
            Precision::F32 => ", or compute in `f64`",
            Precision::F64 => "",
        };
        let text = format!(
            "`{scalar}` does not hold the numbers that {what} leads to: they are too large, or too small\nhelp: choose units in which \
             the numbers are nearer to one{double}"
        );
        (origin, text)
    }

    pub(super) fn too_small(&self) -> String {
        let (scalar, [least, _]) = (self.scalar(), self.model.precision.lengths());
        format!(
            "all lengths of this mechanism are too small for `{scalar}`: it is solved and drawn with powers of them, which vanish\nhelp: use a \
             smaller unit, in which some length is at least {least:e}"
        )
    }

    pub(super) fn endless_accuracy(&self, accuracy: f64, motor: MotorId) -> String {
        let motor = &self.model.joint(self.model.motor(motor).joint).name;
        format!(
            "no accuracy holds for unlimited turns of motor `{motor}`: rounding errors of `{}` grow with each turn\nhelp: declare how \
             far it turns, for example `motor {motor} in -3600 deg ..= 3600 deg;`, or leave `accuracy {accuracy:e};` out",
            self.model.name
        )
    }

    pub(super) fn too_accurate(&self, accuracy: f64, best: f64) -> String {
        let single = self.model.precision == Precision::F32;
        let scalar = self.scalar();
        let in_double = best / Precision::F32.epsilon() * Precision::F64.epsilon();
        let best = upwards(best);
        let or_double = if single && in_double <= accuracy { ", or compute in `f64`" } else { "" };
        format!(
            "this accuracy is beyond `{scalar}`: positions of `{}` may be off by {best:.1e}, however its loops are solved\nhelp: \
             write `accuracy {best:.1e};` or more{or_double}",
            self.model.name
        )
    }
}

/// The next number of two digits that is not less.
fn upwards(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
    // A little more, because what is printed is rounded.
    let up = (value / unit + 1e-9).ceil() * unit;
    if up.is_finite() { up } else { value }
}
