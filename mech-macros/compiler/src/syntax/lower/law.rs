//! Laws: expressions with a variable. What does not depend on it is computed here, exactly as constants are.

use super::Lowering;
use super::param::Quantity;
use super::value::{add, finite, multiply, shown};
use crate::bug::bug;
use crate::model::{Extreme, Function, JointId, Law, LawId, StartValue, Term, TermId};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, ExprKind};
use std::f64::consts::PI;

/// The time, in laws of motors.
pub(super) const TIME: &str = "t";

/// The coordinate of the shaft, in laws of cams.
pub(super) const COORDINATE: &str = "q";

/// More numbers and operations than this make no law that anybody could read.
const MOST_TERMS: usize = 1000;

/// By how many times its own size a start may miss what its law gives, having been computed in another way.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What a part of a law comes to.
#[derive(Clone, Copy)]
enum Part {
    /// It does not depend on the variable.
    Number(f64),
    Term(TermId),
}

/// A law in the making.
struct Draft {
    law: Law,
    variable: &'static str,
    /// Where it stands among the terms, once something asked.
    standing: Option<TermId>,
}

impl Draft {
    fn term(&mut self, part: Part) -> TermId {
        match part {
            Part::Number(number) => self.law.push(Term::Number(number)),
            Part::Term(term) => term,
        }
    }

    /// Two parts made one.
    fn join(&mut self, [a, b]: [Part; 2], kind: fn(TermId, TermId) -> Term) -> Part {
        let (a, b) = (self.term(a), self.term(b));
        Part::Term(self.law.push(kind(a, b)))
    }
}

/// How the parts of a chain are put together: as numbers, and as terms without and with the flag.
struct Chain {
    fold: fn(f64, f64, bool) -> Result<f64, &'static str>,
    kinds: [fn(TermId, TermId) -> Term; 2],
}

const SUM: Chain = Chain {
    fold: |sum, term, minus| Ok(add(sum, term, minus)),
    kinds: [Term::Sum, Term::Difference],
};

const PRODUCT: Chain = Chain {
    fold: multiply,
    kinds: [Term::Product, Term::Quotient],
};

impl Lowering {
    /// An expression as a function of this variable.
    pub(super) fn law(&mut self, expr: &Expr, variable: &'static str) -> Option<LawId> {
        let origin = self.places.note(expr.place);
        let mut draft = Draft {
            law: Law::new(expr.to_string(), origin),
            variable,
            standing: None,
        };
        self.constants.set_variable(Some(variable));
        let part = self.part(expr, &mut draft);
        self.constants.set_variable(None);
        match part? {
            Part::Number(number) => {
                draft.law.push(Term::Number(number));
            }
            // Whatever was made was made for it, so it is the last.
            Part::Term(_) => {}
        }
        if draft.law.terms().len() > MOST_TERMS {
            let text =
                format!("a law has {MOST_TERMS} numbers and operations at most; this one has more");
            self.report.error(expr.place, text);
            return None;
        }
        self.model.laws.push(draft.law);
        Some(LawId::new(self.model.laws.len() - 1))
    }

    fn part(&mut self, expr: &Expr, draft: &mut Draft) -> Option<Part> {
        if !mentions(expr, draft.variable) {
            return self.value(expr).map(Part::Number);
        }
        match &expr.kind {
            // Only the variable is a name that mentions it.
            ExprKind::Integer(_) | ExprKind::Decimal(_) | ExprKind::Pi | ExprKind::Constant(_) => {
                self.variable(expr.place, draft)
            }
            ExprKind::Negative(inner) => {
                let inner = self.part(inner, draft)?;
                let inner = draft.term(inner);
                Some(Part::Term(draft.law.push(Term::Negative(inner))))
            }
            ExprKind::Degrees(inner) => {
                let inner = self.part(inner, draft)?;
                let degree = Part::Number(PI / 180.0);
                Some(draft.join([inner, degree], Term::Product))
            }
            ExprKind::Sum(terms) => self.parts(terms, &SUM, draft),
            ExprKind::Product(factors) => self.parts(factors, &PRODUCT, draft),
            ExprKind::Call(function, argument) => {
                let argument = self.part(argument, draft)?;
                self.of(*function, argument, (expr.place, draft))
            }
            ExprKind::Extreme(extreme, parts) => {
                let [a, b] = &**parts;
                let (a, b) = (self.part(a, draft), self.part(b, draft));
                let parts = [a?, b?];
                Some(match extreme {
                    Extreme::Least => draft.join(parts, |a, b| Term::Extreme(Extreme::Least, a, b)),
                    Extreme::Greatest => {
                        draft.join(parts, |a, b| Term::Extreme(Extreme::Greatest, a, b))
                    }
                })
            }
        }
    }

    fn variable(&mut self, place: Place, draft: &mut Draft) -> Option<Part> {
        let name = draft.variable;
        if self.constants.has(name) {
            let text = format!(
                "`{name}` is the variable of this law, and a constant too; give the constant another name"
            );
            self.report.error(place, text);
            return None;
        }
        let Draft { law, standing, .. } = draft;
        let term = *standing.get_or_insert_with(|| law.push(Term::Variable));
        Some(Part::Term(term))
    }

    /// A chain, from left to right. All parts are looked at, so that all of their errors are reported.
    fn parts(&mut self, chain: &[(bool, Expr)], how: &Chain, draft: &mut Draft) -> Option<Part> {
        let found: Vec<_> = chain
            .iter()
            .map(|(_, part)| self.part(part, draft))
            .collect();
        let mut parts = chain.iter().zip(found);
        let ((_, first), found) = parts.next()?;
        let mut result = found?;
        for ((inverse, part), found) in parts {
            let place = first.place.to(part.place);
            let found = found?;
            // Of two numbers it is one, and it is an error to divide whatever by the number zero.
            let folded = match (result, found) {
                (Part::Number(result), Part::Number(number)) => {
                    (how.fold)(result, number, *inverse)
                }
                (Part::Term(_), Part::Number(number)) => (how.fold)(0.0, number, *inverse),
                (_, Part::Term(_)) => Ok(0.0),
            };
            let folded = match folded {
                Ok(folded) => folded,
                Err(trouble) => {
                    self.report.error(place, trouble);
                    return None;
                }
            };
            result = match (result, found) {
                (Part::Number(_), Part::Number(_)) => {
                    Part::Number(finite(folded, place, &mut self.report)?)
                }
                both => draft.join(both.into(), how.kinds[usize::from(*inverse)]),
            };
        }
        Some(result)
    }

    fn of(
        &mut self,
        function: Function,
        argument: Part,
        (place, draft): (Place, &mut Draft),
    ) -> Option<Part> {
        match argument {
            Part::Number(number) => {
                let found = self.call(function, Quantity::fixed(number), place)?;
                Some(Part::Number(found.value))
            }
            Part::Term(term) => Some(Part::Term(draft.law.push(Term::Of(function, term)))),
        }
    }

    /// Lets every motor with a law start where that has it when the time is zero.
    pub(super) fn start_by_laws(&mut self) {
        for motor in self.model.motors.clone() {
            let Some(law) = motor.law.map(|law| self.model.law(law)) else {
                continue;
            };
            let (value, origin, written) = (law.at(0.0), law.origin, law.written.clone());
            let joint = motor.joint;
            let name = self.model.joint(joint).name.clone();
            let place = self.places.get(origin);
            self.report.enter(self.statement_of(joint));
            if !value.is_finite() {
                let text = format!(
                    "motor `{name}` starts where its law has it when the time is 0, but `{written}` has no value there; \
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
                    "joint `{name}` is placed in the drawing, where its coordinate is 0, but its law starts at {}; \
                     make the law 0 when `t` is 0, or draw its links as they are to start",
                    shown(value)
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
            shown(value),
            shown(listed.value)
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

/// Whether an expression has this name in it.
fn mentions(expr: &Expr, name: &str) -> bool {
    match &expr.kind {
        ExprKind::Integer(_) | ExprKind::Decimal(_) | ExprKind::Pi => false,
        ExprKind::Constant(constant) => constant == name,
        ExprKind::Negative(inner) | ExprKind::Degrees(inner) | ExprKind::Call(_, inner) => {
            mentions(inner, name)
        }
        ExprKind::Sum(parts) | ExprKind::Product(parts) => {
            parts.iter().any(|(_, part)| mentions(part, name))
        }
        ExprKind::Extreme(_, parts) => parts.iter().any(|part| mentions(part, name)),
    }
}
