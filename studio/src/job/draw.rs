//! Still pictures.

use super::picture::{Picture, Sitter};
use super::{Analysed, StillKind};
use crate::failure::Failure;
use crate::motion::{Drive, Mover, Paths, Setting, Span, posed};
use mech_runtime::HeapSmooth;
use mech_runtime::files::{self, Svg};

/// A picture of a mechanism as it is assembled, or where its motors are put.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Draw {
    pub(crate) picture: Picture,
    pub(crate) kind: StillKind,
}

/// The number of places of a path that are recorded in one turn, and the most turns.
const PLACES: u32 = 720;
const MOST_TURNS: u32 = 22;

impl Draw {
    pub(super) fn run(&self, analysed: Analysed) -> Result<Vec<u8>, Failure> {
        let Analysed { model, compiled } = &analysed;
        // What does not move is painted, too, if nothing is constructed.
        let is_plain = self.picture.constructions.is_empty();
        let drives = (!is_plain).then(|| {
            let standing = Drive::standing(model, compiled, &self.picture.at)?;
            Ok::<_, Failure>([standing, self.whole(&analysed)?])
        });
        let drives = drives.transpose()?;
        let drives = drives.as_ref().map(<[Drive; 2]>::each_ref);
        let sitter = self.picture.sitter(analysed, drives, &[0.0])?;
        let Sitter {
            analysed: Analysed { model, compiled },
            painting,
            board,
            sheet,
            size,
            palette,
        } = &sitter;
        let start = Mover::new(model, compiled);
        let machine = posed(start, model, compiled, &self.picture.at)?;
        let paths = self.paths(&sitter.analysed)?;
        let poses = &machine.position().poses[..];
        match self.kind {
            StillKind::Svg => {
                let mut svg = Svg::new(sheet.clone());
                painting.paint(poses, &paths, &mut svg);
                board.paint(0, &mut svg);
                Ok(svg.finish().into_bytes())
            }
            StillKind::Png => {
                let [width, height] = *size;
                let mut picture = HeapSmooth::new(width, height)?;
                picture.set_palette(palette.clone());
                picture.clear();
                picture.look_at(painting.view(*size));
                painting.paint(poses, &paths, &mut picture);
                board.paint(0, &mut picture);
                Ok(files::Picture::from(&picture).png()?)
            }
        }
    }

    /// The motion that the mechanism makes if nobody says which.
    fn whole(&self, Analysed { model, compiled }: &Analysed) -> Result<Drive, Failure> {
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
        let drive = Drive::new(model, compiled, None, Span::default(), &others)?;
        Ok(drive.completed(model, compiled))
    }

    /// The whole paths of traced points in that motion.
    fn paths(&self, analysed: &Analysed) -> Result<Paths, Failure> {
        let Analysed { model, compiled } = analysed;
        let mut paths = Paths::new(model, compiled)?.whole();
        if paths.is_empty() {
            return Ok(paths);
        }
        let Ok(drive) = self.whole(analysed) else {
            return Ok(paths);
        };
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
