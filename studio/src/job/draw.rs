//! Still pictures.

use super::picture::{Picture, Sitter};
use super::{Analysed, StillKind};
use crate::failure::Failure;
use crate::motion::{Drive, Goal, Mover, Paths, Setting, Span, posed};
use mech_runtime::HeapSmooth;
use mech_runtime::files::{self, Svg};

/// A picture of a mechanism as it is assembled, or where its motors are put.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Draw {
    pub(crate) picture: Picture,
    /// Where the point of `follow` is led.
    pub(crate) reach: Option<Goal>,
    pub(crate) kind: StillKind,
}

/// The number of places of a path that are recorded in one turn, and the most turns.
const PLACES: u32 = 720;
const MOST_TURNS: u32 = 22;

impl Draw {
    pub(super) fn run(&self, analysed: Analysed) -> Result<Vec<u8>, Failure> {
        let Analysed { model, compiled } = &analysed;
        let set = &self.picture.at;
        let led = self.reach.as_ref();
        let led = led.map(|goal| Drive::led(model, compiled, set, goal));
        let led = led.transpose()?;
        let at = led.as_ref().map_or_else(|| set.clone(), |led| led.settings(model));
        // What does not move is painted, too, if nothing is constructed.
        let is_plain = self.picture.constructions.is_empty();
        let drives = (!is_plain).then(|| {
            let standing = match led {
                Some(led) => led,
                None => Drive::standing(model, compiled, set)?,
            };
            Ok::<_, Failure>([standing, whole(&analysed, &at)?])
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
        let mut machine = posed(start, model, compiled, set)?;
        if let Some(goal) = &self.reach {
            goal.lead(model, compiled, &mut machine)?;
        }
        let paths = paths(&sitter.analysed, &at)?;
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
}

/// The motion that the mechanism makes if nobody says which.
fn whole(Analysed { model, compiled }: &Analysed, at: &[Setting]) -> Result<Drive, Failure> {
    // The first motor moves, wherever the picture has it.
    let first = model.motors.first().map(|motor| &model.joint(motor.joint).name);
    let others = at.iter().filter(|one| Some(&one.motor) != first);
    let others: Vec<Setting> = others.cloned().collect();
    let drive = Drive::new(model, compiled, None, Span::default(), &others)?;
    Ok(drive.completed(model, compiled))
}

/// The whole paths of traced points in that motion.
fn paths(analysed: &Analysed, at: &[Setting]) -> Result<Paths, Failure> {
    let Analysed { model, compiled } = analysed;
    let mut paths = Paths::new(model, compiled)?.whole();
    if paths.is_empty() {
        return Ok(paths);
    }
    let Ok(drive) = whole(analysed, at) else {
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
