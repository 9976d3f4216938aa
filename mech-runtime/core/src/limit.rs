//! Rates and forces beside a change point, as their limit.
//!
//! At a change point the equations for rates are 0/0, and beside it rounding spoils what they give. But a loop that goes straight on passes
//! it smoothly, and so do its rates. So they are found at three positions on each side that are far enough away, and interpolated.

use crate::Real;

/// The number of positions that are interpolated, half of them on each side.
pub const NODES: usize = 6;
/// Their distances from the middle, in units of that of the nearest.
const PLACES: [f64; NODES] = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0];
/// A sine is near zero if its eighth power is less than so many times the precision. There the cube of the sine divides a rounding to
/// about what interpolation leaves out, the sixth power of the distance.
const NEAR: f64 = 32.0;
/// Numbers that are not smooth by more than this many times the fourth power of that sine have no limit.
const ROUGH: f64 = 16.0;
/// Numbers that are smooth to within this part of the cube of the sine need no smaller distances: interpolation then leaves out no more
/// than rounding hides.
const SMOOTH: f64 = 0.25;
/// If they are less smooth, distances are halved, so often at most. Each halving makes rounding eight times as great.
const MOST_WIDTHS: u32 = 6;
/// Limits for how much farther the next position is tried than the last, until the sine is great enough. So often it is tried, and up to
/// so many times the first distance. An input that gets no farther does not pass the change point.
const LONGER: [f64; 2] = [1.2, 4.0];
const MOST_DISTANCES: u32 = 24;
const FARTHEST: f64 = 256.0;
/// The next distance is a little more than a straight line asks for.
const BEYOND: f64 = 1.05;

/// A position, and everything that is needed to find rates in its neighbourhood.
pub trait Surroundings<T: Real> {
    /// A position.
    type Position;
    /// The rates or forces at a position.
    type Rates;

    /// Returns the number of motors and params.
    fn inputs(&self) -> usize;
    /// The least size at a position of the sines of all loops that pass change points.
    fn sine(&self, position: &Self::Position) -> T;
    /// The greatest rate of the square of such a sine, for an input that moves alone.
    fn rate(&self, input: usize) -> T;
    /// The position after one input has moved by this from the middle, on the way from another such position; none if it cannot be
    /// reached.
    fn moved(&self, from: &Self::Position, input: usize, by: T) -> Option<Self::Position>;
    /// The rates there by the equations.
    fn rates(&self, position: &Self::Position) -> Option<Self::Rates>;
    /// Makes rates number by number from those at the nodes.
    fn interpolate(
        nodes: &[Self::Rates; NODES],
        by: &mut impl FnMut([T; NODES]) -> T,
    ) -> Self::Rates;
}

/// Whether a sine is so near zero that rounding spoils rates.
#[inline]
pub fn is_near<T: Real>(sine: T) -> bool {
    let square = sine * sine;
    let fourth = square * square;
    fourth * fourth < T::from_f64(NEAR * T::EPSILON)
}

/// The rates as their limit; none where they have none, or the equations give more.
pub fn rates<T: Real, S: Surroundings<T>>(around: &S, here: &S::Position) -> Option<S::Rates> {
    let fourth = T::from_f64(NEAR * T::EPSILON).sqrt();
    let rough = T::from_f64(ROUGH) * fourth;
    let mut width = fourth.sqrt().sqrt();
    let mut smooth = T::from_f64(SMOOTH) * width * width * width;
    // The first that are not rough, for where none are smooth.
    let mut spare = None;
    for _ in 0..MOST_WIDTHS {
        if around.sine(here) >= width {
            return None;
        }
        let mut is_open = false;
        for input in 0..around.inputs() {
            let sides = [T::ONE, -T::ONE].map(|sign| clear(around, here, (input, sign), width));
            let [Some(ahead), Some(behind)] = sides else {
                continue;
            };
            is_open = true;
            let nodes = Nodes { input, width, nearest: [behind, ahead] };
            match nodes.rates(around) {
                Some((rates, roughness)) if roughness <= smooth => return Some(rates),
                Some((rates, roughness)) if roughness <= rough && spare.is_none() => {
                    spare = Some(rates);
                }
                _ => {}
            }
        }
        // Beside a dead point there is only one side.
        if !is_open {
            break;
        }
        width = width * T::HALF;
        let next = smooth * T::from_f64(4.0);
        smooth = if next < rough { next } else { rough };
    }
    spare
}

/// The nearest position on one side at which sines are great enough, and how far the input moved there.
fn clear<T: Real, S: Surroundings<T>>(
    around: &S,
    here: &S::Position,
    (input, sign): (usize, T),
    width: T,
) -> Option<(S::Position, T)> {
    // A sine that may be one, and is zero in the middle, takes so long.
    let mut by = width * T::HALF / around.rate(input);
    let farthest = by * T::from_f64(FARTHEST);
    let mut before = (T::ZERO, around.sine(here));
    let mut position = around.moved(here, input, sign * by)?;
    for _ in 0..MOST_DISTANCES {
        let sine = around.sine(&position);
        if sine >= width {
            return Some((position, sign * by));
        }
        let slope = (sine - before.1) / (by - before.0);
        // Where it becomes less it goes through zero.
        let rest = if slope > T::ZERO { width - sine } else { width + sine };
        before = (by, sine);
        let [least, most] = LONGER.map(|longer| by * T::from_f64(longer));
        let next = by + T::from_f64(BEYOND) * rest / slope.abs();
        by = if next < most { next.max(least) } else { most };
        if by > farthest {
            return None;
        }
        position = around.moved(&position, input, sign * by)?;
    }
    None
}

/// The nodes along an input.
struct Nodes<P, T> {
    input: usize,
    /// The sine that is great enough.
    width: T,
    /// The nearest ones behind and ahead, and how far they are.
    nearest: [(P, T); 2],
}

impl<P, T: Real> Nodes<P, T> {
    /// The rates here, and how far they are from smooth.
    fn rates<S: Surroundings<T, Position = P>>(&self, around: &S) -> Option<(S::Rates, T)> {
        let [behind, ahead] = &self.nearest;
        let (middle, unit) = ((ahead.1 + behind.1) * T::HALF, (ahead.1 - behind.1) * T::HALF);
        let next = |from: &P, place: f64| {
            let by = middle + unit * T::from_f64(place);
            let position = around.moved(from, self.input, by)?;
            (around.sine(&position) >= self.width).then_some(position)
        };
        let [b, e] = [next(&behind.0, -2.0)?, next(&ahead.0, 2.0)?];
        let [a, f] = [next(&b, -3.0)?, next(&e, 3.0)?];
        let nodes = [&a, &b, &behind.0, &ahead.0, &e, &f].map(|position| around.rates(position));
        let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = nodes else {
            return None;
        };
        let nodes = [a, b, c, d, e, f];
        let mut greatest = T::ZERO;
        S::interpolate(&nodes, &mut |numbers| {
            greatest = greatest.max(size(&numbers));
            T::ZERO
        });
        let weights = weights(-middle / unit);
        let mut worst = T::ZERO;
        let rates = S::interpolate(&nodes, &mut |numbers| {
            let rough = roughness(&numbers);
            if rough != T::ZERO {
                let part = rough / (size(&numbers) + self.width * greatest);
                // A roughness that is no number counts as infinite.
                worst = if part > worst {
                    part
                } else if part <= worst {
                    worst
                } else {
                    T::from_f64(f64::INFINITY)
                };
            }
            let shares = numbers.iter().zip(weights);
            shares.fold(T::ZERO, |sum, (number, weight)| sum + *number * weight)
        });
        Some((rates, worst))
    }
}

/// The shares of the nodes at a place, by Lagrange.
fn weights<T: Real>(at: T) -> [T; NODES] {
    PLACES.map(|own| {
        let others = PLACES.into_iter().filter(|place| *place != own);
        others.fold(T::ONE, |weight, place| {
            weight * (at - T::from_f64(place)) / T::from_f64(own - place)
        })
    })
}

/// The greatest size of numbers.
fn size<T: Real>(numbers: &[T; NODES]) -> T {
    numbers.iter().fold(T::ZERO, |size, number| size.max(number.abs()))
}

/// By how much numbers are not smooth. A pole, or what jumps, is left of their odd part without its line and its cubic. What the outer nodes
/// tell otherwise than the inner ones, or a kink, is left of their even part.
fn roughness<T: Real>([a, b, c, d, e, f]: &[T; NODES]) -> T {
    let number = T::from_f64;
    let odd = number(0.15) * (number(5.0) * (*d - *c) - number(4.0) * (*e - *b) + (*f - *a));
    let even =
        number(0.05) * (*f + *a) + number(1.0 / 12.0) * (*d + *c) - number(2.0 / 15.0) * (*e + *b);
    odd.abs().max(even.abs())
}
