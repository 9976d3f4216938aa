//! The method that leads a point, and the module of the mechanism in which the point is given.

use super::advance::with_end;
use super::coordinate::coordinate;
use super::emitter::Emitter;
use super::known::start;
use super::limits::limits;
use super::parts::Parts;
use super::step::step;
use super::tokens::{integer, position};
use crate::bug::bug;
use crate::compiled::InverseMechanism;
use crate::model::{Inverse, MotorId};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// `reach`; nothing where motors follow no point.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let (Some(inverse), Some(inverted)) = (&emitter.model.inverse, &emitter.compiled.inverse)
    else {
        return Parts::default();
    };
    let (krate, scalar) = (emitter.krate, emitter.scalar_path());
    let program = &inverted.compiled.program;
    let sizes = [program.inputs(), program.poses.len(), program.state.len()].map(integer);
    Parts {
        fields: quote!(inverse: #krate::generated::Position<#scalar, #(#sizes),*>,),
        start: quote!(inverse: inverse::START,),
        methods: reach(emitter, inverse),
        modules: inverse_module(emitter, inverse, inverted),
        ..Parts::default()
    }
}

fn reach(emitter: &Emitter<'_>, inverse: &Inverse) -> TokenStream {
    let Emitter {
        visibility,
        scalar,
        model,
        ..
    } = emitter;
    let count = count(inverse);
    let motors = inverse.motors.iter();
    let motors: Vec<String> = motors
        .map(|motor| format!("`{}`", motor_name(emitter, *motor)))
        .collect();
    let doc = format!(
        " Leads `{}` to this place on the straight way, and moves {} and everything else after it.",
        inverse.name(model),
        motors.join(", ")
    );
    let unit = if inverse.gives_angle() {
        " The place is x and y in scene units, and the angle of the link in radians: it turns the shorter way."
    } else {
        " The place is x and y in scene units."
    };
    let here = here(emitter, inverse);
    let moved = with_end(emitter, lead());
    quote! {
        #[doc = #doc]
        #[doc = #unit]
        ///
        /// # Errors
        /// If a number is not finite, a loop cannot be closed on the way there, or a motor would leave its range; the mechanism
        /// then stays where it was.
        #visibility fn reach(&mut self, place: [#scalar; #count]) -> Result<(), Blocked<[#scalar; #count]>> {
            let here = #here;
            #moved
        }
    }
}

/// The call that leads the point from the variable `here` to `place`: an expression in a method.
pub(super) fn lead() -> TokenStream {
    quote! {
        inverse::reach(
            Mover {
                position: &mut self.position,
                limits: &known::MOVE_LIMITS,
                step: positions::step,
            },
            &mut self.inverse,
            here,
            place,
        )
    }
}

/// The present value of what is given: an expression in a method.
pub(super) fn here(emitter: &Emitter<'_>, inverse: &Inverse) -> TokenStream {
    let pose = emitter.pose(inverse.link);
    let origin = || quote!([#pose.x, #pose.y]);
    let place = inverse
        .point
        .map_or_else(origin, |point| emitter.point(point));
    if !inverse.gives_angle() {
        return place;
    }
    quote!({
        let [x, y] = #place;
        [x, y, generated::atan2(#pose.sin, #pose.cos)]
    })
}

/// The module of the mechanism in which the point is given.
fn inverse_module(
    emitter: &Emitter<'_>,
    inverse: &Inverse,
    inverted: &InverseMechanism,
) -> TokenStream {
    let other = &emitter.of_inverse(inverted);
    let (krate, scalar, count) = (emitter.krate, &emitter.scalar, count(inverse));
    let [own, all] = [emitter, other].map(|emitter| position(emitter.program));
    let (start, limits, step) = (start(other), limits(other), step(krate, other.program));
    let motors = inverse.motors.iter().map(|motor| integer(motor.index()));
    let turning = inverse.motors.iter().map(|motor| emitter.turns(*motor));
    let given = Inverse::GIVEN.iter().take(inverse.motors.len());
    let given = given.zip([quote!(Sliding), quote!(Sliding), quote!(Turning)]);
    let given = given.map(|(name, kind)| quote!(Input::#kind(#name)));
    let coordinates = inverse.motors.iter().map(|motor| {
        let joint = emitter.model.motor(*motor).joint;
        let Some(coordinate) = coordinate(other, joint) else {
            bug!("a joint with a motor has no coordinate");
        };
        coordinate.value
    });
    let program = emitter.program;
    let size = emitter.number(inverted.model.size());
    let links = integer(emitter.model.declared_links().count());
    let (inputs, watched) = (program.inputs(), program.watches.len());
    let sizes = [inputs, program.poses.len(), program.state.len(), watched].map(integer);
    let inputs = integer(inputs);
    quote! {
        /// The mechanism in which the point is given and motors follow.
        mod inverse {
            #[allow(
                unused_imports,
                clippy::wildcard_imports,
                reason = "which of them a mechanism needs depends on what it is made of",
            )]
            use #krate::generated::{self, *};

            pub(super) const START: #all = #start;

            /// What is given, and in whose place it stands.
            pub(super) const GIVEN: [Input; #count] = [#(#given),*];
            pub(super) const MOTORS: [usize; #count] = [#(#motors),*];

            #limits

            /// Moves both to where the point is at `place`, from where it is `here`.
            pub(super) fn reach(
                mechanism: Mover<'_, #scalar, #(#sizes),*, impl Fn(&#own, Motors<#scalar, #inputs>) -> Result<#own, Stop>>,
                inverse: &mut #all,
                here: [#scalar; #count],
                place: [#scalar; #count],
            ) -> Result<(), Blocked<[#scalar; #count]>> {
                generated::reach(
                    mechanism,
                    Mover { position: inverse, limits: &MOVE_LIMITS, step: positions::step },
                    Led {
                        motors: MOTORS,
                        turning: [#(#turning),*],
                        links: #links,
                        size: #size,
                        given: &GIVEN,
                        here,
                    },
                    place,
                    |at| [#(#coordinates),*],
                )
            }

            #step
        }
    }
}

pub(super) fn count(inverse: &Inverse) -> Literal {
    integer(inverse.motors.len())
}

fn motor_name<'e>(emitter: &'e Emitter<'_>, motor: MotorId) -> &'e str {
    &emitter.model.joint(emitter.model.motor(motor).joint).name
}
