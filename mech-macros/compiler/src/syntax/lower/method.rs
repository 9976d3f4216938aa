//! How the loops are solved.

use super::draft::Draft;
use super::reader::Reader;
use crate::model::{Method, Target};
use crate::syntax::ast::{self, Expr};
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

const METHODS: [&str; 3] = ["exact", "newton", "linear"];
const MACHINES: [&str; 2] = ["x86_64", "cortex_m4f"];

/// More Newton steps than this are a mistake: the error is squared by each.
const MOST_STEPS: i32 = 64;

/// Higher orders follow rounding rather than the motion.
const MOST_ORDER: i32 = 3;

pub(super) fn method(reader: &mut Reader, draft: &mut Draft, method: &ast::Method) {
    let text = method.word.to_string();
    let chosen = match text.as_str() {
        "newton" => newton(reader, method.steps.as_ref()),
        "linear" => without_steps(reader, method, Method::Linear),
        "exact" => without_steps(reader, method, Method::Exact),
        _ => {
            let remedy = spelling::remedy(&text, &METHODS);
            let text = format!("unknown method `{text}`{remedy}");
            reader.report.error(Place::at(method.word.span()), text);
            None
        }
    };
    draft.model.method = chosen.or(draft.model.method);
    if let Some((span, order)) = &method.predictor {
        if !text.eq("newton") {
            let text = format!("method `{text}` starts from no prediction; leave `predictor` out");
            return reader.report.error(Place::at(*span), text);
        }
        let order = reader.whole(order, "the order of a predictor", [1, MOST_ORDER]);
        // An error was reported: any value will do.
        draft.model.predictor = order
            .and_then(|order| u8::try_from(order).ok())
            .unwrap_or(0);
    }
}

fn newton(reader: &mut Reader, steps: Option<&(Option<Expr>, Place)>) -> Option<Method> {
    let Some((steps, brackets)) = steps else {
        return Some(Method::Newton);
    };
    let Some(steps) = steps else {
        let text =
            "the number of newton steps is missing; write `newton(2)`, or leave the brackets out";
        reader.report.error(*brackets, text);
        return None;
    };
    let steps = reader.whole(steps, "the number of newton steps", [1, MOST_STEPS])?;
    u32::try_from(steps).ok().map(Method::NewtonSteps)
}

/// A method that takes no number of steps.
fn without_steps(reader: &mut Reader, method: &ast::Method, chosen: Method) -> Option<Method> {
    let Some((_, brackets)) = &method.steps else {
        return Some(chosen);
    };
    let text = format!(
        "method `{}` takes no number of steps; leave the brackets out",
        method.word
    );
    reader.report.error(*brackets, text);
    None
}

pub(super) fn accuracy(reader: &mut Reader, draft: &mut Draft, value: &Expr) {
    let accuracy = reader.positive(value, "an accuracy");
    draft.model.accuracy = accuracy.or(draft.model.accuracy);
}

pub(super) fn cost(reader: &mut Reader, draft: &mut Draft, word: &Ident) {
    let text = word.to_string();
    draft.model.target = match text.as_str() {
        "x86_64" => Target::X86_64,
        "cortex_m4f" => Target::CortexM4f,
        _ => {
            let remedy = spelling::remedy(&text, &MACHINES);
            let text = format!("unknown machine `{text}`{remedy}");
            return reader.report.error(Place::at(word.span()), text);
        }
    };
}
