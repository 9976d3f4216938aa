//! Params: numbers that may be changed at run time, and what is computed from them.

use super::Lowering;
use crate::api::{self, Owner};
use crate::model::{Formula, FormulaId, Param};
use crate::syntax::Place;
use crate::syntax::ast::{Constant, Expr, ExprKind, Pair};
use proc_macro2::Ident;

/// A number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quantity {
    /// What it is at the start; none if that depends on the variable of a law.
    pub(super) value: Option<f64>,
    /// How it is computed, if it depends on a param or on the variable of a law.
    pub(super) formula: Option<FormulaId>,
}

impl Quantity {
    /// A number that never changes.
    pub(super) fn fixed(value: f64) -> Self {
        Self {
            value: Some(value),
            formula: None,
        }
    }
}

/// A pair of numbers, and how each is computed that depends on a param.
pub(super) type Spot = ([f64; 2], [Option<FormulaId>; 2]);

/// A length, and how it is computed if it depends on a param.
pub(super) type Length = (f64, Option<FormulaId>);

impl Lowering {
    pub(super) fn declare_param(&mut self, param: &Constant) {
        let is_new =
            self.scopes
                .here_mut()
                .constants
                .declare(&param.name, None, "param", &mut self.report);
        let claimed = is_new && self.claim(&param.name, "param") && self.claim_setters(&param.name);
        let value = match &param.value {
            Ok(expr) => self.value(expr),
            Err(error) => {
                self.report.pass_on(error.clone());
                None
            }
        };
        if let (true, Some(value)) = (claimed, value) {
            let origin = self.note(&param.name);
            let id = self.model.params.add(Param {
                name: self.key_of(&param.name),
                origin,
                value,
            });
            let formula = Some(self.model.params.formula(Formula::Param(id)));
            let value = Some(value);
            self.scopes
                .here_mut()
                .constants
                .assign(&param.name, Quantity { value, formula });
        }
    }

    /// Takes the method that sets a param and, with the first, those of all: whether it can have them.
    fn claim_setters(&mut self, name: &Ident) -> bool {
        let place = Place::at(name.span());
        if !std::mem::replace(&mut self.has_params, true) {
            let owner = Owner::Params;
            for method in api::names_of(owner) {
                if !self.claim_method(method.to_owned(), owner.to_string(), place) {
                    return false;
                }
            }
        }
        let owner = format!("changing param `{name}`");
        self.claim_method(
            format!("{}set_{name}", self.scopes.here().prefix),
            owner,
            place,
        )
    }

    /// The value of a number that may not depend on a param.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<f64> {
        let Quantity { value, formula } = self.quantity(expr)?;
        if formula.is_none() {
            return value;
        }
        self.refuse_param(expr);
        None
    }

    /// The values of a pair that may not depend on a param. Both are looked at, so that the errors of both are reported.
    pub(super) fn pair(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let (x, y) = (self.value(&pair.x), self.value(&pair.y));
        Some([x?, y?])
    }

    /// A place in a link, which may depend on params.
    pub(super) fn spot(&mut self, pair: &Pair) -> Option<Spot> {
        let (x, y) = (self.quantity(&pair.x), self.quantity(&pair.y));
        let (x, y) = (x?, y?);
        Some(([x.value?, y.value?], [x.formula, y.formula]))
    }

    /// Reads numbers that may not depend on params, for this reason.
    pub(super) fn with_fixed_numbers<T>(
        &mut self,
        why: &'static str,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = self.why_fixed.replace(why);
        let found = read(self);
        self.why_fixed = before;
        found
    }

    /// Complains about a number that would change with a param where none may.
    fn refuse_param(&mut self, expr: &Expr) {
        let Some(name) = self.first_dependent(expr) else {
            return;
        };
        let what = match self.constants().word_for(name) {
            "param" => format!("`{name}` is a param: it may change while the mechanism runs"),
            _ => {
                format!("`{name}` is computed from a param: it may change while the mechanism runs")
            }
        };
        let why = self.why_fixed.unwrap_or(
            "only laws, points, lines, joints in a drawing and shapes may depend on one",
        );
        let text = format!("{what}; {why}; use a `const` here");
        self.report.error(Place::at(name.span()), text);
    }

    /// The first name in an expression that stands for something that depends on a param.
    fn first_dependent<'e>(&self, expr: &'e Expr) -> Option<&'e Ident> {
        match &expr.kind {
            ExprKind::Constant(name) => self.constants().depends(name).then_some(name),
            ExprKind::Negative(inner) | ExprKind::Degrees(inner) | ExprKind::Call(_, inner) => {
                self.first_dependent(inner)
            }
            ExprKind::Sum(parts) | ExprKind::Product(parts) => parts
                .iter()
                .find_map(|(_, part)| self.first_dependent(part)),
            ExprKind::CallBoth(_, parts) => {
                parts.iter().find_map(|part| self.first_dependent(part))
            }
            ExprKind::Integer(_) | ExprKind::Decimal(_) | ExprKind::Pi => None,
        }
    }
}
