//! The texts of `tests/cases/messages`, and what is said about each.
//!
//! Texts stand between empty lines. `«` and `»` mark the place of a message. Below a text stand its messages in the order of their marks:
//!
//! - `//~` begins a message, `//|` continues it.
//! - `//+` begins a message whose first offer, in backquotes, is right in the place of the mark.
//! - `//=` says what is understood of a text, as `links 4, joints 0`.
//! - `//^` begins a block that stands before each of the texts below, until the next one.
//! - `//!` stands above a text that does not follow a `struct` line.
//!
//! A text without a message is right. `UPDATE_CASES=1` renews the words, never the places, nor what is understood.

use super::{Parsed, first_offer, parsed, places_of, with_offer};
use similar::TextDiff;
use std::path::{Path, PathBuf};
use std::{env, fs};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases/messages");

/// A text with marks, and the messages that are expected about it.
#[derive(Default)]
struct Case {
    text: String,
    messages: Vec<String>,
    /// The names and the counts of what is understood of it.
    counts: Vec<(String, usize)>,
    /// Whether the first offer of each message is tried.
    offers: Vec<bool>,
}

impl Case {
    /// Reads a block of lines, which follows others.
    fn read(block: &str, before: &str) -> Self {
        let mut case = Self::default();
        let mut is_whole = false;
        for line in block.lines() {
            if let Some(message) = line.strip_prefix("//~ ").or(line.strip_prefix("//+ ")) {
                case.messages.push(message.to_owned());
                case.offers.push(line.starts_with("//+"));
            } else if let Some(more) = line.strip_prefix("//|") {
                let message = case.messages.last_mut().expect("a message goes on");
                message.push('\n');
                message.push_str(more.strip_prefix(' ').unwrap_or(more));
            } else if let Some(counts) = line.strip_prefix("//= ") {
                let pairs = counts.split(", ").map(|pair| pair.rsplit_once(' '));
                case.counts.extend(pairs.map(|pair| {
                    let (what, count) = pair.expect("a name and a number");
                    (what.to_owned(), count.parse().expect("a number"))
                }));
            } else if line == "//!" {
                is_whole = true;
            } else {
                case.text += line;
                case.text.push('\n');
            }
        }
        if !is_whole {
            case.text = format!("struct M;\n{before}{}", case.text);
        }
        case
    }

    /// The block's lines of messages, with what is said now. What is wrong beyond words is the error.
    fn judge(&self) -> Result<String, String> {
        let (text, marks) = places_of(&self.text);
        let parsed = parsed(&text);
        for (what, expected) in &self.counts {
            let found = count(&parsed, what);
            if found != *expected {
                return Err(format!("{}{found} {what}, not {expected}", self.text));
            }
        }
        let errors = parsed.errors;
        let found: Vec<_> = errors.iter().map(super::place).collect();
        if found != marks {
            let said: Vec<&str> = errors.iter().map(|error| error.text.as_str()).collect();
            return Err(format!("{}marks {marks:?}, found {found:?} {said:#?}", self.text));
        }
        let mut lines = String::new();
        for (number, error) in errors.iter().enumerate() {
            let message = &error.text;
            if message.ends_with('.') || message.starts_with(char::is_uppercase) {
                return Err(format!("a message is no sentence: {message}"));
            }
            let is_tried = self.offers.get(number) == Some(&true);
            if is_tried {
                self.try_offer(message)?;
            }
            lines += if is_tried { "//+ " } else { "//~ " };
            lines += &message.replace('\n', "\n//| ").replace("//| \n", "//|\n");
            lines.push('\n');
        }
        Ok(lines)
    }

    /// Whether the text is right with the first offer of a message in the place of its mark.
    fn try_offer(&self, message: &str) -> Result<(), String> {
        let offer = first_offer(message);
        let mended = offer.and_then(|offer| with_offer(&self.text, offer));
        let mended = mended.ok_or_else(|| format!("nothing is offered: {message}"))?;
        let errors = parsed(&mended).errors;
        if errors.is_empty() { Ok(()) } else { Err(format!("{mended}: {errors:?}")) }
    }
}

/// Counts what a text has, as it is understood. Hidden joints and the ground count.
fn count(parsed: &Parsed, what: &str) -> usize {
    let Parsed { model, header, .. } = parsed;
    match what {
        "links" => model.links.len(),
        "joints" => model.joints.len(),
        "motors" => model.motors.len(),
        "motor statements" => parsed.motors,
        "axes" => model.axes.len(),
        "near" => model.start.near.len(),
        "headers" => usize::from(header.is_some()),
        "attributes" => header.as_ref().map_or(0, |header| header.attributes.len()),
        _ => panic!("nobody counts {what}"),
    }
}

/// A file's text with what is said now, how many texts it has, and what is wrong beyond words.
fn renewed(text: &str) -> (String, usize, Vec<String>) {
    let (mut blocks, mut before, mut count) = (Vec::new(), String::new(), 0);
    let mut wrong = Vec::new();
    for block in text.trim_end().split("\n\n") {
        if let Some(rest) = block.strip_prefix("//^") {
            before = format!("{}\n", rest.trim_start());
        } else if !block.lines().all(|line| line.starts_with("// ")) {
            count += 1;
            let shared = if block.starts_with("//!") { "" } else { &before };
            match Case::read(block, shared).judge() {
                Ok(messages) => {
                    let is_text = |line: &&str| {
                        !["//~", "//+", "//|"].iter().any(|mark| line.starts_with(mark))
                    };
                    let lines: Vec<&str> = block.lines().filter(is_text).collect();
                    blocks.push(format!("{}\n{messages}", lines.join("\n")).trim_end().to_owned());
                    continue;
                }
                Err(error) => wrong.push(error),
            }
        }
        blocks.push(block.to_owned());
    }
    (blocks.join("\n\n") + "\n", count, wrong)
}

#[test]
fn every_message_stands_at_its_mark() {
    let files = fs::read_dir(FOLDER).expect("the folder of the cases");
    let mut files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    files.sort();
    let (mut count, mut wrong) = (0, Vec::new());
    for file in &files {
        let text = fs::read_to_string(file).expect("a text");
        let (now, texts, errors) = renewed(&text);
        count += texts;
        let name = Path::new(file.file_name().expect("a name")).display();
        wrong.extend(errors.into_iter().map(|error| format!("{name}: {error}")));
        if now != text && env::var_os("UPDATE_CASES").is_some() {
            fs::write(file, now).expect("a file");
        } else if now != text {
            let changes = TextDiff::from_lines(&text, &now);
            wrong.push(format!("{name}:\n{}", changes.unified_diff()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // As many as there were when this was written: none is lost by a slip of the format.
    assert!(count >= 597, "{count}");
}
