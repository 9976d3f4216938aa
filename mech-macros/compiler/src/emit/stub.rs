//! What a mechanism that does not compile leaves behind: its struct and its methods, so that nothing else in the user's
//! crate turns red.

use super::items::{named_points, user_ident};
use crate::model::{JointKind, Model, Precision};
use crate::syntax::{Header, Places};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::{ImplItem, ItemImpl};

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
    let scalar = match model.precision {
        Precision::F32 => quote!(#krate::generated::f32),
        Precision::F64 => quote!(#krate::generated::f64),
    };
    let motors = Literal::usize_unsuffixed(motors);
    let links = Literal::usize_unsuffixed(model.asked_links().len());
    let joints = super::joints::stub(krate, model, visibility, &scalar);
    let implementation = implementation(krate, header, (&scalar, &motors), &joints.trait_methods);
    let methods = distinct(methods(
        krate,
        header,
        places,
        model,
        has_laws,
        (&scalar, &links, &motors),
        &joints.methods,
    ));
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

            #implementation
        };
    }
}

/// The methods of the struct; a name may stand more than once.
fn methods(
    krate: &TokenStream,
    header: &Header,
    places: &Places,
    model: &Model,
    has_laws: bool,
    (scalar, links, motors): (&TokenStream, &Literal, &Literal),
    joints: &TokenStream,
) -> TokenStream {
    let Header {
        visibility, name, ..
    } = header;
    let accessors = accessors(krate, places, model, (scalar, motors));
    let rates = rates(krate, model, visibility, (scalar, links, motors));
    let forces = super::forces::stub(krate, places, model, visibility, (scalar, motors));
    let clear_traces =
        (!model.traces.is_empty()).then(|| quote!(#visibility fn clear_traces(&mut self) {}));
    let overlay = super::overlay::stub(krate, model, visibility, scalar);
    let params = super::params::stub(krate, places, model, visibility, (scalar, links, motors));
    // A size that no parameter has could not be inferred.
    let (sliding, slides) = if super::moves::motor_counts(model)[1] > 0 {
        (
            quote!(, const SLIDING: #krate::generated::usize),
            quote!(, slides: [#scalar; SLIDING]),
        )
    } else {
        (TokenStream::new(), TokenStream::new())
    };
    let at_time = at_time(krate, visibility, has_laws, (scalar, motors));
    let (names, types): (Vec<_>, Vec<_>) = accessors.into_iter().unzip();
    let [picture, _] = super::items::picture(model);
    quote! {
    impl #name {
        #visibility const REPORT: &'static #krate::generated::str = "";
        #visibility const COST: #krate::Cost = #krate::Cost::NOTHING;
        #visibility const LOOP_COSTS: [#krate::Cost; 0] = [];
        #[must_use]
        #visibility const fn new() -> Self {
            Self {}
        }
        #visibility fn motors(&self) -> [#scalar; #motors] {
            loop {}
        }
        #visibility fn move_to<const MOTORS: #krate::generated::usize>(&mut self, motors: [#scalar; MOTORS]) -> #krate::generated::Result<(), #krate::Blocked<[#scalar; MOTORS]>> {
            loop {}
        }
        #visibility fn turn_to<const TURNING: #krate::generated::usize #sliding>(&mut self, phases: [#krate::Phase; TURNING] #slides)
            -> #krate::generated::Result<(), #krate::Blocked<[#scalar; #motors]>>
        {
            loop {}
        }
        #visibility fn range<const MOTORS: #krate::generated::usize>(motors: [#scalar; MOTORS])
            -> #krate::generated::Option<#krate::InRange<Self, [#scalar; MOTORS]>>
        {
            #krate::generated::Option::None
        }
        #visibility fn move_within<const MOTORS: #krate::generated::usize>(&mut self, motors: #krate::InRange<Self, [#scalar; MOTORS]>) {}
        #visibility fn solve_many<const MOTORS: #krate::generated::usize>(
            &self,
            motors: &[[#scalar; MOTORS]],
            columns: &mut #krate::Columns<'_, #scalar, #links>,
        ) -> #krate::generated::Result<(), #krate::BlockedAt<[#scalar; MOTORS]>> {
            loop {}
        }
        #visibility fn move_many<const MOTORS: #krate::generated::usize>(
            instances: &mut [Self],
            motors: &[[#scalar; MOTORS]],
        ) -> #krate::generated::Result<(), #krate::BlockedAt<[#scalar; MOTORS]>> {
            loop {}
        }
        #visibility fn move_toward<const MOTORS: #krate::generated::usize>(&mut self, motors: [#scalar; MOTORS])
            -> #krate::generated::Result<#krate::Reached<[#scalar; MOTORS]>, #krate::Blocked<[#scalar; MOTORS]>>
        {
            loop {}
        }
        #visibility fn poses(&self) -> &[#krate::Pose<#scalar>; #links] {
            loop {}
        }
        #visibility const EXTENT: [[#scalar; 2]; 2] = [[0.0; 2]; 2];
        #visibility fn picture<const W: #krate::generated::usize, const H: #krate::generated::usize>() -> #krate::#picture<{ W }, { H }> {
            loop {}
        }
        #visibility fn draw(&self, canvas: &mut impl #krate::Canvas<#scalar>) {}
        #(
            #visibility fn #names(&self) -> #types {
                loop {}
            }
        )*
        #rates
        #forces
        #at_time
        #clear_traces
        #overlay
        #params
        #joints
    }
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

/// The trait, never run either.
fn implementation(
    krate: &TokenStream,
    header: &Header,
    (scalar, motors): (&TokenStream, &Literal),
    items: &TokenStream,
) -> TokenStream {
    let name = &header.name;
    let text = name.to_string();
    quote! {
            impl #krate::Mechanism for #name {
                type Scalar = #scalar;
                type Motors = [#scalar; #motors];
                const NAME: &'static #krate::generated::str = #text;
                const REPORT: &'static #krate::generated::str = "";
                const COST: #krate::Cost = #krate::Cost::NOTHING;
                const LOOP_COSTS: &'static [#krate::Cost] = &[];
                const MOTORS: &'static [&'static #krate::generated::str] = &[];
                const LINKS: &'static [&'static #krate::generated::str] = &[];
                const SHAPES: &'static [#krate::Shape<#scalar>] = &[];
                const EXTENT: [[#scalar; 2]; 2] = [[0.0; 2]; 2];
                fn new() -> Self {
                    Self {}
                }
                fn motors(&self) -> [#scalar; #motors] {
                    loop {}
                }
                fn move_to(&mut self, motors: [#scalar; #motors]) -> #krate::generated::Result<(), #krate::Blocked<[#scalar; #motors]>> {
                    loop {}
                }
                fn move_toward(&mut self, motors: [#scalar; #motors])
                    -> #krate::generated::Result<#krate::Reached<[#scalar; #motors]>, #krate::Blocked<[#scalar; #motors]>>
                {
                    loop {}
                }
                fn poses(&self) -> &[#krate::Pose<#scalar>] {
                    &[]
                }
                #items
            }
    }
}

/// The method that laws add.
fn at_time(
    krate: &TokenStream,
    visibility: &syn::Visibility,
    has_laws: bool,
    (scalar, motors): (&TokenStream, &Literal),
) -> TokenStream {
    if !has_laws {
        return TokenStream::new();
    }
    quote! {
        #visibility fn at_time(&mut self, t: #krate::generated::f64)
            -> #krate::generated::Result<(), #krate::Blocked<[#scalar; #motors]>>
        {
            loop {}
        }
    }
}

/// The methods that velocities add.
fn rates(
    krate: &TokenStream,
    model: &Model,
    visibility: &syn::Visibility,
    (scalar, links, motors): (&TokenStream, &Literal, &Literal),
) -> TokenStream {
    if !model.effects.velocity {
        return TokenStream::new();
    }
    let (given, second) = if model.effects.acceleration {
        (
            quote!(, accelerations: [#scalar; MOTORS]),
            quote! {
                #visibility fn accelerations(&self) -> &[#krate::Acceleration<#scalar>; #links] {
                    loop {}
                }
            },
        )
    } else {
        (TokenStream::new(), TokenStream::new())
    };
    quote! {
        #visibility fn move_with<const MOTORS: #krate::generated::usize>(&mut self, motors: [#scalar; MOTORS], rates: [#scalar; MOTORS] #given)
            -> #krate::generated::Result<(), #krate::Blocked<[#scalar; MOTORS]>>
        {
            loop {}
        }
        #visibility fn velocities(&self) -> &[#krate::Velocity<#scalar>; #links] {
            loop {}
        }
        #second
        #visibility fn influence_coefficients(&self)
            -> #krate::generated::Result<[[#krate::Velocity<#scalar>; #links]; #motors], #krate::Blocked<[#scalar; #motors]>>
        {
            loop {}
        }
    }
}

/// The methods that read links, points and joints, each once, with what they give.
fn accessors(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    (scalar, motors): (&TokenStream, &Literal),
) -> Vec<(Ident, TokenStream)> {
    let params = Literal::usize_unsuffixed(model.params.len());
    let isometry = quote!(#krate::Isometry2<#scalar>);
    let point = quote!(#krate::Point2<#scalar>);
    let vector = quote!(#krate::Vector2<#scalar>);
    let velocity = quote!(#krate::Velocity<#scalar>);
    let acceleration = quote!(#krate::Acceleration<#scalar>);
    let mut methods: Vec<(Ident, TokenStream)> = Vec::new();
    let mut add = |name: &str, origin, kinds: [TokenStream; 3], rate: &str| {
        let [value, velocity, acceleration] = kinds;
        methods.push((user_ident(name, places, origin), value));
        if model.effects.sensitivity {
            let name = format!("{name}_sensitivity");
            let found = quote!(#krate::generated::Result<[#velocity; #params], #krate::Blocked<[#scalar; #motors]>>);
            methods.push((user_ident(&name, places, origin), found));
        }
        if model.effects.velocity {
            let name = format!("{name}_{rate}");
            methods.push((user_ident(&name, places, origin), velocity));
        }
        if model.effects.acceleration {
            let name = format!("{name}_acceleration");
            methods.push((user_ident(&name, places, origin), acceleration));
        }
    };
    for id in model.declared_links().filter(|&id| model.shows_link(id)) {
        let link = model.link(id);
        let kinds = [isometry.clone(), velocity.clone(), acceleration.clone()];
        add(&link.name, link.origin, kinds, "velocity");
    }
    for (link, name, origin, _) in named_points(model) {
        let kinds = [point.clone(), vector.clone(), vector.clone()];
        let name = format!("{}_{name}", model.link(link).name);
        add(&name, origin, kinds, "velocity");
    }
    let shown = model.joint_ids().filter(|&id| model.shows_joint(id));
    for joint in shown.map(|id| model.joint(id)).filter(|joint| {
        matches!(
            joint.kind,
            JointKind::Revolute(..) | JointKind::Prismatic(..)
        ) && !joint.hidden
    }) {
        let kinds = [scalar.clone(), scalar.clone(), scalar.clone()];
        add(&joint.name, joint.origin, kinds, "rate");
    }
    methods.extend(super::traces::accessors(krate, places, model));
    methods
}
