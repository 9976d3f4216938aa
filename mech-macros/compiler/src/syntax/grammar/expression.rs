//! Numbers that are computed: `2 * sin(30 deg) - THROW`.

use super::tokens::{
    advance, any_word, comes, in_parens, name, run, symbol, take, take_word, unexpected,
};
use crate::model::{Extreme, Function};
use crate::syntax::ast::{Expr, ExprKind, Pair, Read};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Delimiter, Ident, Span, TokenStream};
use syn::parse::ParseStream;
use syn::{Lit, token};

/// How many brackets may stand in one another: enough for anybody, and the stack holds it.
const DEPTH: usize = 64;

/// What a function takes.
#[derive(Clone, Copy)]
enum Called {
    One(Function),
    Two(Extreme),
}

const FUNCTIONS: [(&str, Called); 9] = [
    ("sqrt", Called::One(Function::Sqrt)),
    ("sin", Called::One(Function::Sin)),
    ("cos", Called::One(Function::Cos)),
    ("tan", Called::One(Function::Tan)),
    ("atan", Called::One(Function::Atan)),
    ("exp", Called::One(Function::Exp)),
    ("abs", Called::One(Function::Abs)),
    ("min", Called::Two(Extreme::Least)),
    ("max", Called::Two(Extreme::Greatest)),
];

/// Reads a number.
pub(super) fn expression(input: ParseStream) -> Read<Expr> {
    sum(input, DEPTH)
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

fn sum(input: ParseStream, depth: usize) -> Read<Expr> {
    let mut terms = vec![(false, product(input, depth)?)];
    while let Some(minus) = operator(input, "+", "-") {
        terms.push((minus, product(input, depth)?));
    }
    Ok(chain(terms, ExprKind::Sum))
}

fn product(input: ParseStream, depth: usize) -> Read<Expr> {
    let mut factors = vec![(false, signed(input, depth)?)];
    while let Some(over) = operator(input, "*", "/") {
        factors.push((over, signed(input, depth)?));
    }
    Ok(chain(factors, ExprKind::Product))
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
        (2.., Some(place)) => Expr {
            kind: kind(parts),
            place,
        },
        _ => parts.remove(0).1,
    }
}

/// A number with any minus signs before it: they bind less than `deg` after it.
fn signed(input: ParseStream, depth: usize) -> Read<Expr> {
    let mut signs = Vec::new();
    while let Some(place) = take(input, "-") {
        signs.push(place);
    }
    let number = with_unit(input, depth)?;
    let Some(first) = signs.first() else {
        return Ok(number);
    };
    let place = first.to(number.place);
    // Two signs cancel, so a long row of them is no deeper than one.
    let kind = if signs.len() % 2 == 1 {
        ExprKind::Negative(Box::new(number))
    } else {
        number.kind
    };
    Ok(Expr { kind, place })
}

fn with_unit(input: ParseStream, depth: usize) -> Read<Expr> {
    let number = primary(input, depth)?;
    let number = match take_word(input, "deg") {
        Some(unit) if matches!(number.kind, ExprKind::Degrees(_)) => {
            let text = "this number is in degrees already; leave one `deg` out";
            return Err(Message::new(Place::at(unit), text));
        }
        Some(unit) => in_degrees(number, unit),
        None => number,
    };
    Ok(number)
}

fn in_degrees(number: Expr, unit: Span) -> Expr {
    let place = Place {
        start: number.place.start,
        end: unit,
    };
    Expr {
        kind: ExprKind::Degrees(Box::new(number)),
        place,
    }
}

fn primary(input: ParseStream, depth: usize) -> Read<Expr> {
    let Some(depth) = depth.checked_sub(1) else {
        let text = "too many brackets in one another; give a part of it a name with `const`";
        return Err(Message::new(Place::at(input.span()), text));
    };
    if let Some(tokens) = take_invisible(input) {
        return interpolated(tokens, depth);
    }
    if input.peek(token::Paren) {
        let (inner, place) = in_parens(input, "a number", |input| sum(input, depth))?;
        return Ok(Expr {
            kind: inner.kind,
            place,
        });
    }
    if input.peek(Lit) && !input.peek(syn::LitBool) {
        return literal(input);
    }
    if input.peek(syn::Ident) {
        return named(input, depth);
    }
    Err(unexpected(input, "a number"))
}

/// What a `macro_rules!` variable such as `$x:expr` stands for comes in invisible brackets.
fn take_invisible(input: ParseStream) -> Option<TokenStream> {
    advance(input, |cursor| {
        let (inner, _, rest) = cursor.group(Delimiter::None)?;
        Some((inner.token_stream(), rest))
    })
}

fn interpolated(tokens: TokenStream, depth: usize) -> Read<Expr> {
    let place = Place::of(&tokens);
    let inner = run(tokens, |input| {
        let inner = sum(input, depth)?;
        if input.is_empty() {
            Ok(inner)
        } else {
            Err(unexpected(input, "an operator"))
        }
    });
    inner.unwrap_or_else(|| Err(Message::new(place, "expected a number")))
}

fn literal(input: ParseStream) -> Read<Expr> {
    let other = unexpected(input, "a number");
    let Ok(literal) = input.parse::<Lit>() else {
        return Err(other);
    };
    let place = Place::at(literal.span());
    let (kind, suffix) = match &literal {
        Lit::Int(number) => (
            ExprKind::Integer(number.base10_digits().to_owned()),
            number.suffix(),
        ),
        Lit::Float(number) => (
            ExprKind::Decimal(number.base10_digits().to_owned()),
            number.suffix(),
        ),
        _ => return Err(other),
    };
    let number = Expr { kind, place };
    match suffix {
        "" => Ok(number),
        "deg" => Ok(in_degrees(number, literal.span())),
        unit => {
            let text = format!(
                "unknown unit `{unit}`; lengths and angles in radians have none, degrees have `deg`"
            );
            Err(Message::new(place, text))
        }
    }
}

fn named(input: ParseStream, depth: usize) -> Read<Expr> {
    let ident = name(input, "a number")?;
    if input.peek(token::Paren) {
        return call(input, &ident, depth);
    }
    let place = Place::at(ident.span());
    let kind = if ident == "PI" {
        ExprKind::Pi
    } else {
        ExprKind::Constant(ident)
    };
    Ok(Expr { kind, place })
}

fn call(input: ParseStream, ident: &Ident, depth: usize) -> Read<Expr> {
    let function = FUNCTIONS.iter().find(|(name, _)| ident == name);
    let Some((_, called)) = function else {
        let names = FUNCTIONS.map(|(name, _)| name);
        let remedy = spelling::remedy(&ident.to_string(), &names);
        return Err(Message::new(
            Place::at(ident.span()),
            format!("unknown function `{ident}`{remedy}"),
        ));
    };
    let (kind, place) = in_parens(input, "`(`", |input| {
        let first = sum(input, depth)?;
        Ok(match called {
            Called::One(function) => ExprKind::Call(*function, Box::new(first)),
            Called::Two(extreme) => {
                symbol(input, ",")?;
                let second = sum(input, depth)?;
                take(input, ",");
                ExprKind::Extreme(*extreme, Box::new([first, second]))
            }
        })
    })?;
    let place = Place {
        start: ident.span(),
        end: place.end,
    };
    Ok(Expr { kind, place })
}

/// Takes a word that stands for one of several things.
pub(super) fn one_of<T: Copy>(
    input: ParseStream,
    what: &str,
    words: &[(&str, T)],
) -> Read<(Ident, T)> {
    let Some(ident) = any_word(input) else {
        return Err(unexpected(input, what));
    };
    if let Some((_, meaning)) = words.iter().find(|(word, _)| ident == word) {
        return Ok((ident, *meaning));
    }
    let words: Vec<_> = words.iter().map(|(word, _)| *word).collect();
    let remedy = spelling::remedy(&ident.to_string(), &words);
    Err(Message::new(
        Place::at(ident.span()),
        format!("expected {what}, found `{ident}`{remedy}"),
    ))
}
