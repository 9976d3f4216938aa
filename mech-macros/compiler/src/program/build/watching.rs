//! What is carried of loops that are watched: how near they are to their dead points and change points.

use super::Writer;
use super::tied::Tied;
use crate::plan::{Algebra, Equation, Solution, Turning};
use crate::program::builder::Builder;
use crate::program::calibrate::{determinant, reach};
use crate::program::newton::Newton;
use crate::program::node::{BlockId, Op, Value};
use crate::program::{Bound, Follow, Growth, Watch};
use mech_core::journey;

/// Of the square of a tied loop's sine so much of rounding hides the sign: an iteration ends where a gap is that small.
const OF_ROUNDING: f64 = 32768.0;

/// The determinant of coupled loops is measured against that of the start, but against no less than this part of what their columns'
/// lengths allow: a start near a change point is no measure.
const OF_LENGTHS: f64 = 0.0625;

/// On which side of their change points coupled loops are.
#[derive(Clone, Copy)]
pub(super) struct Side {
    /// A number with its sign: the sine where they were.
    pub(super) last: Value,
    /// One over the determinant of which the sine is a part.
    scale: f64,
}

/// How a loop is solved that may be watched.
#[derive(Clone, Copy)]
pub(super) struct Watchable {
    /// Whether its branch is in the state already.
    pub(super) has_branch: bool,
    /// Whether it is solved by iteration.
    pub(super) iterated: bool,
}

impl Writer<'_> {
    /// Adds to the state what has to be known about a loop, if it is watched.
    pub(super) fn watch_loop(
        &mut self,
        block: BlockId,
        [sine, rounding_square]: [Value; 2],
        is: Watchable,
    ) {
        let Some(watching) = self.choice().watching else {
            return;
        };
        let start = [sine, rounding_square].map(|value| self.builder.at_start(value));
        if !is.has_branch {
            self.keep(start[0]);
        }
        self.keep(start[1]);
        let [sine_index, square_index] = [self.state.len() - 2, self.state.len() - 1];
        self.state[sine_index] = self.builder.name(sine, "sine");
        self.state[square_index] = rounding_square;
        let growth = self.growth(&watching.bound);
        self.watches.push(Watch {
            block,
            sine: sine_index,
            rounding_square: square_index,
            number: self.loops - 1,
            rates: watching.bound.rates,
            growth,
            guessed: watching.bound.guessed,
            at_zero: watching.at_zero,
            iterated: is.iterated,
        });
    }

    /// By how much rounding displaces what the loops hold that are watched so far, as a multiple of the part of a length that is
    /// accepted as a gap: near a zero of its sine a loop turns by up to the root of rounding, and everything with it.
    pub(super) fn doubt(&mut self, accepted: f64) -> Option<Value> {
        let scale = self.builder.constant(self.model.size() / accepted);
        let watches = self.watches.iter();
        let sines: Vec<[Value; 2]> = watches
            .map(|watch| [watch.sine, watch.rounding_square].map(|index| self.state[index]))
            .collect();
        sines
            .into_iter()
            .fold(None, |sum, [sine, rounding_square]| {
                let builder = &mut self.builder;
                let square = builder.mul(sine, sine);
                let square = builder.add(square, rounding_square);
                let root = builder.sqrt(square);
                let turned = builder.div(rounding_square, root);
                let displaced = builder.mul(scale, turned);
                Some(match sum {
                    None => displaced,
                    Some(sum) => builder.add(sum, displaced),
                })
            })
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
        let residuals = equation.residuals(&mut self.builder, solution);
        let [ring] = &residuals.rings[..] else {
            return;
        };
        let [a, b] = ring.columns[..] else {
            return;
        };
        let sine = self.sine_of([a, b]);
        let epsilon = self.model.precision.epsilon();
        let rounding_square = self.builder.constant(16.0 * epsilon);
        let is = Watchable {
            has_branch: false,
            iterated: true,
        };
        self.watch_loop(block, [sine, rounding_square], is);
    }

    /// The sine of a loop of two unknowns, as its columns were at the start: its determinant, as a part of the product of their lengths
    /// there.
    fn sine_of(&mut self, [a, b]: [[Value; 2]; 2]) -> Value {
        let length =
            |builder: &Builder, [x, y]: [Value; 2]| builder.at_start(x).hypot(builder.at_start(y));
        let reach = length(&self.builder, a) * length(&self.builder, b);
        let det = self.builder.cross(a, b);
        let scale = self.builder.constant(1.0 / reach);
        self.builder.mul(scale, det)
    }

    /// On which side of its change point a tied loop is, if that is carried: a number with its sign, plus at the start.
    pub(super) fn keep_side(&mut self, columns: &[Vec<Value>]) -> Option<Value> {
        self.choice().watching?;
        let sine = self.sine_of(pair(columns)?);
        let start = self.builder.at_start(sine);
        Some(self.keep(start))
    }

    /// On which side of their change points coupled loops are, if that is carried.
    pub(super) fn keep_coupled_side(&mut self, columns: &[Vec<Value>]) -> Option<Side> {
        self.choice().watching?;
        if columns.iter().any(|column| column.len() != columns.len()) {
            return None;
        }
        let number = |value: Value| self.builder.at_start(value);
        let det = determinant(columns, number);
        let scale = 1.0 / det.abs().max(OF_LENGTHS * reach(columns, number));
        let last = self.keep(scale * det);
        Some(Side { last, scale })
    }

    /// Coupled loops go on past their change points, or stop there. Their determinant is that where they are closed.
    pub(super) fn watch_coupled(&mut self, block: BlockId, newton: &Newton, side: Side) {
        let scale = self.builder.constant(side.scale);
        let signed = self.builder.make(Op::CopySign(scale, side.last));
        let sine = self.builder.mul(signed, newton.det);
        let rounding_square = self
            .builder
            .constant(OF_ROUNDING * self.model.precision.epsilon());
        let is = Watchable {
            has_branch: true,
            iterated: true,
        };
        self.watch_loop(block, [sine, rounding_square], is);
    }

    /// A tied loop goes on past its change points, or stops there: on its other side the iteration is begun from where it came.
    pub(super) fn watch_tied(
        &mut self,
        block: BlockId,
        tied: &Tied,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
        turned: Value,
    ) {
        if self.choice().watching.is_none() {
            return;
        }
        let columns = self.tied_columns(tied, equation, solution);
        let Some(columns) = pair(&columns) else {
            return;
        };
        let sine = self.sine_of(columns);
        // As far as its angles have turned, so much more of the root of rounding hides the sign.
        let part = self
            .builder
            .constant(OF_ROUNDING * self.model.precision.epsilon());
        let share = self.builder.mul(part, turned);
        let rounding_square = self.builder.add(part, share);
        let is = Watchable {
            has_branch: true,
            iterated: true,
        };
        self.watch_loop(block, [sine, rounding_square], is);
    }
}

/// The two columns of a loop of two unknowns and one ring.
fn pair(columns: &[Vec<Value>]) -> Option<[[Value; 2]; 2]> {
    match columns {
        [a, b] => {
            Some([[*a.first()?, *a.get(1)?], [*b.first()?, *b.get(1)?]]).filter(|_| a.len() == 2)
        }
        _ => None,
    }
}
