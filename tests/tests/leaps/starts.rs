//! What compiles, moves: from its start each motor goes a little in one direction at least, or stops in both at a real limit.

use mech_compiler::evaluate::{Machine, Stop};
use mech_test_support::journeys::{Family, Subject};
use mech_test_support::judge::{Curve, End};
use mech_test_support::{Dice, cases, seeds};

/// Moves that are tried.
const SMALL: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];

/// The motors that cannot be moved although they could be.
pub(crate) fn stuck(subject: &Subject) -> Vec<String> {
    let program = &subject.compiled.program;
    let start = Machine::<f64>::new(program);
    let motors = &program.start.motors;
    let mut all = Vec::new();
    for motor in 0..motors.len() {
        let displacements = SMALL.iter().flat_map(|displacement| [*displacement, -*displacement]);
        let goals: Vec<Vec<f64>> = displacements
            .map(|displacement| {
                let mut goal = motors.clone();
                goal[motor] += displacement;
                goal
            })
            .collect();
        let outcomes: Vec<Result<(), Stop>> =
            goals.iter().map(|goal| start.clone().move_to(goal)).collect();
        let is_limit = |outcome: &Result<(), Stop>| {
            matches!(outcome, Err(Stop::Open(_) | Stop::DeadPoint(_) | Stop::ChangePoint(_)))
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

#[test]
fn what_compiles_moves() {
    for (family, usual) in [(Family::Wild, 90), (Family::Coupled, 30)] {
        let (mut all, mut compiled) = (Vec::new(), 0);
        for seed in seeds(cases(usual)) {
            let text = family.text(&mut Dice::new(seed), false);
            if let Ok(subject) = Subject::read(&text) {
                compiled += 1;
                let stuck = stuck(&subject).into_iter();
                all.extend(stuck.map(|what| format!("seed {seed}: {what}\n{text}")));
            }
        }
        println!("{family:?}: {compiled} compiled");
        assert!(all.is_empty(), "{} stuck: {}", all.len(), all[0]);
        assert!(compiled > 0, "none was tried");
    }
}

#[test]
fn a_strut_moves() {
    let subject = Subject::of(include_str!("../../cases/leaps/strut.txt"));
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    let start = subject.compiled.program.start.motors.clone();
    let to = [start[0] + 0.05, start[1]];
    assert_eq!(machine.move_to(&to), Ok(()), "from {start:?} to {to:?}");
}
