//! The construction of a program in SSA form: constants are folded, and common subexpressions made once.

use super::node::{BlockId, Node, Op, Slot, Value};
use super::{Block, BlockKind, Position, Program, Ssa};
use crate::cancel;
use crate::model::{Axis, Number, Precision};
use crate::plan::{Algebra, Arithmetic, are_equal};
use std::collections::{BTreeMap, HashMap};

/// The operations of a program that is being built, and the state that its positions carry.
#[derive(Debug, Default)]
pub(super) struct SsaBuilder {
    pub(super) ssa: Ssa,
    /// Looked up only, never iterated: the program does not depend on its order.
    known: HashMap<Op, Value>,
    /// The operations that are known only inside the present iteration.
    inside: Option<Vec<Op>>,
    /// Every value at the start.
    at_start: Vec<f64>,
    /// The position at the start.
    pub(super) start: Position<f64>,
    /// The new values of the state's numbers.
    pub(super) state: Vec<Value>,
    /// The rounding unit of what the program computes in.
    pub(super) epsilon: f64,
    /// The number of motors: inputs after them are params.
    pub(super) motors: usize,
    /// Whether a value is made from a param.
    varies: Vec<bool>,
    /// The cosines and sines of directions, each with the one that it was first named with.
    of_directions: HashMap<Value, Value>,
    /// For each motor, and each angle that drives gears, the greatest factor by which another angle follows it: rounding grows by that.
    pub(super) gains: BTreeMap<Value, f64>,
    /// The values of the model's formulas, by their numbers.
    pub(super) formulas: Vec<Value>,
    /// The variables of the law or requirement that is being lowered.
    pub(super) variables: Vec<Value>,
}

/// A number of the state.
#[derive(Clone, Copy, Debug)]
pub(super) struct StateNumber {
    /// Its position in the state.
    pub(super) index: usize,
    /// Its value at the last position.
    pub(super) last: Value,
}

impl SsaBuilder {
    /// Begins a program for a mechanism that is at `start` and is computed in this precision.
    pub(super) fn new(start: Position<f64>, precision: Precision) -> Self {
        Self { start, epsilon: precision.epsilon(), ..Self::default() }
    }

    /// Goes on with a program that was built: what it computes already is made no second time.
    pub(super) fn resume(program: &Program) -> Self {
        let nodes = program.ssa.nodes.iter().enumerate();
        let kept = nodes.filter(|(_, node)| !node.iterated);
        Self {
            known: kept.map(|(index, node)| (node.op, Value::at(index))).collect(),
            at_start: program.values_at_start(),
            varies: vec![false; program.ssa.nodes.len()],
            ssa: program.ssa.clone(),
            start: program.start.clone(),
            state: program.state.clone(),
            epsilon: program.precision.epsilon(),
            motors: program.motors.len(),
            ..Self::default()
        }
    }

    /// Whether a value depends on a param. Its size then is not what it is at the start.
    pub(super) fn varies(&self, value: Value) -> bool {
        self.varies[value.index()]
    }

    /// Whether a value is the cosine or the sine of a direction: it is not greater than one.
    pub(super) fn is_of_direction(&self, part: Value) -> bool {
        self.of_directions.contains_key(&part)
    }

    /// Whether two values are the cosine and the sine of a direction. One cosine has two sines, if a direction is reversed.
    pub(super) fn are_direction(&self, [a, b]: [Value; 2]) -> bool {
        let is = |part: Value, other| self.of_directions.get(&part) == Some(&other);
        is(a, b) || is(b, a)
    }

    /// A value at the start.
    pub(super) fn at_start(&self, value: Value) -> f64 {
        self.at_start[value.index()]
    }

    /// Notes with which value the iteration of an unknown begins: at the start, that is its solution.
    pub(super) fn begins_with(&mut self, unknown: Value, first: Value) {
        self.at_start[unknown.index()] = self.at_start[first.index()];
    }

    /// Adds a number to the state, with its value at the start. Unless it is [updated](Self::update), it stays what it is.
    pub(super) fn carry(&mut self, start: f64) -> StateNumber {
        let index = self.state.len();
        self.start.state.push(start);
        let last = self.make(Op::Last(Slot::State(index)));
        self.state.push(last);
        StateNumber { index, last }
    }

    /// Adds a number to the state, which takes this value at every position.
    pub(super) fn record(&mut self, value: Value) -> StateNumber {
        let carried = self.carry(self.at_start(value));
        self.update(carried.index, value);
        carried
    }

    /// Gives a number of the state its new value.
    pub(super) fn update(&mut self, index: usize, value: Value) {
        self.state[index] = value;
    }

    /// The new value of a number of the state.
    pub(super) fn state(&self, index: usize) -> Value {
        self.state[index]
    }

    /// Begins a new block.
    pub(super) fn block(&mut self, name: String, title: String) -> BlockId {
        self.ssa.blocks.push(Block { name, title, kind: BlockKind::Straight });
        self.current()
    }

    /// Says how a block works.
    pub(super) fn set_kind(&mut self, block: BlockId, kind: BlockKind) {
        self.ssa.blocks[block.index()].kind = kind;
    }

    pub(super) fn current(&self) -> BlockId {
        // A value before the first block stands in that block.
        BlockId::at(self.ssa.blocks.len().saturating_sub(1))
    }

    /// From here to [`leave`](Self::leave) whatever depends on the block's unknowns is made anew in every round.
    pub(super) fn enter(&mut self) {
        self.inside = Some(Vec::new());
    }

    /// Ends the iteration and forgets what was made in it.
    pub(super) fn leave(&mut self) {
        for op in self.inside.take().into_iter().flatten() {
            self.known.remove(&op);
        }
    }

    /// The value that this operation makes, made now unless it was before.
    pub(super) fn make(&mut self, op: Op) -> Value {
        cancel::check();
        if let Some(&known) = self.known.get(&op) {
            return known;
        }
        let block = self.current();
        let depends = |value: Value| {
            let node = &self.ssa.nodes[value.index()];
            node.iterated && node.block == block
        };
        let iterated = self.inside.is_some()
            && (matches!(op, Op::Unknown(..) | Op::Dense(..)) || op.operands().any(depends));
        let value = Value::at(self.ssa.nodes.len());
        // Where unknowns begin is set afterwards.
        let at_start = op.at_start(&self.start, |value| self.at_start[value.index()]);
        self.at_start.push(at_start);
        let varies = match op {
            Op::Input(input) => input.motor(self.motors).is_none(),
            op => op.operands().any(|operand| self.varies(operand)),
        };
        self.varies.push(varies);
        self.ssa.nodes.push(Node { op, block, iterated, name: None });
        self.known.insert(op, value);
        if let (true, Some(inside)) = (iterated, &mut self.inside) {
            inside.push(op);
        }
        value
    }

    /// Says what an operation that comes from outside gives from now on.
    pub(super) fn give(&mut self, op: Op, value: Value) {
        self.known.insert(op, value);
    }

    /// Gives a value a name, unless it has one or is a constant.
    pub(super) fn name(&mut self, value: Value, name: impl Into<String>) -> Value {
        let node = &mut self.ssa.nodes[value.index()];
        if node.name.is_none() && !matches!(node.op, Op::Constant(_)) {
            node.name = Some(name.into());
        }
        value
    }

    /// Gives the two numbers of a vector names.
    pub(super) fn name_vector(&mut self, v: [Value; 2], name: &str) -> [Value; 2] {
        [self.name(v[0], format!("{name}_x")), self.name(v[1], format!("{name}_y"))]
    }

    /// Gives the cosine and sine of a direction names.
    pub(super) fn name_direction(&mut self, v: [Value; 2], name: &str) -> [Value; 2] {
        for [part, other] in [v, [v[1], v[0]]] {
            self.of_directions.entry(part).or_insert(other);
        }
        [self.name(v[0], format!("{name}_cos")), self.name(v[1], format!("{name}_sin"))]
    }

    pub(super) fn abs(&mut self, a: Value) -> Value {
        match (self.number(a), self.negation(a)) {
            (Some(a), _) => self.constant(a.abs()),
            (_, Some(inner)) => self.abs(inner),
            _ => self.make(Op::Abs(a)),
        }
    }

    pub(super) fn max(&mut self, a: Value, b: Value) -> Value {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => self.constant(a.max(b)),
            _ => self.make(Op::Max(a, b)),
        }
    }

    pub(super) fn copysign(&mut self, size: Value, sign: Value) -> Value {
        match (self.number(size), self.number(sign)) {
            (Some(size), Some(sign)) => self.constant(size.copysign(sign)),
            _ => self.make(Op::CopySign(size, sign)),
        }
    }

    /// The name of a value.
    pub(super) fn name_of(&self, value: Value) -> Option<&str> {
        self.ssa.nodes[value.index()].name.as_deref()
    }

    /// The operation that makes a value.
    pub(super) fn op(&self, value: Value) -> Op {
        self.ssa.nodes[value.index()].op
    }

    /// The value that this operation makes, if it was made.
    pub(super) fn find(&self, op: Op) -> Option<Value> {
        self.known.get(&op).copied()
    }

    pub(super) fn number(&self, value: Value) -> Option<f64> {
        match self.ssa.nodes[value.index()].op {
            Op::Constant(number) => Some(number.get()),
            _ => None,
        }
    }

    fn negation(&self, value: Value) -> Option<Value> {
        match self.ssa.nodes[value.index()].op {
            Op::Neg(inner) => Some(inner),
            _ => None,
        }
    }
}

impl Arithmetic for SsaBuilder {
    type Scalar = Value;

    fn constant(&mut self, value: f64) -> Value {
        self.make(Op::Constant(Number::new(value)))
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.constant(a + b),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.negation(a), self.negation(b)) {
            (_, Some(b)) => self.sub(a, b),
            (Some(a), _) => self.sub(b, a),
            _ => self.make(Op::Add(a.min(b), a.max(b))),
        }
    }

    fn sub(&mut self, a: Value, b: Value) -> Value {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.constant(a - b),
            (Some(0.0), _) => return self.neg(b),
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match self.negation(b) {
            Some(b) => self.add(a, b),
            None => self.make(Op::Sub(a, b)),
        }
    }

    fn mul(&mut self, a: Value, b: Value) -> Value {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.constant(a * b),
            (Some(0.0), _) | (_, Some(0.0)) => return self.constant(0.0),
            (Some(1.0), _) => return b,
            (_, Some(1.0)) => return a,
            (Some(-1.0), _) => return self.neg(b),
            (_, Some(-1.0)) => return self.neg(a),
            _ => {}
        }
        match (self.negation(a), self.negation(b)) {
            (Some(a), Some(b)) => self.mul(a, b),
            (Some(a), None) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (None, Some(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            _ => self.make(Op::Mul(a.min(b), a.max(b))),
        }
    }

    fn div(&mut self, a: Value, b: Value) -> Value {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) if b != 0.0 => self.constant(a / b),
            (_, Some(1.0)) => a,
            // A product is several times cheaper, and as good up to a rounding.
            (_, Some(b)) if b != 0.0 && (1.0 / b).is_normal() => {
                let inverse = self.constant(1.0 / b);
                self.mul(a, inverse)
            }
            _ => self.make(Op::Div(a, b)),
        }
    }

    fn neg(&mut self, a: Value) -> Value {
        match (self.number(a), self.negation(a)) {
            (Some(a), _) => self.constant(-a),
            (_, Some(inner)) => inner,
            _ => self.make(Op::Neg(a)),
        }
    }
}

impl Algebra<Value> for SsaBuilder {
    fn number_at_start(&self, value: Value) -> f64 {
        self.at_start(value)
    }

    fn difference(&mut self, a: Value, b: Value) -> Value {
        match [a, b].map(|length| self.number(length)) {
            [Some(a), Some(b)] if are_equal(a, b, self.epsilon) => self.constant(0.0),
            _ => self.sub(a, b),
        }
    }

    fn place(&mut self, axis: &Axis) -> [Value; 2] {
        [0, 1].map(|part| match axis.formulas[part] {
            Some(id) => self.formulas[id.index()],
            None => self.constant(axis.at[part]),
        })
    }

    fn direction(&mut self, axis: &Axis) -> [Value; 2] {
        [0, 1].map(|part| match axis.direction_formulas[part] {
            Some(id) => self.formulas[id.index()],
            None => self.constant(axis.direction[part]),
        })
    }

    fn mirrored_direction(&mut self, axis: &Axis) -> [Value; 2] {
        if axis.turns() {
            let direction = self.direction(axis);
            return self.conjugate(direction);
        }
        let [x, y] = axis.direction;
        self.vector([x, -y])
    }

    fn between(&mut self, from: &Axis, to: &Axis) -> [Value; 2] {
        if !from.varies() && !to.varies() {
            return self.vector([to.at[0] - from.at[0], to.at[1] - from.at[1]]);
        }
        let (from, to) = (self.place(from), self.place(to));
        self.minus(to, from)
    }

    fn sqrt(&mut self, a: Value) -> Value {
        match self.number(a) {
            Some(a) if a >= 0.0 => self.constant(a.sqrt()),
            _ => self.make(Op::Sqrt(a)),
        }
    }

    fn label(&mut self, value: Value, name: &str) -> Value {
        self.name(value, name)
    }
}
