//! Forces in a mechanism, and methods that integrate motion under them.

use crate::Scalar;

/// The forces that a given motion takes, in units of the declared masses, lengths and times. The mechanism has `MOTORS` motors and `JOINTS`
/// joints. `LOADS` numbers describe its loads, and `DYADS` of its loops are dyads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces<
    T,
    const MOTORS: usize,
    const JOINTS: usize,
    const LOADS: usize,
    const DYADS: usize,
> {
    /// The torques of the motors (the forces of those that slide), in the order of their declaration.
    pub torques: [T; MOTORS],
    /// The reaction in each joint, in the order of `JOINTS`.
    pub reactions: [Reaction<T>; JOINTS],
    /// For each motor, the rate of each load when that motor alone moves at unit rate. A force has two rates: the velocity of its point
    /// along x and y. A torque has one: the angular velocity of its link.
    pub velocity_ratios: [[T; LOADS]; MOTORS],
    /// The transmission angles of the dyads, from 0 to π/2, in the order in which the loops are solved.
    pub transmission: [T; DYADS],
}

/// The force and torque that the first link of a joint exerts on the second, at the joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction<T> {
    /// The force along the scene's x.
    pub x: T,
    /// The force along the scene's y.
    pub y: T,
    /// The torque. In a revolute joint it is that of its motor, if any. Where teeth touch it is zero. In a belt it is what the
    /// first wheel exerts on the second; divided by the second's radius, it is the difference of the tensions.
    pub torque: T,
}

impl<T: Scalar> Reaction<T> {
    /// None.
    pub(crate) const NONE: Self = Self { x: T::ZERO, y: T::ZERO, torque: T::ZERO };
}

/// Gauss–Legendre collocation of a given order, for a step of time. Each method is symmetric in time, so energy does not drift.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GaussLegendre {
    /// The implicit midpoint rule: one stage, order 2.
    Order2,
    /// Two stages, order 4.
    #[default]
    Order4,
    /// Three stages, order 6.
    Order6,
}
