//! Going on after an error.

use super::beginning::{STATEMENTS, at_beginning};
use super::ending::{at_assignment, semicolon};
use super::tokens::{name, take, take_tree};
use crate::syntax::Message;
use crate::syntax::ast::{Broken, Read, Statement};
use proc_macro2::{Delimiter, Ident, TokenTree};
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

/// A statement without a name that could not be read.
pub(super) fn broken_statement(error: Message) -> Statement {
    Statement::Broken(Broken {
        error,
        names: Vec::new(),
    })
}

/// Reads the name that a statement declares; without one, the statement is lost.
pub(super) fn read_declared(
    input: ParseStream,
    what: &str,
    rest: impl FnOnce(ParseStream, Ident) -> Statement,
) -> Statement {
    match or_skip(input, &STATEMENTS, |input| name(input, what)) {
        Ok(name) => rest(input, name),
        Err(error) => broken_statement(error),
    }
}

/// Reads the remainder of a statement that declares no name.
pub(super) fn read_setting(
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> Read<Statement>,
) -> Statement {
    to_semicolon(input, &STATEMENTS, read).unwrap_or_else(broken_statement)
}
