//! What the struct of a mechanism has more if velocities were asked for.

use super::added::Added;
use super::block::scalar;
use super::coordinate::coordinate_axes;
use super::costs::more;
use super::items::{named_points, pose, user_ident};
use super::motion::given;
use super::moves::{advance_with, step_full};
use super::params;
use super::scope::number;
use super::step::step;
use crate::compiled::Compiled;
use crate::model::{AxisId, Effects, LinkId, Model};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// What there is of rates.
struct Kinds<'p> {
    program: &'p Program,
    scalar: TokenStream,
    links: Literal,
    count: Literal,
    second: bool,
    effects: Effects,
}

/// What velocities add to a mechanism.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    compiled: &Compiled,
    visibility: &syn::Visibility,
    record: &TokenStream,
) -> Added {
    let program = &compiled.program;
    let Some(moving) = &compiled.moving else {
        return Added::default();
    };
    let kinds = Kinds {
        program,
        scalar: scalar(program),
        links: Literal::usize_unsuffixed(program.links.len()),
        count: Literal::usize_unsuffixed(program.motors.len()),
        second: model.effects.acceleration,
        effects: model.effects,
    };
    let Kinds { scalar, links, .. } = &kinds;
    let mut items = Added {
        fields: quote!(velocities: [#krate::Velocity<#krate::generated::#scalar>; #links],),
        at_rest: quote!(velocities: [Velocity::ZERO; #links],),
        standstill: quote!(self.velocities = [Velocity::ZERO; #links];),
        instance_standstill: quote!(instance.velocities = [Velocity::ZERO; #links];),
        methods: methods(moving, &kinds, visibility, record),
        steps: step(krate, moving),
        ..Added::default()
    };
    if kinds.second {
        let zero = quote!([Acceleration::ZERO; #links]);
        items.fields.extend(
            quote!(accelerations: [#krate::Acceleration<#krate::generated::#scalar>; #links],),
        );
        items.at_rest.extend(quote!(accelerations: #zero,));
        items.standstill.extend(quote!(self.accelerations = #zero;));
        items
            .instance_standstill
            .extend(quote!(instance.accelerations = #zero;));
    }
    let what = "the rates of everything";
    items
        .methods
        .extend(more((program, moving), "RATES_COST", what, visibility));
    items
        .methods
        .extend(accessors(places, model, &kinds, visibility));
    items
}

/// The statements that move it to these motors at the rates that are given.
pub(super) fn moved_with(
    moving: &Program,
    effects: Effects,
    motors: &TokenStream,
    record: &TokenStream,
) -> TokenStream {
    let second = effects.acceleration;
    let [_, arguments] = given(moving);
    let checked = if second {
        quote!([rates, accelerations])
    } else {
        quote!([rates])
    };
    let pattern = if second {
        quote!((velocities, accelerations))
    } else {
        quote!(velocities)
    };
    let keep_second = second.then(|| quote!(self.accelerations = accelerations;));
    let keep_rates = effects.dynamics.then(|| quote!(self.rates = rates;));
    let refused = params::refused(moving);
    let moved = params::of_motors(
        moving,
        advance_with(moving, &quote!(&mut self.position), motors, &arguments),
    );
    quote! {
        for rates in #checked {
            if let Result::Err(stop) = generated::finite(rates, known::MOVE_LIMITS.inputs) {
                return Result::Err(#refused);
            }
        }
        let #pattern = #moved?;
        self.velocities = velocities;
        #keep_second
        #keep_rates
        #record
        Result::Ok(())
    }
}

/// The methods that move it with rates.
fn methods(
    moving: &Program,
    kinds: &Kinds<'_>,
    visibility: &syn::Visibility,
    record: &TokenStream,
) -> TokenStream {
    let Kinds {
        scalar,
        links,
        count,
        second,
        ..
    } = kinds;
    let [parameters, _] = given(moving);
    let [target, given_motors] = params::target(moving, &quote!(self.position));
    let moved = moved_with(moving, kinds.effects, &target, record);
    let (refused, step_full) = (params::refused(moving), step_full(moving));
    let still = second.then(|| quote!(, [0.0; #count]));
    let first = if *second { quote!(.0) } else { quote!() };
    let accelerations = second.then(|| {
        quote! {
            /// The accelerations of the moving links in the scene, in the order of their declaration.
            #[must_use]
            #visibility const fn accelerations(&self) -> &[Acceleration<#scalar>; #links] {
                &self.accelerations
            }
        }
    });
    let sums = if *second {
        "Gives the motors these values, rates and second rates"
    } else {
        "Gives the motors these values and rates"
    };
    let doc = format!(
        " {sums}, in the order of their declaration, in radians or scene units and units of time, and moves everything accordingly."
    );
    quote! {
        #[doc = #doc]
        /// After a move without rates it rests.
        ///
        /// # Errors
        /// If a value is not finite, a loop cannot be closed on the way there, or it is at a dead point or a change point there,
        /// where rates are not determined; the mechanism then stays where it was.
        #[inline]
        #visibility fn move_with(&mut self, motors: [#scalar; #count] #parameters)
            -> Result<(), Blocked<[#scalar; #count]>>
        {
            #given_motors
            #moved
        }

        /// The velocities of the moving links in the scene, in the order of their declaration.
        #[must_use]
        #visibility const fn velocities(&self) -> &[Velocity<#scalar>; #links] {
            &self.velocities
        }

        #accelerations

        /// The influence coefficients: for each motor, the velocities of the moving links if it alone moves, at a rate of one.
        ///
        /// # Errors
        /// If the mechanism is at a dead point or a change point, where these are not determined.
        #visibility fn influence_coefficients(&self)
            -> Result<[[Velocity<#scalar>; #links]; #count], Blocked<[#scalar; #count]>>
        {
            let mut influence_coefficients = [[Velocity::ZERO; #links]; #count];
            for (motor, influence) in Iterator::enumerate(<[_]>::iter_mut(&mut influence_coefficients)) {
                let mut rates = [0.0; #count];
                rates[motor] = 1.0;
                let found = generated::rates_at(&self.position, |last, motors| #step_full(last, motors, rates #still));
                match found {
                    Result::Ok(found) => *influence = found #first,
                    Result::Err(stop) => return Result::Err(#refused),
                }
            }
            Result::Ok(influence_coefficients)
        }
    }
}

/// The methods that tell the rates of links, points and joints.
fn accessors(
    places: &Places,
    model: &Model,
    kinds: &Kinds<'_>,
    visibility: &syn::Visibility,
) -> TokenStream {
    let mut tokens = TokenStream::new();
    let scalar = &kinds.scalar;
    for id in model.declared_links().filter(|&id| model.shows_link(id)) {
        let (link, index) = (model.link(id), index(kinds.program, id));
        let name = &link.name;
        let mut add = |what: &str, kind: TokenStream, rates: Ident| {
            let method = user_ident(&format!("{name}_{what}"), places, link.origin);
            let doc = format!(" The {what} of link `{name}` in the scene.");
            tokens.extend(quote! {
                #[doc = #doc]
                #[must_use]
                #visibility const fn #method(&self) -> #kind<#scalar> {
                    self.#rates[#index]
                }
            });
        };
        add("velocity", quote!(Velocity), format_ident!("velocities"));
        if kinds.second {
            add(
                "acceleration",
                quote!(Acceleration),
                format_ident!("accelerations"),
            );
        }
    }
    for (id, point, origin, axis) in named_points(model) {
        let (name, index) = (&model.link(id).name, index(kinds.program, id));
        let pose = pose(kinds.program, id);
        let at = params::place(model, kinds.program, axis);
        let mut add = |what: &str, value: TokenStream| {
            let method = user_ident(&format!("{name}_{point}_{what}"), places, origin);
            let doc = format!(" The {what} of point `{point}` of link `{name}` in the scene.");
            tokens.extend(quote! {
                #[doc = #doc]
                #[must_use]
                #visibility fn #method(&self) -> Vector2<#scalar> {
                    let [x, y] = #value;
                    Vector2::new(x, y)
                }
            });
        };
        add(
            "velocity",
            quote!(self.velocities[#index].of_point(#pose, #at)),
        );
        if kinds.second {
            let value = quote! {
                self.accelerations[#index].of_point(#pose, self.velocities[#index].angular, #at)
            };
            add("acceleration", value);
        }
    }
    for joint in model.joint_ids().filter(|&id| model.shows_joint(id)) {
        // A motor's coordinate is told without its links.
        let is_kept = |axis: AxisId| {
            let link = model.axis(axis).link;
            link == LinkId::GROUND || kinds.program.place_of(link).is_some()
        };
        let axes = coordinate_axes(model, joint).filter(|(_, a, b)| is_kept(*a) && is_kept(*b));
        let Some(axes) = axes else {
            continue;
        };
        let (name, origin) = (&model.joint(joint).name, model.joint(joint).origin);
        let mut add = |what: &str, title: &str, second: bool| {
            let method = user_ident(&format!("{name}_{what}"), places, origin);
            let doc = format!(" The {title} of the coordinate of joint `{name}`.");
            let value = joint_rate(model, kinds.program, axes, second);
            tokens.extend(quote! {
                #[doc = #doc]
                #[must_use]
                #visibility fn #method(&self) -> #scalar {
                    #value
                }
            });
        };
        add("rate", "rate", false);
        if kinds.second {
            add("acceleration", "second rate", true);
        }
    }
    tokens
}

/// The first or second rate of a joint's coordinate.
fn joint_rate(
    model: &Model,
    program: &Program,
    (turns, from, to): (bool, AxisId, AxisId),
    second: bool,
) -> TokenStream {
    let link = |axis: AxisId| model.axis(axis).link;
    let field = if second {
        quote!(accelerations)
    } else {
        quote!(velocities)
    };
    if turns {
        let angular = |id: LinkId| {
            if id == LinkId::GROUND {
                return quote!(0.0);
            }
            let index = index(program, id);
            quote!(self.#field[#index].angular)
        };
        let (from, to) = (angular(link(from)), angular(link(to)));
        return quote!(#to - #from);
    }
    let end = |end: AxisId| {
        let id = link(end);
        let (axis, pose) = (model.axis(end), pose(program, id));
        let at = params::place(model, program, end);
        let [along, across] = axis.direction.map(|value| number(model.precision, value));
        let (velocity, acceleration) = if id == LinkId::GROUND {
            (quote!(Velocity::ZERO), quote!(Acceleration::ZERO))
        } else {
            let index = index(program, id);
            (
                quote!(self.velocities[#index]),
                quote!(self.accelerations[#index]),
            )
        };
        let rates = if second {
            quote!((#velocity, #acceleration))
        } else {
            velocity
        };
        quote!((#pose, #at, [#along, #across]), #rates)
    };
    let function = if second {
        quote!(generated::slide_acceleration)
    } else {
        quote!(generated::slide_rate)
    };
    let (from, to) = (end(from), end(to));
    quote!(#function(#from, #to))
}

/// Where the rates of a link are kept.
fn index(program: &Program, link: LinkId) -> Literal {
    Literal::usize_unsuffixed(program.pose_index(link))
}
