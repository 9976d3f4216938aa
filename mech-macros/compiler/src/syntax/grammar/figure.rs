//! Shapes that stand for a part of a machine: `gear (0, 0) teeth 20`.

use super::expression::{expression, pair, read_labelled};
use super::tokens::{expected_message, in_brackets, take, take_word};
use crate::syntax::ast::{Expr, Outline, Pair, Read};
use syn::LitStr;
use syn::parse::ParseStream;

/// Reads `radius 0.4`, which may be left out.
fn optional(input: ParseStream, label: &str) -> Read<Option<Expr>> {
    take_word(input, label).map(|_| expression(input)).transpose()
}

pub(super) fn gear(input: ParseStream) -> Read<Outline> {
    Ok(Outline::Gear {
        center: pair(input)?,
        radius: optional(input, "radius")?,
        teeth: read_labelled(input, "teeth")?,
        turned: optional(input, "turned")?,
    })
}

pub(super) fn stand(input: ParseStream) -> Read<Outline> {
    Ok(Outline::Stand {
        at: pair(input)?,
        height: optional(input, "height")?,
        turned: optional(input, "turned")?,
    })
}

pub(super) fn rail(input: ParseStream) -> Read<Outline> {
    let (ends, place) = in_brackets(input, "`[(x, y), (x, y)]`", corners)?;
    Ok(Outline::Rail { ends, place, width: optional(input, "width")? })
}

pub(super) fn spring(input: ParseStream) -> Read<Outline> {
    let (ends, place) = in_brackets(input, "`[(x, y), (x, y)]`", corners)?;
    Ok(Outline::Spring { ends, place, width: read_labelled(input, "width")? })
}

pub(super) fn text(input: ParseStream) -> Read<Outline> {
    let at = pair(input)?;
    if !input.peek(LitStr) {
        return Err(expected_message(input, "a text in quotes"));
    }
    let text = input.parse::<LitStr>().map_err(|_| expected_message(input, "a text in quotes"))?;
    Ok(Outline::Text {
        at,
        text,
        height: read_labelled(input, "height")?,
        turned: optional(input, "turned")?,
    })
}

pub(super) fn corners(input: ParseStream) -> Read<Vec<Pair>> {
    let mut corners = Vec::new();
    while !input.is_empty() {
        corners.push(pair(input)?);
        if take(input, ",").is_none() {
            break;
        }
    }
    Ok(corners)
}
