//! Rates and forces beside a change point, exactly as in the generated code's runtime.

use super::Stop;
use super::journey::Move;
use super::run::Runner;
use crate::program::{AtZero, Forces, LinkRates, Position, Watch};
use mech_core::Real;
use mech_core::limit::{self, NODES, Surroundings};

/// Rates or forces that have a limit at change points.
pub(super) trait Interpolated<T>: Sized {
    /// The same made number by number from those at some positions.
    fn interpolate(nodes: &[Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self;
}

/// Computes rates or forces at a position: beside a change point their limit, if they have one.
pub(super) fn limit<T: Real, R: Interpolated<T>>(
    runner: &Runner<'_, T>,
    here: &Position<T>,
    compute: impl Fn(&Position<T>) -> Result<R, Stop>,
) -> Result<R, Stop> {
    let beside = Beside { runner, here, compute: &compute };
    let mut sines = beside.passing().map(|watch| here.state[watch.sine]);
    if sines.any(limit::is_near)
        && let Some(rates) = limit::rates(&beside, here)
    {
        return Ok(rates);
    }
    compute(here)
}

/// A position beside a change point.
struct Beside<'a, 'p, T: Real, F> {
    runner: &'a Runner<'p, T>,
    here: &'a Position<T>,
    compute: &'a F,
}

impl<T: Real, F> Beside<'_, '_, T, F> {
    /// The loops that pass change points.
    fn passing(&self) -> impl Iterator<Item = &Watch> {
        let watches = self.runner.program.watches.iter();
        watches.filter(|watch| watch.at_zero == AtZero::ChangeBranch)
    }
}

impl<T: Real, R: Interpolated<T>, F: Fn(&Position<T>) -> Result<R, Stop>> Surroundings<T>
    for Beside<'_, '_, T, F>
{
    type Position = Position<T>;
    type Rates = R;

    fn inputs(&self) -> usize {
        self.here.motors.len()
    }

    fn sine(&self, position: &Position<T>) -> T {
        let sines = self.passing().map(|watch| position.state[watch.sine].abs());
        sines.fold(T::ONE, |least, sine| if sine < least { sine } else { least })
    }

    fn rate(&self, input: usize) -> T {
        let rates = self.passing().map(|watch| T::from_f64(watch.rates[input]));
        rates.fold(T::ZERO, T::max)
    }

    fn moved(&self, from: &Position<T>, input: usize, by: T) -> Option<Position<T>> {
        let mut values = self.here.motors.clone();
        values[input] = values[input] + by;
        let turns = self.here.turns.clone();
        Move::new(self.runner, from, &values, &turns).travel().ok()
    }

    fn rates(&self, position: &Position<T>) -> Option<R> {
        (self.compute)(position).ok()
    }

    fn interpolate(nodes: &[R; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> R {
        R::interpolate(nodes, by)
    }
}

impl<T: Real> Interpolated<T> for LinkRates<T> {
    fn interpolate(nodes: &[Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        let accelerations = nodes.each_ref().map(|node| node.accelerations.as_ref());
        let accelerations = match accelerations {
            [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] => Some([a, b, c, d, e, f]),
            _ => None,
        };
        Self {
            velocities: of_links(nodes.each_ref().map(|node| &node.velocities), by),
            accelerations: accelerations.map(|nodes| of_links(nodes, by)),
        }
    }
}

fn of_links<T: Real>(
    nodes: [&Vec<[T; 3]>; NODES],
    by: &mut impl FnMut([T; NODES]) -> T,
) -> Vec<[T; 3]> {
    let part = |link: usize, index: usize| nodes.map(|node| node[link][index]);
    let links = 0..nodes[0].len();
    links.map(|link| [0, 1, 2].map(|index| by(part(link, index)))).collect()
}

impl<T: Real> Interpolated<T> for Forces<T> {
    fn interpolate(nodes: &[Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        // Transmission angles are not smooth where they are zero; their squares are.
        let squared =
            nodes.each_ref().map(|node| node.with_transmission(|angle| angle * angle).roots());
        let mut number = 0;
        let found = nodes[0].map(|_| {
            number += 1;
            by(squared.each_ref().map(|node| node[number - 1]))
        });
        found.with_transmission(|square| square.max(T::ZERO).sqrt())
    }
}
