//! Units that numbers do not have here: there are only `deg` and `rpm`.

use super::tokens::advance;
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::written::{in_product, with_degrees};
use crate::syntax::{Message, Place};
use proc_macro2::Ident;
use syn::buffer::Cursor;
use syn::parse::ParseStream;

const DEGREES: [&str; 3] = ["degree", "degrees", "degs"];
const RADIANS: [&str; 4] = ["rad", "rads", "radian", "radians"];
const TURNS: [&str; 5] = ["turn", "turns", "rev", "revs", "revolutions"];
const LENGTHS: [&str; 9] = ["um", "mm", "cm", "dm", "m", "km", "inch", "inches", "ft"];
const OTHERS: [&str; 11] = ["kg", "g", "mg", "lb", "ms", "s", "sec", "N", "kN", "Nm", "Hz"];
/// Turns in a minute, in radians per second.
pub(super) const SPEED: &str = "rpm";
const TYPES: [&str; 6] = ["f64", "f32", "i32", "i64", "u32", "u64"];

/// Takes the name of a unit.
pub(super) fn take_foreign(input: ParseStream) -> Option<Ident> {
    advance(input, |cursor| {
        let (unit, rest) = cursor.ident()?;
        let text = unit.to_string();
        let lists: [&[&str]; 5] = [&DEGREES, &RADIANS, &TURNS, &LENGTHS, &OTHERS];
        let known = lists.iter().any(|list| list.contains(&text.as_str()));
        (known && !is_declared(rest)).then_some((unit, rest))
    })
}

/// Whether what comes shows that the word before it begins the next clause of a `start`.
pub(super) fn is_declared(rest: Cursor) -> bool {
    let assigned = rest.punct().is_some_and(|(sign, _)| sign.as_char() == '=');
    assigned || rest.ident().is_some_and(|(word, _)| word == "near")
}

/// Returns the message about a number with such a unit.
pub(super) fn trouble(number: &Expr, unit: &str, place: Place) -> Message {
    let text = if DEGREES.contains(&unit) {
        let degrees = match number.kind {
            ExprKind::Degrees(_) => number.to_string(),
            _ => with_degrees(number),
        };
        format!("there is no unit `{unit}`; write `{degrees}`")
    } else if RADIANS.contains(&unit) {
        format!("a number without a unit is in radians; write `{number}`")
    } else if TURNS.contains(&unit) {
        let number = in_product(number);
        format!("there is no unit `{unit}`; write `{number} * 360 deg`")
    } else if LENGTHS.contains(&unit) {
        format!("lengths have no unit; write `{number}`, and all lengths in the same unit")
    } else if OTHERS.contains(&unit) {
        format!(
            "there is no unit `{unit}`; write `{number}`, in units that fit the others, such as m, kg and s"
        )
    } else if unit == "t" {
        format!("a product is written with `*`; write `{} * t`", in_product(number))
    } else if TYPES.contains(&unit) {
        format!("a number has no type; write `{number}`")
    } else {
        format!(
            "unknown unit `{unit}`; lengths and angles in radians have none, degrees have `deg`"
        )
    };
    Message::new(place, text)
}
