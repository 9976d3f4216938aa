//! Functions, operators and comments of other languages, and how they are written here.

use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::written::{in_product, with_degrees};
use crate::syntax::{Message, Place};
use syn::parse::ParseStream;

/// Functions that look like one of ours, but are another.
const FUNCTIONS: [&str; 24] = [
    "arccos", "arcsin", "arctan", "arctan2", "sinh", "cosh", "tanh", "sind", "cosd", "tand", "cot",
    "sec", "csc", "pow", "powi", "powf", "exp2", "sgn", "signum", "ceil", "rad", "deg", "radians",
    "degrees",
];

/// Whether this names a function of another language.
pub(super) fn is_function(name: &str) -> bool {
    FUNCTIONS.contains(&name)
}

/// Writes a call of a function that there is not by functions that there are, if it can.
///
/// In brackets, so that it may stand wherever the call stood.
pub(super) fn call(name: &str, arguments: &[Expr]) -> Option<String> {
    let texts: Vec<String> = arguments.iter().map(in_product).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    Some(match (name, arguments, &texts[..]) {
        ("arccos" | "arcsin" | "arctan", [x], _) => format!("a{}({x})", &name[3..]),
        ("arctan2", [y, x], _) => format!("atan2({y}, {x})"),
        ("sinh", [x], _) => format!("((exp({x}) - exp(-({x}))) / 2)"),
        ("cosh", [x], _) => format!("((exp({x}) + exp(-({x}))) / 2)"),
        ("tanh", _, [x]) => format!("(1 - 2 / (exp(2 * {x}) + 1))"),
        ("exp2", _, [x]) => format!("exp({} * {x})", std::f64::consts::LN_2),
        ("sind" | "cosd" | "tand", [x], _) => {
            format!("{}({})", name.trim_end_matches('d'), with_degrees(x))
        }
        ("cot", [x], _) => format!("(1 / tan({x}))"),
        ("sec", [x], _) => format!("(1 / cos({x}))"),
        ("csc", [x], _) => format!("(1 / sin({x}))"),
        ("pow" | "powi" | "powf", [x, power], _) => spell_power(x, power)?,
        ("sgn" | "signum", [x], _) => format!("sign({x})"),
        ("ceil", _, [x]) => format!("(-floor(-{x}))"),
        ("rad" | "deg" | "radians" | "degrees", [x], _) => with_degrees(x),
        _ => return None,
    })
}

/// A power as it can be written, if it can be.
fn spell_power(base: &Expr, power: &Expr) -> Option<String> {
    const MOST: usize = 8;
    let text = in_product(base);
    match &power.kind {
        ExprKind::Integer(digits) => {
            let factors = digits.parse().ok().filter(|count| (1..=MOST).contains(count));
            Some(format!("({})", vec![text; factors?].join(" * ")))
        }
        ExprKind::Decimal(digits) if digits.parse() == Ok(0.5) => Some(format!("sqrt({base})")),
        _ => None,
    }
}

/// Returns the message about a power.
pub(super) fn power(operator: &str, base: &Expr, power: &Expr) -> Message {
    let text = match spell_power(base, power) {
        Some(product) => format!("there is no `{operator}`; write `{product}`"),
        None => {
            format!("there is no `{operator}`; write the power as a product, such as `x * x * x`")
        }
    };
    Message::new(base.place.to(power.place), text)
}

/// Returns the message about a remainder.
pub(super) fn remainder(number: &Expr, divisor: &Expr) -> Message {
    let place: Place = number.place.to(divisor.place);
    let text = format!("there is no `%`; write `mod({number}, {divisor})`");
    Message::new(place, text)
}

/// Returns the message about a `#` that begins no attribute.
pub(super) fn comment(input: ParseStream) -> Option<Message> {
    let (mark, rest) = input.cursor().punct()?;
    let is_comment = mark.as_char() == '#' && rest.any_group().is_none() && rest.punct().is_none();
    let text = "a comment begins with `//`, not with `#`";
    is_comment.then(|| Message::new(Place::at(mark.span()), text))
}
