//! The method and the accuracy with which loops are solved.

use super::draft::Draft;
use super::reader::Reader;
use super::setting::choose;
use crate::model::Method;
use crate::syntax::Place;
use crate::syntax::ast::{self, Expr};

const METHODS: [(&str, Method); 3] =
    [("exact", Method::Exact), ("newton", Method::Newton), ("linear", Method::Linear)];

/// More Newton steps than this are a mistake: the error is squared by each.
const MOST_STEPS: i32 = 64;

/// Higher orders follow rounding rather than the motion.
const MOST_ORDER: i32 = 3;

pub(super) fn method(reader: &mut Reader, draft: &mut Draft, method: &ast::Method) {
    let chosen = choose(&method.word, "method", &METHODS, reader.report);
    let is_newton = chosen == Some(Method::Newton);
    let chosen = match chosen {
        Some(Method::Newton) => newton(reader, method.steps.as_ref()),
        other => other.and_then(|other| without_steps(reader, method, other)),
    };
    draft.model.method = chosen.or(draft.model.method);
    if let Some((span, order)) = &method.predictor {
        if !is_newton {
            let word = &method.word;
            let text = format!("method `{word}` starts from no prediction; leave `predictor` out");
            return reader.report.error(Place::at(*span), text);
        }
        let order = reader.whole(order, "the order of a predictor", [1, MOST_ORDER]);
        // An error was reported: any value will do.
        draft.model.predictor = order.and_then(|order| u8::try_from(order).ok()).unwrap_or(0);
    }
}

fn newton(reader: &mut Reader, steps: Option<&(Option<Expr>, Place)>) -> Option<Method> {
    let Some((steps, brackets)) = steps else {
        return Some(Method::Newton);
    };
    let Some(steps) = steps else {
        let text =
            "the number of newton steps is missing; write `newton(2)`, or leave the brackets out";
        return reader.report.refuse(*brackets, text);
    };
    let steps = reader.whole(steps, "the number of newton steps", [1, MOST_STEPS])?;
    u32::try_from(steps).ok().map(Method::NewtonSteps)
}

/// A method that takes no number of steps.
fn without_steps(reader: &mut Reader, method: &ast::Method, chosen: Method) -> Option<Method> {
    let Some((_, brackets)) = &method.steps else {
        return Some(chosen);
    };
    let text = format!("method `{}` takes no number of steps; leave the brackets out", method.word);
    reader.report.refuse(*brackets, text)
}

pub(super) fn accuracy(reader: &mut Reader, draft: &mut Draft, value: &Expr) {
    let accuracy = reader.positive(value, "an accuracy");
    draft.model.accuracy = accuracy.or(draft.model.accuracy);
}
