//! Rates beside a change point.

use super::interpolation::Interpolated;
use super::journey::Move;
use super::{Motors, MoveLimits, Position, Stop};
use crate::{Real, Scalar};
use core::marker::PhantomData;
use mech_core::journey;
use mech_core::limit::{self, NODES, Surroundings};

/// A position beside a change point.
struct Beside<
    'a,
    T: 'static,
    R,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    F,
    S,
> {
    limits: &'a MoveLimits<T, M, W>,
    here: &'a Position<T, M, L, K>,
    step_full: &'a F,
    step: &'a S,
    rates: PhantomData<R>,
}

/// The limit of rates; none if they have none.
#[cold]
#[inline(never)]
pub(super) fn rates<T, R, const M: usize, const L: usize, const K: usize, const W: usize>(
    here: &Position<T, M, L, K>,
    limits: &MoveLimits<T, M, W>,
    step_full: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<(Position<T, M, L, K>, R), Stop>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Option<R>
where
    T: Scalar,
    R: Interpolated<T>,
{
    let beside = Beside { limits, here, step_full, step, rates: PhantomData };
    limit::rates(&beside, here)
}

impl<T, R, const M: usize, const L: usize, const K: usize, const W: usize, F, S> Surroundings<T>
    for Beside<'_, T, R, M, L, K, W, F, S>
where
    T: Scalar,
    R: Interpolated<T>,
    F: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<(Position<T, M, L, K>, R), Stop>,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    type Position = Position<T, M, L, K>;
    type Rates = R;

    fn inputs(&self) -> usize {
        M
    }

    fn sine(&self, position: &Self::Position) -> T {
        let sines = self.limits.passing();
        let sines = sines.filter_map(|watched| position.state.get(watched.sine));
        // No sine is greater.
        let least = |least, sine: &T| {
            if Real::abs(*sine) < least { Real::abs(*sine) } else { least }
        };
        sines.fold(T::ONE, least)
    }

    fn rate(&self, input: usize) -> T {
        let rates = self.limits.passing();
        let rates = rates.filter_map(|watched| watched.rates.get(input));
        rates.fold(T::ZERO, |greatest, rate| Real::max(greatest, *rate))
    }

    fn moved(&self, from: &Self::Position, input: usize, by: T) -> Option<Self::Position> {
        let mut target = self.here.motors;
        *target.values.get_mut(input)? += by;
        let going = Move::new(self.limits, from, target, self.step);
        journey::travel(&going, from).ok()
    }

    fn rates(&self, position: &Self::Position) -> Option<R> {
        let found = (self.step_full)(position, position.motors).ok();
        found.map(|(_, rates)| rates).filter(R::is_finite)
    }

    fn interpolate(nodes: &[R; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> R {
        R::interpolate(nodes.each_ref(), by)
    }
}
