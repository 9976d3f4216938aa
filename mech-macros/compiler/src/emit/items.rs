//! The struct and its methods.

use super::added::Added;
use super::block::scalar;
use super::coordinate::coordinate;
use super::costs::costs;
use super::effects;
use super::joints;
use super::known::known;
use super::many::many;
use super::moves::{step_reduced, turn_to, within};
use super::params;
use super::step::step;
use super::traces::painting;
use crate::compiled::Compiled;
use crate::model::{AxisId, LinkId, Model, Origin, Quality};
use crate::plan::Plan;
use crate::program::Program;
use crate::syntax::{Header, Places};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Everything that a coherent mechanism becomes.
pub(crate) fn items(
    krate: &TokenStream,
    header: &Header,
    places: &Places,
    model: &Model,
    compiled: &Compiled,
) -> TokenStream {
    let Compiled {
        plan,
        program,
        report,
        ..
    } = compiled;
    let (attributes, visibility, name) = (&header.attributes, &header.visibility, &header.name);
    let scalar = scalar(program);
    let sizes =
        [program.inputs(), program.poses.len(), program.state.len()].map(Literal::usize_unsuffixed);
    let doc = format!("\n```text\n{report}```");
    let step = step(krate, program);
    let accessors = accessors(places, model, (plan, program), visibility);
    let Added {
        fields,
        at_rest,
        standstill,
        instance_standstill,
        record,
        instance_record,
        known: more_known,
        methods: more_methods,
        trait_methods,
        records,
        steps: more_steps,
    } = effects::added(krate, places, model, compiled, visibility)
        .and(joints::added(model, plan, program, visibility));
    let end = quote!(#standstill #record);
    let (costs, associated_costs) = costs(program, visibility);
    let known = known(krate, model, compiled, &quote!(#costs #more_known));
    let before_constants = before_constants(krate);
    let seen = seen(
        model,
        program,
        visibility,
        &painting(places, model, program),
    );
    let instance_end = [instance_standstill, instance_record];
    let moves = all_moves(model, (plan, program), visibility, (&end, &instance_end));
    let this = alias(name);
    let implementation = implementation(program, name, &trait_methods);
    let recording = recording(&this, &records);
    quote! {
        #(#attributes)*
        #[doc = #doc]
        #[derive(
            #krate::generated::Clone, #krate::generated::Copy, #krate::generated::Debug, #krate::generated::PartialEq,
        )]
        #visibility struct #name {
            position: #krate::generated::Position<#krate::generated::#scalar, #(#sizes),*>,
            #fields
        }

        const _: () = {
            // Under this name, because what is imported below may be called as the struct is.
            type #this = #name;

            #[allow(
                clippy::approx_constant,
                clippy::excessive_precision,
                clippy::inline_always,
                clippy::neg_multiply,
                clippy::suboptimal_flops,
                clippy::unreadable_literal,
                reason = "numbers were computed, and fused operations would not give the same bits on every machine"
            )]
            const _: () = {
            #[allow(
                unused_imports,
                clippy::wildcard_imports,
                reason = "which of them a mechanism needs depends on what it is made of",
            )]
            use #krate::generated::{self, *};
            #before_constants

            #known

            #[allow(dead_code, reason = "nobody has to ask for every link, point and joint")]
            impl #this {
                /// Mobility, trunk and arms, and the loops in the order in which they are solved.
                #visibility const REPORT: &'static str = known::REPORT;

                #associated_costs

                /// The mechanism as it was assembled at compile time.
                #[must_use]
                #visibility const fn new() -> Self {
                    Self { position: known::START, #at_rest }
                }

                #(#moves)*

                #more_methods

                #seen

                #accessors
            }

            impl Default for #this {
                fn default() -> Self {
                    Self::new()
                }
            }

            #implementation

            #recording

            #step

            #more_steps
            };
        };
    }
}

/// The methods that tell and paint where everything is.
fn seen(
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
    painting: &TokenStream,
) -> TokenStream {
    let scalar = scalar(program);
    let links = Literal::usize_unsuffixed(program.poses.len());
    let [picture, doc] = picture(model);
    quote! {
                /// The smallest upright box around all that is seen, wherever its motors move it: lower left and upper right
                /// corner, in scene units.
                #visibility const EXTENT: [[#scalar; 2]; 2] = known::EXTENT;

                #doc
                #[must_use]
                #visibility fn picture<const W: usize, const H: usize>() -> #picture<{ W }, { H }> {
                    let mut picture = #picture::new();
                    #picture::look_at(&mut picture, <Self as Mechanism>::view(W, H));
                    picture
                }

                /// The poses of the moving links in the scene, in the order of their declaration.
                #[must_use]
                #visibility const fn poses(&self) -> &[Pose<#scalar>; #links] {
                    &self.position.poses
                }

                /// Paints every shape, from the plane farthest from the eye to the nearest.
                #visibility fn draw(&self, canvas: &mut impl Canvas<#scalar>) {
                    #painting
                }
    }
}

/// The type of the pictures that it makes for itself, and what is said of them.
pub(super) fn picture(model: &Model) -> [TokenStream; 2] {
    match model.quality {
        Quality::Hard => [
            quote!(Frame),
            quote! {
                /// An empty picture that looks at all of it, wherever its motors move it.
                ///
                /// It takes `W` × `H` bytes on the stack, and 768 for its palette. For a large picture, which would overflow
                /// the stack, `mech_runtime::HeapFrame::of` makes the same on the heap, with feature `std`.
            },
        ],
        Quality::Smooth => [
            quote!(Smooth),
            quote! {
                /// An empty picture with soft edges that looks at all of it, wherever its motors move it.
                ///
                /// It takes 4 × `W` × (`H` + 16) bytes on the stack, and 2 KiB besides. For a large picture, which would overflow
                /// the stack, `mech_runtime::HeapSmooth::of` makes the same on the heap, with feature `std`.
            },
        ],
    }
}

/// The methods that tell and set the values of its motors.
fn moves(program: &Program, visibility: &syn::Visibility, standstill: &TokenStream) -> TokenStream {
    let (scalar, step_reduced) = (scalar(program), step_reduced(program));
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let [target, given] = params::target(program, &quote!(self.position));
    let move_to = quote!(generated::advance(&mut self.position, #target, &known::MOVE_LIMITS, #step_reduced, positions::step));
    let move_to = ending_with(params::of_motors(program, move_to), standstill);
    let mut move_toward = quote!(generated::approach(&mut self.position, #target, &known::MOVE_LIMITS, positions::step));
    if !program.params.is_empty() {
        move_toward.extend(quote!(.map(generated::reached_by_motors)));
    }
    let move_toward = ending_with(params::of_motors(program, move_toward), standstill);
    let values = params::motors(program);
    quote! {
                /// The present values of the motors, in the order of their declaration, in radians or scene units.
                #[must_use]
                #visibility fn motors(&self) -> [#scalar; #motors] {
                    #values
                }

                /// Gives the motors these values, in the order of their declaration, in radians or scene units, and moves
                /// everything accordingly.
                ///
                /// # Errors
                /// If a value is not finite or a loop cannot be closed on the way there; the mechanism then stays where it was.
                #[inline]
                #visibility fn move_to(&mut self, motors: [#scalar; #motors]) -> Result<(), Blocked<[#scalar; #motors]>> {
                    #given
                    #move_to
                }

                /// Moves towards these values of the motors, in radians or scene units, on the straight way from the present
                /// ones, as far as it can.
                ///
                /// # Errors
                /// If a value is not finite; the mechanism then stays where it was.
                #visibility fn move_toward(&mut self, motors: [#scalar; #motors])
                    -> Result<Reached<[#scalar; #motors]>, Blocked<[#scalar; #motors]>>
                {
                    #given
                    #move_toward
                }

    }
}

/// All methods that move: each ends with what `end` does; moves of many instances end with what the two others do.
fn all_moves(
    model: &Model,
    (plan, program): (&Plan, &Program),
    visibility: &syn::Visibility,
    (end, instance_end): (&TokenStream, &[TokenStream; 2]),
) -> [TokenStream; 4] {
    [
        moves(program, visibility, end),
        turn_to(model, program, visibility, end),
        within(program, visibility, end),
        many(program, plan, visibility, instance_end),
    ]
}

/// A move, and what it ends with: everything rests, if there are rates; points are traced.
pub(super) fn ending_with(moved: TokenStream, standstill: &TokenStream) -> TokenStream {
    if standstill.is_empty() {
        return moved;
    }
    quote! {
        let moved = #moved?;
        #standstill
        Result::Ok(moved)
    }
}

/// What the struct is called in the generated code.
fn alias(name: &Ident) -> Ident {
    format_ident!(
        "{}",
        if name == "ThisMechanism" {
            "TheMechanism"
        } else {
            "ThisMechanism"
        }
    )
}

/// The functions that let parameters be called as constants of the user's are. A parameter may stand before a function of its name,
/// but where there is a constant, a static, a unit struct or a variant of its name, it would mean that.
fn before_constants(krate: &TokenStream) -> TokenStream {
    quote! {
        #[allow(unused_imports, clippy::wildcard_imports, reason = "parameters stand before these functions, where constants would stand before parameters")]
        use #krate::generated::parameters::*;
    }
}

/// How a mechanism notes where the points are that it traces, if it does.
fn recording(this: &Ident, records: &TokenStream) -> Option<TokenStream> {
    (!records.is_empty()).then(|| {
        quote! {
            impl Traced for #this {
                #[inline]
                fn record(&mut self) {
                    #records
                }
            }
        }
    })
}

/// The trait, by way of the inherent methods.
fn implementation(program: &Program, name: &Ident, trait_methods: &TokenStream) -> TokenStream {
    let scalar = scalar(program);
    let (motor_names, link_names) = (&program.motors, &program.links);
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let (text, this) = (name.to_string(), alias(name));
    quote! {
            impl Mechanism for #this {
                type Scalar = #scalar;
                type Motors = [#scalar; #motors];
                const NAME: &'static str = #text;
                const REPORT: &'static str = known::REPORT;
                const COST: Cost = known::COST;
                const LOOP_COSTS: &'static [Cost] = &known::LOOP_COSTS;
                const MOTORS: &'static [&'static str] = &[#(#motor_names),*];
                const LINKS: &'static [&'static str] = &[#(#link_names),*];
                const SHAPES: &'static [Shape<#scalar>] = known::SHAPES;
                const EXTENT: [[#scalar; 2]; 2] = known::EXTENT;

                fn new() -> Self {
                    Self::new()
                }

                fn motors(&self) -> [#scalar; #motors] {
                    Self::motors(self)
                }

                fn move_to(&mut self, motors: [#scalar; #motors]) -> Result<(), Blocked<[#scalar; #motors]>> {
                    Self::move_to(self, motors)
                }

                fn move_toward(&mut self, motors: [#scalar; #motors])
                    -> Result<Reached<[#scalar; #motors]>, Blocked<[#scalar; #motors]>>
                {
                    Self::move_toward(self, motors)
                }

                fn poses(&self) -> &[Pose<#scalar>] {
                    Self::poses(self)
                }

                #trait_methods
            }
    }
}

/// An identifier that stands where the user wrote it.
pub(super) fn user_ident(name: &str, places: &Places, origin: Origin) -> Ident {
    let mut ident = format_ident!("{}", name);
    ident.set_span(places.get(origin).start);
    ident
}

/// A method for each link, named point and joint that is shown.
fn accessors(
    places: &Places,
    model: &Model,
    (plan, program): (&Plan, &Program),
    visibility: &syn::Visibility,
) -> TokenStream {
    let scalar = scalar(program);
    let mut tokens = TokenStream::new();
    for id in model.declared_links().filter(|&id| model.shows_link(id)) {
        let link = model.link(id);
        let name = user_ident(&link.name, places, link.origin);
        let pose = pose(program, id);
        let doc = format!(" The pose of link `{}` in the scene.", link.name);
        tokens.extend(quote! {
            #[doc = #doc]
            #[must_use]
            #visibility fn #name(&self) -> Isometry2<#scalar> {
                #pose.isometry()
            }
        });
    }
    for (link, point, origin, axis) in named_points(model) {
        let name = user_ident(
            &format!("{}_{point}", model.link(link).name),
            places,
            origin,
        );
        let at = params::place(model, program, axis);
        let pose = pose(program, link);
        let doc = format!(
            " Point `{point}` of link `{}`, in the scene.",
            model.link(link).name
        );
        tokens.extend(quote! {
            #[doc = #doc]
            #[must_use]
            #visibility fn #name(&self) -> Point2<#scalar> {
                let [x, y] = #pose.apply(#at);
                Point2::new(x, y)
            }
        });
    }
    for joint in model.joint_ids().filter(|&id| model.shows_joint(id)) {
        if let Some((measure, value)) = coordinate(model, plan, program, joint) {
            let joint = model.joint(joint);
            let name = user_ident(&joint.name, places, joint.origin);
            let doc = format!(
                " The coordinate of joint `{}`, in {}.",
                joint.name,
                measure.unit()
            );
            tokens.extend(quote! {
                #[doc = #doc]
                #[must_use]
                #visibility fn #name(&self) -> #scalar {
                    #value
                }
            });
        }
    }
    tokens
}

/// The named points of the moving links that are shown: link, name, place, and which axis it is.
pub(super) fn named_points(model: &Model) -> impl Iterator<Item = (LinkId, &str, Origin, AxisId)> {
    model.shown_points().filter_map(|id| {
        let axis = model.axis(id);
        Some((axis.link, axis.name.as_deref()?, axis.origin, id))
    })
}

/// The expression of the pose of a link, which is kept unless it is the ground.
pub(super) fn pose(program: &Program, link: LinkId) -> TokenStream {
    match program.place_of(link) {
        None => quote!(Pose::identity()),
        Some(index) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(self.position.poses[#index])
        }
    }
}
