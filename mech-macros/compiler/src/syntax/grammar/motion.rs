//! Motions in segments: `rise 9 over 90 deg with cycloidal, dwell 30 deg, return over 90 deg, dwell`.

use super::ending::refuse_misspelt;
use super::expression::{expression, one_of};
use super::tokens::{comes_word, expected_message, take, take_word};
use crate::syntax::ast::{Expr, ExprKind, MotionExpr, Read, SegmentExpr, Way};
use crate::syntax::{Message, Place};
use mech_core::MotionLaw;
use proc_macro2::{Ident, TokenTree};
use syn::buffer::Cursor;
use syn::parse::ParseStream;

const FROM: &str = "from";
const OVER: &str = "over";
const REPEAT: &str = "repeat";
/// The words with which segments begin.
const WAYS: [&str; 4] = ["rise", "fall", "return", "dwell"];
/// Words after a constant that is called like one of them.
const AFTER_NUMBERS: [&str; 4] = ["deg", "rpm", "in", "by"];

/// Reads a law: a motion in segments, or a number.
pub(super) fn law(input: ParseStream) -> Read<Expr> {
    if begins(input.cursor()) { motion(input) } else { expression(input) }
}

/// Whether a motion in segments comes next, and not a number that begins with a constant of such a name.
fn begins(cursor: Cursor) -> bool {
    let Some((word, rest)) = cursor.ident() else {
        return false;
    };
    let is_one = WAYS.iter().any(|way| word == way) || word == FROM;
    let goes_on = match (rest.ident(), rest.punct()) {
        (Some((next, _)), _) => !AFTER_NUMBERS.iter().any(|word| next == word),
        (None, Some((sign, rest))) => match sign.as_char() {
            ',' => word == "dwell",
            '-' => has_segments(rest),
            _ => false,
        },
        (None, None) => !rest.eof(),
    };
    is_one && (goes_on || word == "return")
}

/// Whether `over` or a comma stands before the statement ends.
fn has_segments(mut cursor: Cursor) -> bool {
    while let Some((tree, rest)) = cursor.token_tree() {
        match tree {
            TokenTree::Ident(word) if word == OVER => return true,
            TokenTree::Punct(sign) if sign.as_char() == ',' => return true,
            TokenTree::Punct(sign) if sign.as_char() == ';' => return false,
            _ => cursor = rest,
        }
    }
    false
}

fn motion(input: ParseStream) -> Read<Expr> {
    let begin = Place::at(input.span());
    let mut motion = MotionExpr { from: None, segments: Vec::new(), repeats: false };
    if take_word(input, FROM).is_some() {
        motion.from = Some(expression(input)?);
        if take(input, ",").is_none() {
            return Err(expected_message(input, "`,` and `rise`, `fall` or `dwell`"));
        }
    }
    let end = loop {
        if let Some(keyword) = take_word(input, REPEAT) {
            motion.repeats = true;
            break Place::at(keyword);
        }
        let segment = segment(input)?;
        let end = segment.place;
        motion.segments.push(segment);
        if take(input, ",").is_none() {
            without_comma(input)?;
            break end;
        }
        if input.is_empty() {
            break end;
        }
    };
    let place = begin.to(end);
    if motion.segments.is_empty() {
        let text = "nothing is repeated; write a segment before it, as `rise 2 over 1, return over 1, repeat`";
        return Err(Message::new(place, text));
    }
    if motion.repeats && take(input, ",").is_some() && !input.is_empty() {
        let text = "`repeat` is the last word of a motion; move it behind all segments";
        return Err(Message::new(end, text));
    }
    Ok(Expr { kind: ExprKind::Motion(Box::new(motion)), place })
}

/// Complains about a segment that follows another without a comma.
fn without_comma(input: ParseStream) -> Read<()> {
    let mut words = WAYS.into_iter().chain([REPEAT]);
    let Some(word) = words.find(|word| comes_word(input, word)) else {
        return Ok(());
    };
    let text = format!("a comma stands between the segments of a motion; write `, {word}`");
    Err(Message::new(Place::at(input.span()), text))
}

fn segment(input: ParseStream) -> Read<SegmentExpr> {
    let begin = Place::at(input.span());
    let words = ["rise", "fall", "return", "dwell", REPEAT].map(|word| (word, word));
    if comes_word(input, FROM) {
        let text = "a motion begins with `from`; move it before all segments";
        return Err(Message::new(begin, text));
    }
    let (_, word) = one_of(input, "`rise`, `fall`, `return`, `dwell` or `repeat`", &words)?;
    let way = match word {
        "rise" => Way::Rise(expression(input)?),
        "fall" => Way::Fall(expression(input)?),
        "return" => Way::Return,
        _ => Way::Dwell,
    };
    let (mut span, mut law, mut end) = (None, None, begin);
    if let Way::Dwell = way {
        if !ends(input) {
            span = Some(expression(input)?);
        }
    } else {
        span = Some(over(input, word)?);
        law = with(input)?;
    }
    if let Some(span) = &span {
        end = span.place;
    }
    if let Some((word, _)) = &law {
        end = Place::at(word.span());
    }
    Ok(SegmentExpr { way, span, law: law.map(|(_, law)| law), place: begin.to(end) })
}

/// Whether nothing follows that belongs to a segment.
fn ends(input: ParseStream) -> bool {
    let cursor = input.cursor();
    let is_over = cursor.punct().is_some_and(|(sign, _)| matches!(sign.as_char(), ',' | ';'));
    is_over || cursor.eof() || comes_word(input, "in") || comes_word(input, "by")
}

/// Reads `over` and what a segment takes.
fn over(input: ParseStream, word: &str) -> Read<Expr> {
    if take_word(input, OVER).is_some() {
        return expression(input);
    }
    let example = if word == "return" { "return" } else { "rise 2" };
    let what = format!("`over` and what this takes, as `{example} over 90 deg`");
    Err(expected_message(input, &what))
}

/// Reads `with` and the name of a motion law, if it comes.
fn with(input: ParseStream) -> Read<Option<(Ident, MotionLaw)>> {
    refuse_misspelt(input, &["with", "deg", "in", "by"])?;
    if take_word(input, "with").is_none() {
        return Ok(None);
    }
    let words = MotionLaw::ALL.map(|law| (law.name(), law));
    one_of(input, "a motion law", &words).map(Some)
}
