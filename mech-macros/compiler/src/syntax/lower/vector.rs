//! Numbers and vectors that are measured, and their parts.

use super::draft::Draft;
use super::name::Referent;
use super::quantity::Quantity;
use super::reader::Reader;
use super::{find, path};
use crate::bug::bug;
use crate::model::{
    self, AxisId, AxisKind, BinaryFunction, Formula, JointId, LinkId, Measured, Rate, ReactionPart,
};
use crate::syntax::Place;
use crate::syntax::ast::{MovingExpr, Name, ReactionExpr, VectorPart};

/// Something that is measured.
#[derive(Clone, Copy)]
pub(super) enum Subject {
    /// A number.
    Number(Quantity),
    /// A vector, or a part of it.
    Vector(Vector, Option<VectorPart>),
}

/// A vector of which parts are measured.
#[derive(Clone, Copy)]
pub(super) enum Vector {
    /// The place of a point.
    Place(AxisId),
    /// The instant centre of two links.
    Centre([LinkId; 2]),
    /// The velocity or acceleration of a point.
    Rate(Rate, AxisId),
    /// What the first link of a joint does to the second.
    Reaction(JointId),
    /// What the ground gets.
    Ground,
    /// By what inertia shakes the ground.
    Shaking,
}

impl Vector {
    /// Whether it is a place: then its length says little.
    pub(super) fn is_place(self) -> bool {
        matches!(self, Self::Place(_) | Self::Centre(_))
    }

    /// One part of it, and whether that is the rate of this quantity.
    fn part(self, part: ReactionPart) -> (Option<Rate>, model::Quantity) {
        let is_abscissa = part == ReactionPart::X;
        let (rate, point) = match self {
            Self::Place(point) => (None, point),
            Self::Rate(rate, point) => (Some(rate), point),
            Self::Centre(links) if is_abscissa => return (None, model::Quantity::CentreX(links)),
            Self::Centre(links) => return (None, model::Quantity::CentreY(links)),
            Self::Reaction(joint) => return (None, model::Quantity::Reaction(joint, part)),
            Self::Ground => return (None, model::Quantity::Ground(part)),
            Self::Shaking => return (None, model::Quantity::Shaking(part)),
        };
        let of = if is_abscissa { model::Quantity::X(point) } else { model::Quantity::Y(point) };
        (rate, of)
    }
}

impl Reader<'_> {
    /// A coordinate, an angle or a constant, a place, or the velocity or acceleration of something.
    pub(super) fn moving(
        &mut self,
        draft: &Draft,
        rate: Option<Rate>,
        moving: &MovingExpr,
    ) -> Option<Subject> {
        if let (None, Some(name)) = (rate, &moving.named)
            && self.is_constant(name)?
        {
            let constant = self.constant(&name.name, name.place())?;
            return Some(Subject::Number(constant));
        }
        let point = match (&moving.named, &moving.point) {
            (Some(name), _) if path::is_path(self, name) => None,
            (Some(_), Some(point)) if rate.is_none() && !self.is_link(&point.link) => None,
            (_, point) => point.as_ref(),
        };
        let Some(point) = point else {
            let Some(name) = &moving.named else {
                bug!("something that moves has no name");
            };
            let of = self.named(draft, name)?;
            return self.quantity_or_rate(rate, of).map(Subject::Number);
        };
        let part = moving.part.as_ref().map(|(part, _)| *part);
        if let (Some(rate), Some(first)) = (rate, point.link.uses.first())
            && let Some(Referent::Link(_)) = self.names.get(&self.key_of(&first.name))
        {
            let text = format!(
                "`{point}` is no part of a {}; write `.x`, `.y` or `.norm` after a point",
                rate.word()
            );
            return self.report.refuse(point.place(), text);
        }
        let axis = self.axis(draft, point, Some(AxisKind::Point))?;
        if rate.is_some() && draft.model.axis(axis).link == LinkId::GROUND {
            let text = format!("`{point}` does not move: there is nothing to measure");
            return self.report.refuse(point.place(), text);
        }
        let vector = rate.map_or(Vector::Place(axis), |rate| Vector::Rate(rate, axis));
        Some(Subject::Vector(vector, part))
    }

    /// Whether a name is that of a link.
    fn is_link(&mut self, name: &Name) -> bool {
        path::is_path(self, name) && matches!(find::look_up(self, name), Some(Referent::Link(_)))
    }

    fn quantity_or_rate(&mut self, rate: Option<Rate>, of: model::Quantity) -> Option<Quantity> {
        let of = self.variable_for(Measured::Quantity(of))?;
        let Some(rate) = rate else {
            return Some(of);
        };
        let of = of.as_formula(self.formulas());
        self.variable_for(Measured::Rate(rate, of))
    }

    /// One part of a vector; without a part its length.
    pub(super) fn part_of_vector(
        &mut self,
        vector: Vector,
        part: Option<VectorPart>,
    ) -> Option<Quantity> {
        let mut along = |part| {
            let (rate, of) = vector.part(part);
            self.quantity_or_rate(rate, of)
        };
        match part {
            Some(VectorPart::X) => along(ReactionPart::X),
            Some(VectorPart::Y) => along(ReactionPart::Y),
            Some(VectorPart::Torque) => along(ReactionPart::Torque),
            Some(VectorPart::Norm) | None => {
                let parts = [along(ReactionPart::X)?, along(ReactionPart::Y)?];
                let [x, y] = parts.map(|part| part.as_formula(self.formulas()));
                let length = Formula::OfBoth(BinaryFunction::Hypot, x, y);
                Some(Quantity { value: None, formula: Some(self.formulas().add(length)) })
            }
        }
    }

    /// What the first link of a joint does to the second, or what the ground gets.
    pub(super) fn reaction(&mut self, draft: &Draft, reaction: &ReactionExpr) -> Option<Subject> {
        let (name, part) = match &reaction.part {
            Some((joint, part)) if !path::is_path(self, &reaction.whole) => (joint, Some(*part)),
            _ => (&reaction.whole, None),
        };
        if name.uses.is_empty() && name.name == "ground" {
            self.refuse_massless(draft, true, name.place())?;
            return Some(Subject::Vector(Vector::Ground, part));
        }
        let joint = find::joint(self, draft, name)?;
        Some(Subject::Vector(Vector::Reaction(joint), part))
    }

    /// Complains about a force on the ground, if no link has a mass and there is no load that counts.
    pub(super) fn refuse_massless(
        &mut self,
        draft: &Draft,
        counts_loads: bool,
        place: Place,
    ) -> Option<()> {
        let model = &draft.model;
        let has_mass = model.links.iter().any(|link| link.mass.is_some());
        if has_mass || (counts_loads && !model.actions.loads.is_empty()) {
            return Some(());
        }
        let text = if counts_loads {
            "no link has a mass, and there is no load: the ground gets nothing; write `mass 1 at (0, 0);` in a link"
        } else {
            "no link has a mass, so nothing shakes the ground; write `mass 1 at (0, 0);` in a link"
        };
        self.report.refuse(place, text)
    }
}
