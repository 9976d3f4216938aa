//! Holds the report of the firmware against this machine. Called by `tests/conformance/run`, which makes the firmware tell.
//!
//! `mech-conformance FOLDER` compares, `mech-conformance FOLDER --update` writes the figures anew.

mod agreement;
mod board;
mod error;
mod figures;
mod here;
mod image;
mod page;
mod report;
mod row;

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
    stay_single(&folder)?;
    let figures = Figures::measured(&folder)?;
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs");
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

/// Tests that what is declared in `f32` never computes in `f64`, which a Cortex-M4F does in software.
fn stay_single(folder: &Path) -> Result<(), Error> {
    for image in ["exact_f32", "least"] {
        let path = image_of(folder, Board::CortexM4F, image);
        let doubles = image::soft_doubles(&path)?;
        if !doubles.is_empty() {
            let doubles = doubles.join(", ");
            return Err(Error::Differs(format!(
                "{image} computes in f64: {doubles}"
            )));
        }
    }
    Ok(())
}

/// Where an image is.
pub(crate) fn image_of(folder: &Path, board: Board, image: &str) -> PathBuf {
    let release = folder.join("target").join(board.target()).join("release");
    release.join(image)
}

/// Holds the report of the firmware against that of this machine.
fn agree(folder: &Path) -> Result<(), Error> {
    let abilities = [Board::CortexM4F];
    for (image, here, boards) in [
        ("poses", here::poses_and_pictures(), &Board::ALL[..]),
        ("abilities", here::abilities(), &abilities[..]),
    ] {
        for board in boards {
            let path = folder.join(board.target()).join(format!("{image}.txt"));
            let text = fs::read_to_string(&path).map_err(|source| Error::File { path, source })?;
            let summary = agreement::compare(&report::things(&text)?, &here)?;
            println!("{}, {image}: {summary}", board.name());
        }
    }
    Ok(())
}
