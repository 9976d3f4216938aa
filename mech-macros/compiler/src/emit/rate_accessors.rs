//! The methods that return the rates of links, points and joints.

use super::accessors::{NamedPoint, shown_links, shown_points};
use super::coordinate::CoordinateAxes;
use super::emitter::Emitter;
use crate::model::{AxisId, LinkId};
use proc_macro2::TokenStream;
use quote::quote;

/// A velocity for each link, point and joint that is shown, and an acceleration if accelerations are asked for.
pub(super) fn rate_accessors(emitter: &Emitter<'_>) -> TokenStream {
    let (model, scalar) = (emitter.model, &emitter.scalar);
    let mut tokens = TokenStream::new();
    let orders: &[Order] =
        if model.effects.acceleration { &[Order::First, Order::Second] } else { &[Order::First] };
    for id in shown_links(model) {
        let (link, index) = (model.link(id), emitter.index(id));
        for order in orders {
            let (what, field, kind) = (order.name(), order.field(), order.kind());
            let name = emitter.ident(&format!("{}_{what}", link.name), link.origin);
            let doc = format!(" The {what} of link `{}` in the scene.", link.name);
            let kind = quote!(#kind<#scalar>);
            let value = quote!(self.#field[#index]);
            tokens.extend(emitter.constant_accessor(&name, &doc, &kind, &value));
        }
    }
    for point in shown_points(model) {
        for order in orders {
            let what = order.name();
            let name = emitter.ident(&format!("{}_{what}", point.ident()), point.origin);
            let doc = format!(
                " The {what} of point `{}` of link `{}` in the scene.",
                point.name, point.link_name
            );
            let rate = point_rate(emitter, &point, *order);
            let value = quote! {
                let [x, y] = #rate;
                Vector2::new(x, y)
            };
            tokens.extend(emitter.accessor(&name, &doc, &quote!(Vector2<#scalar>), &value));
        }
    }
    for id in model.shown_joints() {
        // The coordinate of a motor is known without the poses of its links.
        let has_pose = |axis: AxisId| emitter.has_pose(model.axis(axis).link);
        let axes = CoordinateAxes::new(model, id);
        let axes = axes.filter(|axes| has_pose(axes.from) && has_pose(axes.to));
        let (Some(axes), joint) = (axes, model.joint(id)) else {
            continue;
        };
        for order in orders {
            let (suffix, what) = match order {
                Order::First => ("rate", "rate"),
                Order::Second => ("acceleration", "second rate"),
            };
            let name = emitter.ident(&format!("{}_{suffix}", joint.name), joint.origin);
            let doc = format!(" The {what} of the coordinate of joint `{}`.", joint.name);
            let value = joint_rate(emitter, axes, *order);
            tokens.extend(emitter.accessor(&name, &doc, scalar, &value));
        }
    }
    tokens
}

/// The order of a time derivative.
#[derive(Clone, Copy)]
enum Order {
    First,
    Second,
}

impl Order {
    fn name(self) -> &'static str {
        match self {
            Self::First => "velocity",
            Self::Second => "acceleration",
        }
    }

    /// The field with the rates of all links.
    fn field(self) -> TokenStream {
        match self {
            Self::First => quote!(velocities),
            Self::Second => quote!(accelerations),
        }
    }

    /// The type of the rates of a link.
    fn kind(self) -> TokenStream {
        match self {
            Self::First => quote!(Velocity),
            Self::Second => quote!(Acceleration),
        }
    }
}

/// The velocity or acceleration of a point, as an array.
fn point_rate(emitter: &Emitter<'_>, point: &NamedPoint<'_>, order: Order) -> TokenStream {
    let (index, pose) = (emitter.index(point.link), emitter.pose(point.link));
    let place = emitter.place(point.axis);
    match order {
        Order::First => quote!(self.velocities[#index].of_point(#pose, #place)),
        Order::Second => {
            quote!(self.accelerations[#index].of_point(#pose, self.velocities[#index].angular, #place))
        }
    }
}

/// The first or second rate of a joint's coordinate.
fn joint_rate(emitter: &Emitter<'_>, axes: CoordinateAxes, order: Order) -> TokenStream {
    let ends = [axes.from, axes.to];
    let link = |axis: AxisId| emitter.model.axis(axis).link;
    if axes.turns {
        let field = order.field();
        let [from, to] = ends.map(|end| match link(end) {
            LinkId::GROUND => quote!(0.0),
            link => {
                let index = emitter.index(link);
                quote!(self.#field[#index].angular)
            }
        });
        return quote!(#to - #from);
    }
    let [from, to] = ends.map(|end| {
        let rate = |order: Order| match link(end) {
            LinkId::GROUND => {
                let kind = order.kind();
                quote!(#kind::ZERO)
            }
            link => {
                let (field, index) = (order.field(), emitter.index(link));
                quote!(self.#field[#index])
            }
        };
        let (axis, velocity) = (emitter.axis(end), rate(Order::First));
        match order {
            Order::First => quote!(#axis, #velocity),
            Order::Second => {
                let acceleration = rate(Order::Second);
                quote!(#axis, (#velocity, #acceleration))
            }
        }
    });
    let function = match order {
        Order::First => quote!(slide_rate),
        Order::Second => quote!(slide_acceleration),
    };
    quote!(generated::#function(#from, #to))
}
