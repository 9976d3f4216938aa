//! The style in which a mechanism is drawn while it is played.

use super::Layers;

/// Rates of motors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// The rates, in radians or scene units per second. Missing ones are 0.
    pub first: Vec<f64>,
    /// The second rates.
    pub second: Vec<f64>,
}

/// The place, velocity and acceleration of a point while the motors have rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointRates {
    /// Where it is in the scene.
    pub place: [f64; 2],
    /// Its velocity.
    pub velocity: [f64; 2],
    /// Its acceleration, where it is determined.
    pub acceleration: Option<[f64; 2]>,
}

/// The style in which a mechanism is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The visible layers.
    pub layers: Layers,
    /// The size of symbols relative to the usual one.
    pub size: f32,
    /// The length of the arrow for a velocity of one scene unit per second, in scene units.
    pub velocity: f64,
    /// The length of the arrow for an acceleration of one.
    pub acceleration: f64,
}
