//! The methods that return how everything changes with the params.

use super::Parts;
use super::accessors::{NamedPoint, shown_links};
use super::advance::refusal;
use super::costs::literal;
use super::emitter::Emitter;
use super::step::step;
use super::tokens::integer;
use crate::bug::bug;
use crate::cost;
use crate::model::Origin;
use proc_macro2::TokenStream;
use quote::quote;

/// `sensitivities`, a method for each link, point and joint, and what they cost; nothing if that is not asked for.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, links, params, blocked, model, .. } = emitter;
    let Some(program) = &emitter.compiled.sensitive else {
        return Parts::default();
    };
    let Some(sensitivity) = program.sensitivity() else {
        bug!("the program of sensitivities computes none");
    };
    let cost = literal(cost::of_program(program));
    let refusal = refusal(emitter);
    let rates = quote! {
        match sensitivity::sensitivity(&self.position) {
            Result::Ok(found) => found,
            Result::Err(stop) => return Result::Err(#refusal),
        }
    };
    let mut methods = quote! {
        /// How many operations it takes to find how everything follows all params, the position among them.
        #visibility const SENSITIVITY_COST: Cost = #cost;

        /// For each param, in the order of their declaration, the velocities of the moving links if it alone changes, at a rate of
        /// one.
        ///
        /// # Errors
        /// If the mechanism is at a dead point or a change point, where these are not determined.
        #visibility fn sensitivities(&self) -> Result<[[Velocity<#scalar>; #links]; #params], #blocked> {
            let found = #rates;
            Result::Ok(found.map(|(links, _, _)| links))
        }
    };
    let mut add = |name: &str, origin: Origin, what: &str, kind: TokenStream, rate: TokenStream| {
        let method = emitter.ident(&format!("{name}_sensitivity"), origin);
        let doc = format!(
            " For each param, in the order of their declaration, the rate of {what} if it alone changes, at a rate of one."
        );
        methods.extend(quote! {
            #[doc = #doc]
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where these are not determined.
            #visibility fn #method(&self) -> Result<[#kind; #params], #blocked> {
                let found = #rates;
                Result::Ok(found.map(#rate))
            }
        });
    };
    for id in shown_links(model) {
        let (link, index) = (model.link(id), emitter.index(id));
        let what = format!("link `{}`", link.name);
        let kind = quote!(Velocity<#scalar>);
        let rate = quote!(|(links, _, _)| links[#index]);
        add(&link.name, link.origin, &what, kind, rate);
    }
    let points = sensitivity.points.iter().enumerate();
    for (index, &point) in points {
        let (index, point) = (integer(index), NamedPoint::new(model, point));
        let what = format!("point `{}` of link `{}`", point.name, point.link_name);
        let kind = quote!(Vector2<#scalar>);
        let rate = quote!(|(_, points, _)| {
            let [x, y] = points[#index];
            Vector2::new(x, y)
        });
        add(&point.ident(), point.origin, &what, kind, rate);
    }
    for (index, &joint) in sensitivity.joints.iter().enumerate() {
        let (index, joint) = (integer(index), model.joint(joint));
        let what = format!("the coordinate of joint `{}`", joint.name);
        let rate = quote!(|(_, _, joints)| joints[#index]);
        add(&joint.name, joint.origin, &what, scalar.clone(), rate);
    }
    Parts { methods, modules: step(emitter.krate, program), ..Parts::default() }
}
