//! Coordinates over any number of turns: they go on where they are, whatever path a mechanism takes. They are followed here by hand,
//! in small steps.

mod by_hand;
mod continuous;
mod springs;
mod subjects;

use proptest::prelude::*;

/// Moves of so many motors, one after the other.
fn moves(motors: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::collection::vec(prop::collection::vec(-16.0..16.0, motors), 1..5)
}
