//! The command line: what can be said, and who does it.

mod check;
mod completions;
mod draw;
mod film;
mod fix;
mod graph;
mod measure;
mod picture;
mod plot;
mod report;
mod table;
mod target;

use crate::console::Console;
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

/// Checks, mends, draws and measures planar mechanisms.
///
/// FILE is a Rust file with `mechanism! { ... }` in it, or a file `.mech` with the inside of one. Of several mechanisms in a file,
/// `--mechanism NAME` chooses one.
#[derive(Debug, Parser)]
#[command(
    name = "mech",
    version,
    after_help = CODES,
    arg_required_else_help = true,
    disable_help_subcommand = true
)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
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
    Completions(completions::Completions),
}

/// Does what a command line says, and gives the code with which the program ends. The first word is the name of the program.
pub fn run(words: impl IntoIterator<Item = OsString>, console: &mut Console) -> ExitCode {
    // A broken invariant is told below, in one line.
    std::panic::set_hook(Box::new(|_| {}));
    let done = catch(|| obey(words, console)).unwrap_or_else(|what| {
        Err(Failure::internal(format!(
            "internal error: {what}. Please report it, with the command and the file"
        )))
    });
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
    let line = match CommandLine::try_parse_from(words) {
        Ok(line) => line,
        Err(error) if error.use_stderr() => {
            console.complain(&error.to_string());
            return Err(Failure::reported(FailureKind::Usage));
        }
        // What was asked for: the help, or the version.
        Err(error) => return console.answer(error.to_string()),
    };
    match line.command {
        Command::Check(check) => check.run(console),
        Command::Fix(fix) => fix.run(console),
        Command::Report(report) => report.run(console),
        Command::Graph(graph) => graph.run(console),
        Command::Draw(draw) => draw.run(console),
        Command::Film(film) => film.run(console),
        Command::Table(table) => table.run(console),
        Command::Plot(plot) => plot.run(console),
        Command::Completions(completions) => completions.run(console),
    }
}
