//! What is led, as expressions in methods.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::model::Inverse;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The number of what is given.
pub(super) fn count(inverse: &Inverse) -> Literal {
    integer(inverse.given().len())
}

/// What is given, as an array of inputs.
pub(super) fn given(inverse: &Inverse) -> TokenStream {
    let kinds = [quote!(Sliding), quote!(Sliding), quote!(Turning)];
    let given = inverse.given().iter().zip(kinds);
    let given = given.map(|(name, kind)| quote!(Input::#kind(#name)));
    quote!([#(#given),*])
}

/// The present value of what is given: an expression in a method.
pub(super) fn here(emitter: &Emitter<'_>, inverse: &Inverse) -> TokenStream {
    let pose = emitter.pose(inverse.link);
    let origin = || quote!([#pose.x, #pose.y]);
    let place = inverse.point.map_or_else(origin, |point| emitter.point(point));
    if !inverse.gives_angle() {
        return place;
    }
    quote!({
        let [x, y] = #place;
        [x, y, generated::atan2(#pose.sin, #pose.cos)]
    })
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

/// The rates of what is given, as expressions of the variables `velocities` and `accelerations`.
pub(super) struct Rates {
    pub(super) velocity: TokenStream,
    pub(super) acceleration: TokenStream,
}

impl Rates {
    pub(super) fn new(emitter: &Emitter<'_>, inverse: &Inverse) -> Self {
        let (index, pose) = (emitter.index(inverse.link), emitter.pose(inverse.link));
        let origin = || quote!([0.0, 0.0]);
        let point = inverse.point.map_or_else(origin, |point| emitter.place(point));
        let with_angle = |place: TokenStream, rate: TokenStream| {
            if inverse.gives_angle() {
                quote!({ let [x, y] = #place; [x, y, #rate.angular] })
            } else {
                place
            }
        };
        let (velocity, acceleration) = (quote!(velocities[#index]), quote!(accelerations[#index]));
        Self {
            acceleration: with_angle(
                quote!(Acceleration::of_point(#acceleration, #pose, #velocity.angular, #point)),
                acceleration,
            ),
            velocity: with_angle(quote!(Velocity::of_point(#velocity, #pose, #point)), velocity),
        }
    }
}
