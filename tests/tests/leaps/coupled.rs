//! Coupled loops, by name, in which leaps went wrong once or easily could.

use super::families::{assert_leaps, none, targets, values, wrong_in_steps};
use super::reading::Subject;
use mech_compiler::evaluate::Machine;

#[test]
fn robots_whose_loops_wait_for_each_other() {
    let subject = Subject::of(include_str!("texts/rpr121.txt"));
    let to = vec![
        -1.130_138_241_821_159_9,
        1.737_036_454_520_985,
        -1.980_555_410_391_568_8,
    ];
    let mut all = vec![to];
    all.extend(targets(&subject, 2, 12, &[3.0, 3.0, 3.0]));
    assert_leaps(&subject, &all);
}

/// A whole turn of what gears turn leads coupled loops back to where they were: nothing may be leapt over on the way.
#[test]
fn coupled_behind_gears_that_speed_up() {
    let subject = Subject::of(include_str!("texts/s991460.txt"));
    assert_leaps(&subject, &values(&[1.153_595_189_303_182_2, -0.9]));
}

/// How far links of coupled loops in which two pins coincide are off: what hangs on these turns with the crank as one body.
fn off_one_body(subject: &Subject, machine: &Machine<'_, f64>, body: usize) -> f64 {
    let crank = machine.position().motors[0];
    let poses = subject.poses(machine.position());
    let off = |link: usize| {
        let angle: f64 = if link <= body { crank } else { 0.0 };
        let [cos, sin, ..] = poses[link];
        (cos - angle.cos()).hypot(sin - angle.sin())
    };
    (1..=body + 1).map(off).fold(0.0, f64::max)
}

/// Two pins coincide. Twice in a turn another assembly crosses the one that turns as one body: no step, however long, goes over to it.
#[test]
fn coupled_loops_go_straight_on_through_their_change_points() {
    for text in [
        include_str!("texts/s990355.txt"),
        include_str!("texts/s990599.txt"),
    ] {
        let subject = Subject::of(text);
        let mut found = Vec::new();
        for far in [3.0, 5.5, -4.0, 20.0] {
            for steps in [1_u32, 2, 3, 5, 10, 40, 100, 300, 1000, 3000, 20_000] {
                let off = |machine: &Machine<'_, f64>| off_one_body(&subject, machine, 4);
                found.extend(wrong_in_steps(&subject, far, steps, off));
            }
        }
        none(&subject, &found);
    }
}

/// Only where rounding hides the branch a move is refused. Wherever it is not, it goes on from there to either side.
#[test]
fn coupled_loops_do_not_stay_at_their_change_points() {
    let subject = Subject::of(include_str!("texts/s990355.txt"));
    let change_point: f64 = 2.999_944_305_4;
    let mut found = Vec::new();
    for distance in [0.0, 1e-12, 1e-9, 1e-8, 1e-7, 2e-7, 3e-7, 1e-6, 1e-5, 1e-4] {
        for first in [0.0, 3.2] {
            for (at, onwards) in [distance, -distance]
                .into_iter()
                .flat_map(|at| [(at, 0.1), (at, -0.2)])
            {
                let mut machine = Machine::<f64>::new(&subject.compiled.program);
                let outcome = [first, change_point + at, change_point + onwards].map(|to| {
                    let outcome = machine.move_to(&[to]);
                    (outcome, off_one_body(&subject, &machine, 4))
                });
                let [_, near, beyond] = outcome;
                let refused = near.0.is_err() && distance >= 1e-6;
                if refused || beyond.0.is_err() || near.1.max(beyond.1) > 1e-6 {
                    found.push(format!(
                        "from {first} by {at:e}, then by {onwards}: {outcome:?}"
                    ));
                }
            }
        }
    }
    none(&subject, &found);
}

/// Coupled loops near their dead point, and a slide behind them that goes far out: both are at their ends in one leap.
#[test]
fn coupled_s990519() {
    let subject = Subject::of(include_str!("texts/s990519.txt"));
    let far = values(&[0.405, 0.41, 1.0, 5.0, 32.6, -0.1, -20.0]);
    assert_leaps(&subject, &far);
}
