//! Rotation in small steps.

use crate::{Real, Scalar};

/// A turn through an angle in equal steps, so small that the outline looks round.
#[derive(Clone, Copy)]
pub(super) struct Turn<T> {
    cos: T,
    sin: T,
    steps: u32,
}

impl<T: Scalar> Turn<T> {
    /// Through an angle in radians, around something of a radius in pixels. Fineness is the number of steps that a whole turn takes around a
    /// radius of one pixel. The number grows with the root of the radius, so that the error in pixels is the same, up to `most`.
    pub(super) fn new(angle: T, radius: T, fineness: f32, most: u32) -> Self {
        let share = (Real::abs(angle) / T::TURN).to_f32();
        let steps = share * fineness * nalgebra::ComplexField::sqrt(radius.to_f32());
        // Not a number, if anything: the least.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number of steps, if it is none the least"
        )]
        let steps = (steps as u32).clamp(3, most) + 1;
        let part = angle / <T as Real>::from_i32(steps.cast_signed());
        let (sin, cos) = Real::sin_cos(part);
        Self { cos, sin, steps }
    }

    /// The number of steps.
    pub(super) const fn corners(&self) -> u32 {
        self.steps
    }

    /// The cosine of a step.
    pub(super) fn cos(&self) -> T {
        self.cos
    }

    /// The direction one step on.
    pub(super) fn on(&self, [x, y]: [T; 2]) -> [T; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// The direction one step back.
    pub(super) fn back(&self, [x, y]: [T; 2]) -> [T; 2] {
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }
}
