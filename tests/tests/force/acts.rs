//! What acts on each link, by the definitions.

use super::{Given, Position};
use mech_compiler::model::{AxisId, Between, JointKind, LinkId, LoadKind, Model};
use mech_compiler::program::InverseDynamics;
use mech_compiler::program::LinkRates;
use mech_test_support::size;

/// What acts on a link: a force at a point, and a torque.
pub(super) type Act = (LinkId, [f64; 2], [f64; 2], f64);

/// What joints do to links, and the links of which not all of that is known.
pub(super) fn by_joints(
    model: &Model,
    at: &Position,
    inverse_dynamics: &InverseDynamics<f64>,
) -> (Vec<Act>, Vec<LinkId>) {
    let mut acts: Vec<Act> = Vec::new();
    let mut rolls: Vec<LinkId> = Vec::new();
    for (joint, &[x, y, torque]) in model.declared_joints().zip(&inverse_dynamics.reactions) {
        let (mut first, mut second) = model.ends(joint);
        let mut point = [0.0, 0.0];
        match model.joint(joint).kind {
            JointKind::Revolute(a, _) | JointKind::Weld(a, _) => point = place(model, at, a),
            JointKind::Prismatic(a, b) => {
                let pin = |link: LinkId| model.link(link).die.map(|(pin, _)| pin);
                let seen = [a, b].map(|axis| pin(model.axis(axis).link).unwrap_or(axis));
                point = place(model, at, seen[1]);
                if pin(first).is_some() {
                    point = place(model, at, seen[0]);
                }
                for link in [&mut first, &mut second] {
                    if let Some(pin) = pin(*link) {
                        *link = model.axis(pin).link;
                    }
                }
            }
            // Where it touches is not reported.
            _ => rolls.extend(model.link_ids()),
        }
        acts.push((second, point, [x, y], torque));
        acts.push((first, point, [-x, -y], -torque));
    }
    (acts, rolls)
}

/// Follows the angles of all revolute joints to a position nearby.
pub(super) fn follow(angles: &mut [f64], model: &Model, at: &Position) {
    let direction = |axis: AxisId| {
        let axis = model.axis(axis);
        let own = axis.direction[1].atan2(axis.direction[0]);
        let link = axis.link.index().checked_sub(1).map(|link| at.poses[link]);
        link.map_or(own, |[cos, sin, ..]| own + sin.atan2(cos))
    };
    for (angle, joint) in angles.iter_mut().zip(&model.joints) {
        if let JointKind::Revolute(a, b) = joint.kind
            && model.link(model.axis(b).link).die.is_none()
        {
            let off = direction(b) - direction(a) - *angle;
            *angle += off.sin().atan2(off.cos());
        }
    }
}

/// What springs, dampers and loads do to links.
pub(super) fn by_actions(
    model: &Model,
    (at, given): (&Position, &Given),
    moved: &LinkRates<f64>,
) -> Vec<Act> {
    let mut acts: Vec<Act> = Vec::new();
    let velocity = |axis: AxisId| {
        let (point, link) = (place(model, at, axis), model.axis(axis).link);
        match link.index().checked_sub(1) {
            None => [0.0, 0.0],
            Some(index) => {
                let ([turning, x, y], [_, _, u, v]) = (moved.velocities[index], at.poses[index]);
                [x - turning * (point[1] - v), y + turning * (point[0] - u)]
            }
        }
    };
    for (between, stiffness, length_at_rest, damping) in model
        .actions
        .springs
        .iter()
        .map(|spring| (spring.between, spring.stiffness, spring.rest, 0.0))
        .chain(
            model.actions.dampers.iter().map(|damper| (damper.between, 0.0, 0.0, damper.damping)),
        )
    {
        match between {
            Between::Points(a, b) => {
                let (p, q) = (place(model, at, a), place(model, at, b));
                let (u, v) = (velocity(a), velocity(b));
                let length = (q[0] - p[0]).hypot(q[1] - p[1]);
                // Where its ends meet it has no direction, and does nothing.
                let apart = length.max(1e-9 * size(model));
                let unit = [(q[0] - p[0]) / apart, (q[1] - p[1]) / apart];
                let rate = (v[0] - u[0]) * unit[0] + (v[1] - u[1]) * unit[1];
                let tension = stiffness * (length - length_at_rest) + damping * rate;
                let force = unit.map(|part| tension * part);
                acts.push((model.axis(a).link, p, force, 0.0));
                acts.push((model.axis(b).link, q, force.map(|part| -part), 0.0));
            }
            Between::Joint(joint) => {
                let JointKind::Revolute(a, b) = model.joint(joint).kind else {
                    panic!("a spring turns revolutes");
                };
                let turning = |axis: AxisId| {
                    let link = model.axis(axis).link.index().checked_sub(1);
                    link.map_or(0.0, |link| moved.velocities[link][0])
                };
                let deflection = given.angles[joint.index()] - length_at_rest;
                let torque = stiffness * deflection + damping * (turning(b) - turning(a));
                acts.push((model.axis(a).link, [0.0; 2], [0.0; 2], torque));
                acts.push((model.axis(b).link, [0.0; 2], [0.0; 2], -torque));
            }
        }
    }
    for (first, load) in model.actions.numbered_loads() {
        match load.kind {
            LoadKind::Force(point) => {
                let force = [given.loads[first], given.loads[first + 1]];
                acts.push((model.axis(point).link, place(model, at, point), force, 0.0));
            }
            LoadKind::Torque(link) => acts.push((link, [0.0; 2], [0.0; 2], given.loads[first])),
        }
    }
    acts
}

/// A point of a link in the scene.
fn place(model: &Model, at: &Position, axis: AxisId) -> [f64; 2] {
    let axis = model.axis(axis);
    scene_point(at, axis.link, axis.at)
}

pub(super) fn scene_point(at: &Position, link: LinkId, [x, y]: [f64; 2]) -> [f64; 2] {
    match link.index().checked_sub(1) {
        None => [x, y],
        Some(index) => {
            let [cos, sin, u, v] = at.poses[index];
            [u + cos * x - sin * y, v + sin * x + cos * y]
        }
    }
}
