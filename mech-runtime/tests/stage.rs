//! A picture that is painted in parts looks as though it were painted whole.

use crate::outlines::Any;
use mech_runtime::{Canvas, Frame, Outline, OwnedOutline, Pose, Stage, Trace, View};
use proptest::prelude::*;

/// Something to be painted, in pixels around the middle.
fn thing() -> impl Strategy<Value = Any> {
    let place = || [-50.0..50.0, -40.0..40.0];
    let places = |least| prop::collection::vec(place(), least..7_usize);
    let ring = |(center, radius)| OwnedOutline::Ring { center, radius, hole: 0.6 * radius };
    let arc = |(center, start, angle)| OwnedOutline::Arc { center, start, angle, width: 2.5 };
    let outline = prop_oneof![
        places(0).prop_map(OwnedOutline::Polygon),
        places(3).prop_map(OwnedOutline::Winding),
        (place(), 0.5..25.0).prop_map(|(center, radius)| OwnedOutline::Circle { center, radius }),
        (place(), 2.0..25.0).prop_map(ring),
        (places(1), 0.5..6.0).prop_map(|(points, width)| OwnedOutline::Line { points, width }),
        (place(), place(), -7.0..7.0).prop_map(arc),
    ];
    prop_oneof![
        6 => outline.prop_map(Any::Outline),
        1 => (place(), "[a-zA-Z°]{0,7}").prop_map(|(place, text)| Any::Text(place, text)),
    ]
}

/// Paints a thing turned by an angle.
fn paint(thing: &Any, canvas: &mut impl Canvas<f64>, color: u8, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    let (x, y) = (8.0 * sin, 5.0 * cos);
    thing.draw_at(Pose { cos, sin, x, y }, canvas, color);
}

/// Makes the angle of a thing; a thing whose angle is not finite is not seen.
fn angle() -> impl Strategy<Value = f64> {
    prop_oneof![4 => Just(0.0), 3 => 0.0..7.0, 1 => Just(f64::NAN)]
}

proptest! {
    #[test]
    fn a_stage_looks_as_though_all_were_painted(
        things in prop::collection::vec(thing(), 1..9),
        moments in prop::collection::vec((prop::collection::vec(angle(), 8), 0_usize..9, any::<bool>()), 1..9),
    ) {
        let mut stage = Stage::<96, 80>::new();
        let mut small = Stage::<96, 80, 3>::new();
        let mut none = Stage::<96, 80, 0>::new();
        let mut frame = Frame::<96, 80>::new();
        for (number, (angles, seen, is_near)) in moments.iter().enumerate() {
            if number % 4 == 3 {
                let view = View::new([1.5, 0.0], if *is_near { 1.7 } else { 1.0 });
                stage.look_at(view);
                small.look_at(view);
                none.look_at(view);
                frame.look_at(view);
            }
            let things = || (1..).zip(things.iter().zip(angles)).take(*seen);
            let before = stage.frame().clone();
            stage.show(|canvas| things().for_each(|(color, (thing, angle))| paint(thing, canvas, color, *angle)));
            small.show(|canvas| things().for_each(|(color, (thing, angle))| paint(thing, canvas, color, *angle)));
            none.show(|canvas| things().for_each(|(color, (thing, angle))| paint(thing, canvas, color, *angle)));
            frame.clear();
            things().for_each(|(color, (thing, angle))| paint(thing, &mut frame, color, *angle));
            prop_assert!(stage.frame() == &frame, "at moment {number}");
            prop_assert!(small.frame() == &frame, "at moment {number}");
            prop_assert!(none.frame() == &frame, "at moment {number}");
            // Nothing has changed outside of the reported areas.
            for (y, (before, now)) in before.pixels().iter().zip(frame.pixels()).enumerate() {
                for (x, (before, now)) in before.iter().zip(now).enumerate() {
                    let is_reported = stage.changed().any(|area| (area.x..area.x + area.width).contains(&x) && (area.y..area.y + area.height).contains(&y));
                    prop_assert!(before == now || is_reported, "{x}, {y} at moment {number}");
                }
            }
        }
    }
}

#[test]
fn what_stands_still_is_not_painted_again() {
    let square = [[-3.0, -3.0], [3.0, -3.0], [3.0, 3.0], [-3.0, 3.0]];
    let mut stage = Stage::<64, 64>::new();
    let show = |stage: &mut Stage<64, 64>, x: f64| {
        stage.show(|canvas| {
            let ground = Outline::Circle { center: [0.0, 0.0], radius: 30.0 };
            canvas.fill(ground, Pose::identity(), 1);
            let pose = Pose { x, ..Pose::identity() };
            canvas.fill(Outline::Polygon(&square), pose, 2);
        });
        stage.changed().map(|area| area.width * area.height).sum::<usize>()
    };
    assert_eq!(show(&mut stage, 0.0), 64 * 64);
    assert_eq!(show(&mut stage, 1.0), 7 * 6);
    assert_eq!(show(&mut stage, 1.0), 0);
    // One rectangle around both places is less work than two.
    assert_eq!(show(&mut stage, 20.0), 25 * 6);
    assert_eq!(stage.frame().pixel(52, 32), Some(2));
    assert_eq!(stage.frame().pixel(33, 32), Some(1));
}

#[test]
fn a_trace_grows_on_a_stage() {
    let mut trace = Trace::<f64, 40>::new();
    let mut stage = Stage::<64, 64>::new();
    let mut frame = Frame::<64, 64>::new();
    for n in 0..90 {
        let (sin, cos) = (f64::from(n) * 0.13).sin_cos();
        trace.push([20.0 * cos, 25.0 * sin]);
        stage.show(|canvas| trace.draw(canvas, 9));
        frame.clear();
        trace.draw(&mut frame, 9);
        assert!(stage.frame() == &frame);
    }
}
