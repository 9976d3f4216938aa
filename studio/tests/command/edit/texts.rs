//! The edits of `tests/cases/edits`: lines of the dialogue, and what they change.
//!
//! - `---` begins the text of the cases below; `--- @named` is [`NAMED`]. `## ` is a title.
//! - Lines of `> ` are said one after the other.
//! - Then follows what they change in all: `- ` a line that goes, `+ ` one that comes. `= ` is the line above one that only comes.
//! - `| ` is what is answered; that it moves is left out. `! ` is why the last line is refused.
//!
//! Undoing all gives the very text, and what is refused writes nothing. `UPDATE_CASES=1` renews what follows the lines.

use super::NAMED;
use crate::blocks::{blocks, marked, walk};
use crate::run::Folder;
use similar::{ChangeTag, TextDiff};

/// The lines that a text loses and gets.
fn changes(text: &str, now: &str) -> Vec<String> {
    let (mut lines, mut above) = (Vec::new(), None);
    for change in TextDiff::from_lines(text, now).iter_all_changes() {
        let line = change.value();
        let mark = match change.tag() {
            ChangeTag::Equal => {
                above = Some(line);
                continue;
            }
            ChangeTag::Delete => "- ",
            ChangeTag::Insert => "+ ",
        };
        let is_delete = change.tag() == ChangeTag::Delete;
        let above = above.take().filter(|_| !is_delete);
        lines.extend(above.map_or_else(Vec::new, |line| marked("= ", line)));
        lines.extend(marked(mark, line));
    }
    lines
}

/// Says lines about a text, and returns the changes and answers to be told.
fn said(text: &str, lines: &[&str]) -> Vec<String> {
    let undo = "undo\n".repeat(lines.len());
    let lines = lines.join("\n");
    let script = format!("open a.mech\n{lines}\nsave b.mech\n{undo}save c.mech\n");
    let folder = Folder::new().with("a.mech", text);
    let folder = folder.with("script.txt", script);
    let answer = folder.mech("run script.txt");
    assert_eq!(folder.text("a.mech"), text);
    if answer.code != Some(0) {
        assert_eq!(folder.names(), ["a.mech", "script.txt"]);
        let why = answer.err.splitn(3, ": ").nth(2);
        return marked("! ", why.expect("a line, and why"));
    }
    assert_eq!(folder.text("c.mech"), text, "{lines}");
    let answered = marked("| ", &answer.out).into_iter();
    let answered = answered.filter(|line| {
        let is_ours = line.starts_with("| undone: ") || line.starts_with("| saved ");
        !is_ours && !line.contains(" moves: ")
    });
    let mut lines = changes(text, &folder.text("b.mech"));
    lines.extend(answered);
    lines
}

/// A file of cases with what is said now.
fn renewed(file: &str) -> String {
    let (mut text, mut now) = (String::new(), String::new());
    let blocks = blocks(file);
    for cases in blocks.chunk_by(|one, next| one.mark == next.mark || next.mark != ">") {
        let lines = cases.iter().filter(|block| block.mark == ">");
        let lines: Vec<&str> = lines.map(|block| block.head).collect();
        now.extend(lines.iter().map(|line| format!("> {line}\n")));
        if !lines.is_empty() {
            now.extend(said(&text, &lines).iter().map(|line| format!("{line}\n")));
        }
        for block in cases.iter().filter(|block| ["##", "---"].contains(&block.mark)) {
            now += if now.is_empty() { "" } else { "\n" };
            now += &block.to_string();
            if block.mark == "---" {
                text = if block.head == "@named" { NAMED.to_owned() } else { block.body() };
            }
        }
    }
    now
}

#[test]
fn lines_change_what_is_told() {
    walk("edits", renewed, 93);
}
