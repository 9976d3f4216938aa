//! What playing costs in time: `cargo run --release -p mech-studio --example play_times`.

use mech_runtime::overlay::Spot;
use mech_studio::play::{Control, Layer, Mechanism, Player, SIZE, Stage};
use mech_studio::{Document, Source};
use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A chain of four-bars, each driven by the rocker of the one before.
fn chain(loops: u32) -> String {
    let mut text =
        "struct Chain;\nlink r0;\njoint a = revolute(ground, r0) at (0, 0);\n".to_owned();
    for number in 1..=loops {
        let before = number - 1;
        let x = 4.0 * f64::from(before);
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "link c{number}; link r{number};
             joint b{number} = revolute(r{before}, c{number}) at ({}, 0.6);
             joint k{number} = revolute(c{number}, r{number}) at ({}, 2.9);
             joint d{number} = revolute(ground, r{number}) at ({}, 0);",
            x + 0.8,
            x + 3.3,
            x + 4.0
        );
    }
    text + "motor a;\n"
}

fn mechanism(document: &Document) -> Mechanism {
    let declaration = &document.declarations()[0];
    let reading = document.analyse(declaration).expect("the compiler works");
    let compiled = reading.result.expect("it is coherent");
    Mechanism::new(reading.model, *compiled).expect("it can be played")
}

/// The middle of the times of some calls, in milliseconds.
fn milliseconds(mut what: impl FnMut()) -> f64 {
    let mut all: Vec<f64> = (0..61)
        .map(|_| {
            let start = Instant::now();
            what();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

fn measure(name: &str, document: &Document) {
    let start = Instant::now();
    let player = Player::new(mechanism(document), Vec::new(), SIZE);
    let begin = start.elapsed().as_secs_f64() * 1e3;
    let mut stage = Stage::new(player, PathBuf::new()).expect("there is memory");
    let step = milliseconds(|| stage.player.advance(1.0 / 60.0));
    let picture = painting(&mut stage);
    let drag = drag(&mut stage.player);
    for layer in Layer::ALL {
        if layer != Layer::Shapes {
            stage.player.obey(Control::Toggle(layer));
        }
    }
    let all = painting(&mut stage);
    println!(
        "{name}: begins in {begin:.0} ms, steps in {step:.2} ms, follows the pointer in {drag:.1} ms, is painted in {picture:.2} ms, with all layers in {all:.2} ms: {:.0} frames a second",
        1e3 / (step + picture)
    );
}

/// How long it takes to paint a picture, with words.
fn painting(stage: &mut Stage) -> f64 {
    milliseconds(|| {
        black_box(stage.caption().expect("there is memory"));
    })
}

/// How long it takes to follow the pointer with the last link, which goes round a place that it reaches.
fn drag(player: &mut Player) -> f64 {
    let spots = (1..).map(|link| Spot { link, at: [0.0; 2] });
    let pixels = spots.map_while(|spot| player.pixel(spot));
    let [x, y] = pixels.last().expect("a link moves");
    player.obey(Control::Press([x, y]));
    let mut angle = 0.0_f64;
    let time = milliseconds(|| {
        angle += 0.1;
        let [u, v] = [15.0 * (angle.cos() - 1.0), 15.0 * angle.sin()];
        player.obey(Control::Point([x + u, y + v]));
    });
    player.obey(Control::Release);
    time
}

fn main() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/gallery/src/mechanisms");
    for name in ["crane", "walker", "skeleton"] {
        let path = gallery.join(name).with_extension("rs");
        measure(name, &Document::read(&path).expect("it is in the gallery"));
    }
    for loops in [10, 100] {
        let document = Document::of(Source::new("a.mech", chain(loops)));
        measure(&format!("chain of {loops} loops"), &document);
    }
}
