//! The places of a link that have names: where it is joined to others, and its points.

use super::Place;
use crate::quantity::{Position, Surveyed};
use mech_compiler::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model};

/// Places that are nearer than this part of their distance from the origin are one: in single precision, too.
const SAME: f64 = 1e-5;
/// What is farther away than so many times the size of the mechanism is at infinity: rounding alone may have brought it nearer.
const INFINITY: f64 = 1e3;

/// A place in the scene, as a place of a link, and its names.
pub(super) struct Spot {
    pub(super) at: Place,
    pub(super) names: Vec<String>,
}

impl Spot {
    /// The spots of a link. It has one, too, where another link slides on it, unless it is the ground.
    pub(super) fn of(survey: Surveyed<'_>, at: &Position, link: LinkId) -> Vec<Self> {
        let model = survey.model;
        let mut spots: Vec<Self> = Vec::new();
        for joint in model.declared_joints() {
            let Some(Pair { pin, links, at }) = Pair::of(survey, at, joint) else {
                continue;
            };
            let name = &model.joint(joint).name;
            let is_slide = matches!(model.joint(joint).kind, JointKind::Prismatic(..));
            if link == model.axis(pin).link || (links.contains(&link) && !is_slide) {
                add(&mut spots, at, name);
            } else if links.contains(&link) && link != LinkId::GROUND {
                add(&mut spots, at, &format!("{name} on {}", model.link(link).name));
            }
        }
        let points = model.axes.iter().filter(|axis| axis.link == link);
        for point in points.filter(|axis| axis.kind == AxisKind::Point) {
            let place = at.pose(survey.compiled, link);
            let place = place.map(|pose| pose.apply(point.at));
            if let (Some(place), Some(name)) = (place, &point.name)
                && !spots.iter().any(|spot| is_same(spot.at, place))
            {
                add(&mut spots, place, name);
            }
        }
        spots
    }
}

/// The links of a joint, and where it is.
pub(super) struct Pair {
    /// The axis that is where the joint is: of a slide that which slides.
    pin: AxisId,
    /// Its first link and its second.
    pub(super) links: [LinkId; 2],
    pub(super) at: Place,
}

impl Pair {
    /// None if it has no place.
    pub(super) fn of(survey: Surveyed<'_>, at: &Position, joint: JointId) -> Option<Self> {
        let model = survey.model;
        let axes = model.joint(joint).kind.axes()?;
        let is_die = model.link(model.axis(axes[0]).link).die.is_some();
        let axes = axes.map(|axis| model.seen_axis(axis));
        let pin = axes[usize::from(!is_die)];
        let axis = model.axis(pin);
        Some(Self {
            pin,
            links: axes.map(|axis| model.axis(axis).link),
            at: at.pose(survey.compiled, axis.link)?.apply(axis.at),
        })
    }
}

fn add(spots: &mut Vec<Spot>, at: Place, name: &str) {
    match spots.iter_mut().find(|spot| is_same(spot.at, at)) {
        Some(spot) => spot.names.push(name.to_owned()),
        None => spots.push(Spot { at, names: vec![name.to_owned()] }),
    }
}

/// Whether a place is not at infinity.
pub(super) fn is_near(model: &Model, place: Place) -> bool {
    let most = INFINITY * (1.0 + model.size());
    place.iter().all(|part| part.abs() < most)
}

pub(super) fn is_same([a, b]: Place, [c, d]: Place) -> bool {
    (a - c).hypot(b - d) <= SAME * (1.0 + a.hypot(b))
}
