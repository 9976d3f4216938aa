//! Positions of what can be moved.

use mech_compiler::program::Position;
pub(crate) use mech_test_support::journeys::Subject;

/// Every bit of a position.
pub(crate) fn bits(position: &Position<f64>) -> Vec<u64> {
    let numbers = position.poses.iter().flatten();
    let numbers = numbers.chain(&position.motors).chain(&position.state);
    let turns = position
        .turns
        .iter()
        .map(|turns| u64::from(turns.cast_unsigned()));
    numbers
        .map(|number| number.to_bits())
        .chain(turns)
        .collect()
}
