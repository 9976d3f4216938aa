//! Laws: expressions with a variable.

use super::constant::Passing;
use super::draft::Draft;
use super::motion;
use super::quantity::Quantity;
use super::reader::{LawReading, Nature, Reader};
use crate::model::{Formula, Formulas, Law, LawId};
use crate::syntax::ast::{Expr, ExprKind};

/// More numbers and operations than this make no law that anybody could read.
const MOST_FORMULAS: usize = 1000;

/// An expression as a function of this variable. Where a part is scaled or mirrored, the variable and the result follow from those of the
/// part by these factors.
pub(super) fn read(
    reader: &mut Reader,
    draft: &mut Draft,
    expr: &Expr,
    variable: &'static str,
    [input, output]: [Quantity; 2],
    nature: Option<Nature>,
) -> Option<LawId> {
    let origin = draft.places.note(expr.place);
    let passing = Passing { variable: Some(variable), ..reader.passing };
    let law = LawReading { input, formulas: Formulas::default(), measured: Vec::new(), nature };
    let mut inner = Reader { passing, law: Some(law), ..reader.again() };
    let quantity = match &expr.kind {
        ExprKind::Motion(motion) => motion::read(&mut inner, motion, expr.place)?,
        _ => inner.quantity(expr)?,
    };
    let output = inner.in_this_law(output);
    let quantity = quantity.times(output, inner.formulas());
    let mut formulas = inner.law?.formulas;
    let constant = || quantity.value.map(Formula::constant);
    let value = quantity.formula.or_else(|| constant().map(|constant| formulas.add(constant)))?;
    if formulas.all().len() > MOST_FORMULAS {
        let text =
            format!("a law has {MOST_FORMULAS} numbers and operations at most; this one has more");
        return reader.report.refuse(expr.place, text);
    }
    let law = Law::new(formulas, value, expr.to_string(), origin);
    draft.model.laws.push(law);
    Some(LawId::new(draft.model.laws.len() - 1))
}
