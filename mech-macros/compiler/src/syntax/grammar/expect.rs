//! What a mechanism is for: `expect transmission > 40 deg for a in 0 deg ..= 90 deg, "why";`

use super::expression::{expression, measured, pair};
use super::path::{end, path};
use super::recover::read_setting;
use super::tokens::{
    any_word, comes, comes_word, expected_message, in_parens, symbol, take, take_word, word,
};
use crate::model::{Rate, Summary, function_names};
use crate::syntax::ast::{
    CaseExpr, ConditionExpr, End, Expect, Expr, ExprKind, LoadCase, MeasuredExpr, MovingExpr, Name,
    Pair, ReactionExpr, Read, SpotExpr, Statement, VectorPart,
};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Delimiter, Ident, Spacing, Span, TokenStream, TokenTree};
use syn::LitStr;
use syn::parse::ParseStream;
use syn::token::Paren;

/// The words before brackets that measure something, besides those of [`SUMMARIES`].
const MEASURES: [&str; 8] = [
    "transmission",
    "pressure",
    "curvature",
    "angle",
    "distance",
    "clear",
    "dwell",
    "d",
];

/// The words before a colon.
const KINDS: [&str; 5] = ["velocity", "acceleration", "torque", "power", "reaction"];

/// The words before brackets that sum up a motion.
const SUMMARIES: [(&str, Summary); 6] = [
    ("min", Summary::Min),
    ("max", Summary::Max),
    ("swing", Summary::Swing),
    ("stroke", Summary::Swing),
    ("mean", Summary::Mean),
    ("rms", Summary::Rms),
];

/// Two words before brackets that do so, too.
const TIME_RATIO: &str = "time ratio";

/// The signs of comparisons, the longest first: whether the second side is the greater, and whether both must differ.
const RELATIONS: [(&str, bool, bool); 4] = [
    ("<=", true, false),
    (">=", false, false),
    ("<", true, true),
    (">", false, true),
];

/// Reads a condition, the motors' values for which it holds, and the reason.
pub(super) fn expect(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let condition = condition(input)?;
        let (mut cases, mut loads) = (Vec::new(), Vec::new());
        if take_word(input, "for").is_some() {
            range_or_load(input, &mut cases, &mut loads)?;
            while another_comes(input) {
                range_or_load(input, &mut cases, &mut loads)?;
            }
        }
        if take_word(input, "at").is_some() {
            cases.push(value(input)?);
            while another_comes(input) {
                cases.push(value(input)?);
            }
        }
        let why = take(input, ",").map(|_| reason(input)).transpose()?;
        Ok(Statement::Expect(Box::new(Expect {
            keyword,
            condition,
            cases,
            loads,
            why,
        })))
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
    Ok(ConditionExpr::Compare {
        sides: [first, second],
        is_upper,
        is_strict,
    })
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

/// A number in which something may be measured.
fn number(input: ParseStream) -> Read<Expr> {
    measured(input, measure)
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
        loads.push(LoadCase {
            name,
            numbers,
            place,
        });
        return Ok(());
    }
    word(input, "in")?;
    let low = expression(input)?;
    symbol(input, "..=")?;
    let values = vec![low, expression(input)?];
    cases.push(CaseExpr {
        motor: name,
        values,
    });
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

/// Reads something that is measured, if it comes next.
fn measure(input: ParseStream, number: &dyn Fn(ParseStream) -> Read<Expr>) -> Read<Option<Expr>> {
    let Some((first, rest)) = input.cursor().ident() else {
        return Ok(None);
    };
    let name = first.to_string();
    if name == "time"
        && let Some((second, rest)) = rest.ident()
        && second == "ratio"
        && rest.group(Delimiter::Parenthesis).is_some()
    {
        any_word(input);
        any_word(input);
        let (of, brackets) = in_parens(input, "`(`", number)?;
        let kind = MeasuredExpr::Summary(Summary::TimeRatio, TIME_RATIO, of);
        return Ok(Some(from(first.span(), brackets, kind)));
    }
    let Some((inside, ..)) = rest.group(Delimiter::Parenthesis) else {
        let mark = rest.punct().map(|(mark, _)| mark);
        let colon = mark.filter(|mark| mark.as_char() == ':');
        let is_of_rust = match colon.map(|mark| mark.spacing()) {
            Some(Spacing::Alone) => return kind_and_subject(input, &first).map(Some),
            colon => colon.is_some(),
        };
        if name == "PI" || is_of_rust {
            return Ok(None);
        }
        return place_or_name(input).map(Some);
    };
    let mut summaries = SUMMARIES.into_iter();
    let summary = summaries.find(|(word, _)| *word == name);
    // The greater of two numbers is a function.
    let summary = summary.filter(|_| !has_comma(inside.token_stream()));
    if summary.is_none() && !MEASURES.contains(&name.as_str()) {
        return misspelt(&first, &name).map_or(Ok(None), Err);
    }
    any_word(input);
    let (kind, brackets) = in_parens(input, "`(`", |input| match (summary, name.as_str()) {
        (Some((word, summary)), _) => Ok(MeasuredExpr::Summary(summary, word, number(input)?)),
        (None, "transmission") => Ok(MeasuredExpr::Transmission(path(
            input,
            "the name of a joint",
        )?)),
        (None, "pressure") => path(input, "the name of a cam").map(MeasuredExpr::Pressure),
        (None, "curvature") => path(input, "the name of a cam").map(MeasuredExpr::Curvature),
        (None, "angle") => {
            let from = path(input, "the name of a link")?;
            let to = take(input, ",").map(|_| path(input, "the name of a link"));
            Ok(MeasuredExpr::Angle(from, to.transpose()?))
        }
        (None, "clear") => {
            let first = path(input, "the name of a link")?;
            symbol(input, ",")?;
            let second = path(input, "the name of a link")?;
            Ok(MeasuredExpr::Clearance([first, second]))
        }
        (None, "dwell") => {
            let of = number(input)?;
            symbol(input, ",")?;
            Ok(MeasuredExpr::Dwell([of, number(input)?]))
        }
        (None, "d") => {
            let of = number(input)?;
            symbol(input, ",")?;
            let motor = path(input, "the name of a motor")?;
            Ok(MeasuredExpr::Influence(of, motor))
        }
        (None, _) => {
            let from = spot(input, number)?;
            symbol(input, ",")?;
            Ok(MeasuredExpr::Distance([from, spot(input, number)?]))
        }
    })?;
    Ok(Some(from(first.span(), brackets, kind)))
}

/// Reads `velocity:coupler.tip.x`, `torque:a` or `reaction:b`.
fn kind_and_subject(input: ParseStream, kind: &Ident) -> Read<Expr> {
    let text = kind.to_string();
    if !KINDS.contains(&text.as_str()) {
        let remedy = spelling::remedy(&text, &KINDS);
        let text = format!("`{text}` is nothing that is measured of something{remedy}");
        return Err(Message::new(Place::at(kind.span()), text));
    }
    any_word(input);
    symbol(input, ":")?;
    let start = kind.span();
    let motor = |input| path(input, "the name of a motor");
    let (place, measured) = match text.as_str() {
        "torque" => motor(input).map(|motor| (motor.place(), MeasuredExpr::Torque(motor)))?,
        "power" => motor(input).map(|motor| (motor.place(), MeasuredExpr::Power(motor)))?,
        "reaction" => {
            let again = path(&input.fork(), "the name of a joint")?;
            let part = cut_part(again, 1, |_| true);
            let whole = path(input, "the name of a joint")?;
            let part = part.ok().map(|(joint, part, _)| (joint, part));
            let reaction = ReactionExpr { whole, part };
            (reaction.whole.place(), MeasuredExpr::Reaction(reaction))
        }
        _ => {
            let rate = if text == "velocity" {
                Rate::Velocity
            } else {
                Rate::Acceleration
            };
            let what = "a joint, a link or a point";
            let again = path(&input.fork(), what)?;
            let named = path(input, what)?;
            let place = named.place();
            let moving = match cut_part(again, 2, |_| true) {
                Ok((point, part, word)) if part != VectorPart::Torque => MovingExpr {
                    named: None,
                    point: Some(end_of(point)),
                    part: Some((part, word)),
                },
                Ok(_) => return Err(Message::new(place, "a velocity has no torque")),
                Err(again) => MovingExpr {
                    point: (!named.uses.is_empty()).then(|| end_of(again)),
                    named: Some(named),
                    part: None,
                },
            };
            (place, MeasuredExpr::Rate(rate, moving))
        }
    };
    Ok(Expr {
        kind: ExprKind::Measured(Box::new(measured)),
        place: Place { start, ..place },
    })
}

/// Takes the last word of a name off, if it is the word for such a part and so many others stand before it; else gives the name back.
fn cut_part(
    mut name: Name,
    least: usize,
    is_part: fn(VectorPart) -> bool,
) -> Result<(Name, VectorPart, Ident), Name> {
    let is_plain = name.uses.last().is_some_and(|last| last.index.is_none());
    let part = VectorPart::of(&name.name).filter(|part| is_part(*part));
    let part = part.filter(|_| is_plain && name.uses.len() >= least);
    match (part, name.uses.pop_if(|_| part.is_some())) {
        (Some(part), Some(last)) => {
            let word = std::mem::replace(&mut name.name, last.name);
            Ok((name, part, word))
        }
        _ => Err(name),
    }
}

/// The name of a point, as that of a link and one of its axes.
fn end_of(mut name: Name) -> End {
    match name.uses.pop_if(|segment| segment.index.is_none()) {
        Some(link) => {
            let axis = std::mem::replace(&mut name.name, link.name);
            End {
                link: name,
                axis: Some(axis),
            }
        }
        None => End {
            link: name,
            axis: None,
        },
    }
}

/// What is measured, from its first word to the end of its brackets.
fn from(start: Span, brackets: Place, kind: MeasuredExpr) -> Expr {
    Expr {
        kind: ExprKind::Measured(Box::new(kind)),
        place: Place {
            start,
            end: brackets.end,
        },
    }
}

/// The message about a word before brackets that is no function, but nearly one that measures something.
fn misspelt(word: &Ident, name: &str) -> Option<Message> {
    let functions: Vec<&str> = function_names().collect();
    if functions.contains(&name) {
        return None;
    }
    let summaries = SUMMARIES.iter().map(|(word, _)| *word);
    let measures = MEASURES.into_iter().chain(summaries);
    let measures: Vec<&str> = measures.chain([TIME_RATIO]).collect();
    let meant = spelling::nearest(name, &[&functions[..], &measures[..]].concat())?;
    measures.contains(&meant).then(|| {
        let text = format!("nothing that is measured is called `{name}`; did you mean `{meant}`?");
        Message::new(Place::at(word.span()), text)
    })
}

fn has_comma(tokens: TokenStream) -> bool {
    let is_comma = |token| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ',');
    tokens.into_iter().any(is_comma)
}

/// Reads a joint, a link or a constant, or the abscissa or ordinate of a point.
fn place_or_name(input: ParseStream) -> Read<Expr> {
    let name = path(input, "a joint, a link or a point")?;
    let place = name.place();
    let is_coordinate = |part| matches!(part, VectorPart::X | VectorPart::Y);
    let kind = match cut_part(name, 2, is_coordinate) {
        Ok((point, part, _)) => MeasuredExpr::Place(end_of(point), part == VectorPart::Y),
        Err(name) => MeasuredExpr::Named(name),
    };
    Ok(Expr {
        kind: ExprKind::Measured(Box::new(kind)),
        place,
    })
}

/// Reads `link.point` or `(x, y)`.
fn spot(input: ParseStream, number: &dyn Fn(ParseStream) -> Read<Expr>) -> Read<SpotExpr> {
    if !input.peek(Paren) {
        return end(input).map(SpotExpr::Axis);
    }
    let ((x, y), place) = in_parens(input, "`(x, y)`", |input| {
        let x = number(input)?;
        symbol(input, ",")?;
        Ok((x, number(input)?))
    })?;
    Ok(SpotExpr::At(Pair { x, y, place }))
}
