//! Traces: `rod.small_end 256 on plane 1 color 5`.

use super::expression::expression;
use super::item::look;
use super::path::end;
use super::tokens::{comes, expected_message};
use crate::syntax::ast::{Read, Trace};
use syn::parse::ParseStream;

/// Reads what follows the word `trace`.
pub(super) fn trace(input: ParseStream) -> Read<Trace> {
    let point = end(input)?;
    if comes(input, ";") || input.is_empty() {
        let mut error = expected_message(input, "how many places are kept");
        error.text.push_str("; write a number after the point, such as 256");
        return Err(error);
    }
    let length = expression(input)?;
    let (plane, color) = look(input)?;
    Ok(Trace { point, length, plane, color })
}
