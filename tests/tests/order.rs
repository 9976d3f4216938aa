//! The outcome does not depend on the order in which a mechanism is declared.

use mech_compiler::compile;
use mech_compiler::model::{Axis, AxisId, JointId, JointKind, LinkId, Model, MotorId};
use mech_tests::{Dice, grow};
use std::collections::BTreeSet;

/// The same mechanism, declared in another order.
fn shuffled(model: &Model, dice: &mut Dice) -> Model {
    // Dies come after all links that are declared.
    let declared = 1 + model.declared_links().count();
    let mut links = permutation(declared, dice, true);
    links.extend(declared..model.links.len());
    let joints = permutation(model.joints.len(), dice, false);
    let axes = permutation(model.axes.len(), dice, false);
    let link = |id: LinkId| LinkId::new(links[id.index()]);
    let axis = |id: AxisId| AxisId::new(axes[id.index()]);
    let mut other = model.clone();
    for (index, old) in model.links.iter().enumerate() {
        let die = old.die.map(|(pin, line)| (axis(pin), axis(line)));
        other.links[links[index]] = mech_compiler::model::Link { die, ..old.clone() };
    }
    for (index, old) in model.axes.iter().enumerate() {
        other.axes[axes[index]] = Axis {
            link: link(old.link),
            ..old.clone()
        };
    }
    for (index, old) in model.joints.iter().enumerate() {
        let kind = match old.kind {
            JointKind::Revolute(a, b) => JointKind::Revolute(axis(a), axis(b)),
            JointKind::Prismatic(a, b) => JointKind::Prismatic(axis(a), axis(b)),
            JointKind::Weld(a, b) => JointKind::Weld(axis(a), axis(b)),
            JointKind::Gear { a, b, ratio, on } => JointKind::Gear {
                a: link(a),
                b: link(b),
                ratio,
                on: on.map(link),
            },
            JointKind::Belt { a, b, ratio, on } => JointKind::Belt {
                a: link(a),
                b: link(b),
                ratio,
                on: on.map(link),
            },
            JointKind::Rack {
                pinion,
                bar,
                radius,
                on,
            } => JointKind::Rack {
                pinion: link(pinion),
                bar: link(bar),
                radius,
                on: on.map(link),
            },
            JointKind::Cam {
                shaft,
                follower,
                law,
            } => JointKind::Cam {
                shaft: JointId::new(joints[shaft.index()]),
                follower: JointId::new(joints[follower.index()]),
                law,
            },
        };
        other.joints[joints[index]] = mech_compiler::model::Joint {
            kind,
            ..old.clone()
        };
    }
    for motor in &mut other.motors {
        motor.joint = JointId::new(joints[motor.joint.index()]);
    }
    other
}

/// Where each entry goes; with `first` the first stays, as the ground must.
fn permutation(count: usize, dice: &mut Dice, first: bool) -> Vec<usize> {
    let mut places: Vec<usize> = (0..count).collect();
    let low = usize::from(first);
    for index in (low + 1..count).rev() {
        places.swap(index, low + dice.below(index + 1 - low));
    }
    places
}

/// What may not change: the loops by the names of their unknown joints, and their levels; or the kind of the first diagnosis.
fn outcome(model: &Model) -> Result<BTreeSet<(BTreeSet<String>, usize)>, String> {
    let compiled = compile(model).map_err(|diagnoses| {
        let text = format!("{:?}", diagnoses[0]);
        text.split([' ', '{']).next().unwrap_or_default().to_owned()
    })?;
    let names = |joints: Vec<JointId>| {
        joints
            .into_iter()
            .map(|joint| model.joint(joint).name.clone())
            .collect()
    };
    Ok(compiled
        .plan
        .loops()
        .map(|closing| (names(closing.unknowns()), closing.level))
        .collect())
}

#[test]
fn shuffled_declarations_make_the_same_mechanism() {
    let cases = std::env::var("MECH_CASES")
        .ok()
        .and_then(|cases| cases.parse().ok())
        .unwrap_or(2_000);
    for seed in 0..cases {
        let mut dice = Dice::new(seed);
        let additions = 1 + dice.below(8);
        let grown = grow(&mut dice, additions);
        let other = shuffled(&grown.model, &mut dice);
        assert_eq!(outcome(&grown.model), outcome(&other), "seed {seed}");
    }
}

#[test]
fn shuffled_declarations_of_what_is_broken_have_the_same_verdict() {
    for seed in 0..1_000 {
        let mut dice = Dice::new(seed);
        let additions = 2 + dice.below(6);
        let mut model = grow(&mut dice, additions).model;
        // A joint too few, so that something stays free; or no motor.
        if dice.once_in(2) || model.joints.iter().any(|joint| joint.kind.rolls()) {
            model
                .motors
                .remove(MotorId::new(dice.below(model.motors.len())).index());
        } else {
            let loose: Vec<JointId> = model
                .joint_ids()
                .filter(|&joint| model.motor_of(joint).is_none())
                .collect();
            if model.links.iter().any(|link| link.die.is_some()) {
                continue;
            }
            if loose.is_empty() {
                continue;
            }
            let gone = *dice.pick(&loose);
            model.joints.remove(gone.index());
            for motor in &mut model.motors {
                if motor.joint > gone {
                    motor.joint = JointId::new(motor.joint.index() - 1);
                }
            }
        }
        let other = shuffled(&model, &mut dice);
        let (one, another) = (outcome(&model), outcome(&other));
        assert!(one.is_err(), "seed {seed}: something is missing");
        assert_eq!(one, another, "seed {seed}");
    }
}
