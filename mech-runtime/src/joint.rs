//! What a mechanism tells of its joints.

use crate::Pose;
use crate::Scalar;
use crate::pose::pose_of;

/// A joint as it was declared: an entry of [`Mechanism::JOINTS`](crate::Mechanism::JOINTS).
///
/// ```
/// use mech_runtime::{Coordinate, JointKind, Mechanism, mechanism};
///
/// mechanism! {
///     struct SliderCrank;
///     link crank; link rod; link block;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (1, 0.5);
///     joint c = revolute(rod, block) at (4, 0);
///     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
///     motor a;
/// }
///
/// /// A table of any mechanism: each joint that has a coordinate, its unit and its value.
/// fn table<M: Mechanism>(mechanism: &M) -> Vec<(&'static str, &'static str, M::Scalar)> {
///     let joints = M::JOINTS.iter().zip(mechanism.joints().as_ref().to_vec());
///     let rows = joints.filter_map(|(joint, value)| Some((joint.name, joint.coordinate?.unit(), value?)));
///     rows.collect()
/// }
///
/// let mut slider_crank = SliderCrank::new();
/// slider_crank.move_to([7.0])?;
/// let rows = table(&slider_crank);
/// assert_eq!(rows[0], ("a", "rad", 7.0));                         // of a motor: whole turns are counted
/// assert_eq!(rows[3], ("x", "scene units", slider_crank.x()));
/// assert_eq!(SliderCrank::JOINTS[3].kind, JointKind::Prismatic);
/// assert_eq!(SliderCrank::JOINTS[3].links, ["ground", "block"]);
/// assert_eq!(SliderCrank::JOINTS[1].coordinate, Some(Coordinate::Angle));
/// # Ok::<(), mech_runtime::Blocked<[f64; 1]>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct JointInfo<T> {
    /// Its name.
    pub name: &'static str,
    /// What it does.
    pub kind: JointKind,
    /// The names of the links it joins, `ground` among them. Its coordinate is that of the second relative to the first.
    pub links: [&'static str; 2],
    /// Where each of the two links has it, at the start. None of what rolls and of cams, which have no place of their own.
    pub anchors: Option<[Anchor<T>; 2]>,
    /// The number of the motor that drives it: its place in [`MOTORS`](crate::Mechanism::MOTORS), and in the values given to moves.
    pub motor: Option<usize>,
    /// What its coordinate is. None of welds, of what rolls, of cams, and of joints that `show` leaves out.
    pub coordinate: Option<Coordinate>,
}

/// What a joint does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum JointKind {
    /// Two links turn about a common point.
    Revolute,
    /// Two links slide along a common line.
    Prismatic,
    /// A pin of the second link turns and slides in a slot of the first.
    Slot,
    /// Two links are one.
    Weld,
    /// Two toothed wheels roll on each other.
    Gear,
    /// A belt runs over two wheels.
    Belt,
    /// A wheel rolls on a toothed bar.
    Rack,
    /// The second link follows the cam of the first.
    Cam,
}

/// What the coordinate of a joint is measured in, and whether it counts whole turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Coordinate {
    /// A length in scene units.
    Length,
    /// An angle in radians between −π and π, found by an arc tangent. `continuous` in the declaration makes it [`Turns`](Self::Turns).
    Angle,
    /// An angle in radians that goes on over whole turns: of a motor, of what motors turn by gears and belts, or declared
    /// `continuous`.
    Turns,
}

impl Coordinate {
    /// Its unit: `rad` or `scene units`.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Length => "scene units",
            Self::Angle | Self::Turns => "rad",
        }
    }
}

/// Where a link has a joint, in the link's own frame. What depends on params is as at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Anchor<T> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`. None if `show` leaves its pose out.
    pub link: Option<usize>,
    /// The place of the joint, in scene units; where it slides, the point from which or to which its coordinate is measured.
    pub at: [T; 2],
    /// A vector of length one: the direction from which or to which its angle is measured, or the line along which it slides. Of the
    /// pin of a slot it means nothing.
    pub along: [T; 2],
}

impl<T> JointInfo<T> {
    #[doc(hidden)]
    #[must_use]
    pub const fn new(
        name: &'static str,
        kind: JointKind,
        links: [&'static str; 2],
        anchors: Option<[Anchor<T>; 2]>,
        motor: Option<usize>,
        coordinate: Option<Coordinate>,
    ) -> Self {
        Self {
            name,
            kind,
            links,
            anchors,
            motor,
            coordinate,
        }
    }
}

impl<T> Anchor<T> {
    #[doc(hidden)]
    #[must_use]
    pub const fn new(link: Option<usize>, at: [T; 2], along: [T; 2]) -> Self {
        Self { link, at, along }
    }
}

impl<T: Scalar> Anchor<T> {
    /// Where it is in the scene, in scene units, when the links have these [`poses`](crate::Mechanism::poses). None if its link has
    /// no pose among them.
    #[must_use]
    pub fn place(&self, poses: &[Pose<T>]) -> Option<[T; 2]> {
        Some(pose_of(self.link?, poses)?.apply(self.at))
    }

    /// Its direction in the scene, of length one, when the links have these [`poses`](crate::Mechanism::poses). None if its link has
    /// no pose among them.
    #[must_use]
    pub fn direction(&self, poses: &[Pose<T>]) -> Option<[T; 2]> {
        Some(pose_of(self.link?, poses)?.turn(self.along))
    }
}
