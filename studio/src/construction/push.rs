//! What pushes links: reactions in joints, weights, springs, dampers and loads.

use super::Place;
use super::spot::Pair;
use crate::quantity::{Position, Surveyed};
use mech_compiler::model::{AxisId, Between, JointId, JointKind, LinkId, LoadKind, Rate};
use mech_compiler::structure::Factor;

/// A force and a torque on a link.
pub(super) struct Push {
    pub(super) link: LinkId,
    /// Where it acts; none if it is a torque that acts nowhere.
    pub(super) at: Option<Place>,
    pub(super) force: Place,
    pub(super) torque: f64,
    /// The name of what pushes.
    pub(super) name: String,
}

/// All pushes on all links where a mechanism is; none where they are not determined. Where motors rest, dampers do not push.
pub(super) fn pushes(survey: Surveyed<'_>, at: &Position, rests: bool) -> Option<Vec<Push>> {
    let Surveyed { model, compiled, loads, .. } = survey;
    let actions = &model.actions;
    let mut all = Vec::new();
    let reactions = &at.forces.as_ref()?.reactions;
    for (joint, [x, y, torque]) in model.declared_joints().zip(reactions) {
        let name = &model.joint(joint).name;
        all.extend(reaction(survey, at, joint, ([*x, *y], *torque), name)?);
    }
    for link in model.declared_links() {
        if let (Some(gravity), Some(mass)) = (actions.gravity, &model.link(link).mass) {
            all.push(Push {
                link,
                at: Some(at.pose(compiled, link)?.apply(mass.center)),
                force: gravity.map(|part| part * mass.mass),
                torque: 0.0,
                name: "weight".to_owned(),
            });
        }
    }
    for spring in &actions.springs {
        all.extend(match spring.between {
            Between::Points(a, b) => {
                let [from, to] = [a, b].map(|end| spot(survey, at, end));
                let ([x, y], [to_x, to_y]) = (from?, to?);
                let offset = [to_x - x, to_y - y];
                let length = offset[0].hypot(offset[1]);
                let tension = spring.stiffness * (length - spring.rest);
                let force = offset.map(|part| tension * part / length);
                pull(survey, at, [a, b], force, &spring.name)?
            }
            Between::Joint(joint) => {
                let torque = spring.stiffness * (survey.twist(at, joint)? - spring.rest);
                let back = ([0.0; 2], -torque);
                reaction(survey, at, joint, back, &spring.name)?
            }
        });
    }
    for damper in actions.dampers.iter().filter(|_| !rests) {
        all.extend(match damper.between {
            Between::Points(a, b) => {
                let [from, to] = [a, b].map(|end| spot(survey, at, end));
                let (from, to) = (from?, to?);
                let rate = |end: AxisId, place| {
                    at.vector(compiled, model.axis(end).link, place, Rate::Velocity)
                };
                let (slow, fast) = (rate(a, from)?, rate(b, to)?);
                let [x, y] = [0, 1].map(|part| to[part] - from[part]);
                let [u, v] = [0, 1].map(|part| fast[part] - slow[part]);
                let tension = damper.damping * (x * u + y * v) / (x * x + y * y);
                pull(survey, at, [a, b], [tension * x, tension * y], &damper.name)?
            }
            Between::Joint(joint) => {
                let (first, second) = model.ends(joint);
                let [slow, fast] =
                    [first, second].map(|link| at.rate(compiled, link, Rate::Velocity));
                let back = ([0.0; 2], -damper.damping * (fast?[0] - slow?[0]));
                reaction(survey, at, joint, back, &damper.name)?
            }
        });
    }
    for (number, load) in actions.numbered_loads() {
        let (link, place, force, torque) = match load.kind {
            LoadKind::Force(point) => {
                let force = [loads[number], loads[number + 1]];
                let place = spot(survey, at, point)?;
                (model.axis(point).link, Some(place), force, 0.0)
            }
            LoadKind::Torque(link) => (link, None, [0.0; 2], loads[number]),
        };
        all.push(Push { link, at: place, force, torque, name: load.name.clone() });
    }
    let is_finite =
        |push: &Push| push.force.iter().all(|part| part.is_finite()) && push.torque.is_finite();
    all.retain(is_finite);
    Some(all)
}

/// What the first link of a joint does to the second, and the second to the first.
fn reaction(
    survey: Surveyed<'_>,
    at: &Position,
    joint: JointId,
    (force, torque): (Place, f64),
    name: &str,
) -> Option<Vec<Push>> {
    let Surveyed { model, compiled, .. } = survey;
    let push = |link, at, side: f64, torque| Push {
        link,
        at,
        force: force.map(|part| side * part),
        torque,
        name: name.to_owned(),
    };
    let kind = model.joint(joint).kind;
    if let (Some(pair), Some([_, b])) = (Pair::of(survey, at, joint), kind.axes()) {
        // In a slide it is known where the second line begins.
        let there = spot(survey, at, model.seen_axis(b))?;
        let arm = [0, 1].map(|part| there[part] - pair.at[part]);
        let torque = torque + arm[0] * force[1] - arm[1] * force[0];
        let ([first, second], place) = (pair.links, Some(pair.at));
        return Some(vec![push(second, place, 1.0, torque), push(first, place, -1.0, -torque)]);
    }
    let (first, second) = model.ends(joint);
    if torque == 0.0 {
        // Teeth push where they roll on each other.
        let [one, other] = [first, second].map(|link| at.motion(compiled, link));
        let place = one?.centre(other?);
        return place.map(|place| {
            let both = [(second, 1.0), (first, -1.0)];
            Vec::from(both.map(|(link, side)| push(link, Some(place), side, 0.0)))
        });
    }
    let mut rollings = compiled.structure.rollings.iter();
    let rolling = rollings.find(|rolling| rolling.joint == joint)?;
    let [p, q] = rolling.ends.map(|(_, factor)| match factor {
        #[expect(clippy::cast_precision_loss, reason = "teeth are few")]
        Factor::Whole(teeth) => teeth as f64,
        Factor::Float(radius) => radius,
    });
    let shares = [(second, 1.0), (first, p / q), (rolling.carrier, -1.0 - p / q)];
    Some(Vec::from(shares.map(|(link, share)| push(link, None, 0.0, share * torque))))
}

/// A pull of the first point towards the second, and back.
fn pull(
    survey: Surveyed<'_>,
    at: &Position,
    ends: [AxisId; 2],
    force: Place,
    name: &str,
) -> Option<Vec<Push>> {
    let both = ends.into_iter().zip([1.0, -1.0]).map(|(end, side)| {
        Some(Push {
            link: survey.model.axis(end).link,
            at: Some(spot(survey, at, end)?),
            force: force.map(|part| side * part),
            torque: 0.0,
            name: name.to_owned(),
        })
    });
    both.collect()
}

/// Where an axis is in the scene.
fn spot(survey: Surveyed<'_>, at: &Position, axis: AxisId) -> Option<Place> {
    let axis = survey.model.axis(axis);
    Some(at.pose(survey.compiled, axis.link)?.apply(axis.at))
}

/// The name of the first cam, whose push is not at its contact.
pub(super) fn cam(survey: Surveyed<'_>) -> Option<&str> {
    let model = survey.model;
    let mut joints = model.declared_joints().map(|joint| model.joint(joint));
    let found = joints.find(|joint| matches!(joint.kind, JointKind::Cam { .. }));
    found.map(|joint| joint.name.as_str())
}
