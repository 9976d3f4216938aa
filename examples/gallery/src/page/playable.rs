//! Mechanisms of any type for a player.

use crate::{Layer, Layers, Scene, Spot};
use mech_runtime::{Blocked, Reached};

/// A mechanism of any type for a player. [`Exhibit::playable`](crate::Exhibit::playable) makes one.
///
/// Motor values are in the order of [`motor_names`](Self::motor_names), in radians or scene units. Motors without a value keep theirs, and
/// surplus values are left out.
pub trait Playable {
    /// The names of the joints that have a motor.
    fn motor_names(&self) -> &'static [&'static str];
    /// Whether the motor of this joint slides: then its values are lengths.
    fn slides(&self, motor: &str) -> bool;
    /// The present values of the motors.
    fn motors(&self) -> Vec<f64>;
    /// Returns to the start.
    fn reset(&mut self);
    /// The values of the motors at a phase of the exhibit's own motion, from 0 to 1.
    fn motion(&self, phase: f64) -> Vec<f64>;

    /// Moves the motors towards these values, as far as possible. Then the mechanism has these rates, or zeros where it is at a limit or
    /// rates are not determined.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite. The mechanism then stays where it was.
    fn move_toward(
        &mut self,
        motors: &[f64],
        rates: &Rates,
    ) -> Result<Reached<Vec<f64>>, Blocked<Vec<f64>>>;

    /// The place in the scene of a place on a link. `None` if the link does not exist.
    fn place(&self, spot: Spot) -> Option<[f64; 2]>;
    /// The place after a move towards these motor values, as far as possible.
    fn place_toward(&self, spot: Spot, motors: &[f64]) -> Option<[f64; 2]>;
    /// The place on the visible moving link, or else on the nearest one. `None` if that is farther away than `reach`.
    fn spot_at(&self, place: [f64; 2], reach: f64) -> Option<Spot>;
    /// The place of a joint in the scene, if it turns, slides or welds.
    fn joint(&self, name: &str) -> Option<[f64; 2]>;

    /// Whether it can show a layer.
    fn offers(&self, layer: Layer) -> bool;
    /// Draws the mechanism.
    fn draw(&self, scene: &mut Scene, look: &Look);
}

/// Rates of motors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// The rates, in radians or scene units per second. Missing ones are 0.
    pub first: Vec<f64>,
    /// The second rates.
    pub second: Vec<f64>,
}

/// The look of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The visible layers.
    pub layers: Layers,
    /// The size of symbols relative to the usual one.
    pub size: f32,
    /// The length of the arrow for a velocity of one scene unit per second, in scene units.
    pub velocity: f64,
    /// The length of the arrow for an acceleration of one.
    pub acceleration: f64,
}
