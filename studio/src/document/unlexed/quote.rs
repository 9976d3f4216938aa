//! Quotes and comments without an end.

use super::{Body, Unlexed};
use crate::text::Replacement;
use std::ops::Range;

/// What is open at a byte: a quote or a comment.
pub(super) fn slip(body: &Body<'_>, at: usize) -> Option<Unlexed> {
    let rest = &body.text[at..];
    let (sign, what, signs) = if rest.starts_with("/*") {
        ("/*", "a comment", vec![at])
    } else if rest.starts_with('"') {
        ("\"", "a text", odd_quotes(&body.text[..line_end(body.text, at)], body.start))
    } else if rest.starts_with('\'') {
        ("'", "a letter", vec![at])
    } else {
        return None;
    };
    let first = *signs.first()?;
    let end = line_end(body.text, first);
    let removals = signs.iter().map(|&sign_at| {
        let range = sign_at..sign_at + sign.len();
        (Some(range.clone()), Replacement::new(range, ""))
    });
    let line = body.text[first..end].trim_end();
    let inside = line.strip_suffix(';').unwrap_or(line).trim_end().len();
    let (end, closing) = match sign {
        "/*" => (first + line.len(), " */"),
        sign => (first + inside, sign),
    };
    let closing = (closing != "'").then(|| Replacement::new(end..end, closing));
    let edits = removals.chain(closing.map(|closing| (None, closing)));
    let (place, text, change) = match body.best(edits) {
        Some((Some(place), change)) => (place, "; remove it".to_owned(), Some(change)),
        Some((None, change)) => {
            let close = change.text.trim();
            let before =
                if body.text[end..].starts_with(';') { "before the `;`" } else { "at the end" };
            let text = format!("; write `{close}` {before} of this line");
            (place_of(first, sign), text, Some(change))
        }
        None => (place_of(first, sign), String::new(), None),
    };
    Some(Unlexed {
        place,
        text: format!("this `{sign}` opens {what} that nothing closes{text}"),
        change,
    })
}

fn place_of(at: usize, sign: &str) -> Range<usize> {
    at..at + sign.len()
}

/// The quotes of the first line after a byte that has one too many.
fn odd_quotes(text: &str, start: usize) -> Vec<usize> {
    let mut at = start;
    for line in text[start..].split_inclusive('\n') {
        let code = line.split("//").next().unwrap_or(line);
        let quotes = code.match_indices('"').map(|(byte, _)| at + byte);
        let quotes: Vec<usize> = quotes.filter(|&quote| !text[..quote].ends_with('\\')).collect();
        if quotes.len() % 2 == 1 {
            return quotes;
        }
        at += line.len();
    }
    Vec::new()
}

/// Where the line ends in which a byte stands.
fn line_end(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |end| at + end)
}
