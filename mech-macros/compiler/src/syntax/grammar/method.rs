//! The settings of how loops are solved: method, accuracy, cost and change points.

use super::ending::refuse_misspelt;
use super::expression::expression;
use super::recover::read_setting;
use super::tokens::{any_word, comes_word, expected_message, in_parens, take_word, word};
use crate::model::AtChangePoints;
use crate::syntax::Message;
use crate::syntax::ast::{Expr, Method, Read, Statement};
use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::token;

/// Reads `newton(2);` or `newton(1) predictor(3);`.
pub(super) fn method(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let word = any_word(input)
            .ok_or_else(|| expected_message(input, "`exact`, `newton` or `linear`"))?;
        let steps =
            if input.peek(token::Paren) { Some(in_parens(input, "`(`", steps)?) } else { None };
        refuse_misspelt(input, &["predictor"])?;
        let predictor = take_word(input, "predictor")
            .map(|span| Ok((span, in_parens(input, "`(`", expression)?.0)))
            .transpose()?;
        Ok(Statement::Method(Method { keyword, word, steps, predictor }))
    })
}

fn steps(input: ParseStream) -> Read<Option<Expr>> {
    if input.is_empty() {
        return Ok(None);
    }
    expression(input).map(Some)
}

/// Reads `1e-9;`.
pub(super) fn accuracy(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| Ok(Statement::Accuracy { keyword, value: expression(input)? }))
}

/// Reads `x86_64;`.
pub(super) fn cost(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let word = any_word(input).ok_or_else(|| {
            expected_message(input, "the name of a machine, `x86_64` or `cortex_m4f`")
        })?;
        Ok(Statement::Cost { keyword, word })
    })
}

/// Reads `change points stop;`.
pub(super) fn change_points(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let what = at_change_points(input).map_err(|error| with_choices(&error))?;
        Ok(Statement::ChangePoints { keyword, what })
    })
}

fn at_change_points(input: ParseStream) -> Read<AtChangePoints> {
    word(input, "change")?;
    word(input, "points")?;
    let (what, words) = if comes_word(input, "stop") {
        (AtChangePoints::Stop, ["stop"].as_slice())
    } else if comes_word(input, "keep") {
        (AtChangePoints::KeepBranch, ["keep", "branch"].as_slice())
    } else if comes_word(input, "go") {
        (AtChangePoints::GoOn, ["go", "on"].as_slice())
    } else {
        return Err(expected_message(input, "`go`, `keep` or `stop`"));
    };
    words.iter().try_for_each(|text| word(input, text).map(drop))?;
    Ok(what)
}

/// A message about the first wrong word, with what may be written in all.
fn with_choices(message: &Message) -> Message {
    let choices =
        "write `at change points go on`, `at change points keep branch` or `at change points stop`";
    Message::new(message.place, format!("{}; {choices}", message.text))
}
