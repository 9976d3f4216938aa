//! Numbers that are computed: from constants, from params, and from the variable of a law.

use super::{BinaryFunction, FormulaId, Function, ParamId};
use mech_core::Staircase;
use std::collections::HashMap;
use std::fmt;

/// The operation that computes a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Formula {
    /// A number that never changes.
    Constant(Number),
    /// A variable, by its number: a law has one, a requirement as many as it measures quantities.
    Variable(usize),
    /// The value of a param.
    Param(ParamId),
    /// −a.
    Neg(FormulaId),
    /// a + b.
    Add(FormulaId, FormulaId),
    /// a − b.
    Sub(FormulaId, FormulaId),
    /// a · b.
    Mul(FormulaId, FormulaId),
    /// a / b.
    Div(FormulaId, FormulaId),
    /// A function of a.
    Of(Function, FormulaId),
    /// A function of a and b.
    OfBoth(BinaryFunction, FormulaId, FormulaId),
    /// The height of a staircase at a place, of which each step takes this share.
    Stairs(Staircase, FormulaId, Number),
}

impl Formula {
    /// A number that never changes: finite.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self::Constant(Number::new(value))
    }

    /// Returns its operands.
    fn operands(self) -> impl Iterator<Item = FormulaId> {
        let pair = match self {
            Self::Constant(_) | Self::Variable(_) | Self::Param(_) => [None, None],
            Self::Neg(a) | Self::Of(_, a) | Self::Stairs(_, a, _) => [Some(a), None],
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::OfBoth(_, a, b) => [Some(a), Some(b)],
        };
        pair.into_iter().flatten()
    }

    /// The value of a formula, from the values of the formulas that it refers to.
    fn apply<A: FormulaArithmetic>(
        self,
        arithmetic: &mut A,
        get: impl Fn(FormulaId) -> A::Scalar,
    ) -> A::Scalar {
        match self {
            Self::Constant(value) => arithmetic.constant(value.get()),
            Self::Variable(number) => arithmetic.variable(number),
            Self::Param(param) => arithmetic.param(param),
            Self::Neg(a) => arithmetic.neg(get(a)),
            Self::Add(a, b) => arithmetic.add(get(a), get(b)),
            Self::Sub(a, b) => arithmetic.sub(get(a), get(b)),
            Self::Mul(a, b) => arithmetic.mul(get(a), get(b)),
            Self::Div(a, b) => arithmetic.div(get(a), get(b)),
            Self::Of(function, a) => arithmetic.of(function, get(a)),
            Self::OfBoth(function, a, b) => arithmetic.of_both(function, get(a), get(b)),
            Self::Stairs(stairs, place, share) => arithmetic.stairs(stairs, get(place), share),
        }
    }
}

/// Formulas, each after those that it is made from. Equal ones are one.
#[derive(Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Formulas {
    all: Vec<Formula>,
    /// Only looked up, never iterated: the order of a hash map differs from run to run.
    known: HashMap<Formula, FormulaId>,
}

/// Equal ones are shown equally.
impl fmt::Debug for Formulas {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.debug_list().entries(&self.all).finish()
    }
}

/// Arithmetic over numbers, numbers with slopes, the values of a program, or formulas.
pub trait Arithmetic {
    /// A number.
    type Scalar: Clone;

    /// A constant.
    fn constant(&mut self, value: f64) -> Self::Scalar;
    /// −a.
    fn neg(&mut self, a: Self::Scalar) -> Self::Scalar;
    /// a + b.
    fn add(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a − b.
    fn sub(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a · b.
    fn mul(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a / b.
    fn div(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
}

/// An arithmetic that formulas are evaluated in.
pub trait FormulaArithmetic: Arithmetic {
    /// The variable of this number.
    fn variable(&mut self, number: usize) -> Self::Scalar;
    /// The value of a param.
    fn param(&mut self, param: ParamId) -> Self::Scalar;
    /// A function of a.
    fn of(&mut self, function: Function, a: Self::Scalar) -> Self::Scalar;
    /// A function of a and b.
    fn of_both(
        &mut self,
        function: BinaryFunction,
        a: Self::Scalar,
        b: Self::Scalar,
    ) -> Self::Scalar;
    /// The height of a staircase at a place.
    fn stairs(&mut self, stairs: Staircase, place: Self::Scalar, share: Number) -> Self::Scalar;
}

impl Formulas {
    /// Adds a formula, unless it is known.
    pub fn add(&mut self, formula: Formula) -> FormulaId {
        *self.known.entry(formula).or_insert_with(|| {
            self.all.push(formula);
            FormulaId::new(self.all.len() - 1)
        })
    }

    /// All of them, each after those that it is made from.
    #[must_use]
    pub fn all(&self) -> &[Formula] {
        &self.all
    }

    /// All of them, each evaluated once, by their numbers.
    pub fn evaluate<A: FormulaArithmetic>(&self, arithmetic: &mut A) -> Vec<A::Scalar> {
        let mut values: Vec<A::Scalar> = Vec::with_capacity(self.all.len());
        for formula in &self.all {
            let value = formula.apply(arithmetic, |id| values[id.index()].clone());
            values.push(value);
        }
        values
    }

    /// The numbers of the variables that a formula is made from.
    #[must_use]
    pub fn variables(&self, id: FormulaId) -> Vec<usize> {
        let needed = self.needed(id).into_iter().enumerate();
        let needed = needed.filter(|(_, needed)| *needed);
        let variables = needed.filter_map(|(index, _)| match self.all[index] {
            Formula::Variable(number) => Some(number),
            _ => None,
        });
        variables.collect()
    }

    /// Which formulas one is made from, by their numbers.
    fn needed(&self, id: FormulaId) -> Vec<bool> {
        let mut needed = vec![false; id.index() + 1];
        let mut waiting = vec![id];
        while let Some(next) = waiting.pop() {
            if !std::mem::replace(&mut needed[next.index()], true) {
                waiting.extend(self.all[next.index()].operands());
            }
        }
        needed
    }

    /// The value of one formula: only the formulas that it is made from are evaluated.
    pub fn evaluate_one<A: FormulaArithmetic>(
        &self,
        id: FormulaId,
        arithmetic: &mut A,
    ) -> A::Scalar {
        let needed = self.needed(id);
        let mut values: HashMap<FormulaId, A::Scalar> = HashMap::new();
        for (index, _) in needed.iter().enumerate().filter(|(_, needed)| **needed) {
            let value = self.all[index].apply(arithmetic, |id| values[&id].clone());
            values.insert(FormulaId::new(index), value);
        }
        values[&id].clone()
    }
}

/// Formulas are an arithmetic themselves: so those of one collection are copied into another.
impl Arithmetic for Formulas {
    type Scalar = FormulaId;

    fn constant(&mut self, value: f64) -> FormulaId {
        Self::add(self, Formula::constant(value))
    }

    fn neg(&mut self, a: FormulaId) -> FormulaId {
        Self::add(self, Formula::Neg(a))
    }

    fn add(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        Self::add(self, Formula::Add(a, b))
    }

    fn sub(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        Self::add(self, Formula::Sub(a, b))
    }

    fn mul(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        Self::add(self, Formula::Mul(a, b))
    }

    fn div(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        Self::add(self, Formula::Div(a, b))
    }
}

impl FormulaArithmetic for Formulas {
    fn variable(&mut self, number: usize) -> FormulaId {
        Self::add(self, Formula::Variable(number))
    }

    fn param(&mut self, param: ParamId) -> FormulaId {
        Self::add(self, Formula::Param(param))
    }

    fn of(&mut self, function: Function, a: FormulaId) -> FormulaId {
        Self::add(self, Formula::Of(function, a))
    }

    fn of_both(&mut self, function: BinaryFunction, a: FormulaId, b: FormulaId) -> FormulaId {
        Self::add(self, Formula::OfBoth(function, a, b))
    }

    fn stairs(&mut self, stairs: Staircase, place: FormulaId, share: Number) -> FormulaId {
        Self::add(self, Formula::Stairs(stairs, place, share))
    }
}

/// Numbers now.
#[derive(Clone, Copy, Debug)]
pub struct Now<'p> {
    /// The values of the variables, by their numbers.
    pub variables: &'p [f64],
    /// The values of all params.
    pub params: &'p [f64],
}

impl Arithmetic for Now<'_> {
    type Scalar = f64;

    fn constant(&mut self, value: f64) -> f64 {
        value
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn sub(&mut self, a: f64, b: f64) -> f64 {
        a - b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
}

impl FormulaArithmetic for Now<'_> {
    fn variable(&mut self, number: usize) -> f64 {
        self.variables[number]
    }

    fn param(&mut self, param: ParamId) -> f64 {
        self.params[param.index()]
    }

    fn of(&mut self, function: Function, a: f64) -> f64 {
        function.at(a)
    }

    fn of_both(&mut self, function: BinaryFunction, a: f64, b: f64) -> f64 {
        function.at(a, b)
    }

    fn stairs(&mut self, stairs: Staircase, place: f64, share: Number) -> f64 {
        stairs.at(place, share.get())
    }
}

/// Numbers with their slopes: by how much each grows with one of those that they are made from.
pub(super) struct Slopes<'p> {
    /// The values of the variables, by their numbers, each with its slope.
    pub(super) variables: &'p [(f64, f64)],
    /// The values of all params.
    pub(super) params: &'p [f64],
    /// The param whose slope is one, if it is a param by which slopes are taken.
    pub(super) by: Option<ParamId>,
}

impl Slopes<'_> {
    /// A slope along something: none along what rests.
    fn along(slope: f64, rate: f64) -> f64 {
        if rate == 0.0 { 0.0 } else { slope * rate }
    }
}

impl Arithmetic for Slopes<'_> {
    type Scalar = (f64, f64);

    fn constant(&mut self, value: f64) -> (f64, f64) {
        (value, 0.0)
    }

    fn neg(&mut self, (a, da): (f64, f64)) -> (f64, f64) {
        (-a, -da)
    }

    fn add(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a + b, da + db)
    }

    fn sub(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a - b, da - db)
    }

    fn mul(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a * b, da * b + a * db)
    }

    fn div(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a / b, (da - a / b * db) / b)
    }
}

impl FormulaArithmetic for Slopes<'_> {
    fn variable(&mut self, number: usize) -> (f64, f64) {
        self.variables[number]
    }

    fn param(&mut self, param: ParamId) -> (f64, f64) {
        let value = self.params[param.index()];
        (value, if self.by == Some(param) { 1.0 } else { 0.0 })
    }

    fn of(&mut self, function: Function, (a, da): (f64, f64)) -> (f64, f64) {
        (function.at(a), Self::along(function.slope_at(a), da))
    }

    fn of_both(
        &mut self,
        function: BinaryFunction,
        (a, da): (f64, f64),
        (b, db): (f64, f64),
    ) -> (f64, f64) {
        let [by_a, by_b] = function.slopes_at(a, b);
        (function.at(a, b), Self::along(by_a, da) + Self::along(by_b, db))
    }

    fn stairs(&mut self, stairs: Staircase, (a, da): (f64, f64), share: Number) -> (f64, f64) {
        let share = share.get();
        let slope = stairs.slope().at(a, share) / share;
        (stairs.at(a, share), Self::along(slope, da))
    }
}

/// A finite number with an equality that tells every two bit patterns apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Number(u64);

impl Number {
    /// This number. The two zeros are one.
    #[must_use]
    pub fn new(value: f64) -> Self {
        Self(if value == 0.0 { 0 } else { value.to_bits() })
    }

    /// Its value.
    #[must_use]
    pub fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}
