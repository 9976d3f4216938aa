//! The outcome does not depend on the order in which a mechanism is declared.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Axis, AxisId, JointId, JointKind, LinkId, Model, MotorId};
use mech_tests::{Dice, Sample, coupled_samples, for_all, model, samples};
use std::collections::BTreeSet;

/// The same mechanism, declared in another order.
pub(crate) fn shuffle(model: &Model, dice: &mut Dice) -> Model {
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
    for_all(100, &samples(1..=8), |Sample { grown, mut dice }| {
        let other = shuffle(&grown.model, &mut dice);
        assert_eq!(outcome(&grown.model), outcome(&other));
    });
}

/// Where every declared link is after some small moves, in the order of their names; less if it cannot be moved so far.
fn motion(model: &Model, moves: &[Vec<f64>]) -> Vec<Vec<[f64; 4]>> {
    let compiled = compile(model).expect("it was compiled before");
    let mut names: Vec<(&str, usize)> = model
        .declared_links()
        .enumerate()
        .map(|(place, link)| (model.link(link).name.as_str(), place))
        .collect();
    names.sort_unstable();
    let mut machine = Machine::<f64>::new(&compiled.program);
    let mut places = Vec::new();
    for motors in moves {
        if machine.move_to(motors).is_err() {
            break;
        }
        let poses = &machine.position().poses;
        places.push(names.iter().map(|(_, place)| poses[*place]).collect());
    }
    places
}

fn moves(model: &Model, dice: &mut Dice) -> Vec<Vec<f64>> {
    let mut motors = vec![0.0; model.motors.len()];
    let mut next = || {
        for motor in &mut motors {
            *motor += dice.between(-0.02, 0.03);
        }
        motors.clone()
    };
    (0..20).map(|_| next()).collect()
}

#[test]
fn shuffled_declarations_of_what_is_solved_together_make_the_same_mechanism() {
    let mut compiled = 0;
    for_all(
        150,
        &coupled_samples(1..=4),
        |Sample { grown, mut dice }| {
            let model = grown.model;
            let other = shuffle(&model, &mut dice);
            let found = outcome(&model);
            assert_eq!(found, outcome(&other));
            if found.is_err() {
                return;
            }
            compiled += 1;
            let moves = moves(&model, &mut dice);
            let (one, another) = (motion(&model, &moves), motion(&other, &moves));
            assert_eq!(one.len(), another.len());
            for (one, another) in one.iter().flatten().zip(another.iter().flatten()) {
                let near = one.iter().zip(another).all(|(a, b)| (a - b).abs() < 1e-8);
                assert!(near, "{one:?} and {another:?}");
            }
        },
    );
    println!("{compiled} compiled");
}

/// In whichever order these statements stand, the mechanism moves by so many loops.
fn is_solved_in_any_order(statements: &[&str], end: &str, loops: usize) {
    let mut dice = Dice::new(0);
    for _ in 0..60 {
        let order = permutation(statements.len(), &mut dice, false);
        let statements: String = order.iter().map(|&place| statements[place]).collect();
        let text = format!("struct M; {statements} {end} allow coupled;");
        let found = outcome(&model(&text)).expect("it moves");
        assert_eq!(found.len(), loops, "{found:?}");
    }
}

/// A platform on three legs, of which one drives a wheel that carries a chain.
#[test]
fn a_chain_behind_a_platform_is_solved_after_it() {
    is_solved_in_any_order(
        &[
            "link l1;",
            "link l2; link l3;",
            "link l4; link l5;",
            "link l6; link l11;",
            "link l12;",
            "joint j0 = revolute(ground, l1) at (0.68, -2.9);",
            "joint j1 = revolute(l1, l3) at (0.62, 0.97);",
            "joint j2 = revolute(l3, l2) at (-1.58, 0.88);",
            "joint j3 = revolute(ground, l4) at (-2.64, -2.5);",
            "joint j4 = revolute(l4, l2) at (3.4, 1.19);",
            "joint j5 = revolute(ground, l5) at (3.15, -0.69);",
            "joint j6 = revolute(l5, l2) at (0.28, -2.0);",
            "joint j7 = revolute(l1, l6) at (-3.63, -2.09);",
            "joint j8 = gear(l3, l6, 20 : 60 on l1);",
            "joint j15 = revolute(l3, l11) at (-3.55, 0.92);",
            "joint j16 = revolute(l11, l12) at (-2.97, 2.06);",
            "joint j17 = prismatic(l6, l12) at (-1.52, 1.4) along (0.58, -0.82);",
        ],
        "motor j0;",
        2,
    );
}

/// Slides keep the direction of one wheel of a gear, so that it moves its other wheel at once, and ties nothing in the loops.
#[test]
fn a_gear_that_slides_hold_ties_no_loop() {
    is_solved_in_any_order(
        &[
            "link l1; link l2;",
            "link l3; link l4;",
            "link l5;",
            "link l6; link l7;",
            "joint j0 = prismatic(ground, l1) at (-2.45, 2.94) along (-0.81, 0.58);",
            "joint j1 = revolute(ground, l2) at (-2.74, 4.27);",
            "joint j2 = revolute(l2, l3) at (3.37, -1.44);",
            "joint j3 = prismatic(l3, l4) at (0.33, -2.12) along (-0.87, -0.5);",
            "joint j4 = revolute(l4, l1) at (-2.65, -1.13);",
            "joint j5 = rack(l2, l4, radius -0.53 on l3);",
            "joint j6 = prismatic(l4, l5) at (2.11, -3.31) along (0.83, -0.56);",
            "joint j7 = revolute(l5, l6) at (-2.0, -1.73);",
            "joint j8 = prismatic(l3, l6) at (1.65, 2.59) along (-0.12, 0.99);",
            "joint j9 = revolute(l6, l7) at (2.5, -0.99);",
            "joint j10 = gear(l5, l7, 31 : -60);",
        ],
        "motor j0;",
        2,
    );
}

#[test]
fn shuffled_declarations_of_what_is_broken_have_the_same_verdict() {
    for_all(100, &samples(2..=7), |Sample { grown, mut dice }| {
        let mut model = grown.model;
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
            if loose.is_empty() || model.links.iter().any(|link| link.die.is_some()) {
                return;
            }
            let joint = *dice.pick(&loose);
            model.joints.remove(joint.index());
            for motor in &mut model.motors {
                if motor.joint > joint {
                    motor.joint = JointId::new(motor.joint.index() - 1);
                }
            }
        }
        let other = shuffle(&model, &mut dice);
        let (one, another) = (outcome(&model), outcome(&other));
        assert!(one.is_err(), "something is missing");
        assert_eq!(one, another);
    });
}
