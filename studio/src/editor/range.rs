//! The ranges of motors, and the whole paths of points over the first of them.

use crate::failure::Failure;
use crate::motion::{Basis, Mover, Reach, place_of};
use mech_compiler::Compiled;
use mech_compiler::model::{AxisId, Model};

/// The range of a motor that moves alone from the start.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct MotorRange {
    pub(crate) name: String,
    /// Its lowest and highest value, in radians or scene units.
    pub(crate) ends: [f64; 2],
    pub(crate) basis: Basis,
    /// Whether its values are angles.
    pub(crate) turns: bool,
}

impl MotorRange {
    /// A value as it is shown: in degrees or scene units.
    pub(crate) fn shown(&self, value: f64) -> f64 {
        if self.turns { value.to_degrees() } else { value }
    }

    /// The unit in which values are shown.
    pub(crate) fn unit(&self) -> &'static str {
        if self.turns { "°" } else { "" }
    }

    /// The value that is meant by one as it is shown.
    pub(crate) fn meant(&self, shown: f64) -> f64 {
        if self.turns { shown.to_radians() } else { shown }
    }
}

/// Finds the range of each motor, in the order of declaration. A motor that slides without a declared range goes half as far as the
/// mechanism is large.
pub(crate) fn ranges(model: &Model, compiled: &Compiled) -> Result<Vec<MotorRange>, Failure> {
    let base = &compiled.program.start.motors[..model.motors.len()];
    let motors = model.motor_ids().map(|motor| {
        let joint = model.motor(motor).joint;
        let Reach { ends, basis, .. } = Reach::of(model, compiled, motor, base)?;
        Ok(MotorRange {
            name: model.joint(joint).name.clone(),
            ends,
            basis,
            turns: model.turns(joint),
        })
    });
    motors.collect()
}

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
