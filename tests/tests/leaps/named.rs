//! Texts of `tests/cases/leaps/`, in which moves went wrong once or easily could: what stands above each is true of it.
//!
//! - `// to 1, 2` are values of the motor, to each of which it goes from the start as the judge does. Several motors stand side by side.
//! - `// row 1, 2` are displacements from the start, between which it moves in a row.
//! - `// random 7 15 4` are random targets in a row: their seed, how many they are, and how far each motor goes at most.
//! - `// steps 4000 1, 2`: of the judge these are not known. In one leap it comes where so many steps lead.
//! - `// with WORD 3, 4 by 0.5`: in what follows each of these stands for the word, and moves are so many times as long. `// and` has a
//!   second word for each of them.
//! - `// journeys` and `// back from dead points`: random journeys of all kinds, or those that come back from their stops.
//! - `// moves`: from the start each motor moves.

use super::starts::stuck;
use mech_compiler::evaluate::Machine;
use mech_compiler::program::Position;
use mech_test_support::journeys::{Family, Kind, Subject, apart, faults, tally};
use mech_test_support::{Case, Dice, folder};

/// A text in which a word stands for nothing any more, and by how much its moves are longer.
type Variant = (String, f64);

/// Each of these texts with each of some values in the place of a word.
fn replaced(variants: &[Variant], fact: &str) -> Vec<Variant> {
    let (word, values) = fact.split_once(' ').expect("a word and its values");
    let each = variants.iter().flat_map(|(text, longer)| {
        values.split(", ").map(move |value| {
            let (value, by) = value.split_once(" by ").unwrap_or((value, "1"));
            let by: f64 = by.parse().expect("a number");
            (text.replace(word, value), longer * by)
        })
    });
    each.collect()
}

fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(' ');
    words.map(|word| word.parse().expect("a number")).collect()
}

/// Random targets, each motor by no more than its reach from its start, and within its range.
fn random(subject: &Subject, fact: &str) -> Vec<Vec<f64>> {
    let mut words = fact.splitn(3, ' ');
    let mut next = || words.next().expect("seed, number and reaches");
    let mut dice = Dice::new(next().parse().expect("a seed"));
    let count: usize = next().parse().expect("a number");
    let reach = numbers(next());
    let start = &subject.compiled.program.start.motors;
    let mut target = || {
        let part = *dice.pick(&[0.05, 0.3, 1.0]);
        let all = start.iter().zip(&reach).zip(&subject.model.motors);
        all.map(|((start, reach), motor)| {
            let to = start + dice.between(-part * reach, part * reach);
            motor.range.map_or(to, |range| to.clamp(range.low, range.high))
        })
        .collect()
    };
    (0..count).map(|_| target()).collect()
}

/// What is wrong with the moves that a fact has.
fn wrong(subject: &Subject, (word, rest): (&str, &str), longer: f64) -> Vec<String> {
    let start = &subject.compiled.program.start.motors;
    let targets = match word {
        "random" => random(subject, rest),
        _ => rest
            .split(", ")
            .map(|to| {
                let all = numbers(to).into_iter().zip(start);
                all.map(|(to, start)| to * longer + if word == "row" { *start } else { 0.0 })
                    .collect()
            })
            .collect(),
    };
    let found = faults(subject, &targets, word != "to");
    let lines = found.into_iter().map(|(fault, what)| format!("{fault:?}: {what}"));
    lines.collect()
}

/// Where so many equal steps to a value of the motor lead.
fn stepped(subject: &Subject, to: f64, steps: u32) -> Position<f64> {
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    let from = machine.position().motors[0];
    for step in 1..=steps {
        let goal = from + (to - from) * f64::from(step) / f64::from(steps);
        if machine.move_toward(&[goal]) != Ok(None) {
            break;
        }
    }
    machine.position().clone()
}

/// What a leap and steps do not have in common.
fn unlike_steps(subject: &Subject, fact: &str) -> Vec<String> {
    let (steps, targets) = fact.split_once(' ').expect("a number and values");
    let steps = steps.parse().expect("a number");
    let targets = targets.split(", ").flat_map(numbers);
    let unlike = targets.filter_map(|to| {
        let [one, small] = [1, steps].map(|steps| stepped(subject, to, steps));
        let off = (one.motors[0] - small.motors[0]).abs();
        let apart = apart(&one.poses, &small.poses, subject.extent(&small.poses));
        // Where it stops, at a dead point, half of the digits are left.
        let most = if one.motors[0] == to { 1e-6 } else { 1e-3 };
        let same = off <= 1e-6 * (1.0 + to.abs()) && apart <= most;
        (!same).then(|| format!("to {to}: {} and {}, {apart:e}", one.motors[0], small.motors[0]))
    });
    unlike.collect()
}

/// What is wrong with a text by what stands above it, either random journeys or all else; and how many facts that are.
fn judged(case: &Case, wanders: bool) -> (Vec<String>, usize) {
    let plain = vec![(case.text.clone(), 1.0)];
    let (mut variants, mut found, mut facts) = (plain.clone(), Vec::new(), 0);
    for fact in case.marks("") {
        let (word, rest) = fact.split_once(' ').unwrap_or((fact, ""));
        if matches!(word, "journeys" | "back") != wanders {
            continue;
        }
        facts += 1;
        match word {
            "with" => variants = replaced(&plain, rest),
            "and" => variants = replaced(&variants, rest),
            "to" | "row" | "random" => {
                for (text, longer) in &variants {
                    found.extend(wrong(&Subject::of(text), (word, rest), *longer));
                }
            }
            "steps" => found.extend(unlike_steps(&Subject::of(&case.text), rest)),
            "moves" => found.extend(stuck(&Subject::of(&case.text))),
            // Small steps are the same for any seed.
            "journeys" => {
                for (kind, seeds) in [(Kind::Steps, 0..1), (Kind::Leaps, 0..3), (Kind::Stops, 0..3)]
                {
                    found.extend(wander(&case.text, kind, seeds));
                }
            }
            "back" => {
                for kind in [Kind::Leaps, Kind::Stops] {
                    found.extend(wander(&case.text, kind, 0..10));
                }
            }
            "=" => facts -= 1,
            _ => panic!("no fact: {fact}"),
        }
    }
    (found, facts)
}

fn wander(text: &str, kind: Kind, seeds: std::ops::Range<u64>) -> Option<String> {
    let family = Family::Text(text.to_owned());
    let found = tally(kind, &family, seeds, text.contains(": f32;"), 1);
    (!found.faults.is_empty()).then(|| format!("{kind:?}: {found:#?}"))
}

#[track_caller]
fn nothing_is_wrong(wanders: bool, least: usize) {
    let (mut all, mut facts) = (Vec::new(), 0);
    for case in folder("leaps") {
        let (found, count) = judged(&case, wanders);
        facts += count;
        all.extend(found.first().map(|first| {
            let count = found.len();
            format!("{}, {count} times: {first}", case.name)
        }));
    }
    assert!(all.is_empty(), "{} wrong\n{}", all.len(), all.join("\n"));
    assert!(facts >= least, "{facts}");
}

#[test]
fn what_went_astray_once_does_so_no_more() {
    nothing_is_wrong(false, 50);
}

#[test]
fn what_went_astray_on_a_journey_does_so_no_more() {
    nothing_is_wrong(true, 13);
}
