//! What a mechanism that does not compile leaves behind: its struct and its methods, so that nothing else in the user's
//! crate turns red.

use super::block::scalar_of;
use super::items::{named_points, picture, user_ident};
use crate::api::{Item, Subject, TABLE};
use crate::bug::bug;
use crate::model::{Between, JointId, LoadKind, Model, Origin};
use crate::syntax::{Header, Places};
use proc_macro2::{Group, Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{ImplItem, ItemImpl};

/// What `krate::generated` has of the names in the table; all others are the runtime's own.
const GENERATED: [&str; 5] = ["Option", "Result", "f64", "str", "usize"];
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

/// The struct and the signatures of its methods. None of it is ever run. How many motors it will have is not known as long
/// as it has errors, so `move_to` takes any number.
pub(crate) fn stub(
    krate: &TokenStream,
    header: &Header,
    places: &Places,
    model: &Model,
    (motors, has_laws): (usize, bool),
) -> TokenStream {
    let Header {
        attributes,
        visibility,
        name,
    } = header;
    let writer = Writer {
        krate,
        header,
        places,
        model,
        motors,
        has_laws,
    };
    let methods = writer.items(|subject| subject != Subject::Trait);
    let methods = distinct(quote!(impl #name { #methods }));
    let of_trait = writer.items(|subject| subject == Subject::Trait);
    quote! {
        #(#attributes)*
        #[derive(#krate::generated::Clone, #krate::generated::Copy, #krate::generated::Debug, #krate::generated::PartialEq)]
        #visibility struct #name {}

        #[allow(dead_code, unused_imports, unused_variables, clippy::all, clippy::pedantic, reason = "never run: the mechanism has errors")]
        const _: () = {
            use #krate::generated::parameters::*;

            #methods

            impl #krate::generated::Default for #name {
                fn default() -> Self {
                    Self {}
                }
            }

            impl #krate::Mechanism for #name {
                #of_trait
            }
        };
    }
}

/// The methods of an implementation, each once: what has the name of something else is reported elsewhere.
fn distinct(methods: TokenStream) -> TokenStream {
    let Ok(mut methods) = syn::parse2::<ItemImpl>(methods.clone()) else {
        return methods;
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
    methods.into_token_stream()
}

/// Something that has items of its own.
struct Named {
    name: String,
    origin: Origin,
    /// How many places a trace has.
    length: usize,
}

impl Named {
    fn new(name: &str, origin: Origin) -> Self {
        Self {
            name: name.to_owned(),
            origin,
            length: 0,
        }
    }
}

/// Writes items of the table for a mechanism.
struct Writer<'m> {
    krate: &'m TokenStream,
    header: &'m Header,
    places: &'m Places,
    model: &'m Model,
    motors: usize,
    has_laws: bool,
}

impl Writer<'_> {
    /// The items of these subjects.
    fn items(&self, wanted: impl Fn(Subject) -> bool) -> TokenStream {
        let items = TABLE.iter().filter(|item| {
            wanted(item.subject) && item.condition.is_met(self.model, self.has_laws)
        });
        items.map(|item| self.item(item)).collect()
    }

    /// An item, once for each of its subject.
    fn item(&self, item: &Item) -> TokenStream {
        let Ok(text) = item.text.parse::<TokenStream>() else {
            bug!("`{}` is no item", item.text);
        };
        if let Subject::Mechanism | Subject::Trait = item.subject {
            return self.filled(text, None);
        }
        let named = self.named(item.subject);
        let items = named
            .iter()
            .map(|named| self.filled(text.clone(), Some(named)));
        items.collect()
    }

    /// Everything of a kind that is shown.
    fn named(&self, subject: Subject) -> Vec<Named> {
        let model = self.model;
        let load = |is_force: bool| {
            let loads = model.actions.loads.iter();
            loads
                .filter(move |load| matches!(load.kind, LoadKind::Force(_)) == is_force)
                .map(|load| Named::new(&load.name, load.origin))
        };
        let joints = |ids: &mut dyn Iterator<Item = JointId>| {
            ids.map(|id| model.joint(id))
                .map(|joint| Named::new(&joint.name, joint.origin))
                .collect()
        };
        match subject {
            Subject::Mechanism | Subject::Trait => Vec::new(),
            Subject::Link => model
                .declared_links()
                .filter(|&id| model.shows_link(id))
                .map(|id| Named::new(&model.link(id).name, model.link(id).origin))
                .collect(),
            Subject::Point => named_points(model)
                .map(|(link, name, origin, _)| {
                    Named::new(&format!("{}_{name}", model.link(link).name), origin)
                })
                .collect(),
            Subject::Joint => joints(&mut model.shown_joints()),
            Subject::DependentJoint => joints(&mut model.dependent_joints()),
            Subject::Force => load(true).collect(),
            Subject::Torque => load(false).collect(),
            Subject::Spring => model
                .actions
                .springs
                .iter()
                .filter(|spring| matches!(spring.between, Between::Points(..)))
                .map(|spring| Named::new(&spring.name, spring.origin))
                .collect(),
            Subject::Param => {
                let params = model.params.all().iter();
                params
                    .map(|param| Named::new(&param.name, param.origin))
                    .collect()
            }
            Subject::Trace => model
                .traces
                .iter()
                .map(|trace| {
                    let axis = model.axis(trace.point);
                    let name = format!("{}_{}", model.link(axis.link).name, axis.own_name());
                    Named {
                        length: trace.length,
                        ..Named::new(&name, axis.origin)
                    }
                })
                .collect(),
        }
    }

    /// A text of the table with what stands for its words.
    fn filled(&self, text: TokenStream, named: Option<&Named>) -> TokenStream {
        let trees = text.into_iter().map(|tree| match tree {
            TokenTree::Ident(word) => self.meaning(&word, named),
            TokenTree::Group(group) => {
                let inside = self.filled(group.stream(), named);
                Group::new(group.delimiter(), inside).into_token_stream()
            }
            other => other.into_token_stream(),
        });
        trees.collect()
    }

    /// What a word of the table stands for.
    fn meaning(&self, word: &Ident, named: Option<&Named>) -> TokenStream {
        let (krate, model) = (self.krate, self.model);
        let count = |count: usize| Literal::usize_unsuffixed(count).into_token_stream();
        let text = word.to_string();
        match text.as_str() {
            "pub" => self.header.visibility.to_token_stream(),
            "scalar" => {
                let scalar = scalar_of(model.precision);
                quote!(#krate::generated::#scalar)
            }
            "struct_name" => self.header.name.to_string().into_token_stream(),
            "frame" => {
                let [picture, _] = picture(model);
                quote!(#krate::#picture)
            }
            "motor_count" => count(self.motors),
            "link_count" => count(model.asked_links().len()),
            "param_count" => count(model.params.len()),
            "joint_count" => count(model.declared_joints().count()),
            "load_count" => count(model.actions.load_names().len()),
            "trace_length" => count(named.map_or(0, |named| named.length)),
            "none" => quote!(#krate::generated::None),
            "Arrows" => quote!(#krate::overlay::Arrows),
            known if GENERATED.contains(&known) => quote!(#krate::generated::#word),
            known if RUNTIME.contains(&known) => quote!(#krate::#word),
            _ => match named {
                Some(Named { name, origin, .. }) if is_pattern(&text) => {
                    let method = text.replacen("name", name, 1);
                    user_ident(&method, self.places, *origin).into_token_stream()
                }
                _ => word.into_token_stream(),
            },
        }
    }
}

/// Whether a word of the table has the name of its subject in it.
fn is_pattern(word: &str) -> bool {
    word == "name" || word == "set_name" || word.starts_with("name_")
}
