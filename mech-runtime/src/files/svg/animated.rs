//! One period of a mechanism.

use super::{AnimatedSvg, Sheet};
use crate::{Blocked, Mechanism};
use std::string::String;
use std::time::Duration;

/// Moments of a period, at least and at most.
const LEAST: u32 = 128;
const MOST: u32 = 4096;

/// How far anything may be from a straight way between two moments, in pixels.
const TOLERANCE: f64 = 0.02;

/// One period of a mechanism's motion as SVG that moves by itself: see [`AnimatedSvg`].
///
/// `motion` gives the motors' values at a phase in `0.0..1.0`. Everything that [`draw`](Mechanism::draw) draws is seen. The mechanism
/// goes once through its period before anything is drawn, so that traces are those of a motion that goes on for ever. Moments are so
/// near together that nothing is farther than a tenth of a pixel from where it should be (with 4096 of them at most).
///
/// ```
/// use mech_runtime::files::{Sheet, animated};
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
/// let text = animated::<Crank>(&sheet, Duration::from_secs(3), |phase| [phase * TAU])?;
/// assert!(text.contains("prefers-reduced-motion")); // for `std::fs::write("crank.svg", text)`
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # Errors
/// [`Blocked`] if the mechanism cannot go through the motion.
pub fn animated<M: Mechanism>(
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
        if moments >= MOST || layers.coarseness() <= TOLERANCE {
            return Ok(svg.written(&layers));
        }
        moments *= 2;
    }
}
