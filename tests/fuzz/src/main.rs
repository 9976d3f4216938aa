//! Mangled texts for everything that reads texts.
//!
//! ```text
//! fuzz [--count N] [--seconds N] [--seed N] [--limit SECONDS] [--corpus FOLDER]... [TARGET]...
//! fuzz --text TARGET <FILE
//! ```
//!
//! Each target takes N texts, or as many as there is time for. What is found is told with the least text that shows it. The second line tries
//! one text.

mod corpus;
mod finding;
mod language;
mod mangle;
mod minimise;
mod options;
mod pieces;
mod rounds;
mod target;
mod watch;
mod worker;

use options::{Options, Task};
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = Options::read(std::env::args().skip(1)).and_then(|options| match &options.task {
        Task::Rounds => rounds::run(&options),
        Task::Worker(lot) => worker::run(&options, lot).map(|()| true),
        Task::Text(target) => worker::try_standard_input(&options, *target).map(|()| true),
    });
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
