//! The list of statements, and what each begins with.

use super::beginning::{ITEMS, NOT_YET, STATEMENTS, at_beginning};
use super::expression::expression;
use super::header::{self, Line};
use super::recover::{
    broken_statement, doubled, leave_behind, or_skip, read_declared, skip, to_semicolon,
};
use super::tokens::{
    any_word, comes, comes_word, expected_message, message_of, symbol, take, take_tree,
};
use super::{action, expect, foreign, item, joint, method, part, setting};
use crate::syntax::ast::{Broken, Constant, EFFECTS, Ground, Link, Read, Statement, Text};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Ident, Span};
use syn::Attribute;
use syn::parse::ParseStream;
use syn::token::Brace;

/// Reads everything.
pub(super) fn text(input: ParseStream) -> Text {
    let mut text = Text::default();
    let mut headed = false;
    let mut first = true;
    let mut beginning = input.span();
    // What is said before the second statement of a `struct` line that is missing or misspelt.
    let mut of_header = 0..0;
    while !input.is_empty() {
        let begin = input.span();
        let attributes = match attributes(input) {
            Ok(attributes) => attributes,
            Err(error) => {
                text.statements.push(broken_statement(error));
                continue;
            }
        };
        if header::comes(input) {
            let Line { header, error } = header::line(input, attributes);
            let misplaced =
                out_of_place(header.as_ref().map(|(header, _)| &header.name), first, headed);
            text.statements.extend(misplaced.map(broken_statement));
            text.statements.extend(error.map(broken_statement));
            text.header = text.header.or(header);
            headed = true;
        } else {
            let is_documented = comes_word(input, "part");
            let stray = stray(&attributes, is_documented);
            if first {
                beginning = input.span();
                let said = usize::from(stray.is_some()) + usize::from(header::seems(input));
                of_header = text.statements.len()..text.statements.len() + said;
            }
            text.statements.extend(stray.map(broken_statement));
            if !input.is_empty() {
                text.motors += usize::from(comes_word(input, "motor"));
                text.asked.laws |= setting::law_comes(input) || comes_word(input, "path");
                text.asked.follow |= comes_word(input, "follow");
                text.beginnings.push((text.statements.len(), begin));
                text.statements.push(statement(input));
            }
        }
        first = false;
    }
    if !headed {
        text.statements.drain(of_header);
        text.statements.insert(0, broken_statement(headless(beginning)));
        text.beginnings.clear();
    }
    text
}

fn headless(beginning: Span) -> Message {
    let text = "expected `struct Name;` first; it names the type that the mechanism becomes";
    Message::new(Place::at(beginning), text)
}

/// A `struct` line that stands where it should not.
fn out_of_place(name: Option<&Ident>, first: bool, headed: bool) -> Option<Message> {
    let place = Place::at(name?.span());
    if headed {
        Some(Message::new(place, "a mechanism has one `struct` line; remove this one"))
    } else if first {
        None
    } else {
        Some(Message::new(
            place,
            "the `struct` line stands before everything else; move it to the top",
        ))
    }
}

fn attributes(input: ParseStream) -> Read<Vec<Attribute>> {
    or_skip(input, &STATEMENTS, |input| {
        foreign::comment(input).map_or(Ok(()), Err)?;
        Attribute::parse_outer(input).map_err(|error| message_of(&error))
    })
}

/// Attributes and doc comments that stand before something else than the `struct` line; a part may have doc comments.
fn stray(attributes: &[Attribute], is_documented: bool) -> Option<Message> {
    let is_stray = |attribute: &&Attribute| !(is_documented && attribute.path().is_ident("doc"));
    let attribute = attributes.iter().find(is_stray)?;
    let text =
        "only the `struct` line takes attributes and doc comments; write this as a `//` comment";
    Some(Message::new(Place::of(attribute), text))
}

/// Reads a statement; takes at least one token.
pub(super) fn statement(input: ParseStream) -> Statement {
    let Some(keyword) = any_word(input) else {
        let otherwise = expected_message(input, "a statement");
        // Braces without a word are those of the ground, as no name is missing.
        let ground = Ident::new("ground", input.span());
        let names = input.peek(Brace).then_some(ground).into_iter().collect();
        // One token at least, or a stray keyword after it would be waited for forever.
        if take(input, ";").is_none() {
            take_tree(input);
            skip(input, &STATEMENTS);
        }
        return Statement::Broken(Broken { error: otherwise, names });
    };
    if let Some(error) = doubled(input, &keyword) {
        return broken_statement(error);
    }
    // It is not read, but its name is kept: it is not unknown where it is used.
    let left_behind = |error| {
        let mut broken = leave_behind(input, &STATEMENTS, &keyword, error);
        if spelling::nearest(&keyword.to_string(), &STATEMENTS) == Some("ground") {
            broken.names = vec![Ident::new("ground", keyword.span())];
        }
        Statement::Broken(broken)
    };
    match keyword.to_string().as_str() {
        "const" => constant(input, "the name of a constant", Statement::Constant),
        "param" => constant(input, "the name of a param", Statement::Param),
        "ground" => ground(input, keyword.span()),
        "link" => link(input),
        "joint" => joint::joint(input),
        "motor" => setting::motor(input),
        "start" => setting::start(input, keyword.span()),
        "method" => method::method(input, keyword.span()),
        "accuracy" => method::accuracy(input, keyword.span()),
        "cost" => method::cost(input, keyword.span()),
        "at" => method::change_points(input, keyword.span()),
        "effects" => setting::effects(input, keyword.span()),
        "show" => setting::show(input, keyword.span()),
        "continuous" => setting::continuous(input, keyword.span()),
        "quality" => setting::quality(input, keyword.span()),
        "look" => setting::look(input, keyword.span()),
        "gravity" => action::gravity(input, keyword.span()),
        "spring" => action::spring(input),
        "damper" => action::damper(input),
        "load" => action::load(input),
        "follow" => setting::follow(input, keyword.span()),
        "path" => setting::trajectory(input, keyword.span()),
        "expect" => expect::expect(input, keyword.span()),
        "allow" => setting::allow(input),
        "part" => part::part(input, statement),
        "port" => part::port(input),
        "use" if part::is_of_rust(input) => {
            Statement::Broken(part::rust_path(input, unknown_statement(&keyword)))
        }
        "use" => part::used(input),
        NOT_YET => left_behind(not_yet(&keyword)),
        word if EFFECTS.contains(&word) => {
            broken_statement(setting::stray_effects(input, &keyword))
        }
        _ if joint::body_comes(input) => joint::without_keyword(input, keyword),
        _ if take(input, "::").is_some() => {
            Statement::Broken(part::rust_path(input, unknown_statement(&keyword)))
        }
        _ => left_behind(unknown_statement(&keyword)),
    }
}

fn not_yet(keyword: &Ident) -> Message {
    Message::new(Place::at(keyword.span()), format!("`{keyword}` is not supported yet"))
}

fn unknown_statement(keyword: &Ident) -> Message {
    let text = keyword.to_string();
    if let Some(trouble) = as_statement(&text) {
        return Message::new(Place::at(keyword.span()), trouble);
    }
    let remedy = if let Some(near) = spelling::nearest(&text, &STATEMENTS) {
        format!("did you mean `{near}`?")
    } else {
        let supported = STATEMENTS.into_iter().filter(|&word| word != NOT_YET);
        let supported: Vec<&str> = supported.collect();
        format!("a statement begins with one of {}", spelling::list(&supported))
    };
    Message::new(Place::at(keyword.span()), format!("unknown statement `{text}`; {remedy}"))
}

/// Reads `NAME = value;`.
fn constant(input: ParseStream, what: &str, kind: fn(Constant) -> Statement) -> Statement {
    read_declared(input, what, |input, name| {
        let value = to_semicolon(input, &STATEMENTS, |input| {
            refuse_type(input)?;
            symbol(input, "=")?;
            expression(input)
        });
        kind(Constant { name, value })
    })
}

/// Complains about a type.
fn refuse_type(input: ParseStream) -> Read<()> {
    let Some(colon) = take(input, ":") else {
        return Ok(());
    };
    let written = any_word(input);
    let (place, text) = match &written {
        Some(word) => (colon.to(Place::at(word.span())), format!(": {word}")),
        None => (colon, ":".to_owned()),
    };
    Err(Message::new(place, format!("numbers have no type here; leave `{text}` out")))
}

/// Complains about a comma after a link: it stands for `;`, or between several links.
fn after_comma(input: ParseStream, first: Ident) -> Statement {
    let instead = expected_message(input, "`;`");
    let mut names = vec![first];
    while take(input, ",").is_some() && !at_beginning(input, &STATEMENTS) {
        names.extend(any_word(input));
    }
    skip(input, &STATEMENTS);
    let error = match &names[..] {
        [_] => instead,
        _ => several_links(&names),
    };
    Statement::Broken(Broken { error, names })
}

/// The message about several links in one statement.
fn several_links(names: &[Ident]) -> Message {
    let place = Place::at(names[0].span()).to(Place::at(names[names.len() - 1].span()));
    let statements: Vec<String> = names.iter().map(|name| format!("link {name};")).collect();
    let text = format!("each link has its own statement; write `{}`", statements.join(" "));
    Message::new(place, text)
}

fn ground(input: ParseStream, keyword: Span) -> Statement {
    let items = or_skip(input, &STATEMENTS, item::items);
    Statement::Ground(Ground { keyword, items })
}

fn link(input: ParseStream) -> Statement {
    let begin = input.cursor();
    read_declared(input, "the name of a link", |input, name| {
        if comes(input, ",") {
            return after_comma(input, name);
        }
        let items = or_skip(input, &STATEMENTS, |input| item::body(input, begin));
        Statement::Link(Link { name, items })
    })
}

/// Words of Rust that declare a value.
const VALUES: [&str; 3] = ["let", "var", "static"];
/// Words of Rust that declare something else.
const OF_RUST: [&str; 8] = ["fn", "use", "mod", "impl", "trait", "enum", "type", "macro_rules"];

/// Returns the help for a word that begins no statement, but something else.
fn as_statement(word: &str) -> Option<String> {
    if VALUES.contains(&word) {
        Some(format!("numbers are declared by `const`; write `const` for `{word}`"))
    } else if OF_RUST.contains(&word) {
        Some(format!("`{word}` belongs to Rust; write it outside of `mechanism!`"))
    } else if ITEMS.contains(&word) {
        Some(format!(
            "`{word}` is fixed to a link; write it in the braces of `ground` or of a `link`"
        ))
    } else {
        None
    }
}
