//! What a lecture constructs over a mechanism, as on a blackboard: instant centres, polygons of velocities and accelerations, free bodies, centrodes, inflection circles.

mod board;
mod body;
mod centres;
mod mark;
mod panel;
mod path;
mod polygon;
mod push;
mod spot;

#[cfg(feature = "editor")]
pub(crate) use board::Rolling;
pub(crate) use board::{Board, Filmed};
#[cfg(feature = "editor")]
pub(crate) use path::Centrodes;

/// A place in the scene, or a vector.
type Place = [f64; 2];

/// What is constructed over a mechanism.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Construction {
    /// Instant centres, with the lines on which Kennedy's theorem has them.
    Centres,
    /// The velocity polygon.
    Velocities,
    /// The acceleration polygon.
    Accelerations,
    /// The free body of each link, with the forces and torques on it.
    Forces,
    /// Both centrodes of the link of this name, relative to the ground.
    Centrodes(String),
    /// The inflection circle of the link of this name, relative to the ground.
    Inflection(String),
}
