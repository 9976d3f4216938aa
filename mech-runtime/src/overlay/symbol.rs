//! The symbols of a mechanism.

use super::arrow::{head, turn};
use super::elastic;
use super::pen::{self, BOLD, MEDIUM, Pen, THIN};
use crate::pose::pose_of;
use crate::{Canvas, Pose, Real, Scalar};

/// A place on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot<T> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// The place in its frame, in scene units.
    pub at: [T; 2],
}

/// A symbol of a mechanism. Lengths are in scene units. Directions have length one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symbol<T> {
    /// A side of a link, from one of its joints to the next.
    Bar {
        /// The link, numbered as in [`Spot`].
        link: usize,
        /// Both ends, in its frame.
        ends: [[T; 2]; 2],
    },
    /// A named point of a link without a joint.
    Mark(Spot<T>),
    /// The pitch circle of a wheel.
    Wheel {
        /// The centre.
        center: Spot<T>,
        /// The radius.
        radius: T,
    },
    /// The strands of a belt between two wheels.
    Belt {
        /// The centres of the wheels.
        centers: [Spot<T>; 2],
        /// Their radii.
        radii: [T; 2],
    },
    /// The pitch line of a toothed bar.
    Rack {
        /// The centre of the pinion.
        pinion: Spot<T>,
        /// The pinion's pitch radius; negative if the bar is on its other side.
        radius: T,
        /// The bar, at the origin of the line along which it slides.
        bar: Spot<T>,
        /// The direction of that line, in the bar's frame.
        along: [T; 2],
    },
    /// A line along which something slides.
    Line {
        /// The origin.
        at: Spot<T>,
        /// The direction, in the link's frame.
        along: [T; 2],
    },
    /// A point about which something turns.
    Point(Spot<T>),
    /// A prismatic joint, or that of a slot.
    Slide {
        /// The part with the guide, at the origin of its line.
        guide: Spot<T>,
        /// The direction of the guide, in its link's frame.
        along: [T; 2],
        /// The part that slides.
        block: Spot<T>,
    },
    /// A weld.
    Weld(Spot<T>),
    /// A revolute joint; on the ground, a fixed pivot.
    Pivot(Spot<T>),
    /// A spring between two points.
    Spring {
        /// Its ends.
        ends: [Spot<T>; 2],
        /// How many pixels to the left of the line between them it is drawn.
        beside: f32,
    },
    /// A damper between two points.
    Damper {
        /// Its ends.
        ends: [Spot<T>; 2],
        /// How many pixels to the left of the line between them it is drawn.
        beside: f32,
    },
    /// A torsional spring at a joint.
    TorsionSpring(Spot<T>),
    /// A torsional damper at a joint.
    TorsionDamper(Spot<T>),
    /// A cam that turns, at its shaft.
    Cam(Spot<T>),
    /// A cam that slides.
    Wedge {
        /// Its place.
        at: Spot<T>,
        /// The direction in which it slides, in its link's frame.
        along: [T; 2],
    },
    /// A motor that turns.
    RotaryMotor(Spot<T>),
    /// A motor that slides.
    LinearMotor {
        /// The link that it moves.
        block: Spot<T>,
        /// The link with the guide, numbered as in [`Spot`].
        guide: usize,
        /// The guide's direction, in that link's frame.
        along: [T; 2],
    },
}

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

impl<T: Scalar> Spot<T> {
    /// The place in the scene.
    fn place(self, poses: &[Pose<T>]) -> Option<[T; 2]> {
        Some(pose_of(self.link, poses)?.apply(self.at))
    }

    /// The place and a direction of its link, in the scene.
    fn with(self, along: [T; 2], poses: &[Pose<T>]) -> Option<pen::Spot<T>> {
        let pose = pose_of(self.link, poses)?;
        let at = pose.apply(self.at);
        let along = pose.turn(along);
        Some(pen::Spot { at, along })
    }
}

impl<T: Scalar> Symbol<T> {
    /// The kind.
    pub(super) const fn kind(&self) -> Kind {
        match self {
            Self::Bar { .. }
            | Self::Mark(_)
            | Self::Wheel { .. }
            | Self::Belt { .. }
            | Self::Rack { .. }
            | Self::Cam(_)
            | Self::Wedge { .. } => Kind::Link,
            Self::Slide { .. }
            | Self::Weld(_)
            | Self::Pivot(_)
            | Self::Spring { .. }
            | Self::Damper { .. }
            | Self::TorsionSpring(_)
            | Self::TorsionDamper(_) => Kind::Joint,
            Self::RotaryMotor(_) | Self::LinearMotor { .. } => Kind::Motor,
            Self::Line { .. } | Self::Point(_) => Kind::Axis,
        }
    }

    /// Draws it, if the poses of its links are known.
    pub(super) fn draw(
        &self,
        poses: &[Pose<T>],
        pen: &Pen<T>,
        canvas: &mut impl Canvas<T>,
    ) -> Option<()> {
        match *self {
            Self::Bar { link, ends } => {
                let pose = pose_of(link, poses)?;
                pen.line(canvas, ends.map(|end| pose.apply(end)), BOLD);
            }
            Self::Mark(spot) => pen.dot(canvas, spot.place(poses)?, 3.0),
            Self::Wheel { center, radius } => {
                let spot = center.with([T::ONE, T::ZERO], poses)?;
                wheel(pen, canvas, spot, radius);
            }
            Self::Belt { centers, radii } => {
                let [a, b] = centers;
                belt(pen, canvas, [a.place(poses)?, b.place(poses)?], radii);
            }
            Self::Rack {
                pinion,
                radius,
                bar,
                along,
            } => {
                let bar = bar.with(along, poses)?;
                rack(pen, canvas, pinion.place(poses)?, radius, bar);
            }
            Self::Line { at, along } => {
                let spot = at.with(along, poses)?;
                for dash in [-34.0_f32, -19.0, -4.0, 11.0, 26.0] {
                    pen.stroke(canvas, spot, [[dash, 0.0], [dash + 8.0, 0.0]], THIN);
                }
                for dot in [-22.5_f32, -7.5, 7.5, 22.5] {
                    pen.stroke(canvas, spot, [[dot - 0.5, 0.0], [dot + 0.5, 0.0]], THIN);
                }
            }
            Self::Point(spot) => {
                let spot = pen::Spot::upright(spot.place(poses)?);
                pen.stroke(canvas, spot, [[-7.0, 0.0], [7.0, 0.0]], THIN);
                pen.stroke(canvas, spot, [[0.0, -7.0], [0.0, 7.0]], THIN);
            }
            Self::Slide {
                guide,
                along,
                block,
            } => {
                let (rail, at) = (guide.with(along, poses)?, block.place(poses)?);
                slide(pen, canvas, rail, at, guide.link == 0);
            }
            Self::Weld(spot) => {
                let spot = spot.with([T::ONE, T::ZERO], poses)?;
                let corners = [[-4.5, -4.5], [4.5, -4.5], [4.5, 4.5], [-4.5, 4.5]];
                pen.fill(canvas, spot, corners, pen.ink());
            }
            Self::Pivot(spot) => {
                let at = spot.place(poses)?;
                if spot.link == 0 {
                    stand(pen, canvas, at);
                }
                pen.eye(canvas, at, PIVOT);
            }
            Self::Spring {
                ends: [a, b],
                beside,
            } => elastic::spring(pen, canvas, [a.place(poses)?, b.place(poses)?], beside),
            Self::Damper {
                ends: [a, b],
                beside,
            } => elastic::damper(pen, canvas, [a.place(poses)?, b.place(poses)?], beside),
            Self::TorsionSpring(spot) => elastic::torsion_spring(pen, canvas, spot.place(poses)?),
            Self::TorsionDamper(spot) => elastic::torsion_damper(pen, canvas, spot.place(poses)?),
            Self::Cam(spot) => {
                let spot = spot.with([T::ONE, T::ZERO], poses)?;
                let center = spot.offset(pen.pixels(CAM[0]), T::ZERO);
                let start = spot.offset(pen.pixels(CAM[0] + CAM[1]), T::ZERO);
                pen.arc(canvas, center, start, <T as Real>::TURN, MEDIUM);
            }
            Self::Wedge { at, along } => {
                let spot = at.with(along, poses)?;
                let [half, height] = WEDGE;
                let corners = [[-half, -height], [half, -height], [half, height]];
                pen.path(canvas, spot, corners.into_iter().chain([[-half, -height]]));
            }
            Self::RotaryMotor(spot) => turn(pen, canvas, spot.place(poses)?, true, 16.0),
            Self::LinearMotor {
                block,
                guide,
                along,
            } => {
                let along = pose_of(guide, poses)?.turn(along);
                let at = block.place(poses)?;
                slide_arrow(pen, canvas, pen::Spot { at, along });
            }
        }
        Some(())
    }
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
