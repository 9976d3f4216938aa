//! Plain numbers that may have been meant in degrees, and degrees where no angle stands.

use super::report::Report;
use crate::model::Range;
use crate::syntax::Place;
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::written::with_degrees;
use std::f64::consts::TAU;

/// Whether this is an angle that was hardly meant: more than a turn, in a plain number. Told if so.
pub(super) fn is_degrees_perhaps(report: &mut Report, angle: &Expr, value: f64) -> bool {
    let asks = value.abs() > TAU && is_plain(angle);
    if asks {
        let what = format!("`{angle}` is an angle in radians, more than a turn");
        offer_degrees(report, angle.place, &what, &with_degrees(angle));
    }
    asks
}

/// Asks about a range of angles in plain numbers that ends beyond a turn.
pub(super) fn ask_about_degrees(report: &mut Report, [low, high]: &[Expr; 2], range: Range) {
    let goes_far = range.low.abs().max(range.high.abs()) > TAU;
    if goes_far && is_plain(low) && is_plain(high) {
        let what = format!("`{low} ..= {high}` is in radians, more than a turn");
        let offer = format!("{} ..= {}", with_degrees(low), with_degrees(high));
        offer_degrees(report, low.place.to(high.place), &what, &offer);
    }
}

/// Whether one end of a range, or the step in it, is a plain number beside an end in degrees. Told if so.
pub(super) fn is_half_in_degrees(report: &mut Report, numbers: &[&Expr]) -> bool {
    let mut ends = numbers.iter().take(2);
    let with = ends.find(|number| is_in_degrees(number));
    let without = numbers.iter().find(|number| is_plain(number) && !is_zero(number));
    let (Some(with), Some(without)) = (with, without) else {
        return false;
    };
    let what = format!("`{without}` is in radians, beside `{with}`");
    offer_degrees(report, without.place, &what, &with_degrees(without));
    true
}

/// Whether a number is written in degrees.
pub(super) fn is_in_degrees(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Degrees(_) => true,
        ExprKind::Negative(inner) => is_in_degrees(inner),
        ExprKind::Sum(parts) => parts.iter().any(|(_, part)| is_in_degrees(part)),
        _ => false,
    }
}

/// Whether a number is written as a speed.
pub(super) fn is_in_rpm(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Rpm(_) => true,
        ExprKind::Negative(inner) => is_in_rpm(inner),
        ExprKind::Sum(parts) | ExprKind::Product(parts) => {
            parts.iter().any(|(_, part)| is_in_rpm(part))
        }
        _ => false,
    }
}

/// Whether what is no angle, but a length or a mass, is written in degrees, or as a speed. Told if so.
pub(super) fn is_angle(report: &mut Report, number: &Expr, what: &str) -> bool {
    let (noun, unit) = match &number.kind {
        _ if is_in_rpm(number) => ("a speed", "rpm"),
        _ if is_in_degrees(number) => ("an angle", "deg"),
        _ => return false,
    };
    let text = format!("`{number}` is {noun}, and this is {what}; leave `{unit}` out");
    report.error(number.place, text);
    true
}

fn is_zero(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Integer(digits) | ExprKind::Decimal(digits) => digits.parse() == Ok(0.0),
        ExprKind::Negative(inner) => is_zero(inner),
        _ => false,
    }
}

fn offer_degrees(report: &mut Report, place: Place, what: &str, offer: &str) {
    let text = format!(
        "{what}; write `{offer}`\n\nhelp: or give the number a name with `const`, if radians are meant"
    );
    report.error(place, text);
}

/// Whether a number is made of digits alone: nobody wrote `deg`, `PI` or a name.
fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Integer(_) | ExprKind::Decimal(_) => true,
        ExprKind::Negative(inner) => is_plain(inner),
        ExprKind::Sum(parts) | ExprKind::Product(parts) => {
            parts.iter().all(|(_, part)| is_plain(part))
        }
        _ => false,
    }
}
