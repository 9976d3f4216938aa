//! Coming to rest under springs, weights and loads.

use super::{Holding, Motors, MoveLimits, Position, Stop, inputs, motors_of};
use crate::{Blocked, Cause, Real, Scalar};
use mech_core::rest::{self, Unrest};

/// A position that falls. `to` moves it to values of the inputs, and gives the torques that hold it there.
#[derive(Clone, Copy)]
struct Falling<T, S, const INPUTS: usize, const LINKS: usize, const STATE: usize> {
    position: Position<T, INPUTS, LINKS, STATE>,
    to: S,
}

impl<T, S, const I: usize, const M: usize, const L: usize, const K: usize> rest::Falling<T>
    for Falling<T, S, I, L, K>
where
    T: Scalar,
    S: Fn(&mut Position<T, I, L, K>, Motors<T, I>) -> Result<Holding<T, M>, Blocked<[T; I]>> + Copy,
{
    type Numbers = [T; M];
    type Stop = Blocked<[T; I]>;

    fn motors(&self) -> [T; M] {
        motors_of(self.position.motors.values)
    }

    fn move_to(&mut self, motors: &[T; M]) -> Result<[T; M], Blocked<[T; I]>> {
        let mut target = inputs(*motors, &self.position.motors);
        target.turns = self.position.motors.turns;
        (self.to)(&mut self.position, target).map(|held| held.torques)
    }
}

/// Lets a position fall until it is at rest. The motors that are not free are held. `units` are displacements of the motors that compare with
/// each other. Gives the torques of the motors that do not rest by themselves.
///
/// # Errors
/// If it does not come to rest. It then stays where it was.
pub fn come_to_rest<
    T,
    const I: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
>(
    position: &mut Position<T, I, L, K>,
    limits: &MoveLimits<T, I, W>,
    free: [bool; M],
    units: [T; M],
    to: impl Fn(&mut Position<T, I, L, K>, Motors<T, I>) -> Result<Holding<T, M>, Blocked<[T; I]>>
    + Copy,
) -> Result<[T; M], Blocked<[T; I]>>
where
    T: Scalar,
{
    let mut falling = Falling { position: *position, to };
    let infinity = <T as Real>::from_f64(f64::INFINITY);
    let mut ends = [[-infinity, infinity]; M];
    if let Some(range) = &limits.range {
        // Ends are compared with values that have their whole turns in them.
        falling.position.motors = Motors::new(position.motors.total());
        for (ends, range) in ends.iter_mut().zip(range) {
            *ends = *range;
        }
    }
    let here: [T; M] = rest::Falling::motors(&falling);
    for ((ends, here), is_free) in ends.iter_mut().zip(here).zip(free) {
        if !is_free {
            *ends = [here; 2];
        }
    }
    let mut rows = [[T::ZERO; M]; M];
    let refuse = |place, cause| position.refuse(Stop::new(place, cause), limits.inputs);
    match rest::fall(&mut falling, &units, &ends, &mut rows) {
        Ok(torques) => {
            *position = falling.position;
            Ok(torques)
        }
        Err(Unrest::Stopped(blocked)) => Err(blocked),
        Err(Unrest::Unloaded) => Err(refuse("", Cause::Unloaded)),
        Err(Unrest::Endless) => {
            // Named is the motor that has gone farthest.
            let (mut farthest, mut place) = (T::ZERO, "");
            let there = rest::Falling::motors(&falling);
            let motors = here.into_iter().zip(there).zip(units);
            for (((here, there), unit), input) in motors.zip(limits.inputs) {
                let far = Real::abs((there - here) / unit);
                if far > farthest {
                    (farthest, place) = (far, input.name());
                }
            }
            Err(refuse(place, Cause::Restless))
        }
    }
}
