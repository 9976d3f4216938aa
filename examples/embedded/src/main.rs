//! Holds what the firmware told against this machine. Called by `examples/firmware/run`, which makes the firmware tell.
//!
//! `embedded FOLDER` compares, `embedded FOLDER --update` writes the figures anew.

mod agreement;
mod board;
mod error;
mod figures;
mod here;
mod image;
mod page;
mod row;
mod told;

use board::Board;
use error::Error;
use figures::Figures;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

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
    let update = match arguments.next() {
        None => false,
        Some(flag) if flag == "--update" => true,
        Some(_) => return Err(Error::Usage),
    };
    agree(&folder)?;
    let figures = Figures::measured(&folder)?;
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let mut known = Figures::read(&docs.join("embedded.csv"))?;
    if update {
        known.retain(|known| known.compiler != figures.compiler);
        known.push(figures);
        known.sort_by(|a, b| a.compiler.cmp(&b.compiler));
        return page::write(&docs, &known);
    }
    figures.hold_against(&known)?;
    figures.keep_promises()
}

/// Holds poses and pictures against those of this machine.
fn agree(folder: &Path) -> Result<(), Error> {
    let here = here::everything();
    for board in Board::ALL {
        let path = folder.join(board.target()).join("poses.txt");
        let text = fs::read_to_string(&path).map_err(|source| Error::File { path, source })?;
        let summary = agreement::compare(&told::things(&text)?, &here)?;
        println!("{}: {summary}", board.name());
    }
    Ok(())
}
