//! Holds what the firmware told against what mechanisms answer on this machine.
//!
//! What they answer stands in the program alone: to build that takes minutes, and the tests of this library do without.

mod agreement;
mod board;
mod error;
mod figures;
mod image;
mod page;
mod report;
mod row;

use board::Board;
pub use error::Error;
use figures::Figures;
pub use report::{Subject, Things};
use std::fs;
use std::path::{Path, PathBuf};

/// What mechanisms answer on this machine.
pub struct Answers {
    /// Where links are, and what pictures look like.
    pub poses_and_pictures: Things,
    /// What comes of everything that mechanisms and pictures can do.
    pub abilities: Things,
}

/// Which figures are held against those of docs/embedded.csv.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figured {
    /// Those of the images that ran.
    Some,
    /// All that are known: each image has to have run.
    All,
    /// None: they are written anew.
    Anew,
}

/// Holds a folder of reports of the firmware against this machine and the known figures; or writes these figures anew.
///
/// # Errors
/// If something differs, or a file cannot be read or written.
pub fn hold(folder: &Path, here: &Answers, figured: Figured) -> Result<(), Error> {
    agree(folder, here)?;
    stay_single(folder)?;
    let figures = Figures::measured(folder)?;
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs");
    let mut known = Figures::read(&docs.join("embedded.csv"))?;
    if figured == Figured::Anew {
        known.retain(|known| known.compiler != figures.compiler);
        known.push(figures);
        known.sort_by(|a, b| a.compiler.cmp(&b.compiler));
        return page::write(&docs, &known);
    }
    figures.hold_against(&known, figured)?;
    figures.keep_promises()
}

/// Tests that what is declared in `f32` never computes in `f64`, which a Cortex-M4F does in software.
fn stay_single(folder: &Path) -> Result<(), Error> {
    for image in ["exact_f32", "least"] {
        let path = image_of(folder, Board::CortexM4F, image);
        let doubles = image::soft_doubles(&path)?;
        if !doubles.is_empty() {
            let doubles = doubles.join(", ");
            return Err(Error::Differs(format!("{image} computes in f64: {doubles}")));
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
fn agree(folder: &Path, here: &Answers) -> Result<(), Error> {
    let abilities = [Board::CortexM4F];
    for (image, here, boards) in [
        ("poses", &here.poses_and_pictures, &Board::ALL[..]),
        ("abilities", &here.abilities, &abilities[..]),
    ] {
        for board in boards {
            let path = folder.join(board.target()).join(format!("{image}.txt"));
            let text = fs::read_to_string(&path).map_err(|source| Error::File { path, source })?;
            let summary = agreement::compare(&report::things(&text)?, here)?;
            println!("{}, {image}: {summary}", board.name());
        }
    }
    Ok(())
}
