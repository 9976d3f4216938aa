//! The names in a generated function, and expressions that use them.

use crate::bug::bug;
use crate::cancel;
use crate::emit::module;
use crate::emit::tokens::{hidden_ident, integer, number, without_path};
use crate::program::{Op, Part, Program, Slot, Value};
use mech_core::Staircase;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeMap, BTreeSet};

/// The precedence of an expression, the weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// An element of an array that is a variable.
struct Element {
    array: Ident,
    row: usize,
    /// The length of the array.
    rows: usize,
}

/// Where a value stands in an array.
pub(super) struct Place {
    pub(super) array: Ident,
    pub(super) row: usize,
}

/// A variable: a number, or an array of so many.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Variable {
    pub(super) name: Ident,
    pub(super) rows: Option<usize>,
}

/// The names and uses of values in one function.
pub(super) struct Scope<'p> {
    pub(super) program: &'p Program,
    names: BTreeMap<Value, Ident>,
    /// The values that are elements of arrays.
    elements: BTreeMap<Value, Element>,
    /// The variables that hold the last poses of links, by the links' numbers.
    last_poses: BTreeMap<usize, Ident>,
    taken: BTreeSet<String>,
    /// The last number behind each name that several variables would have.
    numbers: BTreeMap<String, usize>,
    /// The number of uses of each value in this function.
    uses: BTreeMap<Value, usize>,
    /// The path of the function that computes sines and cosines.
    sin_cos: TokenStream,
}

impl<'p> Scope<'p> {
    /// The scope of a function that uses values so often and computes sines and cosines by `sin_cos`.
    pub(super) fn new(
        program: &'p Program,
        uses: BTreeMap<Value, usize>,
        sin_cos: TokenStream,
    ) -> Self {
        Self {
            program,
            names: BTreeMap::new(),
            elements: BTreeMap::new(),
            last_poses: BTreeMap::new(),
            taken: module::taken_names().collect(),
            numbers: BTreeMap::new(),
            uses,
            sin_cos,
        }
    }

    /// A name that nothing else in this function has.
    pub(super) fn fresh(&mut self, wanted: &str) -> Ident {
        let wanted = without_path(wanted);
        let (taken, last) = (&self.taken, self.numbers.get(&wanted).copied());
        let (name, number) = free_name(&wanted, last, |name| taken.contains(name));
        self.numbers.insert(wanted, number);
        let ident = hidden_ident(&name);
        self.taken.insert(name);
        ident
    }

    /// A name for another function, which neither a variable here nor any of `functions` has.
    pub(super) fn fresh_function(
        &mut self,
        functions: &mut BTreeSet<String>,
        wanted: &str,
    ) -> Ident {
        let is_taken = |name: &str| self.taken.contains(name) || functions.contains(name);
        let (name, _) = free_name(&without_path(wanted), None, is_taken);
        let ident = hidden_ident(&name);
        self.taken.insert(name.clone());
        functions.insert(name);
        ident
    }

    /// The variable that holds the last pose of a link.
    pub(super) fn last_pose(&mut self, link: usize) -> Ident {
        if let Some(known) = self.last_poses.get(&link) {
            return known.clone();
        }
        let name = self.fresh(&format!("last_{}", self.program.links[link]));
        self.last_poses.insert(link, name.clone());
        name
    }

    /// The name of a value in this function; a new one if it has none yet.
    pub(super) fn bind(&mut self, value: Value) -> Ident {
        if let Some(known) = self.names.get(&value) {
            return known.clone();
        }
        let wanted = self.program.node(value).name.as_deref().unwrap_or("part");
        let name = self.fresh(wanted);
        self.alias(value, name.clone());
        name
    }

    /// The names of several values.
    pub(super) fn bind_all<'v>(
        &mut self,
        values: impl IntoIterator<Item = &'v Value>,
    ) -> Vec<Ident> {
        let values = values.into_iter();
        values.map(|&value| self.bind(value)).collect()
    }

    /// Gives a value the name of an existing variable.
    pub(super) fn alias(&mut self, value: Value, name: Ident) {
        self.names.insert(value, name);
    }

    /// Makes a value known as an element of an array of so many rows.
    pub(super) fn place(&mut self, value: Value, array: Ident, row: usize, rows: usize) {
        self.elements.insert(value, Element { array, row, rows });
    }

    /// Whether any value is an element of an array.
    pub(super) fn has_arrays(&self) -> bool {
        !self.elements.is_empty()
    }

    /// The array in which a value stands, and where.
    pub(super) fn place_of(&self, value: Value) -> Option<Place> {
        let element = self.elements.get(&value)?;
        Some(Place { array: element.array.clone(), row: element.row })
    }

    /// The array whose elements are these values, from the first to the last.
    pub(super) fn array(&self, values: impl ExactSizeIterator<Item = Value>) -> Option<Ident> {
        let count = values.len();
        let mut array = None;
        for (row, value) in values.enumerate() {
            let element = self.elements.get(&value)?;
            let is_first = array.get_or_insert(&element.array);
            if *is_first != &element.array || (element.row, element.rows) != (row, count) {
                return None;
            }
        }
        array.cloned()
    }

    /// The variables that hold these values, each once.
    pub(super) fn variables<'v>(
        &mut self,
        values: impl IntoIterator<Item = &'v Value>,
    ) -> Vec<Variable> {
        let mut variables = Vec::new();
        let mut known = BTreeSet::new();
        for &value in values {
            let variable = match self.elements.get(&value) {
                Some(Element { array, rows, .. }) => {
                    Variable { name: array.clone(), rows: Some(*rows) }
                }
                None => Variable { name: self.bind(value), rows: None },
            };
            if known.insert((variable.name.clone(), variable.rows)) {
                variables.push(variable);
            }
        }
        variables
    }

    pub(super) fn is_bound(&self, value: Value) -> bool {
        self.names.contains_key(&value) || self.elements.contains_key(&value)
    }

    /// Whether a value deserves a `let` of its own: it means something, or it is used more than once.
    pub(super) fn deserves_name(&self, value: Value) -> bool {
        let node = self.program.node(value);
        let leaf = matches!(node.op, Op::Constant(_) | Op::Last(_));
        !leaf && (node.name.is_some() || self.uses.get(&value).is_some_and(|&uses| uses > 1))
    }

    /// The live value of an operation, if there is one.
    pub(super) fn value_of(&self, op: Op) -> Option<Value> {
        let mut live = self.program.live_values();
        live.find(|&value| self.program.node(value).op == op)
    }

    /// A value as an expression: its name if it has one here, else its operation.
    pub(super) fn expression(&self, value: Value) -> TokenStream {
        self.name_or_operation(value).0
    }

    /// Several values as expressions.
    pub(super) fn expressions<'v>(
        &self,
        values: impl IntoIterator<Item = &'v Value>,
    ) -> Vec<TokenStream> {
        let values = values.into_iter();
        values.map(|&value| self.expression(value)).collect()
    }

    /// A value with the opposite sign.
    pub(super) fn negation(&self, value: Value) -> TokenStream {
        let value = self.operand(value, Binding::Sign);
        quote!(-#value)
    }

    /// The operation of a value, even if the value has a name.
    pub(super) fn definition(&self, value: Value) -> TokenStream {
        self.operation(value).0
    }

    /// The sine and cosine of an angle, as a pair.
    pub(super) fn sin_cos(&self, angle: Value) -> TokenStream {
        let (sin_cos, angle) = (&self.sin_cos, self.expression(angle));
        quote!(#sin_cos(#angle))
    }

    fn name_or_operation(&self, value: Value) -> (TokenStream, Binding) {
        cancel::check();
        match (self.names.get(&value), self.elements.get(&value)) {
            (Some(name), _) => (quote!(#name), Binding::Atom),
            (None, Some(Element { array, row, .. })) => {
                let row = integer(*row);
                (quote!(#array[#row]), Binding::Atom)
            }
            (None, None) => self.operation(value),
        }
    }

    fn operation(&self, value: Value) -> (TokenStream, Binding) {
        let call = |function: TokenStream, arguments: &[Value]| {
            let arguments = self.expressions(arguments);
            quote!(#function(#(#arguments),*))
        };
        let atom = match self.program.node(value).op {
            Op::Constant(constant) if constant.get() < 0.0 => {
                return (self.number(constant.get()), Binding::Sign);
            }
            Op::Neg(a) => return (self.negation(a), Binding::Sign),
            Op::Add(a, b) => return self.infix(a, &quote!(+), b, Binding::Sum),
            Op::Sub(a, b) => return self.infix(a, &quote!(-), b, Binding::Sum),
            Op::Mul(a, b) => return self.infix(a, &quote!(*), b, Binding::Product),
            Op::Div(a, b) => return self.infix(a, &quote!(/), b, Binding::Product),
            Op::Choose(test, a, b) => {
                let [test, a, b] = [test, a, b].map(|value| self.expression(value));
                let choice = quote!(if #test >= 0.0 { #a } else { #b });
                return (choice, Binding::Sum);
            }
            Op::Constant(constant) => self.number(constant.get()),
            Op::Last(slot) => self.last(slot),
            Op::Abs(a) => {
                let a = self.operand(a, Binding::Atom);
                quote!(#a.abs())
            }
            Op::CopySign(a, b) => {
                let (a, b) = (self.operand(a, Binding::Atom), self.expression(b));
                quote!(#a.copysign(#b))
            }
            Op::Sin(angle) => {
                let pair = self.sin_cos(angle);
                quote!(#pair.0)
            }
            Op::Cos(angle) => {
                let pair = self.sin_cos(angle);
                quote!(#pair.1)
            }
            Op::Sqrt(a) => call(quote!(sqrt), &[a]),
            Op::Atan2(a, b) => call(quote!(atan2), &[a, b]),
            Op::Round(a) => call(quote!(round), &[a]),
            Op::Exp(a) => call(quote!(exp), &[a]),
            Op::Stairs(stairs, place, share) => {
                let (stairs, place) = (staircase(stairs), self.expression(place));
                let share = self.number(share.get());
                quote!(#stairs.at(#place, #share))
            }
            Op::Max(a, b) => call(quote!(max), &[a, b]),
            // These are always bound: they are parameters or variables.
            Op::Input(_)
            | Op::Turns(_)
            | Op::PartOfTurns(..)
            | Op::Unknown(..)
            | Op::Solved(..)
            | Op::Dense(..)
            | Op::Time
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Linear(..) => bug!("a value from outside is read before it has a name"),
        };
        (atom, Binding::Atom)
    }

    fn number(&self, value: f64) -> TokenStream {
        number(self.program.precision, value)
    }

    fn infix(
        &self,
        a: Value,
        sign: &TokenStream,
        b: Value,
        binding: Binding,
    ) -> (TokenStream, Binding) {
        // Floats do not associate: on the right side the same binding needs parentheses too.
        let tighter = if binding == Binding::Sum { Binding::Product } else { Binding::Sign };
        let (a, b) = (self.operand(a, binding), self.operand(b, tighter));
        (quote!(#a #sign #b), binding)
    }

    /// A value as an operand, in parentheses unless it binds at least as tightly as `wanted`.
    fn operand(&self, value: Value, wanted: Binding) -> TokenStream {
        let (tokens, binding) = self.name_or_operation(value);
        if binding < wanted { quote!((#tokens)) } else { tokens }
    }

    /// A number of the last position, by the variable of the link it belongs to if there is one.
    fn last(&self, slot: Slot) -> TokenStream {
        match slot {
            Slot::State(index) => {
                let index = integer(index);
                quote!(last.state[#index])
            }
            Slot::Pose(link, part) => {
                let part = match part {
                    Part::Cos => quote!(cos),
                    Part::Sin => quote!(sin),
                    Part::X => quote!(x),
                    Part::Y => quote!(y),
                };
                if let Some(pose) = self.last_poses.get(&link) {
                    quote!(#pose.#part)
                } else {
                    let link = integer(link);
                    quote!(last.poses[#link].#part)
                }
            }
        }
    }
}

/// A name, numbered if need be so that it is not taken.
fn free_name(
    wanted: &str,
    last: Option<usize>,
    is_taken: impl Fn(&str) -> bool,
) -> (String, usize) {
    let mut number = last.map_or(1, |last| last + 1);
    loop {
        let name = match number {
            1 => wanted.to_owned(),
            _ => format!("{wanted}_{number}"),
        };
        if !is_taken(&name) {
            return (name, number);
        }
        number += 1;
    }
}

/// A staircase, as it is made in generated code.
fn staircase(stairs: Staircase) -> TokenStream {
    let law = format_ident!("{}", format!("{:?}", stairs.law));
    let made = if stairs.repeats { quote!(endless) } else { quote!(single) };
    let order = Literal::u8_unsuffixed(stairs.order);
    quote!(Staircase::#made(MotionLaw::#law, #order))
}
