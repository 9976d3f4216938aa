//! The methods that compute many positions at once.

use super::Parts;
use super::advance::{Target, advance, standstill, strip_params};
use super::emitter::Emitter;
use super::limits::reduced_range;
use super::step::{lanes_module, runs_in_lanes};
use super::tokens::integer;
use crate::model::Precision;
use proc_macro2::TokenStream;
use quote::quote;

/// `solve_many` and `move_many`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, values, links, model, program, .. } = emitter;
    let reduced_range = emitter.number(reduced_range(program, &emitter.compiled.plan));
    // So many numbers fill a few vector registers of any x86-64; with more lanes, registers spill.
    let lanes = integer(match program.precision {
        Precision::F32 => 8,
        Precision::F64 => 4,
    });
    let kernel = kernel(emitter);
    let there = quote!(there);
    let Target { before, value } = Target::new(emitter, &there);
    let advance = strip_params(emitter, advance(emitter, &there, &value));
    let move_all = if emitter.has_params() {
        quote! {
            let each = Iterator::zip(<[Self]>::iter_mut(instances), motors);
            for (index, (instance, motors)) in Iterator::enumerate(each) {
                if let Result::Err(blocked) = Self::move_to(instance, *motors) {
                    return Result::Err(BlockedAt { index, blocked });
                }
            }
            Result::Ok(())
        }
    } else {
        let standstill = standstill(emitter, &quote!(instance));
        let position = if standstill.is_empty() {
            quote!(&mut instance.position)
        } else {
            quote!({ #standstill &mut instance.position })
        };
        let mut function = quote!(generated::move_many);
        let mut then = None;
        if !model.traces.is_empty() {
            function = quote!(generated::move_many_then);
            then = Some(quote!(|instance| Traced::record(instance),));
        }
        quote! {
            #function::<_, _, _, _, _, #lanes>(
                instances,
                motors,
                #reduced_range,
                |instance| #position,
                #kernel,
                #then
                Self::move_to,
            )
        }
    };
    let methods = quote! {
        /// The poses of the links at many values of the motors, each as if it were moved there from where it is. Where
        /// positions depend on nothing but the motors, several are computed at once.
        ///
        /// # Errors
        /// The first that is blocked, or for which there is no room; those before it are in the columns.
        #visibility fn solve_many(
            &self,
            motors: &[#values],
            columns: &mut Columns<'_, #scalar, #links>,
        ) -> Result<(), BlockedAt<#values>> {
            generated::solve_many::<_, _, _, #lanes>(motors, columns, #reduced_range, #kernel, |motors| {
                let mut there = self.position;
                #before
                #advance?;
                Result::Ok(there.poses)
            })
        }

        /// Moves many instances, each to its own values of the motors. Where positions depend on nothing but the motors,
        /// several are computed at once.
        ///
        /// # Errors
        /// The first that is blocked; those before it have moved, those after it have not.
        #visibility fn move_many(
            instances: &mut [Self],
            motors: &[#values],
        ) -> Result<(), BlockedAt<#values>> {
            #move_all
        }
    };
    Parts::methods(methods)
}

/// The closure that computes several positions at once, and the smallest margin of each. Where that is not possible, it returns a
/// negative margin, so each position is computed by itself.
fn kernel(emitter: &Emitter<'_>) -> TokenStream {
    if !runs_in_lanes(emitter.program) {
        return quote!(|_| (known::START.poses, -1.0));
    }
    let module = lanes_module(emitter.program);
    if emitter.program.range.is_some() {
        quote! {
            |motors| {
                let motors = Motors::new(motors);
                let (position, margins) = #module::position::<generated::Reduced>(&known::START, motors);
                let inside = if MoveLimits::contains(&known::MOVE_LIMITS, &motors) { 1.0 } else { -1.0 };
                (position.poses, generated::min_margin([generated::min_margin(margins), inside]))
            }
        }
    } else {
        quote! {
            |motors| {
                let (position, margins) = #module::position::<generated::Reduced>(&known::START, Motors::new(motors));
                (position.poses, generated::min_margin(margins))
            }
        }
    }
}
