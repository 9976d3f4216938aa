//! The outline of a thick arc with round ends.

use super::turn::Turn;
use crate::Scalar;

/// The corners of the outline of an arc: along its outer side, around its end, back along its inner side, around its beginning.
#[derive(Clone)]
pub(super) struct Arc<T> {
    center: [T; 2],
    radius: T,
    half: T,
    /// Along the arc, and around its ends in the same sense.
    along: Turn<T>,
    around: Turn<T>,
    /// From the centre to where it has come, of length one, and from the arc's end to where it has come around it.
    direction: [T; 2],
    aside: [T; 2],
    section: Section,
    left: u32,
}

#[derive(Clone, Copy)]
enum Section {
    Outer,
    End,
    Inner,
    Beginning,
    Done,
}

impl<T: Scalar> Arc<T> {
    /// An arc around a centre, from a direction of length one.
    pub(super) fn new(
        center: [T; 2],
        radius: T,
        direction: [T; 2],
        half: T,
        along: Turn<T>,
        around: Turn<T>,
    ) -> Self {
        Self {
            center,
            radius,
            half,
            along,
            around,
            direction,
            aside: direction,
            section: Section::Outer,
            left: along.corners(),
        }
    }

    fn place(&self, radius: T) -> [T; 2] {
        let ([x, y], [u, v]) = (self.center, self.direction);
        [x + radius * u, y + radius * v]
    }
}

impl<T: Scalar> Iterator for Arc<T> {
    type Item = [T; 2];

    fn next(&mut self) -> Option<[T; 2]> {
        let corner = match self.section {
            Section::Outer => self.place(self.radius + self.half),
            Section::Inner => self.place((self.radius - self.half).max(T::ZERO)),
            Section::End | Section::Beginning => {
                let ([x, y], [u, v]) = (self.place(self.radius), self.aside);
                [x + self.half * u, y + self.half * v]
            }
            Section::Done => return None,
        };
        if let Some(left) = self.left.checked_sub(1) {
            self.left = left;
            match self.section {
                Section::Outer => self.direction = self.along.on(self.direction),
                Section::Inner => self.direction = self.along.back(self.direction),
                _ => self.aside = self.around.on(self.aside),
            }
        } else {
            (self.section, self.left, self.aside) = match self.section {
                Section::Outer => (Section::End, self.around.corners(), self.direction),
                Section::End => (Section::Inner, self.along.corners(), self.direction),
                Section::Inner => {
                    (Section::Beginning, self.around.corners(), self.direction.map(|part| -part))
                }
                _ => (Section::Done, 0, self.direction),
            };
        }
        Some(corner)
    }
}
