//! One period of a mechanism as animated SVG.

use super::place::Place;
use super::track::Track;
use super::{AnimatedSvg, Sheet};
use crate::{Blocked, Mechanism, Pose, Scalar, Shape};
use core::iter;
use std::string::String;
use std::time::Duration;
use std::vec::Vec;

/// The least and the greatest number of moments.
const LEAST: u32 = 128;
const MOST: u32 = 4096;

/// The greatest distance of a figure from straight lines between moments, in pixels.
const TOLERANCE: f64 = 0.02;

/// The greatest error at a time between two moments, in pixels, and that time as a share. It is no simple fraction, so that a link that
/// turns once or swings between two moments is elsewhere at this time.
const DEVIATION: f64 = 0.05;
const BETWEEN: f64 = 0.381_966;

/// Draws one period of a mechanism's motion as SVG that moves: see [`AnimatedSvg`].
///
/// `motion` gives the motors' values at a phase in `0.0..1.0`, in radians or scene units. [`draw`](Mechanism::draw) paints each moment.
/// The mechanism moves through one period before the first moment, so that its traces are complete.
///
/// The error of every figure is below a tenth of a pixel. There are at most 4096 moments: a link that turns more than two thousand times in
/// a period is shown wrongly.
///
/// ```
/// use mech_runtime::files::{Sheet, animate};
/// use mech_runtime::{View, mechanism};
/// use std::f64::consts::TAU;
/// use std::time::Duration;
///
/// mechanism! {
///     struct Crank;
///     ground { point o = (0, 0); circle (0, 0) radius 0.5 on plane 0 color 1; }
///     link crank { point shaft = (0, 0); circle (2, 0) radius 0.2 on plane 1 color 2; }
///     joint a = revolute(ground.o, crank.shaft);
///     motor a;
/// }
/// let sheet = Sheet::new(320, 240).look_at(View::new([0.0, 0.0], 40.0)).title("A crank");
/// let text = animate::<Crank>(&sheet, Duration::from_secs(3), |phase| [phase * TAU])?;
/// assert!(text.contains("prefers-reduced-motion")); // for `std::fs::write("crank.svg", text)`
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # Errors
/// [`Blocked`] if the mechanism cannot make this motion.
pub fn animate<M: Mechanism>(
    sheet: &Sheet,
    period: Duration,
    motion: impl Fn(f64) -> M::Motors,
) -> Result<String, Blocked<M::Motors>> {
    let mut moments = LEAST;
    loop {
        let mut mechanism = M::new();
        let mut svg = AnimatedSvg::new(sheet.clone(), period);
        for moment in 0..2 * moments {
            let phase = f64::from(moment % moments) / f64::from(moments);
            mechanism.move_to(motion(phase))?;
            if moment >= moments {
                svg.add(|canvas| mechanism.draw(canvas));
            }
        }
        let layers = svg.layers();
        let is_fine = layers.coarseness() <= TOLERANCE;
        if moments >= MOST || (is_fine && !deviates::<M>(sheet, moments, &motion)?) {
            return Ok(svg.document(&layers));
        }
        moments *= 2;
    }
}

/// Whether some link is elsewhere between two moments than the moments say, because it turns too fast.
fn deviates<M: Mechanism>(
    sheet: &Sheet,
    moments: u32,
    motion: impl Fn(f64) -> M::Motors,
) -> Result<bool, Blocked<M::Motors>> {
    let planned = tracks::<M>(sheet, moments, 0.0, &motion)?;
    let found = tracks::<M>(sheet, moments, BETWEEN, &motion)?;
    let mut pairs = iter::zip(&planned, &found);
    Ok(pairs.any(|(planned, found)| planned.deviation(found, BETWEEN) > DEVIATION))
}

/// The tracks of all links, at moments that are later by a share of the time between two moments.
fn tracks<M: Mechanism>(
    sheet: &Sheet,
    moments: u32,
    late: f64,
    motion: impl Fn(f64) -> M::Motors,
) -> Result<Vec<Track>, Blocked<M::Motors>> {
    let mut mechanism = M::new();
    let mut tracks: Vec<_> = mechanism
        .poses()
        .iter()
        .map(|_| Track::new(Vec::new()))
        .collect();
    for shape in M::SHAPES {
        let link = shape.link.checked_sub(1);
        if let Some(track) = link.and_then(|link| tracks.get_mut(link)) {
            track.carry(reach(shape) * sheet.view.scale());
        }
    }
    for moment in 0..moments {
        mechanism.move_to(motion((f64::from(moment) + late) / f64::from(moments)))?;
        for (track, pose) in tracks.iter_mut().zip(mechanism.poses()) {
            track.push(Place::of(*pose, sheet).unwrap_or(Place::PICTURE));
        }
    }
    Ok(tracks)
}

/// The distance from the origin of its link to the farthest point of a shape, in scene units.
fn reach<T: Scalar>(shape: &Shape<T>) -> f64 {
    let (low, high) = shape.bounds(Pose::identity());
    let [x, y] = [0, 1].map(|axis| {
        let ends = [low[axis], high[axis]].map(|end: T| end.to_f64().abs());
        ends[0].max(ends[1])
    });
    x.hypot(y)
}
