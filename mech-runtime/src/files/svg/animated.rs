//! One period of a mechanism as animated SVG.

use super::element::reach;
use super::place::Place;
use super::{AnimatedSvg, Sheet};
use crate::{Blocked, Mechanism};
use std::string::String;
use std::time::Duration;
use std::{vec, vec::Vec};

/// The least and the greatest number of moments.
const LEAST: u32 = 128;
const MOST: u32 = 4096;

/// The greatest distance of a figure from where it should be at a time between two moments, in pixels, and that time as a share. It is no
/// simple fraction, so that a link that turns once or swings between two moments is elsewhere at this time.
const DEVIATION: f64 = 0.02;
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
    while moments < MOST && deviates::<M>(sheet, moments, &motion)? {
        moments *= 2;
    }
    let mut mechanism = M::new();
    let mut svg = AnimatedSvg::new(sheet.clone(), period);
    for moment in 0..2 * moments {
        let phase = f64::from(moment % moments) / f64::from(moments);
        mechanism.move_to(motion(phase))?;
        if moment >= moments {
            svg.add(|canvas| mechanism.draw(canvas));
        }
    }
    Ok(svg.finish())
}

/// Whether some link is elsewhere between two moments than on the straight way from one to the next.
fn deviates<M: Mechanism>(
    sheet: &Sheet,
    moments: u32,
    motion: impl Fn(f64) -> M::Motors,
) -> Result<bool, Blocked<M::Motors>> {
    let mut mechanism = M::new();
    let mut reaches = vec![0.0_f64; mechanism.poses().len()];
    for shape in M::SHAPES {
        let link = shape.link.checked_sub(1);
        if let Some(farthest) = link.and_then(|link| reaches.get_mut(link)) {
            *farthest = farthest.max(reach(&shape.outline) * sheet.view.scale());
        }
    }
    let mut places = |moment: f64| -> Result<Vec<_>, Blocked<M::Motors>> {
        mechanism.move_to(motion(moment / f64::from(moments)))?;
        let poses = mechanism.poses().iter();
        Ok(poses.map(|pose| Place::of(*pose, sheet)).collect())
    };
    let mut before = places(0.0)?;
    // Not beyond the last moment, where a motion that does not close would leap.
    for moment in 1..moments {
        let between = places(f64::from(moment - 1) + BETWEEN)?;
        let after = places(f64::from(moment))?;
        let links = before.iter().zip(&between).zip(&after).zip(&reaches);
        let mut deviations = links.filter_map(|(((before, between), after), reach)| {
            let (before, between, after) = ((*before)?, (*between)?, (*after)?);
            let expected = before.between(after.after(before), BETWEEN);
            Some(expected.distance(between.after(expected), *reach))
        });
        if deviations.any(|deviation| deviation > DEVIATION) {
            return Ok(true);
        }
        before = after;
    }
    Ok(false)
}
