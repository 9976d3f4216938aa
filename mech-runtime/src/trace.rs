//! Traces of points.

use crate::{Canvas, Point2, Real, Scalar};
use core::fmt;

/// The width of a drawn trace, in pixels.
const WIDTH: f64 = 1.5;

/// The last `N` places of a point, in scene units, without allocation.
///
/// A mechanism with `effects { trace rod.small_end 256; }` has a trace of this point. Every move that succeeds adds a place. A trace
/// can record any other point as well:
///
/// ```
/// use mech_runtime::Trace;
///
/// let mut trace = Trace::<f64, 2>::new();
/// for x in [0.0, 1.0, 2.0] {
///     trace.push([x, 0.5]);
/// }
/// let abscissas: Vec<f64> = trace.iter().map(|point| point.x).collect();
/// assert_eq!(abscissas, [1.0, 2.0]);
/// ```
#[derive(Clone, Copy)]
pub struct Trace<T, const N: usize> {
    places: [[T; 2]; N],
    /// The slot of the next place: that of the oldest, once there are `N`.
    next: usize,
    len: usize,
}

impl<T: Scalar, const N: usize> Trace<T, N> {
    /// An empty trace.
    #[must_use]
    pub const fn new() -> Self {
        Self { places: [[T::ZERO; 2]; N], next: 0, len: 0 }
    }

    /// Adds a place in the scene. If there are `N` places already, the oldest is removed.
    #[inline]
    pub fn push(&mut self, place: [T; 2]) {
        if let Some(slot) = self.places.get_mut(self.next) {
            *slot = place;
            self.next = if self.next + 1 < N { self.next + 1 } else { 0 };
            self.len = if self.len < N { self.len + 1 } else { N };
        }
    }

    /// Removes all places.
    pub const fn clear(&mut self) {
        (self.next, self.len) = (0, 0);
    }

    /// The number of places, at most `N`.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no places.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The places in the scene, from the oldest to the newest.
    #[must_use]
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = Point2<T>> + Clone + '_ {
        self.in_order().map(|[x, y]| Point2::new(x, y))
    }

    fn in_order(&self) -> impl DoubleEndedIterator<Item = [T; 2]> + Clone + '_ {
        // Once it is full, the next place is the oldest.
        let start = if self.len < N { 0 } else { self.next };
        let (newer, older) = self.places.split_at_checked(start).unwrap_or_default();
        let older = older.get(..self.len - newer.len()).unwrap_or_default();
        older.iter().chain(newer).copied()
    }

    /// Draws a thin line from place to place in entry `color` of the palette. Places that are not finite are left out.
    pub fn draw(&self, canvas: &mut impl Canvas<T>, color: u8) {
        // Steps too small to be seen are drawn with the next.
        let least = <T as Real>::HALF / canvas.scale();
        let mut places = self.in_order();
        let Some(first) = places.next() else {
            return;
        };
        let mut line = Strokes::new(first);
        let mut remainder = None;
        for to in places {
            let from = line.end();
            let is_near = Real::abs(to[0] - from[0]) < least && Real::abs(to[1] - from[1]) < least;
            if is_near {
                remainder = Some(to);
            } else {
                line.push(to, canvas, color);
                remainder = None;
            }
        }
        if let Some(to) = remainder {
            line.push(to, canvas, color);
        }
        line.draw(canvas, color);
    }
}

/// A line that is drawn some places at a time.
struct Strokes<T> {
    places: [[T; 2]; 32],
    len: usize,
}

impl<T: Scalar> Strokes<T> {
    const fn new(place: [T; 2]) -> Self {
        Self { places: [place; 32], len: 1 }
    }

    /// The last place.
    fn end(&self) -> [T; 2] {
        let [first, ..] = self.places;
        let end = self.places.get(..self.len).and_then(<[_]>::last);
        end.copied().unwrap_or(first)
    }

    /// Adds a place. One that is not finite is left out, with the lines to it and from it.
    fn push(&mut self, place: [T; 2], canvas: &mut impl Canvas<T>, color: u8) {
        let is_finite = place.iter().all(|&part| Real::is_finite(part));
        if self.len == self.places.len() || !is_finite {
            let end = self.end();
            self.draw(canvas, color);
            *self = Self::new(if is_finite { end } else { place });
        }
        if let (true, Some(next)) = (is_finite, self.places.get_mut(self.len)) {
            *next = place;
            self.len += 1;
        }
    }

    fn draw(&self, canvas: &mut impl Canvas<T>, color: u8) {
        let mut points = self.places.get(..self.len).unwrap_or_default();
        if let [first, remainder @ ..] = points
            && !first.iter().all(|&part| Real::is_finite(part))
        {
            points = remainder;
        }
        let width = <T as Real>::from_f64(WIDTH) / canvas.scale();
        if points.len() > 1 {
            canvas.trace(points, width, color);
        }
    }
}

impl<T: Scalar, const N: usize> Default for Trace<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// The same places in the same order.
impl<T: Scalar, const N: usize> PartialEq for Trace<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.len == other.len && self.in_order().eq(other.in_order())
    }
}

/// Its places.
impl<T: Scalar, const N: usize> fmt::Debug for Trace<T, N> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.in_order()).finish()
    }
}
