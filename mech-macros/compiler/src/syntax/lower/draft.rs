//! The model in the making.

use super::claim::Claims;
use super::name::Body;
use crate::model::{AxisId, DrawnAxis, LinkId, Model, Origin};
use crate::syntax::ast::Text;
use crate::syntax::{Place, Places};
use proc_macro2::Ident;
use std::collections::BTreeMap;

/// The model in the making.
pub(super) struct Draft {
    /// As far as it has come, without its params.
    pub(super) model: Model,
    /// Where everything in it was declared.
    pub(super) places: Places,
    /// Who has taken which name.
    pub(super) claims: Claims,
    /// Whether the text declares params, readable or not.
    pub(super) has_params: bool,
    /// The axes that the drawing has put on links.
    drawn: BTreeMap<LinkId, Vec<AxisId>>,
    /// The motors of the model, as the text declares them.
    pub(super) motors: Vec<WrittenMotor>,
    /// Names of points and lines that are left out of the model because of an error; of all, if there is no name. Without a link,
    /// they may be meant for any.
    lost: Vec<(Option<Body>, Option<String>)>,
}

/// A motor of the model, as the text declares it, for messages.
pub(super) struct WrittenMotor {
    /// The number of its statement.
    pub(super) statement: usize,
    /// Its range, if it has one.
    pub(super) range: String,
}

impl Draft {
    /// A model as far as it has come.
    pub(super) fn of_model(model: Model) -> Self {
        Self {
            model,
            places: Places::default(),
            claims: Claims::default(),
            has_params: false,
            drawn: BTreeMap::new(),
            motors: Vec::new(),
            lost: Vec::new(),
        }
    }

    /// The model of a text before any of its statements.
    pub(super) fn of(text: &Text) -> Self {
        let mut draft = Self::of_model(Model::new("Mechanism", Origin::default()));
        if let Some((header, precision)) = &text.header {
            draft.model.name = header.name.to_string();
            draft.model.origin = draft.note(&header.name);
            draft.model.precision = *precision;
        }
        draft
    }

    /// Notes where a name stands.
    pub(super) fn note(&mut self, name: &Ident) -> Origin {
        self.places.note(Place::at(name.span()))
    }

    /// The axis that the drawing puts on a link. Joints on one spot share it; only those of the link are looked at.
    pub(super) fn drawn_axis(&mut self, link: LinkId, drawn: DrawnAxis, origin: Origin) -> AxisId {
        let of_link = self.drawn.entry(link).or_default();
        let is_it = |axis: &&AxisId| drawn.is(self.model.axis(**axis));
        if let Some(&axis) = of_link.iter().find(is_it) {
            return axis;
        }
        let axis = self.model.add_drawn_axis(link, drawn, origin);
        of_link.push(axis);
        axis
    }

    /// Notes that a link should have an axis of this name, or any, had there not been an error.
    pub(super) fn lose_axis(&mut self, link: Body, name: Option<&Ident>) {
        self.lost.push((Some(link), name.map(ToString::to_string)));
    }

    /// Notes that a statement that could not be read may be a point outside of its link, or the ground.
    pub(super) fn lose(&mut self, names: &[Ident]) {
        for name in names {
            self.lost.push((None, Some(name.to_string())));
            if name == "ground" {
                self.lose_axis(LinkId::GROUND.into(), None);
            }
        }
    }

    /// Whether a link should have an axis of this name.
    pub(super) fn is_lost(&self, link: Body, name: &str) -> bool {
        let lost = |entry: &Option<String>| entry.as_deref().is_none_or(|entry| entry == name);
        let mut all = self.lost.iter();
        all.any(|(owner, entry)| owner.is_none_or(|owner| owner == link) && lost(entry))
    }
}
