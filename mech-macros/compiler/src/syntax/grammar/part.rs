//! Parts, their ports and their uses.

use super::beginning::STATEMENTS;
use super::expression::{expression, pair};
use super::item::body;
use super::path::path;
use super::recover::{or_skip, read_declared, skip, to_semicolon};
use super::tokens::{
    any_word, comes, end, expected_message, in_braces, in_brackets, in_parens, name, open_braces,
    symbol, take, take_word,
};
use crate::syntax::ast::{Broken, Constant, Part, Port, PortBinding, Read, Statement, Use};
use crate::syntax::{Message, Place};
use proc_macro2::{Ident, Spacing};
use syn::parse::ParseStream;
use syn::token;

/// Reads `Leg(size = 1) { ... }`, by what reads a statement.
pub(super) fn part(input: ParseStream, statement: fn(ParseStream) -> Statement) -> Statement {
    read_declared(input, "the name of a part", |input, name| {
        let mut parameters = Vec::new();
        let body = or_skip(input, &STATEMENTS, |input| {
            parameters = numbers(input)?;
            in_braces(input, "`{`", statement)
        });
        Statement::Part(Box::new(Part { name, parameters, body }))
    })
}

/// Reads `frame { ... }` or `frame;`.
pub(super) fn port(input: ParseStream) -> Statement {
    let begin = input.cursor();
    read_declared(input, "the name of a port", |input, name| {
        let items = or_skip(input, &STATEMENTS, |input| body(input, begin));
        Statement::Port(Port { name, items })
    })
}

/// Whether a path of Rust follows the word `use`.
pub(super) fn is_of_rust(input: ParseStream) -> bool {
    let name = input.cursor().ident();
    name.is_some_and(|(_, rest)| {
        let next = rest.punct();
        next.is_some_and(|(mark, _)| mark.as_char() == ':' && mark.spacing() == Spacing::Joint)
    })
}

/// Leaves behind a path of Rust, which may be meant for a use: what it declares is not unknown.
pub(super) fn rust_path(input: ParseStream, outside: Message) -> Broken {
    let (mut names, mut colons) = (Vec::new(), None);
    while let Some(name) = any_word(input) {
        names.push(name);
        let next = take(input, "::");
        colons = colons.or(next);
    }
    let is_use = input.peek(token::Brace) || input.peek(token::Paren);
    let error = match colons {
        Some(colons) if is_use => Message::new(colons, "expected `:`, found `::`"),
        _ if input.is_empty() || comes(input, ";") => outside,
        _ => expected_message(input, "`;`"),
    };
    skip(input, &STATEMENTS);
    let declared = if is_use { names.first() } else { names.last() };
    let names = declared.cloned().into_iter().collect();
    Broken { error, names }
}

/// Reads `left[6]: Leg(size = 2) mirrored scaled 2 { frame = ground };`.
pub(super) fn used(input: ParseStream) -> Statement {
    read_declared(input, "the name of what is used", |input, name| {
        let unread = name.clone();
        match to_semicolon(input, &STATEMENTS, |input| instances(input, name)) {
            Ok(used) => Statement::Use(Box::new(used)),
            Err(error) => Statement::Broken(Broken { error, names: vec![unread] }),
        }
    })
}

fn instances(input: ParseStream, instance: Ident) -> Read<Use> {
    let count = if input.peek(token::Bracket) {
        Some(in_brackets(input, "`[`", expression)?)
    } else {
        None
    };
    symbol(input, ":")?;
    let part = name(input, "the name of a part")?;
    let arguments = numbers(input)?;
    let mirrored = take_word(input, "mirrored");
    let scaled = take_word(input, "scaled").map(|_| expression(input)).transpose()?;
    let mirrored = mirrored.or_else(|| take_word(input, "mirrored"));
    let ports = if input.peek(token::Brace) {
        ports(input)?
    } else {
        return Err(expected_message(
            input,
            "`{` and the links that are lent, as `{ frame = ground }`",
        ));
    };
    Ok(Use { name: instance, count, part, arguments, mirrored, scaled, ports })
}

/// Reads `(size = 1, phase = 30 deg)`, or nothing.
fn numbers(input: ParseStream) -> Read<Vec<Constant>> {
    if !input.peek(token::Paren) {
        return Ok(Vec::new());
    }
    let (numbers, _) = in_parens(input, "`(`", |input| {
        list(input, |input| {
            let name = name(input, "the name of a number")?;
            let value = if input.is_empty() || comes(input, ",") {
                let text = format!("each number of a part has a value; write `{name} = 1`");
                Err(Message::new(Place::at(name.span()), text))
            } else {
                symbol(input, "=")?;
                Ok(expression(input)?)
            };
            Ok(Constant { name, value })
        })
    })?;
    Ok(numbers)
}

/// Reads `{ frame = ground, crank = axle at (1, 0) turned 30 deg }`.
fn ports(input: ParseStream) -> Read<Vec<PortBinding>> {
    let (_, content) = open_braces(input).map_err(|_| expected_message(input, "`{`"))?;
    let ports = list(&content, |input| {
        let port = name(input, "the name of a port")?;
        symbol(input, "=")?;
        let link = path(input, "the name of a link")?;
        let at = take_word(input, "at").map(|_| pair(input)).transpose()?;
        let turned = take_word(input, "turned").map(|_| expression(input)).transpose()?;
        Ok(PortBinding { port, link, at, turned })
    })?;
    end(&content, "}")?;
    Ok(ports)
}

/// Reads some of a kind with commas between them, to the end of the brackets.
fn list<T>(input: ParseStream, one: impl Fn(ParseStream) -> Read<T>) -> Read<Vec<T>> {
    let mut all = Vec::new();
    while !input.is_empty() {
        all.push(one(input)?);
        if take(input, ",").is_none() {
            if comes(input, ";") {
                return Err(expected_message(input, "`,` or the closing bracket"));
            }
            break;
        }
    }
    Ok(all)
}
