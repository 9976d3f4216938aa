//! Angles that are followed over whole turns, from a reference.

use super::Interval;
use crate::program::{Op, Program, Value};

/// An angle that is followed over whole turns. It lies within half a turn of a reference, wherever the branch cut of its arc tangent is.
#[derive(Clone, Copy, Debug)]
pub(super) struct WholeAngle {
    value: Value,
    /// The numbers whose arc tangent it is, but for whole turns.
    sin: Value,
    cos: Value,
    reference: Interval,
}

impl WholeAngle {
    /// The angle that is carried under this number, if it is followed over whole turns.
    pub(super) fn carried(program: &Program, state: usize, reference: Interval) -> Option<Self> {
        let mut angles = program.follows.iter().zip(&program.followed);
        let (_, (_, principal)) = angles.find(|(follow, _)| follow.angle == state)?;
        let Op::Atan2(sin, cos) = program.node(*principal).op else {
            return None;
        };
        Some(Self { value: program.state[state], sin, cos, reference })
    }

    /// Whether it is this value.
    pub(super) fn is(self, value: Value) -> bool {
        self.value == value
    }

    /// Its enclosure, from those of all values.
    pub(super) fn range(self, values: &[Interval]) -> Interval {
        let [sin, cos] = [self.sin, self.cos].map(|value| values[value.index()]);
        let [across, along] = [self.reference.sin(), self.reference.cos()];
        let beyond = (sin * along - cos * across).atan2(cos * along + sin * across);
        self.reference + beyond
    }
}
