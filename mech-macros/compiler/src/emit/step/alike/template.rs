//! The function that pieces share, as a program of its own.

use super::Term;
use super::class::{Class, Output};
use super::pieces::Part;
use super::shape::{Kind, Operand};
use crate::bug::bug;
use crate::emit::step::block::function;
use crate::emit::step::flow::Flow;
use crate::model::Number;
use crate::program::{Block, BlockId, BlockKind, Node, Op, Program, Ssa, Value};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::BTreeMap;
use std::slice;

/// The data from which the function of a class is written.
pub(super) struct Shared<'c> {
    pub(super) program: &'c Program,
    pub(super) class: &'c Class,
    pub(super) numbers: &'c Numbers,
    pub(super) name: &'c Ident,
    /// The title of the block that stands for all.
    pub(super) title: &'c str,
    pub(super) part: Part,
    /// Whether it is called in loops only, where a call would keep the Rust compiler from computing several rows at once.
    pub(super) in_loops: bool,
}

impl Shared<'_> {
    pub(super) fn function(&self) -> TokenStream {
        let mut template = Template {
            program: self.program,
            class: self.class,
            block: BlockId::FIRST,
            nodes: Vec::new(),
            outers: BTreeMap::new(),
            columns: Vec::new(),
            results: Vec::new(),
            known: BTreeMap::new(),
        };
        template.parameters(self.numbers);
        let takes = (0..template.nodes.len()).map(Value::at).collect();
        template.operations(self.numbers);
        let outputs = self.class.outputs.iter();
        let gives: Vec<Value> = outputs.map(|output| template.output(*output)).collect();
        let before = match self.part {
            Part::Before => "What is known before: ",
            Part::Whole | Part::Solution => "",
        };
        let others = self.class.rows.len() - 1;
        let title = format!("{before}{} {others} more are like it.", self.title);
        let flow = Flow { takes, gives: gives.iter().copied().collect(), ..Flow::default() };
        let program = template.finish(&gives, title);
        let inline = if self.in_loops { quote!(inline(always)) } else { quote!(inline) };
        function(&program, BlockId::FIRST, self.name, &flow, &gives, &inline)
    }
}

/// A program that is being written from the operations of a class.
struct Template<'c> {
    program: &'c Program,
    class: &'c Class,
    block: BlockId,
    nodes: Vec<Node>,
    /// The parameters for what is known before the pieces.
    outers: BTreeMap<Value, Value>,
    /// The parameters for the columns of the table.
    columns: Vec<Value>,
    /// The results of the operations.
    results: Vec<Value>,
    /// The numbers that are made already, without their signs.
    known: BTreeMap<u64, Value>,
}

impl Template<'_> {
    fn make(&mut self, op: Op, name: Option<String>) -> Value {
        let value = Value::at(self.nodes.len());
        self.nodes.push(Node { op, block: self.block, iterated: false, name });
        value
    }

    fn parameter(&mut self, name: String) -> Value {
        let number = self.nodes.len();
        self.make(Op::Load(number), Some(name))
    }

    fn parameters(&mut self, numbers: &Numbers) {
        for value in self.class.shape.outers() {
            let name = self.name(value).unwrap_or_else(|| "known".to_owned());
            let parameter = self.parameter(name);
            self.outers.insert(value, parameter);
        }
        let sides = usize::from(self.class.has_sides());
        for column in 0..numbers.columns.len() {
            let is_side = column + sides == numbers.columns.len() && sides == 1;
            let name = if is_side { "side" } else { "number" };
            let parameter = self.parameter(name.to_owned());
            self.columns.push(parameter);
        }
    }

    /// The name of a value, without that of the instance to which it belongs.
    fn name(&self, value: Value) -> Option<String> {
        let name = self.program.node(value).name.as_deref()?;
        Some(within_instance(name).to_owned())
    }

    fn operations(&mut self, numbers: &Numbers) {
        let mut cells = numbers.cells.iter();
        let has_sides = self.class.has_sides();
        for operation in &self.class.shape.operations {
            let mut operands = Vec::new();
            for operand in &operation.operands {
                operands.push(self.operand(*operand, &mut cells));
            }
            let name = self.name(operation.value);
            let op = match (operation.kind, &operands[..]) {
                (Kind::Sum, &[(a, a_negative), (b, b_negative)]) => {
                    self.sum([a, b], [a_negative, b_negative])
                }
                (Kind::Product, &[a, b]) => {
                    let [a, b] = [a, b].map(|(value, negative)| self.signed(value, negative));
                    Op::Mul(a, b)
                }
                _ => {
                    let operands: Vec<Value> = operands
                        .iter()
                        .map(|&(value, negative)| self.signed(value, negative))
                        .collect();
                    let mut operands = operands.into_iter();
                    let original = self.program.node(operation.value).op;
                    original.map(|other| operands.next().unwrap_or(other))
                }
            };
            let result = match (operation.is_root && has_sides, self.columns.last()) {
                (true, Some(&side)) => {
                    let root = self.make(op, None);
                    self.make(Op::Mul(side, root), name)
                }
                _ => self.make(op, name),
            };
            self.results.push(result);
        }
    }

    /// An operand, and whether its opposite is meant. For a number, the next of `cells` says whether it is a constant or a column of the
    /// table.
    fn operand(&mut self, operand: Operand, cells: &mut slice::Iter<'_, Cell>) -> (Value, bool) {
        match operand {
            Operand::Inner { position, negative } => (self.results[position], negative),
            Operand::Outer(Term { value, negative }) => (self.outers[&value], negative),
            Operand::Number(_) => match cells.next() {
                Some(Cell::Column(column)) => (self.columns[*column], false),
                Some(Cell::Same(number)) => self.number(*number),
                None => bug!("a class has more numbers in its operations than in its rows"),
            },
        }
    }

    /// A number; a negative one as the opposite of a positive one.
    fn number(&mut self, number: f64) -> (Value, bool) {
        let key = number.abs().to_bits();
        let size = if let Some(&known) = self.known.get(&key) {
            known
        } else {
            let made = self.make(Op::Constant(Number::new(number.abs())), None);
            self.known.insert(key, made);
            made
        };
        (size, number < 0.0)
    }

    fn signed(&mut self, value: Value, negative: bool) -> Value {
        if !negative {
            return value;
        }
        match self.nodes[value.index()].op {
            Op::Constant(number) => self.make(Op::Constant(Number::new(-number.get())), None),
            _ => self.make(Op::Neg(value), None),
        }
    }

    fn sum(&mut self, [a, b]: [Value; 2], negative: [bool; 2]) -> Op {
        match negative {
            [false, false] => Op::Add(a, b),
            [false, true] => Op::Sub(a, b),
            [true, false] => Op::Sub(b, a),
            [true, true] => {
                let a = self.signed(a, true);
                Op::Sub(a, b)
            }
        }
    }

    fn output(&mut self, output: Output) -> Value {
        let result = self.results[output.position];
        let name = self.class.shape.operations[output.position].value;
        let name = self.name(name);
        if output.negative {
            self.make(Op::Neg(result), name)
        } else {
            if self.nodes[result.index()].name.is_none() {
                self.nodes[result.index()].name = name;
            }
            result
        }
    }

    fn finish(self, gives: &[Value], title: String) -> Program {
        let mut live = vec![false; self.nodes.len()];
        let mut waiting = gives.to_vec();
        while let Some(value) = waiting.pop() {
            if !std::mem::replace(&mut live[value.index()], true) {
                waiting.extend(self.nodes[value.index()].op.operands());
            }
        }
        let block = Block { name: String::new(), title, kind: BlockKind::Straight };
        Program {
            precision: self.program.precision,
            ssa: Ssa { nodes: self.nodes, blocks: vec![block] },
            live,
            ..Program::default()
        }
    }
}

/// The name of what belongs to an instance of a part, without the instance: `left[2].foot_x` becomes `foot_x`.
pub(super) fn within_instance(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, name)| name)
}

/// The place of a number in the function that pieces share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// It is the same in all rows.
    Same(f64),
    /// It differs, and is in this column of the table.
    Column(usize),
}

/// The numbers of a class.
pub(super) struct Numbers {
    /// The cells of the numbers of its operations.
    pub(super) cells: Vec<Cell>,
    /// The columns of its table, each with a number for each row.
    pub(super) columns: Vec<Vec<f64>>,
}

impl Numbers {
    pub(super) fn of(class: &Class) -> Self {
        let mut numbers = Self { cells: Vec::new(), columns: Vec::new() };
        for place in 0..class.rows[0].numbers.len() {
            let column: Vec<f64> = class.rows.iter().map(|row| row.numbers[place]).collect();
            let cell = numbers.cell(column);
            numbers.cells.push(cell);
        }
        if class.has_sides() {
            let sides = class
                .rows
                .iter()
                .map(|row| if row.is_on_other_side(&class.shape) { -1.0 } else { 1.0 });
            numbers.columns.push(sides.collect());
        }
        numbers
    }

    fn cell(&mut self, column: Vec<f64>) -> Cell {
        let first = column[0];
        if column.iter().all(|number| is_same(*number, first)) {
            return Cell::Same(first);
        }
        let known = self.columns.iter().position(|known| {
            let mut pairs = known.iter().zip(&column);
            pairs.all(|(a, b)| is_same(*a, *b))
        });
        Cell::Column(known.unwrap_or_else(|| {
            self.columns.push(column);
            self.columns.len() - 1
        }))
    }
}

fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}
