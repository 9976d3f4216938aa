//! What pictures cost: dirty rectangles beside full repaints, and a whole frame of Andrews' squeezer, solved and drawn.

#[path = "common/mod.rs"]
mod common;

use common::{Threshold, compare};
use mech_gallery::{
    andrews::AndrewsSqueezer, four_bar::CrankRocker, geared_piston::GearedPiston,
    jansen::JansenLeg, watt::Watt,
};
use mech_runtime::{Frame, Mechanism, Smooth, Stage};
use std::f64::consts::TAU;
use std::hint::black_box;

/// Positions in a turn: how a mechanism moves that takes four seconds for it, at 60 pictures a second.
const STEPS: u32 = 240;

/// Goes on to the next position.
struct Motion<M> {
    mechanism: M,
    start: f64,
    step: u32,
}

impl<M: Mechanism<Scalar = f64, Motors = [f64; 1]>> Motion<M> {
    fn new() -> Self {
        let mechanism = M::new();
        let [start] = mechanism.motors();
        Self { mechanism, start, step: 0 }
    }

    fn go_on(&mut self) -> &M {
        self.step = (self.step + 1) % STEPS;
        let angle = self.start + TAU * f64::from(self.step) / f64::from(STEPS);
        black_box(self.mechanism.move_to([angle])).expect("it turns");
        &self.mechanism
    }
}

/// A whole picture of 512 × 512 pixels beside one in which only what has moved is painted again.
fn repaints<M: Mechanism<Scalar = f64, Motors = [f64; 1]>>(threshold: Threshold) {
    let (mut full, mut part) = (Motion::<M>::new(), Motion::<M>::new());
    let mut frame = Box::new(Frame::<512, 512>::new());
    let mut stage = Box::new(Stage::<512, 512, 128>::new());
    frame.look_at(M::view(512, 512));
    stage.look_at(M::view(512, 512));
    compare(
        &format!("{}, whole picture or what moved", M::NAME),
        ["Frame", "Stage"],
        1.0,
        threshold,
        || {
            let mechanism = full.go_on();
            frame.clear();
            mechanism.draw(black_box(&mut *frame));
        },
        || {
            let mechanism = part.go_on();
            black_box(&mut *stage).show(|canvas| mechanism.draw(canvas));
        },
    );
    let pixels: usize = stage.changed().map(|area| area.width * area.height).sum();
    #[expect(clippy::cast_precision_loss, reason = "a picture has fewer")]
    let part = 100.0 * pixels as f64 / (512.0 * 512.0);
    println!("    {} rectangles, {:.1} % of the picture", stage.changed().count(), part);
}

/// A frame of Andrews' squeezer, and its share that is spent on solving.
fn whole_frame() {
    let (mut solved, mut drawn) =
        (Motion::<AndrewsSqueezer>::new(), Motion::<AndrewsSqueezer>::new());
    let mut frame = Box::new(Frame::<512, 512>::new());
    frame.look_at(AndrewsSqueezer::view(512, 512));
    let (share, [_, whole]) = compare(
        "Andrews' squeezer, solved or solved and drawn",
        ["solve", "both"],
        1.0,
        Threshold::None,
        || {
            black_box(solved.go_on());
        },
        || {
            let mechanism = drawn.go_on();
            frame.clear();
            mechanism.draw(black_box(&mut *frame));
        },
    );
    println!(
        "    {:.1} µs a frame (at most 60: {}), of which {:.1} % are the solve",
        whole / 1000.0,
        if whole < 60_000.0 { "kept" } else { "MISSED" },
        100.0 * share
    );
    let mut soft = Motion::<AndrewsSqueezer>::new();
    let mut hard = Motion::<AndrewsSqueezer>::new();
    let mut smooth = Box::new(Smooth::<512, 512>::new());
    smooth.look_at(AndrewsSqueezer::view(512, 512));
    compare(
        "Andrews' squeezer, soft edges or hard",
        ["Smooth", "Frame"],
        1.0,
        Threshold::None,
        || {
            let mechanism = soft.go_on();
            smooth.clear();
            mechanism.draw(black_box(&mut *smooth));
        },
        || {
            let mechanism = hard.go_on();
            frame.clear();
            mechanism.draw(black_box(&mut *frame));
        },
    );
}

fn main() {
    whole_frame();
    repaints::<CrankRocker>(Threshold::None);
    repaints::<Watt>(Threshold::None);
    repaints::<AndrewsSqueezer>(Threshold::None);
    repaints::<JansenLeg>(Threshold::AtLeast(4.0));
    repaints::<GearedPiston>(Threshold::None);
}
