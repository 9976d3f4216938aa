//! Forces of motors and joints.

use super::Stop;
use super::interpolation::{Interpolated, Rates, array, row};
use crate::blocked::Input;
use crate::{Cause, Forces, Reaction, Real, Scalar};
use mech_core::limit::NODES;

/// The torques of the motors that hold the mechanism still.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Holding<T, const MOTORS: usize> {
    /// In the order of the motors.
    pub torques: [T; MOTORS],
}

impl<T: Scalar, const MOTORS: usize> Rates for Holding<T, MOTORS> {
    #[inline]
    fn is_finite(&self) -> bool {
        all_finite(&self.torques)
    }
}

impl<T: Scalar, const MOTORS: usize> Interpolated<T> for Holding<T, MOTORS> {
    fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        Self { torques: row(nodes.map(|node| &node.torques), by) }
    }
}

impl<T: Scalar, const M: usize, const J: usize, const L: usize, const D: usize> Rates
    for Forces<T, M, J, L, D>
{
    #[inline]
    fn is_finite(&self) -> bool {
        let reactions = self.reactions.iter();
        all_finite(&self.torques)
            && all_finite(&self.transmission)
            && self.velocity_ratios.iter().all(|row| all_finite(row))
            && reactions
                .map(|reaction| reaction.x + reaction.y + reaction.torque)
                .all(Real::is_finite)
    }
}

impl<T: Scalar, const M: usize, const J: usize, const L: usize, const D: usize> Interpolated<T>
    for Forces<T, M, J, L, D>
{
    fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        Self {
            torques: row(nodes.map(|node| &node.torques), by),
            reactions: array(nodes.map(|node| &node.reactions), Reaction::NONE, |nodes| Reaction {
                x: by(nodes.map(|reaction| reaction.x)),
                y: by(nodes.map(|reaction| reaction.y)),
                torque: by(nodes.map(|reaction| reaction.torque)),
            }),
            velocity_ratios: rows(nodes.map(|node| &node.velocity_ratios), by),
            // It is not smooth where it is zero; its square is.
            transmission: row(nodes.map(|node| &node.transmission), &mut |angles| {
                let square = by(angles.map(|angle| angle * angle));
                Real::sqrt(Real::max(square, T::ZERO))
            }),
        }
    }
}

/// Rows of numbers made number by number.
fn rows<T: Scalar, const ROWS: usize, const COUNT: usize>(
    nodes: [&[[T; COUNT]; ROWS]; NODES],
    by: &mut impl FnMut([T; NODES]) -> T,
) -> [[T; COUNT]; ROWS] {
    array(nodes, [T::ZERO; COUNT], |nodes| row(nodes.each_ref(), by))
}

/// Inertia and forces, reduced to the motors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia<T, const MOTORS: usize> {
    /// The reduced inertia, symmetric.
    pub matrix: [[T; MOTORS]; MOTORS],
    /// For each motor the torque that accelerates it apart from its own.
    pub drive: [T; MOTORS],
    /// The kinetic energy.
    pub kinetic: T,
    /// The potential energy of gravity and springs.
    pub potential: T,
}

impl<T: Scalar, const MOTORS: usize> Rates for Inertia<T, MOTORS> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.matrix.iter().all(|row| all_finite(row))
            && all_finite(&self.drive)
            && Real::is_finite(self.kinetic + self.potential)
    }
}

impl<T: Scalar, const MOTORS: usize> Interpolated<T> for Inertia<T, MOTORS> {
    fn interpolate(nodes: [&Self; NODES], by: &mut impl FnMut([T; NODES]) -> T) -> Self {
        Self {
            matrix: rows(nodes.map(|node| &node.matrix), by),
            drive: row(nodes.map(|node| &node.drive), by),
            kinetic: by(nodes.map(|node| node.kinetic)),
            potential: by(nodes.map(|node| node.potential)),
        }
    }
}

impl<T: Scalar, const MOTORS: usize> Inertia<T, MOTORS> {
    /// The accelerations of the motors under these torques and everything else, by Cholesky's method.
    ///
    /// # Errors
    /// The first motor that no mass resists there, or that a second rate is beyond the range of the numbers.
    pub fn accelerations<const INPUTS: usize>(
        &self,
        torques: [T; MOTORS],
        inputs: &[Input; INPUTS],
    ) -> Result<[T; MOTORS], Stop> {
        let mut rows = self.matrix;
        let mut sums: [T; MOTORS] =
            core::array::from_fn(|motor| torques[motor] + self.drive[motor]);
        for pivot in 0..MOTORS {
            let own = rows[pivot];
            let square = own[pivot] - products(&own[..pivot], &own[..pivot]);
            // A square within rounding of zero is no mass.
            let least = <T as Real>::from_f64(16.0 * T::EPSILON) * self.matrix[pivot][pivot];
            let resists = square > least;
            if !resists {
                return Err(Stop::new(inputs[pivot].name(), Cause::Massless));
            }
            let root = Real::sqrt(square);
            rows[pivot][pivot] = root;
            for row in &mut rows[pivot + 1..] {
                row[pivot] = (row[pivot] - products(&row[..pivot], &own[..pivot])) / root;
            }
            sums[pivot] = (sums[pivot] - products(&own[..pivot], &sums[..pivot])) / root;
        }
        for pivot in (0..MOTORS).rev() {
            let mut sum = sums[pivot];
            for (row, solved) in rows.iter().zip(sums).skip(pivot + 1) {
                sum -= row[pivot] * solved;
            }
            sums[pivot] = sum / rows[pivot][pivot];
        }
        if all_finite(&sums) { Ok(sums) } else { Err(Stop::new("", Cause::Overflow)) }
    }
}

/// The message that something given is not a finite number.
#[must_use]
pub const fn not_finite(place: &'static str) -> Stop {
    Stop::new(place, Cause::NotFinite)
}

/// The force with which a spring between two points pulls them together.
#[must_use]
pub fn pull<T: Scalar>(from: [T; 2], to: [T; 2], stiffness: T, natural_length: T) -> T {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let longer = Real::max(Real::abs(x), Real::abs(y));
    let length = if longer > T::ZERO {
        // Squares of parts of it, because its own square may overflow.
        let [x, y] = [x / longer, y / longer];
        longer * Real::sqrt(x * x + y * y)
    } else {
        T::ZERO
    };
    stiffness * (length - natural_length)
}

/// The scalar product of two rows of numbers.
fn products<T: Scalar>(a: &[T], b: &[T]) -> T {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(T::ZERO, |sum, product| sum + product)
}

fn all_finite<T: Scalar>(numbers: &[T]) -> bool {
    numbers.iter().all(|number| Real::is_finite(*number))
}
