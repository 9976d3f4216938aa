//! Numbers and their units as a report says them.

use crate::quantity::{Extreme, Summary, tick};
use mech_compiler::model::Precision;

/// What is measured is told with so many digits: at a dead point more are not known, as the mechanism stops a hair before it.
const DIGITS: usize = 4;

/// A number with so many digits, and its unit. A scene unit has no name. Of angles thousandths are told at most.
pub(super) fn with_unit(value: f64, unit: &str, digits: usize) -> String {
    let value = match unit {
        "deg" => (value * 1e3).round() / 1e3 + 0.0,
        _ => value,
    };
    let number = short(value, digits);
    match unit {
        "unit" | "" => number,
        unit => format!("{number} {unit}"),
    }
}

fn short(value: f64, digits: usize) -> String {
    let rounded = format!("{value:.*e}", digits.saturating_sub(1)).parse();
    tick(rounded.unwrap_or(value))
}

/// What drives a motion.
pub(super) struct Driver {
    pub(super) name: String,
    pub(super) unit: &'static str,
    /// How large the mechanism is that it drives.
    pub(super) size: f64,
    pub(super) precision: Precision,
    /// Whether the motion ends where it began.
    pub(super) is_cyclic: bool,
}

impl Driver {
    /// `38.9 deg at a = 199.5 deg`.
    pub(super) fn at(&self, extreme: Extreme, unit: &str) -> String {
        format!(
            "{} at {} = {}",
            with_unit(extreme.value, unit, DIGITS),
            self.name,
            with_unit(extreme.by, self.unit, DIGITS)
        )
    }

    /// What differs by less, in turns or sizes of the mechanism, differs by rounding alone.
    fn near(&self) -> f64 {
        1e-7_f64.max(1e3 * self.precision.epsilon())
    }

    /// Whether a quantity stays as it is in this motion.
    pub(super) fn is_still(&self, summary: &Summary) -> bool {
        let whole = if summary.unit == "deg" { 360.0 } else { self.size };
        summary.extent() <= self.near() * whole
    }

    /// What a joint does that is driven.
    pub(super) fn joint_line(&self, summary: &Summary) -> String {
        let Summary { name, unit, least, greatest, time_ratio, .. } = summary;
        let extent = summary.extent();
        let (is_angle, turns) = (unit == "deg", extent / 360.0);
        if self.is_still(summary) {
            return format!("joint `{name}` stays at {}", with_unit(least.value, unit, DIGITS));
        }
        if is_angle && turns >= 1.0 - self.near() {
            return if (turns - 1.0).abs() <= self.near() {
                format!("joint `{name}` turns right round")
            } else {
                format!("joint `{name}` turns {} times", short(turns, DIGITS))
            };
        }
        if is_angle && self.is_cyclic && summary.is_one_way() {
            return format!("joint `{name}` turns by {}", with_unit(extent, unit, DIGITS));
        }
        let does = if is_angle { "swings by" } else { "has a stroke of" };
        let ratio = time_ratio.filter(|ratio| *ratio > 1.0 + 1e-4);
        let ratio = ratio.map(|ratio| format!("; time ratio {}", short(ratio, DIGITS)));
        format!(
            "joint `{name}` {does} {}, from {} to {}{}",
            with_unit(extent, unit, DIGITS),
            self.at(*least, unit),
            self.at(*greatest, unit),
            ratio.unwrap_or_default()
        )
    }
}
