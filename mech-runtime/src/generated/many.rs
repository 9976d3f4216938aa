//! Many positions at once, in lanes that the compiler vectorises.

use super::{Motors, Position};
use crate::{Blocked, BlockedAt, Cause, Columns, Pose, Real, Scalar};
use mech_core::trig;

/// The number of positions that are tested for room at once.
const BLOCK: usize = 64;

/// A source of sines and cosines.
pub trait Sines<T> {
    /// The sine and the cosine of an angle in radians.
    fn sin_cos(angle: T) -> (T, T);
}

/// Sines and cosines of any angle.
#[derive(Clone, Copy, Debug)]
pub struct FullRange;

impl<T: Scalar> Sines<T> for FullRange {
    #[inline]
    fn sin_cos(angle: T) -> (T, T) {
        Real::sin_cos(angle)
    }
}

/// Sines and cosines of angles within the range of the polynomials, without a test. The bits are the same.
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl Sines<f64> for Reduced {
    #[inline]
    fn sin_cos(angle: f64) -> (f64, f64) {
        trig::sin_cos_within_f64(angle)
    }
}

impl Sines<f32> for Reduced {
    #[inline]
    fn sin_cos(angle: f32) -> (f32, f32) {
        trig::sin_cos_within_f32(angle)
    }
}

type Lanes<T, const L: usize, const LANES: usize> = [[[T; LANES]; 4]; L];

/// The positions of a lane each, if all of them close. `kernel` gives the poses, and the least of the loops' margins.
#[inline]
fn lanes<T: Scalar, const M: usize, const L: usize, const LANES: usize>(
    motors: &[[T; M]; LANES],
    reach: T,
    kernel: impl Fn([T; M]) -> ([Pose<T>; L], T),
) -> Option<Lanes<T, L, LANES>> {
    let mut inside = true;
    for motor in motors.as_flattened() {
        inside &= Real::abs(*motor) <= reach;
    }
    if !inside {
        return None;
    }
    let mut lanes = [[[T::ZERO; LANES]; 4]; L];
    let mut margins = [T::ZERO; LANES];
    for lane in 0..LANES {
        let (poses, margin) = kernel(motors[lane]);
        for link in 0..L {
            lanes[link][0][lane] = poses[link].cos;
            lanes[link][1][lane] = poses[link].sin;
            lanes[link][2][lane] = poses[link].x;
            lanes[link][3][lane] = poses[link].y;
        }
        margins[lane] = margin;
    }
    let mut closes = true;
    for margin in margins {
        closes &= margin >= T::ZERO;
    }
    closes.then_some(lanes)
}

/// The positions at many motor values, each as if moved there from where the mechanism is.
///
/// # Errors
/// The first that is blocked; those before it are in the columns.
#[inline]
pub fn solve_many<T: Scalar, const M: usize, const L: usize, const LANES: usize>(
    motors: &[[T; M]],
    columns: &mut Columns<'_, T, L>,
    reach: T,
    kernel: impl Fn([T; M]) -> ([Pose<T>; L], T),
    one: impl Fn([T; M]) -> Result<[Pose<T>; L], Blocked<[T; M]>>,
) -> Result<(), BlockedAt<[T; M]>> {
    let mut first = 0;
    while let Some(block) = motors.get(first..).and_then(<[_]>::first_chunk::<BLOCK>)
        && let Some(mut places) = columns.block::<BLOCK>(first)
        && solve_block::<T, M, L, LANES>(block, &mut places, reach, &kernel)
    {
        first += BLOCK;
    }
    for chunk in motors.get(first..).unwrap_or_default().chunks(LANES) {
        let found = <&[[T; M]; LANES]>::try_from(chunk)
            .ok()
            .and_then(|chunk| lanes::<T, M, L, LANES>(chunk, reach, &kernel));
        match found {
            Some(lanes) if first + LANES <= columns.len() => columns.put_lanes(first, &lanes),
            _ => {
                for (index, motors) in (first..).zip(chunk) {
                    let poses = one(*motors).map_err(|blocked| BlockedAt { index, blocked })?;
                    if !columns.put(index, &poses) {
                        let blocked = Blocked::new("", Cause::NoRoom, *motors);
                        return Err(BlockedAt { index, blocked });
                    }
                }
            }
        }
        first += chunk.len();
    }
    Ok(())
}

/// Solves a block. Returns whether all of it closes.
#[inline]
fn solve_block<T: Scalar, const M: usize, const L: usize, const LANES: usize>(
    motors: &[[T; M]; BLOCK],
    places: &mut [[Option<&mut [T; BLOCK]>; 4]; L],
    reach: T,
    kernel: impl Fn([T; M]) -> ([Pose<T>; L], T),
) -> bool {
    for (number, chunk) in motors.as_chunks::<LANES>().0.iter().enumerate() {
        let Some(lanes) = lanes(chunk, reach, &kernel) else {
            return false;
        };
        for (places, lanes) in places.iter_mut().zip(&lanes) {
            for (place, lane) in places.iter_mut().zip(lanes) {
                if let Some(place) = place
                    && let Some(place) = place.as_chunks_mut::<LANES>().0.get_mut(number)
                {
                    *place = *lane;
                }
            }
        }
    }
    true
}

/// Moves many instances, each to its own motor values.
///
/// # Errors
/// The first that is blocked; those before it have moved, those after it have not.
#[inline]
pub fn move_many<
    I,
    T: Scalar,
    const M: usize,
    const L: usize,
    const K: usize,
    const LANES: usize,
>(
    instances: &mut [I],
    motors: &[[T; M]],
    reach: T,
    position: impl Fn(&mut I) -> &mut Position<T, M, L, K>,
    kernel: impl Fn([T; M]) -> ([Pose<T>; L], T),
    one: impl Fn(&mut I, [T; M]) -> Result<(), Blocked<[T; M]>>,
) -> Result<(), BlockedAt<[T; M]>> {
    move_many_then::<_, _, _, _, _, LANES>(instances, motors, reach, position, kernel, |_| (), one)
}

/// Moves many instances, each to its own motor values, and calls `then` for each that `kernel` has moved.
///
/// # Errors
/// As [`move_many`].
#[inline]
pub fn move_many_then<
    I,
    T: Scalar,
    const M: usize,
    const L: usize,
    const K: usize,
    const LANES: usize,
>(
    instances: &mut [I],
    motors: &[[T; M]],
    reach: T,
    position: impl Fn(&mut I) -> &mut Position<T, M, L, K>,
    kernel: impl Fn([T; M]) -> ([Pose<T>; L], T),
    then: impl Fn(&mut I),
    one: impl Fn(&mut I, [T; M]) -> Result<(), Blocked<[T; M]>>,
) -> Result<(), BlockedAt<[T; M]>> {
    let mut first = 0;
    for (instances, chunk) in instances.chunks_mut(LANES).zip(motors.chunks(LANES)) {
        let found = <&[[T; M]; LANES]>::try_from(chunk)
            .ok()
            .filter(|_| instances.len() == LANES)
            .and_then(|chunk| lanes::<T, M, L, LANES>(chunk, reach, &kernel));
        match found {
            Some(lanes) => {
                for (lane, (instance, motors)) in instances.iter_mut().zip(chunk).enumerate() {
                    let position = position(instance);
                    position.motors = Motors::new(*motors);
                    for (pose, lanes) in position.poses.iter_mut().zip(&lanes) {
                        let [cos, sin, x, y] = lanes.each_ref().map(|part| part[lane]);
                        *pose = Pose { cos, sin, x, y };
                    }
                    then(instance);
                }
            }
            None => {
                for (index, (instance, motors)) in (first..).zip(instances.iter_mut().zip(chunk)) {
                    one(instance, *motors).map_err(|blocked| BlockedAt { index, blocked })?;
                }
            }
        }
        first += LANES;
    }
    Ok(())
}

/// The least of the margins of loops.
#[inline]
#[must_use]
pub fn min_margin<T: Scalar, const N: usize>(margins: [T; N]) -> T {
    let mut least = T::ONE;
    for margin in margins {
        // Written so that NaN stays.
        least = if margin >= least { least } else { margin };
    }
    least
}
