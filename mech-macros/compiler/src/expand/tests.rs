//! A mechanism with errors has the same items as one without.

use super::{analyse_and_emit, stub};
use crate::api::{self, Condition, Owner, TABLE};
use proc_macro2::TokenStream;
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use syn::{Expr, ImplItem, Item, ItemImpl, Stmt};

const CRANK: &str = "link arm { mass 1 at (1, 0); point tip = (1, 0); }
    joint hinge = revolute(ground, arm) at (0, 0);";

const EFFECTS: [&str; 7] = [
    "",
    "effects { velocity; }",
    "effects { acceleration; overlay; }",
    "effects { force; }",
    "effects { dynamics; velocity; }",
    "effects { overlay; force; trace arm.tip 10; }",
    "effects { acceleration; overlay; force; dynamics; trace arm.tip 10; }",
];

/// Mechanisms with all that adds items.
fn mechanisms() -> Vec<String> {
    let acting = "load push = force(arm.tip); load twist = torque(arm);
        spring coil = linear(ground.post, arm.tip) stiffness 1;";
    let with_effects = EFFECTS.map(|effects| {
        let acts =
            if effects.contains("force") || effects.contains("dynamics") { acting } else { "" };
        format!(
            "struct Crank; ground {{ point post = (3, 0); }} {CRANK} motor hinge; {acts} {effects}"
        )
    });
    let others = [
        format!("struct Crank; {CRANK} motor hinge in -1..=1;"),
        format!("struct Crank; {CRANK} motor hinge = t;"),
        "struct Crank; param a = 1; link arm { point tip = (a, 0); }
         joint hinge = revolute(ground, arm) at (0, 0); motor hinge; effects { velocity; sensitivity; }".to_owned(),
        "struct Slider; ground { line rail = (0, 0) -> (1, 0); } link arm { line edge = (0, 0) -> (1, 0); }
         joint guide = prismatic(ground.rail, arm.edge); motor guide;".to_owned(),
    ];
    with_effects.into_iter().chain(others).collect()
}

/// All implementations in these items, those in constants too.
fn implementations(items: Vec<Item>) -> Vec<ItemImpl> {
    let found = items.into_iter().flat_map(|item| match item {
        Item::Impl(item) => vec![item],
        Item::Const(item) => match *item.expr {
            Expr::Block(block) => {
                let inside = block.block.stmts.into_iter().filter_map(|stmt| match stmt {
                    Stmt::Item(item) => Some(item),
                    _ => None,
                });
                implementations(inside.collect())
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    });
    found.collect()
}

/// The signatures of an expansion by name: the inherent ones, or those of the trait.
fn signatures(expansion: TokenStream, of_trait: bool) -> BTreeMap<String, String> {
    let file: syn::File = syn::parse2(expansion).expect("items");
    let all = implementations(file.items).into_iter();
    let wanted = all.filter(|item| match &item.trait_ {
        None => !of_trait,
        Some((path, _)) => {
            of_trait && path.segments.last().is_some_and(|name| name.ident == "Mechanism")
        }
    });
    let items = wanted.flat_map(|item| item.items);
    let signatures = items.filter_map(|item| match item {
        ImplItem::Const(item) => Some((item.ident.to_string(), item.ty.to_token_stream())),
        ImplItem::Type(item) => Some((item.ident.to_string(), item.ty.to_token_stream())),
        ImplItem::Fn(mut item) => {
            item.sig.constness = None;
            let is_own = |name: &str| name == "W" || name == "H";
            let mut parameters = item.sig.generics.const_params();
            if !parameters.any(|parameter| is_own(&parameter.ident.to_string())) {
                item.sig.generics = syn::Generics::default();
            }
            Some((item.sig.ident.to_string(), item.sig.to_token_stream()))
        }
        _ => None,
    });
    signatures.map(|(name, signature)| (name, plain(&signature))).collect()
}

/// A signature without the paths of its types. Each mechanism here has one motor, which may be a parameter of a stub, and how many
/// loops are dyads is not known there.
fn plain(signature: &TokenStream) -> String {
    let mut text: String = signature.to_string().split_whitespace().collect();
    for path in ["::mech_runtime::generated::", "::mech_runtime::overlay::", "::mech_runtime::"] {
        text = text.replace(path, "");
    }
    for parameter in ["MOTORS", "TURNING", "SLIDING", "PARAMS"] {
        text = text.replace(parameter, "1");
    }
    for unknown in ["Forces<", "&F)", "[Cost;"] {
        if let Some(end) = text.find(unknown) {
            text.truncate(end);
        }
    }
    text.trim_end_matches('&').to_owned()
}

#[test]
fn a_stub_has_the_signatures_of_the_items() {
    let krate: TokenStream = "::mech_runtime".parse().expect("a path");
    let not_in_items = |name: &str| {
        TABLE.iter().any(|item| {
            let condition = item.condition;
            let may_lack = matches!(
                condition,
                Condition::Ranges | Condition::Turning | Condition::TurningAndSliding
            );
            may_lack && item.name() == name
        })
    };
    for mechanism in mechanisms() {
        let body: TokenStream = mechanism.parse().expect("tokens");
        let items = analyse_and_emit(&krate, body.clone());
        assert!(!items.to_string().contains("compile_error"), "{mechanism}");
        let stub = stub(&krate, body);
        for of_trait in [false, true] {
            let items = signatures(items.clone(), of_trait);
            let mut stub = signatures(stub.clone(), of_trait);
            assert!(items.len() > 10, "{mechanism}");
            stub.retain(|name, _| items.contains_key(name) || !not_in_items(name));
            assert_eq!(stub, items, "{mechanism}");
        }
    }
}

#[test]
fn the_names_of_all_mechanisms_are_taken() {
    let claimed: BTreeSet<&str> = Owner::ALL.into_iter().flat_map(api::names_of).collect();
    for item in TABLE {
        let name = item.name();
        let is_taken = claimed.contains(name) || api::is_reserved(name);
        assert_eq!(is_taken, item.is_fixed(), "{name}");
    }
}
