//! Still pictures.

use super::picture::{Picture, Sitter};
use super::{Analysed, StillKind};
use crate::failure::Failure;
use crate::motion::{Drive, Mover, Paths, PlaneMotion, Setting, Span, obstacle, posed};
use crate::painting::Centres;
use mech_compiler::compile;
use mech_compiler::model::Model;
use mech_runtime::files::{self, Svg};
use mech_runtime::{HeapSmooth, Pose};

/// A picture of a mechanism as it is assembled, or where its motors are put.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Draw {
    pub(crate) picture: Picture,
    pub(crate) kind: StillKind,
    /// Whether instant centres are painted, as the first motor moves.
    pub(crate) centres: bool,
}

/// The number of places of a path that are recorded in one turn, and the most turns.
const PLACES: u32 = 720;
const MOST_TURNS: u32 = 22;

impl Draw {
    pub(super) fn run(&self, analysed: Analysed) -> Result<Vec<u8>, Failure> {
        let centres = if self.centres {
            Some(self.centres(&analysed.model)?)
        } else {
            None
        };
        let sitter = self.picture.sitter(analysed, centres.as_ref());
        let Sitter {
            analysed: Analysed { model, compiled },
            painting,
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
                if let Some(centres) = &centres {
                    centres.paint(&mut svg);
                }
                Ok(svg.finish().into_bytes())
            }
            StillKind::Png => {
                let [width, height] = *size;
                let mut picture = HeapSmooth::new(width, height)?;
                picture.set_palette(palette.clone());
                picture.clear();
                picture.look_at(painting.view(*size));
                painting.paint(poses, &paths, &mut picture);
                if let Some(centres) = &centres {
                    centres.paint(&mut picture);
                }
                Ok(files::Picture::from(&picture).png()?)
            }
        }
    }

    /// The instant centres where the motors are put, as the first of them moves.
    fn centres(&self, model: &Model) -> Result<Centres, Failure> {
        let mut model = Model {
            show: None,
            ..model.clone()
        };
        model.effects.velocity = true;
        let compiled = compile(&model).map_err(|_| {
            Failure::mechanism("instant centres need velocities, with which it does not compile")
        })?;
        let Some(moving) = &compiled.moving else {
            return Err(Failure::internal("velocities have no program"));
        };
        let machine = posed(
            Mover::new(&model, &compiled),
            &model,
            &compiled,
            &self.picture.at,
        )?;
        let position = machine.position();
        let mut mover = Mover::of(&model, moving);
        mover.put_back(&position);
        let rest = vec![0.0; model.motors.len()];
        let mut rates = rest.clone();
        let Some(first) = rates.first_mut() else {
            return Err(Failure::mechanism(
                "nothing moves: there are no instant centres",
            ));
        };
        *first = 1.0;
        let found = mover.motion([&rates, &rest]).map_err(|stop| {
            let why = obstacle(&model, &compiled, stop);
            Failure::mechanism(format!("there are no velocities here: {why}"))
        })?;
        let motions = model.declared_links().filter_map(|link| {
            let place = compiled.program.place_of(link)?;
            let pose = Pose::from(*position.poses.get(place)?);
            let rates = found.velocities.get(place)?;
            Some((link, PlaneMotion::new(*rates, pose)))
        });
        Ok(Centres::of(&model, &motions.collect::<Vec<_>>()))
    }

    /// The whole paths of traced points in the motion that the mechanism makes if nobody says which.
    fn paths(&self, Analysed { model, compiled }: &Analysed) -> Result<Paths, Failure> {
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
