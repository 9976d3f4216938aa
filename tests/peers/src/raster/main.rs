//! The rasteriser beside other crates: two scenes of 512 × 512 pixels, cleared and painted.

#[path = "../../../benches/common/mod.rs"]
mod common;
mod peers;
mod scene;

use common::{Threshold, compare};
use mech_runtime::{Frame, Smooth};
use peers::{EmbeddedGraphics, TinySkia, Vello, Zeno};
use scene::{SIDE, paint};

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
        let ours = frame.pixels().as_flattened().iter().filter(|&&pixel| pixel != 0).count();
        println!("pixels painted: {ours}, by tiny-skia's mask {}", skia.covered());
        for (name, pixels) in
            [("tiny-skia", skia.pixels()), ("vello_cpu", vello.pixels()), ("zeno", zeno.pixels())]
        {
            println!(
                "mean difference of a channel to {name}: {:.4} of 255",
                difference(&smooth, pixels)
            );
        }
        let mut show = |peer: &str, limit, mut theirs: Box<dyn FnMut() + '_>| {
            compare(
                &format!("{name}, hard edges, {peer}"),
                [peer, "ours"],
                1.0,
                limit,
                &mut theirs,
                || hard(&mut frame),
            );
        };
        show("tiny-skia mask", Threshold::AtLeast(mask_limit), Box::new(|| skia.mask()));
        show("tiny-skia", Threshold::None, Box::new(|| skia.paint(false)));
        show("embedded-graphics", Threshold::None, Box::new(|| embedded.paint()));
        let mut show = |peer: &str, limit, mut theirs: Box<dyn FnMut() + '_>| {
            compare(
                &format!("{name}, smooth, {peer}"),
                [peer, "ours"],
                1.0,
                limit,
                &mut theirs,
                || soft(&mut smooth),
            );
        };
        show("zeno", Threshold::AtLeast(1.5), Box::new(|| zeno.paint(true)));
        show("zeno's masks alone", Threshold::None, Box::new(|| zeno.paint(false)));
        show("vello_cpu", Threshold::AtLeast(1.5), Box::new(|| vello.paint()));
        show("tiny-skia", Threshold::AtLeast(1.5), Box::new(|| skia.paint(true)));
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
