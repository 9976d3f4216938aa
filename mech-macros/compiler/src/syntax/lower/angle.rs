//! Plain numbers of more than a turn, which may have been meant in degrees.

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
