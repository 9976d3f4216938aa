//! `mech play`.

use super::CODES;
use super::picture::kind_of;
use super::target::{Replacing, coherent};
use crate::console::Console;
use crate::document::{Declaration, Document, Source};
use crate::failure::{Failure, FailureKind};
use crate::job::Analysed;
use crate::output::{Output, OutputKind, Writer};
use crate::play::{Control, Mechanism, Player, SIZE, Stage, keys, terminal};
use clap::Args;
use std::io::{self, IsTerminal};
use std::path::PathBuf;

/// Plays mechanisms in a window, or in a terminal.
///
/// Links follow the pointer that drags them. Motors go through their declared ranges, or round, or as far as the mechanism lets them, one after the other. Motors with laws follow these.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = long_help())]
pub(super) struct Play {
    /// Rust files with `mechanism!` in them, or files `.mech` with the inside of one. Of several files, those without a mechanism are left out.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The mechanism, where there are several: the name of its type. Without, all of them, one after the other.
    #[arg(short, long, value_name = "NAME")]
    mechanism: Option<String>,
    /// Plays in the terminal.
    #[arg(long, conflicts_with = "picture")]
    terminal: bool,
    /// Writes what is seen as a PNG file, and plays no further.
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
    #[command(flatten)]
    replacing: Replacing,
    /// How long it has played by then, 0 to 3600.
    #[arg(long, value_name = "SECONDS", default_value = "0", requires = "picture", value_parser = read_seconds)]
    after: f64,
    /// Paints on dark ground.
    #[arg(long)]
    night: bool,
    /// A text that stands for those of the files.
    #[arg(skip)]
    given: Option<Document>,
}

const EXAMPLES: &str = "\
Examples:
  mech play four_bar.mech
  mech play src/main.rs --mechanism FourBar --terminal
  mech play legs.rs wings.rs --picture seen.png --after 1.5";

fn long_help() -> String {
    let keys: Vec<String> = keys::help().iter().map(|key| format!("  {key}")).collect();
    format!("{EXAMPLES}\n\nKeys:\n{}\n\n{CODES}", keys.join("\n"))
}

fn read_seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if (0.0..=3600.0).contains(&seconds) => Ok(seconds),
        _ => Err(format!("`{text}` is not a number of seconds from 0 to 3600")),
    }
}

impl Play {
    /// Gives the text itself, and the number of the mechanism in it.
    pub(super) fn give(&mut self, document: Document, index: usize) {
        let declaration = document.declarations().get(index);
        self.mechanism = declaration.and_then(|declaration| declaration.name.clone());
        self.given = Some(document);
    }

    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let mut mechanisms = self.mechanisms(console)?.into_iter();
        let first = mechanisms.next();
        let first = first.ok_or_else(|| Failure::internal("there is nothing to play"))?;
        let mut player = Player::new(first, mechanisms.collect(), SIZE);
        if self.night {
            player.obey(Control::DayOrNight);
        }
        let mut stage = Stage::new(player, PathBuf::new())?;
        match &self.picture {
            Some(path) => {
                kind_of(path, &[("png", ())])?;
                stage.wait(self.after);
                let output = Output::new(path, OutputKind::Png, stage.png()?);
                let output = output.over(self.replacing.over_its_kind());
                writer.write(match &self.given {
                    Some(document) => output.from([document.source().path()]),
                    None => output.from(&self.files),
                })
            }
            None if self.terminal => in_terminal(stage),
            None => in_window(stage),
        }
    }

    /// All mechanisms that are to be played; one at least. What is wrong with any of them is told.
    fn mechanisms(&self, console: &mut Console) -> Result<Vec<Mechanism>, Failure> {
        let mut found = Vec::new();
        let mut is_wrong = false;
        for document in self.documents()? {
            for declaration in self.wanted(&document) {
                match coherent(&document, declaration, console) {
                    Ok(Analysed { model, compiled }) => {
                        found.push(Mechanism::new(model, compiled)?);
                    }
                    Err(failure) if failure.is_reported() => is_wrong = true,
                    Err(failure) => return Err(failure),
                }
            }
        }
        if is_wrong {
            return Err(Failure::reported(FailureKind::Mechanism));
        }
        Ok(found)
    }

    /// The files, one of which at least has a mechanism that is wanted.
    fn documents(&self) -> Result<Vec<Document>, Failure> {
        if let Some(document) = &self.given {
            return Ok(vec![document.clone()]);
        }
        if let [only] = &self.files[..] {
            let document = Document::read(only)?;
            if self.wanted(&document).is_empty() {
                document.choose(self.mechanism.as_deref())?;
            }
            return Ok(vec![document]);
        }
        let documents = self.files.iter();
        let documents = documents.map(|path| Ok(Document::of(Source::read(path)?)));
        let documents: Vec<Document> = documents.collect::<Result<_, Failure>>()?;
        let has_any = documents.iter().any(|one| !self.wanted(one).is_empty());
        match &self.mechanism {
            _ if has_any => Ok(documents),
            Some(name) => {
                Err(Failure::usage(format!("none of these files has a mechanism `{name}`")))
            }
            None => Err(Failure::file("none of these files has a mechanism")),
        }
    }

    /// The mechanisms of a file that are wanted.
    fn wanted<'d>(&self, document: &'d Document) -> Vec<&'d Declaration> {
        let name = self.mechanism.as_deref();
        let is_wanted = |one: &&Declaration| name.is_none() || one.name.as_deref() == name;
        document.declarations().iter().filter(is_wanted).collect()
    }
}

fn in_terminal(stage: Stage) -> Result<(), Failure> {
    if !is_terminal() {
        return Err(Failure::usage(
            "`--terminal` needs one, and input and output are none; write a picture with `--picture FILE`",
        ));
    }
    terminal::play(stage)
}

/// What can be done where there is no window.
const INSTEAD: &str =
    "play in a terminal with `--terminal`, or write a picture with `--picture FILE`";

/// Plays in a window. Where none comes up, the terminal is offered, if this is one.
#[cfg(feature = "editor")]
fn in_window(stage: Stage) -> Result<(), Failure> {
    use crate::play::window;
    match window::play(stage)? {
        None => Ok(()),
        Some(unopened) if !is_terminal() => {
            Err(Failure::usage(format!("{}; {INSTEAD}", unopened.reason)))
        }
        Some(unopened) => in_terminal_instead(unopened),
    }
}

#[cfg(not(feature = "editor"))]
fn in_window(_: Stage) -> Result<(), Failure> {
    Err(Failure::usage(format!("this `mech` was built without its feature `editor`; {INSTEAD}")))
}

/// Says why there is no window, and asks whether the terminal will do.
#[cfg(feature = "editor")]
fn in_terminal_instead(unopened: crate::play::window::Unopened) -> Result<(), Failure> {
    use std::io::BufRead;
    let reason = unopened.reason;
    eprint!("{reason}\nplay in this terminal instead (as `--terminal` does)? [Y/n] ");
    let mut answer = String::new();
    let read = io::stdin().lock().read_line(&mut answer);
    read.map_err(|error| Failure::file(format!("the terminal cannot be read: {error}")))?;
    match answer.trim() {
        "" | "y" | "Y" | "yes" => in_terminal(unopened.stage),
        _ => Ok(()),
    }
}

/// Whether there is somebody who sees what is written, and can type.
fn is_terminal() -> bool {
    io::stdout().is_terminal() && io::stdin().is_terminal()
}
