//! Descriptions of joints.

use crate::Pose;
use crate::Scalar;
use mech_core::{Coordinate, JointKind};

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
    /// The name.
    pub name: &'static str,
    /// The kind.
    pub kind: JointKind,
    /// The names of the two links, or `ground`. The coordinate is that of the second relative to the first.
    pub links: [&'static str; 2],
    /// The place of the joint on each of the two links, at the start. `None` for gears, belts, racks and cams.
    pub anchors: Option<[Anchor<T>; 2]>,
    /// The number of its motor in [`MOTORS`](crate::Mechanism::MOTORS) and in the arguments of moves. `None` if it has no motor.
    pub motor: Option<usize>,
    /// The kind of its coordinate. `None` for welds, gears, belts, racks, cams, and joints that `show` leaves out.
    pub coordinate: Option<Coordinate>,
}

/// The place of a joint in the frame of one of its links, with the params as declared.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Anchor<T> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`. `None` if `show` leaves its pose out.
    pub link: Option<usize>,
    /// The place of the joint, in scene units. Of a joint that slides: the point from or to which its coordinate is measured.
    pub at: [T; 2],
    /// A vector of length one: the direction from or to which its angle is measured, or the line along which it slides. It has no
    /// meaning for the pin of a slot.
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
        Self { name, kind, links, anchors, motor, coordinate }
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
    /// Its place in the scene, in scene units, when the links have these [`poses`](crate::Mechanism::poses). `None` if its link has no
    /// pose among them.
    #[must_use]
    pub fn place(&self, poses: &[Pose<T>]) -> Option<[T; 2]> {
        Some(Pose::of_link(self.link?, poses)?.apply(self.at))
    }

    /// Its direction in the scene, of length one, when the links have these [`poses`](crate::Mechanism::poses). `None` if its link has no
    /// pose among them.
    #[must_use]
    pub fn direction(&self, poses: &[Pose<T>]) -> Option<[T; 2]> {
        Some(Pose::of_link(self.link?, poses)?.turn(self.along))
    }
}
