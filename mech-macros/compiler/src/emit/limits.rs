//! The limits of every move.

use super::emitter::Emitter;
use super::step::takes_sines;
use super::tokens::{integer, option};
use crate::bug::bug;
use crate::model::Precision;
use crate::plan::{Plan, Step, float_of};
use crate::program::{self, Program};
use mech_core::journey::Growth;
use proc_macro2::TokenStream;
use quote::quote;

/// The constant `MOVE_LIMITS`.
pub(super) fn limits(emitter: &Emitter<'_>) -> TokenStream {
    let (program, scalar) = (emitter.program, &emitter.scalar);
    let n = |value: f64| emitter.number(value);
    let inputs: Vec<TokenStream> = inputs(emitter).collect();
    let watched = program.watches.iter().map(|watch| {
        let [sine, rounding_square] = [watch.sine, watch.rounding_square].map(integer);
        let rates = watch.rates.iter().copied().map(n);
        let (iterated, guessed) = (watch.iterated, watch.guessed);
        let at_zero = match watch.at_zero {
            program::AtZero::Stay => quote!(AtZero::Stay),
            program::AtZero::ChangeBranch => quote!(AtZero::ChangeBranch),
            program::AtZero::Stop => quote!(AtZero::Stop),
        };
        let closed = program.closed_form(watch.block).map(|closed| &closed.place);
        let newton = program.newton(watch.block).map(|newton| &newton.place);
        let Some(place) = closed.or(newton) else {
            bug!("a block is watched that closes no loop");
        };
        let growth = growth(emitter, &watch.growth);
        quote! {
            Watched {
                sine: #sine,
                rounding_square: #rounding_square,
                rates: [#(#rates),*],
                growth: #growth,
                guessed: #guessed,
                at_zero: #at_zero,
                iterated: #iterated,
                place: #place,
            }
        }
    });
    let follows = program.follows.iter().map(|follow| {
        let rates = follow.rates.iter().copied().map(n);
        let growth = growth(emitter, &follow.growth);
        let (angle, guessed) = (integer(follow.angle), follow.guessed);
        quote!(Followed { angle: #angle, rates: [#(#rates),*], growth: #growth, guessed: #guessed })
    });
    let motion_signs = option(program.layout.motion_signs.map(|first| {
        let first = integer(first);
        quote!(#first)
    }));
    let overflows = program.overflows;
    let stepping = if program.is_function() {
        quote!(Stepping::Afresh)
    } else if program.subdivides() {
        quote!(Stepping::Subdivided)
    } else {
        quote!(Stepping::Onwards)
    };
    let reduced_range = if takes_sines(program) {
        n(reduced_range(program, &emitter.compiled.plan))
    } else {
        quote!(#scalar::MAX)
    };
    let max_steps = option(program.max_steps.as_ref().map(|max_steps| {
        let max_steps = max_steps.iter().copied().map(n);
        quote!([#(#max_steps),*])
    }));
    let range = option(program.range.as_ref().map(|range| {
        let ends = range.iter().map(|ends| {
            let [low, high] = ends.map(|end| range_end(emitter, end));
            quote!([#low, #high])
        });
        quote!([#(#ends),*])
    }));
    let [motors, loops] = [inputs.len(), program.watches.len()].map(integer);
    quote! {
        pub(super) const MOVE_LIMITS: MoveLimits<#scalar, #motors, #loops> = MoveLimits {
            inputs: &[#(#inputs),*],
            watched: [#(#watched),*],
            follows: &[#(#follows),*],
            motion_signs: #motion_signs,
            stepping: #stepping,
            overflows: #overflows,
            reduced_range: #reduced_range,
            max_steps: #max_steps,
            range: #range,
        };
    }
}

/// The inputs of a move: the motors, and after them the params.
fn inputs(emitter: &Emitter<'_>) -> impl Iterator<Item = TokenStream> {
    let program = emitter.program;
    let motors = emitter.model.motor_ids().zip(&program.motors);
    let motors = motors.map(|(motor, name)| {
        if emitter.turns(motor) {
            quote!(Input::Turning(#name))
        } else {
            quote!(Input::Sliding(#name))
        }
    });
    let params = program.params.iter();
    motors.chain(params.map(|name| quote!(Input::Param(#name))))
}

/// The conditions under which something changes faster, as a slice.
fn growth(emitter: &Emitter<'_>, growth: &[Growth<f64>]) -> TokenStream {
    let growth = growth.iter().map(|growth| match *growth {
        Growth::Near(index) => {
            let index = integer(index);
            quote!(Growth::Near(#index))
        }
        Growth::Far(input, unit) => {
            let (input, unit) = (integer(input), emitter.number(unit));
            quote!(Growth::Far(#input, #unit))
        }
    });
    quote!(&[#(#growth),*])
}

/// An end of a range: infinite for a motor without a range.
fn range_end(emitter: &Emitter<'_>, end: f64) -> TokenStream {
    let scalar = &emitter.scalar;
    if end == f64::INFINITY {
        quote!(#scalar::INFINITY)
    } else if end == f64::NEG_INFINITY {
        quote!(#scalar::NEG_INFINITY)
    } else {
        emitter.number(end)
    }
}

/// The largest value of a motor for which all angles are within the range of the polynomials of sine and cosine.
pub(super) fn reduced_range(program: &Program, plan: &Plan) -> f64 {
    let meshes = plan.steps.iter().filter_map(|step| match step {
        Step::Mesh(mesh) => Some(mesh),
        _ => None,
    });
    let gains = meshes.map(|mesh| {
        let parts = mesh.parts.iter();
        parts.map(|(_, part)| float_of(part).abs()).sum()
    });
    let gain = gains.fold(1.0, f64::max);
    let limit = match program.precision {
        Precision::F32 => f64::from(mech_core::trig::LIMIT_F32),
        Precision::F64 => mech_core::trig::LIMIT_F64,
    };
    // The other half is for the angles at which the meshes begin.
    (0.5 * limit / gain).round()
}
