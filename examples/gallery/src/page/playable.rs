//! A mechanism to play with, whatever its type.

use crate::{Layer, Layers, Scene, Spot};
use mech_runtime::{Blocked, Reached};

/// A mechanism to play with, whatever its type. Made by [`Exhibit::playable`](crate::Exhibit::playable).
///
/// Values of motors are in the order of [`motor_names`](Self::motor_names), in radians or scene units. Where there are fewer than
/// motors, the others are taken as they are; what is too many is left out.
pub trait Playable {
    /// The names of the joints that have a motor.
    fn motor_names(&self) -> &'static [&'static str];
    /// Whether the motor of this joint slides: then its values are lengths.
    fn slides(&self, motor: &str) -> bool;
    /// The present values of the motors.
    fn motors(&self) -> Vec<f64>;
    /// Everything is as it was at the start again.
    fn reset(&mut self);
    /// The values of the motors at a phase of the exhibit's own motion, which takes from 0 to 1.
    fn motion(&self, phase: f64) -> Vec<f64>;

    /// Moves towards these values of the motors, as far as it can. It then has these rates; at a limit, and wherever rates are not
    /// determined, none.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite; it then stays where it was.
    fn move_toward(
        &mut self,
        motors: &[f64],
        rates: &Rates,
    ) -> Result<Reached<Vec<f64>>, Blocked<Vec<f64>>>;

    /// Where a place on a link is in the scene; `None` of a link that does not exist.
    fn place(&self, spot: Spot) -> Option<[f64; 2]>;
    /// Where it would be after a move towards these values of the motors, as far as it can.
    fn place_toward(&self, spot: Spot, motors: &[f64]) -> Option<[f64; 2]>;
    /// The place on the moving link that is seen here, or else on the one that comes nearest, unless it is farther away than `reach`.
    fn spot_at(&self, place: [f64; 2], reach: f64) -> Option<Spot>;
    /// Where a joint is in the scene, if it is one that turns, slides or welds.
    fn joint(&self, name: &str) -> Option<[f64; 2]>;

    /// Whether it can show a layer.
    fn offers(&self, layer: Layer) -> bool;
    /// Draws it.
    fn draw(&self, scene: &mut Scene, look: &Look);
}

/// How fast motors move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// Their rates, in radians or scene units a second; 0 where there is none.
    pub first: Vec<f64>,
    /// The rates of these.
    pub second: Vec<f64>,
}

/// How a mechanism is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// What is seen of it.
    pub layers: Layers,
    /// How many times as large as usual symbols are drawn.
    pub size: f32,
    /// How long the arrow for a velocity of one scene unit a second is, in scene units.
    pub velocity: f64,
    /// The same for an acceleration.
    pub acceleration: f64,
}
