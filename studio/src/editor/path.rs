//! The whole paths of points, over the whole range of the first motor.

use super::range::MotorRange;
use crate::motion::{Mover, place_of};
use mech_compiler::Compiled;
use mech_compiler::model::{AxisId, Model};

/// The number of steps of a path.
const PLACES: u32 = 180;

/// A path in the scene: places that follow one another.
pub(crate) type Path = Vec<[f64; 2]>;

/// The paths of points over the whole range of the first motor, or of the time by laws. A path ends where the mechanism cannot go on.
pub(crate) fn whole_paths(
    model: &Model,
    compiled: &Compiled,
    ranges: &[MotorRange],
    points: &[AxisId],
) -> Vec<Path> {
    let mut paths = vec![Path::new(); points.len()];
    let Some(range) = ranges.first() else {
        return paths;
    };
    let spots = points.iter().map(|point| {
        let axis = model.axis(*point);
        Some((compiled.program.place_of(axis.link)?, axis.at))
    });
    let spots: Vec<Option<(usize, [f64; 2])>> = spots.collect();
    let mut machine = Mover::new(model, compiled);
    let mut motors = compiled.program.start.motors[..model.motors.len()].to_vec();
    let [low, high] = range.ends;
    for place in 0..=PLACES {
        motors[0] = low + (high - low) * f64::from(place) / f64::from(PLACES);
        if machine.move_to(&motors).is_err() {
            // Places after a gap are no part of the path.
            if paths.iter().any(|path| !path.is_empty()) {
                break;
            }
            continue;
        }
        let poses = machine.position().poses;
        for (path, spot) in paths.iter_mut().zip(&spots) {
            if let Some((link, at)) = spot {
                path.push(place_of(model.precision, poses[*link], *at));
            }
        }
    }
    paths
}
