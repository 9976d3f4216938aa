//! The methods of instances of parts: hidden methods of the mechanism, which those of the views call.

use super::merge::{merged, names};
use super::method::{Item, Method};
use super::tokens::hidden_method;
use crate::model::Model;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use std::collections::{BTreeMap, HashSet};
use syn::ImplItemFn;

/// A method of what belongs to an instance.
pub(super) struct Owned {
    pub(super) instance: usize,
    /// Its name in the view.
    pub(super) local: String,
    pub(super) method: Method,
}

/// The instances, by what the names of their hidden methods begin with.
pub(super) struct Owners(BTreeMap<String, usize>);

impl Owners {
    /// The instances of a mechanism.
    pub(super) fn of(model: &Model) -> Self {
        let instances = model.instances.iter().enumerate();
        let prefixes = instances
            .map(|(number, instance)| (hidden_method(&format!("{}.", instance.path)), number));
        Self(prefixes.collect())
    }

    /// The instance to which a hidden method belongs, and the name of the method there.
    pub(super) fn owner(&self, method: &Ident) -> Option<(usize, String)> {
        let name = method.to_string();
        // A beginning ends with two underscores; the longest one counts.
        let ends = name.char_indices().map(|(at, letter)| at + letter.len_utf8());
        let ends = ends.rev().filter(|end| name[..*end].ends_with("__"));
        let mut owners = ends.filter_map(|end| {
            let number = self.0.get(&name[..end])?;
            Some((*number, name[end..].to_owned()))
        });
        owners.next()
    }
}

/// A method of a view: for each instance of the kind, that which it calls, if it has one.
pub(super) struct Shared<'o> {
    pub(super) local: &'o str,
    /// The method of the first instance that has it.
    pub(super) first: &'o Owned,
    /// The same, as it reads.
    pub(super) read: ImplItemFn,
    pub(super) all: Vec<Option<&'o Owned>>,
    /// The body of all, where they differ in numbers only.
    pub(super) body: Option<TokenStream>,
}

impl Shared<'_> {
    /// Tells whether the methods take `&mut self`.
    pub(super) fn takes_mutable(&self) -> bool {
        let receiver = self.read.sig.receiver().map(|receiver| &receiver.kind);
        matches!(receiver, Some(syn::ReceiverKind::Reference(_, _, Some(_))))
    }

    fn merged_body(&self) -> Option<TokenStream> {
        if self.read.sig.inputs.len() != 1 || self.takes_mutable() {
            return None;
        }
        let bodies = self.all.iter().map(|one| Some(one.as_ref()?.method.body()));
        let bodies: Vec<TokenStream> = bodies.collect::<Option<_>>()?;
        merged(&bodies, &quote!(self.mechanism), &quote!(self.instance))
    }
}

/// The methods that these instances have.
pub(super) fn shared<'o>(instances: &[usize], owned: &'o [Owned]) -> Vec<Shared<'o>> {
    let mut methods: Vec<Shared<'o>> = Vec::new();
    for (number, instance) in instances.iter().enumerate() {
        for one in owned.iter().filter(|one| one.instance == *instance) {
            if let Some(known) = methods.iter_mut().find(|known| known.local == one.local) {
                known.all[number] = Some(one);
                continue;
            }
            let mut all = vec![None; instances.len()];
            all[number] = Some(one);
            methods.push(Shared {
                local: &one.local,
                first: one,
                read: one.method.read(),
                all,
                body: None,
            });
        }
    }
    for method in &mut methods {
        method.body = method.merged_body();
    }
    methods
}

/// Drops the hidden methods that views have merged, unless others call them.
pub(super) fn drop_uncalled<'s>(
    methods: &mut Vec<Item>,
    shared: impl Iterator<Item = &'s Shared<'s>>,
) {
    let (mut merged, mut called) = (HashSet::new(), HashSet::new());
    for shared in shared {
        let Some(body) = &shared.body else { continue };
        names(body, &mut called);
        let all = shared.all.iter().flatten();
        merged.extend(all.map(|one| one.method.name.to_string()));
    }
    let name = |method: &Item| match method {
        Item::Method(method) => Some(method.name.to_string()),
        Item::Other(_) => None,
    };
    let is_merged = |method: &Item| name(method).is_some_and(|name| merged.contains(&name));
    for method in methods.iter().filter(|method| !is_merged(method)) {
        names(&method.to_token_stream(), &mut called);
    }
    methods.retain(|method| {
        !is_merged(method) || name(method).is_some_and(|name| called.contains(&name))
    });
}
