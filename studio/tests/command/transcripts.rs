//! The transcripts of `tests/cases/commands`: what `mech` answers, refuses and writes.
//!
//! A case is a folder. `## ` and a title begin it:
//!
//! - `--- a.mech` begins a file's text. `--- a.mech @four_bar` has a text of [`shared`]; `--- @crank` is another one, for the cases below.
//! - `$ mech check a.mech` is run. Each line of `> ` is a line of its input.
//! - Then follows what it said: `| ` what it answered, `! ` what it complained of, `= 1` its exit code unless that is 0. Files that it wrote
//!   follow as `---`, pictures by the bytes that they begin with.
//!
//! Files that are not told stay as they were, and no others appear. [`are_as_told`] explains `…`. `UPDATE_CASES=1` renews those words that
//! are not as told.

use crate::blocks::{Block, are_as_told, blocks, marked, walk};
use crate::run::{FOUR_BAR, Folder, mech_said, repository, rust};
use std::collections::BTreeMap;
use std::fs;

/// Texts by their names.
type Texts = BTreeMap<String, String>;

/// Texts that all files of cases share: two that are often needed, and the documents of Linkage in `studio/tests/samples`.
fn shared() -> Texts {
    let files = fs::read_dir(repository("studio/tests/samples")).expect("samples");
    let samples = files.map(|file| {
        let path = file.expect("a file").path();
        let name = path.file_name().expect("a name").display().to_string();
        (name, fs::read_to_string(path).expect("a text"))
    });
    let ours = [("four_bar", FOUR_BAR.to_owned()), ("two", rust())];
    let ours = ours.map(|(name, text)| (name.to_owned(), text));
    samples.chain(ours).collect()
}

/// The words of a line. Those between quotes are one.
fn words(line: &str) -> Vec<&str> {
    let parts = line.split('"').enumerate();
    let words = parts.map(|(number, part)| match number % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    words.collect::<Vec<_>>().concat()
}

fn files(folder: &Folder) -> BTreeMap<String, Vec<u8>> {
    let names = folder.names().into_iter();
    let files = names.map(|name| {
        let bytes = fs::read(folder.path(&name)).expect("a file");
        (name, bytes)
    });
    files.collect()
}

/// A file as it is told: a text, one that is shared, or the bytes that a picture begins with.
fn told_file(name: &str, bytes: Vec<u8>, shared: &Texts) -> Vec<String> {
    let picture = format!("{}\n", bytes[..bytes.len().min(6)].escape_ascii());
    let text = String::from_utf8(bytes).ok();
    let text = text.filter(|text| !text.starts_with("<svg"));
    let text = text.unwrap_or(picture);
    let known = shared.iter().find(|(_, known)| **known == text);
    match known {
        Some((known, _)) => vec![format!("--- {name} @{known}")],
        None => [vec![format!("--- {name}")], marked("", &text)].concat(),
    }
}

/// Runs a line, and returns what it says now.
fn said(folder: &Folder, line: &str, input: &str, shared: &Texts) -> Vec<String> {
    let words = words(line);
    let (first, words) = words.split_first().expect("a command");
    assert_eq!(*first, "mech");
    let before = files(folder);
    let answer = mech_said(&folder.path(""), words, input);
    let mut lines = marked("| ", &answer.out);
    lines.extend(marked("! ", &answer.err));
    if answer.code != Some(0) {
        lines.push(format!("= {}", answer.code.expect("it ends by itself")));
    }
    let written = files(folder).into_iter();
    let written = written.filter(|(name, bytes)| before.get(name) != Some(bytes));
    lines.extend(written.flat_map(|(name, bytes)| told_file(&name, bytes, shared)));
    lines
}

/// A file of cases with what is said now.
fn renewed(text: &str) -> String {
    let (mut shared, mut folder, mut now) = (shared(), Folder::new(), String::new());
    let all = blocks(text);
    let mut rest = &all[..];
    while let Some((block, after)) = rest.split_first() {
        rest = after;
        let is_text = block.head.starts_with('@');
        let is_apart = !now.is_empty() && (block.mark == "##" || is_text);
        now += if is_apart { "\n" } else { "" };
        now += &block.to_string();
        match block.mark {
            "##" => folder = Folder::new(),
            "---" if is_text => {
                shared.insert(block.head[1..].to_owned(), block.body());
            }
            "---" => {
                let (name, text) = match block.head.split_once(" @") {
                    Some((name, known)) => (name, shared[known].clone()),
                    None => (block.head, block.body()),
                };
                folder = folder.with(name, text);
            }
            "$" => {
                let inputs = rest.iter().take_while(|block| block.mark == ">");
                let (input, after) = rest.split_at(inputs.count());
                let is_told = |block: &&Block<'_>| !["##", "$"].contains(&block.mark);
                let (told, after) = after.split_at(after.iter().take_while(is_told).count());
                rest = after;
                now.extend(input.iter().map(ToString::to_string));
                let lines = input.iter().map(|block| format!("{}\n", block.head));
                let found = said(&folder, block.head, &lines.collect::<String>(), &shared);
                let told: String = told.iter().map(ToString::to_string).collect();
                let told = marked("", &told);
                let lines = if are_as_told(&found, &told) { told } else { found };
                now.extend(lines.iter().map(|line| format!("{line}\n")));
            }
            _ => panic!("out of place: {block}"),
        }
    }
    now
}

#[test]
fn commands_say_and_write_what_is_told() {
    walk("commands", renewed, 297 + 69);
}
