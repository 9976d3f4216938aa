//! From tokens to the tree of the text. What cannot be read is reported in the tree, and reading goes on after it.

mod action;
mod beginning;
mod ending;
mod expect;
mod expression;
mod figure;
mod foreign;
mod header;
mod item;
mod joint;
mod measured;
mod method;
mod motion;
mod part;
mod path;
mod recover;
mod setting;
mod statement;
mod tokens;
mod trace;
mod unit;

pub use beginning::STATEMENTS;

use super::ast::{Expr, Read, Statement, Text};
use super::limits;
use crate::bug::bug;
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

/// Of a text that is beyond a limit, the `struct` line is read if it has no more tokens than this.
const LINE: usize = 1000;

/// Reads the body of a `mechanism!`.
pub(super) fn read(input: TokenStream) -> Text {
    match limits::of_tokens(&input) {
        Ok(()) => read_within(input),
        Err(excess) => {
            let is_end =
                |tree: &TokenTree| matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ';');
            let line = input.into_iter().take_while(|tree| !is_end(tree));
            let line: TokenStream = line.take(LINE).collect();
            let is_short = limits::of_tokens(&line).is_ok();
            let mut text = if is_short { read_within(line) } else { Text::default() };
            text.statements = vec![recover::broken_statement(excess.message())];
            text.beginnings.clear();
            text.is_beyond = true;
            text
        }
    }
}

/// The same of a text that is within all limits.
fn read_within(input: TokenStream) -> Text {
    let text = tokens::run(braces_at_end(input), |input| {
        tokens::open_braces(input).map(|(_, content)| statement::text(&content)).unwrap_or_default()
    });
    text.unwrap_or_default()
}

/// Reads a statement alone, as it stands in a text that has a header; none if these tokens are anything else.
pub(super) fn read_statement(input: TokenStream) -> Option<Statement> {
    limits::of_tokens(&input).ok()?;
    let text = tokens::run(input, statement::text)?;
    // The first statement says that there is no header.
    let mut statements = text.statements.into_iter();
    match (statements.next()?, statements.next()?, statements.next()) {
        (Statement::Broken(_), statement, None) => Some(statement),
        _ => None,
    }
}

/// Reads something that is measured, and stands alone.
pub(super) fn read_measurand(input: TokenStream) -> Read<Expr> {
    limits::of_tokens(&input).map_err(|excess| excess.message())?;
    let read = tokens::run(input, |input| {
        let read = measured::number(input)?;
        if input.is_empty() {
            Ok(read)
        } else {
            Err(tokens::expected_message(input, "nothing more"))
        }
    });
    match read {
        Some(read) => read,
        None => bug!("a text was not read"),
    }
}

/// The tokens in braces that stand where the last token stands: there, a message about the end of the text is of use.
fn braces_at_end(input: TokenStream) -> TokenStream {
    let last = last_span(&input);
    let mut group = Group::new(Delimiter::Brace, input);
    group.set_span(last);
    TokenTree::Group(group).into()
}

/// The place of the last token; the macro's own call site if there is none.
pub(super) fn last_span(input: &TokenStream) -> Span {
    match input.clone().into_iter().last() {
        Some(TokenTree::Group(group)) => group.span_close(),
        Some(tree) => tree.span(),
        None => Span::call_site(),
    }
}
