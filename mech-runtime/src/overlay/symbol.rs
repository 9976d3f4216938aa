//! The symbols of a mechanism.

use super::arrow::{head, turn};
use super::elastic;
use super::pen::{self, BOLD, MEDIUM, Pen, THIN, looking};
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

/// A spot on its link, looking along a direction of it.
fn directed<T: Scalar>(spot: Spot<T>, along: [T; 2], poses: &[Pose<T>]) -> Option<pen::Spot<T>> {
    let pose = Pose::of_link(spot.link, poses)?;
    let own = looking(spot.at, along);
    Some(pen::Spot { pose, own })
}

/// A spot on its link.
fn on<T: Scalar>(spot: Spot<T>, poses: &[Pose<T>]) -> Option<pen::Spot<T>> {
    directed(spot, [T::ONE, T::ZERO], poses)
}

/// The pose in the scene of a spot of a link, looking along a direction of it.
fn pose<T: Scalar>(spot: Spot<T>, along: [T; 2], poses: &[Pose<T>]) -> Option<Pose<T>> {
    let pose = Pose::of_link(spot.link, poses)?;
    Some(looking(pose.apply(spot.at), pose.turn(along)))
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
    canvas: &mut dyn Canvas<T>,
) -> Option<()> {
    match *symbol {
        Symbol::Bar { link, ends } => {
            let spot = pen::Spot::at(Pose::of_link(link, poses)?);
            pen.line(canvas, spot, ends, BOLD);
        }
        Symbol::Mark(spot) => pen.dot(canvas, on(spot, poses)?, 3.0),
        Symbol::Wheel { center, radius } => {
            wheel(pen, canvas, on(center, poses)?, radius);
        }
        Symbol::Belt { centers, radii } => {
            let [a, b] = centers;
            belt(pen, canvas, [place(a, poses)?, place(b, poses)?], radii);
        }
        Symbol::Rack { pinion, radius, bar, along } => {
            let bar = pose(bar, along, poses)?;
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
        Symbol::Slide { guide, along, block } => {
            let (rail, at) = (pose(guide, along, poses)?, place(block, poses)?);
            let line = directed(guide, along, poses)?;
            slide(pen, canvas, rail, at, (guide.link > 0).then_some(line));
        }
        Symbol::Weld(spot) => {
            let spot = on(spot, poses)?;
            let corners = [[-4.5, -4.5], [4.5, -4.5], [4.5, 4.5], [-4.5, 4.5]];
            pen.fill(canvas, spot, corners, pen.ink());
        }
        Symbol::Pivot(spot) => {
            let at = on(spot, poses)?;
            if spot.link == 0 {
                stand(pen, canvas, at);
            }
            pen.eye(canvas, at, PIVOT);
        }
        Symbol::Spring { ends: [a, b], beside } => {
            elastic::spring(pen, canvas, [place(a, poses)?, place(b, poses)?], beside);
        }
        Symbol::Damper { ends: [a, b], beside } => {
            elastic::damper(pen, canvas, [place(a, poses)?, place(b, poses)?], beside);
        }
        Symbol::TorsionSpring(spot) => elastic::torsion_spring(pen, canvas, place(spot, poses)?),
        Symbol::TorsionDamper(spot) => elastic::torsion_damper(pen, canvas, place(spot, poses)?),
        Symbol::Cam(spot) => {
            let places = [CAM[0], CAM[0] + CAM[1]].map(|ahead| [pen.pixels(ahead), T::ZERO]);
            pen.arc(canvas, on(spot, poses)?, places, <T as Real>::TURN, MEDIUM);
        }
        Symbol::Wedge { at, along } => {
            let spot = directed(at, along, poses)?;
            let [half, height] = WEDGE;
            let first = [-half, -height];
            pen.path(canvas, spot, [first, [half, -height], [half, height], first]);
        }
        Symbol::RotaryMotor(spot) => turn(pen, canvas, place(spot, poses)?, true, 16.0),
        Symbol::LinearMotor { block, guide, along } => {
            let along = Pose::of_link(guide, poses)?.turn(along);
            let at = place(block, poses)?;
            slide_arrow(pen, canvas, looking(at, along));
        }
    }
    Some(())
}

/// The triangle and the hatched base of a fixed pivot.
fn stand<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, spot: pen::Spot<T>) {
    let [height, half, base] = STAND;
    pen.figure(canvas, spot, [[0.0, 0.0], [half, -height], [-half, -height]]);
    pen.stroke(canvas, spot, [[-base, -height], [base, -height]], MEDIUM);
    let own = looking(spot.own.apply([T::ZERO, -pen.pixels(height)]), [T::ONE, T::ZERO]);
    let floor = pen::Spot { own, ..spot };
    pen.hatch(canvas, floor, (HATCH - base, HATCH, 5), -1.0);
}

/// A block on its rail, or on a line of a moving link.
fn slide<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut dyn Canvas<T>,
    guide: Pose<T>,
    at: [T; 2],
    line: Option<pen::Spot<T>>,
) {
    let along = [guide.cos, guide.sin];
    let pose = looking(at, along);
    let block = pen::Spot::at(pose);
    let [half, height] = BLOCK;
    let [offset, _] = guide.relative(at);
    if let Some(line) = line {
        let reach = pen.pixels(2.0 * half);
        let least = if offset < reach { offset - reach } else { T::ZERO };
        let most = if offset > -reach { offset + reach } else { T::ZERO };
        pen.line(canvas, line, [[least, T::ZERO], [most, T::ZERO]], BOLD);
    } else {
        // The rail lies below, or to the right where it is upright.
        let is_below = along[0] > T::ZERO || (along[0] >= T::ZERO && along[1] > T::ZERO);
        let side = if is_below { -1.0 } else { 1.0 };
        let depth = side * (height + 1.0);
        pen.path(canvas, block, [[-RAIL, depth], [RAIL, depth]]);
        // The hatching stands still while the block slides.
        let remainder = HATCH * fraction(offset / pen.pixels(HATCH));
        let at = pose.apply([-remainder, depth].map(|part| pen.pixels(part)));
        let floor = pen::Spot::at(looking(at, along));
        pen.hatch(canvas, floor, (HATCH - RAIL, HATCH, 14), side);
    }
    let corners = [[-half, -height], [half, -height], [half, height], [-half, height]];
    pen.figure(canvas, block, corners);
}

/// The fractional part of a number, above the whole number below it; of a number that is not finite, zero.
fn fraction<T: Scalar>(number: T) -> f32 {
    let remainder = number - Scalar::floor(number);
    if Real::is_finite(remainder) { remainder.to_f32() } else { 0.0 }
}

/// A pitch circle, with a tick by which it is seen to turn.
fn wheel<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, hub: pen::Spot<T>, radius: T) {
    let rim = [radius, T::ZERO];
    let inner = [radius - pen.pixels(7.0), T::ZERO];
    pen.arc(canvas, hub, [[T::ZERO; 2], rim], <T as Real>::TURN, THIN);
    pen.line(canvas, hub, [inner, rim], MEDIUM);
}

/// The two strands of a belt: the outer tangents of its wheels.
fn belt<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, centers: [[T; 2]; 2], radii: [T; 2]) {
    let Some((spot, length)) = pen::Spot::between(centers) else {
        return;
    };
    let sine = (radii[0] - radii[1]) / length;
    // Where one wheel is within the other, there is no tangent: NaN is not drawn.
    let cosine = Real::sqrt(T::ONE - sine * sine);
    for side in [cosine, -cosine] {
        let touching = |center: T, radius: T| [center + radius * sine, radius * side];
        let ends = [touching(T::ZERO, radii[0]), touching(length, radii[1])];
        pen.line(canvas, spot, ends, THIN);
    }
}

/// The pitch line of a rack where its pinion touches it, with ticks that move with it.
fn rack<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut dyn Canvas<T>,
    pinion: [T; 2],
    radius: T,
    bar: Pose<T>,
) {
    let along = [bar.cos, bar.sin];
    let contact = looking(pinion, along).apply([T::ZERO, -radius]);
    let contact = looking(contact, along);
    let reach = Real::abs(radius) + Real::abs(radius);
    let ends = [[-reach, T::ZERO], [reach, T::ZERO]];
    pen.line(canvas, pen::Spot::at(contact), ends, THIN);
    // Ticks half a radius apart, on the side away from the pinion.
    let apart = <T as Real>::HALF * Real::abs(radius);
    let [offset, _] = bar.relative([contact.x, contact.y]);
    let remainder = apart * T::from_f32(fraction(offset / apart));
    let ticks = pen::Spot::at(looking(contact.apply([-remainder, T::ZERO]), along));
    let away = pen.pixels(if radius > T::ZERO { -5.0 } else { 5.0 });
    for number in -3..=4 {
        let ahead = apart * <T as Real>::from_i32(number);
        pen.line(canvas, ticks, [[ahead, T::ZERO], [ahead, away]], THIN);
    }
}

/// A double arrow beside what a motor slides.
fn slide_arrow<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, block: Pose<T>) {
    // On the side where the rail is not.
    let is_above = block.cos > T::ZERO || (block.cos >= T::ZERO && block.sin > T::ZERO);
    let beside = if is_above { 14.0 } else { -14.0 };
    let spot = pen::Spot::at(block);
    pen.path(canvas, spot, [[-12.0, beside], [12.0, beside]]);
    for ahead in [18.0, -18.0] {
        let tip = [ahead, beside].map(|part| pen.pixels(part));
        let along = if ahead > 0.0 { T::ONE } else { -T::ONE };
        let own = looking(tip, [along, T::ZERO]);
        head(pen, canvas, pen::Spot { own, ..spot }, 1.0);
    }
}
