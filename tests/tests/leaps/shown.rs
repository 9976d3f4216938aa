//! What is shown alone leaps as it does in the whole mechanism, although fewer loops are watched in a move.

use super::comparing::{MOST_STEPS, compare, rounding, shorten};
use super::drawing::{Drawing, coupled, sequential};
use super::random::{runner, target};
use super::reading::Subject;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::LinkId;
use mech_test_support::journeys::off;
use mech_test_support::{Dice, cases, seeds};
use proptest::strategy::{Strategy, ValueTree as _};

/// Leaps of one mechanism.
const LEAPS: u64 = 8;

/// What is wrong with the leaps of a mechanism that shows one link, beside the whole; and how many were compared.
fn wrong(seed: u64, drawing: &Drawing) -> (Vec<String>, u64) {
    let drawn = drawing.drawn();
    let Ok(whole) = Subject::read(&drawn.text) else {
        return (Vec::new(), 0);
    };
    let mut dice = Dice::new(seed);
    let links: Vec<LinkId> = whole.model.declared_links().collect();
    let link = *dice.pick(&links);
    let text = format!("{}\nshow {};", drawn.text, whole.model.link(link).name);
    let part = Subject::read(&text).unwrap_or_else(|why| panic!("seed {seed}: {why}\n{text}"));
    let place = part.compiled.program.place_of(link).expect("it is shown");
    let begin = Machine::<f64>::new(&whole.compiled.program);
    let begin_shown = Machine::<f64>::new(&part.compiled.program);
    let (mut machine, mut shown) = (begin.clone(), begin_shown.clone());
    let (mut all, mut count) = (Vec::new(), 0);
    for _ in 0..LEAPS {
        let start = machine.position().clone();
        let to = target(&mut dice, &drawn, &whole, &start.motors);
        let to = shorten(&whole, &start, &to, MOST_STEPS);
        if machine.move_to(&to).is_err() {
            (machine, shown) = (begin.clone(), begin_shown.clone());
            continue;
        }
        count += 1;
        let why = if let Err(stop) = shown.move_to(&to) {
            Some(format!("{stop:?}"))
        } else {
            let poses = whole.poses(machine.position());
            let (alone, extent) = (&shown.position().poses[place], whole.extent(&poses));
            let off = off(alone, &poses[link.index()], extent);
            (off > rounding(&whole, machine.position())).then(|| format!("off by {off:.2e}"))
        };
        if let Some(why) = why {
            // Where the whole is wrong, that is another matter.
            if compare(&whole, &start, &to).0.is_empty() {
                all.push(format!(
                    "seed {seed}, from {:?} to {to:?}: {why}\n{text}",
                    start.motors
                ));
            }
            break;
        }
    }
    (all, count)
}

#[track_caller]
fn assert_none(strategy: &impl Strategy<Value = Drawing>, default: u64) {
    let (mut all, mut count) = (Vec::new(), 0);
    for seed in seeds(cases(default)) {
        let tree = strategy.new_tree(&mut runner(seed)).expect("a drawing");
        let (found, leaps) = wrong(seed, &tree.current());
        all.extend(found);
        count += leaps;
    }
    println!("{count} leaps of what is shown alone");
    assert!(all.is_empty(), "{} wrong of {count}\n{}", all.len(), all[0]);
    assert!(count > 0, "none was compared");
}

#[test]
fn of_sequential_mechanisms() {
    assert_none(&sequential(6), 20);
}

#[test]
fn of_coupled_mechanisms() {
    assert_none(&coupled(), 4);
}
