//! Forces in a mechanism.

/// What it takes to move a mechanism of `MOTORS` motors and `JOINTS` joints in a given way. `LOADS` numbers say what its loads
/// are, `DYADS` of its loops are dyads.
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
    /// For each motor how fast each number of the loads is followed if it alone moves, at a rate of one: the velocity of the point
    /// of a force along x and y, the angular velocity of the link of a torque.
    pub velocity_ratios: [[T; LOADS]; MOTORS],
    /// The transmission angles, from 0 to π/2, of the loops that are dyads, in the order in which they are solved.
    pub transmission: [T; DYADS],
}

/// What the first link of a joint does to the second, there where the joint is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction<T> {
    /// The force along the scene's x.
    pub x: T,
    /// The force along the scene's y.
    pub y: T,
    /// The torque. In a revolute joint it is that of its motor, if it has one; in a gear, belt or rack there is none.
    pub torque: T,
}
