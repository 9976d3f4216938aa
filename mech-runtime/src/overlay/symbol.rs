//! The symbols of a mechanism.

use super::arrow::{head, turn};
use super::elastic;
use super::pen::{self, BOLD, MEDIUM, Pen, THIN};
use crate::{Canvas, Pose, Real, Scalar};
use mech_core::{Spot, Symbol};

/// The kinds of symbols that are drawn or left out together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Link,
    Joint,
    Motor,
    Axis,
}

/// The radius of a revolute joint, in pixels.
const PIVOT: f32 = 4.7;
/// A fixed pivot's stand: how high it is, and half as wide; half the width of its base.
const STAND: [f32; 3] = [14.0, 8.0, 13.0];
/// A cam: how far its centre is from its shaft, and its radius; a wedge: half its length and half its height.
const CAM: [f32; 2] = [6.0, 14.0];
const WEDGE: [f32; 2] = [16.0, 7.0];
/// A block: half its length and half its height.
const BLOCK: [f32; 2] = [13.0, 7.0];
/// Half the length of a rail.
const RAIL: f32 = 36.0;
/// The distance between strokes of hatching.
const HATCH: f32 = 5.0;

/// The place of a spot in the scene.
fn place<T: Scalar>(spot: Spot<T>, poses: &[Pose<T>]) -> Option<[T; 2]> {
    Some(Pose::of_link(spot.link, poses)?.apply(spot.at))
}

/// The place of a spot and a direction of its link, in the scene.
fn directed<T: Scalar>(spot: Spot<T>, along: [T; 2], poses: &[Pose<T>]) -> Option<pen::Spot<T>> {
    let pose = Pose::of_link(spot.link, poses)?;
    let at = pose.apply(spot.at);
    let along = pose.turn(along);
    Some(pen::Spot { at, along })
}

/// The kind of a symbol.
pub(super) const fn kind<T>(symbol: &Symbol<T>) -> Kind {
    match symbol {
        Symbol::Bar { .. }
        | Symbol::Mark(_)
        | Symbol::Wheel { .. }
        | Symbol::Belt { .. }
        | Symbol::Rack { .. }
        | Symbol::Cam(_)
        | Symbol::Wedge { .. } => Kind::Link,
        Symbol::Slide { .. }
        | Symbol::Weld(_)
        | Symbol::Pivot(_)
        | Symbol::Spring { .. }
        | Symbol::Damper { .. }
        | Symbol::TorsionSpring(_)
        | Symbol::TorsionDamper(_) => Kind::Joint,
        Symbol::RotaryMotor(_) | Symbol::LinearMotor { .. } => Kind::Motor,
        Symbol::Line { .. } | Symbol::Point(_) => Kind::Axis,
    }
}

/// Draws a symbol, if the poses of its links are known.
pub(super) fn draw<T: Scalar>(
    symbol: &Symbol<T>,
    poses: &[Pose<T>],
    pen: &Pen<T>,
    canvas: &mut impl Canvas<T>,
) -> Option<()> {
    match *symbol {
        Symbol::Bar { link, ends } => {
            let pose = Pose::of_link(link, poses)?;
            pen.line(canvas, ends.map(|end| pose.apply(end)), BOLD);
        }
        Symbol::Mark(spot) => pen.dot(canvas, place(spot, poses)?, 3.0),
        Symbol::Wheel { center, radius } => {
            let spot = directed(center, [T::ONE, T::ZERO], poses)?;
            wheel(pen, canvas, spot, radius);
        }
        Symbol::Belt { centers, radii } => {
            let [a, b] = centers;
            belt(pen, canvas, [place(a, poses)?, place(b, poses)?], radii);
        }
        Symbol::Rack {
            pinion,
            radius,
            bar,
            along,
        } => {
            let bar = directed(bar, along, poses)?;
            rack(pen, canvas, place(pinion, poses)?, radius, bar);
        }
        Symbol::Line { at, along } => {
            let spot = directed(at, along, poses)?;
            for dash in [-34.0_f32, -19.0, -4.0, 11.0, 26.0] {
                pen.stroke(canvas, spot, [[dash, 0.0], [dash + 8.0, 0.0]], THIN);
            }
            for dot in [-22.5_f32, -7.5, 7.5, 22.5] {
                pen.stroke(canvas, spot, [[dot - 0.5, 0.0], [dot + 0.5, 0.0]], THIN);
            }
        }
        Symbol::Point(spot) => {
            let spot = pen::Spot::upright(place(spot, poses)?);
            pen.stroke(canvas, spot, [[-7.0, 0.0], [7.0, 0.0]], THIN);
            pen.stroke(canvas, spot, [[0.0, -7.0], [0.0, 7.0]], THIN);
        }
        Symbol::Slide {
            guide,
            along,
            block,
        } => {
            let (rail, at) = (directed(guide, along, poses)?, place(block, poses)?);
            slide(pen, canvas, rail, at, guide.link == 0);
        }
        Symbol::Weld(spot) => {
            let spot = directed(spot, [T::ONE, T::ZERO], poses)?;
            let corners = [[-4.5, -4.5], [4.5, -4.5], [4.5, 4.5], [-4.5, 4.5]];
            pen.fill(canvas, spot, corners, pen.ink());
        }
        Symbol::Pivot(spot) => {
            let at = place(spot, poses)?;
            if spot.link == 0 {
                stand(pen, canvas, at);
            }
            pen.eye(canvas, at, PIVOT);
        }
        Symbol::Spring {
            ends: [a, b],
            beside,
        } => elastic::spring(pen, canvas, [place(a, poses)?, place(b, poses)?], beside),
        Symbol::Damper {
            ends: [a, b],
            beside,
        } => elastic::damper(pen, canvas, [place(a, poses)?, place(b, poses)?], beside),
        Symbol::TorsionSpring(spot) => elastic::torsion_spring(pen, canvas, place(spot, poses)?),
        Symbol::TorsionDamper(spot) => elastic::torsion_damper(pen, canvas, place(spot, poses)?),
        Symbol::Cam(spot) => {
            let spot = directed(spot, [T::ONE, T::ZERO], poses)?;
            let center = spot.offset(pen.pixels(CAM[0]), T::ZERO);
            let start = spot.offset(pen.pixels(CAM[0] + CAM[1]), T::ZERO);
            pen.arc(canvas, center, start, <T as Real>::TURN, MEDIUM);
        }
        Symbol::Wedge { at, along } => {
            let spot = directed(at, along, poses)?;
            let [half, height] = WEDGE;
            let corners = [[-half, -height], [half, -height], [half, height]];
            pen.path(canvas, spot, corners.into_iter().chain([[-half, -height]]));
        }
        Symbol::RotaryMotor(spot) => turn(pen, canvas, place(spot, poses)?, true, 16.0),
        Symbol::LinearMotor {
            block,
            guide,
            along,
        } => {
            let along = Pose::of_link(guide, poses)?.turn(along);
            let at = place(block, poses)?;
            slide_arrow(pen, canvas, pen::Spot { at, along });
        }
    }
    Some(())
}

/// The triangle and the hatched base of a fixed pivot.
fn stand<T: Scalar>(pen: &Pen<T>, canvas: &mut impl Canvas<T>, at: [T; 2]) {
    let [height, half, base] = STAND;
    let spot = pen::Spot::upright(at);
    pen.figure(
        canvas,
        spot,
        [[0.0, 0.0], [half, -height], [-half, -height]],
    );
    pen.stroke(canvas, spot, [[-base, -height], [base, -height]], MEDIUM);
    let floor = pen::Spot::upright(spot.offset(T::ZERO, -pen.pixels(height)));
    pen.hatch(canvas, floor, (HATCH - base, base, HATCH), -1.0);
}

/// A block on its rail, or on the line of a moving link.
fn slide<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut impl Canvas<T>,
    guide: pen::Spot<T>,
    at: [T; 2],
    is_fixed: bool,
) {
    let along = guide.along;
    let block = pen::Spot { at, along };
    let [half, height] = BLOCK;
    let offset = (at[0] - guide.at[0]) * along[0] + (at[1] - guide.at[1]) * along[1];
    if is_fixed {
        // The rail lies below, or to the right where it is upright.
        let is_below = along[0] > T::ZERO || (along[0] >= T::ZERO && along[1] > T::ZERO);
        let side = if is_below { -1.0 } else { 1.0 };
        let depth = height + 1.0;
        let ends = [-RAIL, RAIL].map(|end| [end, side * depth]);
        pen.stroke(canvas, block, ends, MEDIUM);
        // The hatching stands still while the block slides.
        let remainder = HATCH * fraction(offset / pen.pixels(HATCH));
        let floor = pen::Spot {
            at: block.offset(T::ZERO, pen.pixels(side * depth)),
            along,
        };
        pen.hatch(canvas, floor, (HATCH - RAIL - remainder, RAIL, HATCH), side);
    } else {
        let reach = pen.pixels(2.0 * half);
        let least = if offset < reach {
            offset - reach
        } else {
            T::ZERO
        };
        let most = if offset > -reach {
            offset + reach
        } else {
            T::ZERO
        };
        let ends = [guide.offset(least, T::ZERO), guide.offset(most, T::ZERO)];
        pen.line(canvas, ends, BOLD);
    }
    let corners = [
        [-half, -height],
        [half, -height],
        [half, height],
        [-half, height],
    ];
    pen.figure(canvas, block, corners);
}

/// The fractional part of a number, above the whole number below it; of a number that is not finite, zero.
fn fraction<T: Scalar>(number: T) -> f32 {
    let remainder = number - Scalar::floor(number);
    if Real::is_finite(remainder) {
        remainder.to_f32()
    } else {
        0.0
    }
}

/// A pitch circle, with a tick by which it is seen to turn.
fn wheel<T: Scalar>(pen: &Pen<T>, canvas: &mut impl Canvas<T>, hub: pen::Spot<T>, radius: T) {
    let rim = hub.offset(radius, T::ZERO);
    pen.arc(canvas, hub.at, rim, <T as Real>::TURN, THIN);
    let inner = hub.offset(radius - pen.pixels(7.0), T::ZERO);
    pen.line(canvas, [inner, rim], MEDIUM);
}

/// The two strands of a belt: the outer tangents of its wheels.
fn belt<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut impl Canvas<T>,
    [from, to]: [[T; 2]; 2],
    radii: [T; 2],
) {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = Real::sqrt(x * x + y * y);
    let sine = (radii[0] - radii[1]) / length;
    let remainder = T::ONE - sine * sine;
    let [u, v] = [x / length, y / length];
    // Where one wheel is within the other, there is no tangent: NaN is not drawn.
    let cosine = Real::sqrt(remainder);
    for side in [cosine, -cosine] {
        let normal = [sine * u - side * v, sine * v + side * u];
        let touching = |[x, y]: [T; 2], radius: T| [x + radius * normal[0], y + radius * normal[1]];
        let ends = [touching(from, radii[0]), touching(to, radii[1])];
        pen.line(canvas, ends, THIN);
    }
}

/// The pitch line of a rack where its pinion touches it, with ticks that move with it.
fn rack<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut impl Canvas<T>,
    pinion: [T; 2],
    radius: T,
    bar: pen::Spot<T>,
) {
    let [u, v] = bar.along;
    let at = [pinion[0] + radius * v, pinion[1] - radius * u];
    let contact = pen::Spot { at, ..bar };
    let reach = Real::abs(radius) + Real::abs(radius);
    let ends = [
        contact.offset(-reach, T::ZERO),
        contact.offset(reach, T::ZERO),
    ];
    pen.line(canvas, ends, THIN);
    // Ticks half a radius apart, on the side away from the pinion.
    let apart = <T as Real>::HALF * Real::abs(radius);
    let offset = (at[0] - bar.at[0]) * u + (at[1] - bar.at[1]) * v;
    let remainder = apart * T::from_f32(fraction(offset / apart));
    let away = pen.pixels(if radius > T::ZERO { -5.0 } else { 5.0 });
    for number in -3..=4 {
        let ahead = apart * <T as Real>::from_i32(number) - remainder;
        let tick = [contact.offset(ahead, T::ZERO), contact.offset(ahead, away)];
        pen.line(canvas, tick, THIN);
    }
}

/// A double arrow beside what a motor slides.
fn slide_arrow<T: Scalar>(pen: &Pen<T>, canvas: &mut impl Canvas<T>, block: pen::Spot<T>) {
    // On the side where the rail is not.
    let [u, v] = block.along;
    let is_above = u > T::ZERO || (u >= T::ZERO && v > T::ZERO);
    let beside = if is_above { 14.0 } else { -14.0 };
    pen.stroke(canvas, block, [[-12.0, beside], [12.0, beside]], MEDIUM);
    let beside = pen.pixels(beside);
    for ahead in [18.0, -18.0] {
        let at = block.offset(pen.pixels(ahead), beside);
        let along = if ahead > 0.0 { [u, v] } else { [-u, -v] };
        head(pen, canvas, pen::Spot { at, along }, 1.0);
    }
}
