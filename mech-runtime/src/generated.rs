//! What generated code calls. Not for use by hand: it changes without notice.

pub use crate::{Blocked, Canvas, Isometry2, Mechanism, Outline, Point2, Pose, Shape};

use crate::{Cause, Scalar};

/// Everything that is carried from one move to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position<T, const MOTORS: usize, const LINKS: usize, const KEPT: usize> {
    /// The values of the motors.
    pub motors: [T; MOTORS],
    /// The poses of the moving links.
    pub poses: [Pose<T>; LINKS],
    /// What is carried besides: angles that gears need, unwrapped; the sides of dyads that pass change points.
    pub kept: [T; KEPT],
}

impl<T: Scalar, const MOTORS: usize, const LINKS: usize, const KEPT: usize>
    Position<T, MOTORS, LINKS, KEPT>
{
    /// The loops check themselves; what hangs on motors and gears alone may still overflow.
    fn checked(self) -> Result<Self, Blocked> {
        let finite = |pose: &Pose<T>| (pose.cos + pose.sin + pose.x + pose.y).is_finite();
        if self.poses.iter().all(finite) {
            Ok(self)
        } else {
            Err(Blocked::new("", Cause::Overflow))
        }
    }
}

fn all_finite<T: Scalar, const MOTORS: usize>(
    motors: [T; MOTORS],
    names: [&'static str; MOTORS],
) -> Result<(), Blocked> {
    match motors
        .into_iter()
        .zip(names)
        .find(|(motor, _)| !motor.is_finite())
    {
        Some((_, name)) => Err(Blocked::new(name, Cause::NotFinite)),
        None => Ok(()),
    }
}

/// Moves in one step.
///
/// # Errors
/// As `step`, or if a motor's value is not finite.
#[inline]
pub fn advance_at_once<T: Scalar, const MOTORS: usize, const LINKS: usize, const KEPT: usize>(
    start: &Position<T, MOTORS, LINKS, KEPT>,
    motors: [T; MOTORS],
    names: [&'static str; MOTORS],
    step: impl Fn(
        &Position<T, MOTORS, LINKS, KEPT>,
        [T; MOTORS],
    ) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked>,
) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked> {
    all_finite(motors, names)?;
    step(start, motors)?.checked()
}

/// Moves in one step if that works, else in as many as it takes.
///
/// # Errors
/// As `step`, or if a motor's value is not finite.
#[inline]
pub fn advance<T: Scalar, const MOTORS: usize, const LINKS: usize, const KEPT: usize>(
    start: &Position<T, MOTORS, LINKS, KEPT>,
    motors: [T; MOTORS],
    names: [&'static str; MOTORS],
    step: impl Fn(
        &Position<T, MOTORS, LINKS, KEPT>,
        [T; MOTORS],
    ) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked>,
) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked> {
    all_finite(motors, names)?;
    match step(start, motors).and_then(Position::checked) {
        Ok(position) => Ok(position),
        Err(blocked) => by_pieces(start, motors, blocked, step),
    }
}

#[cold]
fn by_pieces<T: Scalar, const MOTORS: usize, const LINKS: usize, const KEPT: usize>(
    start: &Position<T, MOTORS, LINKS, KEPT>,
    motors: [T; MOTORS],
    mut blocked: Blocked,
    step: impl Fn(
        &Position<T, MOTORS, LINKS, KEPT>,
        [T; MOTORS],
    ) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked>,
) -> Result<Position<T, MOTORS, LINKS, KEPT>, Blocked> {
    /// The smallest part of a motor step that is tried.
    const FINEST: f64 = 1.0 / 4096.0;
    let mut position = *start;
    let (mut done, mut stride) = (0.0, 0.5);
    while stride >= FINEST {
        let target = done + stride;
        let mut aim = motors;
        if target < 1.0 {
            let part = <T as Scalar>::from_f64(target);
            for (aim, from) in aim.iter_mut().zip(start.motors) {
                *aim = from + (*aim - from) * part;
            }
        }
        match step(&position, aim).and_then(Position::checked) {
            Ok(next) if target < 1.0 => {
                position = next;
                done = target;
                stride = (2.0 * stride).min(1.0 - done);
            }
            Ok(next) => return Ok(next),
            Err(reason) => {
                blocked = reason;
                stride *= 0.5;
            }
        }
    }
    Err(blocked)
}

/// Tests the margins of loops in closed form: none may be negative.
///
/// # Errors
/// The first loop whose margin is negative or not a number.
#[inline]
pub fn closes<T: Scalar, const LOOPS: usize>(
    margins: [T; LOOPS],
    places: [&'static str; LOOPS],
) -> Result<(), Blocked> {
    // So written that what is not a number does not pass.
    match margins
        .into_iter()
        .position(|margin| !(margin >= T::zero()))
    {
        None => Ok(()),
        Some(first) => Err(Blocked::new(
            places.get(first).copied().unwrap_or_default(),
            Cause::Open,
        )),
    }
}

/// Tests the result of a loop: its gap, and its determinant with the sign it has at the start.
///
/// # Errors
/// If the gap is greater than `accept` or the determinant less than `floor`, or either is not a number.
#[inline]
pub fn closed<T: Scalar, const N: usize>(
    gap: [T; N],
    accept: T,
    det: T,
    floor: T,
    place: &'static str,
) -> Result<(), Blocked> {
    // So written that what is not a number does not pass.
    let is_closed = gap.into_iter().all(|gap| gap.abs() <= accept);
    if is_closed && det >= floor {
        Ok(())
    } else {
        Err(Blocked::new(
            place,
            if is_closed {
                Cause::DeadPoint
            } else {
                Cause::Open
            },
        ))
    }
}

/// The solution of `rows · x = right` by elimination with partial pivoting, and the determinant. What is singular gives a
/// determinant of zero or numbers that are not finite.
#[must_use]
pub fn solve<T: Scalar, const N: usize>(mut rows: [[T; N]; N], mut right: [T; N]) -> ([T; N], T) {
    let mut det = T::one();
    for pivot in 0..N {
        let mut best = pivot;
        for row in pivot + 1..N {
            if rows[row][pivot].abs() > rows[best][pivot].abs() {
                best = row;
            }
        }
        if best != pivot {
            rows.swap(best, pivot);
            right.swap(best, pivot);
            det = -det;
        }
        det *= rows[pivot][pivot];
        for row in pivot + 1..N {
            let factor = rows[row][pivot] / rows[pivot][pivot];
            let above = rows[pivot];
            for (entry, over) in rows[row].iter_mut().zip(above).skip(pivot + 1) {
                *entry -= factor * over;
            }
            right[row] -= factor * right[pivot];
        }
    }
    for row in (0..N).rev() {
        let mut sum = right[row];
        for column in row + 1..N {
            sum -= rows[row][column] * right[column];
        }
        right[row] = sum / rows[row][row];
    }
    (right, det)
}

/// The sine and the cosine of an angle in radians.
#[inline]
pub fn sin_cos<T: Scalar>(angle: T) -> (T, T) {
    angle.libm_sin_cos()
}

/// The sine of an angle in radians.
#[inline]
pub fn sin<T: Scalar>(angle: T) -> T {
    angle.libm_sin_cos().0
}

/// The cosine of an angle in radians.
#[inline]
pub fn cos<T: Scalar>(angle: T) -> T {
    angle.libm_sin_cos().1
}

/// The angle of the vector (`x`, `y`), in radians.
#[inline]
pub fn atan2<T: Scalar>(y: T, x: T) -> T {
    y.libm_atan2(x)
}

/// The square root.
#[inline]
pub fn sqrt<T: Scalar>(value: T) -> T {
    nalgebra::ComplexField::sqrt(value)
}

/// The nearest whole number, halves away from zero.
#[inline]
pub fn round<T: Scalar>(value: T) -> T {
    value.libm_round()
}

/// An axis in the scene: the pose of its link, its origin and its direction in the link's frame.
type Axis<T> = (Pose<T>, [T; 2], [T; 2]);

fn heading<T: Scalar>((pose, _, [x, y]): Axis<T>) -> [T; 2] {
    [pose.cos * x - pose.sin * y, pose.sin * x + pose.cos * y]
}

/// The coordinate of a revolute joint: the angle from one axis's direction to the other's, in radians.
pub fn angle<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (heading(from), heading(to));
    atan2(a * d - b * c, a * c + b * d)
}

/// The coordinate of a prismatic joint: the way from one axis's origin to the other's, along the first.
pub fn slide<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (from.0.apply(from.1), to.0.apply(to.1));
    let [x, y] = heading(from);
    (c - a) * x + (d - b) * y
}

/// Paints shapes that are already in painting order.
pub fn paint<T: Scalar>(shapes: &[Shape<T>], poses: &[Pose<T>], canvas: &mut impl Canvas<T>) {
    for shape in shapes {
        let pose = match shape.link.checked_sub(1) {
            None => Some(Pose::identity()),
            Some(index) => poses.get(index).copied(),
        };
        if let Some(pose) = pose {
            canvas.fill(shape.outline, pose, shape.color);
        }
    }
}
