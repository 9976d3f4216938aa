//! What playing costs in time: `cargo run --release -p mech-studio --example play_times`.

#[expect(dead_code, reason = "what all of them share")]
mod timing;

use mech_runtime::overlay::Spot;
use mech_studio::play::{Control, Layer, Mechanism, Player, SIZE, Stage};
use mech_studio::{Document, Source};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;
use timing::{chain, middle};

fn mechanism(document: &Document) -> Mechanism {
    let declaration = &document.declarations()[0];
    let reading = document.analyse(declaration).expect("the compiler works");
    let compiled = reading.result.expect("it is coherent");
    Mechanism::new(reading.model, *compiled).expect("it can be played")
}

fn measure(name: &str, document: &Document) {
    let start = Instant::now();
    let player = Player::new(mechanism(document), Vec::new(), SIZE);
    let begin = start.elapsed().as_secs_f64() * 1e3;
    let mut stage = Stage::new(player, PathBuf::new()).expect("there is memory");
    let step = middle(61, || stage.player.advance(1.0 / 60.0));
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
    middle(61, || {
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
    let time = middle(61, || {
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
