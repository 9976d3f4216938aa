//! Numbers and their units as a report says them.

use crate::quantity::{Extreme, Summary, tick};

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

/// What drives a motion: its name and its unit.
pub(super) struct Driver {
    pub(super) name: String,
    pub(super) unit: &'static str,
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

    /// What a joint does that is driven.
    pub(super) fn driven(&self, summary: &Summary) -> String {
        /// Angles that differ by less are one.
        const NEAR: f64 = 1e-6;
        let Summary {
            name,
            unit,
            least,
            greatest,
            time_ratio,
            ..
        } = summary;
        let extent = summary.extent();
        let size = least.value.abs().max(greatest.value.abs()).max(1.0);
        let turns = extent / 360.0;
        if extent <= NEAR * size {
            return format!(
                "joint `{name}` stays at {}",
                with_unit(least.value, unit, DIGITS)
            );
        }
        if unit == "deg" && turns >= 1.0 - NEAR {
            return match turns.round() {
                1.0 => format!("joint `{name}` turns right round"),
                whole if (turns - whole).abs() < NEAR => {
                    format!("joint `{name}` turns right round, {whole} times")
                }
                _ => format!("joint `{name}` turns {} times", short(turns, DIGITS)),
            };
        }
        let does = match unit.as_str() {
            "deg" => "swings by",
            _ => "has a stroke of",
        };
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
