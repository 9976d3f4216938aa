//! Where a point has been.

use crate::raster::line;
use crate::{Canvas, Point2, Real, Scalar};
use core::fmt;

/// How wide a trace is drawn, in pixels.
const WIDTH: f64 = 1.5;

/// The last `N` places of a point, in scene units: of more, the oldest are forgotten. Nothing is allocated.
///
/// A mechanism with `effects { trace rod.small_end 256; }` has one for each point so traced, which every move that succeeds adds
/// to; it can be kept for anything else as well:
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
    /// Where the next place goes: that of the oldest, once there are `N`.
    next: usize,
    len: usize,
}

impl<T: Scalar, const N: usize> Trace<T, N> {
    /// No place yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            places: [[T::ZERO; 2]; N],
            next: 0,
            len: 0,
        }
    }

    /// Adds a place in the scene; where there are `N` already, the oldest is forgotten.
    #[inline]
    pub fn push(&mut self, place: [T; 2]) {
        if let Some(slot) = self.places.get_mut(self.next) {
            *slot = place;
            self.next = if self.next + 1 < N { self.next + 1 } else { 0 };
            self.len = if self.len < N { self.len + 1 } else { N };
        }
    }

    /// Forgets all places.
    pub const fn clear(&mut self) {
        (self.next, self.len) = (0, 0);
    }

    /// How many places there are: `N` at most.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
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

    /// Draws it as a thin line from place to place, with entry `color` of the palette. What is not finite is left out.
    pub fn draw(&self, canvas: &mut impl Canvas<T>, color: u8) {
        // Steps too small to be seen are drawn with the next.
        let least = <T as Real>::HALF / canvas.scale();
        let mut places = self.in_order();
        let Some(mut from) = places.next() else {
            return;
        };
        let mut rest = None;
        for to in places {
            let is_near = Real::abs(to[0] - from[0]) < least && Real::abs(to[1] - from[1]) < least;
            if is_near {
                rest = Some(to);
            } else {
                line(canvas, [from, to], Real::from_f64(WIDTH), color);
                (from, rest) = (to, None);
            }
        }
        if let Some(to) = rest {
            line(canvas, [from, to], Real::from_f64(WIDTH), color);
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
