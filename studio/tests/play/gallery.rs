//! The mechanisms of the gallery, from their texts.

use mech_runtime::HeapSmooth;
use mech_studio::play::{Mechanism, Painter, Player};
use mech_studio::{Document, Source};
use std::path::{Path, PathBuf};

/// Of the picture.
pub(crate) const SIZE: [usize; 2] = [480, 360];

/// All files of the gallery with a mechanism.
pub(crate) const FILES: [&str; 13] = [
    "andrews",
    "antikythera",
    "crane",
    "diagram",
    "excavator",
    "four_bar",
    "geared_piston",
    "jansen",
    "rocker_arm",
    "skeleton",
    "velocities",
    "walker",
    "watt",
];

pub(crate) fn path(file: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/gallery/src/mechanisms");
    folder.join(file).with_extension("rs")
}

pub(crate) fn first(document: &Document) -> Mechanism {
    let reading = document.analyse(&document.declarations()[0]);
    let reading = reading.expect("it can be analysed");
    let compiled = reading.result.expect("it is coherent");
    Mechanism::new(reading.model, *compiled).expect("it can be played")
}

pub(crate) fn mechanism(file: &str) -> Mechanism {
    first(&Document::read(&path(file)).expect("it is in the gallery"))
}

pub(crate) fn from_text(text: &str) -> Mechanism {
    first(&Document::of(Source::new("a.mech", text)))
}

pub(crate) fn from_rust(text: &str) -> Mechanism {
    first(&Document::of(Source::new("a.rs", text)))
}

pub(crate) fn player(file: &str) -> Player {
    Player::new(mechanism(file), Vec::new(), SIZE)
}

pub(crate) fn picture(player: &Player) -> HeapSmooth {
    let mut painter = Painter::new(player.camera().size()).expect("it is small");
    painter.paint(player).expect("it is small").clone()
}

pub(crate) fn near(one: &[f64], other: &[f64], tolerance: f64) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(a, b)| (a - b).abs() <= tolerance)
}
