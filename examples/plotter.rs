//! A plotter with two arms writes a word. Its motors follow the pen: the compiler solves them in closed form.
//!
//! Run it with `cargo run --example plotter`. It prints the steps of both motors as CSV, and writes `target/plotter.gif`.

use mech_runtime::files::Gif;
use mech_runtime::{HeapFrame, mechanism};
use std::{error::Error, f64::consts::TAU, fs, time::Duration};

mechanism! {
    /// Both motors stand on the ground. The trace keeps what the pen has written.
    struct Plotter;
    link left; link right; link rod;
    link pen { point tip = (0, 4); }
    joint l = revolute(ground, left) at (-1, 0);
    joint r = revolute(ground, right) at (1, 0);
    joint lk = revolute(left, pen) at (-2.4, 1.8);
    joint rk = revolute(right, rod) at (2.4, 1.8);
    joint tip = revolute(pen, rod) at (0, 4);
    motor l;
    motor r;
    follow pen.tip by l, r;
    effects { trace pen.tip 600; }
}

/// A stepper motor makes so many steps a turn.
const STEPS: f64 = 3200.0;

/// The word in one stroke: columns and rows of a grid.
#[rustfmt::skip]
const WORD: [[i32; 2]; 26] = [
    [0, 0], [0, 8], [2, 3], [4, 8], [4, 0], // M
    [9, 0], [6, 0], [6, 4], [8, 4], [6, 4], [6, 8], [9, 8], [6, 8], [6, 0], // E
    [14, 0], [11, 0], [11, 8], [14, 8], [11, 8], [11, 0], // C
    [16, 0], [16, 8], [16, 4], [20, 4], [20, 8], [20, 0], // H
];

fn main() -> Result<(), Box<dyn Error>> {
    let place = |[x, y]: [i32; 2]| [0.15 * f64::from(x) - 1.5, 0.15 * f64::from(y) + 2.6];
    let mut plotter = Plotter::new();
    plotter.reach(place(WORD[0]))?;
    plotter.clear_traces();
    fs::create_dir_all("target")?;
    let mut frame = HeapFrame::of::<Plotter>(480, 360)?;
    let file = fs::File::create("target/plotter.gif")?;
    let mut film = Gif::new(file, &frame, Duration::from_millis(40))?;
    println!("left,right"); // steps from where both motors stood when it was declared
    for ends in WORD.windows(2) {
        let [from, to] = [place(ends[0]), place(ends[1])];
        for step in 1..=12 {
            let part = f64::from(step) / 12.0;
            plotter.reach([0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part))?;
            let [left, right] = plotter.motors().map(|value| (value / TAU * STEPS).round());
            println!("{left},{right}");
            frame.clear();
            plotter.draw(&mut frame);
            film.add(&frame)?;
        }
    }
    Ok(film.finish()?)
}
