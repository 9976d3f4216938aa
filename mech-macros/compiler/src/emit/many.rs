//! Many positions at once.

use super::block::scalar;
use super::params;
use super::scope::number;
use super::step::in_lanes;
use crate::model::Precision;
use crate::plan::{Plan, Step, float_of};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The methods that solve many positions.
pub(super) fn many(
    program: &Program,
    plan: &Plan,
    visibility: &syn::Visibility,
    [standstill, record]: &[TokenStream; 2],
) -> TokenStream {
    let (scalar, step_reduced) = (scalar(program), super::moves::step_reduced(program));
    let [motors, links] =
        [program.motors.len(), program.links.len()].map(Literal::usize_unsuffixed);
    let reduced_range = number(program.precision, reduced_range(program, plan));
    // What the vector unit of any x86-64 holds in a few registers; more lanes spill.
    let lanes = Literal::usize_unsuffixed(match program.precision {
        Precision::F32 => 8,
        Precision::F64 => 4,
    });
    let kernel = if in_lanes(program) && program.range.is_some() {
        quote! {
            |motors| {
                let motors = Motors::new(motors);
                let (position, margins) = positions::position::<generated::Reduced>(&known::START, motors);
                let inside = if MoveLimits::contains(&known::MOVE_LIMITS, &motors) { 1.0 } else { -1.0 };
                (position.poses, generated::min_margin([generated::min_margin(margins), inside]))
            }
        }
    } else if in_lanes(program) {
        quote! {
            |motors| {
                let (position, margins) = positions::position::<generated::Reduced>(&known::START, Motors::new(motors));
                (position.poses, generated::min_margin(margins))
            }
        }
    } else {
        // One by one.
        quote!(|_| (known::START.poses, -1.0))
    };
    let instance = if standstill.is_empty() {
        quote!(&mut instance.position)
    } else {
        quote! {
            {
                #standstill
                &mut instance.position
            }
        }
    };
    let (move_many, then) = if record.is_empty() {
        (quote!(generated::move_many), TokenStream::new())
    } else {
        (
            quote!(generated::move_many_then),
            quote!(|instance| #record,),
        )
    };
    let [target, given] = params::target(program, &quote!(there));
    let one = quote!(generated::advance(&mut there, #target, &known::MOVE_LIMITS, #step_reduced, positions::step));
    let one = params::of_motors(program, one);
    let all = if program.params.is_empty() {
        quote! {
            #move_many::<_, _, _, _, _, #lanes>(
                instances,
                motors,
                #reduced_range,
                |instance| #instance,
                #kernel,
                #then
                Self::move_to,
            )
        }
    } else {
        quote! {
            let each = Iterator::zip(<[Self]>::iter_mut(instances), motors);
            for (index, (instance, motors)) in Iterator::enumerate(each) {
                if let Result::Err(blocked) = Self::move_to(instance, *motors) {
                    return Result::Err(BlockedAt { index, blocked });
                }
            }
            Result::Ok(())
        }
    };
    quote! {
        /// The poses of the links at many values of the motors, each as if it were moved there from where it is. Where
        /// positions depend on nothing but the motors, several are computed at once.
        ///
        /// # Errors
        /// The first that is blocked, or for which there is no room; those before it are in the columns.
        #visibility fn solve_many(
            &self,
            motors: &[[#scalar; #motors]],
            columns: &mut Columns<'_, #scalar, #links>,
        ) -> Result<(), BlockedAt<[#scalar; #motors]>> {
            generated::solve_many::<_, _, _, #lanes>(motors, columns, #reduced_range, #kernel, |motors| {
                let mut there = self.position;
                #given
                #one?;
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
            motors: &[[#scalar; #motors]],
        ) -> Result<(), BlockedAt<[#scalar; #motors]>> {
            #all
        }
    }
}

/// The greatest value of a motor for which all angles are within the range of the polynomials of sine and cosine.
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
    // The rest is for where the meshes begin.
    (0.5 * limit / gain).round()
}
