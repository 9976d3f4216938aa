//! The distance of a watched loop's sine from zero, and the part of it that rounding hides.

use super::{AtZero, Growth, Journey, Standing};
use crate::Real;

/// Rounding moves a loop by so many roundings at most.
const ROUNDINGS: f64 = 64.0;

/// A loop has left a change point where its sine is more than so many times what rounding hides. It has come to one where its sine is
/// less than the second factor. Between them rounding cannot decide.
pub(super) const WELL_AWAY: f64 = 6.0;
pub(super) const NEAR: f64 = 3.0;

/// Loops whose zeros are nearer to each other than this are passed together.
pub(super) const NEAREST: f64 = 0.03125;

/// Whether a loop that is passed over its change points is solved by iteration: it does not stand there.
pub(super) fn is_stepped_over<T: Real, J: Journey<T>>(journey: &J, index: usize) -> bool {
    let watch = journey.watch(index);
    watch.iterated && watch.at_zero != AtZero::Stay
}

pub(super) fn is_zero<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    let sine = journey.sine(position, index);
    !is_stepped_over(journey, index) && sine * sine <= hidden_square(journey, position, index)
}

/// Whether such a loop is so near a zero of its sine that it may have a change point there.
pub(super) fn is_near<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    is_stepped_over(journey, index) && {
        let sine = journey.sine(position, index);
        sine * sine <= journey.rounding_square(position, index)
    }
}

/// The square of a sine of a loop below which rounding hides its sign.
pub(super) fn hidden_square<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> T {
    // Between two parts of the move that rounding tells apart a sine changes by so much.
    let resolution = journey.watch(index).change * T::from_f64(T::EPSILON);
    journey.rounding_square(position, index)
        + passed_on(journey, position, index)
        + resolution * resolution
}

/// The square of the rounding that earlier loops pass on to a sine: the nearer one of them is to its own zero, the more.
fn passed_on<T: Real, J: Journey<T>>(journey: &J, position: &J::Position, index: usize) -> T {
    let rounding = T::from_f64(ROUNDINGS * T::EPSILON);
    journey.growth(index).fold(T::ZERO, |sum, growth| {
        let Growth::Near(earlier) = growth else {
            return sum;
        };
        let sine = journey.sine(position, earlier);
        sum + rounding * rounding / (sine * sine).max(rounding)
    })
}

/// Whether rounding cannot make the sine of a loop vanish.
pub(super) fn is_well_away<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    exceeds(journey, position, index, WELL_AWAY)
}

/// Whether the sine of a loop is more than so many times as great as what rounding hides.
pub(super) fn exceeds<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
    times: f64,
) -> bool {
    let sine = journey.sine(position, index) * T::from_f64(1.0 / times);
    sine * sine > hidden_square(journey, position, index)
}

/// Whether a loop has passed the change point that it stands at.
pub(super) fn has_passed<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    journey.standing(position, index) == Standing::Passed
}

/// Puts a loop on its other side: it has passed its change point.
pub(super) fn pass<T: Real, J: Journey<T>>(journey: &J, position: &mut J::Position, index: usize) {
    journey.turn_over(position, index);
    journey.set_standing(position, index, Standing::Passed);
}

/// Whether a loop in closed form that can change its branch stands where it does.
pub(super) fn stands_at_change_point<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    let watch = journey.watch(index);
    watch.at_zero == AtZero::ChangeBranch && !watch.iterated && is_zero(journey, position, index)
}

/// A distance from a zero: so many fourth roots of the precision, as a part of the move.
pub(super) fn distance<T: Real, J: Journey<T>>(journey: &J, index: usize, times: f64) -> T {
    T::from_f64(times) * T::from_f64(T::EPSILON).sqrt().sqrt() / journey.watch(index).change
}
