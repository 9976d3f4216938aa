//! Symbols and arrows: what they look like, and what is true of all of them.

mod diagrams;
mod elastic;
mod pictures;
mod properties;

use mech_runtime::overlay::{Spot, Symbol};
use mech_runtime::{Frame, Overlay, Palette, Pose};

/// That of link 1 everywhere.
const TURNED: Pose<f64> = Pose {
    cos: 0.8,
    sin: 0.6,
    x: 0.0,
    y: 0.0,
};

/// A picture in which a scene unit is a pixel and the origin is in the middle.
fn picture<const W: usize, const H: usize>(paint: impl FnOnce(&mut Frame<W, H>)) -> String {
    let mut frame = Frame::<W, H>::new();
    paint(&mut frame);
    let rows = frame.pixels().iter().map(|row| {
        let row = row.iter().map(|&pixel| match pixel {
            Palette::PAPER => '.',
            Palette::EYE => 'o',
            _ => '#',
        });
        row.collect::<String>()
    });
    rows.collect::<Vec<_>>().join("\n")
}

const fn on(link: usize, at: [f64; 2]) -> Spot<f64> {
    Spot { link, at }
}

#[track_caller]
fn assert_looks<const W: usize, const H: usize>(
    paint: impl FnOnce(&mut Frame<W, H>),
    expected: &str,
) {
    let found = picture(paint);
    let lines: Vec<&str> = expected.lines().map(str::trim).collect();
    assert_eq!(found, lines.join("\n").trim(), "\n{found}\n");
}

/// A symbol of the ground, and of a link that is turned.
fn draw<const W: usize, const H: usize>(symbol: Symbol<f64>) -> impl FnOnce(&mut Frame<W, H>) {
    move |frame| {
        let overlay = Overlay::new().links(true).axes(true);
        overlay.draw(&[symbol], &[TURNED], frame);
    }
}
