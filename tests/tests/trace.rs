//! Traces: the path of a point is where it was reported to be after each move that succeeded, and nothing else.

use super::recorder::Recorder;
use mech_runtime::{Frame, Mechanism, Outline, Point2, Pose, Reached, Trace, View};
use proptest::prelude::*;

include!(concat!(env!("OUT_DIR"), "/trace.rs"));

fn places<const N: usize>(trace: &Trace<f64, N>) -> Vec<Point2<f64>> {
    trace.iter().collect()
}

#[test]
fn every_method_that_moves_leaves_a_trace_and_none_that_fails() {
    let mut four_bar = FourBar::new();
    assert!(four_bar.coupler_tip_trace().is_empty(), "the start is no move");
    four_bar.move_within(FourBar::range([0.5]).expect("within"));
    let first = four_bar.coupler_tip();
    Mechanism::move_to(&mut four_bar, [0.6]).expect("it turns");
    let been = [first, four_bar.coupler_tip()];
    assert_eq!(places(four_bar.coupler_tip_trace()), been);
    assert_eq!(four_bar.crank_pin_trace().len(), 2);
    let newest = four_bar.crank_pin_trace().iter().next_back();
    assert_eq!(newest, Some(four_bar.crank_pin()));
    let before = four_bar;
    assert!(four_bar.move_to([8.0]).is_err(), "beyond its range");
    assert_eq!(four_bar, before);
    four_bar.clear_traces();
    assert!(four_bar.coupler_tip_trace().is_empty() && four_bar.crank_pin_trace().is_empty());
    assert_ne!(four_bar, before, "traces are a part of it");
}

#[test]
fn many_instances_leave_a_trace_each() {
    let mut many = [FourBar::new(); 11];
    let mut one = many;
    let starts = [0.0, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0];
    for round in 0..7 {
        let motors: [[f64; 1]; 11] = std::array::from_fn(|n| [0.1 * f64::from(round) + starts[n]]);
        FourBar::move_many(&mut many, &motors).expect("they turn");
        for (one, motors) in one.iter_mut().zip(motors) {
            one.move_to(motors).expect("it turns");
        }
    }
    for (many, one) in many.iter().zip(&one) {
        assert_eq!(many.coupler_tip_trace().len(), 5);
        for (many, one) in many.coupler_tip_trace().iter().zip(one.coupler_tip_trace().iter()) {
            assert!((many - one).norm() < 1e-14, "{many} and {one}");
        }
    }
}

#[test]
fn what_is_traced_is_solved_though_it_is_not_shown() {
    let mut slider = SliderCrank::new();
    assert_eq!(SliderCrank::LINKS, ["rod"]);
    slider.move_to([0.1]).expect("it slides");
    // The crank's end is where two circles cut each other: about the shaft, and about the block.
    let (crank, rod, block) = (1.25_f64.sqrt(), 9.25_f64.sqrt(), 4.1_f64);
    let x = (crank.powi(2) - rod.powi(2) + block.powi(2)) / (2.0 * block);
    let y = (crank.powi(2) - x * x).sqrt();
    let middle = slider.rod_middle_trace().iter().next().expect("a place");
    assert!((f64::from(middle.x) - f64::midpoint(x, block)).abs() < 1e-6);
    assert!((f64::from(middle.y) - y / 2.0).abs() < 1e-6);
    let stopped = slider.move_toward([9.0]).expect("it slides as far as it can");
    assert!(matches!(stopped, Reached::Limit(_)));
    assert_eq!(slider.rod_middle_trace().len(), 2);
    assert!(slider.move_to([9.0]).is_err());
    assert_eq!(slider.rod_middle_trace().len(), 2);
    assert!(SliderCrank::REPORT.contains("trace     rod.middle: the last 4 places, 32 bytes"));
}

#[test]
fn traces_are_drawn_above_the_ground_and_below_the_links() {
    let mut four_bar = FourBar::new();
    for step in 0..4 {
        four_bar.move_to([f64::from(step)]).expect("it turns");
    }
    let mut recorded: Vec<(u8, Vec<[f64; 2]>)> = Vec::new();
    let fill = |outline: Outline<'_, f64>, _: Pose<f64>, color: u8| {
        let points = match outline {
            Outline::Line { points, width } => {
                assert!((width - 0.15).abs() < 1e-12, "1.5 pixels");
                points.to_vec()
            }
            _ => Vec::new(),
        };
        recorded.push((color, points));
    };
    Mechanism::draw(&four_bar, &mut Recorder { scale: 10.0, fill });
    let colors: Vec<u8> = recorded.iter().map(|(color, _)| *color).collect();
    assert_eq!(colors, [1, 14, 7, 3], "lines through all places");
    for (lines, trace) in [
        (&recorded[1], places(four_bar.coupler_tip_trace())),
        (&recorded[2], places(four_bar.crank_pin_trace())),
    ] {
        let expected: Vec<[f64; 2]> = trace.into_iter().map(Into::into).collect();
        assert_eq!(lines.1, expected);
    }
}

#[test]
fn a_trace_is_seen_in_a_picture() {
    let mut trace = Trace::<f64, 64>::new();
    for n in 0..64 {
        let (sin, cos) = (f64::from(n) * 0.1).sin_cos();
        trace.push([20.0 * cos, 20.0 * sin]);
    }
    let mut frame = Frame::<64, 64>::new();
    frame.look_at(View::new([0.0, 0.0], 1.0));
    trace.draw(&mut frame, 9);
    for (y, row) in (-32..).zip(frame.pixels()) {
        for (x, &pixel) in (-32..).zip(row) {
            let [x, y] = [x, y].map(|pixel| f64::from(pixel) + 0.5);
            let radius = x.hypot(y);
            // Its places are more than once around.
            if pixel == 9 {
                assert!((radius - 20.0).abs() < 1.5, "{x}, {y}");
            } else {
                assert!((radius - 20.0).abs() > 0.5, "{x}, {y}");
            }
        }
    }
}

proptest! {
    #[test]
    fn a_trace_is_the_end_of_what_was_pushed(pushed in prop::collection::vec([-9.0..9.0, -9.0..9.0], 0..40), clear in 0_usize..40) {
        let (mut none, mut one, mut some) = (Trace::<f64, 0>::new(), Trace::<f64, 1>::new(), Trace::<f64, 13>::new());
        let mut expected: Vec<[f64; 2]> = Vec::new();
        for (number, &place) in pushed.iter().enumerate() {
            if number == clear {
                one.clear();
                some.clear();
                expected.clear();
            }
            none.push(place);
            one.push(place);
            some.push(place);
            expected.push(place);
        }
        let end = |length: usize| {
            let end = &expected[expected.len().saturating_sub(length)..];
            end.iter().map(|&[x, y]| Point2::new(x, y)).collect::<Vec<_>>()
        };
        prop_assert_eq!(places(&none), end(0));
        prop_assert_eq!(places(&one), end(1));
        prop_assert_eq!(places(&some), end(13));
        let mut backwards: Vec<_> = some.iter().rev().collect();
        backwards.reverse();
        prop_assert_eq!(backwards, end(13));
        let mut again = Trace::<f64, 13>::new();
        for place in end(13) {
            again.push([place.x, place.y]);
        }
        prop_assert_eq!(some, again, "whatever was forgotten");
        prop_assert_eq!(format!("{some:?}"), format!("{again:?}"));
    }

    #[test]
    fn no_place_is_too_bad(places in prop::collection::vec([any::<f64>(), any::<f64>()], 0..20), scale in any::<f64>()) {
        let mut frame = Frame::<16, 12>::new();
        frame.look_at(View::new([0.0, 0.0], scale));
        let mut trace = Trace::<f64, 16>::new();
        for place in places {
            trace.push(place);
        }
        trace.draw(&mut frame, 1);
    }
}
