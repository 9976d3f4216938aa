//! The methods that forces add to a mechanism that has errors: never run.

use crate::emit::items::user_ident;
use crate::model::{Between, LoadKind, Model};
use crate::syntax::Places;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The same methods for a mechanism that has errors: never run.
pub(in crate::emit) fn stub(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    visibility: &syn::Visibility,
    (scalar, motors): (&TokenStream, &Literal),
) -> TokenStream {
    let mut tokens = TokenStream::new();
    if !model.effects.needs_actions() {
        return tokens;
    }
    let blocked = quote!(#krate::Blocked<[#scalar; #motors]>);
    let result = |what: TokenStream| quote!(#krate::generated::Result<#what, #blocked>);
    let done = result(quote!(()));
    let all = result(quote!([#scalar; #motors]));
    for load in &model.actions.loads {
        let get = user_ident(&load.name, places, load.origin);
        let set = user_ident(&format!("set_{}", load.name), places, load.origin);
        let kind = match load.kind {
            LoadKind::Force(_) => quote!([#scalar; 2]),
            LoadKind::Torque(_) => quote!(#scalar),
        };
        tokens.extend(quote! {
            #visibility fn #get(&self) -> #kind { loop {} }
            #visibility fn #set(&mut self, load: #kind) -> #done { loop {} }
        });
    }
    for spring in &model.actions.springs {
        if let Between::Points(..) = spring.between {
            let name = user_ident(&spring.name, places, spring.origin);
            tokens.extend(quote!(#visibility fn #name(&self) -> #scalar { loop {} }));
        }
    }
    if model.effects.force {
        tokens.extend(quote! {
            #visibility fn hold_at(&mut self, motors: [#scalar; #motors]) -> #all { loop {} }
            #visibility fn torques(&self) -> #all { loop {} }
        });
        let [joints, loads] = [
            model.told_joints().count(),
            model.actions.load_names().len(),
        ]
        .map(Literal::usize_unsuffixed);
        // How many loops are dyads is not known; there are no more of them than joints.
        let forces = result(quote!(#krate::Forces<#scalar, #motors, #joints, #loads, #joints>));
        tokens.extend(quote! {
            #visibility fn forces(&self, rates: [#scalar; #motors], accelerations: [#scalar; #motors]) -> #forces { loop {} }
        });
        for load in &model.actions.loads {
            let name = user_ident(&format!("{}_advantage", load.name), places, load.origin);
            let along = match load.kind {
                LoadKind::Force(_) => quote!(, along: [#scalar; 2]),
                LoadKind::Torque(_) => quote!(),
            };
            tokens.extend(quote!(#visibility fn #name(&self #along) -> #all { loop {} }));
        }
    }
    if model.effects.dynamics {
        let energy = result(quote!([#scalar; 2]));
        tokens.extend(quote! {
            #visibility fn rates(&self) -> [#scalar; #motors] { loop {} }
            #visibility fn set_rates(&mut self, rates: [#scalar; #motors]) -> #done { loop {} }
            #visibility fn motor_accelerations(&self, torques: [#scalar; #motors]) -> #all { loop {} }
            #visibility fn energy(&self) -> #energy { loop {} }
            #visibility fn simulate(&mut self, time: #scalar, torques: [#scalar; #motors]) -> #done { loop {} }
            #visibility fn simulate_by(&mut self, method: #krate::GaussLegendre, time: #scalar, torques: [#scalar; #motors]) -> #done {
                loop {}
            }
        });
    }
    tokens
}
