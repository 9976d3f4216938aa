//! The pieces in which a step is emitted: its blocks. A block with a loop like others is divided in two: what comes before the solution,
//! and the solution.

use super::Term;
use super::class::{Class, LEAST};
use super::shape::Shape;
use crate::cancel;
use crate::emit::step::flow::{Flow, is_computed, is_given};
use crate::emit::step::sines::is_short;
use crate::program::{BlockId, BlockKind, Op, Program, Slot, System, Value};
use std::collections::{BTreeMap, BTreeSet};

/// A block or a part of it.
pub(super) struct Piece {
    pub(super) block: BlockId,
    /// The values that it computes, in order.
    pub(super) values: Vec<Value>,
    /// The same, and in a class also values that another piece computes already: they are computed again.
    anew: Vec<Value>,
    pub(super) part: Part,
    pub(super) flow: Flow,
    /// The class of the piece and its row there; none if too few pieces are like it.
    pub(super) row: Option<Place>,
}

/// The part of a block that a piece is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// All of it.
    Whole,
    /// The part that is known before its loop is solved.
    Before,
    /// The solution of its loop.
    Solution,
}

/// The place of a piece in a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) class: usize,
    pub(super) row: usize,
}

/// All pieces, in the order of their blocks, and the classes among them.
pub(super) struct Pieces {
    pub(super) all: Vec<Piece>,
    pub(super) classes: Vec<Class>,
}

impl Pieces {
    /// The pieces of a program; none if no class is among them.
    pub(super) fn of(program: &Program) -> Option<Self> {
        let mut values = vec![Vec::new(); program.ssa.blocks.len()];
        for value in program.live_values() {
            let node = program.node(value);
            if is_computed(node.op) {
                values[node.block.index()].push(value);
            }
        }
        let solutions = solutions(program, &values)?;
        let mut all = Vec::new();
        for (block, values) in program.block_ids().zip(values) {
            let piece = |values: Vec<Value>, anew: Vec<Value>, part| Piece {
                block,
                values,
                anew,
                part,
                flow: Flow::default(),
                row: None,
            };
            match solutions.get(&block) {
                None if values.is_empty() => {}
                None => all.push(piece(values.clone(), values, Part::Whole)),
                Some(solution) => {
                    let inside: BTreeSet<Value> = solution.own.iter().copied().collect();
                    let others = values.into_iter().filter(|value| !inside.contains(value));
                    let others: Vec<Value> = others.collect();
                    if !others.is_empty() {
                        all.push(piece(others.clone(), others, Part::Before));
                    }
                    all.push(piece(solution.own.clone(), solution.anew.clone(), Part::Solution));
                }
            }
        }
        let has_functions = !is_short(program);
        let shapes = all.iter().enumerate().filter_map(|(number, piece)| {
            let is_candidate = match piece.part {
                Part::Before | Part::Solution => true,
                Part::Whole => has_functions && is_straight(program, piece.block),
            };
            let shape = is_candidate.then(|| shape(program, &piece.anew))?;
            Some((number, shape?))
        });
        let classes = Class::find(shapes.collect());
        for (class, found) in classes.iter().enumerate() {
            for (row, &piece) in found.pieces.iter().enumerate() {
                all[piece].row = Some(Place { class, row });
            }
        }
        let mut pieces = Self { all, classes };
        pieces.find_flows(program);
        pieces.find_outputs(program);
        Some(pieces)
    }

    /// Whether anything needs a piece.
    pub(super) fn is_run(&self, piece: usize) -> bool {
        !self.all[piece].flow.gives.is_empty()
    }

    /// The values of other pieces that a piece needs. One in a class may take a value where its own operations take the value's opposite.
    fn reads(&self, program: &Program, piece: &Piece) -> BTreeSet<Value> {
        cancel::check();
        if let Some(place) = piece.row {
            let row = &self.classes[place.class].rows[place.row];
            return row.arguments.iter().map(|term| term.value).collect();
        }
        let own: BTreeSet<Value> = piece.values.iter().copied().collect();
        let systems = piece.values.iter().filter_map(|&value| {
            let Op::Linear(number, _) = program.node(value).op else {
                return None;
            };
            Some(&program.systems()[number])
        });
        let coefficients = systems.flat_map(System::coefficients).copied();
        let operands = piece.values.iter().flat_map(|&value| program.node(value).op.operands());
        let all = operands.chain(coefficients);
        all.filter(|value| !own.contains(value)).collect()
    }

    fn find_flows(&mut self, program: &Program) {
        let mut makers = BTreeMap::new();
        for (number, piece) in self.all.iter().enumerate() {
            makers.extend(piece.values.iter().map(|&value| (value, number)));
        }
        let reads: Vec<BTreeSet<Value>> =
            self.all.iter().map(|piece| self.reads(program, piece)).collect();
        for (number, reads) in reads.into_iter().enumerate() {
            for value in reads {
                match program.node(value).op {
                    Op::Constant(_) => {}
                    Op::Last(slot) => {
                        let flow = &mut self.all[number].flow;
                        flow.reads_last = true;
                        if let Slot::Pose(link, _) = slot {
                            flow.links.insert(link);
                        }
                    }
                    op => {
                        self.all[number].flow.takes.insert(value);
                        if let (false, Some(&maker)) = (is_given(op), makers.get(&value)) {
                            self.all[maker].flow.gives.insert(value);
                        }
                    }
                }
            }
        }
        let margins = program.margins().map(|(_, closed)| closed.margin);
        for value in program.roots().chain(margins) {
            if let Some(&maker) = makers.get(&value) {
                self.all[maker].flow.gives.insert(value);
            }
        }
    }

    fn find_outputs(&mut self, program: &Program) {
        for piece in &self.all {
            let Some(place) = piece.row else {
                continue;
            };
            let class = &mut self.classes[place.class];
            for &value in &piece.flow.gives {
                let output = class.output(program, place.row, value);
                if !class.outputs.contains(&output) {
                    class.outputs.push(output);
                }
            }
        }
        for class in &mut self.classes {
            class.outputs.sort_unstable();
        }
    }
}

/// The solution of a loop.
struct Solution {
    /// Those values of its block that depend on the goal of its dyad.
    own: Vec<Value>,
    /// The values of the solution, and those of other blocks that depend on the goal as well: they are computed again.
    anew: Vec<Value>,
}

/// The solutions of loops that enough other loops are like, by their blocks; none if there are none.
fn solutions(program: &Program, values: &[Vec<Value>]) -> Option<BTreeMap<BlockId, Solution>> {
    if !program.is_closed() || program.closed_forms().count() < LEAST {
        return None;
    }
    let (mut blocks, mut shapes) = (Vec::new(), Vec::new());
    for (block, _) in program.closed_forms() {
        let solution = Solution::of(program, block, &values[block.index()]);
        if let Some(shape) = shape(program, &solution.anew) {
            shapes.push((blocks.len(), shape));
            blocks.push((block, solution));
        }
    }
    let classes = Class::find(shapes);
    let alike: BTreeSet<usize> =
        classes.iter().flat_map(|class| class.pieces.iter().copied()).collect();
    let alike = blocks.into_iter().enumerate().filter(|(number, _)| alike.contains(number));
    let solutions: BTreeMap<BlockId, Solution> = alike.map(|(_, found)| found).collect();
    (!solutions.is_empty()).then_some(solutions)
}

impl Solution {
    fn of(program: &Program, block: BlockId, values: &[Value]) -> Self {
        let goal: BTreeSet<Value> = program
            .closed_form(block)
            .iter()
            .flat_map(|closed| closed.dyad.goal())
            .map(|part| Term::of(program, part).value)
            .collect();
        let (mut dependent, mut rooted) = (goal.clone(), BTreeSet::new());
        let (mut own, mut others) = (Vec::new(), BTreeSet::new());
        for value in needed(program, values, goal.first().copied()) {
            let node = program.node(value);
            let is_goal = goal.contains(&Term::of(program, value).value);
            if is_goal || !node.op.operands().any(|operand| dependent.contains(&operand)) {
                continue;
            }
            dependent.insert(value);
            let is_rooted = node.op.operands().any(|operand| rooted.contains(&operand));
            if is_rooted || matches!(node.op, Op::Sqrt(_)) {
                rooted.insert(value);
            }
            if node.block == block {
                own.push(value);
            } else if !rooted.contains(&value) {
                others.insert(value);
            }
        }
        Self { anew: closure(program, &own, &others), own }
    }
}

/// These values and those that they are computed from, in order, without those before the first that is of interest.
fn needed(program: &Program, values: &[Value], first: Option<Value>) -> BTreeSet<Value> {
    let Some(first) = first else {
        return BTreeSet::new();
    };
    let is_of_interest = |value: &Value| *value >= first && program.is_live(*value);
    let mut waiting: Vec<Value> = values.iter().copied().filter(is_of_interest).collect();
    let mut found: BTreeSet<Value> = waiting.iter().copied().collect();
    while let Some(value) = waiting.pop() {
        let operands = program.node(value).op.operands();
        for operand in operands.filter(is_of_interest) {
            if found.insert(operand) {
                waiting.push(operand);
            }
        }
    }
    found
}

/// These values and those among `others` that they are computed from, each after those that it needs.
fn closure(program: &Program, values: &[Value], others: &BTreeSet<Value>) -> Vec<Value> {
    let (mut closure, mut made) = (Vec::new(), BTreeSet::new());
    for &value in values {
        make(program, value, others, &mut made, &mut closure);
    }
    closure
}

/// Adds a value to `order`, after those among `others` that it is computed from.
fn make(
    program: &Program,
    value: Value,
    others: &BTreeSet<Value>,
    made: &mut BTreeSet<Value>,
    order: &mut Vec<Value>,
) {
    if !made.insert(value) {
        return;
    }
    for operand in program.node(value).op.operands() {
        if others.contains(&operand) {
            make(program, operand, others, made, order);
        }
    }
    order.push(value);
}

/// The shape of these values, if they can be emitted as a function of numbers alone.
fn shape(program: &Program, values: &[Value]) -> Option<Shape> {
    let is_sine = |value: &Value| matches!(program.node(*value).op, Op::Sin(_) | Op::Cos(_));
    if values.is_empty() || values.iter().any(is_sine) {
        return None;
    }
    Shape::of(program, values)
}

fn is_straight(program: &Program, block: BlockId) -> bool {
    matches!(program.ssa.blocks[block.index()].kind, BlockKind::Straight)
}
