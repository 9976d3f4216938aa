//! What compiles, moves: from its start each motor goes a little in one direction at least, or stops in both at a real limit.

use super::drawing::{Drawing, coupled, sequential};
use super::random::runner;
use super::reading::Subject;
use mech_compiler::evaluate::{Machine, Stop};
use mech_test_support::judge::{Curve, End};
use mech_test_support::{cases, seeds};
use proptest::strategy::{Strategy, ValueTree as _};

/// Moves that are tried.
const SMALL: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];

/// The motors that cannot be moved although they could be.
fn stuck(subject: &Subject) -> Vec<String> {
    let program = &subject.compiled.program;
    let start = Machine::<f64>::new(program);
    let motors = &program.start.motors;
    let mut all = Vec::new();
    for motor in 0..motors.len() {
        let displacements = SMALL
            .iter()
            .flat_map(|displacement| [*displacement, -*displacement]);
        let goals: Vec<Vec<f64>> = displacements
            .map(|displacement| {
                let mut goal = motors.clone();
                goal[motor] += displacement;
                goal
            })
            .collect();
        let outcomes: Vec<Result<(), Stop>> = goals
            .iter()
            .map(|goal| start.clone().move_to(goal))
            .collect();
        let is_limit = |outcome: &Result<(), Stop>| {
            matches!(
                outcome,
                Err(Stop::Open(_) | Stop::DeadPoint(_) | Stop::ChangePoint(_))
            )
        };
        let judged = |goal: &[f64]| {
            let judge = subject.judge_at(start.position());
            Curve::new(&judge, &judge.start(), [motors, goal]).end == End::Arrives
        };
        // Nothing so near is too far; and of two limits side by side one is none.
        let all_limits = outcomes.iter().all(is_limit);
        let wrong = goals.iter().zip(&outcomes).find(|(goal, outcome)| {
            let suspicious = outcome.is_err() && (all_limits || !is_limit(outcome));
            suspicious && judged(goal)
        });
        if let Some((goal, outcome)) = wrong {
            all.push(format!("from {motors:?} to {goal:?}: {outcome:?}"));
        }
    }
    all
}

fn stuck_of(strategy: &impl Strategy<Value = Drawing>, default: u64) -> Vec<String> {
    let mut all = Vec::new();
    for seed in seeds(cases(default)) {
        let drawn = strategy
            .new_tree(&mut runner(seed))
            .expect("a drawing")
            .current()
            .drawn();
        if let Ok(subject) = Subject::read(&drawn.text) {
            all.extend(
                stuck(&subject)
                    .into_iter()
                    .map(|text| format!("seed {seed}: {text}\n{}", drawn.text)),
            );
        }
    }
    all
}

#[track_caller]
fn assert_none(wrong: &[String]) {
    assert!(
        wrong.is_empty(),
        "{} stuck, the first: {}",
        wrong.len(),
        wrong[0]
    );
}

#[test]
fn sequential_mechanisms_that_compile_move() {
    assert_none(&stuck_of(&sequential(6), 60));
}

#[test]
fn coupled_mechanisms_that_compile_move() {
    assert_none(&stuck_of(&coupled(), 20));
}

#[test]
fn a_strut_moves() {
    assert_none(&stuck(&Subject::of(include_str!("texts/strut.txt"))));
    let subject = Subject::of(include_str!("texts/strut.txt"));
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    let start = subject.compiled.program.start.motors.clone();
    let to = [start[0] + 0.05, start[1]];
    assert_eq!(machine.move_to(&to), Ok(()), "from {start:?} to {to:?}");
}

#[test]
fn named_mechanisms_move() {
    let texts = [
        include_str!("texts/polar.txt"),
        include_str!("texts/rpr121.txt"),
        include_str!("texts/s1008.txt"),
        include_str!("texts/s1022.txt"),
        include_str!("texts/s25.txt"),
        include_str!("texts/s5180.txt"),
        include_str!("texts/s5256.txt"),
        include_str!("texts/t3.txt"),
        include_str!("texts/tanhalf.txt"),
    ];
    let wrong: Vec<String> = texts
        .into_iter()
        .flat_map(|text| {
            stuck(&Subject::of(text))
                .into_iter()
                .map(move |why| format!("{why}\n{text}"))
        })
        .collect();
    assert_none(&wrong);
}
