//! What the struct of a mechanism has more if it tells how everything follows the params.

use super::block::scalar;
use super::costs::literal;
use super::items::user_ident;
use super::motion::Moved;
use super::scope::Scope;
use super::step::{Written, position, takes_sines};
use crate::cost;
use crate::model::{AxisId, LinkId, Model};
use crate::program::{Program, Sensitivity};
use crate::syntax::Places;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// What follows each param, in a step's own words: links, points and joints.
pub(super) fn followed(sensitivity: &Sensitivity, scope: &Scope<'_>) -> TokenStream {
    let of_params = sensitivity.of_params.iter().map(|rates| {
        let links = rates.links.iter().map(|link| {
            let [angular, x, y] = link.map(|rate| scope.expression(rate));
            quote!(Velocity { angular: #angular, x: #x, y: #y })
        });
        let points = rates.points.iter().map(|point| {
            let [x, y] = point.map(|rate| scope.expression(rate));
            quote!([#x, #y])
        });
        let joints = rates.joints.iter().map(|&rate| scope.expression(rate));
        quote!(([#(#links),*], [#(#points),*], [#(#joints),*]))
    });
    quote!([#(#of_params),*])
}

/// The type of that.
fn followed_type(program: &Program, sensitivity: &Sensitivity) -> TokenStream {
    let scalar = scalar(program);
    let [links, points, joints, params] = [
        program.links.len(),
        sensitivity.points.len(),
        sensitivity.joints.len(),
        program.params.len(),
    ]
    .map(Literal::usize_unsuffixed);
    quote!([([Velocity<#scalar>; #links], [[#scalar; 2]; #points], [#scalar; #joints]); #params])
}

/// The function that tells how everything follows the params.
pub(super) fn sensitivity_step(
    program: &Program,
    written: &Written,
    places: &[&String],
    (moved, result): (&Moved, &TokenStream),
) -> TokenStream {
    let Some(sensitivity) = &program.sensitivity else {
        return TokenStream::new();
    };
    let Written {
        motors,
        body,
        last,
        margins,
        ..
    } = written;
    let Moved {
        margins: regular,
        places: rate_places,
        ..
    } = moved;
    let (position, scalar) = (position(program), scalar(program));
    let found = followed_type(program, sensitivity);
    let count = Literal::usize_unsuffixed(program.inputs());
    let closes = (program.is_closed() && !margins.is_empty())
        .then(|| quote!(closes([#(#margins),*], [#(#places),*])?;));
    let determined =
        (!regular.is_empty()).then(|| quote!(determined([#(#regular),*], [#(#rate_places),*])?;));
    let (sines, anywhere) = if takes_sines(program) {
        (quote!(<S: Sines<#scalar>>), quote!(::<FullRange>))
    } else {
        (TokenStream::new(), TokenStream::new())
    };
    quote! {
        /// For each param, the rates of all links, of points and of joints if it alone changes, where it is.
        #[inline]
        fn rates_by_params #sines(#last: &#position, motors: Motors<#scalar, #count>) -> Result<#found, Stop> {
            #motors
            #body
            #closes
            #determined
            Ok(#result)
        }

        /// The same, if all of it is finite.
        #[inline]
        pub(super) fn sensitivity(position: &#position) -> Result<#found, Stop> {
            followed(position, rates_by_params #anywhere)
        }
    }
}

/// The methods that tell it.
pub(super) fn methods(
    places: &Places,
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
) -> TokenStream {
    let Some(sensitivity) = &program.sensitivity else {
        return TokenStream::new();
    };
    let scalar = scalar(program);
    let [motors, params, links] = [
        program.motors.len(),
        program.params.len(),
        program.links.len(),
    ]
    .map(Literal::usize_unsuffixed);
    let blocked = quote!(Blocked<[#scalar; #motors]>);
    let cost = literal(cost::of_program(program));
    let found = quote! {
        match sensitivity::sensitivity(&self.position) {
            Result::Ok(found) => found,
            Result::Err(stop) => return Result::Err(generated::blocked_motors(Position::refuse(&self.position, stop, known::MOVE_LIMITS.inputs))),
        }
    };
    let mut tokens = quote! {
        /// How many operations it takes to find how everything follows all params, the position among them.
        #visibility const SENSITIVITY_COST: Cost = #cost;

        /// For each param, in the order of their declaration, the velocities of the moving links if it alone changes, at a rate of
        /// one.
        ///
        /// # Errors
        /// If the mechanism is at a dead point or a change point, where these are not determined.
        #visibility fn sensitivities(&self) -> Result<[[Velocity<#scalar>; #links]; #params], #blocked> {
            let found = #found;
            Result::Ok(found.map(|(links, _, _)| links))
        }
    };
    let mut add = |name: &str, what: &str, origin, kind: &TokenStream, value: &TokenStream| {
        let method = user_ident(&format!("{name}_sensitivity"), places, origin);
        let doc = format!(
            " For each param, in the order of their declaration, the rate of {what} if it alone changes, at a rate of one."
        );
        tokens.extend(quote! {
            #[doc = #doc]
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where these are not determined.
            #visibility fn #method(&self) -> Result<[#kind; #params], #blocked> {
                let found = #found;
                Result::Ok(found.map(#value))
            }
        });
    };
    for id in model.declared_links().filter(|&id| model.shows_link(id)) {
        let (link, index) = (model.link(id), place(program, id));
        let what = format!("link `{}`", link.name);
        let value = quote!(|(links, _, _)| links[#index]);
        add(
            &link.name,
            &what,
            link.origin,
            &quote!(Velocity<#scalar>),
            &value,
        );
    }
    for (index, &point) in sensitivity.points.iter().enumerate() {
        let (name, what) = point_name(model, point);
        let index = Literal::usize_unsuffixed(index);
        let value = quote!(|(_, points, _)| {
            let [x, y] = points[#index];
            Vector2::new(x, y)
        });
        let origin = model.axis(point).origin;
        add(&name, &what, origin, &quote!(Vector2<#scalar>), &value);
    }
    for (index, &joint) in sensitivity.joints.iter().enumerate() {
        let joint = model.joint(joint);
        let index = Literal::usize_unsuffixed(index);
        let what = format!("the coordinate of joint `{}`", joint.name);
        let value = quote!(|(_, _, joints)| joints[#index]);
        add(&joint.name, &what, joint.origin, &quote!(#scalar), &value);
    }
    tokens
}

/// Where the rates of a link are.
fn place(program: &Program, link: LinkId) -> Literal {
    Literal::usize_unsuffixed(program.pose_index(link))
}

/// What a point's method is called, and what it is.
fn point_name(model: &Model, point: AxisId) -> (String, String) {
    let axis = model.axis(point);
    let (link, name) = (&model.link(axis.link).name, axis.own_name());
    (
        format!("{link}_{name}"),
        format!("point `{name}` of link `{link}`"),
    )
}
