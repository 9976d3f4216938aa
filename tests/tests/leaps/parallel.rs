//! Parallelograms stay parallelograms, however far a move goes: random rows of them whose change points coincide or nearly do, and
//! some by name.

use mech_compiler::evaluate::Machine;
use mech_test_support::journeys::Subject;
use mech_test_support::judge::wrap;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write as _;

/// What is wrong with the first of so many equal steps, by so much in all, after which links are off by more than a millionth.
pub(crate) fn wrong_in_steps(
    subject: &Subject,
    far: f64,
    steps: u32,
    off: impl Fn(&Machine<'_, f64>) -> f64,
) -> Option<String> {
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    (1..=steps).find_map(|step| {
        let to = far * f64::from(step) / f64::from(steps);
        let outcome = machine.move_to(&[to]);
        let off = off(&machine);
        let fails = outcome.is_err() || off > 1e-6;
        fails.then(|| format!("to {far} in {steps} steps: at {to} {outcome:?}, off by {off:.2e}"))
    })
}

/// Tests that nothing wrong was found with a mechanism.
#[track_caller]
pub(crate) fn none(subject: &Subject, found: &[String]) {
    assert!(
        found.is_empty(),
        "{} wrong\n{}\n{}",
        found.len(),
        found[..4.min(found.len())].join("\n"),
        subject.text
    );
}

/// One parallelogram: from the crank before it to the next.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// How long the cranks are, and how far their pivots are apart.
    lengths: [f64; 2],
    /// The direction from pivot to pivot.
    direction: f64,
    /// Where it is flat: the turn of the first crank.
    flat: f64,
    /// Whether it lies folded there.
    folded: bool,
}

fn cell(flat: impl Strategy<Value = f64>) -> impl Strategy<Value = Cell> {
    // Rhombi too: where they are folded, pins meet; and what is nearly one, down to a millionth.
    let near = (-6.0..-1.0).prop_map(|power| 1.0 - 10.0_f64.powf(power));
    let part = prop_oneof![Just(1.0), near, 0.4..0.9];
    let lengths =
        (0.5..3.0, part, any::<bool>()).prop_map(|(long, part, turned): (f64, f64, bool)| {
            let lengths = [long, long * part];
            if turned { [lengths[1], lengths[0]] } else { lengths }
        });
    (lengths, -PI..PI, flat, any::<bool>()).prop_map(|(lengths, direction, flat, folded)| Cell {
        lengths,
        direction,
        flat,
        folded,
    })
}

/// A single parallelogram, which is not flat at the start.
fn alone() -> impl Strategy<Value = Vec<Cell>> {
    cell(0.4..PI - 0.4).prop_map(|cell| vec![cell])
}

/// A row whose change points are at one place, or apart by any power of ten.
fn row() -> impl Strategy<Value = Vec<Cell>> {
    let sign = |minus: bool| if minus { -1.0 } else { 1.0 };
    let gap = || {
        let apart = (-13.0..-1.0).prop_map(|power| 10.0_f64.powf(power));
        prop_oneof![1 => Just(0.0), 4 => apart]
    };
    // Not where it starts: there nothing tells how it goes on.
    let away = (0.4..PI - 0.4, any::<bool>()).prop_map(move |(turn, minus)| sign(minus) * turn);
    let gaps = prop::collection::vec(cell(gap()), 2..4);
    (away, gaps, any::<bool>()).prop_map(move |(mut flat, mut cells, minus)| {
        for cell in &mut cells {
            flat += sign(minus) * cell.flat;
            cell.flat = flat;
        }
        cells
    })
}

/// Moves of the crank, one after the other.
fn moves() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-7.0..7.0, 1..4)
}

fn text(cells: &[Cell], method: &str) -> String {
    let mut links = String::new();
    let mut pivots = String::from("point p0 = (0, 0);");
    let mut joints = String::from("joint j0 = revolute(ground.p0, r0.o);");
    let (mut at, mut arm) = ([0.0, 0.0], String::new());
    let write = "a string";
    for (number, cell) in cells.iter().enumerate() {
        let next = number + 1;
        let [crank, apart] = cell.lengths;
        let (sin, cos) = cell.direction.sin_cos();
        at = [at[0] + apart * cos, at[1] + apart * sin];
        let phase = cell.direction - cell.flat + if cell.folded { PI } else { 0.0 };
        let pin = [crank * phase.cos(), crank * phase.sin()];
        write!(pivots, " point p{next} = ({}, {});", at[0], at[1]).expect(write);
        writeln!(
            links,
            "link r{number} {{ point o = (0, 0); {arm} point q = ({}, {}); }} link k{number} {{ point a = (0, 0); point b = ({apart}, 0); }}",
            pin[0], pin[1]
        )
        .expect(write);
        writeln!(
            joints,
            "joint j{next} = revolute(ground.p{next}, r{next}.o); joint a{number} = revolute(r{number}.q, k{number}.a); \
             joint b{number} = revolute(k{number}.b, r{next}.p);"
        )
        .expect(write);
        arm = format!("point p = ({}, {});", pin[0], pin[1]);
    }
    let last = cells.len();
    let near = (1..=last).map(|next| format!("r{next} near 0;"));
    let near: String = near.collect();
    format!(
        "struct Row; ground {{ {pivots} }} {links} link r{last} {{ point o = (0, 0); {arm} }} {joints} motor j0; start {{ {near} }} {method}"
    )
}

/// Moves a row and looks at all its cranks.
fn stay_parallel(text: &str, moves: &[f64]) {
    let subject = Subject::of(text);
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    for by in moves {
        let to = machine.position().motors[0] + by;
        machine.move_to(&[to]).unwrap_or_else(|stop| panic!("{stop:?} to {to}\n{text}"));
        let cranks = machine.position().poses.iter().step_by(2);
        for (number, [cos, sin, ..]) in cranks.enumerate() {
            let off = wrap(sin.atan2(*cos) - to);
            assert!(off.abs() < 1e-5, "crank {number} is off by {off} at {to}\n{text}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn a_parallelogram_stays_one_however_far_it_goes(
        cells in alone(),
        moves in prop::collection::vec(-300.0..300.0, 1..4),
    ) {
        stay_parallel(&text(&cells, ""), &moves);
    }

    #[test]
    fn all_cranks_stay_parallel(cells in row(), moves in moves()) {
        stay_parallel(&text(&cells, ""), &moves);
    }

    #[test]
    fn all_cranks_stay_parallel_by_iteration(cells in row(), moves in moves()) {
        stay_parallel(&text(&cells, "method newton;"), &moves);
    }
}

/// The second change point comes so soon behind the first that a line to it would begin before the first.
#[test]
fn two_change_points_that_nearly_coincide() {
    let cell = |crank, flat| Cell { lengths: [crank, 0.5], direction: 0.0, flat, folded: false };
    let cells =
        [cell(0.308_820_570_723_256_2, 0.947_346_924_228_682_7), cell(0.5, 0.947_329_735_481_967)];
    stay_parallel(&text(&cells, ""), &[-5.260_746_027_353_87, -0.502_763_240_083_480_7]);
}

/// Of three change points within a thousandth of a degree one is passed alone, and a line to the other two must not begin before it.
#[test]
fn three_change_points_that_nearly_coincide() {
    let cell = |apart, flat, folded| Cell { lengths: [0.5, apart], direction: 0.0, flat, folded };
    let cells = [
        cell(0.45, 0.4, true),
        cell(0.2, 0.400_010_968_097_652_85, false),
        cell(0.5, 0.400_012_141_011_745_15, false),
    ];
    stay_parallel(&text(&cells, ""), &[3.776_903_876_563_644]);
}

/// A parallelogram drawn with rounded places, nearly a rhombus: where it lies folded, rounding of its lengths is more than that of the
/// short distance of its pins.
#[test]
fn a_parallelogram_that_is_nearly_a_rhombus() {
    let subject = Subject::of(include_str!("../../cases/leaps/near-rhombus.txt"));
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    for step in 1..=600 {
        let target = [5.0 * f64::from(step)];
        machine.move_to(&target).expect("it goes round");
        let [cos, ..] = machine.position().poses[1];
        assert!(cos > 0.999, "its coupler has turned at {target:?}");
    }
}

/// The coupler of a parallelogram does not turn, however far the crank does.
#[test]
fn a_parallelogram_behind_gears_stays_one() {
    for (ratio, speed) in [
        ("1 : 40", 0.025),
        ("17 : 40", 0.425),
        ("7 : 1", 7.0),
        ("1 : 3", 1.0 / 3.0),
        ("100 : 1", 100.0),
    ] {
        let subject =
            Subject::with(include_str!("../../cases/leaps/worm-parallelogram.txt"), "RATIO", ratio);
        for step in [0.1, 1.0, 5.0, 30.0, 200.0] {
            let step: f64 = step / speed * 0.025;
            let mut machine = Machine::<f64>::new(&subject.compiled.program);
            let mut at = 0.0;
            while at < 20.0 / speed {
                at += step;
                let to = machine.move_to(&[at]);
                let [cos, sin, ..] = subject.poses(machine.position())[3];
                assert!(
                    to.is_ok() && sin.abs() < 1e-6 && cos > 0.0,
                    "{ratio}: at {at} in steps of {step}: {to:?}, its coupler has turned to {:.4}",
                    sin.atan2(cos)
                );
            }
        }
    }
}

/// A bar on three equal cranks, one of which is redundant, in line or not: whatever they do, the bar does not turn. At a quarter
/// of a turn cranks and bar are in line.
#[test]
fn a_parallelogram_with_a_redundant_crank() {
    for (x, y) in [(4, 0), (2, 0), (2, -1), (1, 2), (20, -30)] {
        let subject = Subject::of(&format!(
            "struct M;
            link first; link second; link third; link bar;
            joint a = revolute(ground, first) at (0, 0);
            joint b = revolute(ground, second) at (3, 0);
            joint c = revolute(ground, third) at ({x}, {y});
            joint d = revolute(first, bar) at (0, 1);
            joint e = revolute(second, bar) at (3, 1);
            joint f = revolute(third, bar) at ({x}, {});
            motor a; allow redundant;",
            y + 1
        ));
        let off = |machine: &Machine<'_, f64>| {
            let sine = machine.position().motors[0].sin();
            let poses = subject.poses(machine.position());
            let sines = [sine, sine, sine, 0.0].into_iter().zip(&poses[1..]);
            let off = sines.map(|(sine, pose)| (pose[1] - sine).abs());
            off.fold(0.0, f64::max)
        };
        let mut found = Vec::new();
        for far in [0.3, 1.0, 1.5, FRAC_PI_2, 1.7, 2.5, 7.0, -0.3, -1.5, -FRAC_PI_2, -1.7, -2.2] {
            for steps in [1, 7, 50] {
                found.extend(wrong_in_steps(&subject, far, steps, off));
            }
        }
        none(&subject, &found);
    }
}

/// A crank swings one side of a parallelogram until it is flat for a moment, and back. Whatever the steps, it stays a parallelogram: the
/// side that faces the one that only slides does not turn.
#[test]
fn a_parallelogram_that_is_flat_for_a_moment() {
    let subject = Subject::of(include_str!("../../cases/leaps/touch.txt"));
    for to in [4.3, 4.44, 5.0, 3.9] {
        for steps in [1_u32, 2, 10, 100, 1000, 10_000] {
            let mut machine = Machine::<f64>::new(&subject.compiled.program);
            for step in 1..=steps {
                let past = 4.45 * f64::from(step) / f64::from(steps);
                machine.move_to(&[past]).expect("it turns");
            }
            machine.move_to(&[to]).expect("it turns");
            let sine = subject.poses(machine.position())[4][1];
            assert!(sine.abs() < 1e-9, "to {to} in {steps} steps: {sine}");
        }
    }
}
