//! Params: numbers that may be changed at run time.

use super::constant::Value;
use super::draft::Draft;
use super::expansion::Expansion;
use super::quantity::Quantity;
use super::reader::Reader;
use crate::api::{self, Owner};
use crate::model::{Formula, Param};
use crate::syntax::Place;
use crate::syntax::ast::Constant;
use proc_macro2::Ident;

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
