//! The correct texts of the project.

use crate::run::repository;
use mech_compiler::model::Model;
use mech_studio::{Document, Reading, Source};
use std::fs;
use std::path::Path;

/// A text that moves, and its mechanism.
pub(super) struct Correct {
    pub(super) text: String,
    pub(super) model: Model,
}

/// Reads a mechanism of a file of its own.
pub(super) fn analyse(text: &str) -> (Document, Reading) {
    let document = Document::of(Source::new("a.mech", text));
    let reading = document.analyse(&document.declarations()[0]);
    let reading = reading.unwrap_or_else(|failure| panic!("{failure:?}\n{text}"));
    (document, reading)
}

pub(super) fn read() -> Vec<Correct> {
    const FOLDERS: [&str; 5] = [
        "docs",
        "examples",
        "studio/src/editor/example",
        "tests/cases",
        "tests/tests/subjects/zoo",
    ];
    let mut found = Vec::new();
    for folder in FOLDERS {
        collect(&repository(folder), &mut found);
    }
    found.sort();
    found.dedup();
    let correct = found.into_iter().filter_map(|text| {
        let Reading { model, result, .. } = analyse(&text).1;
        result.is_ok().then_some(Correct { text, model })
    });
    correct.collect()
}

fn collect(path: &Path, found: &mut Vec<String>) {
    if path.is_dir() {
        let entries = fs::read_dir(path).expect("a folder");
        entries.for_each(|entry| collect(&entry.expect("an entry").path(), found));
        return;
    }
    let end = path.extension().and_then(|end| end.to_str()).unwrap_or("");
    if !["md", "mech", "rs"].contains(&end) {
        return;
    }
    let text = fs::read_to_string(path).expect("a text");
    let own = |part: &str| part.to_owned() + "\n";
    match end {
        "md" => {
            let blocks = text.split("```text\n").skip(1);
            found.extend(blocks.filter_map(|one| Some(own(one.split_once("```")?.0))));
        }
        "mech" if text.matches("struct ").count() > 1 => {
            found.extend(text.split("\n\n").map(own));
        }
        "mech" => found.push(text),
        _ => {
            let document = Document::of(Source::new(path, &*text));
            let bodies = document.declarations().iter();
            found.extend(bodies.filter_map(|one| Some(own(&text[one.body.clone()?]))));
        }
    }
    found.retain(|one| one.contains("struct "));
}
