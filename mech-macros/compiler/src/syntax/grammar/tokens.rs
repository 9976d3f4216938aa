//! Single tokens, and the brackets around them.

use crate::syntax::ast::Read;
use crate::syntax::{Message, Place};
use proc_macro2::{Delimiter, Ident, Spacing, Span, TokenStream, TokenTree};
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream, Parser};
use syn::token::{Brace, Bracket, Paren};
use syn::{braced, bracketed, parenthesized};

/// Runs a parser that makes its own messages.
pub(super) fn run<T>(tokens: TokenStream, parse: impl FnOnce(ParseStream) -> T) -> Option<T> {
    let mut result = None;
    let parser = |input: ParseStream| {
        result = Some(parse(input));
        Ok(())
    };
    // An error could only be about tokens that were left over, which have been reported by then.
    parser.parse2(tokens).ok();
    result
}

/// A message of `syn`'s as one of ours.
pub(super) fn message_of(error: &syn::Error) -> Message {
    Message::new(Place::at(error.span()), error.to_string())
}

/// The message that something else should stand here.
pub(super) fn expected_message(input: ParseStream, expected: &str) -> Message {
    let text = match input.cursor().token_tree() {
        Some((tree, _)) => format!("expected {expected}, found `{}`", beginning(&tree)),
        None => format!("expected {expected}"),
    };
    Message::new(Place::at(input.span()), text)
}

/// The first token of a tree, as text.
pub(super) fn beginning(tree: &TokenTree) -> String {
    let TokenTree::Group(group) = tree else {
        return tree.to_string();
    };
    match group.delimiter() {
        Delimiter::Parenthesis => "(".to_owned(),
        Delimiter::Brace => "{".to_owned(),
        Delimiter::Bracket => "[".to_owned(),
        Delimiter::None => group.stream().to_string(),
    }
}

/// Takes what the function reads at the cursor, if it reads anything.
pub(super) fn advance<T>(
    input: ParseStream,
    read: impl for<'c> Fn(Cursor<'c>) -> Option<(T, Cursor<'c>)>,
) -> Option<T> {
    // Most often there is nothing: then no error of `syn`'s is made, which costs more than all else here.
    read(input.cursor())?;
    input.step(|cursor| read(*cursor).ok_or_else(|| cursor.error("nothing to take"))).ok()
}

/// Takes whatever comes next.
pub(super) fn take_tree(input: ParseStream) -> Option<TokenTree> {
    advance(input, |cursor| cursor.token_tree())
}

/// Reads these punctuation characters.
fn punctuation<'c>(mut cursor: Cursor<'c>, text: &str) -> Option<(Place, Cursor<'c>)> {
    let mut place: Option<Place> = None;
    let mut rest = text.chars().peekable();
    while let Some(character) = rest.next() {
        let (punct, after) = cursor.punct()?;
        let apart = rest.peek().is_some() && punct.spacing() == Spacing::Alone;
        if punct.as_char() != character || apart {
            return None;
        }
        let start = place.map_or(punct.span(), |place| place.start);
        place = Some(Place { start, end: punct.span() });
        cursor = after;
    }
    Some((place?, cursor))
}

/// Whether these punctuation characters come next.
pub(super) fn comes(input: ParseStream, text: &str) -> bool {
    punctuation(input.cursor(), text).is_some()
}

/// Takes these punctuation characters if they come next.
pub(super) fn take(input: ParseStream, text: &str) -> Option<Place> {
    advance(input, |cursor| punctuation(cursor, text))
}

/// Takes these punctuation characters.
pub(super) fn symbol(input: ParseStream, text: &str) -> Read<Place> {
    take(input, text).ok_or_else(|| expected_message(input, &format!("`{text}`")))
}

/// Whether this word comes next.
pub(super) fn comes_word(input: ParseStream, word: &str) -> bool {
    input.cursor().ident().is_some_and(|(ident, _)| ident == word)
}

/// Takes this word if it comes next.
pub(super) fn take_word(input: ParseStream, word: &str) -> Option<Span> {
    advance(input, |cursor| cursor.ident().filter(|(ident, _)| ident == word))
        .map(|ident| ident.span())
}

/// Takes this word.
pub(super) fn word(input: ParseStream, word: &str) -> Read<Span> {
    take_word(input, word).ok_or_else(|| expected_message(input, &format!("`{word}`")))
}

/// Takes any word, be it a keyword of Rust.
pub(super) fn any_word(input: ParseStream) -> Option<Ident> {
    advance(input, |cursor| cursor.ident())
}

/// Takes a name that the generated code can bear.
pub(super) fn name(input: ParseStream, what: &str) -> Read<Ident> {
    if !input.peek(Ident::peek_any) {
        return Err(expected_message(input, what));
    }
    // A keyword to `syn` is no name, nor is one of edition 2024, in which generated code is written.
    let valid = input.peek(syn::Ident) && !comes_word(input, "gen");
    let ident = any_word(input).ok_or_else(|| expected_message(input, what))?;
    let text = match ident.to_string() {
        raw if raw.starts_with("r#") => format!("`{raw}` is a raw identifier; choose a plain name"),
        text if text == "_" => format!("expected {what}, found `_`; give it a name"),
        text if !valid => format!("`{text}` is a keyword of Rust; choose another name"),
        _ => return Ok(ident),
    };
    Err(Message::new(Place::at(ident.span()), text))
}

/// Nothing may be left before the closing bracket.
pub(super) fn end(input: ParseStream, closing: &str) -> Read<()> {
    if input.is_empty() { Ok(()) } else { Err(expected_message(input, &format!("`{closing}`"))) }
}

/// Reads what stands in `( )`.
pub(super) fn in_parens<T>(
    input: ParseStream,
    what: &str,
    read: impl FnOnce(ParseStream) -> Read<T>,
) -> Read<(T, Place)> {
    let Ok((paren, content)) = open_parens(input) else {
        return Err(expected_message(input, what));
    };
    let value = read(&content)?;
    end(&content, ")")?;
    Ok((value, Place { start: paren.span.open(), end: paren.span.close() }))
}

/// Reads what stands in `[ ]`.
pub(super) fn in_brackets<T>(
    input: ParseStream,
    what: &str,
    read: impl FnOnce(ParseStream) -> Read<T>,
) -> Read<(T, Place)> {
    let Ok((bracket, content)) = open_brackets(input) else {
        return Err(expected_message(input, what));
    };
    let value = read(&content)?;
    end(&content, "]")?;
    Ok((value, Place { start: bracket.span.open(), end: bracket.span.close() }))
}

/// Reads everything that stands in `{ }`, one item after the other. An item takes at least one token.
pub(super) fn in_braces<T>(
    input: ParseStream,
    what: &str,
    item: impl Fn(ParseStream) -> T,
) -> Read<Vec<T>> {
    let Ok((_, content)) = open_braces(input) else {
        return Err(expected_message(input, what));
    };
    let mut items = Vec::new();
    while !content.is_empty() {
        items.push(item(&content));
    }
    Ok(items)
}

fn open_parens<'a>(input: &ParseBuffer<'a>) -> syn::Result<(Paren, ParseBuffer<'a>)> {
    let content;
    let paren = parenthesized!(content in input);
    Ok((paren, content))
}

fn open_brackets<'a>(input: &ParseBuffer<'a>) -> syn::Result<(Bracket, ParseBuffer<'a>)> {
    let content;
    let bracket = bracketed!(content in input);
    Ok((bracket, content))
}

/// Enters a pair of braces.
pub(super) fn open_braces<'a>(input: &ParseBuffer<'a>) -> syn::Result<(Brace, ParseBuffer<'a>)> {
    let content;
    let brace = braced!(content in input);
    Ok((brace, content))
}
