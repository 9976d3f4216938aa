//! Names, and paths through uses of parts: `left[2].foot.tip`.

use super::expression::expression;
use super::tokens::{comes, in_brackets, name, take};
use crate::syntax::Message;
use crate::syntax::Place;
use crate::syntax::ast::{End, Index, Name, Read, Segment};
use syn::parse::ParseStream;
use syn::token;

/// Reads `link`, `link.axis` or `use.link.axis`. Without brackets the last word is taken for an axis: where the one before it turns out
/// to be a use, `uses` of the lowering moves them.
pub(super) fn end(input: ParseStream) -> Read<End> {
    let (mut segments, last) =
        segments(input, "the name of a link", "the name of a point or line")?;
    let is_link = |segment: &Segment| segment.index.is_none();
    let Some(link) = segments.pop_if(|segment| is_link(segment)) else {
        let link = Name {
            uses: segments,
            name: last,
        };
        return Ok(End { link, axis: None });
    };
    let link = Name {
        uses: segments,
        name: link.name,
    };
    let axis = Some(last);
    Ok(End { link, axis })
}

/// Reads the name of a link or joint (`what`), or a path to one.
pub(super) fn path(input: ParseStream, what: &str) -> Read<Name> {
    let (uses, name) = segments(input, what, what)?;
    Ok(Name { uses, name })
}

/// Reads words with dots between them; the last has no brackets.
fn segments(
    input: ParseStream,
    first: &str,
    later: &str,
) -> Read<(Vec<Segment>, proc_macro2::Ident)> {
    let mut segments = Vec::new();
    let mut what = first;
    loop {
        let name = name(input, what)?;
        let index = index(input)?;
        if take(input, ".").is_none() {
            if let Some(Index::At(_) | Index::Every(_)) = index {
                let text = format!(
                    "`{name}` in brackets is an instance of a part; name what of it is meant, as `{}.tip`",
                    Segment {
                        name: name.clone(),
                        index
                    }
                );
                return Err(Message::new(Place::at(name.span()), text));
            }
            return Ok((segments, name));
        }
        segments.push(Segment { name, index });
        what = later;
    }
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
