//! Mechanisms of which it is known how far they move.

use super::super::{Blocked, Interval, Verdict, certify};
use super::models::{TURN, chain, exhibit, four_bar, program, slider_crank, tokens};
use crate::program::Program;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn ranges(ranges: &[(f64, f64)]) -> Vec<Interval> {
    ranges.iter().map(|&(low, high)| Interval::new(low, high)).collect()
}

fn verdict(program: &Program, over: &[(f64, f64)]) -> Verdict {
    certify(program, &ranges(over))
}

#[track_caller]
fn blocked(program: &Program, over: &[(f64, f64)]) -> Blocked {
    match verdict(program, over) {
        Verdict::Blocked(blocked) => blocked,
        verdict => panic!("{verdict:?}"),
    }
}

#[track_caller]
fn strict(program: &Program, over: &[(f64, f64)]) {
    let verdict = verdict(program, over);
    assert!(verdict.is_strict(), "{verdict:?}");
}

#[track_caller]
fn touching(program: &Program, over: &[(f64, f64)]) {
    let verdict = verdict(program, over);
    assert!(matches!(&verdict, Verdict::Proved { touching } if touching.len() == 1), "{verdict:?}");
}

const DEAD_POINT: f64 = 0.935_085_041_393_594_5;

#[test]
fn a_rocker_stops_at_its_dead_point() {
    let program = four_bar([4.0, 1.0, 2.0, 1.5], 0.0, 0.5, 2.0);
    let up = blocked(&program, &[(0.0, 2.0)]);
    assert!((up.limit - DEAD_POINT).abs() < 1e-12, "{up:?}");
    assert_eq!((up.interval.low(), up.interval.high()), (up.limit, 2.0));
    assert!(up.interval.contains(up.at[0]));
    let down = blocked(&program, &[(-2.0, 0.9)]);
    assert!((down.limit + DEAD_POINT).abs() < 1e-12, "{down:?}");
    assert_eq!((down.interval.low(), down.interval.high()), (-2.0, down.limit));
    let around = blocked(&program, &TURN);
    assert!((around.limit - DEAD_POINT).abs() < 1e-12, "{around:?}");
    assert!((around.interval.high() - (TAU - DEAD_POINT)).abs() < 1e-11, "{around:?}");
    strict(&program, &[(-0.935, 0.935)]);
    strict(&program, &[(-DEAD_POINT + 1e-9, DEAD_POINT - 1e-9)]);
}

#[test]
fn a_parallelogram_passes_its_change_points() {
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0), &TURN);
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0), &[(-10.0, 13.0)]);
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.7, 1.7, 1.7), &TURN);
    strict(&four_bar([2.0, 1.0, 2.0, 1.0], 0.7, 1.7, 1.7), &[(0.8, 3.7)]);
}

/// Its pins meet where it is folded: there any direction closes it, and that which it had is kept.
#[test]
fn a_rhombus_passes_its_change_points() {
    touching(&four_bar([2.0, 2.0, 2.0, 2.0], 0.0, 1.0, 1.0), &TURN);
    touching(&four_bar([2.0, 2.0, 2.0, 2.0], 0.7, 1.7, 1.7), &TURN);
}

#[test]
fn a_piston_with_a_long_rod_moves_and_one_with_a_short_rod_does_not() {
    strict(&slider_crank(1.0, 3.0), &TURN);
    let short = blocked(&slider_crank(1.0, 0.5), &TURN);
    assert!((short.limit - PI / 6.0).abs() < 1e-12, "{short:?}");
    assert!((short.interval.high() - 5.0 * PI / 6.0).abs() < 1e-11, "{short:?}");
    touching(&slider_crank(1.0, 1.0), &[(0.0, 3.0)]);
}

#[test]
fn nearly_folded_four_bars_turn() {
    for gap in [1e-3, 1e-6, 1e-9] {
        for tilt in [0.0, 0.7] {
            let near = 1.0 + tilt;
            strict(&four_bar([2.0, 1.0, 2.0, 1.0 + gap], tilt, 1.0 + tilt, near), &TURN);
        }
    }
}

#[test]
fn four_bars_that_just_do_not_fold_over_are_blocked() {
    for gap in [1e-3, 1e-6] {
        let program = four_bar([2.0 + gap, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0);
        let blocked = blocked(&program, &TURN);
        assert!((blocked.limit - PI).abs() < 3.0 * gap.sqrt(), "{blocked:?}");
    }
}

#[test]
fn chains_of_loops_are_proved() {
    for loops in 1..=10 {
        strict(&chain(loops), &TURN);
    }
}

#[test]
fn the_gallery_turns() {
    for name in ["four_bar", "jansen", "watt", "andrews"] {
        strict(&exhibit(name), &TURN);
    }
}

#[test]
fn two_motors_are_proved_together() {
    let text = "struct FiveBar;
        link left; link left_rod; link right_rod; link right;
        joint a = revolute(ground, left) at (0, 0);
        joint b = revolute(left, left_rod) at (0, 1);
        joint c = revolute(left_rod, right_rod) at (2, 3);
        joint d = revolute(right_rod, right) at (4, 1);
        joint e = revolute(right, ground) at (4, 0);
        motor a; motor e;";
    let program = program(tokens(text));
    strict(&program, &[(-0.9, 0.9), (-0.9, 0.9)]);
    let corner = blocked(&program, &[(-1.1, 1.1), (-1.1, 1.1)]);
    assert!(corner.limit.abs() > 0.9, "{corner:?}");
    let far = blocked(&program, &[(-0.1, 2.5), (-0.1, 2.5)]);
    assert!(far.limit > 0.0, "{far:?}");
}

#[test]
fn motors_without_a_range_stay_at_their_start() {
    strict(&four_bar([4.0, 1.0, 2.0, 1.5], 0.0, 0.5, 2.0), &[]);
}

#[test]
fn loops_without_a_closed_form_are_named() {
    let text = "struct FourBar;
        link crank; link coupler; link rocker;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0, 1);
        joint c = revolute(coupler, rocker) at (3, 3);
        joint d = revolute(rocker, ground) at (4, 0);
        motor a;
        method newton;";
    let program = program(tokens(text));
    assert!(matches!(verdict(&program, &TURN), Verdict::NoClosedForm { .. }));
}

/// The parallelogram goes on the way it came, so its side changes; what hangs on it must close on both.
#[test]
fn loops_that_change_sides_are_tried_on_both() {
    let text = |reach: f64| {
        format!(
            "struct Train;
        ground {{ point a = (0, 0); point d = (2, 0); point g = (6, 0); }}
        link crank {{ point a = (0, 0); point b = (1, 0); }}
        link coupler {{ point b = (0, 0); point c = (2, 0); }}
        link rocker {{ point d = (0, 0); point c = (1, 0); }}
        link rod {{ point c = (0, 0); point f = ({reach:?}, 0); }}
        link lever {{ point g = (0, 0); point f = (3, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c);
        joint d = revolute(ground.d, rocker.d);
        joint e = revolute(rocker.c, rod.c);
        joint f = revolute(rod.f, lever.f);
        joint g = revolute(ground.g, lever.g);
        motor a;
        start {{ a = 60 deg; rocker near 60 deg; lever near 100 deg; }}"
        )
    };
    let crossing = |text: &str| program(tokens(text));
    let wide = crossing(&text(3.8));
    assert!(matches!(verdict(&wide, &TURN), Verdict::Proved { touching } if touching.len() == 1));
    strict(&wide, &[(0.5, 2.5)]);
    assert!(matches!(verdict(&crossing(&text(1.5)), &TURN), Verdict::Blocked(_)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// A four-bar's crank turns if its ends come neither too near nor too far for coupler and rocker.
    #[test]
    fn four_bars_move_as_their_lengths_say(
        lengths in prop::array::uniform4(0.5_f64..4.0),
        tilt in 0.0..TAU,
        start in 0.0..TAU,
    ) {
        let [ground, crank, coupler, rocker] = lengths;
        let square = |angle: f64| ground.powi(2) + crank.powi(2) - 2.0 * ground * crank * (angle - tilt).cos();
        let (most, least) = (coupler + rocker, (coupler - rocker).abs());
        let closes = |angle: f64| (least.powi(2)..=most.powi(2)).contains(&square(angle));
        let near = (ground - crank).abs() - least;
        let far = most - (ground + crank);
        prop_assume!(near.abs() > 1e-6 && far.abs() > 1e-6 && closes(start) && closes(start - 0.02) && closes(start + 0.02));
        let (sin, cos) = start.sin_cos();
        let goal = [ground * tilt.cos() - crank * cos, ground * tilt.sin() - crank * sin];
        let distance = goal[0].hypot(goal[1]);
        let turn = (distance.powi(2) + rocker.powi(2) - coupler.powi(2)) / (2.0 * distance * rocker);
        let near_angle = (-goal[1]).atan2(-goal[0]) + turn.clamp(-1.0, 1.0).acos();
        let program = four_bar(lengths, tilt, start, near_angle);
        match verdict(&program, &[(start - PI, start + PI)]) {
            Verdict::Proved { touching } => {
                prop_assert!(near > 0.0 && far > 0.0 && touching.is_empty(), "{near} {far} {touching:?}");
            }
            Verdict::Blocked(Blocked { at, limit, interval, .. }) => {
                prop_assert!(!closes(at[0]) && (near < 0.0 || far < 0.0));
                let dead = [most, least].map(|reach| (square(limit).sqrt() - reach).abs());
                prop_assert!(dead[0].min(dead[1]) < 1e-9, "{dead:?}");
                let inside = interval.low() * 0.5 + interval.high() * 0.5;
                prop_assert!(!closes(inside) && (limit - start).abs() <= PI);
            }
            verdict => prop_assert!(false, "{verdict:?}"),
        }
    }
}

#[test]
fn very_many_loops_are_left_alone() {
    let verdict = verdict(&chain(120), &TURN);
    assert!(matches!(verdict, Verdict::Undecided { .. }), "{verdict:?}");
}

#[test]
fn a_range_without_end_is_not_decided() {
    let program = four_bar([4.0, 1.0, 3.5, 3.0], 0.0, 1.0, 1.5);
    let verdict = verdict(&program, &[(0.0, f64::INFINITY)]);
    assert!(matches!(verdict, Verdict::Undecided { .. }), "{verdict:?}");
}
