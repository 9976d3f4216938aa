//! A method for each link, named point and joint that is shown.

use super::coordinate::{coordinate, unit};
use super::emitter::Emitter;
use super::parts::Parts;
use super::shown::{shown_links, shown_points};
use proc_macro2::TokenStream;
use quote::quote;

/// The poses of links, the places of points and the coordinates of joints.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let (model, scalar) = (emitter.model, &emitter.scalar);
    let mut methods = TokenStream::new();
    for id in shown_links(model) {
        let link = model.link(id);
        let (name, pose) = (emitter.ident(&link.name, link.origin), emitter.pose(id));
        let doc = format!(" The pose of link `{}` in the scene.", link.name);
        let kind = quote!(Isometry2<#scalar>);
        methods.extend(emitter.accessor(&name, &doc, &kind, &quote!(#pose.isometry())));
    }
    for point in shown_points(model) {
        let name = emitter.ident(&point.ident(), point.origin);
        let doc = format!(" Point `{}` of link `{}`, in the scene.", point.name, point.link_name);
        let place = emitter.point(point.axis);
        let value = quote! {
            let [x, y] = #place;
            Point2::new(x, y)
        };
        methods.extend(emitter.accessor(&name, &doc, &quote!(Point2<#scalar>), &value));
    }
    for id in model.shown_joints() {
        let joint = model.joint(id);
        if let Some(coordinate) = coordinate(emitter, id) {
            let name = emitter.ident(&joint.name, joint.origin);
            let unit = unit(coordinate.measure);
            let doc = format!(" The coordinate of joint `{}`, in {unit}.", joint.name);
            methods.extend(emitter.accessor(&name, &doc, scalar, &coordinate.value));
        }
    }
    Parts::methods(methods)
}
