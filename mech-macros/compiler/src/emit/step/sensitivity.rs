//! The functions that compute how everything changes with the params.

use super::functions::StepParts;
use super::inputs::step_parameters;
use super::outcome::rates_of_links;
use super::scope::Scope;
use super::sines::type_parameter;
use crate::emit::tokens::{integer, position, scalar};
use crate::program::{Program, Sensitivity};
use proc_macro2::TokenStream;
use quote::quote;

/// The function `sensitivity`, and the one that it calls.
pub(super) fn sensitivity_functions(
    sensitivity: &Sensitivity,
    parts: &StepParts<'_>,
    scope: &Scope<'_>,
) -> TokenStream {
    let StepParts { statements, margins, rate_margins, .. } = parts;
    let program = scope.program;
    let (position, parameters) = (position(program), step_parameters(&parts.last, program));
    let (kind, rates) = (rates_type(program, sensitivity), rates(sensitivity, scope));
    let closes =
        (program.is_closed() && !margins.is_empty()).then(|| margins.check_here(&quote!(closes)));
    let determined =
        (!rate_margins.is_empty()).then(|| rate_margins.check_here(&quote!(determined)));
    let [sines, full_range] = type_parameter(program);
    quote! {
        /// For each param, the rates of all links, of points and of joints if it alone changes, where it is.
        #[inline]
        fn rates_by_params #sines(#parameters) -> Result<#kind, Stop> {
            #statements
            #closes
            #determined
            Ok(#rates)
        }

        /// The same, if all of it is finite.
        #[inline]
        pub(super) fn sensitivity(position: &#position) -> Result<#kind, Stop> {
            followed(position, rates_by_params #full_range)
        }
    }
}

/// For each param the rates of links, points and joints for a unit rate of the param alone.
fn rates(sensitivity: &Sensitivity, scope: &Scope<'_>) -> TokenStream {
    let of_params = sensitivity.of_params.iter().map(|rates| {
        let links = rates_of_links(&quote!(Velocity), &rates.links, scope);
        let points = rates.points.iter().map(|point| {
            let [x, y] = point.map(|rate| scope.expression(rate));
            quote!([#x, #y])
        });
        let joints = scope.expressions(&rates.joints);
        quote!((#links, [#(#points),*], [#(#joints),*]))
    });
    quote!([#(#of_params),*])
}

fn rates_type(program: &Program, sensitivity: &Sensitivity) -> TokenStream {
    let scalar = scalar(program.precision);
    let [links, points, joints, params] = [
        program.links.len(),
        sensitivity.points.len(),
        sensitivity.joints.len(),
        program.params.len(),
    ]
    .map(integer);
    quote!([([Velocity<#scalar>; #links], [[#scalar; 2]; #points], [#scalar; #joints]); #params])
}
