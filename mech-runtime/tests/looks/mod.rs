//! The looks of shapes, letters, symbols and arrows, pixel for pixel: `looks/*.txt`, which somebody has looked at.
//!
//! The first line of a file says what it shows. `.` is the background, `o` what is within a symbol, `+` blue, and `#` everything else.
//! After a picture was changed on purpose, `UPDATE_PICTURES=1` paints it anew: look at it.

use mech_runtime::overlay::{Arrows, Spot, Symbol};
use mech_runtime::{Canvas, Frame, Outline, Overlay, Palette, Pose, Trace, View, raster};
use similar::TextDiff;
use std::path::Path;
use std::{env, fs};

/// The pose of link 1 everywhere.
pub(crate) const TURNED: Pose<f64> = Pose { cos: 0.8, sin: 0.6, x: 0.0, y: 0.0 };

pub(crate) const fn on(link: usize, at: [f64; 2]) -> Spot<f64> {
    Spot { link, at }
}

/// A picture in which a scene unit is a pixel and the origin is in the middle.
pub(crate) fn picture<const W: usize, const H: usize>(
    paint: impl FnOnce(&mut Frame<W, H>),
) -> String {
    let mut frame = Frame::<W, H>::new();
    paint(&mut frame);
    let rows = frame.pixels().map(|row| {
        let row = row.map(|pixel| match pixel {
            Palette::PAPER => '.',
            Palette::EYE => 'o',
            Palette::BLUE => '+',
            _ => '#',
        });
        row.iter().collect::<String>()
    });
    rows.join("\n")
}

/// The same with the origin in the lower left corner.
fn cornered<const W: usize, const H: usize>(paint: impl FnOnce(&mut Frame<W, H>)) -> String {
    picture(|frame| {
        #[expect(clippy::cast_precision_loss, reason = "small")]
        frame.look_at(View::new([W as f64 / 2.0, H as f64 / 2.0], 1.0));
        paint(frame);
    })
}

fn shape<const W: usize, const H: usize>(outline: Outline<f64>) -> String {
    cornered::<W, H>(|frame| frame.fill(outline, Pose::identity(), 1))
}

/// Lines of text, one below the other.
fn text(lines: [&str; 5]) -> String {
    cornered::<98, 41>(|frame| {
        for (number, line) in (1..).zip(lines) {
            frame.text([1.0, 41.0 - 8.0 * f64::from(number)], line, 1);
        }
    })
}

/// Symbols of the ground, and of a link that is turned.
pub(crate) fn symbols<const W: usize, const H: usize>(symbols: &[Symbol<f64>]) -> String {
    picture::<W, H>(|frame| {
        let overlay = Overlay::new().links(true).axes(true);
        overlay.draw(symbols, &[TURNED], frame);
    })
}

const STAR: [[f64; 2]; 5] = [[9.5, 15.5], [15.0, 0.5], [1.0, 10.0], [18.0, 10.0], [4.0, 0.5]];

const RING: Outline<'_, f64> = Outline::Ring { center: [7.5, 6.5], radius: 6.0, hole: 3.0 };

const LINE: Outline<'_, f64> =
    Outline::Line { points: &[[4.0, 4.0], [22.0, 4.0], [13.0, 15.0]], width: 5.0 };

const DOT: Outline<'_, f64> = Outline::Line { points: &[[3.5, 3.5]], width: 5.0 };

const fn arc(angle: f64) -> Outline<'static, f64> {
    Outline::Arc { center: [10.0, 8.0], start: [17.0, 8.0], angle, width: 3.0 }
}

fn bar() -> String {
    cornered::<31, 13>(|frame| {
        let pins = [[6.5, 6.5], [24.5, 6.5]];
        raster::bar(frame, &pins, Pose::identity(), 11.0, Palette::BLUE);
    })
}

fn letters() -> String {
    text([
        "ABCDEFGHIJKLMNOP",
        "QRSTUVWXYZabcdef",
        "ghijklmnopqrstuv",
        "wxyz 0123456789",
        "!\"#$%&'()*+,-./:",
    ])
}

fn signs() -> String {
    text([";<=>?@[\\]^_`{|}~", "°±²·×−Δαβγδθλμπφ", "ψω é", "60° 3 × 10² ΔT", "h = −0.5"])
}

fn letters_at_the_margins() -> String {
    cornered::<13, 9>(|frame| {
        frame.text([-3.0, 4.0], "AB", 1);
        frame.text([9.0, -3.0], "AB", 1);
    })
}

const ENDS: [Spot<f64>; 2] = [on(0, [-32.0, 0.0]), on(0, [32.0, 0.0])];

const SPRING: Symbol<f64> = Symbol::Spring { ends: ENDS, beside: 0.0 };

const DAMPER: Symbol<f64> = Symbol::Damper { ends: ENDS, beside: 8.0 };

const GEAR: Symbol<f64> = Symbol::Wheel { center: on(1, [0.0, 0.0]), radius: 16.0 };

const BELT: Symbol<f64> =
    Symbol::Belt { centers: [on(0, [-14.0, 0.0]), on(0, [12.0, 0.0])], radii: [4.0, 8.0] };

const RACK: Symbol<f64> = Symbol::Rack {
    pinion: on(0, [0.0, 8.0]),
    radius: 10.0,
    bar: on(0, [1.0, 0.0]),
    along: [1.0, 0.0],
};

const AXIS: Symbol<f64> = Symbol::Line { at: on(0, [0.0, 0.0]), along: [1.0, 0.0] };

const LINK: [Symbol<f64>; 2] =
    [Symbol::Bar { link: 1, ends: [[-15.0, 0.0], [15.0, 0.0]] }, Symbol::Mark(on(1, [15.0, 0.0]))];

const fn slide(guide: Spot<f64>) -> Symbol<f64> {
    Symbol::Slide { guide, along: [1.0, 0.0], block: on(1, [0.0, 0.0]) }
}

const LINEAR_MOTOR: Symbol<f64> =
    Symbol::LinearMotor { block: on(1, [0.0, 0.0]), guide: 0, along: [1.0, 0.0] };

/// A long arrow, one shorter than its head, and one too short to be seen.
fn arrows() -> String {
    picture::<41, 25>(|frame| {
        let arrows = Arrows::new(4.0, Palette::INK);
        arrows.draw(frame, [-16.0, -8.0], [8.0, 4.0]);
        arrows.draw(frame, [-10.0, 6.0], [-1.5, 0.0]);
        arrows.draw(frame, [10.0, -6.0], [0.0, 0.1]);
    })
}

/// The first place is forgotten, and two are so near each other that they are one.
fn trace() -> String {
    picture::<31, 19>(|frame| {
        let mut trace = Trace::<f64, 6>::new();
        for place in [
            [9.0, 9.0],
            [-12.0, -6.0],
            [-6.0, 6.0],
            [0.0, 6.0],
            [0.2, 6.1],
            [6.0, -6.0],
            [12.0, -6.0],
        ] {
            trace.push(place);
        }
        trace.draw(frame, Palette::INK);
    })
}

/// A file's name, and what paints its picture.
type Named = (&'static str, fn() -> String);

const PICTURES: &[Named] = &[
    ("ring", || shape::<15, 13>(RING)),
    ("star-hollow", || shape::<19, 16>(Outline::Polygon(&STAR))),
    ("star-full", || shape::<19, 16>(Outline::Winding(&STAR))),
    ("line", || shape::<27, 20>(LINE)),
    ("line-of-one-point", || shape::<7, 7>(DOT)),
    ("arc", || shape::<20, 18>(arc(4.0))),
    ("bar", bar),
    ("letters", letters),
    ("signs", signs),
    ("letters-at-the-margins", letters_at_the_margins),
    ("spring", || symbols::<71, 17>(&[SPRING])),
    ("damper", || symbols::<71, 37>(&[DAMPER])),
    ("torsional-spring", || symbols::<41, 31>(&[Symbol::TorsionSpring(on(1, [0.0, 0.0]))])),
    ("torsional-damper", || symbols::<41, 37>(&[Symbol::TorsionDamper(on(1, [0.0, 0.0]))])),
    ("gear", || symbols::<35, 35>(&[GEAR])),
    ("belt", || symbols::<41, 21>(&[BELT])),
    ("rack", || symbols::<47, 21>(&[RACK])),
    ("axes-of-a-point", || symbols::<17, 17>(&[Symbol::Point(on(1, [0.0, 0.0]))])),
    ("axis-of-a-line", || symbols::<75, 5>(&[AXIS])),
    ("link", || symbols::<33, 29>(&LINK)),
    ("arrows", arrows),
    ("trace", trace),
    ("pivot", || symbols::<13, 11>(&[Symbol::Pivot(on(1, [0.0, 0.0]))])),
    ("fixed-pivot", || symbols::<37, 41>(&[Symbol::Pivot(on(0, [0.0, 5.0]))])),
    ("slide-on-the-ground", || symbols::<81, 31>(&[slide(on(0, [-100.0, 0.0]))])),
    ("slide-of-moving-links", || symbols::<61, 47>(&[slide(on(1, [-10.0, 0.0]))])),
    ("weld", || symbols::<17, 17>(&[Symbol::Weld(on(1, [0.0, 0.0]))])),
    ("rotary-motor", || symbols::<43, 33>(&[Symbol::RotaryMotor(on(1, [0.0, -5.0]))])),
    ("linear-motor", || symbols::<45, 39>(&[LINEAR_MOTOR])),
];

#[test]
fn everything_looks_as_it_did() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/looks");
    let mut wrong = String::new();
    for (name, paint) in PICTURES {
        let file = folder.join(name).with_extension("txt");
        let text = fs::read_to_string(&file).expect("a file that says what it shows");
        let title = text.lines().next().expect("what it shows");
        let now = format!("{title}\n\n{}\n", paint());
        if now != text && env::var_os("UPDATE_PICTURES").is_some() {
            fs::write(file, now).expect("a file");
        } else if now != text {
            let changes = TextDiff::from_lines(&text, &now);
            wrong += &format!("{name}:\n{}\n", changes.unified_diff());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    // All but this one.
    let files = fs::read_dir(folder).expect("the folder").count() - 1;
    assert_eq!(files, PICTURES.len());
}

#[test]
fn an_arc_of_a_whole_turn_is_a_ring() {
    let ring = Outline::Ring { center: [10.0, 8.0], radius: 8.5, hole: 5.5 };
    assert_eq!(shape::<20, 18>(arc(7.0)), shape::<20, 18>(ring));
}
