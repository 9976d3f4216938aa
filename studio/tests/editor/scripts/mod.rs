//! Gesture scripts: what somebody does, line by line, and what is so then.
//!
//! Each `.txt` of this folder is walked. A line that begins with `==` is the title of a case, one with `//` a comment. Any other line is a verb
//! with its arguments: words, `"quoted ones"`, and places as `(1, 2)`. A verb is what somebody does (`gestures.rs`) or a judge of what is so then
//! (`judges.rs`).
//! Indented lines are the block of text of the line above.
//!
//! - `not` before a judge: it does not hold. `until` before one: it does after a while.
//! - A text is a block, a quoted word, a `.mech` beside the scripts, or one that was noted. `start` is noted when somebody begins.
//!   `with "old" "new"` replaces words of it.
//! - `for FROM TO` as the first line: the case is run once with each line of the block, split at `|`, in the place of these words.
//! - `FOLDER` is a folder of the case's own, in which stands `crank.mech`.
//!
//! `UPDATE_CASES=1` renews the blocks of `is`, which are what the text is then, and nothing else. `MECH_SCRIPT=dead_ends` walks one file alone.

mod gestures;
mod judges;
mod words;

use crate::folder::Folder;
use crate::user::User;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::{env, fs, thread};
use words::{Word, Words};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/editor/scripts");

/// Where texts are looked for by their names.
const TEXTS: [&str; 3] = ["", "../../samples", "../../../../examples/gallery/src/mechanisms"];

/// The verbs of lines that may have a block.
const WITH_BLOCK: [&str; 7] = ["text", "file", "retype", "write-file", "is", "on-disk", "at-once"];

struct Line {
    number: usize,
    text: String,
    block: Option<String>,
}

impl Line {
    fn all_of(script: &str) -> Result<Vec<Self>, String> {
        let mut lines: Vec<Self> = Vec::new();
        for (number, line) in (1..).zip(script.lines()) {
            if let Some(more) = line.strip_prefix("    ") {
                let of = lines.last_mut().ok_or("a block is of no line")?;
                let block = of.block.get_or_insert_default();
                *block += more;
                block.push('\n');
            } else if !line.is_empty() && !line.starts_with("//") {
                lines.push(Self { number, text: line.to_owned(), block: None });
            }
        }
        Ok(lines)
    }

    /// With what stands in the columns of a run in the place of their names.
    fn with(&self, columns: &[(&str, &str)]) -> Self {
        let fill = |text: &str| {
            let fill = |text: String, (name, value): &(&str, &str)| text.replace(name, value);
            columns.iter().fold(text.to_owned(), fill)
        };
        Self { number: self.number, text: fill(&self.text), block: self.block.as_deref().map(fill) }
    }
}

/// Texts by their names, and a folder of files.
struct Texts {
    noted: BTreeMap<String, String>,
    folder: Folder,
}

impl Texts {
    /// A text that a line names or shows.
    fn take(&self, words: &mut Words<'_>) -> Result<String, String> {
        let mut text = match words.block {
            Some(block) => block.to_owned(),
            None => self.named(words.word()?)?,
        };
        if words.takes("with") {
            for [old, new] in words.all(|words| Ok([words.text()?, words.text()?]))? {
                if !text.contains(&old) {
                    return Err(format!("{old:?} is not in {text}"));
                }
                text = text.replace(&old, &new);
            }
        }
        Ok(text)
    }

    fn named(&self, word: Word) -> Result<String, String> {
        let name = match word {
            Word::Quoted(text) => return Ok(text),
            Word::Name(name) => name,
            other @ Word::Place(_) => return Err(format!("{other:?} is no text")),
        };
        let read =
            |folder: &&str| fs::read_to_string(Path::new(FOLDER).join(folder).join(&name)).ok();
        let noted = self.noted.get(&name).cloned();
        let found = noted.or_else(|| TEXTS.iter().find_map(read));
        found.ok_or_else(|| format!("there is no text {name}"))
    }
}

struct Scene {
    user: Option<User>,
    texts: Texts,
    /// The number of judges so far.
    judged: usize,
    /// The renewed blocks, by the numbers of their lines.
    renewed: BTreeMap<usize, String>,
}

impl Scene {
    fn new() -> Self {
        Self {
            user: None,
            texts: Texts { noted: BTreeMap::new(), folder: Folder::new() },
            judged: 0,
            renewed: BTreeMap::new(),
        }
    }

    /// Does what a line says, or judges it.
    fn perform(&mut self, line: &Line) -> Result<(), String> {
        let done = catch_unwind(AssertUnwindSafe(|| {
            let folder = self.texts.folder.0.display().to_string();
            let words = Words::of(&line.text.replace("FOLDER", &folder), line.block.as_deref())?;
            let mut rest = words.clone();
            let verb = rest.text()?;
            if line.block.is_some() && !WITH_BLOCK.contains(&&*verb) {
                return Err(format!("{verb} has no block"));
            }
            if self.does(&verb, &mut rest)? {
                return rest.end();
            }
            self.judged += 1;
            self.judge(words, line)
        }));
        done.unwrap_or_else(|panic| {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
            Err(text.unwrap_or_default())
        })
    }
}

/// The results of the cases of a script.
#[derive(Default)]
struct Walk {
    wrong: Vec<String>,
    renewed: BTreeMap<usize, String>,
    count: usize,
}

impl Walk {
    fn case(&mut self, name: &str, lines: &[Line]) -> Result<(), String> {
        let [title, steps @ ..] = lines else {
            return Ok(());
        };
        let Some(words) = title.text.strip_prefix("== ") else {
            return Err(format!("{name}:{}: a title is missing", title.number));
        };
        let (columns, rows, steps) = match steps {
            [first, rest @ ..] if first.text.starts_with("for ") => {
                let rows = first.block.as_deref().unwrap_or_default();
                (&first.text[4..], rows.lines().collect(), rest)
            }
            _ => ("", vec![""], steps),
        };
        for row in rows {
            let (columns, values) = (columns.split_whitespace(), row.split(" | "));
            if columns.clone().count() != values.clone().count() && !row.is_empty() {
                return Err(format!("{name}:{}: not as many columns: {row}", title.number));
            }
            let columns: Vec<_> = columns.zip(values).collect();
            let mut scene = Scene::new();
            let mut steps = steps.iter().map(|step| step.with(&columns));
            let wrong = steps.find_map(|step| Some((scene.perform(&step).err()?, step)));
            if let Some((wrong, step)) = wrong {
                let Line { number, text, .. } = step;
                self.wrong.push(format!("{name}:{number}: {words}\n{text}\n{wrong}"));
            } else if scene.judged == 0 {
                self.wrong.push(format!("{name}:{}: nothing is judged", title.number));
            }
            self.count += 1;
            self.renewed.append(&mut scene.renewed);
        }
        Ok(())
    }

    /// The script with its blocks as they would be.
    fn script(&self, before: &str) -> String {
        let (mut script, mut is_renewed) = (String::new(), false);
        for (number, line) in (1..).zip(before.lines()) {
            if is_renewed && line.starts_with("    ") {
                continue;
            }
            script += &format!("{line}\n");
            let block = self.renewed.get(&number);
            is_renewed = block.is_some();
            for line in block.into_iter().flat_map(|block| block.lines()) {
                script += &format!("    {line}\n");
            }
        }
        script
    }
}

fn walk(file: &Path) -> Walk {
    let name = format!("{}", file.file_name().expect("a name").display());
    let script = fs::read_to_string(file).expect("a script");
    let mut walk = Walk::default();
    let lines = Line::all_of(&script).expect(&name);
    for case in lines.chunk_by(|_, next| !next.text.starts_with("== ")) {
        let case = walk.case(&name, case);
        walk.wrong.extend(case.err());
    }
    if !walk.renewed.is_empty() && env::var_os("UPDATE_CASES").is_some() {
        fs::write(file, walk.script(&script)).expect("a script");
    }
    walk
}

#[test]
fn every_script_goes_as_it_says() {
    let files = fs::read_dir(FOLDER).expect("the folder of the scripts");
    let mut files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    let one = env::var("MECH_SCRIPT").ok();
    files.retain(|file| {
        let is_meant = one.as_deref().is_none_or(|one| file.ends_with(format!("{one}.txt")));
        is_meant && file.extension() == Some("txt".as_ref())
    });
    assert!(!files.is_empty(), "there is no script {one:?}");
    let walks: Vec<Walk> = thread::scope(|scope| {
        let walks: Vec<_> = files.iter().map(|file| scope.spawn(|| walk(file))).collect();
        let walks = walks.into_iter().map(|walk| walk.join().expect("a walk"));
        walks.collect()
    });
    let wrong = walks.iter().flat_map(|walk| &walk.wrong);
    let wrong: Vec<&str> = wrong.map(String::as_str).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    // As many as there were when this was written: none is lost by a slip of the format.
    let count: usize = walks.iter().map(|walk| walk.count).sum();
    assert!(one.is_some() || count >= 125, "{count}");
}
