//! Measurands: numbers that are made from quantities, one for each column of a table.

use super::formula::Slopes;
use super::{FormulaId, Formulas, Measured, Now, Quantity};

/// A number that is made from what is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurand {
    /// Its name: `coupler.tip.x`.
    pub name: String,
    formulas: Formulas,
    measured: Vec<Measured>,
    subject: FormulaId,
}

impl Measurand {
    /// One of these formulas, whose variables are measured.
    pub(crate) fn new(
        name: String,
        formulas: Formulas,
        measured: Vec<Measured>,
        subject: FormulaId,
    ) -> Self {
        Self { name, formulas, measured, subject }
    }

    /// A quantity alone.
    #[must_use]
    pub fn of(name: String, quantity: Quantity) -> Self {
        let mut formulas = Formulas::default();
        let subject = formulas.add(super::Formula::Variable(0));
        Self::new(name, formulas, vec![Measured::Quantity(quantity)], subject)
    }

    /// Its formulas.
    #[must_use]
    pub fn formulas(&self) -> &Formulas {
        &self.formulas
    }

    /// The meanings of the variables of its formulas, by their numbers.
    #[must_use]
    pub fn measured(&self) -> &[Measured] {
        &self.measured
    }

    /// The formula of the number itself.
    #[must_use]
    pub fn subject(&self) -> FormulaId {
        self.subject
    }

    /// The meanings of its own variables: without those of which rates are taken.
    pub fn own(&self) -> impl Iterator<Item = &Measured> {
        let numbers = self.formulas.variables(self.subject).into_iter();
        numbers.map(|number| &self.measured[number])
    }

    /// The quantity, if it is one and nothing else.
    #[must_use]
    pub fn quantity(&self) -> Option<Quantity> {
        match (self.formulas.all()[self.subject.index()], &self.measured[..]) {
            (super::Formula::Variable(0), [only]) => only.quantity(),
            _ => None,
        }
    }

    /// Its value, where its variables have these: not finite where it has none.
    #[must_use]
    pub fn value(&self, variables: &[f64]) -> f64 {
        let mut now = Now { variables, params: &[] };
        self.formulas.evaluate_one(self.subject, &mut now)
    }

    /// The slope of a formula, where the variables have these values and slopes.
    #[must_use]
    pub fn slope(&self, of: FormulaId, variables: &[(f64, f64)]) -> f64 {
        let mut slopes = Slopes { variables, params: &[], by: None };
        self.formulas.evaluate_one(of, &mut slopes).1
    }
}
