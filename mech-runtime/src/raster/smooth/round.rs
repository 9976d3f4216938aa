//! A circle, row by row.

use super::cover::Cover;
use crate::raster::fixed;
use crate::raster::turn::Turn;
use crate::{Real, Scalar};
use core::ops::Range;

/// Only those are taken that are seen.
const MOST: u32 = 1 << 22;

/// A circle that is followed down on both sides at once, in straight steps that are invisibly short.
pub(super) struct Round<T> {
    center: [T; 2],
    /// A little more than its own, since steps are nearer to the centre than their ends are.
    radius: T,
    turn: Turn<T>,
    /// The direction from the centre to the end of the step, of length one. The y axis points down.
    direction: [T; 2],
    /// The ends of the rest of the step: pixels to the right of the centre, and pixels down from the top of the picture.
    from: [T; 2],
    to: [T; 2],
}

/// The rows of a picture of so many in which a circle is seen at least in part; none, if it is not a circle.
pub(super) fn rows<T: Scalar>(center: [T; 2], radius: T, height: usize) -> Range<usize> {
    let is_finite = [center[0], center[1], radius].iter().all(|&number| Real::is_finite(number));
    if !(is_finite && radius > T::ZERO) {
        return 0..0;
    }
    fixed::rows_touching([center[1] - radius, center[1] + radius], height)
}

impl<T: Scalar> Round<T> {
    /// A circle whose radius is positive, from a row on; a radius of one pixel takes so many steps.
    pub(super) fn new(center: [T; 2], radius: T, row: usize, fineness: f32) -> Self {
        let turn = Turn::new(T::TURN, radius, fineness, MOST);
        // 1/12 of the square of the step's angle.
        let sixth = <T as Real>::from_f64(1.0 / 6.0);
        let radius = radius + radius * ((T::ONE - turn.cos()) * sixth);
        // From its pole, or from the upper border of the row.
        let rise = fixed::border::<T>(row) - center[1];
        let sine = Real::max(rise / radius, -T::ONE);
        let cosine = Real::sqrt(Real::max((T::ONE - sine) * (T::ONE + sine), T::ZERO));
        let mut round = Self {
            center,
            radius,
            turn,
            direction: [cosine, sine],
            from: [T::ZERO; 2],
            to: [radius * cosine, center[1] + radius * sine],
        };
        round.advance();
        round
    }

    /// The next step, which ends at the lower pole at the latest.
    fn advance(&mut self) {
        self.from = self.to;
        let [x, y] = self.turn.on(self.direction);
        self.direction = if x > T::ZERO { [x, y] } else { [T::ZERO, T::ONE] };
        let [x, y] = self.direction;
        self.to = [self.radius * x, self.center[1] + self.radius * y];
    }

    /// Adds what it covers in a row, with a sign. Rows are asked for from the top.
    pub(super) fn cover<G: AsRef<[f32]> + AsMut<[f32]>>(
        &mut self,
        row: usize,
        sign: f32,
        cover: &mut Cover<G>,
    ) {
        let bottom = fixed::border::<T>(row + 1);
        let center = self.center[0];
        let (mut least, mut most) = (self.from[0], self.from[0]);
        loop {
            let ([x, y], [end, end_y]) = (self.from, self.to);
            let is_whole = end_y <= bottom;
            let next = if is_whole {
                self.to
            } else {
                [x + (end - x) * ((bottom - y) / (end_y - y)), bottom]
            };
            (least, most) = (least.min(next[0]), Real::max(most, next[0]));
            let gain = sign * (next[1] - y).to_f32();
            cover.add((center - x).to_f32(), (center - next[0]).to_f32(), gain);
            cover.add((center + x).to_f32(), (center + next[0]).to_f32(), -gain);
            if is_whole && self.direction[0] > T::ZERO {
                self.advance();
                continue;
            }
            self.from = next;
            break;
        }
        cover.touch((center - most).to_f32(), (center - least).to_f32());
        cover.touch((center + least).to_f32(), (center + most).to_f32());
    }
}
