//! Going on after an error.

use super::ending::{at_assignment, semicolon};
use super::tokens::{take, take_tree};
use crate::syntax::ast::Read;
use proc_macro2::{Delimiter, TokenTree};
use syn::parse::ParseStream;

/// Reads the remainder of a statement up to its `;`. After an error, goes to the next statement of a list in which
/// statements begin with one of these words.
pub(super) fn to_semicolon<T>(
    input: ParseStream,
    beginnings: &[&str],
    read: impl FnOnce(ParseStream) -> Read<T>,
) -> Read<T> {
    or_skip(input, beginnings, |input| {
        let begin = input.cursor();
        let value = read(input)?;
        semicolon(input, begin, beginnings)?;
        Ok(value)
    })
}

/// Reads the remainder of a statement that has an end of its own. After an error, goes to the next statement.
pub(super) fn or_skip<T>(
    input: ParseStream,
    beginnings: &[&str],
    read: impl FnOnce(ParseStream) -> Read<T>,
) -> Read<T> {
    let result = read(input);
    if result.is_err() {
        skip(input, beginnings);
    }
    result
}

/// Leaves the statement behind: past its `;` or its braces, or up to where another statement clearly begins.
pub(super) fn skip(input: ParseStream, beginnings: &[&str]) {
    // In a list without such words, a statement is a name that is given a value.
    let begins =
        || at_beginning(input, beginnings) || beginnings.is_empty() && at_assignment(input);
    while !input.is_empty() && !begins() {
        if take(input, ";").is_some() || ends_with_braces(take_tree(input)) {
            break;
        }
    }
}

fn ends_with_braces(tree: Option<TokenTree>) -> bool {
    // Without a tree the text is at its end.
    tree.is_none_or(
        |tree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace),
    )
}

/// Whether one of the words comes next, followed by what may follow it: a name, a number or a bracket. The word `at`
/// also stands within joints, before a bracket: it begins a statement only with `change` after it.
pub(super) fn at_beginning(input: ParseStream, beginnings: &[&str]) -> bool {
    let Some((word, rest)) = input.cursor().ident() else {
        return false;
    };
    let name = rest.ident().map(|(name, _)| name);
    let follows = if word == "at" {
        name.is_some_and(|name| name == "change")
    } else {
        name.is_some() || rest.literal().is_some() || rest.any_group().is_some()
    };
    follows && beginnings.iter().any(|beginning| word == *beginning)
}
