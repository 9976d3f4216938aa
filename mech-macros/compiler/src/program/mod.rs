//! The program: straight-line operations on scalars, block by block, from motor values and the last position to the next
//! position. Emitting it as Rust and running it now are readings of the same thing.

mod build;
mod builder;
mod calibrate;
mod choice;
mod clearance;
mod closed_form;
mod contact;
mod derived;
mod display;
mod divided;
mod forced;
mod forces;
mod formula;
mod gauge;
mod in_time;
mod live;
mod newton;
mod node;
mod sensitivity;
mod state;
mod timing;
mod watch;

pub(crate) use crate::plan::Dyad;
pub use crate::plan::{Bound, Growth};
pub(crate) use build::find_needed;
pub use build::{Output, build, build_as, derive};
pub use choice::{Choice, Solver, Watching};
pub use clearance::clearance;
pub(crate) use clearance::corners;
pub use closed_form::ClosedForm;
pub use contact::{CamContact, CamNumbers};
pub use derived::{Derived, LinearEquations, LinkRates, RateMargin, Results, System};
pub(crate) use forced::{Circumstances, Motion};
pub use forces::{Forces, Inertia, InverseDynamics};
pub(crate) use gauge::{Detail, Gauge};
pub(crate) use in_time::{Following, InTime};
pub(crate) use live::{computing, iteration};
pub use mech_core::Real;
pub use mech_core::journey::AtZero;
pub use newton::{Limits, Newton, Rounds, Scalar};
pub use node::{BlockId, Node, Op, Part, Slot, Value};
pub use sensitivity::{ParamRates, Sensitivity};
pub use state::{JointAngle, Place, StateLayout};
pub(crate) use timing::build_trajectory;
pub use timing::{LawValues, Timing, build_timing};
pub use watch::{Follow, Watch};

use crate::model::{LinkId, Precision};
use crate::plan::{Solution, Turning};

/// Values of motors up to this may be multiplied by any ratio of gears without leaving the range of single precision.
pub(crate) const MODERATE: f64 = 1e15;

/// A straight-line program.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Program {
    /// The name of the mechanism.
    pub name: String,
    /// The precision that it computes in.
    pub precision: Precision,
    /// Its operations.
    pub ssa: Ssa,
    /// The names of the motors' joints.
    pub motors: Vec<String>,
    /// The names of the params: they are given after the motors, by the same operation.
    pub params: Vec<String>,
    /// The moving links whose poses are stored, in the order of their declaration: without a `show` all.
    pub stored: Vec<LinkId>,
    /// Their names.
    pub links: Vec<String>,
    /// For each of them the cosine, sine, x and y of its new pose.
    pub poses: Vec<[Value; 4]>,
    /// The new values of what is carried from position to position.
    pub state: Vec<Value>,
    /// The layout of the state, but for the numbers of watched loops.
    pub layout: StateLayout,
    /// The unknowns of each loop that it solves, by the loop's number in the plan.
    pub(crate) solutions: Vec<(usize, Vec<Solution<Value>>)>,
    /// The loops in closed form that have dead points or change points.
    pub watches: Vec<Watch>,
    /// The angles that are followed over whole turns: how fast they turn at most.
    pub follows: Vec<Follow>,
    /// The same angles, less whole turns, and what they are.
    pub(crate) followed: Vec<(Turning, Value)>,
    /// The longest displacement of each motor and param in one piece, where loops are coupled, or laws or params change what was not examined.
    pub max_steps: Option<Vec<f64>>,
    /// For each motor and param, whether its value is read less whole turns, and the turns are read as a separate count. This
    /// keeps a declared accuracy after any number of turns.
    pub reduced: Vec<bool>,
    /// The least and the greatest value of each motor, if any has a declared range: it was proved that it moves through.
    pub range: Option<Vec<[f64; 2]>>,
    /// Whether something may move beyond the range of the numbers.
    pub overflows: bool,
    /// Whether a law may make an angle so large that the polynomials of sine and cosine do not reach it, whatever the motors' values.
    pub curved: bool,
    /// The values that it computes besides positions, if it does.
    pub derived: Option<Derived>,
    /// Whether anything depends on each value.
    pub live: Vec<bool>,
    /// The position in which the mechanism is assembled.
    pub start: Position<f64>,
}

/// Operations in SSA form, whatever they are for.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ssa {
    /// All values, each after those it is made from.
    pub nodes: Vec<Node>,
    /// The blocks, in the order in which they run.
    pub blocks: Vec<Block>,
}

/// One step of the plan.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Block {
    /// Its name, which is that of a function.
    pub name: String,
    /// Its title, for a reader.
    pub title: String,
    /// Its kind.
    pub kind: BlockKind,
}

impl Block {
    /// The number of the loop that it solves, if it solves one.
    pub(crate) fn loop_number(&self) -> Option<usize> {
        match &self.kind {
            BlockKind::Straight => None,
            BlockKind::ClosedForm(closed) => Some(closed.number),
            BlockKind::Newton(newton) => Some(newton.number),
        }
    }
}

/// The kind of a block.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BlockKind {
    /// One operation after another.
    Straight,
    /// The same, closing a loop: with a margin to be tested.
    ClosedForm(ClosedForm),
    /// With an iteration in it.
    Newton(Newton),
}

/// A position of a mechanism: everything that is carried from one move to the next.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Position<T> {
    /// The values of the motors, and after them those of the params.
    pub motors: Vec<T>,
    /// For each motor its whole turns, which are counted apart from its value.
    pub turns: Vec<i32>,
    /// For each moving link whose pose is stored its cosine, sine, x and y.
    pub poses: Vec<[T; 4]>,
    /// All other numbers that are carried from position to position, as unwrapped angles and the sides of dyads.
    pub state: Vec<T>,
}

impl<T: Copy> Position<T> {
    /// The same with other numbers.
    #[must_use]
    pub fn map<W>(&self, each: impl Fn(T) -> W) -> Position<W> {
        let all = |numbers: &[T]| numbers.iter().map(|number| each(*number)).collect();
        Position {
            motors: all(&self.motors),
            turns: self.turns.clone(),
            poses: self.poses.iter().map(|pose| pose.map(&each)).collect(),
            state: all(&self.state),
        }
    }

    /// The number in a slot.
    pub(crate) fn at(&self, slot: Slot) -> T {
        match slot {
            Slot::State(index) => self.state[index],
            Slot::Pose(link, part) => self.poses[link][part.index()],
        }
    }
}

impl Program {
    /// Whether its constants and its start are within the range of the scalar type.
    #[must_use]
    pub fn fits(&self) -> bool {
        let start = self.start.poses.iter().flatten().chain(&self.start.state);
        let constants = self.ssa.nodes.iter().filter_map(|node| match node.op {
            Op::Constant(number) => Some(number.get()),
            _ => None,
        });
        let watched = self.watches.iter().flat_map(|watch| &watch.rates);
        let followed = self.follows.iter().flat_map(|follow| &follow.rates);
        let steps = self.max_steps.iter().flatten();
        let emitted = watched.chain(followed).chain(steps);
        start.chain(emitted).copied().chain(constants).all(|number| self.precision.holds(number))
    }

    /// The number of inputs: motors, and after these params.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.motors.len() + self.params.len()
    }

    /// The names of all of them.
    pub fn input_names(&self) -> impl Iterator<Item = &String> {
        self.motors.iter().chain(&self.params)
    }

    /// Whether whole turns are taken out of any motor's value.
    #[must_use]
    pub fn reduces(&self) -> bool {
        self.reduced.contains(&true)
    }

    /// The node that makes a value.
    #[must_use]
    pub fn node(&self, value: Value) -> &Node {
        &self.ssa.nodes[value.index()]
    }

    /// Whether something depends on a value.
    #[must_use]
    pub fn is_live(&self, value: Value) -> bool {
        self.live[value.index()]
    }

    /// All values that something depends on, each after those it is made from.
    pub fn live_values(&self) -> impl Iterator<Item = Value> + '_ {
        (0u32..).map(Value).zip(&self.live).filter(|(_, live)| **live).map(|(value, _)| value)
    }

    /// Its results, besides the margins of its loops: poses, state, and whatever else it computes.
    pub(crate) fn roots(&self) -> impl Iterator<Item = Value> + '_ {
        let position = self.poses.iter().flatten().chain(&self.state).copied();
        position.chain(self.derived.iter().flat_map(Derived::roots))
    }

    /// The linear systems that it solves as a whole for its results besides positions.
    #[must_use]
    pub fn systems(&self) -> &[System] {
        let derived = self.derived.as_ref();
        derived.map_or(&[], |derived| &derived.equations.systems)
    }

    /// The margins by which these results are determined.
    #[must_use]
    pub fn rate_margins(&self) -> &[RateMargin] {
        let derived = self.derived.as_ref();
        derived.map_or(&[], |derived| &derived.equations.margins)
    }

    /// Its results besides positions.
    #[must_use]
    pub fn results(&self) -> Option<&Results> {
        self.derived.as_ref().map(|derived| &derived.results)
    }

    /// The forces that it computes.
    #[must_use]
    pub fn forces(&self) -> Option<&Forces<Value>> {
        match self.results()? {
            Results::Forces { forces, .. } => Some(forces),
            Results::Rates(_) | Results::Sensitivity(_) => None,
        }
    }

    /// The rates with each param that it computes.
    #[must_use]
    pub fn sensitivity(&self) -> Option<&Sensitivity> {
        match self.results()? {
            Results::Sensitivity(sensitivity) => Some(sensitivity),
            Results::Rates(_) | Results::Forces { .. } => None,
        }
    }

    /// The loop of a block, if it solves one.
    #[must_use]
    pub fn newton(&self, block: BlockId) -> Option<&Newton> {
        match &self.ssa.blocks[block.index()].kind {
            BlockKind::Newton(newton) => Some(newton),
            BlockKind::Straight | BlockKind::ClosedForm(_) => None,
        }
    }

    /// The closed form of a block, if it is one.
    #[must_use]
    pub fn closed_form(&self, block: BlockId) -> Option<&ClosedForm> {
        match &self.ssa.blocks[block.index()].kind {
            BlockKind::ClosedForm(closed) => Some(closed),
            BlockKind::Straight | BlockKind::Newton(_) => None,
        }
    }

    /// The number of the loop that a block solves, if it solves one.
    #[must_use]
    pub fn loop_of(&self, block: BlockId) -> Option<usize> {
        self.ssa.blocks[block.index()].loop_number()
    }

    /// The loops that it solves, by their numbers in the plan.
    #[must_use]
    pub fn solved_loops(&self) -> Vec<usize> {
        self.ssa.blocks.iter().filter_map(Block::loop_number).collect()
    }

    /// The linear systems of the motion that something depends on.
    pub fn live_systems(&self) -> impl Iterator<Item = &System> {
        self.systems().iter().enumerate().filter_map(|(number, system)| {
            let is_of =
                |value: Value| matches!(self.node(value).op, Op::Linear(of, _) if of == number);
            self.live_values().any(is_of).then_some(system)
        })
    }

    /// Whether a step that fails is subdivided: where loops are iterated until they close. A fixed number of rounds is a promise
    /// about time, which subdivision would break.
    #[must_use]
    pub fn subdivides(&self) -> bool {
        let newtons = self.block_ids().filter_map(|block| self.newton(block));
        let rounds: Vec<Rounds> = newtons.map(|newton| newton.rounds).collect();
        let is_fixed = |rounds: &Rounds| matches!(rounds, Rounds::Exactly(_));
        !rounds.is_empty() && !rounds.iter().any(is_fixed)
    }

    /// Whether a position is a function of the motors alone: every loop in closed form, and nothing carried.
    #[must_use]
    pub fn is_function(&self) -> bool {
        self.is_closed() && self.state.is_empty()
    }

    /// Whether loops pass change points: then it may take several turns until everything is where it was.
    #[must_use]
    pub fn passes_change_points(&self) -> bool {
        let mut watches = self.watches.iter();
        watches.any(|watch| watch.at_zero == AtZero::ChangeBranch)
    }

    /// Whether no move can fail whose values are within the declared ranges: every loop was proved to close there and needs no
    /// watching, and no number can grow beyond its type.
    #[must_use]
    pub fn never_fails(&self) -> bool {
        let Some(ranges) = &self.range else {
            return false;
        };
        let is_moderate = |end: &f64| end.is_infinite() || end.abs() <= MODERATE;
        let fits = !self.overflows || ranges.iter().flatten().all(is_moderate);
        fits && self.is_function() && self.margins().next().is_none() && self.max_steps.is_none()
    }

    /// Whether every loop is solved in closed form: no iteration, and no start that it would need.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.block_ids().all(|block| self.newton(block).is_none())
    }

    /// Whether it closes any loop.
    #[must_use]
    pub fn has_loops(&self) -> bool {
        !self.solved_loops().is_empty()
    }

    /// The closed forms that may fail to close: those whose margin is no constant, with their margins.
    pub fn margins(&self) -> impl Iterator<Item = (BlockId, &ClosedForm)> {
        self.closed_forms()
            .filter(|(_, closed)| !matches!(self.node(closed.margin).op, Op::Constant(_)))
    }

    /// All closed forms, in the order in which they are found.
    pub fn closed_forms(&self) -> impl Iterator<Item = (BlockId, &ClosedForm)> {
        self.block_ids().filter_map(|block| Some((block, self.closed_form(block)?)))
    }

    /// The ids of all blocks, in the order in which they run.
    pub fn block_ids(&self) -> impl Iterator<Item = BlockId> + use<> {
        (0u32..).take(self.ssa.blocks.len()).map(BlockId)
    }
}
