//! The outcome does not depend on the order in which a mechanism is declared.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, Model, MotorId};
use mech_test_support::{
    Dice, Sample, apart, cases, chain, coupled_samples, driven_elsewhere, folder, for_all, model,
    on_any_ground, reach, reordered, samples, shuffle, shuffled, size, with_ground, worst_gap,
};
use std::collections::BTreeSet;

/// What may not change: the loops by the names of their unknown joints, and their levels; or the kind of the first diagnosis.
fn outcome(model: &Model) -> Result<BTreeSet<(BTreeSet<String>, usize)>, String> {
    let compiled = compile(model).map_err(|diagnoses| {
        let text = format!("{:?}", diagnoses[0]);
        text.split([' ', '{']).next().unwrap_or_default().to_owned()
    })?;
    let names = |joints: Vec<JointId>| {
        joints.into_iter().map(|joint| model.joint(joint).name.clone()).collect()
    };
    Ok(compiled.plan.loops().map(|closing| (names(closing.unknowns()), closing.level)).collect())
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
    let mut compiled = 0;
    for_all(300, &samples(1..=6), |Sample { grown, mut dice }| {
        let model = on_any_ground(&grown.model, &mut dice);
        if let Some(model) = driven_elsewhere(&model, &mut dice) {
            let other = shuffled(&model, &mut dice);
            compiled += u64::from(are_the_same(&model, &other, &mut dice));
        }
    });
    println!("{compiled} compiled");
    assert!(2 * compiled > cases(300), "{compiled} compiled");
}

#[test]
fn shuffled_declarations_of_what_is_solved_together_make_the_same_mechanism() {
    let mut compiled = 0;
    for_all(150, &coupled_samples(1..=4), |Sample { grown, mut dice }| {
        let other = shuffled(&grown.model, &mut dice);
        compiled += u64::from(are_the_same(&grown.model, &other, &mut dice));
    });
    println!("{compiled} compiled");
    assert!(4 * compiled > 3 * cases(150), "{compiled} compiled");
}

/// In whichever order the lines of a text stand after the first, the mechanism moves by so many loops, and in the same way; or it is refused
/// alike.
#[test]
fn texts_mean_the_same_in_any_order() {
    let cases = folder("orders");
    assert!(cases.len() >= 7);
    for case in cases {
        let mut dice = Dice::new(0);
        let mut statements: Vec<&str> = case.statements().collect();
        let declared = model(&statements.concat());
        let loops = case.marks("loops").next();
        let loops = loops.map(|loops| loops.parse::<usize>().expect("a number"));
        let refused = case.marks("refused").next();
        assert!(loops.is_some() != refused.is_some(), "{}", case.name);
        for _ in 0..60 {
            shuffle(&mut statements[1..], &mut dice);
            let other = model(&statements.concat());
            let found = outcome(&other);
            assert_eq!(found.as_ref().map(BTreeSet::len).ok(), loops, "{}: {found:?}", case.name);
            assert_eq!(found.err().as_deref(), refused, "{}", case.name);
            assert_eq!(are_the_same(&declared, &other, &mut dice), loops.is_some());
        }
    }
}

#[test]
fn shuffled_declarations_of_what_is_broken_have_the_same_verdict() {
    for_all(100, &samples(2..=7), |Sample { grown, mut dice }| {
        let mut model = grown.model;
        // A joint too few, so that something stays free; or no motor.
        if dice.once_in(2) || model.joints.iter().any(|joint| joint.kind.rolls()) {
            model.motors.remove(MotorId::new(dice.below(model.motors.len())).index());
        } else {
            let loose: Vec<JointId> =
                model.joint_ids().filter(|&joint| model.motor_of(joint).is_none()).collect();
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
