//! Reads a line by the table of what can be said.

use super::pattern::{Element, Misfit, What, fit, read, shown};
use super::request::{Request, Row, Taken};
use super::table::ROWS;
use super::words::{Word, words};
use crate::failure::Failure;

/// Reads the request of a line; nothing if the line is empty or a comment.
pub(crate) fn request(line: &str) -> Result<Option<Request>, Failure> {
    let line = without_comment(line).trim();
    if line.is_empty() {
        return Ok(None);
    }
    let found = words(line)?;
    let mut misfits: Vec<(&Row, Misfit)> = Vec::new();
    for row in ROWS {
        match fit(&read(row.pattern), line, &found) {
            Ok(found) => return (row.request)(Taken(found)).map(Some),
            Err(misfit) => misfits.push((row, misfit)),
        }
    }
    Err(Failure::usage(complaint(line, &found, &misfits)))
}

/// A line up to its comment, which begins with `#`.
fn without_comment(line: &str) -> &str {
    let mut is_quoted = false;
    let comment = line.find(|letter: char| {
        is_quoted ^= letter == '"';
        letter == '#' && !is_quoted
    });
    &line[..comment.unwrap_or(line.len())]
}

/// Why no row fits a line.
fn complaint(line: &str, words: &[Word], misfits: &[(&Row, Misfit)]) -> String {
    let farthest = misfits.iter().map(|(_, misfit)| misfit.at).max().unwrap_or(0);
    let first = words.first().map_or("", |word| word.of(line));
    if farthest == 0 {
        return match nearest(first) {
            Some(near) => format!("unknown command `{first}`; did you mean `{near}`?"),
            None => format!("unknown command `{first}`; `help` lists all"),
        };
    }
    let nearest = misfits.iter().filter(|(_, misfit)| misfit.at == farthest);
    let nearest: Vec<&(&Row, Misfit)> = nearest.collect();
    let mut wants: Vec<String> = Vec::new();
    for want in nearest.iter().flat_map(|(_, misfit)| &misfit.wants) {
        let want = in_words(want);
        if !wants.contains(&want) {
            wants.push(want);
        }
    }
    let wanted =
        if wants.is_empty() { "the end of the line".to_owned() } else { wants.join(" or ") };
    let found = match words.get(farthest) {
        Some(word) => format!(", found `{}`", word.of(line)),
        None => String::new(),
    };
    let patterns: Vec<String> =
        nearest.iter().map(|(row, _)| format!("`{}`", shown(&read(row.pattern)))).collect();
    format!("expected {wanted}{found}; say {}", patterns.join(" or "))
}

fn in_words(element: &Element) -> String {
    match element {
        Element::Word(word) => format!("`{word}`"),
        Element::Optional(inner) => inner.first().map(in_words).unwrap_or_default(),
        Element::Slot { what, .. } => match what {
            What::New => "a name".to_owned(),
            What::Link => "a link".to_owned(),
            What::Joint => "a joint".to_owned(),
            What::End => "a point, a line or a link".to_owned(),
            What::Any => "the name of something".to_owned(),
            What::Value => "a number".to_owned(),
            What::Number => "a number that counts".to_owned(),
            What::Place => "a place as `(1, 2)`".to_owned(),
            What::One(words) => {
                let words: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
                words.join(" or ")
            }
            What::Rest => "more".to_owned(),
        },
    }
}

/// The words with which lines may begin.
pub(super) fn beginnings() -> Vec<&'static str> {
    let mut all = Vec::new();
    for row in ROWS {
        match read(row.pattern).into_iter().next() {
            Some(Element::Word(word)) => all.push(word),
            Some(Element::Slot { what: What::One(words), .. }) => all.extend(words),
            _ => {}
        }
    }
    all.dedup();
    all
}

/// The beginning that is most like a word.
fn nearest(word: &str) -> Option<&'static str> {
    // No word that can be said is half as long, and to compare a long one takes for ever.
    if word.len() > 64 {
        return None;
    }
    let likeness = |known: &str| similar::TextDiff::from_chars(known, word).ratio();
    let all = beginnings().into_iter().map(|known| (likeness(known), known));
    let best = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (best.0 > 0.6).then_some(best.1)
}

/// The help: all rows, or those that begin with a word.
pub(crate) fn help(topic: Option<&str>) -> Result<String, Failure> {
    let rows = ROWS.iter().map(|row| (shown(&read(row.pattern)), row.help));
    let is_asked = |pattern: &str| {
        let first = pattern.split_whitespace().next().unwrap_or_default();
        topic.is_none_or(|topic| first.split('|').any(|word| word == topic))
    };
    let rows: Vec<_> = rows.filter(|(pattern, _)| is_asked(pattern)).collect();
    if rows.is_empty() {
        let topic = topic.unwrap_or_default();
        return Err(Failure::usage(format!("there is no command `{topic}`; `help` lists all")));
    }
    Ok(rows.iter().map(|(pattern, help)| format!("{pattern}\n    {help}\n")).collect())
}
