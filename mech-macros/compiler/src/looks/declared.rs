//! The outlines of declared shapes.

use super::outline::{Outline, Painted, painted};
use crate::bug::bug;
use crate::model::{LinkId, Measure, Place, Shape, ShapeKind};
use mech_core::colors::{EYE, INK, darker};

/// A bar's face, and the pins and eyes on it, as parts of its width.
pub(super) const FACE: f64 = 0.76;
pub(super) const PIN: f64 = 0.28;
const HOLE: f64 = 0.14;

/// The outlines of a shape, from back to front.
pub(super) fn outlines(link: LinkId, shape: &Shape) -> Vec<Painted> {
    let values = shape.kind.numbers();
    let measure = |index: usize| Measure::new(values[index], shape.formulas[index]);
    let count = shape.kind.reach().0.len();
    let point = |index: usize| [measure(2 * index), measure(2 * index + 1)];
    let length = |index: usize| measure(2 * count + index);
    let outline = match shape.kind {
        ShapeKind::Circle { .. } => Outline::Circle { center: point(0), radius: length(0) },
        ShapeKind::Ring { .. } => {
            Outline::Ring { center: point(0), radius: length(0), hole: length(1) }
        }
        ShapeKind::Polygon(_) => Outline::Polygon((0..count).map(point).collect()),
        ShapeKind::Figure(_) => {
            bug!("a figure is painted before it is known how the mechanism moves")
        }
        ShapeKind::Bar { .. } => {
            let pins: Vec<Place> = (0..count).map(point).collect();
            let all = bar(&pins, length(0), shape.color);
            return painted(link, shape.plane, all).collect();
        }
    };
    painted(link, shape.plane, [(outline, shape.color)]).collect()
}

/// A bar with a dark edge and an eye at each pin, as `mech_runtime::raster::bar` draws it: outlines and their colours, from back to
/// front.
pub(super) fn bar(pins: &[Place], width: Measure, color: u8) -> Vec<(Outline, u8)> {
    let line =
        |share: f64| Outline::Line { points: pins.to_vec().into(), width: width.times(share) };
    let mut all = vec![(line(1.0), darker(color)), (line(FACE), color)];
    all.extend(pins.iter().flat_map(|pin| eye(*pin, width)));
    all
}

/// The pin of a bar of this width.
pub(super) fn eye(center: Place, width: Measure) -> [(Outline, u8); 2] {
    let circle = |share: f64| Outline::Circle { center, radius: width.times(share) };
    [(circle(PIN), INK), (circle(HOLE), EYE)]
}
