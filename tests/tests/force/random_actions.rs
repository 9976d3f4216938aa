//! Random masses, springs, dampers and loads.

use mech_compiler::model::{
    Actions, AxisId, AxisKind, Between, Damper, Effects, JointKind, LinkId, Load, LoadKind, Mass,
    Model, Origin, Spring,
};
use mech_test_support::{Dice, size};

/// Puts random masses on all links, and lets random things act on them.
pub(super) fn load_up(model: &mut Model, dice: &mut Dice) {
    let size = size(model);
    let near = |dice: &mut Dice| dice.between(-0.5 * size, 0.5 * size);
    for id in model.declared_links().collect::<Vec<_>>() {
        let center = [near(dice), near(dice)];
        model.links[id.index()].mass = Some(Mass {
            mass: dice.between(0.1, 2.0),
            center,
            inertia: dice.between(0.0, 0.2) * size * size,
        });
    }
    let points: Vec<AxisId> = (0..model.axes.len())
        .map(AxisId::new)
        .filter(|&axis| {
            let axis = model.axis(axis);
            axis.kind == AxisKind::Point && model.link(axis.link).die.is_none()
        })
        .collect();
    let moving: Vec<AxisId> =
        points.iter().copied().filter(|&point| model.axis(point).link != LinkId::GROUND).collect();
    let revolutes: Vec<_> = model
        .declared_joints()
        .filter(|&joint| matches!(model.joint(joint).kind, JointKind::Revolute(..)))
        .collect();
    let mut actions = Actions {
        gravity: Some([dice.between(-3.0, 3.0), dice.between(-10.0, 0.0)]),
        ..Actions::default()
    };
    let origin = Origin::default();
    let mut betweens = Vec::new();
    for _ in 0..if points.is_empty() { 0 } else { 3 } {
        let (a, b) = (*dice.pick(&points), *dice.pick(&points));
        let together = |kind: JointKind| matches!(kind, JointKind::Revolute(p, q) if [p, q] == [a, b] || [q, p] == [a, b]);
        let joined = model.joints.iter().any(|joint| together(joint.kind));
        if model.axis(a).link != model.axis(b).link && !joined {
            betweens.push(Between::Points(a, b));
        }
    }
    if !revolutes.is_empty() {
        betweens.push(Between::Joint(*dice.pick(&revolutes)));
    }
    for (number, &between) in betweens.iter().enumerate() {
        let rest = match between {
            Between::Points(..) if dice.once_in(3) => 0.0,
            Between::Points(..) => dice.between(0.1, 1.0) * size,
            Between::Joint(_) => dice.between(-1.0, 1.0),
        };
        actions.springs.push(Spring {
            name: format!("spring{number}"),
            origin,
            between,
            stiffness: dice.between(1.0, 5.0),
            rest,
        });
        actions.dampers.push(Damper {
            name: format!("damper{number}"),
            origin,
            between,
            damping: dice.between(0.1, 1.0),
        });
    }
    if !moving.is_empty() {
        let point = *dice.pick(&moving);
        for (name, kind) in [
            ("push", LoadKind::Force(point)),
            ("twist", LoadKind::Torque(model.axis(*dice.pick(&moving)).link)),
        ] {
            actions.loads.push(Load { name: name.to_owned(), origin, kind });
        }
    }
    model.actions = actions;
    model.effects = Effects {
        velocity: true,
        acceleration: true,
        force: true,
        dynamics: true,
        overlay: false,
        sensitivity: false,
    };
    model.show = None;
}
