//! `joint name = kind(first, second, size) at (x, y) along (dx, dy);`

use super::beginning::{STATEMENTS, at_beginning};
use super::expression::{direction, expression, one_of, pair, read_labelled};
use super::motion;
use super::path::{end, path};
use super::recover::{broken_statement, read_declared, skip, to_semicolon};
use super::tokens::{comes_word, expected_message, in_parens, symbol, take, take_word};
use crate::syntax::ast::{
    Broken, Clause, End, Expr, ExprKind, Joint, JointBody, JointWord, Name, Read, RollerExpr,
    Rolling, Size, Statement,
};
use crate::syntax::{Message, Place};
use proc_macro2::{Delimiter, Ident};
use syn::parse::ParseStream;
use syn::token::Paren;

const WORDS: [(&str, JointWord); 8] = [
    ("revolute", JointWord::Revolute),
    ("prismatic", JointWord::Prismatic),
    ("gear", JointWord::Gear),
    ("slot", JointWord::Slot),
    ("rack", JointWord::Rack),
    ("belt", JointWord::Belt),
    ("weld", JointWord::Weld),
    ("cam", JointWord::Cam),
];

/// Reads a joint after its keyword.
pub(super) fn joint(input: ParseStream) -> Statement {
    read_declared(input, "the name of a joint", |input, name| {
        if input.peek(Paren) && WORDS.iter().any(|(word, _)| name == word) {
            skip(input, &STATEMENTS);
            let text = format!("a joint has a name before its kind: `joint NAME = {name}(...)`");
            return broken_statement(Message::new(Place::at(name.span()), text));
        }
        let body = to_semicolon(input, &STATEMENTS, body);
        Statement::Joint(Box::new(Joint { name, body }))
    })
}

/// Whether `= revolute(` comes next: a joint whose keyword is missing.
pub(super) fn body_comes(input: ParseStream) -> bool {
    let sign = input.cursor().punct();
    let kind = sign.filter(|(sign, _)| sign.as_char() == '=').and_then(|(_, rest)| rest.ident());
    kind.is_some_and(|(kind, rest)| {
        let is_called = rest.group(Delimiter::Parenthesis).is_some();
        is_called && WORDS.iter().any(|(word, _)| kind == word)
    })
}

/// The message about a joint that begins with its name.
pub(super) fn without_keyword(input: ParseStream, name: Ident) -> Statement {
    skip(input, &STATEMENTS);
    let text = format!("a joint begins with `joint`; write `joint {name}` for `{name}`");
    Statement::Broken(Broken {
        error: Message::new(Place::at(name.span()), text),
        names: vec![name],
    })
}

fn body(input: ParseStream) -> Read<JointBody> {
    symbol(input, "=")?;
    let (word, kind) = one_of(input, "a kind of joint", &WORDS)?;
    let ((ends, (rolling, law)), _) = in_parens(input, "`(`", |input| parts(input, kind))?;
    if input.peek(Paren) {
        let place = pair(input)?;
        let text = format!("a place follows `at`; write `at ({}, {})`", place.x, place.y);
        return Err(Message::new(place.place, text));
    }
    let roller = match kind {
        JointWord::Cam => roller(input)?,
        _ => None,
    };
    let at = clause(input, "at", pair)?;
    let along = clause(input, "along", direction)?;
    if rolling.is_some() {
        carrier_outside(input)?;
    }
    Ok(JointBody { word, kind, ends, rolling, law, roller, at, along })
}

/// The text in the brackets: the ends, the sizes of rolling parts, and a cam's law.
type Parts = ([End; 2], (Option<Rolling>, Option<Expr>));

fn parts(input: ParseStream, kind: JointWord) -> Read<Parts> {
    let first = end(input)?;
    let next = match kind {
        JointWord::Cam => "the joint of the follower",
        _ => "the second link",
    };
    comma(input, next)?;
    let second = end(input)?;
    let law = match kind {
        JointWord::Cam => {
            let what = "the follower's coordinate by the shaft's, `q`, as `0.2 * (1 - cos(q))`";
            comma(input, what)?;
            Some(motion::law(input)?)
        }
        _ => None,
    };
    let size = match kind {
        JointWord::Gear | JointWord::Belt => Some(ratio(input, [&first, &second])?),
        JointWord::Rack => Some(radius(input)?),
        JointWord::Revolute
        | JointWord::Prismatic
        | JointWord::Slot
        | JointWord::Weld
        | JointWord::Cam => None,
    };
    let rolling = match size {
        Some(size) => Some(Rolling { size, carrier: carrier(input)? }),
        None => None,
    };
    if take(input, ",").is_some() && size_is_none(kind) {
        two_links(input, kind, [&first, &second])?;
    }
    Ok(([first, second], (rolling, law)))
}

/// A comma, and what is missing after it if there is none.
fn comma(input: ParseStream, next: &str) -> Read<()> {
    match take(input, ",") {
        Some(_) => Ok(()),
        None => Err(expected_message(input, &format!("`,` and {next}"))),
    }
}

fn ratio(input: ParseStream, [a, b]: [&End; 2]) -> Read<Size> {
    comma(input, "the teeth of both wheels, as `20 : 40`")?;
    let first = expression(input)?;
    if take(input, ":").is_some() {
        let second = expression(input)?;
        return Ok(Size::Ratio([first, second]));
    }
    let written = |first: &Expr, second: &Expr| {
        format!("a ratio is written with `:`; write `{first} : {second}`")
    };
    let otherwise = expected_message(input, "`:`");
    if take(input, ",").is_some() && !input.is_empty() {
        let second = expression(input)?;
        return Err(Message::new(first.place.to(second.place), written(&first, &second)));
    }
    if !input.is_empty() && !comes_word(input, "on") {
        return Err(otherwise);
    }
    let factors = match &first.kind {
        ExprKind::Product(factors) => &factors[..],
        _ => &[],
    };
    let text = match factors {
        [(false, first), (true, second)] => written(first, second),
        _ => format!(
            "a ratio has two numbers; write `1 : {first}` if `{b}` is the larger wheel, or `{first} : 1` if `{a}` is"
        ),
    };
    Err(Message::new(first.place, text))
}

fn size_is_none(kind: JointWord) -> bool {
    !matches!(kind, JointWord::Gear | JointWord::Belt | JointWord::Rack | JointWord::Cam)
}

/// Complains about a third link.
fn two_links(input: ParseStream, kind: JointWord, [first, second]: [&End; 2]) -> Read<()> {
    if input.is_empty() {
        return Ok(());
    }
    let third = end(input)?;
    let words = WORDS.iter().filter(|(_, word)| *word == kind);
    let word: String = words.map(|(word, _)| *word).collect();
    let link = third.link.to_string();
    let is_known = [first, second].iter().any(|end| end.link.to_string() == link);
    let mut text = format!("a joint joins two links; leave `, {third}` out");
    if !is_known {
        text += &format!(", or declare another joint for it, as `{word}({first}, {third})`");
    }
    Err(Message::new(third.place(), text))
}

fn carrier(input: ParseStream) -> Read<Option<Name>> {
    take_word(input, "on").map(|_| path(input, "the name of a link")).transpose()
}

/// Complains about a carrier that is named after the brackets.
fn carrier_outside(input: ParseStream) -> Read<()> {
    let Some(keyword) = take_word(input, "on") else {
        return Ok(());
    };
    let link = path(input, "the name of a link")?;
    let text =
        format!("the carrier is named within the brackets; write `on {link})` for `) on {link}`");
    Err(Message::new(Place::at(keyword).to(Place::at(link.span())), text))
}

/// Reads `roller valve.foot radius 5`, if it comes.
fn roller(input: ParseStream) -> Read<Option<RollerExpr>> {
    if take_word(input, "roller").is_none() {
        return Ok(None);
    }
    let point = end(input)?;
    let radius = read_labelled(input, "radius")?;
    Ok(Some(RollerExpr { point, radius }))
}

fn radius(input: ParseStream) -> Read<Size> {
    comma(input, "the radius of the pinion, as `radius 0.5`")?;
    read_labelled(input, "radius").map(Size::Radius)
}

fn clause<T>(
    input: ParseStream,
    keyword: &str,
    value: fn(ParseStream) -> Read<T>,
) -> Read<Option<Clause<T>>> {
    // A joint without its `;` may stand before `at change points`.
    if at_beginning(input, &STATEMENTS) {
        return Ok(None);
    }
    let Some(keyword) = take_word(input, keyword) else {
        return Ok(None);
    };
    Ok(Some(Clause { keyword, value: value(input)? }))
}
