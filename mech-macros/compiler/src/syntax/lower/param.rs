//! Params: numbers that may be changed at run time.

use super::constant::Value;
use super::draft::Draft;
use super::name::Names;
use super::quantity::Quantity;
use super::reader::Reader;
use super::report::Report;
use crate::api::{self, Owner};
use crate::model::{Formula, Param, Params};
use crate::syntax::Place;
use crate::syntax::ast::Constant;
use proc_macro2::Ident;

/// Declares a param in a scope.
pub(super) fn declare(
    param: &Constant,
    scope: usize,
    names: &mut Names,
    draft: &mut Draft,
    params: &mut Params,
    report: &mut Report,
) {
    let name = &param.name;
    let constants = &mut names.scopes.get_mut(scope).constants;
    let is_new = constants.declare(name, Value::default(), "param", report);
    let mut reader = Reader::new(names, scope, params, report);
    let is_taken = is_new
        && draft.claims.take_name(&mut reader, name, "param")
        && take_setters(&mut reader, draft, name);
    let value = match &param.value {
        Ok(expr) => reader.value(expr),
        Err(error) => {
            reader.report.pass_on(error.clone());
            None
        }
    };
    if let Some(value) = value.filter(|_| is_taken) {
        let id = params.add(Param {
            name: names.scope(scope).key_of(name),
            origin: draft.note(name),
            value,
        });
        let quantity = Quantity {
            value: Some(value),
            formula: Some(params.formula(Formula::Param(id))),
        };
        names.scopes.get_mut(scope).constants.assign(name, quantity);
    }
}

/// Takes the method that sets a param and, with the first, those of all: whether it can have them.
fn take_setters(reader: &mut Reader, draft: &mut Draft, name: &Ident) -> bool {
    let place = Place::at(name.span());
    if !std::mem::replace(&mut draft.has_params, true) {
        let owner = Owner::Params;
        for method in api::names_of(owner) {
            let owner = owner.to_string();
            if !draft
                .claims
                .take(method.to_owned(), owner, place, reader.report)
            {
                return false;
            }
        }
    }
    let owner = format!("changing param `{name}`");
    let setter = format!("{}set_{name}", reader.here().prefix);
    draft.claims.take(setter, owner, place, reader.report)
}
