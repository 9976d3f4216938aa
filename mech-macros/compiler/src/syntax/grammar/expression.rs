//! Numbers that are computed: `2 * sin(30 deg) - THROW`.

use super::tokens::{
    advance, any_word, comes, expected_message, in_parens, name, run, symbol, take, take_tree,
    take_word,
};
use super::{foreign, unit};
use crate::model::{BinaryFunction, Function, function_names};
use crate::syntax::ast::{Direction, Expr, ExprKind, Pair, Read};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use syn::parse::ParseStream;
use syn::{Lit, Token, token};

/// The greatest depth of nested brackets: enough for anybody, and the stack holds it.
const DEPTH: usize = 64;

/// Reads a number that begins with a name, if it is measured; else nothing is taken. The second reads a number inside of it.
pub(super) type Measuring =
    fn(ParseStream, &dyn Fn(ParseStream) -> Read<Expr>) -> Read<Option<Expr>>;

/// How a number is read at some depth.
#[derive(Clone, Copy)]
struct Nesting {
    /// How much deeper brackets may be.
    left: usize,
    /// The numbers that may be measured.
    measuring: Option<Measuring>,
}

/// A function of one number or of two.
#[derive(Clone, Copy)]
enum Callee {
    One(Function),
    Both(BinaryFunction),
}

impl Callee {
    /// The function of this name.
    fn named(name: &Ident) -> Option<Self> {
        let one = Function::ALL.into_iter();
        let both = BinaryFunction::ALL.into_iter();
        let one = one.filter(|function| name == function.name());
        let both = both.filter(|function| name == function.name());
        one.map(Self::One).chain(both.map(Self::Both)).next()
    }
}

/// Reads a number.
pub(super) fn expression(input: ParseStream) -> Read<Expr> {
    let nesting = Nesting { left: DEPTH, measuring: None };
    sum(input, nesting)
}

/// Reads a number in which some may be measured.
pub(super) fn measured(input: ParseStream, measuring: Measuring) -> Read<Expr> {
    let nesting = Nesting { left: DEPTH, measuring: Some(measuring) };
    sum(input, nesting)
}

/// Reads `(x, y)`.
pub(super) fn pair(input: ParseStream) -> Read<Pair> {
    let ((x, y), place) = in_parens(input, "`(x, y)`", |input| {
        let x = expression(input)?;
        symbol(input, ",")?;
        let y = expression(input)?;
        take(input, ",");
        Ok((x, y))
    })?;
    Ok(Pair { x, y, place })
}

/// Reads a number after the word that says what it is.
pub(super) fn read_labelled(input: ParseStream, label: &str) -> Read<Expr> {
    if take_word(input, label).is_some() {
        return expression(input);
    }
    let mut error = expected_message(input, &format!("`{label}`"));
    if input.cursor().literal().is_some()
        && let Ok(number) = expression(input)
    {
        error.place = number.place;
        error.text = format!("expected `{label}` before this number; write `{label} {number}`");
    }
    Err(error)
}

/// Reads `(dx, dy)` or `30 deg`.
pub(super) fn direction(input: ParseStream) -> Read<Direction> {
    if input.peek(token::Paren) && !is_angle_in_parens(input) {
        return pair(input).map(Direction::Parts);
    }
    let begins = input.cursor();
    match expression(input) {
        Ok(angle) => Ok(Direction::Angle(angle)),
        Err(_) if input.cursor() == begins => {
            Err(expected_message(input, "`(dx, dy)`, or an angle such as `30 deg`"))
        }
        Err(error) => Err(error),
    }
}

/// Whether what stands in parentheses is one number with something after it, as in `(90 + 15) deg`.
fn is_angle_in_parens(input: ParseStream) -> bool {
    let Some((inner, _, rest)) = input.cursor().group(Delimiter::Parenthesis) else {
        return false;
    };
    let is = |token: &TokenTree, mark: char| matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark);
    let has_comma = inner.token_stream().into_iter().any(|token| is(&token, ','));
    let goes_on = rest.token_tree().is_some_and(|(next, _)| {
        let is_unit = matches!(&next, TokenTree::Ident(word) if word == "deg");
        is_unit || ['+', '-', '*', '/'].iter().any(|&mark| is(&next, mark))
    });
    !has_comma && goes_on
}

fn sum(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let mut terms = vec![(false, product(input, nesting)?)];
    while let Some(minus) = operator(input, "+", "-") {
        terms.push((minus, product(input, nesting)?));
    }
    Ok(chain(terms, ExprKind::Sum))
}

fn product(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let mut factors = vec![(false, read_signed(input, nesting)?)];
    while let Some(over) = operator(input, "*", "/") {
        factors.push((over, read_signed(input, nesting)?));
    }
    let product = chain(factors, ExprKind::Product);
    if take(input, "%").is_some() {
        return Err(foreign::remainder(&product, &with_unit(input, nesting)?));
    }
    Ok(product)
}

/// Takes one of two operators: whether it was the second. The arrow before a direction is none.
fn operator(input: ParseStream, first: &str, second: &str) -> Option<bool> {
    if comes(input, "->") {
        return None;
    }
    let first = take(input, first).map(|_| false);
    first.or_else(|| take(input, second).map(|_| true))
}

/// A chain of one is that one.
fn chain(mut parts: Vec<(bool, Expr)>, kind: fn(Vec<(bool, Expr)>) -> ExprKind) -> Expr {
    let places = parts.first().zip(parts.last());
    let place = places.map(|((_, first), (_, last))| first.place.to(last.place));
    match (parts.len(), place) {
        (2.., Some(place)) => Expr { kind: kind(parts), place },
        _ => parts.remove(0).1,
    }
}

/// A number with any minus signs before it: they bind less than `deg` after it.
fn read_signed(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let mut signs = Vec::new();
    while let Some(place) = take(input, "-") {
        signs.push(place);
    }
    let number = with_unit(input, nesting)?;
    without_power(input, &number, nesting)?;
    let Some(first) = signs.first() else {
        return Ok(number);
    };
    let place = first.to(number.place);
    // Two signs cancel, so a long row of them is no deeper than one.
    let kind =
        if signs.len() % 2 == 1 { ExprKind::Negative(Box::new(number)) } else { number.kind };
    Ok(Expr { kind, place })
}

/// Complains about a power of this number.
fn without_power(input: ParseStream, number: &Expr, nesting: Nesting) -> Read<()> {
    let mut operators = ["^", "**"].into_iter();
    let Some(operator) = operators.find(|operator| comes(input, operator)) else {
        return Ok(());
    };
    take(input, operator);
    Err(foreign::power(operator, number, &with_unit(input, nesting)?))
}

fn with_unit(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let number = primary(input, nesting)?;
    let number = match take_word(input, "deg") {
        Some(unit) if matches!(number.kind, ExprKind::Degrees(_)) => {
            let text = "this number is in degrees already; leave one `deg` out";
            return Err(Message::new(Place::at(unit), text));
        }
        Some(unit) => with(ExprKind::Degrees, number, unit),
        None => number,
    };
    let number = match take_word(input, unit::SPEED) {
        Some(unit) => with(ExprKind::Rpm, number, unit),
        None => number,
    };
    match unit::take_foreign(input) {
        Some(unit) => {
            let place = number.place.to(Place::at(unit.span()));
            Err(unit::trouble(&number, &unit.to_string(), place))
        }
        None => Ok(number),
    }
}

/// A number in a unit.
fn with(kind: fn(Box<Expr>) -> ExprKind, number: Expr, unit: Span) -> Expr {
    let place = Place { start: number.place.start, end: unit };
    Expr { kind: kind(Box::new(number)), place }
}

fn primary(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let Some(left) = nesting.left.checked_sub(1) else {
        let text = "too many brackets in one another; give a part of it a name with `const`";
        return Err(Message::new(Place::at(input.span()), text));
    };
    let nesting = Nesting { left, ..nesting };
    if let Some(tokens) = take_invisible(input) {
        return read_interpolated(tokens, nesting);
    }
    if input.peek(token::Paren) {
        let (inner, place) = in_parens(input, "a number", |input| sum(input, nesting))?;
        return Ok(Expr { kind: inner.kind, place });
    }
    if let Some((literal, _)) = input.cursor().literal() {
        return number(input, literal);
    }
    if let Some(measuring) = nesting.measuring
        && let Some(measured) = measuring(input, &|input| sum(input, nesting))?
    {
        return Ok(measured);
    }
    if input.peek(syn::Ident) {
        return named(input, nesting);
    }
    // A function of ours that is a keyword of Rust.
    if input.peek(Token![mod])
        && input.peek2(token::Paren)
        && let Some(ident) = any_word(input)
    {
        return call(input, &ident, nesting);
    }
    Err(expected_message(input, "a number"))
}

/// Takes the tokens of a `macro_rules!` variable such as `$x:expr`: they come in invisible brackets.
fn take_invisible(input: ParseStream) -> Option<TokenStream> {
    advance(input, |cursor| {
        let (inner, _, rest) = cursor.group(Delimiter::None)?;
        Some((inner.token_stream(), rest))
    })
}

fn read_interpolated(tokens: TokenStream, nesting: Nesting) -> Read<Expr> {
    let place = Place::of(&tokens);
    let inner = run(tokens, |input| {
        let inner = sum(input, nesting)?;
        if input.is_empty() { Ok(inner) } else { Err(expected_message(input, "an operator")) }
    });
    inner.unwrap_or_else(|| Err(Message::new(place, "expected a number")))
}

/// Takes a literal if it is a number.
fn number(input: ParseStream, literal: Literal) -> Read<Expr> {
    let place = Place::at(literal.span());
    let literal = Lit::new(literal);
    let (kind, suffix) = match &literal {
        Lit::Int(number) => (ExprKind::Integer(number.base10_digits().to_owned()), number.suffix()),
        Lit::Float(number) => {
            (ExprKind::Decimal(number.base10_digits().to_owned()), number.suffix())
        }
        _ => return Err(expected_message(input, "a number")),
    };
    take_tree(input);
    let number = Expr { kind, place };
    match suffix {
        "" => Ok(number),
        "deg" => Ok(with(ExprKind::Degrees, number, place.end)),
        unit::SPEED => Ok(with(ExprKind::Rpm, number, place.end)),
        unit => Err(unit::trouble(&number, unit, place)),
    }
}

fn named(input: ParseStream, nesting: Nesting) -> Read<Expr> {
    let ident = name(input, "a number")?;
    if input.peek(token::Paren) {
        return call(input, &ident, nesting);
    }
    without_path(input, &ident)?;
    let place = Place::at(ident.span());
    let kind = if ident == "PI" { ExprKind::Pi } else { ExprKind::Constant(ident) };
    Ok(Expr { kind, place })
}

/// Complains about a path of Rust.
fn without_path(input: ParseStream, first: &Ident) -> Read<()> {
    let (mut last, mut end) = (first.clone(), None);
    while take(input, "::").is_some() {
        last = name(input, "a name")?;
        end = Some(last.span());
    }
    let Some(end) = end else {
        return Ok(());
    };
    let text = if last == "PI" {
        "paths of Rust cannot be seen here; write `PI`".to_owned()
    } else if last == "TAU" {
        "paths of Rust cannot be seen here; write `(2 * PI)`".to_owned()
    } else {
        format!(
            "paths of Rust cannot be seen here; declare `const {last} = ...;` in the mechanism and write `{last}`"
        )
    };
    Err(Message::new(Place::at(first.span()).to(Place::at(end)), text))
}

fn call(input: ParseStream, ident: &Ident, nesting: Nesting) -> Read<Expr> {
    let Some(called) = Callee::named(ident) else {
        return Err(unknown_function(input, ident, nesting));
    };
    let (kind, place) = in_parens(input, "`(`", |input| {
        let first = sum(input, nesting)?;
        Ok(match called {
            Callee::One(function) => ExprKind::Call(function, Box::new(first)),
            Callee::Both(function) => {
                symbol(input, ",")?;
                let second = sum(input, nesting)?;
                take(input, ",");
                ExprKind::CallBoth(function, Box::new([first, second]))
            }
        })
    })?;
    let place = Place { start: ident.span(), end: place.end };
    Ok(Expr { kind, place })
}

/// The message about a call of a function that there is not.
fn unknown_function(input: ParseStream, ident: &Ident, nesting: Nesting) -> Message {
    let name = ident.to_string();
    let place = Place::at(ident.span());
    if foreign::is_function(&name)
        && let Ok((arguments, brackets)) =
            in_parens(input, "`(`", |input| arguments(input, nesting))
        && let Some(written) = foreign::call(&name, &arguments)
    {
        let text = format!("there is no `{name}`; write `{written}`");
        return Message::new(place.to(brackets), text);
    }
    let names: Vec<&str> = function_names().collect();
    // A name from another language is no misspelling of one of ours.
    let text = match spelling::nearest(&name, &names) {
        Some(meant) if !foreign::is_function(&name) => {
            format!("unknown function `{name}`; did you mean `{meant}`?")
        }
        _ => format!("unknown function `{name}`; there are {}", spelling::list_all(&names)),
    };
    Message::new(place, text)
}

/// Numbers with commas between them.
fn arguments(input: ParseStream, nesting: Nesting) -> Read<Vec<Expr>> {
    let mut arguments = Vec::new();
    while !input.is_empty() {
        arguments.push(sum(input, nesting)?);
        if take(input, ",").is_none() {
            break;
        }
    }
    Ok(arguments)
}

/// Takes a word that stands for one of several things.
pub(super) fn one_of<T: Copy>(
    input: ParseStream,
    what: &str,
    words: &[(&str, T)],
) -> Read<(Ident, T)> {
    let Some(ident) = any_word(input) else {
        return Err(expected_message(input, what));
    };
    if let Some((_, meaning)) = words.iter().find(|(word, _)| ident == word) {
        return Ok((ident, *meaning));
    }
    let words: Vec<_> = words.iter().map(|(word, _)| *word).collect();
    let remedy = spelling::remedy(&ident.to_string(), &words);
    Err(Message::new(Place::at(ident.span()), format!("expected {what}, found `{ident}`{remedy}")))
}
