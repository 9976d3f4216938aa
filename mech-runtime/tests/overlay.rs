//! Properties of all symbols and arrows.

use crate::looks::{TURNED, on, picture, symbols};
use mech_runtime::overlay::{Arrows, Symbol, arrow, moment};
use mech_runtime::{Canvas, Frame, Outline, Overlay, Pose, View};
use proptest::prelude::*;

#[test]
fn a_moment_to_the_right_is_that_to_the_left_in_a_mirror() {
    let [left, right] = [true, false]
        .map(|left| picture::<44, 44>(|frame| moment(frame, [0.01, 0.02], left, 15.0, 1.0, 14)));
    let mirrored = left.lines().map(|row| row.chars().rev().collect::<String>());
    let right: Vec<&str> = right.lines().collect();
    let differing = mirrored
        .zip(right)
        .flat_map(|(one, other)| {
            let pairs: Vec<(char, char)> = one.chars().zip(other.chars()).collect();
            pairs
        })
        .filter(|(one, other)| one != other);
    // The mirror is half a hundredth of a pixel off.
    assert!(differing.count() < 6);
}

#[test]
fn only_what_is_wanted_is_drawn() {
    let symbols = [
        Symbol::Bar { link: 0, ends: [[-9.0, 0.0], [9.0, 0.0]] },
        Symbol::Pivot(on(1, [0.0, 0.0])),
        Symbol::RotaryMotor(on(1, [0.0, 0.0])),
        Symbol::Point(on(1, [0.0, 0.0])),
        // No pose is known of this one.
        Symbol::Mark(on(2, [0.0, 0.0])),
        Symbol::LinearMotor { block: on(7, [0.0, 0.0]), guide: 0, along: [1.0, 0.0] },
    ];
    let none = Overlay::new().joints(false).motors(false);
    let kinds = [none.links(true), none.joints(true), none.motors(true), none.axes(true)];
    let drawn = |overlay: Overlay, symbols: &[Symbol<f64>]| {
        picture::<41, 41>(|frame| overlay.draw(symbols, &[TURNED], frame))
    };
    assert!(!drawn(none, &symbols).contains(['#', 'o']));
    for (kind, symbol) in kinds.into_iter().zip(symbols) {
        let alone = drawn(kind, &[symbol]);
        assert!(alone.contains('#'));
        assert_eq!(drawn(kind, &symbols), alone);
    }
    assert_eq!(Overlay::default(), none.joints(true).motors(true));
}

#[test]
fn ends_that_meet_are_no_spring() {
    let (ends, beside) = ([on(0, [1.0, 2.0]); 2], 8.0);
    for symbol in [Symbol::Spring { ends, beside }, Symbol::Damper { ends, beside }] {
        assert_eq!(symbols::<5, 2>(&[symbol]), ".....\n.....");
    }
}

/// Notes what is painted.
#[derive(Default)]
struct Recorder {
    polygons: Vec<Vec<[f64; 2]>>,
    circles: Vec<([f64; 2], f64)>,
    scale: f64,
}

impl Canvas<f64> for Recorder {
    fn fill(&mut self, outline: Outline<f64>, pose: Pose<f64>, _: u8) {
        match outline {
            Outline::Circle { center, radius } => {
                self.circles.push((pose.apply(center), radius));
            }
            Outline::Polygon(corners) => self.add(corners.to_vec(), pose),
            Outline::Line { points, width } => self.add(around(points, width), pose),
            Outline::Arc { start, .. } => self.add(vec![start], pose),
            other => panic!("{other:?} is in no symbol"),
        }
    }

    fn text(&mut self, _: [f64; 2], _: &str, _: u8) {}

    fn scale(&self) -> f64 {
        self.scale
    }
}

impl Recorder {
    fn add(&mut self, points: Vec<[f64; 2]>, pose: Pose<f64>) {
        let points = points.into_iter().map(|point| pose.apply(point));
        self.polygons.push(points.collect());
    }
}

/// Returns the outermost places of a straight line: before its ends and beside them.
fn around(points: &[[f64; 2]], width: f64) -> Vec<[f64; 2]> {
    let [from, to] = [points[0], points[points.len() - 1]];
    let offset = [to[0] - from[0], to[1] - from[1]];
    let length = offset[0].hypot(offset[1]);
    let [u, v] = if length > 0.0 {
        offset.map(|part| part / length * width / 2.0)
    } else {
        [width / 2.0, 0.0]
    };
    let beside = |[x, y]: [f64; 2]| [[x - v, y + u], [x + v, y - u]];
    let ends = [[from[0] - u, from[1] - v], [to[0] + u, to[1] + v]];
    [beside(from), beside(to), ends].concat()
}

fn all_symbols() -> Vec<Symbol<f64>> {
    vec![
        Symbol::Bar { link: 1, ends: [[0.0, 0.0], [1.0, 2.0]] },
        Symbol::Mark(on(1, [1.0, 0.0])),
        Symbol::Wheel { center: on(1, [0.5, 0.0]), radius: 1.5 },
        Symbol::Belt { centers: [on(0, [0.0, 0.0]), on(1, [3.0, 0.5])], radii: [1.0, 0.5] },
        Symbol::Rack {
            pinion: on(0, [0.0, 0.0]),
            radius: -0.5,
            bar: on(1, [1.0, 1.0]),
            along: [0.6, 0.8],
        },
        Symbol::Line { at: on(1, [0.0, 1.0]), along: [0.0, 1.0] },
        Symbol::Point(on(1, [1.0, 1.0])),
        Symbol::Slide { guide: on(0, [0.0, 0.0]), along: [0.0, -1.0], block: on(1, [2.0, 1.0]) },
        Symbol::Slide { guide: on(1, [0.0, 0.0]), along: [0.8, -0.6], block: on(0, [2.0, 1.0]) },
        Symbol::Weld(on(1, [0.0, 1.0])),
        Symbol::Spring { ends: [on(0, [0.0, 0.0]), on(1, [3.0, 0.5])], beside: 8.0 },
        Symbol::Damper { ends: [on(1, [3.0, 0.5]), on(0, [0.0, 0.0])], beside: 0.0 },
        Symbol::TorsionSpring(on(1, [0.0, 1.0])),
        Symbol::TorsionDamper(on(1, [0.0, 1.0])),
        Symbol::Pivot(on(0, [2.0, 2.0])),
        Symbol::RotaryMotor(on(1, [0.0, 0.0])),
        Symbol::LinearMotor { block: on(1, [0.0, 0.0]), guide: 0, along: [0.0, 1.0] },
    ]
}

#[test]
fn where_pixels_have_no_size_everything_is_where_it_stands() {
    let mut canvas = Recorder { scale: f64::INFINITY, ..Recorder::default() };
    let overlay = Overlay::new().links(true).axes(true);
    overlay.draw(&all_symbols(), &[TURNED], &mut canvas);
    let corners = canvas.polygons.iter().flatten();
    let far = corners.clone().filter(|corner| corner[0].hypot(corner[1]) > 6.0);
    assert_eq!(far.count(), 0);
    assert!(corners.count() > 60 && canvas.circles.iter().all(|(_, radius)| *radius == 0.0));
}

proptest! {
    #[test]
    fn an_arrow_reaches_from_its_tail_to_its_tip(tail in [-9.0..9.0, -9.0..9.0], offset in [-9.0..9.0, -9.0..9.0], scale in 2.0..200.0, size in 0.5_f32..3.0) {
        let mut canvas = Recorder { scale, ..Recorder::default() };
        let tip = [tail[0] + offset[0], tail[1] + offset[1]];
        arrow(&mut canvas, [tail, tip], size, 3);
        let length = f64::hypot(offset[0], offset[1]);
        prop_assume!(length * scale > 1.01 * f64::from(size));
        let pixel = f64::from(size) / scale;
        let [ahead, left] = [[offset[0] / length, offset[1] / length], [-offset[1] / length, offset[0] / length]];
        let mut reach = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in canvas.polygons.iter().flatten() {
            let [x, y] = [corner[0] - tail[0], corner[1] - tail[1]];
            let along = x * ahead[0] + y * ahead[1];
            reach = (reach.0.min(along), reach.1.max(along));
            prop_assert!((x * left[0] + y * left[1]).abs() < 3.7 * pixel);
        }
        // Nothing lies beyond the tip; behind the tail, half a line's width.
        prop_assert!((reach.1 - length).abs() < 1e-9 * (1.0 + length), "{reach:?} of {length}");
        prop_assert!((reach.0 + pixel).abs() < 1e-9, "{reach:?}");
    }

    #[test]
    fn symbols_keep_their_size_however_large_the_scene_is_seen(scale in 0.01..1000.0_f64, size in 0.5_f32..3.0) {
        let sizes = |symbol: Symbol<f64>, scale: f64, size: f32| {
            let mut canvas = Recorder { scale, ..Recorder::default() };
            Overlay::new().size(size).draw(&[symbol], &[TURNED], &mut canvas);
            let corners = canvas.polygons.iter().flatten();
            let radii = canvas.circles.iter().map(|(_, radius)| *radius);
            let reach = corners.map(|corner| corner[0].hypot(corner[1])).chain(radii);
            reach.fold(0.0, f64::max) * scale
        };
        for symbol in [
            Symbol::Pivot(on(0, [0.0, 0.0])),
            Symbol::Pivot(on(1, [0.0, 0.0])),
            Symbol::Weld(on(1, [0.0, 0.0])),
            Symbol::RotaryMotor(on(1, [0.0, 0.0])),
            Symbol::LinearMotor { block: on(1, [0.0, 0.0]), guide: 0, along: [0.6, 0.8] },
        ] {
            let (once, again) = (sizes(symbol, 1.0, 1.0), sizes(symbol, scale, size));
            prop_assert!((again / f64::from(size) - once).abs() < 1e-6 * once, "{symbol:?}: {once}, {again}");
        }
    }

    #[test]
    fn no_pose_and_no_view_is_too_bad(numbers in prop::array::uniform4(any::<f64>()), center in [any::<f64>(), any::<f64>()], scale in any::<f64>(), size in any::<f32>()) {
        let [cos, sin, x, y] = numbers;
        let mut frame = Frame::<24, 16>::new();
        frame.look_at(View::new(center, scale));
        let overlay = Overlay::new().links(true).axes(true).size(size);
        overlay.draw(&all_symbols(), &[Pose { cos, sin, x, y }], &mut frame);
        Arrows::new(cos, 1).size(size).draw(&mut frame, [x, y], [sin, cos]);
        moment(&mut frame, [x, y], true, size, size, 1);
    }
}
