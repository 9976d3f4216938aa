//! What the examples that measure times have in common: large mechanisms, and clocks.

use mech_studio::{Assembly, Command, JointForm};
use std::time::Instant;

/// A chain of four-bars, each driven by the rocker of the one before: three joints a loop, and the motor's.
pub(crate) fn chain(loops: usize) -> String {
    let mut text =
        "struct Chain;\nlink r0;\njoint a = revolute(ground, r0) at (0, 0);\n".to_owned();
    for number in 1..=loops {
        let before = number - 1;
        let x = 4.0 * count(before);
        text += &format!(
            "link c{number}; link r{number};\n\
             joint b{number} = revolute(r{before}, c{number}) at ({}, 0.6);\n\
             joint k{number} = revolute(c{number}, r{number}) at ({}, 2.9);\n\
             joint d{number} = revolute(ground, r{number}) at ({}, 0);\n",
            x + 0.8,
            x + 3.3,
            x + 4.0
        );
    }
    text + "motor a;\n"
}

/// A small number.
pub(crate) fn count(number: usize) -> f64 {
    u32::try_from(number).map_or(f64::NAN, f64::from)
}

/// A joint of such a chain that is too many.
pub(crate) fn joint_too_many(loops: usize) -> Command {
    Command::Join(Assembly {
        name: "extra".to_owned(),
        kind: JointForm::Revolute,
        ends: ["r1".to_owned(), format!("r{loops}")],
        at: Some(["1".to_owned(), "1".to_owned()]),
        along: None,
    })
}

/// How long something takes, in milliseconds.
pub(crate) fn milliseconds(what: impl FnOnce()) -> f64 {
    let start = Instant::now();
    what();
    start.elapsed().as_secs_f64() * 1e3
}

/// Some times of the same, the shortest first.
pub(crate) fn times(count: usize, mut what: impl FnMut()) -> Vec<f64> {
    let mut all: Vec<f64> = (0..count).map(|_| milliseconds(&mut what)).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// The middle of some times of the same.
pub(crate) fn middle(count: usize, what: impl FnMut()) -> f64 {
    times(count, what)[count / 2]
}
