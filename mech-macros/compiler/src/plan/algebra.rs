//! The arithmetic that geometry is written in: with numbers to assemble a mechanism now, with symbols to write the
//! program that moves it later. The formulas stand only once.

use crate::model::Axis;

/// Scalars and what can be done with them.
pub(crate) trait Algebra {
    /// A scalar.
    type Scalar: Copy;

    fn constant(&mut self, value: f64) -> Self::Scalar;
    fn add(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    fn sub(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    fn mul(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    fn neg(&mut self, a: Self::Scalar) -> Self::Scalar;

    fn vector(&mut self, [x, y]: [f64; 2]) -> [Self::Scalar; 2] {
        [self.constant(x), self.constant(y)]
    }

    /// Where an axis is in its link: with numbers, at the start.
    fn place(&mut self, axis: &Axis) -> [Self::Scalar; 2] {
        self.vector(axis.at)
    }

    /// The direction of an axis in its link: with numbers, at the start.
    fn direction(&mut self, axis: &Axis) -> [Self::Scalar; 2] {
        self.vector(axis.direction)
    }

    /// The same, mirrored in the link's x axis: the opposite angle.
    fn mirrored_direction(&mut self, axis: &Axis) -> [Self::Scalar; 2] {
        let [x, y] = axis.direction;
        self.vector([x, -y])
    }

    /// The way from one axis of a link to another, in the link.
    fn between(&mut self, from: &Axis, to: &Axis) -> [Self::Scalar; 2] {
        self.vector([to.at[0] - from.at[0], to.at[1] - from.at[1]])
    }

    fn plus(&mut self, a: [Self::Scalar; 2], b: [Self::Scalar; 2]) -> [Self::Scalar; 2] {
        [self.add(a[0], b[0]), self.add(a[1], b[1])]
    }

    fn minus(&mut self, a: [Self::Scalar; 2], b: [Self::Scalar; 2]) -> [Self::Scalar; 2] {
        [self.sub(a[0], b[0]), self.sub(a[1], b[1])]
    }

    fn scaled(&mut self, factor: Self::Scalar, v: [Self::Scalar; 2]) -> [Self::Scalar; 2] {
        [self.mul(factor, v[0]), self.mul(factor, v[1])]
    }

    /// The product of two complex numbers: turns `v` by the angle of the unit vector `by`.
    fn turned(&mut self, by: [Self::Scalar; 2], v: [Self::Scalar; 2]) -> [Self::Scalar; 2] {
        let (cc, ss) = (self.mul(by[0], v[0]), self.mul(by[1], v[1]));
        let (sc, cs) = (self.mul(by[1], v[0]), self.mul(by[0], v[1]));
        [self.sub(cc, ss), self.add(sc, cs)]
    }

    /// The complex conjugate: the opposite angle.
    fn conjugate(&mut self, v: [Self::Scalar; 2]) -> [Self::Scalar; 2] {
        [v[0], self.neg(v[1])]
    }

    fn dot(&mut self, a: [Self::Scalar; 2], b: [Self::Scalar; 2]) -> Self::Scalar {
        let (x, y) = (self.mul(a[0], b[0]), self.mul(a[1], b[1]));
        self.add(x, y)
    }

    fn cross(&mut self, a: [Self::Scalar; 2], b: [Self::Scalar; 2]) -> Self::Scalar {
        let (p, q) = (self.mul(a[0], b[1]), self.mul(a[1], b[0]));
        self.sub(p, q)
    }
}

/// Arithmetic now, in double precision.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Numbers;

impl Algebra for Numbers {
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

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }
}

/// The pose of a link: the direction of its x axis, and its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose<S> {
    pub(crate) direction: [S; 2],
    pub(crate) origin: [S; 2],
}

impl<S: Copy> Pose<S> {
    pub(crate) fn identity<A: Algebra<Scalar = S>>(algebra: &mut A) -> Self {
        Self {
            direction: algebra.vector([1.0, 0.0]),
            origin: algebra.vector([0.0, 0.0]),
        }
    }

    /// Where an axis of the link is.
    pub(crate) fn carry<A: Algebra<Scalar = S>>(self, algebra: &mut A, axis: &Axis) -> [S; 2] {
        let point = algebra.place(axis);
        self.carry_spot(algebra, point)
    }

    /// Where a spot of the link is.
    pub(crate) fn carry_spot<A: Algebra<Scalar = S>>(
        self,
        algebra: &mut A,
        spot: [S; 2],
    ) -> [S; 2] {
        let turned = algebra.turned(self.direction, spot);
        algebra.plus(self.origin, turned)
    }

    /// Where a point of the link is that no param moves.
    pub(crate) fn carry_point<A: Algebra<Scalar = S>>(
        self,
        algebra: &mut A,
        point: [f64; 2],
    ) -> [S; 2] {
        let point = algebra.vector(point);
        self.carry_spot(algebra, point)
    }

    /// Where an axis of the link points.
    pub(crate) fn heading<A: Algebra<Scalar = S>>(self, algebra: &mut A, axis: &Axis) -> [S; 2] {
        let direction = algebra.direction(axis);
        algebra.turned(self.direction, direction)
    }

    /// The pose, in this pose's outer frame, of what is at `inner` in this frame.
    pub(crate) fn then<A: Algebra<Scalar = S>>(self, algebra: &mut A, inner: Self) -> Self {
        let direction = algebra.turned(self.direction, inner.direction);
        let offset = algebra.turned(self.direction, inner.origin);
        Self {
            direction,
            origin: algebra.plus(self.origin, offset),
        }
    }

    /// The pose of the outer frame, seen from this one.
    pub(crate) fn inverse<A: Algebra<Scalar = S>>(self, algebra: &mut A) -> Self {
        let direction = algebra.conjugate(self.direction);
        let [x, y] = algebra.turned(direction, self.origin);
        Self {
            direction,
            origin: [algebra.neg(x), algebra.neg(y)],
        }
    }
}
