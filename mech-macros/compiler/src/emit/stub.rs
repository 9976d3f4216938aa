//! The stub of a mechanism with errors: its struct and its methods, so that nothing else in the user's crate turns red.

use super::accessors::{NamedPoint, shown_links, shown_points};
use super::drawing::picture;
use super::tokens::{integer, scalar, setter, user_ident};
use super::views::{Site, Views, views};
use crate::api::{Item, Subject, TABLE};
use crate::bug::bug;
use crate::model::{Between, JointId, LoadKind, Origin};
use crate::syntax::{Header, Parsed};
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{ImplItem, ItemImpl};

/// The names in the table that stand for items of `generated` in the runtime crate, and for items at its root.
const GENERATED: [&str; 6] = ["Option", "Result", "bool", "f64", "str", "usize"];
const RUNTIME: [&str; 21] = [
    "Acceleration",
    "Blocked",
    "BlockedAt",
    "Canvas",
    "Columns",
    "Cost",
    "Forces",
    "GaussLegendre",
    "InRange",
    "Isometry2",
    "JointInfo",
    "JointKind",
    "Overlay",
    "Phase",
    "Point2",
    "Pose",
    "Reached",
    "Shape",
    "Trace",
    "Vector2",
    "Velocity",
];

/// The struct and the signatures of its methods. None of it is ever run. The number of motors is not certain as long as there are
/// errors, so `move_to` takes any number.
pub(crate) fn stub(krate: &TokenStream, header: &Header, parsed: &Parsed) -> TokenStream {
    let Header { attributes, visibility, name } = header;
    let stub = Stub { krate, header, parsed };
    let site = Site { krate, visibility, this: name };
    let methods = without_duplicates(&stub.items(Item::method));
    let Views { methods, items: views } = views(&site, &parsed.model, methods);
    let trait_items = stub.items(Item::trait_item);
    quote! {
        #(#attributes)*
        #[derive(#krate::generated::Clone, #krate::generated::Copy, #krate::generated::Debug, #krate::generated::PartialEq)]
        #visibility struct #name {}

        #[allow(dead_code, unused_imports, unused_variables, clippy::all, clippy::pedantic, reason = "never run: the mechanism has errors")]
        const _: () = {
            use #krate::generated::parameters::*;

            impl #name {
                #methods
            }

            #views

            impl #krate::generated::Default for #name {
                fn default() -> Self {
                    Self {}
                }
            }

            impl #krate::Mechanism for #name {
                #trait_items
            }
        };
    }
}

/// Associated items, the first of each name. Parts of the same name are reported elsewhere.
fn without_duplicates(items: &TokenStream) -> TokenStream {
    let Ok(mut methods) = syn::parse2::<ItemImpl>(quote!(impl Mechanism { #items })) else {
        return items.clone();
    };
    let mut names: Vec<Ident> = Vec::new();
    methods.items.retain(|item| {
        let name = match item {
            ImplItem::Const(item) => &item.ident,
            ImplItem::Fn(item) => &item.sig.ident,
            _ => return true,
        };
        let is_new = !names.contains(name);
        names.push(name.clone());
        is_new
    });
    let items = methods.items;
    quote!(#(#items)*)
}

/// A part of a mechanism that has items of its own.
struct Part {
    name: String,
    origin: Origin,
    /// The number of places of a trace.
    length: usize,
}

impl Part {
    fn new(name: &str, origin: Origin) -> Self {
        Self { name: name.to_owned(), origin, length: 0 }
    }
}

/// A mechanism with errors, for which the items of the table are written.
struct Stub<'m> {
    krate: &'m TokenStream,
    header: &'m Header,
    parsed: &'m Parsed,
}

impl Stub<'_> {
    /// The items of the table that have this text, once for each part that they are for.
    fn items(&self, text: fn(&Item) -> Option<String>) -> TokenStream {
        let Parsed { model, asked, .. } = self.parsed;
        let items = TABLE.iter().filter(|item| item.condition.is_met(model, *asked));
        let items = items.filter_map(|item| {
            let text = text(item)?;
            let Ok(tokens) = text.parse::<TokenStream>() else {
                bug!("`{text}` is no item");
            };
            Some(match self.parts(item.subject) {
                None => self.fill(tokens, None),
                Some(parts) => {
                    let parts = parts.iter();
                    let items = parts.map(|part| self.fill(tokens.clone(), Some(part)));
                    items.collect()
                }
            })
        });
        items.collect()
    }

    /// All parts of a kind that are shown; none for the mechanism itself.
    fn parts(&self, subject: Subject) -> Option<Vec<Part>> {
        let model = &self.parsed.model;
        let joint = |id: JointId| Part::new(&model.joint(id).name, model.joint(id).origin);
        let loads = |is_force: bool| {
            let loads = model.actions.loads.iter();
            let loads = loads.filter(|load| matches!(load.kind, LoadKind::Force(_)) == is_force);
            loads.map(|load| Part::new(&load.name, load.origin)).collect()
        };
        Some(match subject {
            Subject::Mechanism | Subject::Both | Subject::Trait => return None,
            Subject::Link => shown_links(model)
                .map(|id| Part::new(&model.link(id).name, model.link(id).origin))
                .collect(),
            Subject::Point => {
                shown_points(model).map(|point| Part::new(&point.ident(), point.origin)).collect()
            }
            Subject::Joint => model.shown_joints().map(joint).collect(),
            Subject::DependentJoint => model.dependent_joints().map(joint).collect(),
            Subject::Force => loads(true),
            Subject::Torque => loads(false),
            Subject::Spring => {
                let springs = model.actions.springs.iter();
                springs
                    .filter(|spring| matches!(spring.between, Between::Points(..)))
                    .map(|spring| Part::new(&spring.name, spring.origin))
                    .collect()
            }
            Subject::Param => {
                let params = model.params.all().iter();
                params.map(|param| Part::new(&param.name, param.origin)).collect()
            }
            Subject::Trace => {
                let traces = model.traces.iter().map(|trace| {
                    let point = NamedPoint::new(model, trace.point);
                    Part { length: trace.length, ..Part::new(&point.ident(), point.origin) }
                });
                traces.collect()
            }
        })
    }

    /// A text of the table with its words replaced by what they stand for.
    fn fill(&self, text: TokenStream, part: Option<&Part>) -> TokenStream {
        let trees = text.into_iter().map(|tree| match tree {
            TokenTree::Ident(word) => self.meaning(&word, part),
            TokenTree::Group(group) => {
                let inside = self.fill(group.stream(), part);
                Group::new(group.delimiter(), inside).into_token_stream()
            }
            other => other.into_token_stream(),
        });
        trees.collect()
    }

    /// Returns the tokens for a word of the table.
    fn meaning(&self, word: &Ident, part: Option<&Part>) -> TokenStream {
        let (krate, model) = (self.krate, &self.parsed.model);
        let count = |count: usize| integer(count).into_token_stream();
        let text = word.to_string();
        match text.as_str() {
            "pub" => self.header.visibility.to_token_stream(),
            "scalar" => {
                let scalar = scalar(model.precision);
                quote!(#krate::generated::#scalar)
            }
            "struct_name" => self.header.name.to_string().into_token_stream(),
            "frame" => {
                let picture = picture(model);
                quote!(#krate::#picture)
            }
            "motor_count" => count(self.parsed.motors),
            "link_count" => count(model.asked_links().len()),
            "param_count" => count(model.params.len()),
            "joint_count" => count(model.declared_joints().count()),
            "load_count" => count(model.actions.load_names().len()),
            "trace_length" => match part {
                Some(part) => count(part.length),
                None => bug!("a method of no trace has a length"),
            },
            "none" => quote!(#krate::generated::None),
            "Arrows" => quote!(#krate::overlay::Arrows),
            known if GENERATED.contains(&known) => quote!(#krate::generated::#word),
            known if RUNTIME.contains(&known) => quote!(#krate::#word),
            _ => match part {
                Some(Part { name, origin, .. }) if is_pattern(&text) => {
                    let method = match text.as_str() {
                        "set_name" => setter(name),
                        text => text.replacen("name", name, 1),
                    };
                    user_ident(&method, &self.parsed.places, *origin).into_token_stream()
                }
                _ => word.into_token_stream(),
            },
        }
    }
}

/// Whether a word of the table contains the name of its part.
fn is_pattern(word: &str) -> bool {
    word == "name" || word == "set_name" || word.starts_with("name_")
}
