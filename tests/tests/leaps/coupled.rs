//! Coupled loops in which two pins coincide: what hangs on these turns with the crank as one body.

use super::parallel::{none, wrong_in_steps};
use mech_compiler::evaluate::Machine;
use mech_test_support::journeys::Subject;

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
        include_str!("../../cases/leaps/s990355.txt"),
        include_str!("../../cases/leaps/s990599.txt"),
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
    let subject = Subject::of(include_str!("../../cases/leaps/s990355.txt"));
    let change_point: f64 = 2.999_944_305_4;
    let mut found = Vec::new();
    for distance in [0.0, 1e-12, 1e-9, 1e-8, 1e-7, 2e-7, 3e-7, 1e-6, 1e-5, 1e-4] {
        for first in [0.0, 3.2] {
            for (at, onwards) in
                [distance, -distance].into_iter().flat_map(|at| [(at, 0.1), (at, -0.2)])
            {
                let mut machine = Machine::<f64>::new(&subject.compiled.program);
                let outcome = [first, change_point + at, change_point + onwards].map(|to| {
                    let outcome = machine.move_to(&[to]);
                    (outcome, off_one_body(&subject, &machine, 4))
                });
                let [_, near, beyond] = outcome;
                let refused = near.0.is_err() && distance >= 1e-6;
                if refused || beyond.0.is_err() || near.1.max(beyond.1) > 1e-6 {
                    found.push(format!("from {first} by {at:e}, then by {onwards}: {outcome:?}"));
                }
            }
        }
    }
    none(&subject, &found);
}
