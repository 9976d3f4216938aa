//! The arithmetic of geometry: with numbers it assembles a mechanism now, with symbols it makes the program that moves it later. So each
//! formula stands once.

use crate::model::{Arithmetic, Axis};

/// An arithmetic with roots, vectors and the places of axes.
pub(crate) trait Algebra<S: Copy>: Arithmetic<Scalar = S> {
    fn sqrt(&mut self, a: S) -> S;

    /// The value at the start. A number is that value itself.
    fn number_at_start(&self, value: S) -> f64;

    /// Gives a value a name for readers. A number has none.
    fn label(&mut self, value: S, _name: &str) -> S {
        value
    }

    /// The difference of two lengths; exactly zero where it is only rounding.
    fn difference(&mut self, a: S, b: S) -> S;

    fn vector(&mut self, [x, y]: [f64; 2]) -> [S; 2] {
        [self.constant(x), self.constant(y)]
    }

    /// The place of an axis in its link: with numbers, at the start.
    fn place(&mut self, axis: &Axis) -> [S; 2] {
        self.vector(axis.at)
    }

    /// The direction of an axis in its link: with numbers, at the start.
    fn direction(&mut self, axis: &Axis) -> [S; 2] {
        self.vector(axis.direction)
    }

    /// The same, mirrored in the link's x axis: the opposite angle.
    fn mirrored_direction(&mut self, axis: &Axis) -> [S; 2] {
        let [x, y] = axis.direction;
        self.vector([x, -y])
    }

    /// The vector from one axis of a link to another, in the link.
    fn between(&mut self, from: &Axis, to: &Axis) -> [S; 2] {
        self.vector([to.at[0] - from.at[0], to.at[1] - from.at[1]])
    }

    fn plus(&mut self, a: [S; 2], b: [S; 2]) -> [S; 2] {
        [self.add(a[0], b[0]), self.add(a[1], b[1])]
    }

    fn minus(&mut self, a: [S; 2], b: [S; 2]) -> [S; 2] {
        [self.sub(a[0], b[0]), self.sub(a[1], b[1])]
    }

    fn scale(&mut self, factor: S, v: [S; 2]) -> [S; 2] {
        [self.mul(factor, v[0]), self.mul(factor, v[1])]
    }

    /// The product of two complex numbers: turns `v` by the angle of the unit vector `by`.
    fn rotate(&mut self, by: [S; 2], v: [S; 2]) -> [S; 2] {
        let (cc, ss) = (self.mul(by[0], v[0]), self.mul(by[1], v[1]));
        let (sc, cs) = (self.mul(by[1], v[0]), self.mul(by[0], v[1]));
        [self.sub(cc, ss), self.add(sc, cs)]
    }

    /// The complex conjugate: the opposite angle.
    fn conjugate(&mut self, v: [S; 2]) -> [S; 2] {
        [v[0], self.neg(v[1])]
    }

    fn dot(&mut self, a: [S; 2], b: [S; 2]) -> S {
        let (x, y) = (self.mul(a[0], b[0]), self.mul(a[1], b[1]));
        self.add(x, y)
    }

    fn cross(&mut self, a: [S; 2], b: [S; 2]) -> S {
        let (p, q) = (self.mul(a[0], b[1]), self.mul(a[1], b[0]));
        self.sub(p, q)
    }
}

/// Arithmetic now, in double precision.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Numbers;

impl Arithmetic for Numbers {
    type Scalar = f64;

    fn constant(&mut self, value: f64) -> f64 {
        value
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn sub(&mut self, a: f64, b: f64) -> f64 {
        a - b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }
}

impl Algebra<f64> for Numbers {
    fn sqrt(&mut self, a: f64) -> f64 {
        a.sqrt()
    }

    fn number_at_start(&self, value: f64) -> f64 {
        value
    }

    fn difference(&mut self, a: f64, b: f64) -> f64 {
        if are_equal(a, b, f64::EPSILON) { 0.0 } else { a - b }
    }
}

/// Whether only rounding makes two lengths differ.
pub(crate) fn are_equal(a: f64, b: f64, epsilon: f64) -> bool {
    /// In units of rounding.
    const EQUAL: f64 = 4.0;
    (a - b).abs() <= EQUAL * epsilon * a
}

/// The pose of a link: the direction of its x axis, and its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose<S> {
    pub(crate) direction: [S; 2],
    pub(crate) origin: [S; 2],
}

impl<S: Copy> Pose<S> {
    pub(crate) fn identity(algebra: &mut impl Algebra<S>) -> Self {
        Self { direction: algebra.vector([1.0, 0.0]), origin: algebra.vector([0.0, 0.0]) }
    }

    /// Cosine, sine, x and y.
    pub(crate) fn numbers(self) -> [S; 4] {
        let ([cos, sin], [x, y]) = (self.direction, self.origin);
        [cos, sin, x, y]
    }

    /// The place of an axis of the link in the outer frame.
    pub(crate) fn carry(self, algebra: &mut impl Algebra<S>, axis: &Axis) -> [S; 2] {
        let point = algebra.place(axis);
        self.carry_spot(algebra, point)
    }

    /// The place of a spot of the link in the outer frame.
    pub(crate) fn carry_spot(self, algebra: &mut impl Algebra<S>, spot: [S; 2]) -> [S; 2] {
        let turned = algebra.rotate(self.direction, spot);
        algebra.plus(self.origin, turned)
    }

    /// Where a point of the link is that no param moves.
    pub(crate) fn carry_point(self, algebra: &mut impl Algebra<S>, point: [f64; 2]) -> [S; 2] {
        let point = algebra.vector(point);
        self.carry_spot(algebra, point)
    }

    /// Where an axis of the link points.
    pub(crate) fn heading(self, algebra: &mut impl Algebra<S>, axis: &Axis) -> [S; 2] {
        let direction = algebra.direction(axis);
        algebra.rotate(self.direction, direction)
    }

    /// The pose, in this pose's outer frame, of what is at `inner` in this frame.
    pub(crate) fn then(self, algebra: &mut impl Algebra<S>, inner: Self) -> Self {
        let direction = algebra.rotate(self.direction, inner.direction);
        let offset = algebra.rotate(self.direction, inner.origin);
        Self { direction, origin: algebra.plus(self.origin, offset) }
    }

    /// The pose of the outer frame, seen from this one.
    pub(crate) fn inverse(self, algebra: &mut impl Algebra<S>) -> Self {
        let direction = algebra.conjugate(self.direction);
        let [x, y] = algebra.rotate(direction, self.origin);
        Self { direction, origin: [algebra.neg(x), algebra.neg(y)] }
    }
}
