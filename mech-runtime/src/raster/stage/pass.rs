//! One of the times that everything is told.

use super::area::Areas;
use super::item::{Item, Items, mixed};
use crate::raster::font;
use crate::raster::spans::Clip;
use crate::raster::{Canvas, Frame, View, fixed, paint};
use crate::{Outline, Pose, Real, Scalar};
use core::ops::Range;

/// What is done with everything that is painted.
#[derive(Clone)]
pub(super) enum Task {
    /// It is looked at: what has changed?
    Compare,
    /// Those of these numbers are painted.
    Ground(Range<usize>),
    /// Those from this number on are painted, within a rectangle.
    Paint(usize, Clip),
}

/// The [`Canvas`] on which a [`Stage`](super::Stage) lets things be painted.
pub struct Pass<'s, const W: usize, const H: usize, const N: usize> {
    frame: &'s mut Frame<W, H>,
    view: View,
    items: &'s mut Items<N>,
    changed: &'s mut Areas,
    task: Task,
    /// The number of the next thing.
    next: usize,
}

impl<'s, const W: usize, const H: usize, const N: usize> Pass<'s, W, H, N> {
    pub(super) fn new(
        frame: &'s mut Frame<W, H>,
        view: View,
        items: &'s mut Items<N>,
        changed: &'s mut Areas,
        task: Task,
    ) -> Self {
        Self {
            frame,
            view,
            items,
            changed,
            task,
            next: 0,
        }
    }

    /// Where the next thing is to be painted.
    fn clip(&mut self) -> Option<Clip> {
        let number = self.next;
        self.next += 1;
        let within = match &self.task {
            Task::Compare => return None,
            Task::Ground(numbers) => numbers.contains(&number).then_some(Clip::all(W, H)),
            Task::Paint(first, within) => (number >= *first).then_some(*within),
        };
        let clip = within?.and(self.items.clip(number));
        (!clip.is_empty()).then_some(within?)
    }
}

impl<T: Scalar, const W: usize, const H: usize, const N: usize> Canvas<T> for Pass<'_, W, H, N> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection::<T>(W, H);
        if matches!(self.task, Task::Compare) {
            let place = projection.of(pose);
            let mut extent = Extent::new(color);
            let reach = match outline {
                Outline::Circle { center, radius } => {
                    extent.add(place.point(center));
                    extent.mix(1, [projection.length(radius)])
                }
                Outline::Ring {
                    center,
                    radius,
                    hole,
                } => {
                    extent.add(place.point(center));
                    extent.mix(2, [hole, radius].map(|length| projection.length(length)))
                }
                Outline::Polygon(corners) | Outline::Winding(corners) => {
                    for &corner in corners {
                        extent.add(place.point(corner));
                    }
                    let kind = 3 + u64::from(matches!(outline, Outline::Winding(_)));
                    extent.mix(kind, [T::ZERO])
                }
                Outline::Line { points, width } => {
                    for &point in points {
                        extent.add(place.point(point));
                    }
                    extent.mix(5, [<T as Real>::HALF * projection.length(width)])
                }
                Outline::Arc {
                    center,
                    start,
                    angle,
                    width,
                } => {
                    extent.add(place.point(center));
                    let [x, y] = [start[0] - center[0], start[1] - center[1]];
                    let reach = Real::sqrt(x * x + y * y) + <T as Real>::HALF * width;
                    let [u, v] = place.point(start);
                    extent.mix(6, [u, v, angle, width, projection.length(reach)])
                }
            };
            let item = extent.item(reach, [W, H]);
            self.items.tell(item, self.changed);
        } else if let Some(clip) = self.clip() {
            let mut part = self.frame.part(clip);
            paint::outline(&mut part, projection, outline, pose, color);
        }
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection::<T>(W, H).point(place);
        if matches!(self.task, Task::Compare) {
            let mut extent = Extent::new(color);
            extent.add(place);
            for character in text.chars() {
                extent.mark = mixed(extent.mark, character.into());
            }
            let letters = i32::try_from(text.chars().count()).unwrap_or(i32::MAX);
            let wide = letters.saturating_add(2).saturating_mul(font::ADVANCE);
            let reach = extent.mix(7, [<T as Real>::from_i32(wide)]);
            let item = extent.item(reach, [W, H]);
            self.items.tell(item, self.changed);
        } else if let Some(clip) = self.clip() {
            paint::text(&mut self.frame.part(clip), place, text, color);
        }
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

/// The corners of a thing, in pixels.
struct Extent<T> {
    low: [T; 2],
    high: [T; 2],
    mark: u64,
    is_finite: bool,
    is_empty: bool,
}

impl<T: Scalar> Extent<T> {
    fn new(color: u8) -> Self {
        Self {
            low: [T::ZERO; 2],
            high: [T::ZERO; 2],
            mark: mixed(0x5851_F42D_4C95_7F2D, color.into()),
            is_finite: true,
            is_empty: true,
        }
    }

    #[inline]
    fn add(&mut self, [x, y]: [T; 2]) {
        self.is_finite &= Real::is_finite(x) && Real::is_finite(y);
        if self.is_empty {
            (self.low, self.high, self.is_empty) = ([x, y], [x, y], false);
        }
        self.low = [self.low[0].min(x), self.low[1].min(y)];
        self.high = [Real::max(self.high[0], x), Real::max(self.high[1], y)];
        self.mark = mixed(self.mark, bits(x) ^ bits(y).rotate_left(29));
    }

    /// Mixes in what else it is made of, and gives the last of these: how far it reaches around its corners.
    fn mix<const K: usize>(&mut self, kind: u64, numbers: [T; K]) -> T {
        self.mark = mixed(self.mark, kind);
        for number in numbers {
            self.mark = mixed(self.mark, bits(number));
        }
        numbers.last().copied().unwrap_or(T::ZERO)
    }

    fn item(&self, reach: T, [width, height]: [usize; 2]) -> Item {
        let clip = if self.is_finite && !self.is_empty && Real::is_finite(reach) {
            let [x, y] = [0, 1].map(|axis| [self.low[axis] - reach, self.high[axis] + reach]);
            let (columns, rows) = (fixed::touched(x, width), fixed::touched(y, height));
            Clip {
                left: columns.start,
                top: rows.start,
                right: columns.end,
                bottom: rows.end,
            }
        } else {
            Clip::none()
        };
        let mark = self.mark;
        Item { mark, clip }
    }
}

/// The bits of a number, whatever its type; both zeros are one.
#[inline]
fn bits<T: Scalar>(number: T) -> u64 {
    Real::to_f64(number + T::ZERO).to_bits()
}
