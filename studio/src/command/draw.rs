//! `mech draw`.

use super::CODES;
use super::picture::{Picture, Sitter, kind_of};
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::motion::{Drive, Mover, Paths, Setting, Span, posed};
use crate::output;
use clap::Args;
use mech_runtime::HeapSmooth;
use mech_runtime::files::{self, Svg};

/// Draws a mechanism as it is assembled, or where its motors are put: PNG or SVG.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Draw {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    picture: Picture,
}

const EXAMPLES: &str = "\
Examples:
  mech draw four_bar.mech -o four_bar.png
  mech draw four_bar.mech -o four_bar.svg --at a=30 --overlay
  mech draw src/main.rs --mechanism FourBar -o wide.png --size 1920x1080 --look diagram --night";

#[derive(Clone, Copy)]
enum Kind {
    Png,
    Svg,
}

/// How many places of a path are recorded in one turn, and the most turns.
const PLACES: u32 = 720;
const MOST_TURNS: u32 = 22;

impl Draw {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let path = &self.picture.output;
        let kind = kind_of(path, &[("png", Kind::Png), ("svg", Kind::Svg)])?;
        let sitter = self.picture.sitter(&self.target, console)?;
        let Sitter {
            model,
            compiled,
            painting,
            sheet,
            size,
            palette,
        } = &sitter;
        let start = Mover::new(model, compiled);
        let machine = posed(start, model, compiled, &self.picture.at)?;
        let paths = self.paths(&sitter)?;
        let poses = &machine.position().poses[..];
        match kind {
            Kind::Svg => {
                let mut svg = Svg::new(sheet.clone());
                painting.paint(poses, &paths, &mut svg);
                output::replace(path, svg.finish().as_bytes())
            }
            Kind::Png => {
                let [width, height] = *size;
                let mut picture = HeapSmooth::new(width, height)?;
                picture.set_palette(palette.clone());
                picture.clear();
                picture.look_at(painting.view(*size));
                painting.paint(poses, &paths, &mut picture);
                output::replace(path, &files::Picture::from(&picture).png()?)
            }
        }
    }

    /// The whole paths of traced points in the motion that the mechanism makes if nobody says which.
    fn paths(&self, sitter: &Sitter) -> Result<Paths, Failure> {
        let Sitter {
            model, compiled, ..
        } = sitter;
        let mut paths = Paths::new(model, compiled)?.whole();
        if paths.is_empty() {
            return Ok(paths);
        }
        // The first motor moves, wherever the picture has it.
        let first = model
            .motors
            .first()
            .map(|motor| &model.joint(motor.joint).name);
        let others = self
            .picture
            .at
            .iter()
            .filter(|one| Some(&one.motor) != first);
        let others: Vec<Setting> = others.cloned().collect();
        let drive = Drive::new(model, compiled, None, Span::default(), &others);
        let Ok(drive) = drive else {
            return Ok(paths);
        };
        let drive = drive.completed(model, compiled);
        let places = PLACES * drive.turns(model).min(MOST_TURNS);
        let mut machine = Mover::new(model, compiled);
        for number in 0..=places {
            let part = f64::from(number) / f64::from(places);
            if drive.move_to(model, compiled, &mut machine, part).is_ok() {
                paths.record(&machine.position().poses);
            }
        }
        Ok(paths)
    }
}
