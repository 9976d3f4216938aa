//! The command line: what can be said, and who does it.

mod assignment;
mod check;
mod completions;
mod construction;
mod draw;
#[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
mod edit;
mod film;
mod fix;
mod graph;
mod import;
mod measure;
mod of_text;
mod picture;
mod play;
mod plot;
mod report;
mod rest;
mod run;
mod table;
mod target;

use crate::console::Console;
use crate::dialogue::converse;
use crate::failure::Failure;
use crate::output::Writer;
use clap::{Parser, Subcommand};
use mech_compiler::catch;
pub(crate) use of_text::obey_within;
use of_text::{OfText, parse};
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

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
    disable_help_subcommand = true,
    args_conflicts_with_subcommands = true
)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
    /// Lets lines that come from a file or a program write here, too: a file, or a folder and what is below it.
    #[arg(long, value_name = "PATH")]
    allow_write: Vec<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Command {
    #[command(flatten)]
    OfText(Box<OfText>),
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
    let Some(CommandLine { command, allow_write }) = parse(words, console)? else {
        return Ok(());
    };
    match command {
        None => converse(&allow_write, console),
        Some(Command::OfText(command)) => command.run(&mut Writer::default(), console),
        #[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
        Some(Command::Edit(edit)) => edit.run(console),
        Some(Command::Import(import)) => import.run(&mut Writer::default(), console),
        Some(Command::Run(run)) => run.run(console),
        Some(Command::Completions(completions)) => completions.run(console),
    }
}
