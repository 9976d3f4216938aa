//! Reading at a place of the text: what names and numbers mean there.

use super::constant::{Constants, Passing};
use super::name::Names;
use super::quantity::{Quantity, Spot};
use super::report::{Report, StatementPlace};
use super::scope::Scope;
use super::similarity::Similarity;
use super::unknown::Unknown;
use crate::model::{Formulas, Measured, Params};
use crate::syntax::ast::{MeasuredExpr, Statement};
use crate::syntax::{Noun, Place};
use proc_macro2::Ident;

/// A statement in one of the scopes in which it is read.
pub(super) struct Located<'t> {
    pub(super) scope: usize,
    pub(super) place: StatementPlace,
    pub(super) statement: &'t Statement,
    /// Whether what it declares has its name.
    pub(super) is_named: bool,
}

/// The meaning of names and numbers at a place of the text.
pub(super) struct Reader<'r> {
    pub(super) names: &'r Names,
    /// The scope in which the text stands.
    pub(super) scope: usize,
    /// The names that count as constants here.
    pub(super) passing: Passing,
    /// Which instances `[*]` stands for, from the outermost inwards.
    pub(super) every: &'r [usize],
    /// The similarity of lengths and angles.
    pub(super) frame: Similarity,
    /// Why numbers may not depend on params, if there is a reason of their own.
    pub(super) why_fixed: Option<&'static str>,
    /// The law or requirement that is read.
    pub(super) law: Option<LawReading>,
    /// What measures, if a requirement is read.
    pub(super) measuring: Option<&'r dyn Measuring>,
    pub(super) params: &'r mut Params,
    pub(super) report: &'r mut Report,
}

/// A law, as far as it is read.
pub(super) struct LawReading {
    /// By what its variable is divided, where a part is scaled or mirrored.
    pub(super) input: Quantity,
    /// Its formulas.
    pub(super) formulas: Formulas,
    /// What its variables stand for, if it is a requirement.
    pub(super) measured: Vec<Measured>,
    /// What its variable and its value are, if that is known.
    pub(super) nature: Option<Nature>,
}

impl LawReading {
    /// A requirement or a measurand, of which nothing is read yet.
    pub(super) fn of_measured() -> Self {
        Self {
            input: Quantity::fixed(1.0),
            formulas: Formulas::default(),
            measured: Vec::new(),
            nature: None,
        }
    }
}

/// What the variable and the value of a law are.
#[derive(Clone, Copy)]
pub(super) struct Nature {
    /// What it is a function of.
    pub(super) of: Argument,
    /// Whether it gives an angle; else a length.
    pub(super) is_angle: bool,
}

/// What a law is a function of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Argument {
    /// The time.
    Time,
    /// The angle of a shaft.
    Angle,
    /// The way of a slide.
    Length,
}

/// What measures a mechanism.
pub(super) trait Measuring {
    /// A number that is measured, or a constant.
    fn measure(&self, reader: &mut Reader, expr: &MeasuredExpr, place: Place) -> Option<Quantity>;
}

impl<'r> Reader<'r> {
    /// Reading in a scope.
    pub(super) fn new(
        names: &'r Names,
        scope: usize,
        params: &'r mut Params,
        report: &'r mut Report,
    ) -> Self {
        Self {
            names,
            scope,
            passing: Passing::default(),
            every: &[],
            frame: names.scope(scope).similarity,
            why_fixed: None,
            law: None,
            measuring: None,
            params,
            report,
        }
    }

    /// Reading a statement, which messages are about from now on.
    pub(super) fn of(
        located: &Located,
        names: &'r Names,
        params: &'r mut Params,
        report: &'r mut Report,
    ) -> Self {
        report.enter(located.place, names.scope(located.scope).instance());
        Self::new(names, located.scope, params, report)
    }

    /// The same outside of laws, changed for a while.
    pub(super) fn again(&mut self) -> Reader<'_> {
        Reader { params: self.params, report: self.report, law: None, measuring: None, ..*self }
    }

    /// Reading numbers that may not depend on params, for this reason.
    pub(super) fn fixed(&mut self, why: &'static str) -> Reader<'_> {
        Reader { why_fixed: Some(why), ..self.again() }
    }

    /// The scope in which the text stands.
    pub(super) fn here(&self) -> &'r Scope {
        self.names.scope(self.scope)
    }

    /// The numbers of the mechanism or the instance that is read.
    pub(super) fn constants(&self) -> &'r Constants {
        &self.here().constants
    }

    /// A number of this name that is unknown here.
    pub(super) fn unknown_number(&self, name: &Ident) -> Unknown {
        Unknown::new(Noun::Number, self.here().part.clone(), name)
    }

    /// The name of something that is declared here, with the path to it.
    pub(super) fn key_of(&self, name: &Ident) -> String {
        self.here().key_of(name)
    }

    /// Where formulas are added: to the law that is read, or to those of the model.
    pub(super) fn formulas(&mut self) -> &mut Formulas {
        match &mut self.law {
            Some(law) => &mut law.formulas,
            None => self.params.formulas_mut(),
        }
    }

    /// A number of the model; in a law, with a formula of the law.
    pub(super) fn in_this_law(&mut self, known: Quantity) -> Quantity {
        match (known.formula, &mut self.law) {
            (Some(formula), Some(law)) => Quantity {
                formula: Some(self.params.evaluate_one(formula, &mut law.formulas)),
                ..known
            },
            _ => known,
        }
    }

    /// A place after a similarity. The place in the text is what is wrong if that is too far away.
    pub(super) fn transform(&mut self, spot: Spot, by: Similarity, place: Place) -> Option<Spot> {
        let moved = by.place(spot, self.formulas());
        self.near(moved, place)
    }

    /// A place, unless it is too far away.
    pub(super) fn near(&mut self, spot: Spot, place: Place) -> Option<Spot> {
        for number in spot.0 {
            self.report.finite(number, place)?;
        }
        Some(spot)
    }

    /// First the inner similarity, then the outer.
    pub(super) fn compose(
        &mut self,
        outer: &Similarity,
        inner: &Similarity,
        place: Place,
    ) -> Option<Similarity> {
        let both = outer.after(inner, self.formulas());
        self.near(both.offset, place)?;
        Some(both)
    }
}
