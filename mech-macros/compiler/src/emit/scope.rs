//! The names in a generated function, and expressions that use them.

use super::module;
use crate::bug::bug;
use crate::model::Precision;
use crate::program::{BlockId, Op, Part, Program, Slot, Value};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;
use std::collections::{BTreeMap, BTreeSet};

/// An identifier of the generated code that the user's code cannot see.
pub(super) fn ident(name: &str) -> Ident {
    // Names come from the user's own identifiers, so they are identifiers too; a keyword becomes one by an underscore.
    let parsed =
        syn::parse_str::<Ident>(name).or_else(|_| syn::parse_str::<Ident>(&format!("{name}_")));
    let mut ident = parsed.unwrap_or_else(|_| bug!("`{name}` is to be a name"));
    ident.set_span(Span::mixed_site());
    ident
}

/// A literal of this precision, in the shortest form that gives the very number.
pub(super) fn number(precision: Precision, value: f64) -> TokenStream {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "rounding is what is asked for"
    )]
    let text = match precision {
        Precision::F32 => format!("{:?}", (value as f32).abs()),
        Precision::F64 => format!("{:?}", value.abs()),
    };
    let literal = text
        .parse::<Literal>()
        .unwrap_or_else(|_| bug!("{value} is to be a constant"));
    if value < 0.0 {
        quote!(-#literal)
    } else {
        quote!(#literal)
    }
}

/// How tightly an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The names and uses of values in one function.
pub(super) struct Scope<'p> {
    program: &'p Program,
    names: BTreeMap<Value, Ident>,
    /// The variables that hold the last poses of links, by their numbers.
    last_poses: BTreeMap<usize, Ident>,
    taken: BTreeSet<String>,
    /// How often each value is used by what this function makes.
    uses: BTreeMap<Value, usize>,
    /// Where sines and cosines are taken from.
    sines: TokenStream,
}

impl<'p> Scope<'p> {
    pub(super) fn new(program: &'p Program, uses: BTreeMap<Value, usize>) -> Self {
        Self {
            program,
            names: BTreeMap::new(),
            last_poses: BTreeMap::new(),
            taken: module::taken().collect(),
            uses,
            sines: quote!(sin_cos),
        }
    }

    /// A name that nothing else in this function has.
    pub(super) fn fresh(&mut self, wanted: &str) -> Ident {
        let mut name = wanted.to_owned();
        let mut number = 1;
        while !self.taken.insert(name.clone()) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        ident(&name)
    }

    /// A name for another function, which no variable of this one has.
    pub(super) fn fresh_function(&mut self, names: &mut FunctionNames, wanted: &str) -> Ident {
        let mut name = wanted.to_owned();
        let mut number = 1;
        while self.taken.contains(&name) || names.has(&name) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        self.taken.insert(name.clone());
        names.take(name.clone());
        ident(&name)
    }

    /// The variable that holds the last pose of a link.
    pub(super) fn last_pose(&mut self, link: usize) -> Ident {
        if let Some(known) = self.last_poses.get(&link) {
            return known.clone();
        }
        let name = &self.program.links[link];
        let name = self.fresh(&format!("last_{name}"));
        self.last_poses.insert(link, name.clone());
        name
    }

    /// Gives a value a name in this function.
    pub(super) fn bind(&mut self, value: Value) -> Ident {
        if let Some(known) = self.names.get(&value) {
            return known.clone();
        }
        let wanted = self.program.node(value).name.as_deref().unwrap_or("part");
        let name = self.fresh(wanted);
        self.names.insert(value, name.clone());
        name
    }

    /// Lets a value go by the name of another thing.
    pub(super) fn alias(&mut self, value: Value, name: Ident) {
        self.names.insert(value, name);
    }

    pub(super) fn is_bound(&self, value: Value) -> bool {
        self.names.contains_key(&value)
    }

    /// Whether a value deserves a `let` of its own: it means something, or it is used more than once.
    pub(super) fn deserves_name(&self, value: Value) -> bool {
        let node = self.program.node(value);
        let leaf = matches!(node.op, Op::Constant(_) | Op::Last(_));
        !leaf && (node.name.is_some() || self.uses.get(&value).copied().unwrap_or(0) > 1)
    }

    /// A value as an expression: its name if it has one here, else what makes it.
    pub(super) fn expression(&self, value: Value) -> TokenStream {
        self.bound(value).0
    }

    /// A value with the other sign.
    pub(super) fn negated(&self, value: Value) -> TokenStream {
        let value = self.at_least(value, Binding::Sign);
        quote!(-#value)
    }

    /// What makes a value, even if it has a name.
    pub(super) fn definition(&self, value: Value) -> TokenStream {
        self.made(value).0
    }

    fn bound(&self, value: Value) -> (TokenStream, Binding) {
        match self.names.get(&value) {
            Some(name) => (quote!(#name), Binding::Atom),
            None => self.made(value),
        }
    }

    fn made(&self, value: Value) -> (TokenStream, Binding) {
        match self.program.node(value).op {
            Op::Constant(constant) => {
                let tokens = number(self.program.precision, constant.get());
                (
                    tokens,
                    if constant.get() < 0.0 {
                        Binding::Sign
                    } else {
                        Binding::Atom
                    },
                )
            }
            Op::Last(slot) => (self.last(slot), Binding::Atom),
            Op::Neg(a) => (self.negated(a), Binding::Sign),
            Op::Abs(a) => {
                let a = self.at_least(a, Binding::Atom);
                (quote!(#a.abs()), Binding::Atom)
            }
            Op::Add(a, b) => self.infix(a, &quote!(+), b, Binding::Sum),
            Op::Sub(a, b) => self.infix(a, &quote!(-), b, Binding::Sum),
            Op::Mul(a, b) => self.infix(a, &quote!(*), b, Binding::Product),
            Op::Div(a, b) => self.infix(a, &quote!(/), b, Binding::Product),
            Op::Sin(a) => self.sine(a, 0),
            Op::Cos(a) => self.sine(a, 1),
            Op::Sqrt(a) => self.call(&quote!(sqrt), &[a]),
            Op::Atan2(a, b) => self.call(&quote!(atan2), &[a, b]),
            Op::Round(a) => self.call(&quote!(round), &[a]),
            Op::Exp(a) => self.call(&quote!(exp), &[a]),
            Op::Choose(test, a, b) => {
                let [test, a, b] = [test, a, b].map(|value| self.expression(value));
                (quote!(if #test >= 0.0 { #a } else { #b }), Binding::Sum)
            }
            Op::Max(a, b) => self.call(&quote!(max), &[a, b]),
            Op::CopySign(a, b) => self.method(a, &quote!(copysign), b),
            // These are always bound: they are parameters or variables.
            Op::Motor(_)
            | Op::Turns(_)
            | Op::Turned(..)
            | Op::Unknown(..)
            | Op::Solved(..)
            | Op::Dense(..)
            | Op::Time
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Linear(..) => bug!("a value from outside is read before it has a name"),
        }
    }

    fn infix(
        &self,
        a: Value,
        sign: &TokenStream,
        b: Value,
        binding: Binding,
    ) -> (TokenStream, Binding) {
        // Floats do not associate: on the right side the same binding needs parentheses too.
        let tighter = if binding == Binding::Sum {
            Binding::Product
        } else {
            Binding::Sign
        };
        let (a, b) = (self.at_least(a, binding), self.at_least(b, tighter));
        (quote!(#a #sign #b), binding)
    }

    fn call(&self, function: &TokenStream, arguments: &[Value]) -> (TokenStream, Binding) {
        let arguments = arguments.iter().map(|&argument| self.expression(argument));
        (quote!(#function(#(#arguments),*)), Binding::Atom)
    }

    /// Where sines and cosines are taken from in this function.
    pub(super) fn sines(&self) -> &TokenStream {
        &self.sines
    }

    /// From here on sines and cosines are taken from there.
    pub(super) fn take_sines_from(&mut self, sines: TokenStream) {
        self.sines = sines;
    }

    fn sine(&self, angle: Value, part: usize) -> (TokenStream, Binding) {
        let (sines, angle) = (&self.sines, self.expression(angle));
        let part = Literal::usize_unsuffixed(part);
        (quote!(#sines(#angle).#part), Binding::Atom)
    }

    fn method(&self, of: Value, name: &TokenStream, argument: Value) -> (TokenStream, Binding) {
        let (of, argument) = (self.at_least(of, Binding::Atom), self.expression(argument));
        (quote!(#of.#name(#argument)), Binding::Atom)
    }

    fn at_least(&self, value: Value, wanted: Binding) -> TokenStream {
        let (tokens, binding) = self.bound(value);
        if binding < wanted {
            quote!((#tokens))
        } else {
            tokens
        }
    }

    /// A number of the last position, by the name of the link it belongs to.
    fn last(&self, slot: Slot) -> TokenStream {
        match slot {
            Slot::State(index) => {
                let index = Literal::usize_unsuffixed(index);
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
                    let link = Literal::usize_unsuffixed(link);
                    quote!(last.poses[#link].#part)
                }
            }
        }
    }
}

/// How often each value is used to make these, directly, and how often beyond: in other blocks or in the result.
pub(super) fn uses(program: &Program, block: BlockId) -> BTreeMap<Value, usize> {
    let mut uses = BTreeMap::new();
    let mut count = |value: Value| *uses.entry(value).or_insert(0) += 1;
    for value in program
        .live_values()
        .filter(|&value| program.node(value).block == block)
    {
        program.node(value).op.operands().for_each(&mut count);
    }
    for system in program.live_systems() {
        if system.block == block {
            let needed = system.columns.iter().flatten().chain(&system.right);
            needed.copied().for_each(&mut count);
        }
    }
    if let Some(newton) = program.newton(block) {
        // The gap and the determinant leave the iteration; what follows a round is read once.
        newton
            .gap
            .iter()
            .copied()
            .chain([newton.det])
            .chain(newton.extent)
            .chain(
                newton
                    .columns
                    .iter()
                    .flatten()
                    .filter(|_| newton.dense)
                    .copied(),
            )
            .for_each(&mut count);
        newton
            .scalars
            .iter()
            .flat_map(|scalar| [scalar.first, scalar.next])
            .for_each(&mut count);
    }
    uses
}

/// Names of the functions of a module, each given once.
#[derive(Default)]
pub(super) struct FunctionNames(BTreeSet<String>);

impl FunctionNames {
    fn has(&self, name: &str) -> bool {
        self.0.contains(name)
    }

    fn take(&mut self, name: String) {
        self.0.insert(name);
    }
}
