//! Who has taken which name.

use super::name::{Body, Referent};
use super::reader::Reader;
use super::report::Report;
use crate::api::{self, Owner, is_reserved};
use crate::model::Model;
use crate::syntax::Place;
use proc_macro2::Ident;
use std::collections::{HashMap, HashSet};

/// The methods that the generated struct will have, and the names that two things claim. Looked up only, never iterated.
#[derive(Default)]
pub(super) struct Claims {
    /// Each with what it is made for.
    methods: HashMap<String, String>,
    /// The names that a link and a joint claim: whoever means the second is not to blame.
    shared: HashSet<String>,
}

impl Claims {
    /// Whether both a link and a joint claim this name.
    pub(super) fn is_shared(&self, name: &str) -> bool {
        self.shared.contains(name)
    }

    /// Whether a method was taken for this.
    pub(super) fn has(&self, method: &str, owner: &str) -> bool {
        let by = self.methods.get(method);
        by.is_some_and(|by| by == owner)
    }

    /// Takes a method: whether it can be had.
    pub(super) fn take(
        &mut self,
        method: String,
        owner: String,
        place: Place,
        report: &mut Report,
    ) -> bool {
        if let Some(earlier) = self.methods.get(&method) {
            let text = format!(
                "{owner} and {earlier} would both be the method `{method}`; rename one of them"
            );
            report.error(place, text);
            return false;
        }
        self.methods.insert(method, owner);
        true
    }

    /// Takes all methods of this owner, and reports each that something else has.
    pub(super) fn take_all(&mut self, owner: Owner, place: Place, report: &mut Report) {
        for method in api::names_of(owner) {
            self.take(method.to_owned(), owner.to_string(), place, report);
        }
    }

    /// Takes the name of a link or a joint (`what`): whether it can have it.
    pub(super) fn take_name(&mut self, reader: &mut Reader, name: &Ident, what: &str) -> bool {
        let text = name.to_string();
        let key = reader.key_of(name);
        let place = Place::at(name.span());
        let in_path = what == "use" || reader.here().part.is_some();
        let trouble = if text == "ground" {
            "`ground` is the link that is fixed".to_owned()
        } else if is_reserved(&text) {
            format!("`{text}` is a method of every mechanism")
        } else if in_path && (text.contains("__") || text.starts_with('_') || text.ends_with('_')) {
            format!("`{text}` stands in paths, where underscores are only between letters")
        } else {
            let earlier = match reader.names.get(&key) {
                Some(Referent::Link(_)) => "link",
                Some(Referent::Joint(_)) => "joint",
                Some(Referent::Use) => "use",
                Some(Referent::Broken) | None => {
                    let owner = format!("{what} `{text}`");
                    return self.take(key, owner, place, reader.report);
                }
            };
            if earlier != what {
                self.shared.insert(key);
            }
            format!("there is a {earlier} `{text}` already")
        };
        let message = format!("{trouble}; choose another name for this {what}");
        reader.report.error(place, message);
        false
    }

    /// Takes the method of a point: whether it can have it.
    pub(super) fn take_point(
        &mut self,
        reader: &mut Reader,
        model: &Model,
        link: Body,
        name: &Ident,
    ) -> bool {
        let link = reader.names.name_of(model, link);
        let method = format!("{link}_{name}");
        let owner = format!("point `{link}.{name}`");
        self.take(method, owner, Place::at(name.span()), reader.report)
    }
}
