//! Motors, the start and what is wanted: everything that refers to links and joints declared elsewhere.

use super::beginning::{STATEMENTS, at_beginning};
use super::ending::{after_last, refuse_misspelt};
use super::expression::expression;
use super::motion;
use super::path::{end, path};
use super::recover::{or_skip, read_setting, skip, to_semicolon};
use super::tokens::{
    any_word, comes, expected_message, in_braces, in_brackets, in_parens, name, symbol, take,
    take_word,
};
use super::trace::trace;
use crate::syntax::ast::{
    Broken, EFFECTS, Effect, Expr, Follow, Motor, Name, Read, Start, StartClause, Statement,
    Trajectory,
};
use crate::syntax::written::in_product;
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Ident, Span};
use syn::parse::ParseStream;
use syn::token;

/// Whether a motor with a law comes next: `motor name =`.
pub(super) fn law_comes(input: ParseStream) -> bool {
    let mut words = input.cursor().ident().filter(|(word, _)| word == "motor");
    words = words.and_then(|(_, rest)| rest.ident());
    words.is_some_and(|(_, rest)| rest.punct().is_some_and(|(sign, _)| sign.as_char() == '='))
}

/// Reads `name = law in low ..= high by step;`.
pub(super) fn motor(input: ParseStream) -> Statement {
    read_setting(input, |input| {
        let joint = path(input, "the name of a joint")?;
        one_motor(input, &joint)?;
        worded_speed(input)?;
        let law = take(input, "=").map(|_| motion::law(input)).transpose()?;
        worded_range(input)?;
        refuse_misspelt(input, &["in", "by", "deg", "rpm"])?;
        let range = take_word(input, "in").map(|_| range(input)).transpose()?;
        let step = take_word(input, "by").map(|_| expression(input)).transpose()?;
        after_step(input)?;
        Ok(Statement::Motor(Motor { joint, law, range, step }))
    })
}

/// Complains about several joints in one `motor`.
fn one_motor(input: ParseStream, first: &Name) -> Read<()> {
    let mut others = Vec::new();
    while take(input, ",").is_some() {
        others.push(path(input, "the name of a joint")?);
    }
    let Some(last) = others.last() else {
        return Ok(());
    };
    let place = first.place().to(last.place());
    let names = std::iter::once(first).chain(&others);
    let statements: Vec<_> = names.map(|name| format!("motor {name};")).collect();
    let text = format!("each motor has its own statement; write `{}`", statements.join(" "));
    Err(Message::new(place, text))
}

/// Complains about a speed in words: `speed 3`, `at 60 rpm`.
fn worded_speed(input: ParseStream) -> Read<()> {
    if at_beginning(input, &STATEMENTS) {
        return Ok(());
    }
    let mut words = ["speed", "at", "with"].into_iter();
    let Some(word) = words.find_map(|word| take_word(input, word)) else {
        return Ok(());
    };
    take_word(input, "speed");
    let error = match expression(input) {
        Ok(speed) => Message::new(
            speed.place,
            format!("a motor's law follows `=`; write `= {} * t`", in_product(&speed)),
        ),
        Err(error) => Message { text: error.text.replacen("write `", "write `= ", 1), ..error },
    };
    Err(Message { place: Place::at(word).to(error.place), ..error })
}

/// Complains about a range in words: `from low to high`.
fn worded_range(input: ParseStream) -> Read<()> {
    let Some(first) = take_word(input, "from").or_else(|| take_word(input, "between")) else {
        return Ok(());
    };
    let low = expression(input)?;
    if take_word(input, "to").is_none() && take_word(input, "and").is_none() {
        return Err(expected_message(input, "`to`"));
    }
    let high = expression(input)?;
    let text = format!("a range is written with `..=`; write `in {low} ..= {high}`");
    Err(Message::new(Place::at(first).to(high.place), text))
}

fn range(input: ParseStream) -> Read<[Expr; 2]> {
    if input.peek(token::Bracket) {
        let comma = |input: ParseStream| {
            let low = expression(input)?;
            symbol(input, ",")?;
            Ok((low, expression(input)?))
        };
        let ((low, high), place) = in_brackets(input, "`[`", comma)?;
        let text = format!("a range is written with `..=`; write `{low} ..= {high}`");
        return Err(Message::new(place, text));
    }
    let low = expression(input)?;
    symbol(input, "..=")?;
    Ok([low, expression(input)?])
}

fn after_step(input: ParseStream) -> Read<()> {
    match take_word(input, "in") {
        Some(word) => Err(Message::new(Place::at(word), "`in` stands before `by`; swap the two")),
        None if comes(input, "=") => {
            Err(expected_message(input, "`;` (a law stands before `in` and `by`)"))
        }
        None => Ok(()),
    }
}

/// Reads `{ joint = value; link near angle; }`.
pub(super) fn start(input: ParseStream, keyword: Span) -> Statement {
    match or_skip(input, &STATEMENTS, |input| in_braces(input, "`{`", clause)) {
        Ok(clauses) => Statement::Start(Start { keyword, clauses }),
        Err(error) => Statement::Broken(Broken { error, names: Vec::new() }),
    }
}

fn clause(input: ParseStream) -> Read<StartClause> {
    to_semicolon(input, &[], |input| {
        let name = path(input, "the name of a joint or a link")?;
        let near = take_word(input, "near").is_some();
        if !near && take(input, "=").is_none() {
            return Err(expected_message(input, "`=` (for a joint) or `near` (for a link)"));
        }
        Ok(StartClause { name, near, value: expression(input)? })
    })
}

/// Reads `{ velocity; trace a.b 256; }`.
pub(super) fn effects(input: ParseStream, keyword: Span) -> Statement {
    let in_braces = |input: ParseStream| {
        let all = in_braces(input, "`{`", effect);
        all.map_err(|mut error| {
            if let Some((effect, _)) = input.cursor().ident() {
                error.text += &format!("; write `effects {{ {effect}; }}`");
            }
            error
        })
    };
    match or_skip(input, &STATEMENTS, in_braces) {
        Ok(effects) => Statement::Effects { keyword, effects },
        Err(error) => Statement::Broken(Broken { error, names: Vec::new() }),
    }
}

/// Complains about effects outside of their braces: all that stand there in a row.
pub(super) fn stray_effects(input: ParseStream, first: &Ident) -> Message {
    let mut effects = vec![first.clone()];
    loop {
        skip(input, &STATEMENTS);
        let next = input.cursor().ident().map(|(word, _)| word);
        let Some(next) = next.filter(|word| EFFECTS.iter().any(|effect| word == effect)) else {
            break;
        };
        any_word(input);
        effects.push(next);
    }
    let place = Place::at(first.span()).to(Place::at(effects[effects.len() - 1].span()));
    let statements: Vec<String> = effects
        .iter()
        .map(|effect| match effect.to_string().as_str() {
            "trace" => "trace ...;".to_owned(),
            plain => format!("{plain};"),
        })
        .collect();
    let text = format!("effects stand in braces; write `effects {{ {} }}`", statements.join(" "));
    Message::new(place, text)
}

fn effect(input: ParseStream) -> Read<Effect> {
    let begin = input.cursor();
    to_semicolon(input, &[], |input| {
        if take_word(input, "trace").is_some() {
            return trace(input).map(|trace| Effect::Trace(Box::new(trace)));
        }
        let effect = name(input, "the name of an effect")?;
        // No number stands here: a word is the next effect.
        let next = input.cursor().ident();
        let word = effect.to_string();
        if next.is_some() && spelling::nearest(&word, &["trace"]).is_some() {
            let text = format!("unknown effect `{word}`; did you mean `trace`?");
            return Err(Message::new(Place::at(effect.span()), text));
        }
        match next.and_then(|_| after_last(input, begin, "`;`")) {
            Some(missing) => Err(missing),
            None => Ok(Effect::Plain(effect)),
        }
    })
}

/// Reads `a, b.c;`.
pub(super) fn show(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let what = read_list(input, end)?;
        Ok(Statement::Show { keyword, what })
    })
}

/// Reads `a, b;`.
pub(super) fn continuous(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let joints = read_list(input, |input| path(input, "the name of a joint"))?;
        Ok(Statement::Continuous { keyword, joints })
    })
}

/// Reads `pen.tip in (1 ..= 3, 0 ..= 2) by left, right;`.
pub(super) fn follow(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let what = end(input)?;
        refuse_misspelt(input, &["in", "by"])?;
        let region = if take_word(input, "in").is_some() {
            let expected = "the ranges of x and y, as `(0 ..= 2, 1 ..= 3)`";
            in_parens(input, expected, |input| read_list(input, range))?.0
        } else {
            Vec::new()
        };
        if take_word(input, "by").is_none() {
            let mut error = expected_message(input, "`by` and the motors that follow");
            error.text += &format!("; write `follow {what} by a, b`");
            return Err(error);
        }
        let motors = read_list(input, |input| path(input, "the name of a motor's joint"))?;
        refuse_misspelt(input, &["least"])?;
        let least = take_word(input, "least");
        Ok(Statement::Follow(Follow { keyword, what, region, motors, least }))
    })
}

/// Reads `pen.tip = (2 + cos(t), 1 + sin(t));`.
pub(super) fn trajectory(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let what = end(input)?;
        symbol(input, "=")?;
        let expected = "the laws of x and y, as `(2 + cos(t), 1 + sin(t))`";
        let laws = in_parens(input, expected, |input| read_list(input, expression))?.0;
        Ok(Statement::Path(Trajectory { keyword, what, laws }))
    })
}

/// Reads one or more of something, with commas between them.
fn read_list<T>(input: ParseStream, one: impl Fn(ParseStream) -> Read<T>) -> Read<Vec<T>> {
    let mut all = vec![one(input)?];
    while take(input, ",").is_some() && !input.peek(token::Semi) {
        all.push(one(input)?);
    }
    Ok(all)
}

/// Reads `redundant;`.
pub(super) fn allow(input: ParseStream) -> Statement {
    read_setting(input, |input| {
        let word =
            any_word(input).ok_or_else(|| expected_message(input, "`redundant` or `coupled`"))?;
        Ok(Statement::Allow(word))
    })
}

/// Reads `diagram;`.
pub(super) fn look(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let expected = "`machine`, `diagram` or `none`";
        let word = any_word(input).ok_or_else(|| expected_message(input, expected))?;
        Ok(Statement::Look { keyword, word })
    })
}

/// Reads `smooth;`.
pub(super) fn quality(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let word = any_word(input).ok_or_else(|| expected_message(input, "`hard` or `smooth`"))?;
        Ok(Statement::Quality { keyword, word })
    })
}
