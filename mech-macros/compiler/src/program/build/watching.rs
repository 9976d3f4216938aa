//! Loops that are watched, and angles whose turns are counted: what a position carries of them.

use super::LoopSite;
use super::lowering::Lowering;
use crate::plan::{Algebra, Arithmetic, Dyad, Equation, Solution, Turning};
use crate::program::builder::SsaBuilder;
use crate::program::calibrate::{determinant, reach};
use crate::program::choice::Choice;
use crate::program::closed_form::ClosedForm;
use crate::program::newton::Newton;
use crate::program::node::{Op, Value};
use crate::program::{Bound, Follow, Growth, Watch};
use mech_core::journey;
use std::f64::consts::TAU;

/// Rounding hides the sign of a tied loop's sine below the square root of so many roundings: an iteration ends where a gap is that small.
const OF_ROUNDING: f64 = 32768.0;

/// The determinant of coupled loops is measured against that of the start, but against no less than this part of what their columns'
/// lengths allow: a start near a change point is no measure.
const OF_LENGTHS: f64 = 0.0625;

/// On which side of their change points coupled loops are.
#[derive(Clone, Copy)]
pub(super) struct CoupledSide {
    /// A number with its sign: the sine where they were.
    pub(super) last: Value,
    /// One over the determinant that the sine is a part of: the sine is the loop's determinant times this.
    scale: f64,
}

/// The loops and angles that a journey examines while motors move.
#[derive(Default)]
pub(super) struct Watches {
    /// The loops that are watched, in the order in which they are closed.
    pub(super) loops: Vec<Watch>,
    /// The greatest rates of the angles whose turns are counted.
    pub(super) follows: Vec<Follow>,
    /// The same angles, between −π and π, and what they are.
    pub(super) angles: Vec<(Turning, Value)>,
    /// By how much rounding tilts dyads of two circles, in radians, by the numbers of their loops.
    tilts: Vec<(usize, Value)>,
}

/// By how much rounding turns a watched loop near a zero of its sine, in radians.
fn of_sine(ssa: &mut SsaBuilder, watch: &Watch) -> Value {
    let [sine, rounding_square] = [watch.sine, watch.rounding_square].map(|index| ssa.state(index));
    let square = ssa.mul(sine, sine);
    let square = ssa.add(square, rounding_square);
    let root = ssa.sqrt(square);
    ssa.div(rounding_square, root)
}

impl Watches {
    /// Adds to the state what has to be known about a loop, if it is watched: its sine, and the square below which rounding hides the sine's
    /// sign. Its branch may be in the state already.
    pub(super) fn watch(
        &mut self,
        ssa: &mut SsaBuilder,
        site: &LoopSite,
        [sine, rounding_square]: [Value; 2],
        has_branch: bool,
    ) {
        let Some(watching) = &site.choice.watching else {
            return;
        };
        let start = [sine, rounding_square].map(|value| ssa.at_start(value));
        // A branch is the last number of the state so far.
        if !has_branch {
            ssa.carry(start[0]);
        }
        let rounding = ssa.carry(start[1]).index;
        ssa.name(sine, "sine");
        ssa.update(rounding - 1, sine);
        ssa.update(rounding, rounding_square);
        let bound = watching.bound.clone();
        self.loops.push(Watch {
            block: site.block,
            sine: rounding - 1,
            rounding_square: rounding,
            number: site.number,
            growth: self.growth(&bound),
            rates: bound.rates,
            guessed: bound.guessed,
            at_zero: watching.at_zero,
            iterated: site.iterated,
        });
    }

    /// Takes note how far rounding tilts a dyad of two circles: the line between their centres, the more the nearer these are, and if it is
    /// watched the arms, which near a zero of its sine turn the more, the longer they are beside that line.
    pub(super) fn note_tilt(&mut self, ssa: &mut SsaBuilder, closed: &ClosedForm) {
        /// So many roundings are in the place of a centre.
        const ROUNDINGS: f64 = 16.0;
        if let Dyad::TwoCircles { goal, .. } = closed.dyad {
            let length = ssa.extent(&closed.dyad.sides());
            let least = ROUNDINGS * ssa.epsilon * length;
            let (least, tiny) = (ssa.constant(least), ssa.constant(least * least));
            let square = ssa.dot(goal, goal);
            let square = ssa.add(square, tiny);
            let distance = ssa.sqrt(square);
            let watch = self.loops.iter().find(|watch| watch.number == closed.number);
            let displaced = match watch.map(|watch| of_sine(ssa, watch)) {
                Some(turned) => {
                    let length = ssa.constant(length);
                    let turned = ssa.mul(length, turned);
                    ssa.add(turned, least)
                }
                None => least,
            };
            let tilt = ssa.div(displaced, distance);
            self.tilts.push((closed.number, tilt));
        }
    }

    /// The displacement by rounding of all that the watched loops hold so far, as a multiple of the part of a length that is accepted as a gap:
    /// near a zero of its sine a loop turns by up to the root of rounding, and everything with it; where its pins come near each other, by what
    /// rounding turns the line between them.
    pub(super) fn doubt(&self, ssa: &mut SsaBuilder, size: f64, accepted: f64) -> Option<Value> {
        let scale = ssa.constant(size / accepted);
        let is_tilted =
            |watch: &&Watch| self.tilts.iter().any(|(number, _)| *number == watch.number);
        let others = self.loops.iter().filter(|watch| !is_tilted(watch));
        let turned: Vec<Value> = others.map(|watch| of_sine(ssa, watch)).collect();
        let tilts = self.tilts.iter().map(|(_, tilt)| tilt);
        let turned = turned.iter().chain(tilts);
        turned.fold(None, |sum, turned| {
            let displaced = ssa.mul(scale, *turned);
            Some(match sum {
                None => displaced,
                Some(sum) => ssa.add(sum, displaced),
            })
        })
    }

    /// The causes of a bound's growth, loops by their place among those that are watched so far.
    fn growth(&self, bound: &Bound) -> Vec<journey::Growth<f64>> {
        let watched = |number| self.loops.iter().position(|watch| watch.number == number);
        let growth = bound.growth.iter().filter_map(|growth| match *growth {
            Growth::NearZero(number) => watched(number).map(journey::Growth::Near),
            Growth::FarOut(input, unit) => Some(journey::Growth::Far(input, unit)),
        });
        growth.collect()
    }

    /// Counts the turns of an angle between −π and π, from where it starts. Gives the index in the state of the angle over any number of
    /// turns.
    pub(super) fn count_turns(
        &mut self,
        lowering: &mut Lowering<'_>,
        what: Turning,
        principal: Value,
        start: f64,
    ) -> usize {
        self.angles.push((what, principal));
        let mut known = lowering.plan.turning.iter();
        let bound = known.find(|(turning, _)| *turning == what);
        let bound = bound.map(|(_, bound)| bound.clone());
        // As long as nobody has looked, nothing moves.
        let bound = bound.unwrap_or_else(|| Bound::still(lowering.model.inputs()));
        let ssa = &mut lowering.ssa;
        let carried = ssa.carry(start);
        self.follows.push(Follow {
            angle: carried.index,
            growth: self.growth(&bound),
            rates: bound.rates,
            guessed: bound.guessed,
        });
        let behind = ssa.sub(carried.last, principal);
        let turn = ssa.constant(TAU);
        let turns = ssa.div(behind, turn);
        let turns = ssa.make(Op::Round(turns));
        let whole = ssa.mul(turn, turns);
        let angle = ssa.add(principal, whole);
        ssa.update(carried.index, angle);
        carried.index
    }

    /// Watches a dyad that is iterated like one in closed form: over a place where it does not close it may not leap.
    pub(super) fn watch_iteration(
        &mut self,
        ssa: &mut SsaBuilder,
        site: &LoopSite,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
    ) {
        if site.choice.watching.is_none() || equation.rings.len() != 1 {
            return;
        }
        let residuals = equation.residuals(ssa, solution);
        let [ring] = &residuals.rings[..] else {
            return;
        };
        let [a, b] = ring.columns[..] else {
            return;
        };
        let sine = ssa.sine_of([a, b]);
        let rounding_square = ssa.constant(16.0 * ssa.epsilon);
        self.watch(ssa, site, [sine, rounding_square], false);
    }

    /// Watches coupled loops, which pass their change points or stop there. Their determinant is that where they are closed.
    pub(super) fn watch_coupled(
        &mut self,
        ssa: &mut SsaBuilder,
        site: &LoopSite,
        newton: &Newton,
        side: CoupledSide,
    ) {
        let scale = ssa.constant(side.scale);
        let signed = ssa.make(Op::CopySign(scale, side.last));
        let sine = ssa.mul(signed, newton.det);
        let rounding_square = ssa.constant(OF_ROUNDING * ssa.epsilon);
        self.watch(ssa, site, [sine, rounding_square], true);
    }

    /// Watches a tied loop, which passes its change points or stops there: on its other side the iteration begins where the loop came
    /// from. Its columns are those where it is closed; its angles add these roundings.
    pub(super) fn watch_tied(
        &mut self,
        ssa: &mut SsaBuilder,
        site: &LoopSite,
        columns: &[Vec<Value>],
        roundings: Value,
    ) {
        let Some(columns) = pair(columns) else {
            return;
        };
        let sine = ssa.sine_of(columns);
        // As far as its angles have turned, so much more of the root of rounding hides the sign.
        let part = ssa.constant(OF_ROUNDING * ssa.epsilon);
        let share = ssa.mul(part, roundings);
        let rounding_square = ssa.add(part, share);
        self.watch(ssa, site, [sine, rounding_square], true);
    }
}

impl SsaBuilder {
    /// The sine of a loop of two unknowns, as its columns were at the start: its determinant, as a part of the product of their lengths
    /// there.
    fn sine_of(&mut self, [a, b]: [[Value; 2]; 2]) -> Value {
        let reach = self.size_at_start(&[a]) * self.size_at_start(&[b]);
        let det = self.cross(a, b);
        let scale = self.constant(1.0 / reach);
        self.mul(scale, det)
    }

    /// Carries on which side of its change point a tied loop is, if it is watched: a number with its sign, plus at the start.
    pub(super) fn carry_side(&mut self, choice: &Choice, columns: &[Vec<Value>]) -> Option<Value> {
        choice.watching.as_ref()?;
        let sine = self.sine_of(pair(columns)?);
        Some(self.carry(self.at_start(sine)).last)
    }

    /// Carries on which side of their change points coupled loops are, if they are watched.
    pub(super) fn carry_coupled_side(
        &mut self,
        choice: &Choice,
        columns: &[Vec<Value>],
    ) -> Option<CoupledSide> {
        choice.watching.as_ref()?;
        if columns.iter().any(|column| column.len() != columns.len()) {
            return None;
        }
        let number = |value: Value| self.at_start(value);
        let det = determinant(columns, number);
        let scale = 1.0 / det.abs().max(OF_LENGTHS * reach(columns, number));
        let last = self.carry(scale * det).last;
        Some(CoupledSide { last, scale })
    }
}

/// The two columns of a loop of two unknowns and one ring.
fn pair(columns: &[Vec<Value>]) -> Option<[[Value; 2]; 2]> {
    match columns {
        [a, b] => Some([a[..].try_into().ok()?, b[..].try_into().ok()?]),
        _ => None,
    }
}

impl Lowering<'_> {
    /// Carries the signs of the inputs' last motions, if a loop passes change points, and after them for each watched loop the number of
    /// its `Standing`: they say on which side it leaves one.
    pub(super) fn carry_motion_signs(&mut self, watches: &Watches) {
        let mut loops = watches.loops.iter();
        if loops.all(|watch| watch.at_zero == journey::AtZero::Stay) {
            return;
        }
        let signs = (0..self.model.inputs()).map(|_| self.ssa.carry(1.0).index);
        self.layout.motion_signs = signs.min();
        for _ in &watches.loops {
            self.ssa.carry(1.0);
        }
    }
}
