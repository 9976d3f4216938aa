//! The motion that a mechanism makes by itself.

use crate::gallery::{FILES, SIZE, first, from_text, mechanism, near, path, player};
use mech_gallery::Exhibited;
use mech_gallery::skeleton::Skeleton;
use mech_studio::Document;
use mech_studio::play::{Derived, Mechanism, Player};
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The mechanism goes through its own motion twice, step by step: nothing is in its way, and all motors move.
fn goes_through(mut mechanism: Mechanism) {
    let title = mechanism.title().to_owned();
    let start = mechanism.motors().to_vec();
    let mut moved = vec![false; start.len()];
    let mut phase = 0.0;
    while phase < 2.0 * mechanism.length() {
        phase += 1.0 / 120.0;
        let goal = mechanism.motion(phase);
        let obstacle = mechanism.move_toward(&goal);
        assert!(obstacle.is_none(), "{title} at {phase}: {obstacle:?}");
        for (moved, (value, start)) in moved.iter_mut().zip(goal.iter().zip(&start)) {
            *moved |= (value - start).abs() > 1e-3;
        }
    }
    assert!(moved.iter().all(|moved| *moved), "{title}: {moved:?}");
}

#[test]
fn all_motors_of_the_gallery_move_and_nothing_is_in_their_way() {
    for file in FILES {
        goes_through(mechanism(file));
    }
}

/// Rates are the slopes of the values, and second rates those of the rates.
#[test]
fn rates_are_slopes() {
    const APART: f64 = 1e-5;
    for file in ["crane", "excavator", "skeleton"] {
        let mut mechanism = mechanism(file);
        mechanism.prepare(Derived::Rates);
        let seconds = mechanism.seconds();
        // Within a stroke, not where one motor follows another.
        for phase in [0.13, 0.77, 1.4] {
            let slopes = |before: &[f64], after: &[f64]| -> Vec<f64> {
                let pairs = before.iter().zip(after);
                pairs.map(|(before, after)| (after - before) / (2.0 * APART * seconds)).collect()
            };
            let [before, after] = [phase - APART, phase + APART];
            let here = mechanism.rates(phase);
            let first = slopes(&mechanism.motion(before), &mechanism.motion(after));
            let [low, high] = [before, after].map(|phase| mechanism.rates(phase).first);
            let size = mechanism.bounds()[1][0] - mechanism.bounds()[0][0];
            assert!(near(&here.first, &first, 1e-6 * size), "{file} {phase}");
            assert!(near(&here.second, &slopes(&low, &high), 1e-6 * size));
        }
    }
}

#[test]
fn motors_follow_their_laws_in_seconds() {
    let text = "struct Crank; link crank { point pin = (1, 0); }
joint a = revolute(ground, crank) at (0, 0);
motor a = 0.5 * t * t;";
    let mut mechanism = from_text(text);
    mechanism.prepare(Derived::Rates);
    let mut player = Player::new(mechanism, Vec::new(), SIZE);
    for _ in 0..40 {
        player.advance(0.1);
    }
    assert!(near(player.motors(), &[8.0], 1e-9), "{:?}", player.motors());
    let rates = player.mechanism().rates(4.0);
    assert!(near(&rates.first, &[4.0], 1e-12) && near(&rates.second, &[1.0], 1e-12));
}

#[test]
fn a_motor_keeps_within_its_range_and_comes_back() {
    let mut player = player("excavator");
    let start = player.motors().to_vec();
    let ranges: [[f64; 2]; 3] = [[1.65, 2.65], [2.75, 3.95], [1.75, 2.5]];
    let mut reached = ranges.map(|[low, high]| [high, low]);
    // Three strokes of 4 s.
    for _ in 0..240 {
        player.advance(0.05);
        for (reached, &value) in reached.iter_mut().zip(player.motors()) {
            *reached = [reached[0].min(value), reached[1].max(value)];
        }
    }
    assert!(near(player.motors(), &start, 1e-9), "{:?}", player.motors());
    for (reached, range) in reached.iter().zip(ranges) {
        let hundredth = 0.012 * (range[1] - range[0]);
        assert!(near(reached, &range, hundredth), "{reached:?} {range:?}");
        assert!(range[0] < reached[0] && reached[1] < range[1]);
    }
}

#[test]
fn a_crank_turns_on_and_on() {
    let mut player = player("four_bar");
    for _ in 0..60 {
        player.advance(0.1);
    }
    assert!(near(player.motors(), &[1.5 * TAU], 1e-9));
}

/// A slide without a declared range has no end of its own: it goes as far as the mechanism is large.
#[test]
fn a_slide_without_a_range_moves() {
    let text = "struct Slide; ground { line rail = (0, 0) -> (1, 0); }
link block { line rail = (0, 0) -> (1, 0); polygon [(-1, -1), (1, -1), (1, 1), (-1, 1)]; }
joint x = prismatic(ground.rail, block.rail);
motor x;";
    goes_through(from_text(text));
}

/// Four steps there and back take 8 s.
#[test]
fn by_the_laws_of_its_session_the_skeleton_walks_as_in_the_gallery() {
    let session = Path::new(env!("CARGO_MANIFEST_DIR")).join("sessions/skeleton_walks.txt");
    let session = fs::read_to_string(session).expect("a session");
    let session = session.strip_suffix("play\n").expect("it plays at the end");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("skeleton_walks");
    fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("skeleton.rs");
    fs::copy(path("skeleton"), &file).expect("a file");
    fs::write(folder.join("session.txt"), format!("{session}save\n")).expect("a file");
    let mut run = Command::new(env!("CARGO_BIN_EXE_mech"));
    run.current_dir(&folder).args(["run", "session.txt", "skeleton.rs"]);
    let done = run.output().expect("the command runs");
    assert!(done.status.success(), "{done:?}");
    let mechanism = first(&Document::read(&file).expect("a file"));
    for step in 0..=96 {
        let phase = f64::from(step) / 96.0;
        let motors = mechanism.motion(8.0 * phase / mechanism.seconds());
        assert!(near(&motors, &Skeleton::motion(phase), 1e-9), "{phase}");
    }
}
