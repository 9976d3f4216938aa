//! Names, and paths through uses of parts: `left[2].foot.tip`.

use super::expression::expression;
use super::tokens::{comes, in_brackets, name, take};
use crate::syntax::Message;
use crate::syntax::Place;
use crate::syntax::ast::{End, ExprKind, Index, Name, Read, Segment};
use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::token;

/// Reads `link`, `link.axis` or `use.link.axis`. Without brackets the last word is taken for an axis: where the one before it turns out
/// to be a use, `uses` of the lowering moves them.
pub(super) fn end(input: ParseStream) -> Read<End> {
    let (mut segments, last) =
        segments(input, "the name of a link", "the name of a point or line")?;
    let is_link = |segment: &Segment| segment.index.is_none();
    let Some(link) = segments.pop_if(|segment| is_link(segment)) else {
        let link = Name { uses: segments, name: last };
        return Ok(End { link, axis: None });
    };
    let link = Name { uses: segments, name: link.name };
    let axis = Some(last);
    Ok(End { link, axis })
}

/// Reads the name of a link or joint (`what`), or a path to one.
pub(super) fn path(input: ParseStream, what: &str) -> Read<Name> {
    let (uses, name) = segments(input, what, what)?;
    Ok(Name { uses, name })
}

/// Reads words with dots between them; the last has no brackets.
fn segments(input: ParseStream, first: &str, later: &str) -> Read<(Vec<Segment>, Ident)> {
    let mut segments = Vec::new();
    let mut what = first;
    loop {
        let name = name(input, what)?;
        let index = index(input)?;
        if take(input, ".").is_none() {
            return match index {
                None => Ok((segments, name)),
                Some(index) => Err(no_instance(name, index)),
            };
        }
        segments.push(Segment { name, index });
        what = later;
    }
}

/// The message about a name in brackets with nothing after it.
fn no_instance(name: Ident, index: Index) -> Message {
    let place = Place::at(name.span());
    let point = match &index {
        Index::At(index) if matches!(index.kind, ExprKind::Constant(_)) => {
            Some(format!("{name}.{index}"))
        }
        _ => None,
    };
    let text = match point {
        Some(point) if name == "ground" => {
            format!("a point of a link is named with `.`; write `{point}`")
        }
        point => {
            let or = point.map(|point| format!(", or write `{point}` if a point is meant"));
            let index = Some(index);
            let instance = Segment { name, index };
            format!(
                "`{}` in brackets is an instance of a part; name what of it is meant, as `{instance}.tip`{}",
                instance.name,
                or.unwrap_or_default()
            )
        }
    };
    Message::new(place, text)
}

fn index(input: ParseStream) -> Read<Option<Index>> {
    if !input.peek(token::Bracket) {
        return Ok(None);
    }
    let (index, place) = in_brackets(input, "`[`", |input| {
        if comes(input, "*") {
            take(input, "*");
            return Ok(None);
        }
        expression(input).map(Some)
    })?;
    Ok(Some(match index {
        Some(index) => Index::At(index),
        None => Index::Every(place),
    }))
}
