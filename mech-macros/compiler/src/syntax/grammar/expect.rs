//! What a mechanism is for: `expect transmission > 40 deg for a in 0 deg ..= 90 deg, "why";`

use super::ending::refuse_misspelt;
use super::expression::{expression, pair};
use super::measured::number;
use super::path::path;
use super::recover::read_setting;
use super::tokens::{
    any_word, comes, comes_word, expected_message, in_parens, symbol, take, take_word, word,
};
use crate::syntax::ast::{CaseExpr, ConditionExpr, Expect, Expr, LoadCase, Pair, Read, Statement};
use crate::syntax::{Message, Place};
use proc_macro2::{Delimiter, Span};
use syn::LitStr;
use syn::parse::ParseStream;
use syn::token::Paren;

/// The signs of comparisons, the longest first: whether the second side is the greater, and whether both must differ.
const RELATIONS: [(&str, bool, bool); 4] =
    [("<=", true, false), (">=", false, false), ("<", true, true), (">", false, true)];

/// Reads a condition, the motors' values for which it holds, and the reason.
pub(super) fn expect(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let condition = condition(input)?;
        let (mut cases, mut loads) = (Vec::new(), Vec::new());
        refuse_misspelt(input, &["for", "at", "deg", "rpm"])?;
        if take_word(input, "for").is_some() {
            range_or_load(input, &mut cases, &mut loads)?;
            while another_comes(input) {
                range_or_load(input, &mut cases, &mut loads)?;
            }
        }
        refuse_misspelt(input, &["at", "deg", "rpm"])?;
        if take_word(input, "at").is_some() {
            cases.push(value(input)?);
            while another_comes(input) {
                cases.push(value(input)?);
            }
        }
        refuse_misspelt(input, &["deg", "rpm"])?;
        let why = take(input, ",").map(|_| reason(input)).transpose()?;
        Ok(Statement::Expect(Box::new(Expect { keyword, condition, cases, loads, why })))
    })
}

fn condition(input: ParseStream) -> Read<ConditionExpr> {
    let after = input.cursor().ident().map(|(_, rest)| rest);
    let brackets = after.and_then(|rest| rest.group(Delimiter::Parenthesis));
    if comes_word(input, "turns") && brackets.is_some() {
        let start = Place::at(input.span());
        any_word(input);
        let read = |input: ParseStream| path(input, "the name of a motor");
        let (motor, place) = in_parens(input, "`(`", read)?;
        return Ok(ConditionExpr::Turns(motor, start.to(place)));
    }
    let first = number(input)?;
    refuse_misspelt(input, &["in", "deg", "rpm"])?;
    if take_word(input, "in").is_some() {
        return Ok(ConditionExpr::Within(first, between(input)?));
    }
    let Some((is_upper, is_strict)) = relation(input) else {
        return Err(no_relation(input, &first));
    };
    let second = number(input)?;
    if relation(input).is_some() {
        let text = format!(
            "a condition compares two numbers; write `{second} in {first} ..= ...`, or two statements"
        );
        return Err(Message::new(first.place.to(second.place), text));
    }
    Ok(ConditionExpr::Compare { sides: [first, second], is_upper, is_strict })
}

fn relation(input: ParseStream) -> Option<(bool, bool)> {
    let mut all = RELATIONS.into_iter();
    let found = all.find(|(sign, ..)| take(input, sign).is_some());
    found.map(|(_, is_upper, is_strict)| (is_upper, is_strict))
}

/// The message about a number with which nothing is compared.
fn no_relation(input: ParseStream, first: &Expr) -> Message {
    if comes(input, "=") || comes(input, "==") {
        let text = format!(
            "numbers that are computed are hardly ever equal; write `{first} in ... ..= ...`"
        );
        return Message::new(first.place, text);
    }
    expected_message(input, "`<`, `<=`, `>`, `>=` or `in`")
}

fn between(input: ParseStream) -> Read<[Expr; 2]> {
    let low = number(input)?;
    symbol(input, "..=")?;
    Ok([low, number(input)?])
}

/// Takes a comma, if another motor follows it.
fn another_comes(input: ParseStream) -> bool {
    let is_reason = input.peek2(LitStr);
    !is_reason && take(input, ",").is_some()
}

/// Reads `motor in low ..= high`, `load = (x, y)` or `load = torque`.
fn range_or_load(
    input: ParseStream,
    cases: &mut Vec<CaseExpr>,
    loads: &mut Vec<LoadCase>,
) -> Read<()> {
    let name = path(input, "the name of a motor")?;
    if take(input, "=").is_some() {
        let place = Place::at(input.span());
        let (numbers, place) = if input.peek(Paren) {
            let Pair { x, y, place } = pair(input)?;
            (vec![x, y], place)
        } else {
            let number = expression(input)?;
            let place = place.to(number.place);
            (vec![number], place)
        };
        loads.push(LoadCase { name, numbers, place });
        return Ok(());
    }
    word(input, "in")?;
    let low = expression(input)?;
    symbol(input, "..=")?;
    let values = vec![low, expression(input)?];
    cases.push(CaseExpr { motor: name, values });
    Ok(())
}

/// Reads `motor = value`.
fn value(input: ParseStream) -> Read<CaseExpr> {
    let motor = path(input, "the name of a motor")?;
    symbol(input, "=")?;
    let values = vec![expression(input)?];
    Ok(CaseExpr { motor, values })
}

fn reason(input: ParseStream) -> Read<String> {
    let text = input.parse::<LitStr>();
    text.map(|text| text.value())
        .map_err(|_| expected_message(input, "the reason, as \"so that it fits\""))
}
