//! The method that leads a point, and the module of the mechanism in which the point is given.

use super::Parts;
use super::advance::with_end;
use super::coordinate::coordinate;
use super::emitter::Emitter;
use super::known::start;
use super::least;
use super::led::{count, given, here, lead};
use super::limits::limits;
use super::step::{laws, step};
use super::tokens::{integer, position};
use crate::bug::bug;
use crate::compiled::InverseMechanism;
use crate::model::{Effects, Inverse, MotorId};
use crate::plan::Step;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// `reach`; nothing where motors follow no point.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Some(inverse) = &emitter.model.inverse else {
        return Parts::default();
    };
    if let (true, Some(moving)) = (inverse.is_least, &emitter.compiled.moving) {
        return Parts {
            methods: reach(emitter, inverse, &least::lead(emitter, inverse, moving)),
            modules: least::module(emitter, inverse),
            ..Parts::default()
        };
    }
    let Some(inverted) = &emitter.compiled.inverse else {
        return Parts::default();
    };
    let (krate, scalar) = (emitter.krate, emitter.scalar_path());
    let program = &inverted.compiled.program;
    let sizes = [program.inputs(), program.poses.len(), program.state.len()].map(integer);
    Parts {
        fields: quote!(inverse: #krate::generated::Position<#scalar, #(#sizes),*>,),
        start: quote!(inverse: inverse::START,),
        methods: {
            let here = here(emitter, inverse);
            let lead = lead();
            let reach = reach(emitter, inverse, &quote!({ let here = #here; #lead }));
            let at_time = at_time(emitter, inverse);
            quote!(#reach #at_time)
        },
        modules: inverse_module(emitter, inverse, inverted),
        ..Parts::default()
    }
}

fn reach(emitter: &Emitter<'_>, inverse: &Inverse, lead: &TokenStream) -> TokenStream {
    let Emitter { visibility, scalar, model, .. } = emitter;
    let count = count(inverse);
    let motors = inverse.motors.iter();
    let motors: Vec<String> =
        motors.map(|motor| format!("`{}`", motor_name(emitter, *motor))).collect();
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
    let moved = with_end(emitter, lead.clone());
    quote! {
        #[doc = #doc]
        #[doc = #unit]
        ///
        /// # Errors
        /// If a number is not finite, a loop cannot be closed on the way there, or a motor would leave its range; the mechanism
        /// then stays where it was.
        #visibility fn reach(&mut self, place: [#scalar; #count]) -> Result<(), Blocked<[#scalar; #count]>> {
            #moved
        }
    }
}

/// The method that leads the point along its path; nothing without one.
fn at_time(emitter: &Emitter<'_>, inverse: &Inverse) -> TokenStream {
    if inverse.trajectory.is_empty() {
        return TokenStream::new();
    }
    let Emitter { visibility, scalar, model, .. } = emitter;
    let laws = inverse.trajectory.iter().map(|law| model.law(*law));
    let laws: Vec<&str> = laws.map(|law| law.written.as_str()).collect();
    let doc = format!(
        " Leads `{}` to where its path has it at a time, and moves everything accordingly: `({})`.",
        inverse.name(model),
        laws.join(", ")
    );
    let (count, here) = (count(inverse), here(emitter, inverse));
    let given = given_in_time(model.effects);
    let lead = if given.len() == 1 { quote!(reach) } else { quote!(reach_with) };
    quote! {
        #[doc = #doc]
        ///
        /// # Errors
        /// If the time, or a law's value or rate at it, is not finite, or the point cannot be led there; the mechanism then stays where
        /// it was.
        #visibility fn at_time(&mut self, t: f64) -> Result<(), Blocked<[#scalar; #count]>> {
            let found = generated::finite([t], &[inverse::GIVEN[0]])
                .and_then(|()| inverse::at_time(self.position.motors, t));
            match found {
                Result::Ok([#(#given),*]) => self.#lead(#(#given),*),
                Result::Err(stop) => {
                    Result::Err(Blocked::of(Blocked::new(stop.place, stop.cause, #here), &inverse::GIVEN))
                }
            }
        }
    }
}

/// The names of what a path gives at a time, as far as effects ask for it.
fn given_in_time(effects: Effects) -> Vec<Ident> {
    let all =
        [("place", true), ("velocity", effects.velocity), ("acceleration", effects.acceleration)];
    let all = all.into_iter().filter(|(_, is_asked)| *is_asked);
    all.map(|(name, _)| format_ident!("{name}")).collect()
}

/// The function that gives what is given at a time, in the module of the inverse, and the laws that it calls; nothing without a path.
fn trajectory(emitter: &Emitter<'_>, inverse: &Inverse, other: &Emitter<'_>) -> TokenStream {
    let Some(timing) = &other.compiled.timing else {
        return TokenStream::new();
    };
    let laws = laws(other, timing);
    let (scalar, count, given) =
        (&emitter.scalar, count(inverse), given_in_time(emitter.model.effects));
    let (inputs, numbers) = (integer(other.program.inputs()), integer(given.len()));
    let motors = inverse.motors.iter().map(|motor| integer(motor.index()));
    let chosen = quote!([#(all[#motors]),*]);
    let others = given.iter().skip(1);
    quote! {
        #laws

        /// The place of the point at a time, and its rates as far as effects ask for them.
        pub(super) fn at_time(motors: Motors<#scalar, #inputs>, t: f64) -> Result<[[#scalar; #count]; #numbers], Stop> {
            let (motors #(, #others)*) = laws::laws(motors, t)?;
            let place = motors.total();
            Ok([#({ let all = #given; #chosen }),*])
        }
    }
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
    let given = given(inverse);
    let coordinates = inverse.motors.iter().map(|motor| {
        let joint = emitter.model.motor(*motor).joint;
        let Some(coordinate) = coordinate(other, joint) else {
            bug!("a joint with a motor has no coordinate");
        };
        coordinate.value
    });
    let trajectory = trajectory(emitter, inverse, other);
    let program = emitter.program;
    let size = emitter.number(inverted.model.size());
    let links = emitter.model.declared_links().count();
    // Whoever rolls counts whole turns, of which the inverse has its own count.
    let is_rigid = |step: &Step| matches!(step, Step::Weld(_) | Step::Drive(_) | Step::Close(_));
    let direct = program.poses.len() == links
        && program.turns_with_links()
        && emitter.compiled.plan.steps.iter().all(is_rigid);
    let links = integer(links);
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
            pub(super) const GIVEN: [Input; #count] = #given;
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
                        direct: #direct,
                    },
                    place,
                    |at| [#(#coordinates),*],
                )
            }

            #step

            #trajectory
        }
    }
}

fn motor_name<'e>(emitter: &'e Emitter<'_>, motor: MotorId) -> &'e str {
    &emitter.model.joint(emitter.model.motor(motor).joint).name
}
