//! The command line: what can be said, and who does it.

mod assignment;
mod check;
mod completions;
mod draw;
#[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
mod edit;
mod film;
mod fix;
mod graph;
mod import;
mod measure;
mod picture;
mod play;
mod plot;
mod report;
mod run;
mod table;
mod target;

use crate::console::Console;
use crate::dialogue::converse;
use crate::document::Document;
use crate::failure::{Failure, FailureKind};
use clap::{Parser, Subcommand};
use mech_compiler::catch;
use std::ffi::OsString;
use std::process::ExitCode;
use target::Target;

/// What is the same below the help of every command.
const CODES: &str = "\
Exit codes:
  0   done
  1   something is wrong with the mechanism
  2   something is wrong with the command
  3   a file cannot be read or written; nothing was overwritten
  70  something is wrong with mech itself";

/// Checks, mends, draws, plays and measures planar mechanisms.
///
/// FILE is a Rust file with `mechanism! { ... }` in it, or a file `.mech` with the inside of one. Of several mechanisms in a file,
/// `--mechanism NAME` chooses one. Without a command, `mech` opens a dialogue in which mechanisms are made and changed.
#[derive(Debug, Parser)]
#[command(
    name = "mech",
    version,
    after_help = CODES,
    disable_help_subcommand = true
)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Check),
    Fix(fix::Fix),
    Report(report::Report),
    Graph(graph::Graph),
    Draw(draw::Draw),
    Film(film::Film),
    Table(table::Table),
    Plot(plot::Plot),
    Play(play::Play),
    #[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
    Edit(edit::Edit),
    Import(import::Import),
    Run(run::Run),
    Completions(completions::Completions),
}

/// Does what a command line says, and gives the code with which the program ends. The first word is the name of the program.
pub fn run(words: impl IntoIterator<Item = OsString>, console: &mut Console) -> ExitCode {
    // A broken invariant is told below, in one line.
    std::panic::set_hook(Box::new(|_| {}));
    let done = catch(|| obey(words, console)).unwrap_or_else(|what| Err(Failure::internal(what)));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !failure.is_reported() {
                console.complain(&format!("error: {failure}\n"));
            }
            failure.exit_code()
        }
    }
}

fn obey(words: impl IntoIterator<Item = OsString>, console: &mut Console) -> Result<(), Failure> {
    let Some(line) = parse(words, console)? else {
        return Ok(());
    };
    match line.command {
        Some(command) => command.run(console),
        None => converse(console),
    }
}

/// The command line; none if only its help was asked for.
fn parse(
    words: impl IntoIterator<Item = OsString>,
    console: &mut Console,
) -> Result<Option<CommandLine>, Failure> {
    match CommandLine::try_parse_from(words) {
        Ok(line) => Ok(Some(line)),
        Err(error) if error.use_stderr() => {
            console.complain(&error.to_string());
            Err(Failure::reported(FailureKind::Usage))
        }
        // What was asked for: the help, or the version.
        Err(error) => console.answer(error.to_string()).map(|()| None),
    }
}

/// Does what a subcommand does, on the mechanism with this number in a text that may not be in any file. The words are those after
/// `mech`, without the file.
pub(crate) fn obey_within(
    words: &[String],
    document: Document,
    index: usize,
    console: &mut Console,
) -> Result<(), Failure> {
    let mut all: Vec<OsString> = vec!["mech".into()];
    let (name, others) = words
        .split_first()
        .ok_or_else(|| Failure::internal("a command without a word"))?;
    all.push(name.into());
    // The file is given below; this only fills its place.
    all.push("-".into());
    all.extend(others.iter().map(OsString::from));
    let Some(line) = parse(all, console)? else {
        return Ok(());
    };
    let mut command = line
        .command
        .ok_or_else(|| Failure::internal("a command without a word"))?;
    command.give(document, index);
    command.run(console)
}

impl Command {
    fn run(self, console: &mut Console) -> Result<(), Failure> {
        match self {
            Self::Check(check) => check.run(console),
            Self::Fix(fix) => fix.run(console),
            Self::Report(report) => report.run(console),
            Self::Graph(graph) => graph.run(console),
            Self::Draw(draw) => draw.run(console),
            Self::Film(film) => film.run(console),
            Self::Table(table) => table.run(console),
            Self::Plot(plot) => plot.run(console),
            Self::Play(play) => play.run(console),
            #[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
            Self::Edit(edit) => edit.run(console),
            Self::Import(import) => import.run(console),
            Self::Run(run) => run.run(console),
            Self::Completions(completions) => completions.run(console),
        }
    }

    /// Gives the text itself, and the number of the mechanism in it.
    fn give(&mut self, document: Document, index: usize) {
        if let Self::Play(play) = self {
            play.give(document, index);
        } else if let Some(target) = self.target() {
            target.give(document, index);
        }
    }

    /// The mechanism that it is about, if it is about one of one file.
    fn target(&mut self) -> Option<&mut Target> {
        Some(match self {
            Self::Check(check) => &mut check.target,
            Self::Fix(fix) => &mut fix.target,
            Self::Report(report) => &mut report.target,
            Self::Graph(graph) => &mut graph.target,
            Self::Draw(draw) => &mut draw.target,
            Self::Film(film) => &mut film.target,
            Self::Table(table) => &mut table.target,
            Self::Plot(plot) => &mut plot.target,
            #[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
            Self::Edit(_) => return None,
            Self::Play(_) | Self::Import(_) | Self::Run(_) | Self::Completions(_) => return None,
        })
    }
}
