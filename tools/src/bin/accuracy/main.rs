//! The price list: the cost and the accuracy of every method, on several mechanisms.
//!
//! `cargo accuracy [--quick]`

mod article;
mod closure;
mod command;
mod contestant;
mod diagram;
mod frontier;
mod measurement;
mod method;
mod octuple;
mod reference;
mod subject;
mod table;

use command::{Command, HELP};
use measurement::{Effort, measure};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fmt, fs, io};

fn main() -> ExitCode {
    match Command::read(env::args().skip(1)).and_then(run) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Result<(), String> {
    let effort = match command {
        Command::Help => {
            say(format_args!("{HELP}"));
            return Ok(());
        }
        Command::Full => Effort { rounds: 101, positions: 4000 },
        Command::Quick => Effort { rounds: 3, positions: 500 },
    };
    let mut measurements = Vec::new();
    for subject in subject::subjects() {
        let slug = subject.slug;
        let measurement = measure(subject, effort).map_err(|error| format!("{slug}: {error}"))?;
        say(format_args!("{}", table::table(&measurement)));
        measurements.push(measurement);
    }
    say(format_args!("* nothing else is both cheaper and more exact at this step\n"));
    let files: [(&str, Vec<u8>); 4] = [
        ("accuracy.csv", table::csv(&measurements).into()),
        ("accuracy.svg", diagram::svg(&measurements)?.into()),
        (
            "accuracy.png",
            diagram::picture(&measurements)?.png().map_err(|error| error.to_string())?,
        ),
        ("accuracy.md", article::article(&measurements, effort).into()),
    ];
    for folder in folders(command) {
        fs::create_dir_all(&folder)
            .map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        for (name, bytes) in &files {
            let path = folder.join(name);
            fs::write(&path, bytes)
                .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
            say(format_args!("{}", path.display()));
        }
    }
    Ok(())
}

/// The folder of the results: in the workspace, or the current folder if the workspace does not exist.
fn folders(command: Command) -> Vec<PathBuf> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let root = workspace.filter(|workspace| workspace.is_dir());
    let root = root.unwrap_or(Path::new("."));
    let mut folders = vec![root.join("target/accuracy")];
    if command == Command::Full {
        folders.push(root.join("docs"));
    }
    folders
}

/// Writes a line to the output. It is no error if nobody reads it.
fn say(line: fmt::Arguments<'_>) {
    let _ = writeln!(io::stdout(), "{line}");
}
