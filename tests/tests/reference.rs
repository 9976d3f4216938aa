//! Positions held against numbers that nobody of this project made.

use super::literature::{FourBar, SliderCrank, Tracer, rows};
use mech_gallery::andrews::AndrewsSqueezer;
use mech_gallery::jansen::JansenLeg;
use mech_runtime::{Isometry2, Point2};
use std::f64::consts::{PI, TAU};

const TOLERANCE: f64 = 1e-12;

#[track_caller]
fn assert_point(found: Point2<f64>, x: f64, y: f64) {
    assert!((found.x - x).abs() < TOLERANCE, "x: {} instead of {x}", found.x);
    assert!((found.y - y).abs() < TOLERANCE, "y: {} instead of {y}", found.y);
}

#[track_caller]
fn assert_turned(link: Isometry2<f64>, angle: f64) {
    let found = link.rotation.angle();
    assert!((found - angle).abs() < TOLERANCE, "{found} instead of {angle}");
}

#[test]
fn teaching_four_bar() {
    let mut mechanism = FourBar::new();
    for [angle, x, y, coupler, rocker] in rows(include_str!("literature/four-bar.txt")) {
        mechanism.move_to([angle]).unwrap();
        assert_point(mechanism.coupler_end(), x, y);
        assert_point(mechanism.rocker_end(), x, y);
        assert_turned(mechanism.coupler(), coupler);
        assert_turned(mechanism.rocker(), rocker);
    }
}

#[test]
fn teaching_slider_crank() {
    let rows = rows::<3>(include_str!("literature/slider-crank.txt"));
    let [start, at, _] = rows[0];
    let mut mechanism = SliderCrank::new();
    for [angle, x, rod] in rows {
        mechanism.move_to([angle - start]).unwrap();
        assert_point(mechanism.rod_end(), x, 10.01);
        assert_turned(mechanism.rod(), rod);
        assert!((mechanism.x() - (x - at)).abs() < TOLERANCE);
    }
}

#[test]
fn slider_crank_tracer() {
    let rows = rows::<3>(include_str!("literature/tracer.txt"));
    let [start, ..] = rows[0];
    let mut mechanism = Tracer::new();
    for [angle, x, rod] in rows {
        mechanism.move_to([angle - start]).unwrap();
        assert_point(mechanism.rod_end(), x, 0.0);
        assert_turned(mechanism.rod(), rod);
        // The tracer is (8, 2) from the end of the rod at the start, and turns with the rod.
        let (sin, cos) = rod.sin_cos();
        assert_point(mechanism.rod_tracer(), x + 8.0 * cos - 2.0 * sin, 8.0 * sin + 2.0 * cos);
    }
}

#[test]
fn andrews_squeezer_by_continuation_from_its_start() {
    let mut mechanism = AndrewsSqueezer::new();
    let mut worst: f64 = 0.0;
    for row in rows::<7>(include_str!("literature/andrews.txt")) {
        let from = mechanism.beta();
        // A degree a step, as a film would.
        let steps = ((row[0] - from).abs().to_degrees()).ceil().max(1.0);
        let mut done = 0.0;
        while done < steps {
            done += 1.0;
            mechanism.move_to([from + (row[0] - from) * (done / steps)]).unwrap();
        }
        let found = [
            mechanism.beta(),
            mechanism.theta(),
            mechanism.gamma(),
            mechanism.phi(),
            mechanism.delta(),
            mechanism.omega(),
            mechanism.epsilon(),
        ];
        for (found, expected) in found.into_iter().zip(row) {
            worst = worst.max(((found - expected + PI).rem_euclid(TAU) - PI).abs());
        }
    }
    println!("Andrews: worst of 14 rows {worst:.1e} rad");
    assert!(worst < TOLERANCE, "{worst:e}");
}

#[test]
fn jansens_foot() {
    let mut mechanism = JansenLeg::new();
    let drawn = f64::atan2(11.52, 9.61);
    let mut worst: f64 = 0.0;
    for (degrees, x, y) in
        [(0.0, -43.170_055_155, -91.753_225_905), (45.0, -24.406_393_593, -91.789_596_143)]
    {
        mechanism.move_to([f64::to_radians(degrees) - drawn]).unwrap();
        worst = worst.max((mechanism.lower_plate_foot() - Point2::new(x, y)).norm());
    }
    println!("Jansen: foot at most {worst:.1e} off");
    assert!(worst < 1e-6, "{worst:e}");
}
