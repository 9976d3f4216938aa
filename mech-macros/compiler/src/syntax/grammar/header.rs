//! The `struct` line.

use super::beginning::STATEMENTS;
use super::ending::{missing_after, semicolon};
use super::recover::skip;
use super::tokens::{any_word, expected_message, message_of, name, take};
use crate::model::Precision;
use crate::syntax::ast::Read;
use crate::syntax::{Header, Message, Place, spelling};
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Attribute, Token, Visibility};

/// As much of a `struct` line as could be read, and what is wrong with it.
pub(super) struct Line {
    pub header: Option<(Header, Precision)>,
    pub error: Option<Message>,
}

/// Whether a `struct` line comes next, its attributes apart.
pub(super) fn comes(input: ParseStream) -> bool {
    let invisible = input.peek(syn::token::Group) && input.peek2(Token![struct]);
    invisible || input.peek(Token![pub]) || input.peek(Token![struct])
}

/// Whether a `struct` line seems to come whose keyword is misspelt or left out.
pub(super) fn seems(input: ParseStream) -> bool {
    let Some((word, rest)) = input.cursor().ident() else {
        return false;
    };
    let (text, words) = (word.to_string(), [&STATEMENTS[..], &["struct"]].concat());
    let rest = match rest.ident() {
        Some((_, rest)) if spelling::nearest(&text, &words) == Some("struct") => rest,
        // The names of types have a great letter.
        None if text.starts_with(char::is_uppercase) => rest,
        _ => return false,
    };
    rest.punct().is_some_and(|(mark, _)| ";:".contains(mark.as_char()))
}

/// Reads a `struct` line from its visibility on.
pub(super) fn line(input: ParseStream, mut attributes: Vec<Attribute>) -> Line {
    let twice = attributes.iter().find_map(derived_anyway);
    attributes.retain(|attribute| derived_anyway(attribute).is_none());
    let begin = input.cursor();
    let header = beginning(input, attributes);
    let (mut header, error) = match header {
        Ok(header) => (Some((header, Precision::default())), None),
        Err(error) => (None, Some(error)),
    };
    let error = error.or_else(|| match ending(input, begin) {
        Ok(given) => {
            if let Some((_, precision)) = &mut header {
                *precision = given;
            }
            None
        }
        Err(error) => Some(error),
    });
    if error.is_some() {
        skip(input, &STATEMENTS);
    }
    Line { header, error: error.or(twice) }
}

/// `pub struct Name`
fn beginning(input: ParseStream, attributes: Vec<Attribute>) -> Read<Header> {
    let visibility: Visibility = input.parse().map_err(|error| message_of(&error))?;
    if !input.peek(Token![struct]) {
        return Err(expected_message(input, "`struct`"));
    }
    any_word(input);
    let name = name(input, "the name of the struct")?;
    Ok(Header { attributes, visibility, name })
}

/// A `derive` of what every mechanism is already.
fn derived_anyway(attribute: &Attribute) -> Option<Message> {
    const DERIVED: [&str; 5] = ["Clone", "Copy", "Debug", "Default", "PartialEq"];
    if !attribute.path().is_ident("derive") {
        return None;
    }
    let list = attribute.meta.require_list().ok()?;
    let twice = list
        .tokens
        .clone()
        .into_iter()
        .find(|token| DERIVED.contains(&token.to_string().as_str()))?;
    let text = format!("every mechanism is `{twice}` already; leave it out");
    Some(Message::new(Place::at(twice.span()), text))
}

/// `: f64;`
fn ending(input: ParseStream, begin: Cursor) -> Read<Precision> {
    let precision = match take(input, ":") {
        Some(_) => scalar(input)?,
        None if input.peek(Token![;]) => Precision::default(),
        None => {
            let missing = "`;`, or `: f64` or `: f32`";
            let forgotten = missing_after(input, begin, &STATEMENTS, "`;`");
            return Err(forgotten.unwrap_or_else(|| expected_message(input, missing)));
        }
    };
    semicolon(input, begin, &STATEMENTS)?;
    Ok(precision)
}

fn scalar(input: ParseStream) -> Read<Precision> {
    let otherwise = expected_message(input, "`f64` or `f32`");
    let ident = any_word(input).ok_or(otherwise)?;
    match ident.to_string().as_str() {
        "f64" => Ok(Precision::F64),
        "f32" => Ok(Precision::F32),
        other => {
            let text = format!("a mechanism cannot be computed in `{other}`; write `f64` or `f32`");
            Err(Message::new(Place::at(ident.span()), text))
        }
    }
}
