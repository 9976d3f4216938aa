//! Verdicts for editors.

use super::Verdict;
use crate::document::{self, Source};
use crate::edit::differences;
use crate::mend::{Mending, Remainder};
use crate::text::Replacement;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Range;

#[derive(Serialize)]
struct Report<'a> {
    file: String,
    moves: bool,
    mechanisms: Vec<Mechanism<'a>>,
}

#[derive(Serialize)]
struct Mechanism<'a> {
    /// Null of parts, and where the name cannot be read.
    name: Option<&'a str>,
    moves: bool,
    place: Place,
    /// How far each motor goes, if it moves.
    motors: &'a [String],
    messages: Vec<Message<'a>>,
    /// The repairs that compile, the likeliest first.
    repairs: Vec<Repair<'a>>,
    /// The places where it breaks what is expected of it.
    witnesses: Vec<Witness<'a>>,
}

#[derive(Serialize)]
struct Witness<'a> {
    expect: &'a str,
    /// The motors' values, as `--at` takes them.
    at: BTreeMap<&'a str, f64>,
    /// When it comes there, if motors follow laws.
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<f64>,
    value: f64,
}

#[derive(Serialize)]
struct Repair<'a> {
    text: &'a str,
    /// The work that remains after it: `nothing`, `other start` or `other faults`.
    remainder: &'static str,
    /// The replacements that make it, in the order of their places.
    edits: Vec<Edit>,
}

#[derive(Serialize)]
struct Edit {
    place: Place,
    text: String,
}

#[derive(Serialize)]
struct Message<'a> {
    level: &'static str,
    text: &'a str,
    /// The lines after the first, without their words `note:` and `help:`.
    notes: Vec<Note<'a>>,
    place: Place,
}

#[derive(Serialize)]
struct Note<'a> {
    level: &'static str,
    text: &'a str,
}

#[derive(Serialize)]
struct Place {
    /// In bytes from the beginning of the file.
    start: usize,
    end: usize,
    from: Spot,
    to: Spot,
}

#[derive(Serialize)]
struct Spot {
    line: usize,
    column: usize,
}

/// The verdicts as an object in JSON, with a newline.
pub(crate) fn to_json(source: &Source, verdicts: &[Verdict]) -> String {
    let mechanisms: Vec<Mechanism<'_>> = verdicts
        .iter()
        .map(|verdict| match verdict {
            Verdict::Moves { name, place, motors, notes, .. } => Mechanism {
                name: Some(name),
                moves: true,
                place: in_file(source, place),
                motors,
                messages: notes.iter().map(|text| note(source, text, place)).collect(),
                repairs: Vec::new(),
                witnesses: Vec::new(),
            },
            Verdict::Faulty { name, place, messages, repairs, witnesses } => Mechanism {
                name: name.as_deref(),
                moves: false,
                place: in_file(source, place),
                motors: &[],
                messages: messages.iter().map(|one| message(source, one)).collect(),
                repairs: repairs.iter().map(|one| repair(source, one)).collect(),
                witnesses: witnesses.iter().map(witness).collect(),
            },
        })
        .collect();
    let report = Report {
        file: source.path().to_string_lossy().into_owned(),
        moves: mechanisms.iter().all(|mechanism| mechanism.moves),
        mechanisms,
    };
    // Strings and numbers can always be written.
    serde_json::to_string_pretty(&report).unwrap_or_default() + "\n"
}

fn message<'a>(source: &Source, message: &'a document::Message) -> Message<'a> {
    let mut lines = message.text.lines();
    let text = lines.next().unwrap_or_default();
    let note = |line: &'a str| {
        let (level, text) = line.split_once(": ")?;
        let level = match level {
            "note" => "note",
            "help" => "help",
            _ => return None,
        };
        Some(Note { level, text })
    };
    Message {
        level: "error",
        text,
        notes: lines.filter_map(note).collect(),
        place: in_file(source, &message.place),
    }
}

fn note<'a>(source: &Source, text: &'a str, place: &Range<usize>) -> Message<'a> {
    Message { level: "note", text, notes: Vec::new(), place: in_file(source, place) }
}

fn witness(found: &super::Witness) -> Witness<'_> {
    let at = found.at.iter();
    Witness {
        expect: &found.expect,
        at: at.map(|(name, value)| (&**name, *value)).collect(),
        time: found.time,
        value: found.value,
    }
}

fn repair<'a>(source: &Source, mending: &'a Mending) -> Repair<'a> {
    let edits = differences(source.text(), &mending.text).into_iter();
    let edits =
        edits.map(|Replacement { range, text }| Edit { place: in_file(source, &range), text });
    Repair {
        text: &mending.words,
        remainder: match mending.remainder {
            Remainder::Nothing => "nothing",
            Remainder::OtherStart => "other start",
            Remainder::OtherFaults => "other faults",
        },
        edits: edits.collect(),
    }
}

fn in_file(source: &Source, range: &Range<usize>) -> Place {
    let spot = |byte| {
        let document::Spot { line, column } = source.spot(byte);
        Spot { line, column }
    };
    Place { start: range.start, end: range.end, from: spot(range.start), to: spot(range.end) }
}
