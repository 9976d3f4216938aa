//! Rows of parallelograms whose change points coincide or nearly do: all cranks stay parallel, however far a move goes.

use super::judge::wrapped;
use super::reading::Subject;
use mech_compiler::evaluate::Machine;
use proptest::prelude::*;
use std::f64::consts::PI;
use std::fmt::Write as _;

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
            if turned {
                [lengths[1], lengths[0]]
            } else {
                lengths
            }
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
    let subject = Subject::read(text).unwrap_or_else(|wrong| panic!("{wrong}\n{text}"));
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    for by in moves {
        let to = machine.position().motors[0] + by;
        machine
            .move_to(&[to])
            .unwrap_or_else(|stop| panic!("{stop:?} to {to}\n{text}"));
        let cranks = machine.position().poses.iter().step_by(2);
        for (number, [cos, sin, ..]) in cranks.enumerate() {
            let off = wrapped(sin.atan2(*cos) - to);
            assert!(
                off.abs() < 1e-5,
                "crank {number} is off by {off} at {to}\n{text}"
            );
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
