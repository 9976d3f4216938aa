//! The rasteriser beside other crates: two scenes of 512 × 512 pixels, cleared and painted.

mod peers;
mod scene;

use mech_runtime::{Frame, Smooth};
use mech_tests::median;
use peers::{EmbeddedGraphics, TinySkia, Vello, Zeno};
use scene::{SIDE, paint};
use std::time::Instant;

/// Rounds, in each of which both paint some pictures in turn.
const ROUNDS: usize = 61;
const PICTURES: u32 = 6;

/// Milliseconds a picture.
fn time(paint: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..PICTURES {
        paint();
    }
    start.elapsed().as_secs_f64() * 1e3 / f64::from(PICTURES)
}

/// Prints how many times as long theirs takes as ours: the median of all rounds.
fn compare(what: &str, limit: Option<f64>, mut theirs: impl FnMut(), mut ours: impl FnMut()) {
    let rounds: Vec<_> = (0..ROUNDS)
        .map(|_| [time(&mut theirs), time(&mut ours)])
        .collect();
    let [theirs, ours] = [0, 1].map(|who| median(rounds.iter().map(|round| round[who])));
    let ratio = median(rounds.iter().map(|round| round[0] / round[1]));
    let verdict = match limit {
        None => "no threshold".to_owned(),
        Some(limit) if ratio >= limit => format!("at least {limit}"),
        Some(limit) => format!("at least {limit}: MISSED"),
    };
    println!("{what:<40} {theirs:.3} ms, ours {ours:.3} ms, ratio {ratio:.2} ({verdict})");
}

fn main() {
    for (name, screens, mask_limit) in [("links", 0.46, 3.0), ("fat", 2.75, 2.2)] {
        println!("\n{name}: 20 hexagons and 10 circles, {screens} screens");
        let scene = scene::scene(screens);
        let mut frame = Box::new(Frame::<512, 512>::new());
        let mut smooth = Box::new(Smooth::<512, 512>::new());
        let mut skia = TinySkia::new(&scene);
        let mut vello = Vello::new(&scene);
        let mut zeno = Zeno::new(&scene);
        let mut embedded = EmbeddedGraphics::new(&scene);
        let hard = |frame: &mut Frame<512, 512>| {
            frame.clear();
            paint(&scene, frame);
        };
        let soft = |smooth: &mut Smooth<512, 512>| {
            smooth.clear();
            paint(&scene, smooth);
        };
        hard(&mut frame);
        soft(&mut smooth);
        skia.mask();
        skia.paint(true);
        vello.paint();
        zeno.paint(true);
        let ours = frame
            .pixels()
            .as_flattened()
            .iter()
            .filter(|&&pixel| pixel != 0)
            .count();
        println!(
            "pixels painted: {ours}, by tiny-skia's mask {}",
            skia.covered()
        );
        for (name, pixels) in [
            ("tiny-skia", skia.pixels()),
            ("vello_cpu", vello.pixels()),
            ("zeno", zeno.pixels()),
        ] {
            println!(
                "mean difference of a channel to {name}: {:.4} of 255",
                difference(&smooth, pixels)
            );
        }
        let mut show = |peer: &str, limit, mut theirs: Box<dyn FnMut() + '_>| {
            compare(
                &format!("{name}, hard edges, {peer}"),
                limit,
                &mut theirs,
                || hard(&mut frame),
            );
        };
        show("tiny-skia mask", Some(mask_limit), Box::new(|| skia.mask()));
        show("tiny-skia", None, Box::new(|| skia.paint(false)));
        show("embedded-graphics", None, Box::new(|| embedded.paint()));
        let mut show = |peer: &str, limit, mut theirs: Box<dyn FnMut() + '_>| {
            compare(
                &format!("{name}, smooth, {peer}"),
                limit,
                &mut theirs,
                || soft(&mut smooth),
            );
        };
        show("zeno", Some(1.5), Box::new(|| zeno.paint(true)));
        show("zeno's masks alone", None, Box::new(|| zeno.paint(false)));
        show("vello_cpu", Some(1.5), Box::new(|| vello.paint()));
        show("tiny-skia", Some(1.5), Box::new(|| skia.paint(true)));
    }
}

/// Of pictures of which one is upside down.
fn difference(smooth: &Smooth<512, 512>, pixels: &[u8]) -> f64 {
    let rows = pixels.chunks_exact(4 * usize::from(SIDE)).rev();
    let sum: u64 = smooth
        .pixels()
        .iter()
        .zip(rows)
        .flat_map(|(ours, theirs)| ours.as_flattened().iter().zip(theirs))
        .map(|(ours, theirs)| u64::from(ours.abs_diff(*theirs)))
        .sum();
    sum as f64 / (4.0 * f64::from(SIDE) * f64::from(SIDE))
}
