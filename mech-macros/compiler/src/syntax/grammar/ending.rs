//! The end of a statement, and the message where it is missing.

use super::beginning::{STATEMENTS, at_beginning};
use super::tokens::{beginning, comes, expected_message, take};
use super::unit::is_declared;
use crate::syntax::ast::Read;
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Delimiter, TokenTree};
use syn::buffer::Cursor;
use syn::parse::ParseStream;

/// Takes the `;` of a statement that began there, in a list in which statements begin with one of these words.
pub(super) fn semicolon(input: ParseStream, begin: Cursor, beginnings: &[&str]) -> Read<()> {
    if take(input, ";").is_some() {
        return Ok(());
    }
    let forgotten = missing_after(input, begin, beginnings, "`;`");
    Err(forgotten.unwrap_or_else(|| otherwise(input, beginnings)))
}

/// The message that something is missing after what was read last, if another statement or nothing comes next.
pub(super) fn missing_after(
    input: ParseStream,
    begin: Cursor,
    beginnings: &[&str],
    missing: &str,
) -> Option<Message> {
    let next = input.is_empty() || at_beginning(input, beginnings) || at_assignment(input);
    next.then(|| after_last(input, begin, missing)).flatten()
}

/// The message that something is missing after what was read last, if anything was.
pub(super) fn after_last(input: ParseStream, begin: Cursor, missing: &str) -> Option<Message> {
    let last = last_between(begin, input.cursor())?;
    let (text, place) = match &last {
        TokenTree::Group(group) => {
            (closing_bracket(group.delimiter()), Place::at(group.span_close()))
        }
        tree => (beginning(tree), Place::at(tree.span())),
    };
    Some(Message::new(place, format!("expected {missing} after `{text}`")))
}

/// Whether a name comes next that is given a value.
pub(super) fn at_assignment(input: ParseStream) -> bool {
    let name = input.cursor().ident();
    name.is_some_and(|(_, rest)| is_declared(rest))
}

fn closing_bracket(delimiter: Delimiter) -> String {
    match delimiter {
        Delimiter::Parenthesis => ")",
        Delimiter::Brace => "}",
        Delimiter::Bracket => "]",
        Delimiter::None => "this",
    }
    .to_owned()
}

/// Complains about a word after which a statement would go on, if it were spelt as one of these.
pub(super) fn refuse_misspelt(input: ParseStream, words: &[&str]) -> Read<()> {
    let Some((word, _)) = input.cursor().ident() else {
        return Ok(());
    };
    let text = word.to_string();
    let is_right = words.contains(&text.as_str());
    if is_right || at_beginning(input, &STATEMENTS) || at_assignment(input) {
        return Ok(());
    }
    spelling::nearest(&text, words).map_or(Ok(()), |near| {
        let text = format!("unknown word `{text}`; did you mean `{near}`?");
        Err(Message::new(Place::at(word.span()), text))
    })
}

/// The last token between two places.
fn last_between(begin: Cursor, end: Cursor) -> Option<TokenTree> {
    let (mut cursor, mut last) = (begin, None);
    while cursor != end {
        let (tree, rest) = cursor.token_tree()?;
        (last, cursor) = (Some(tree), rest);
    }
    last
}

fn otherwise(input: ParseStream, beginnings: &[&str]) -> Message {
    let mut message = expected_message(input, "`;`");
    if comes(input, ",") {
        message.text += if beginnings.is_empty() {
            "; end each with `;`"
        } else {
            "; write a statement for each"
        };
    }
    message
}
