//! The outcome does not depend on the order in which a mechanism is declared.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, Model, MotorId};
use mech_test_support::{
    Dice, Sample, apart, chain, coupled_samples, driven_elsewhere, for_all, model, on_any_ground,
    reach, reordered, samples, shuffle, shuffled, size, with_ground, worst_gap,
};
use std::collections::BTreeSet;

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

/// Where every declared link is after some small moves, in the order of their names; less if it cannot be moved so far. Every joint is
/// closed as it is declared.
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
        let all = with_ground(model, poses);
        let gap = worst_gap(model, &all) / reach(&all).max(size(model));
        assert!(gap < 1e-13, "torn by {gap:e} of its size at {motors:?}");
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

/// Two orders of the same mechanism have the same loops, and move alike. Says whether it moves.
fn are_the_same(one: &Model, another: &Model, dice: &mut Dice) -> bool {
    let found = outcome(one);
    assert_eq!(found, outcome(another));
    if found.is_err() {
        return false;
    }
    let moves = moves(one, dice);
    let same = |motors: &Vec<f64>| reordered(motors, one, another);
    let others: Vec<Vec<f64>> = moves.iter().map(same).collect();
    let (one, another) = (motion(one, &moves), motion(another, &others));
    assert_eq!(one.len(), another.len());
    for (one, another) in one.iter().zip(&another) {
        assert!(apart(one, another) < 1e-8, "{one:?} and {another:?}");
    }
    true
}

#[test]
fn shuffled_declarations_make_the_same_mechanism() {
    for_all(300, &samples(1..=8), |Sample { grown, mut dice }| {
        let other = shuffled(&grown.model, &mut dice);
        are_the_same(&grown.model, &other, &mut dice);
    });
    let dice = &mut Dice::new(0);
    for loops in 1..20 {
        let chain = chain(loops);
        assert!(are_the_same(&chain, &shuffled(&chain, dice), dice));
    }
}

#[test]
fn shuffled_declarations_on_any_ground_driven_anywhere_make_the_same_mechanism() {
    for_all(300, &samples(1..=6), |Sample { grown, mut dice }| {
        let model = on_any_ground(&grown.model, &mut dice);
        if let Some(model) = driven_elsewhere(&model, &mut dice) {
            let other = shuffled(&model, &mut dice);
            are_the_same(&model, &other, &mut dice);
        }
    });
}

#[test]
fn shuffled_declarations_of_what_is_solved_together_make_the_same_mechanism() {
    let mut compiled = 0;
    for_all(
        150,
        &coupled_samples(1..=4),
        |Sample { grown, mut dice }| {
            let other = shuffled(&grown.model, &mut dice);
            compiled += u64::from(are_the_same(&grown.model, &other, &mut dice));
        },
    );
    println!("{compiled} compiled");
}

/// In whichever order these statements stand, the mechanism moves by so many loops, and in the same way.
fn is_solved_in_any_order(statements: &[&str], end: &str, loops: usize) {
    let mut dice = Dice::new(0);
    let mut statements = statements.to_vec();
    let text = |statements: &[&str]| {
        let statements = statements.concat();
        model(&format!("struct M; {statements} {end} allow coupled;"))
    };
    let declared = text(&statements);
    for _ in 0..60 {
        shuffle(&mut statements, &mut dice);
        let other = text(&statements);
        let found = outcome(&other).expect("it moves");
        assert_eq!(found.len(), loops, "{found:?}");
        assert!(are_the_same(&declared, &other, &mut dice));
    }
}

/// The motor is between two moving links. Both loops of the second level were accepted in one pass, and the first took the frame in which
/// the second was described.
#[test]
fn tongs_that_are_driven_in_the_middle_close() {
    is_solved_in_any_order(
        &[
            "link c;",
            "link a;",
            "link b;",
            "link d;",
            "joint base = revolute(ground, a) at (0, 0);",
            "joint wheel = slot(b, ground) at (4, 0) along (1, 0);",
            "joint mid = revolute(a, b) at (2, 0.5);",
            "joint right = revolute(a, c) at (4, 1);",
            "joint left = revolute(b, d) at (0, 1);",
            "joint mid2 = revolute(c, d) at (2, 1.5);",
        ],
        "motor mid;",
        2,
    );
}

#[test]
fn bars_that_are_rigid_with_a_rod_turn_with_it() {
    is_solved_in_any_order(
        &[
            "link crank;",
            "link d;",
            "link rod;",
            "link e;",
            "link block;",
            "joint m = revolute(ground, crank) at (0, 0);",
            "joint p = revolute(crank, rod) at (1, 1);",
            "joint q = revolute(rod, block) at (4, 0);",
            "joint x = prismatic(ground, block) at (4, 0) along (1, 0);",
            "joint s = revolute(rod, d) at (2, 2);",
            "joint t = revolute(d, e) at (3, 3);",
            "joint u = revolute(rod, e) at (3, 1);",
        ],
        "motor m;",
        2,
    );
}

#[test]
fn four_bars_in_series_close() {
    is_solved_in_any_order(
        &[
            "link crank;",
            "link rod;",
            "link rocker;",
            "link second_crank;",
            "link second_rod;",
            "link second_rocker;",
            "joint a = revolute(ground, crank) at (0, 0);",
            "joint b = revolute(crank, rod) at (0, 1);",
            "joint c = revolute(rod, rocker) at (3, 2);",
            "joint d = revolute(ground, rocker) at (3, 0);",
            "joint e = revolute(rocker, second_crank) at (3.5, 1.5);",
            "joint f = revolute(second_crank, second_rod) at (4, 2.2);",
            "joint g = revolute(second_rod, second_rocker) at (6, 2);",
            "joint h = revolute(rocker, second_rocker) at (6.2, 0.3);",
        ],
        "motor b; motor f;",
        2,
    );
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

/// Slides keep the angle of a coupler, and the motor drives it: equal cranks hold it, too, and it cannot turn. The wheel makes the angles tied.
#[test]
fn a_motor_that_would_turn_the_coupler_of_equal_cranks_is_refused_in_any_order() {
    let mut dice = Dice::new(0);
    let mut statements = [
        "link a;",
        "link b; link w;",
        "link c;",
        "link s; link t;",
        "joint a0 = revolute(ground, a) at (0, 0);",
        "joint b0 = revolute(ground, b) at (3, 1);",
        "joint a1 = revolute(a, c) at (1, 2);",
        "joint b1 = revolute(b, c) at (4, 3);",
        "joint x = prismatic(ground, t) at (2, 5) along (1, 0);",
        "joint y = prismatic(t, s) at (2, 5) along (0, 1);",
        "joint m = revolute(s, c) at (2, 4);",
        "joint v = revolute(c, w) at (3, 4);",
        "joint g = belt(w, a, 1 : 2);",
    ];
    for _ in 0..60 {
        shuffle(&mut statements, &mut dice);
        let text =
            |statements: &str| model(&format!("struct M; {statements} motor m; allow coupled;"));
        let equal = statements.concat();
        let unequal = equal.replace("at (4, 3)", "at (4.5, 3.2)");
        assert_eq!(outcome(&text(&equal)), Err("DeadStart".to_owned()));
        let found = outcome(&text(&unequal)).expect("it moves");
        assert_eq!(found.len(), 2, "{found:?}");
    }
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
        let other = shuffled(&model, &mut dice);
        let (one, another) = (outcome(&model), outcome(&other));
        assert!(one.is_err(), "something is missing");
        assert_eq!(one, another);
    });
}
