//! The text with all instances of parts in it.

use super::constant::{Constants, Value};
use super::draft::Draft;
use super::name::Names;
use super::quantity::Quantity;
use super::reader::{Located, Reader};
use super::report::{Report, StatementPlace};
use super::scope::Scopes;
use crate::api::{self, Owner};
use crate::model::{Formula, Param, Params};
use crate::syntax::Place;
use crate::syntax::ast::{Constant, Part, Statement, Text};
use proc_macro2::Ident;

/// The text with all instances of parts in it, and what has a name there. Whoever comes later reads these names.
pub(super) struct Expansion<'t> {
    pub(super) text: &'t Text,
    pub(super) names: Names,
    pub(super) draft: Draft,
    pub(super) params: Params,
    pub(super) report: Report,
}

impl<'t> Expansion<'t> {
    /// Nothing but the names of constants.
    pub(super) fn of(text: &'t Text) -> Self {
        Self {
            text,
            names: Names::new(Scopes::new(Constants::of(&text.statements))),
            draft: Draft::of(text),
            params: Params::default(),
            report: Report::default(),
        }
    }

    /// Reading in a scope, and the model that is made from it.
    pub(super) fn read(&mut self, scope: usize) -> (Reader<'_>, &mut Draft) {
        let reader = Reader::new(&self.names, scope, &mut self.params, &mut self.report);
        (reader, &mut self.draft)
    }

    /// From now on messages are about this statement.
    pub(super) fn enter(&mut self, located: &Located) {
        let instance = self.names.scope(located.scope).instance();
        self.report.enter(located.place, instance);
    }
}

/// Statements in a scope: those of the mechanism, or in an instance those of the part whose own statement has this number.
pub(super) fn locate(
    statements: &[Statement],
    scope: usize,
    part: Option<usize>,
) -> impl DoubleEndedIterator<Item = Located<'_>> {
    let place = move |number| match part {
        None => StatementPlace::of_mechanism(number),
        Some(outer) => StatementPlace { outer, inner: Some(number) },
    };
    let numbered = statements.iter().enumerate();
    numbered.map(move |(index, statement)| Located {
        scope,
        place: place(index + 1),
        statement,
        is_named: false,
    })
}

/// The parts of a mechanism, each with the number of its statement.
pub(super) fn parts(text: &Text) -> impl Iterator<Item = (usize, &Part)> {
    let statements = (1..).zip(&text.statements);
    statements.filter_map(|(number, statement)| match statement {
        Statement::Part(part) => Some((number, &**part)),
        _ => None,
    })
}

impl Expansion<'_> {
    /// Declares a param in a scope.
    pub(super) fn declare_param(&mut self, param: &Constant, scope: usize) {
        let name = &param.name;
        let constants = &mut self.names.scopes.get_mut(scope).constants;
        let is_new = constants.declare(name, Value::default(), "param", &mut self.report);
        let (mut reader, draft) = self.read(scope);
        let is_taken = is_new
            && draft.claims.take_name(&mut reader, name, "param")
            && take_setters(&mut reader, draft, name);
        let value = reader.report.read(&param.value);
        let value = value.and_then(|expr| reader.value(expr));
        if let Some(value) = value.filter(|_| is_taken) {
            let id = self.params.add(Param {
                name: self.names.scope(scope).key_of(name),
                origin: self.draft.note(name),
                value,
            });
            let quantity = Quantity {
                value: Some(value),
                formula: Some(self.params.formula(Formula::Param(id))),
            };
            let constants = &mut self.names.scopes.get_mut(scope).constants;
            constants.assign(name, quantity);
        }
    }
}

/// Takes the method that sets a param and, with the first, those of all: whether it can have them.
fn take_setters(reader: &mut Reader, draft: &mut Draft, name: &Ident) -> bool {
    let place = Place::at(name.span());
    if !std::mem::replace(&mut draft.has_params, true) {
        let owner = Owner::Params;
        for method in api::names_of(owner) {
            let owner = owner.to_string();
            if !draft.claims.take(method.to_owned(), owner, place, reader.report) {
                return false;
            }
        }
    }
    let owner = format!("changing param `{name}`");
    let setter = format!("{}set_{name}", reader.here().prefix);
    draft.claims.take(setter, owner, place, reader.report)
}
