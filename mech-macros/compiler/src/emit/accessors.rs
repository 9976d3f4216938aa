//! A method for each link, named point and joint that is shown.

use super::Parts;
use super::coordinate::{coordinate, unit};
use super::emitter::Emitter;
use crate::model::{AxisId, LinkId, Model, Origin};
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

/// The moving links that are shown.
pub(super) fn shown_links(model: &Model) -> impl Iterator<Item = LinkId> {
    model.declared_links().filter(|&id| model.shows_link(id))
}

/// A named point of a moving link.
pub(super) struct NamedPoint<'m> {
    pub(super) axis: AxisId,
    pub(super) link: LinkId,
    pub(super) link_name: &'m str,
    pub(super) name: &'m str,
    pub(super) origin: Origin,
}

impl<'m> NamedPoint<'m> {
    pub(super) fn new(model: &'m Model, axis: AxisId) -> Self {
        let point = model.axis(axis);
        Self {
            axis,
            link: point.link,
            link_name: model.owner_of(point),
            name: point.own_name(),
            origin: point.origin,
        }
    }

    /// The name of its method.
    pub(super) fn ident(&self) -> String {
        format!("{}_{}", self.link_name, self.name)
    }
}

/// The named points of moving links that are shown.
pub(super) fn shown_points(model: &Model) -> impl Iterator<Item = NamedPoint<'_>> {
    let points = model.shown_points();
    points.map(|axis| NamedPoint::new(model, axis))
}
