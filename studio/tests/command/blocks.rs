//! Data of tests in blocks: a line that begins with a mark, and the lines below it up to the next.

use similar::TextDiff;
use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;
use std::{env, fs, thread};

const MARKS: [&str; 9] = ["##", "---", "$", ">", "|", "!", "=", "-", "+"];

/// A line with a mark, and what stands below it.
#[derive(Debug)]
pub(crate) struct Block<'a> {
    pub(crate) mark: &'a str,
    pub(crate) head: &'a str,
    below: Vec<&'a str>,
}

impl Block<'_> {
    /// The lines below, as the text of a file.
    pub(crate) fn body(&self) -> String {
        self.below.iter().map(|line| format!("{line}\n")).collect()
    }
}

impl Display for Block<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let line = format!("{} {}", self.mark, self.head);
        writeln!(f, "{}", line.trim_end())?;
        f.write_str(&self.body())
    }
}

/// The blocks of a text. Empty lines at the end of each do not count.
pub(crate) fn blocks(text: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    for line in text.lines() {
        let (mark, head) = line.split_once(' ').unwrap_or((line, ""));
        if MARKS.contains(&mark) {
            let below = Vec::new();
            blocks.push(Block { mark, head, below });
        } else {
            let last = blocks.last_mut().expect("a mark in the first line");
            last.below.push(line);
        }
    }
    for block in &mut blocks {
        while block.below.last() == Some(&"") {
            block.below.pop();
        }
        let is_line = !["##", "---"].contains(&block.mark);
        assert!(!is_line || block.below.is_empty(), "no mark: {block}");
    }
    blocks
}

/// The lines of a text behind a mark. What has no end is told.
pub(crate) fn marked(mark: &str, text: &str) -> Vec<String> {
    let unended =
        Some("(the last line does not end)").filter(|_| !text.is_empty() && !text.ends_with('\n'));
    let lines = text.lines().chain(unended);
    lines.map(|line| format!("{mark}{line}").trim_end().to_owned()).collect()
}

/// Whether lines are as they are told: `…` stands for the rest of a line, and alone behind its mark for any number of lines.
pub(crate) fn are_as_told(lines: &[String], told: &[String]) -> bool {
    let Some((first, later)) = told.split_first() else {
        return lines.is_empty();
    };
    let start = first.strip_suffix('…');
    let is_any = start.is_some_and(|start| start.len() <= 2);
    if is_any && are_as_told(lines, later) {
        return true;
    }
    let Some((line, others)) = lines.split_first() else {
        return false;
    };
    let is_next = start.map_or(line == first, |start| line.starts_with(start.trim_end()));
    is_next && are_as_told(others, if is_any { told } else { later })
}

/// Holds the files of a folder of `tests/cases` against what is found now; `UPDATE_CASES=1` renews them. There are at least so many cases.
pub(crate) fn walk(folder: &str, renewed: fn(&str) -> String, least: usize) {
    let folder = crate::run::repository("tests/cases").join(folder);
    let files = fs::read_dir(folder).expect("the folder of the cases");
    let mut files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    files.sort();
    let texts = files.iter().map(|file| fs::read_to_string(file).expect("a text"));
    let texts: Vec<String> = texts.collect();
    let found: Vec<String> = thread::scope(|scope| {
        let walks = texts.iter().map(|text| scope.spawn(|| renewed(text)));
        let walks: Vec<_> = walks.collect();
        let found = walks.into_iter().map(|walk| walk.join().expect("cases that can be read"));
        found.collect()
    });
    let (mut wrong, mut count) = (String::new(), 0);
    for ((file, text), now) in files.iter().zip(&texts).zip(&found) {
        count +=
            text.lines().filter(|line| line.starts_with("$ ") || line.starts_with("> ")).count();
        if now != text && env::var_os("UPDATE_CASES").is_some() {
            fs::write(file, now).expect("a file");
        } else if now != text {
            let changes = TextDiff::from_lines(text, now);
            wrong += &format!("{}:\n{}", file.display(), changes.unified_diff());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    // As many as there were when this was written: none is lost by a slip of the format.
    assert!(count >= least, "{count}");
}
