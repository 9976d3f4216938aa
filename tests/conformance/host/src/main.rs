//! Holds the report of the firmware against this machine. Called by `tests/conformance/run`, which makes the firmware tell.
//!
//! `mech-conformance FOLDER` compares what ran, `--all` asks that every known image ran, and `--update` writes the figures anew.

mod here;

use mech_conformance::{Answers, Error, Figured, hold};
use std::env;
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Error> {
    let mut arguments = env::args_os().skip(1);
    let folder = arguments.next().map(PathBuf::from).ok_or(Error::Usage)?;
    let figured = match arguments.next() {
        None => Figured::Some,
        Some(flag) if flag == "--all" => Figured::All,
        Some(flag) if flag == "--update" => Figured::Anew,
        Some(_) => return Err(Error::Usage),
    };
    let here =
        Answers { poses_and_pictures: here::poses_and_pictures(), abilities: here::abilities() };
    hold(&folder, &here, figured)
}
