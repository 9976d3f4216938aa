//! What tables measure of a mechanism: each text by itself, once the model is known.

use super::constant::Constants;
use super::draft::Draft;
use super::measured::Tabulated;
use super::name::{Body, LentLink, Names, Referent, divide};
use super::quantity::Quantity;
use super::reader::{LawReading, Reader};
use super::report::{Report, StatementPlace};
use super::requirement::check_size;
use super::scope::{Scopes, UsedPart};
use super::similarity::Similarity;
use super::vector::{Subject, Vector};
use crate::bug::bug;
use crate::model::{Measurand, Measured, Model, Params};
use crate::syntax::Message;
use crate::syntax::ast::{Expr, ExprKind, VectorPart};

/// The numbers that a text measures: of a vector without a part, its parts.
pub(in crate::syntax) fn lower(
    model: &Model,
    expr: &Expr,
    text: &str,
) -> Result<Vec<Measurand>, Message> {
    let names = Names::of_model(model);
    let draft = Draft::of_model(model.clone());
    let (mut params, mut report) = (Params::default(), Report::default());
    // All constants of the text stand before it.
    report.enter(StatementPlace::of_mechanism(1), None);
    let mut reader = Reader::new(&names, 0, &mut params, &mut report);
    let found = measurands(&mut reader, &draft, expr);
    match (found, report.first()) {
        (_, Some(message)) => Err(message),
        (Some(mut found), None) => {
            for one in &mut found {
                one.name.insert_str(0, text);
            }
            Ok(found)
        }
        (None, None) => bug!("nothing is measured, and nothing says why"),
    }
}

/// The same, named by the ends of their names alone.
fn measurands(reader: &mut Reader, draft: &Draft, expr: &Expr) -> Option<Vec<Measurand>> {
    let measuring = Tabulated(draft);
    let mut inner = Reader {
        law: Some(LawReading::of_measured()),
        measuring: Some(&measuring),
        ..reader.again()
    };
    let vector = match &expr.kind {
        ExprKind::Measured(measured) => {
            match measuring.subject(&mut inner, measured, expr.place)? {
                Subject::Vector(vector, None) => Ok(vector),
                Subject::Vector(vector, part) => Err(inner.part_of_vector(vector, part)?),
                Subject::Number(number) => Err(number),
            }
        }
        _ => Err(inner.quantity(expr)?),
    };
    let numbers = match vector {
        Ok(vector) => parts(&mut inner, vector)?,
        Err(number) => vec![("", number)],
    };
    let numbers: Vec<_> = numbers
        .into_iter()
        .map(|(ending, number)| (ending, number.as_formula(inner.formulas())))
        .collect();
    let Some(LawReading { formulas, measured, .. }) = inner.law.take() else {
        bug!("a measurand has lost its formulas");
    };
    check_size(reader, &formulas, expr.place)?;
    refuse_summaries(reader, &measured, expr)?;
    let made = numbers.into_iter().map(|(ending, subject)| {
        Measurand::new(ending.to_owned(), formulas.clone(), measured.clone(), subject)
    });
    Some(made.collect())
}

/// Both parts of a vector.
fn parts(reader: &mut Reader, vector: Vector) -> Option<Vec<(&'static str, Quantity)>> {
    let parts = [(".x", VectorPart::X), (".y", VectorPart::Y)].into_iter();
    let parts = parts.map(|(ending, part)| {
        let number = reader.part_of_vector(vector, Some(part))?;
        Some((ending, number))
    });
    parts.collect()
}

/// Complains about what is no number of a position.
fn refuse_summaries(reader: &mut Reader, measured: &[Measured], expr: &Expr) -> Option<()> {
    let is_summary = |one: &Measured| matches!(one, Measured::Summary(..));
    if !measured.iter().any(is_summary) {
        return Some(());
    }
    let text =
        format!("`{expr}` sums up a whole motion; `--summary` does so for all that is measured");
    reader.report.refuse(expr.place, text)
}

impl Names {
    /// The names of a model that is made.
    fn of_model(model: &Model) -> Self {
        let mut names = Self::new(Scopes::of_model(model));
        for link in model.declared_links() {
            let name = model.link(link).name.clone();
            names.enter(name, Referent::Link(link.into()));
        }
        for joint in model.declared_joints() {
            let name = model.joint(joint).name.clone();
            names.enter(name, Referent::Joint(Some(joint)));
        }
        for axis in &model.axes {
            let Some(path) = axis.port.as_ref().filter(|path| names.get(path).is_none()) else {
                continue;
            };
            let body = Body { id: axis.link, port: Some(names.ports.len()) };
            names.ports.push(LentLink { path: path.clone(), similarity: Similarity::IDENTITY });
            names.enter(path.clone(), Referent::Link(body));
        }
        names
    }
}

impl Scopes {
    /// The scopes of a model that is made.
    fn of_model(model: &Model) -> Self {
        let mut scopes = Self::new(Constants::of_model(model));
        for instance in &model.instances {
            let parent = instance.parent.map_or(0, |parent| parent + 1);
            let (_, name) = divide(&instance.path);
            let number = scopes.add(parent, name, &instance.part, Constants::default());
            let uses = &mut scopes.get_mut(parent).uses;
            match uses.iter_mut().find(|used| used.name == instance.name) {
                Some(used) => used.instances.push(number),
                None => uses.push(UsedPart {
                    name: instance.name.clone(),
                    is_array: instance.index.is_some(),
                    own: Similarity::IDENTITY,
                    instances: vec![number],
                }),
            }
        }
        scopes
    }
}
