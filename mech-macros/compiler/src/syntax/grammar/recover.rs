//! Going on after an error.

use super::beginning::{STATEMENTS, at_beginning};
use super::ending::{at_assignment, semicolon};
use super::tokens::{name, take, take_tree};
use crate::syntax::ast::{Broken, Read, Statement};
use crate::syntax::{Message, Place};
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
        if take(input, ";").is_some() {
            break;
        }
        if ends_with_braces(take_tree(input)) {
            // That of a `use`.
            take(input, ";");
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
    Statement::Broken(Broken { error, names: Vec::new() })
}

/// Reads the name that a statement declares; without one, the statement is lost.
pub(super) fn read_declared(
    input: ParseStream,
    what: &str,
    rest: impl FnOnce(ParseStream, Ident) -> Statement,
) -> Statement {
    match declared_name(input, &STATEMENTS, what) {
        Ok(name) => rest(input, name),
        Err(broken) => Statement::Broken(broken),
    }
}

/// Reads the name that a statement or an item declares. Without one, leaves it behind.
pub(super) fn declared_name(
    input: ParseStream,
    beginnings: &[&str],
    what: &str,
) -> Result<Ident, Broken> {
    let names = seeming_name(input, beginnings);
    or_skip(input, beginnings, |input| name(input, what))
        .map_err(|error| Broken { error, names: names.into_iter().collect() })
}

/// The name that a statement seems to declare after its first word: the next word, be it in quotes.
fn seeming_name(input: ParseStream, beginnings: &[&str]) -> Option<Ident> {
    if at_beginning(input, beginnings) {
        return None;
    }
    let cursor = input.cursor();
    cursor.ident().map(|(name, _)| name).or_else(|| {
        let (quoted, _) = cursor.literal()?;
        let name = quoted.to_string();
        let mut name: Ident = syn::parse_str(name.trim_matches('"')).ok()?;
        name.set_span(quoted.span());
        Some(name)
    })
}

/// Leaves a statement or an item behind whose first word is wrong. That word is its name if none follows.
pub(super) fn leave_behind(
    input: ParseStream,
    beginnings: &[&str],
    keyword: &Ident,
    error: Message,
) -> Broken {
    let name = seeming_name(input, beginnings).unwrap_or_else(|| keyword.clone());
    skip(input, beginnings);
    Broken { error, names: vec![name] }
}

/// The message about a word that stands twice, of which the first has been read. Before a name's mark or braces, the second is a name.
pub(super) fn doubled(input: ParseStream, keyword: &Ident) -> Option<Message> {
    const WITHOUT_NAME: [&str; 3] = ["ground", "start", "effects"];
    let (_, rest) = input.cursor().ident().filter(|(next, _)| next == keyword)?;
    let is_word = rest.ident().is_some_and(|(word, _)| word != "in" && word != "by");
    let is_doubled =
        is_word || rest.any_group().is_some() && WITHOUT_NAME.iter().any(|word| keyword == word);
    let text = format!("`{keyword}` stands here twice; remove one of the two");
    is_doubled.then(|| Message::new(Place::at(keyword.span()), text))
}

/// Reads the remainder of a statement that declares no name.
pub(super) fn read_setting(
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> Read<Statement>,
) -> Statement {
    to_semicolon(input, &STATEMENTS, read).unwrap_or_else(broken_statement)
}
