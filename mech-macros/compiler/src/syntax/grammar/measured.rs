//! What is measured: `coupler.tip.y`, `max(torque:a)`, `distance(tip.p, (1, 2))`.

use super::ending::refuse_misspelt;
use super::expression::measured;
use super::path::{end, path};
use super::tokens::{any_word, expected_message, in_parens, symbol, take, word};
use crate::model::{Rate, Summary, function_names};
use crate::syntax::ast::{
    End, Expr, ExprKind, MeasuredExpr, MovingExpr, Name, Pair, ReactionExpr, Read, SpotExpr,
    VectorPart,
};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Delimiter, Ident, Spacing, Span, TokenStream, TokenTree};
use syn::parse::ParseStream;
use syn::token::Paren;

/// The words before brackets that measure something, besides those of [`SUMMARIES`].
const MEASURES: [&str; 10] = [
    "transmission",
    "pressure",
    "curvature",
    "angle",
    "distance",
    "clear",
    "centre",
    "dwell",
    "d",
    "advantage",
];

/// The words before a colon.
const KINDS: [&str; 6] = ["velocity", "acceleration", "torque", "power", "reaction", "shaking"];

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

/// Reads a number in which something may be measured.
pub(super) fn number(input: ParseStream) -> Read<Expr> {
    measured(input, measure)
}

/// Reads something that is measured, if it comes next.
fn measure(input: ParseStream, number: &dyn Fn(ParseStream) -> Read<Expr>) -> Read<Option<Expr>> {
    let Some((first, rest)) = input.cursor().ident() else {
        return Ok(None);
    };
    let name = first.to_string();
    if name == "time"
        && let Some((_, rest)) = rest.ident()
        && rest.group(Delimiter::Parenthesis).is_some()
    {
        any_word(input);
        refuse_misspelt(input, &["ratio"])?;
        word(input, "ratio")?;
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
        let (of, place) = moving(input)?;
        let kind = ExprKind::Measured(Box::new(MeasuredExpr::Moving(None, of)));
        return Ok(Some(Expr { kind, place }));
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
        (None, "transmission") => {
            Ok(MeasuredExpr::Transmission(path(input, "the name of a joint")?))
        }
        (None, "pressure") => path(input, "the name of a cam").map(MeasuredExpr::Pressure),
        (None, "curvature") => path(input, "the name of a cam").map(MeasuredExpr::Curvature),
        (None, "angle") => {
            let from = path(input, "the name of a link")?;
            let to = take(input, ",").map(|_| path(input, "the name of a link"));
            Ok(MeasuredExpr::Angle(from, to.transpose()?))
        }
        (None, "clear") => two_links(input).map(MeasuredExpr::Clearance),
        (None, "centre") => two_links(input).map(|links| MeasuredExpr::Centre(links, None)),
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
        (None, "advantage") => {
            let load = path(input, "the name of a load")?;
            symbol(input, ",")?;
            let motor = path(input, "the name of a motor")?;
            Ok(MeasuredExpr::Advantage(load, motor))
        }
        (None, _) => {
            let from = spot(input, number)?;
            symbol(input, ",")?;
            Ok(MeasuredExpr::Distance([from, spot(input, number)?]))
        }
    })?;
    let MeasuredExpr::Centre(links, _) = kind else {
        return Ok(Some(from(first.span(), brackets, kind)));
    };
    let part = take(input, ".").map(|_| part_of_place(input)).transpose()?;
    let end = part.map_or(brackets, |(_, place)| place);
    let kind = MeasuredExpr::Centre(links, part.map(|(part, _)| part));
    Ok(Some(from(first.span(), end, kind)))
}

/// Reads `x`, `y` or `norm`.
fn part_of_place(input: ParseStream) -> Read<(VectorPart, Place)> {
    let place = Place::at(input.span());
    let word = input.cursor().ident().map(|(word, _)| word);
    match word.as_ref().and_then(VectorPart::of) {
        Some(part) if part != VectorPart::Torque => {
            any_word(input);
            Ok((part, place))
        }
        _ => Err(expected_message(input, "`x`, `y` or `norm`")),
    }
}

/// Reads the names of two links.
fn two_links(input: ParseStream) -> Read<[Name; 2]> {
    let first = path(input, "the name of a link")?;
    symbol(input, ",")?;
    Ok([first, path(input, "the name of a link")?])
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
        "shaking" => {
            let what = path(input, "`force` or `moment`")?;
            (what.place(), MeasuredExpr::Shaking(shaking(what)?))
        }
        "reaction" => {
            let again = path(&input.fork(), "the name of a joint")?;
            let part = cut_part(again, 1, |_| true);
            let whole = path(input, "the name of a joint")?;
            let part = part.ok().map(|(joint, part, _)| (joint, part));
            let reaction = ReactionExpr { whole, part };
            (reaction.whole.place(), MeasuredExpr::Reaction(reaction))
        }
        _ => {
            let rate = if text == "velocity" { Rate::Velocity } else { Rate::Acceleration };
            let (of, place) = moving(input)?;
            (place, MeasuredExpr::Moving(Some(rate), of))
        }
    };
    Ok(Expr { kind: ExprKind::Measured(Box::new(measured)), place: Place { start, ..place } })
}

/// Reads a joint, a link, a constant, a point or a part of one.
fn moving(input: ParseStream) -> Read<(MovingExpr, Place)> {
    let what = "a joint, a link or a point";
    let again = path(&input.fork(), what)?;
    let named = path(input, what)?;
    let place = named.place();
    let moving = match cut_part(again, 2, |_| true) {
        Ok((point, part, word)) if part != VectorPart::Torque => {
            MovingExpr { named: None, point: Some(end_of(point)), part: Some((part, word)) }
        }
        Ok(_) => return Err(Message::new(place, "only a reaction has a torque")),
        Err(again) => MovingExpr {
            point: (!named.uses.is_empty()).then(|| end_of(again)),
            named: Some(named),
            part: None,
        },
    };
    Ok((moving, place))
}

/// The part of what shakes the ground: of `moment` the torque, of `force` the whole of it or a part.
fn shaking(what: Name) -> Read<Option<VectorPart>> {
    let place = what.place();
    let (what, part) = match cut_part(what, 1, |part| part != VectorPart::Torque) {
        Ok((what, part, _)) => (what, Some(part)),
        Err(what) => (what, None),
    };
    match (what.uses.is_empty(), what.name.to_string().as_str(), part) {
        (true, "force", part) => Ok(part),
        (true, "moment", None) => Ok(Some(VectorPart::Torque)),
        _ => {
            let text = format!(
                "`{what}` shakes nothing; write `shaking:force`, perhaps with `.x` or `.y`, or `shaking:moment`"
            );
            Err(Message::new(place, text))
        }
    }
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
            End { link: name, axis: Some(axis) }
        }
        None => End { link: name, axis: None },
    }
}

/// What is measured, from its first word to the end of its brackets.
fn from(start: Span, brackets: Place, kind: MeasuredExpr) -> Expr {
    Expr { kind: ExprKind::Measured(Box::new(kind)), place: Place { start, end: brackets.end } }
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
