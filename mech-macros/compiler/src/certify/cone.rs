//! Cones: the values from which a program makes some outputs, back to where the cone is cut.
//!
//! A program of many loops is proved loop by loop: what earlier loops find is taken to be anything at all, unless that is too
//! little. So a proof costs no more in a long chain than in a short one.

use crate::cancel;
use crate::model::{InputId, Number};
use crate::plan::Solution;
use crate::program::{ClosedForm, Node, Op, Program, Value};
use std::collections::{BTreeMap, BinaryHeap};

/// A cone of more nodes is not looked at: it would depend on more loops than a proof can follow, and a chain of a thousand loops has a
/// thousand such cones.
const MOST_NODES: usize = 1024;

/// A variable of a cone: a value at which it is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Variable {
    /// An angle of which only sine and cosine are read.
    Angle(Value),
    /// An unknown that a loop finds, both by number: a direction, taken as its angle, or a displacement.
    Found(usize, usize),
    /// The value of a motor or of a param.
    Input(usize),
}

/// The values that some outputs are made from, renumbered. Inputs of its nodes are the variables.
#[derive(Clone, Debug)]
pub(crate) struct Cone {
    pub(crate) nodes: Vec<Node>,
    pub(crate) variables: Vec<Variable>,
    /// The outputs, in the order in which they were asked for.
    pub(crate) outputs: Vec<Value>,
}

/// The part of a loop's unknown that a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Share {
    Cos,
    Sin,
    Displacement,
}

/// Cuts cones out of a program.
#[derive(Clone, Debug)]
pub(crate) struct Cutter<'p> {
    pub(crate) program: &'p Program,
    /// The values at the start.
    pub(crate) at_start: Vec<f64>,
    found: BTreeMap<Value, (usize, usize, Share)>,
}

/// Where a cone is cut.
pub(crate) struct Cuts<'c> {
    /// Whether the solution of a loop, by its number, is written out.
    pub(crate) through: &'c dyn Fn(usize) -> bool,
    /// The loop whose solution is asked for, if one is: that is written out.
    pub(crate) own: Option<usize>,
    /// Whether an angle is written out, too, and not only its sine and cosine.
    pub(crate) into: &'c dyn Fn(Value) -> bool,
}

impl Cuts<'_> {
    /// Cuts each loop and each angle out by itself: nothing before them is written out.
    pub(crate) const ALONE: Self = Self { through: &|_| false, own: None, into: &|_| false };
}

impl<'p> Cutter<'p> {
    pub(crate) fn new(program: &'p Program) -> Self {
        let start = |closed: &ClosedForm| {
            let vectors = closed.dyad.vectors();
            let made = vectors.iter().flatten().copied();
            made.chain([closed.discriminant, closed.tolerance]).max()
        };
        let closed = program.closed_forms();
        let starts: BTreeMap<usize, Value> =
            closed.filter_map(|(_, closed)| Some((closed.number, start(closed)?))).collect();
        let mut found = BTreeMap::new();
        for (number, solutions) in &program.solutions {
            for (index, solution) in solutions.iter().enumerate() {
                let mut note = |value: Value, share| {
                    // A loop does not find a constant, nor a value that was there before the loop.
                    let before = starts.get(number).is_some_and(|start| value <= *start);
                    if !before && !matches!(program.node(value).op, Op::Constant(_)) {
                        found.entry(value).or_insert((*number, index, share));
                    }
                };
                match *solution {
                    Solution::Direction([cos, sin]) => {
                        note(cos, Share::Cos);
                        note(sin, Share::Sin);
                    }
                    Solution::Slide(displacement) => note(displacement, Share::Displacement),
                }
            }
        }
        Self { program, at_start: program.values_at_start(), found }
    }

    /// Returns the cone of these outputs; none if it is too large.
    pub(crate) fn cone(&self, outputs: &[Value], cuts: &Cuts<'_>) -> Option<Cone> {
        cancel::check();
        // From the last to the first: what is asked for twice comes out twice in a row.
        let mut needed: Vec<Value> = Vec::new();
        let mut waiting: BinaryHeap<Value> = outputs.iter().copied().collect();
        while let Some(value) = waiting.pop() {
            if needed.last() == Some(&value) {
                continue;
            }
            if needed.len() == MOST_NODES {
                return None;
            }
            needed.push(value);
            if self.cut(value, outputs, cuts).is_none() {
                waiting.extend(self.program.node(value).op.operands());
            }
        }
        let mut growing = ConeBuilder {
            cone: Cone {
                nodes: Vec::with_capacity(needed.len()),
                variables: Vec::new(),
                outputs: Vec::new(),
            },
            inputs: Vec::new(),
            copies: BTreeMap::new(),
        };
        for &value in needed.iter().rev() {
            let node = self.program.node(value);
            let op = match self.cut(value, outputs, cuts) {
                Some((variable, Share::Cos)) => Op::Cos(growing.variable(variable, node)),
                Some((variable, Share::Sin)) => Op::Sin(growing.variable(variable, node)),
                Some((variable, Share::Displacement)) => {
                    let input = growing.variable(variable, node);
                    growing.copies.insert(value, input);
                    continue;
                }
                None => match node.op {
                    // Values are taken with all their turns in them.
                    Op::Turns(_) | Op::PartOfTurns(..) => Op::Constant(Number::new(0.0)),
                    op => op.map(|operand| growing.copies[&operand]),
                },
            };
            let copy = growing.push(Node { op, ..node.clone() });
            growing.copies.insert(value, copy);
        }
        let ConeBuilder { mut cone, copies, .. } = growing;
        cone.outputs = outputs.iter().map(|output| copies[output]).collect();
        Some(cone)
    }

    /// Whether a variable stands for a value.
    pub(crate) fn is_cut(&self, value: Value, outputs: &[Value], cuts: &Cuts<'_>) -> bool {
        let cut = self.cut(value, outputs, cuts);
        cut.is_some_and(|(variable, _)| !matches!(variable, Variable::Input(_)))
    }

    /// The variable that stands for a value, if the program is cut there.
    fn cut(&self, value: Value, outputs: &[Value], cuts: &Cuts<'_>) -> Option<(Variable, Share)> {
        if let Some(&(number, index, share)) = self.found.get(&value)
            && !(cuts.through)(number)
            && !(cuts.own == Some(number) && outputs.contains(&value))
        {
            return Some((Variable::Found(number, index), share));
        }
        match self.program.node(value).op {
            Op::Sin(angle) if !(cuts.into)(angle) => Some((Variable::Angle(angle), Share::Sin)),
            Op::Cos(angle) if !(cuts.into)(angle) => Some((Variable::Angle(angle), Share::Cos)),
            Op::Input(input) => Some((Variable::Input(input.index()), Share::Displacement)),
            _ => None,
        }
    }

    /// Returns an unknown that a loop finds, both by number.
    pub(crate) fn solution(&self, number: usize, index: usize) -> Option<Solution<Value>> {
        let (_, found) = self.program.solutions.iter().find(|(of, _)| *of == number)?;
        found.get(index).copied()
    }

    /// A sum of constant parts of inputs, if an angle is one: for each input the part.
    pub(crate) fn parts(&self, angle: Value) -> Option<BTreeMap<usize, f64>> {
        let node = self.program.node(angle);
        let both = |a: Value, b: Value, sign: f64| {
            let (mut sum, other) = (self.parts(a)?, self.parts(b)?);
            for (input, part) in other {
                *sum.entry(input).or_insert(0.0) += sign * part;
            }
            Some(sum)
        };
        let scaled = |a: Value, by: f64| {
            let parts = self.parts(a)?;
            Some(parts.into_iter().map(|(input, part)| (input, part * by)).collect())
        };
        match node.op {
            Op::Constant(_) | Op::Turns(_) | Op::PartOfTurns(..) => Some(BTreeMap::new()),
            Op::Input(input) => Some(BTreeMap::from([(input.index(), 1.0)])),
            Op::Neg(a) => scaled(a, -1.0),
            Op::Add(a, b) => both(a, b, 1.0),
            Op::Sub(a, b) => both(a, b, -1.0),
            Op::Mul(a, b) => match (self.program.node(a).op, self.program.node(b).op) {
                (Op::Constant(by), _) => scaled(b, by.get()),
                (_, Op::Constant(by)) => scaled(a, by.get()),
                _ => None,
            },
            Op::Div(a, by) => match self.program.node(by).op {
                Op::Constant(by) => scaled(a, 1.0 / by.get()),
                _ => None,
            },
            _ => None,
        }
    }

    /// After how many turns of an input an angle that is a sum of inputs has made whole turns only. None if that is not known.
    pub(crate) fn turns_until_whole(
        &self,
        angle: Value,
        input: usize,
        part: f64,
    ) -> Option<(i64, i64)> {
        let mut waiting = vec![angle];
        let mut exact = None;
        while let Some(value) = waiting.pop() {
            match self.program.node(value).op {
                Op::PartOfTurns(of, numerator, denominator) if of.index() == input => {
                    // Of several parts of one motor only their sum tells.
                    if exact.replace((numerator, denominator)).is_some() {
                        return None;
                    }
                }
                Op::Turns(of) if of.index() == input => return None,
                op => waiting.extend(op.operands()),
            }
        }
        match exact {
            Some(exact) => Some(exact),
            #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
            None if part.fract() == 0.0 && part.abs() < 1e9 => Some((part as i64, 1)),
            None => None,
        }
    }
}

/// A cone that grows.
struct ConeBuilder {
    cone: Cone,
    /// The nodes of the variables.
    inputs: Vec<Value>,
    copies: BTreeMap<Value, Value>,
}

impl ConeBuilder {
    fn push(&mut self, node: Node) -> Value {
        self.cone.nodes.push(node);
        Value::at(self.cone.nodes.len() - 1)
    }

    /// The node that stands for a variable.
    fn variable(&mut self, variable: Variable, like: &Node) -> Value {
        let known = self.cone.variables.iter().position(|known| *known == variable);
        if let Some(known) = known {
            return self.inputs[known];
        }
        let op = Op::Input(InputId::new(self.cone.variables.len()));
        let node = self.push(Node { op, ..like.clone() });
        self.cone.variables.push(variable);
        self.inputs.push(node);
        node
    }
}
