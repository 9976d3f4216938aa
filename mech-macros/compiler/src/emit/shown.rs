//! The links and points that have methods of their own.

use crate::model::{AxisId, LinkId, Model, Origin};

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
