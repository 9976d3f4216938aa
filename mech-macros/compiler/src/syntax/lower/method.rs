//! How the loops are solved.

use super::Lowering;
use crate::model::{AtChangePoints, Method, Target};
use crate::syntax::ast::{self, Expr};
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const METHODS: [&str; 3] = ["exact", "newton", "linear"];
const MACHINES: [&str; 2] = ["x86_64", "cortex_m4f"];

/// More Newton steps than this are a mistake: the error is squared by each.
const MOST_STEPS: i32 = 64;

/// Higher orders follow rounding rather than the motion.
const MOST_ORDER: i32 = 3;

const ONE_TOO_MANY: &str = "remove one of the two";

impl Lowering {
    pub(super) fn lower_method(&mut self, method: &ast::Method) {
        self.check_choice(method.keyword, "method", "accuracy");
        let text = method.word.to_string();
        let chosen = match text.as_str() {
            "newton" => self.newton(method.steps.as_ref()),
            "linear" => self.without_steps(method, Method::Linear),
            "exact" => self.without_steps(method, Method::Exact),
            _ => {
                let remedy = spelling::remedy(&text, &METHODS);
                let text = format!("unknown method `{text}`{remedy}");
                self.report.error(Place::at(method.word.span()), text);
                None
            }
        };
        self.model.method = chosen.or(self.model.method);
        if let Some((span, order)) = &method.predictor {
            if !text.eq("newton") {
                let text =
                    format!("method `{text}` starts from no prediction; leave `predictor` out");
                return self.report.error(Place::at(*span), text);
            }
            let order = self.whole(order, "the order of a predictor", [1, MOST_ORDER]);
            // An error was reported: any value will do.
            self.model.predictor = order
                .and_then(|order| u8::try_from(order).ok())
                .unwrap_or(0);
        }
    }

    /// Either a method is declared, or an accuracy that chooses one.
    fn check_choice(&mut self, keyword: Span, word: &'static str, other: &'static str) {
        let singles = &self.scopes.here().singles;
        if singles.contains(&other) && !singles.contains(&word) {
            let text = "`accuracy` chooses the method, so there cannot be both; remove `accuracy` or `method`";
            self.report.error(Place::at(keyword), text);
        }
        self.single(keyword, word, ONE_TOO_MANY);
    }

    fn newton(&mut self, steps: Option<&(Option<Expr>, Place)>) -> Option<Method> {
        let Some((steps, brackets)) = steps else {
            return Some(Method::Newton);
        };
        let Some(steps) = steps else {
            let text = "the number of newton steps is missing; write `newton(2)`, or leave the brackets out";
            self.report.error(*brackets, text);
            return None;
        };
        let steps = self.whole(steps, "the number of newton steps", [1, MOST_STEPS])?;
        u32::try_from(steps).ok().map(Method::NewtonSteps)
    }

    /// A method that takes no number of steps.
    fn without_steps(&mut self, method: &ast::Method, chosen: Method) -> Option<Method> {
        let Some((_, brackets)) = &method.steps else {
            return Some(chosen);
        };
        let text = format!(
            "method `{}` takes no number of steps; leave the brackets out",
            method.word
        );
        self.report.error(*brackets, text);
        None
    }

    pub(super) fn lower_accuracy(&mut self, keyword: Span, value: &Expr) {
        self.check_choice(keyword, "accuracy", "method");
        let accuracy = self.positive(value, "an accuracy");
        self.model.accuracy = accuracy.or(self.model.accuracy);
    }

    pub(super) fn lower_cost(&mut self, keyword: Span, word: &Ident) {
        self.single(keyword, "cost", ONE_TOO_MANY);
        let text = word.to_string();
        self.model.target = match text.as_str() {
            "x86_64" => Target::X86_64,
            "cortex_m4f" => Target::CortexM4f,
            _ => {
                let remedy = spelling::remedy(&text, &MACHINES);
                let text = format!("unknown machine `{text}`{remedy}");
                return self.report.error(Place::at(word.span()), text);
            }
        };
    }

    pub(super) fn lower_change_points(&mut self, keyword: Span, what: AtChangePoints) {
        self.single(keyword, "at change points", ONE_TOO_MANY);
        self.model.change_points = what;
    }
}
