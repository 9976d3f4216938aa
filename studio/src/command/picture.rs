//! What drawings and films have in common: what is painted, and on what.

use super::assignment::Assignment;
use super::construction::Constructions;
use super::target::Replacing;
use crate::failure::Failure;
use crate::job::{self, Size};
use crate::motion::Setting;
use clap::{Args, ValueEnum};
use mech_compiler::model::Look;
use std::path::{Path, PathBuf};

/// What is painted, and on what.
#[derive(Args, Clone, Debug)]
pub(super) struct Picture {
    /// The file to write: its ending says which kind.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: PathBuf,
    #[command(flatten)]
    pub(super) replacing: Replacing,
    /// The size in pixels, as 800x600; a width alone has the height that fits.
    #[arg(long, value_name = "SIZE", default_value = "800", value_parser = read_size)]
    size: Size,
    /// How the mechanism looks, whatever it declares.
    #[arg(long, value_enum)]
    look: Option<Looks>,
    /// Paints the symbols of joints, motors and axes over it.
    #[arg(long)]
    overlay: bool,
    /// Writes the names of joints and links over it.
    #[arg(long)]
    names: bool,
    #[command(flatten)]
    constructions: Constructions,
    /// Paints on dark ground.
    #[arg(long)]
    night: bool,
    /// Puts a motor at a value, in degrees if it turns: `--at a=30`.
    #[arg(long, value_name = "MOTOR=VALUE")]
    at: Vec<Setting>,
    /// Gives a constant or a param another value than in the file: `--set size=2`.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<Assignment>,
}

/// How a mechanism looks.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Looks {
    /// Every link without shapes has a body that is made from what it carries.
    Machine,
    /// Symbols of joints, and lines between them.
    Diagram,
    /// Nothing but the declared shapes.
    Shapes,
}

/// The most pixels of a picture in one direction.
const MOST: usize = 16_384;

fn read_size(text: &str) -> Result<Size, String> {
    let side = |text: &str| match text.parse() {
        Ok(side @ 1..=MOST) => Ok(side),
        _ => Err(format!("`{text}` is not a number of pixels from 1 to {MOST}")),
    };
    Ok(match text.split_once('x') {
        None => Size { width: side(text)?, height: None },
        Some((width, height)) => Size { width: side(width)?, height: Some(side(height)?) },
    })
}

impl Picture {
    /// The same without its file.
    pub(super) fn job(&self) -> job::Picture {
        job::Picture {
            size: self.size,
            look: self.look.map(|look| match look {
                Looks::Machine => Look::Machine,
                Looks::Diagram => Look::Diagram,
                Looks::Shapes => Look::Shapes,
            }),
            overlay: self.overlay,
            names: self.names,
            constructions: self.constructions.all(),
            loads: self.constructions.load.clone(),
            night: self.night,
            at: self.at.clone(),
        }
    }
}

/// The kind of a file by its ending, one of these.
pub(super) fn kind_of<K: Copy>(path: &Path, kinds: &[(&str, K)]) -> Result<K, Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let ending = ending.unwrap_or_default();
    let found = kinds.iter().find(|(known, _)| *known == ending);
    found.map(|(_, kind)| *kind).ok_or_else(|| {
        let endings: Vec<String> = kinds.iter().map(|(known, _)| format!("`.{known}`")).collect();
        Failure::usage(format!(
            "`{}` does not say what to write; its name has to end in {}",
            path.display(),
            endings.join(", ")
        ))
    })
}
