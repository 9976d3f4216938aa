//! What is shown alone leaps as it does in the whole mechanism, although fewer loops are watched in a move.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::LinkId;
use mech_compiler::program::Position;
use mech_test_support::journeys::{Family, Subject, apart, off};
use mech_test_support::{Dice, cases, seeds};
use std::f64::consts::TAU;

/// Leaps of one mechanism.
const LEAPS: u64 = 8;

/// How much rounding may do to a position: more where it is near a dead point.
fn rounding(subject: &Subject, at: &Position<f64>) -> f64 {
    let small = 1e-7;
    let poses = subject.poses(at);
    let extent = subject.extent(&poses);
    let mut most = 1.0_f64;
    for motor in 0..at.motors.len() {
        for distance in [small, -small] {
            let mut machine = Machine::new(&subject.compiled.program);
            machine.put_back(at.clone());
            let mut goal = at.motors.clone();
            goal[motor] += distance;
            most = most.max(match machine.move_to(&goal) {
                Ok(()) => apart(&poses, &subject.poses(machine.position()), extent) / small,
                Err(_) => 1e8,
            });
        }
    }
    // Of the motors' values themselves, too: they may be large.
    let values = at.motors.iter().map(|value| value.abs());
    (1e4 * f64::EPSILON * most * values.fold(1.0, f64::max)).clamp(1e-6, 1e-2)
}

/// A target: by a little, by some turns, or far away.
fn target(dice: &mut Dice, subject: &Subject, at: &[f64]) -> Vec<f64> {
    let size = mech_test_support::size(&subject.model).max(1.0);
    let turn = *dice.pick(&[0.3, 3.0, 7.0, 7.0, 40.0, 50.0 * TAU]);
    let slide = *dice.pick(&[0.1, 1.0, 4.0, 20.0]) * size;
    let only = dice.below(2 * at.len());
    let mut to = at.to_vec();
    for (number, value) in to.iter_mut().enumerate() {
        let most = if subject.slides(number) { slide } else { turn };
        let displacement = dice.between(-most, most);
        if only >= at.len() || only == number {
            *value += displacement;
        }
    }
    to
}

/// What is wrong with the first leap that a mechanism of a family makes otherwise where it shows one link; and how many were compared.
fn wrong(family: &Family, seed: u64) -> (Option<String>, u64) {
    let mut dice = Dice::new(seed);
    let plain = family.text(&mut dice, false);
    let Ok(whole) = Subject::read(&plain) else {
        return (None, 0);
    };
    let links: Vec<LinkId> = whole.model.declared_links().collect();
    let link = *dice.pick(&links);
    let text = format!("{plain}\nshow {};", whole.model.link(link).name);
    let part = Subject::read(&text).unwrap_or_else(|why| panic!("seed {seed}: {why}\n{text}"));
    let place = part.compiled.program.place_of(link).expect("it is shown");
    let begin = Machine::<f64>::new(&whole.compiled.program);
    let begin_shown = Machine::<f64>::new(&part.compiled.program);
    let (mut machine, mut shown) = (begin.clone(), begin_shown.clone());
    let mut count = 0;
    for _ in 0..LEAPS {
        let start = machine.position().motors.clone();
        let to = target(&mut dice, &whole, &start);
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
            let why = format!("seed {seed}, from {start:?} to {to:?}: {why}\n{text}");
            return (Some(why), count);
        }
    }
    (None, count)
}

#[test]
fn what_is_shown_leaps_as_in_the_whole() {
    for (family, usual) in [(Family::Wild, 30), (Family::Coupled, 6)] {
        let (mut all, mut count) = (Vec::new(), 0);
        for seed in seeds(cases(usual)) {
            let (found, leaps) = wrong(&family, seed);
            all.extend(found);
            count += leaps;
        }
        println!("{count} leaps of what is shown alone");
        assert!(all.is_empty(), "{} wrong of {count}\n{}", all.len(), all[0]);
        assert!(count > 0, "none was compared");
    }
}
