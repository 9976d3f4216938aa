//! Rates and forces that have a limit at change points, made number by number from those at some positions.

use crate::{Acceleration, Real, Scalar, Velocity};
use mech_core::limit::NODES;

/// The rates of all links.
pub trait Rates: Copy {
    /// Whether all rates are finite, and so small that the rates of points and joints are finite too.
    fn is_finite(&self) -> bool;
}

/// Rates or forces that have a limit at change points.
pub trait Interpolated<T>: Rates {
    /// The same made number by number from those at some positions.
    fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self;
}

/// A row of numbers made number by number.
pub(super) fn row<T: Scalar, const COUNT: usize>(
    nodes: [&[T; COUNT]; NODES],
    by: &mut impl FnMut([T; NODES]) -> T,
) -> [T; COUNT] {
    array(nodes, T::ZERO, by)
}

/// An array made element by element. All arrays have one length, but the compiler does not always see that, so `none` stands in for a
/// panic.
pub(super) fn array<E: Copy, const COUNT: usize>(
    nodes: [&[E; COUNT]; NODES],
    none: E,
    mut by: impl FnMut([E; NODES]) -> E,
) -> [E; COUNT] {
    core::array::from_fn(|index| by(nodes.map(|node| node.get(index).copied().unwrap_or(none))))
}

/// Whether numbers are so small that their products with other rates and lengths are finite.
#[inline]
fn leave_room<T: Scalar>(rates: impl Iterator<Item = [T; 3]>) -> bool {
    let sum =
        rates.fold(T::ZERO, |sum, [a, b, c]| sum + (Real::abs(a) + Real::abs(b) + Real::abs(c)));
    Real::is_finite(sum * sum * sum)
}

macro_rules! rates_of_links {
    ($rates:ident) => {
        impl<T: Scalar, const LINKS: usize> Rates for [$rates<T>; LINKS] {
            #[inline]
            fn is_finite(&self) -> bool {
                leave_room(self.iter().map(|rate| [rate.angular, rate.x, rate.y]))
            }
        }

        impl<T: Scalar, const LINKS: usize> Interpolated<T> for [$rates<T>; LINKS] {
            fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
                array(nodes, $rates::ZERO, |nodes| $rates {
                    angular: by(nodes.map(|node| node.angular)),
                    x: by(nodes.map(|node| node.x)),
                    y: by(nodes.map(|node| node.y)),
                })
            }
        }
    };
}
rates_of_links!(Velocity);
rates_of_links!(Acceleration);

impl<T: Scalar, const LINKS: usize> Rates for ([Velocity<T>; LINKS], [Acceleration<T>; LINKS]) {
    #[inline]
    fn is_finite(&self) -> bool {
        self.0.is_finite() && self.1.is_finite()
    }
}

impl<T: Scalar, const LINKS: usize> Interpolated<T>
    for ([Velocity<T>; LINKS], [Acceleration<T>; LINKS])
{
    fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        let velocities = <[Velocity<T>; LINKS]>::interpolate(nodes.map(|node| &node.0), by);
        let accelerations = <[Acceleration<T>; LINKS]>::interpolate(nodes.map(|node| &node.1), by);
        (velocities, accelerations)
    }
}
