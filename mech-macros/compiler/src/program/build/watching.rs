//! What is carried of loops that are watched: how near they are to their dead points and change points.

use super::Writer;
use crate::plan::{Algebra, Equation, Solution, Turning};
use crate::program::builder::Builder;
use crate::program::node::{BlockId, Value};
use crate::program::{Bound, Follow, Growth, Watch};
use mech_core::journey::{self, AtZero};

impl Writer<'_> {
    /// Carries what has to be known about a loop that is watched, if it is. The side of a dyad that is carried is so already.
    pub(super) fn keep_watch(
        &mut self,
        block: BlockId,
        sine: Value,
        tiny_square: Value,
        sided: bool,
    ) {
        let Some(watching) = self.choice().watching else {
            return;
        };
        let start = [sine, tiny_square].map(|value| self.builder.at_start(value));
        if !(sided && watching.at_zero == AtZero::GoOver) {
            self.keep(start[0]);
        }
        self.keep(start[1]);
        let kept = self.kept.len() - 2;
        self.kept[kept] = self.builder.name(sine, "sine");
        self.kept[kept + 1] = tiny_square;
        let growth = self.growth(&watching.bound);
        self.watches.push(Watch {
            block,
            kept,
            number: self.loops - 1,
            rates: watching.bound.rates,
            growth,
            guessed: watching.bound.guessed,
            at_zero: watching.at_zero,
        });
    }

    /// What makes a bound grow, loops by their place among those that are watched so far.
    fn growth(&self, bound: &Bound) -> Vec<journey::Growth<f64>> {
        let watched = |number| self.watches.iter().position(|watch| watch.number == number);
        let growth = bound.growth.iter().filter_map(|growth| match *growth {
            Growth::NearZero(number) => watched(number).map(journey::Growth::Near),
            Growth::FarOut(input, unit) => Some(journey::Growth::Far(input, unit)),
        });
        growth.collect()
    }

    /// Notes that an angle is followed over whole turns.
    pub(super) fn follow(&mut self, what: Turning, angle: Value) {
        self.followed_angles.push((what, angle));
        let mut known = self.plan.turning.iter();
        let bound = known.find(|(turning, _)| *turning == what);
        let bound = bound.map(|(_, bound)| bound.clone());
        // As long as nobody has looked, nothing moves.
        let bound = bound.unwrap_or_else(|| Bound::still(self.model.inputs()));
        self.follows.push(Follow {
            growth: self.growth(&bound),
            rates: bound.rates,
        });
    }

    /// A dyad that is iterated is watched like one in closed form: over a place where it does not close it may not leap.
    pub(super) fn watch_iteration(
        &mut self,
        block: BlockId,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
    ) {
        if self.choice().watching.is_none() || equation.rings.len() != 1 {
            return;
        }
        let measure = equation.measure(&mut self.builder, solution);
        let [walk] = &measure.rings[..] else {
            return;
        };
        let [a, b] = walk.columns[..] else {
            return;
        };
        let length =
            |builder: &Builder, [x, y]: [Value; 2]| builder.at_start(x).hypot(builder.at_start(y));
        let reach = length(&self.builder, a) * length(&self.builder, b);
        let det = self.builder.cross(a, b);
        let scale = self.builder.constant(1.0 / reach);
        let sine = self.builder.mul(scale, det);
        let epsilon = self.model.precision.epsilon();
        let tiny_square = self.builder.constant(16.0 * epsilon);
        self.keep_watch(block, sine, tiny_square, false);
    }
}
