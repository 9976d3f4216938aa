//! Laws: expressions with a variable.

use super::Lowering;
use super::param::Quantity;
use super::report::StatementPlace;
use super::value::format_number;
use crate::bug::bug;
use crate::model::{Formula, Formulas, JointId, Law, LawId, StartValue};
use crate::syntax::Place;
use crate::syntax::ast::Expr;
use proc_macro2::Ident;

/// The time, in laws of motors.
pub(super) const TIME: &str = "t";

/// The coordinate of the shaft, in laws of cams.
pub(super) const COORDINATE: &str = "q";

/// More numbers and operations than this make no law that anybody could read.
const MOST_FORMULAS: usize = 1000;

/// The greatest relative difference between a start and what its law gives: the two are computed differently.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Lowering {
    /// An expression as a function of this variable.
    pub(super) fn law(&mut self, expr: &Expr, variable: &'static str) -> Option<LawId> {
        self.scaled_law(expr, variable, [Quantity::fixed(1.0); 2])
    }

    /// An expression as a function of this variable, where the part that declares it is scaled or mirrored: by these factors the variable
    /// and the result follow from those of the part.
    pub(super) fn scaled_law(
        &mut self,
        expr: &Expr,
        variable: &'static str,
        [input, output]: [Quantity; 2],
    ) -> Option<LawId> {
        let origin = self.places.note(expr.place);
        self.scopes
            .here_mut()
            .constants
            .set_variable(Some(variable));
        self.law = Some(Formulas::default());
        self.law_input = input;
        let quantity = self.quantity(expr);
        let quantity = quantity.map(|quantity| {
            let output = self.in_this_law(output);
            self.product(quantity, output)
        });
        let formulas = self.law.take();
        self.scopes.here_mut().constants.set_variable(None);
        let (quantity, mut formulas) = (quantity?, formulas?);
        let constant = || quantity.value.map(Formula::constant);
        let value = quantity
            .formula
            .or_else(|| constant().map(|constant| formulas.add(constant)))?;
        if formulas.all().len() > MOST_FORMULAS {
            let text = format!(
                "a law has {MOST_FORMULAS} numbers and operations at most; this one has more"
            );
            self.report.error(expr.place, text);
            return None;
        }
        let law = Law::new(formulas, value, expr.to_string(), origin);
        self.model.laws.push(law);
        Some(LawId::new(self.model.laws.len() - 1))
    }

    /// Where formulas are added: to the law that is read, or to those of the model.
    pub(super) fn formulas(&mut self) -> &mut Formulas {
        match &mut self.law {
            Some(law) => law,
            None => self.model.params.formulas_mut(),
        }
    }

    /// A number of the model; in a law, with a formula of the law.
    pub(super) fn in_this_law(&mut self, known: Quantity) -> Quantity {
        match (known.formula, &mut self.law) {
            (Some(formula), Some(law)) => Quantity {
                formula: Some(self.model.params.evaluate_one(formula, law)),
                ..known
            },
            _ => known,
        }
    }

    /// The variable of the law that is read.
    pub(super) fn variable(&mut self, name: &Ident, place: Place) -> Option<Quantity> {
        if self.constants().has(&name.to_string()) {
            let text = format!(
                "`{name}` is the variable of this law, and a constant too; give the constant another name"
            );
            self.report.error(place, text);
            return None;
        }
        let variable = Quantity {
            value: None,
            formula: Some(self.formulas().add(Formula::Variable)),
        };
        let input = self.in_this_law(self.law_input);
        Some(self.quotient(variable, input))
    }

    /// Lets every motor with a law start where that has it when the time is zero.
    pub(super) fn start_by_laws(&mut self) {
        for motor in self.model.motors.clone() {
            let Some(law) = motor.law.map(|law| self.model.law(law)) else {
                continue;
            };
            let (value, origin, written) = (
                self.model.at_start(law, 0.0),
                law.origin,
                law.written.clone(),
            );
            let joint = motor.joint;
            let name = self.model.joint(joint).name.clone();
            let place = self.places.get(origin);
            let statement = StatementPlace::of_mechanism(self.statement_of(joint));
            self.report.enter(statement, None);
            if !value.is_finite() {
                let text = format!(
                    "motor `{name}` starts where its law has it at time 0, but `{written}` has no value there; \
                     change it so that it has one"
                );
                self.report.error(place, text);
                continue;
            }
            let mut listed = self.model.start.values.iter();
            if let Some(listed) = listed.find(|listed| listed.joint == joint).copied() {
                self.check_start_by_law(&name, value, listed);
            } else if self.is_drawn(joint) && value.abs() > ROUNDING {
                let text = format!(
                    "joint `{name}` is placed in the drawing, where its coordinate is 0, but its law starts at {}\n\n\
                     help: make the law 0 when `t` is 0, or draw its links as they are to start",
                    format_number(value)
                );
                self.report.error(place, text);
            } else {
                self.check_law_in_range(&name, joint, value);
                // Of what is drawn, rounding has been let pass.
                let value = if self.is_drawn(joint) { 0.0 } else { value };
                self.model.start.values.push(StartValue {
                    joint,
                    value,
                    origin,
                });
            }
        }
    }

    /// A start that was given must be that of the law.
    fn check_start_by_law(&mut self, name: &str, value: f64, listed: StartValue) {
        let scale = value.abs().max(listed.value.abs()).max(1.0);
        if (value - listed.value).abs() <= ROUNDING * scale {
            return;
        }
        let text = format!(
            "motor `{name}` starts at {} by its law, not at {}; leave this out, or change one of the two",
            format_number(value),
            format_number(listed.value)
        );
        self.report.error(self.places.get(listed.origin), text);
    }

    fn statement_of(&self, joint: JointId) -> usize {
        let mut lawful = self.lawful.iter();
        lawful.find(|(id, _)| *id == joint).map_or_else(
            || bug!("a law was given in no statement"),
            |(_, statement)| *statement,
        )
    }
}
