//! The outline of a thick line with round ends and joins.

use super::turn::Turn;
use crate::{Real, Scalar};

/// The corners of the outline of a line: along one side, around its end, back along the other side, around its beginning. By the non-zero rule
/// it surrounds what is near the line.
#[derive(Clone)]
pub(super) struct Stroke<T, P> {
    point: P,
    /// The number of parts. The outline follows each onward, and back.
    parts: usize,
    half: T,
    turn: Turn<T>,
    first: Part<T>,
    next: Step<T>,
}

/// A part of a line, followed onward or back.
#[derive(Clone, Copy)]
struct Part<T> {
    /// Parts are numbered onward along the line, and then back.
    number: usize,
    from: [T; 2],
    to: [T; 2],
    along: [T; 2],
}

/// The next part of an outline.
#[derive(Clone, Copy)]
enum Step<T> {
    /// Beside the beginning of a part.
    Begin(Part<T>),
    /// Beside its end.
    End(Part<T>),
    /// Around the joint before a part, from a direction; so many corners at most.
    Around(Part<T>, [T; 2], u32),
    /// At the joint before a part, on the inner side of a bend.
    Inside(Part<T>),
    Done,
}

impl<T: Scalar, P: Fn(usize) -> [T; 2]> Stroke<T, P> {
    /// The outline of a line through so many points, given by their number, with this half width. `turn` follows its ends.
    pub(super) fn new(point: P, count: usize, half: T, turn: Turn<T>) -> Option<Self> {
        let parts = count.checked_sub(1)?;
        let at = point(0);
        // Of a line without length, a dot is left.
        let mut stroke = Self {
            point,
            parts,
            half,
            turn,
            first: Part { number: 0, from: at, to: at, along: [T::ONE, T::ZERO] },
            next: Step::Done,
        };
        if let Some(first) = stroke.part_after(2 * parts) {
            stroke.first = first;
        }
        stroke.next = Step::Begin(stroke.first);
        Some(stroke)
    }

    /// The next part that has a length, after the last again the first; none if none has.
    fn part_after(&self, number: usize) -> Option<Part<T>> {
        let all = 2 * self.parts;
        let next = number.saturating_add(1);
        (next..all).chain(0..all.min(next)).find_map(|number| self.part(number))
    }

    fn part(&self, number: usize) -> Option<Part<T>> {
        let (from, to) = if number < self.parts {
            (number, number + 1)
        } else {
            let back = 2 * self.parts - number;
            (back, back - 1)
        };
        let (from, to) = ((self.point)(from), (self.point)(to));
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let length = Real::sqrt(x * x + y * y);
        (length > T::ZERO).then(|| Part { number, from, to, along: [x / length, y / length] })
    }

    /// The step after the end of a part.
    fn after(&self, part: Part<T>) -> Step<T> {
        let Some(next) = self.part_after(part.number) else {
            // The outline of a dot has two halves.
            let along = part.along.map(|part| -part);
            let other = Part { number: 1 - part.number.min(1), along, ..part };
            return Step::Around(other, aside(part.along), self.turn.corners());
        };
        let ([a, b], [c, d]) = (part.along, next.along);
        let cross = a * d - b * c;
        let is_end = (part.number < self.parts) != (next.number < self.parts);
        if cross > T::ZERO && !is_end {
            Step::Inside(next)
        } else if cross < T::ZERO || is_end {
            Step::Around(next, aside(part.along), self.turn.corners())
        } else {
            Step::Begin(next)
        }
    }

    fn beside(&self, [x, y]: [T; 2], [u, v]: [T; 2]) -> [T; 2] {
        [x + self.half * u, y + self.half * v]
    }
}

impl<T: Scalar, P: Fn(usize) -> [T; 2]> Iterator for Stroke<T, P> {
    type Item = [T; 2];

    fn next(&mut self) -> Option<[T; 2]> {
        loop {
            let (corner, next) = match self.next {
                Step::Begin(part) => (self.beside(part.from, aside(part.along)), Step::End(part)),
                Step::End(part) => {
                    let corner = self.beside(part.to, aside(part.along));
                    (corner, self.after(part))
                }
                Step::Inside(part) => (part.from, Step::Begin(part)),
                Step::Around(part, from, left) => {
                    let goal = aside(part.along);
                    let from = self.turn.back(from);
                    let is_near = from[0] * goal[0] + from[1] * goal[1] > self.turn.cos();
                    match left.checked_sub(1) {
                        Some(left) if !is_near => {
                            (self.beside(part.from, from), Step::Around(part, from, left))
                        }
                        _ => {
                            let is_done = part.number == self.first.number;
                            self.next = if is_done { Step::Done } else { Step::Begin(part) };
                            continue;
                        }
                    }
                }
                Step::Done => return None,
            };
            self.next = next;
            return Some(corner);
        }
    }
}

/// The direction to the side on which the outline runs.
fn aside<T: Scalar>([u, v]: [T; 2]) -> [T; 2] {
    [-v, u]
}
