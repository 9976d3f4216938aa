//! What is said of the large mechanisms, against numbers that are known from elsewhere.

use mech_gallery::Exhibited;
use mech_gallery::antikythera::Antikythera;
use mech_gallery::excavator::Excavator;
use mech_gallery::skeleton::Skeleton;
use mech_gallery::walker::Walker;
use mech_runtime::Mechanism;
use std::f64::consts::TAU;

/// The lines of a declaration in the source of an exhibit.
fn declaration(source: &str) -> usize {
    let lines = source.lines().skip_while(|line| *line != "mechanism! {");
    let body = lines.skip(1).take_while(|line| *line != "}");
    let is_text = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//");
    body.filter(is_text).count()
}

#[test]
fn each_is_declared_in_sixty_lines() {
    let lines =
        [Walker::SOURCE, Excavator::SOURCE, Antikythera::SOURCE, Skeleton::SOURCE].map(declaration);
    assert!(lines.iter().all(|lines| (10..=60).contains(lines)), "{lines:?}");
}

/// The periods of Freeth and others, Nature 444 (2006), in turns a year.
#[test]
fn the_computer_has_the_periods_of_the_sky() {
    for period in [
        "mean_moon.turn by -254/19 · year.turn",
        "metonic.turn by -5/19 · year.turn",
        "games.turn by 1/4 · year.turn",
        "callippic.turn by -1/76 · year.turn",
        "saros.turn by -940/4237 · year.turn",
        "exeligmos.turn by -235/12711 · year.turn",
        "carrier.turn by -477/4237 · year.turn",
    ] {
        let line = format!("  moved     {period}");
        assert!(Antikythera::REPORT.lines().any(|other| other == line), "{period}");
    }
}

/// A pin 9.6 mm from its axle in a slot whose axle is 1.1 mm away: the moon is at most asin(1.1 / 9.6) from its mean.
#[test]
fn the_moon_is_faster_and_slower() {
    let mut m = Antikythera::new();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for step in 0..=4000 {
        m.move_to([TAU * f64::from(step) / 4000.0]).expect("it turns");
        let ahead = (m.true_moon().turn() - m.mean_moon().turn()).sin().asin();
        (low, high) = (low.min(ahead), high.max(ahead));
    }
    let amplitude = (high - low) / 2.0;
    let expected = (1.1_f64 / 9.6).asin();
    assert!((amplitude - expected).abs() < 1e-4 * expected, "{amplitude} {expected}");
    // After 19 years moon and sun are where they were, and nothing is lost.
    m.move_to([19.0 * TAU]).expect("it turns");
    assert!((m.mean_moon().turn() + 254.0 * TAU).abs() < 1e-11);
}

/// Every corner of the three strokes is reached, by a move that cannot fail.
#[test]
fn all_strokes_of_the_excavator_are_free() {
    const STROKES: [[f64; 2]; 3] = [[1.65, 2.65], [2.75, 3.95], [1.75, 2.5]];
    assert!(Excavator::range([1.6, 3.0, 2.0]).is_none());
    for corner in 0..8_usize {
        let mut m = Excavator::new();
        let ends = [0, 1, 2].map(|motor| STROKES[motor][(corner >> motor) & 1]);
        m.move_within(Excavator::range(ends).expect("it is an end of each stroke"));
        let lengths = [
            (m.lift().rod_pin() - m.lift().barrel_pin()).norm(),
            (m.crowd().rod_pin() - m.crowd().barrel_pin()).norm(),
            (m.curl().rod_pin() - m.curl().barrel_pin()).norm(),
        ];
        for (length, end) in lengths.iter().zip(ends) {
            assert!((length - end).abs() < 1e-12);
        }
    }
}

#[test]
fn the_skeleton_has_two_hundred_freedoms_and_eight_motors() {
    assert!(Skeleton::MOTORS.len() <= 8);
    let free = Skeleton::JOINTS.iter().filter(|joint| joint.links.len() > 1);
    assert!(free.count() >= 200);
    let line = Skeleton::REPORT.lines().find_map(|line| line.strip_prefix("  freedoms  "));
    assert_eq!(line, Some("232 of joints: 8 by motors, 223 by gears, belts and racks, 1 by cams"));
}

/// While a foot carries, it stands: the ankle's path along the ground is what the law of the leg leaves of 100 a stride.
#[test]
fn the_skeleton_does_not_slip() {
    let mut m = Skeleton::new();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for step in 0..1000 {
        let phase = f64::from(step) / 1000.0 / 4.0;
        m.move_to(Skeleton::motion(phase)).expect("it walks");
        let stride = (1.0 - (TAU * phase).cos()).rem_euclid(1.0);
        if (0.08..0.42).contains(&stride) && phase < 0.25 {
            let ankle = m.leg(0).talus().bone_head();
            let place = ankle.x - 100.0 * (1.0 - (TAU * phase).cos()).floor();
            (low, high) = (low.min(place), high.max(place));
        }
    }
    assert!(high - low < 0.5, "{low} to {high}");
}

/// Six evenly spaced legs on each side: after a sixth of a turn each foot is where that of the next leg was.
#[test]
fn each_leg_of_the_walker_follows_the_next() {
    let mut m = Walker::new();
    m.move_to([1.0]).expect("it turns");
    let places =
        |m: &Walker| [0, 1, 2, 3, 4, 5].map(|k| [m.left(k).foot_tip(), m.right(k).foot_tip()]);
    let before = places(&m);
    m.move_to([1.0 + TAU / 6.0]).expect("it turns");
    let after = places(&m);
    for k in 0..6 {
        let next = [before[(k + 1) % 6][0], before[(k + 5) % 6][1]];
        assert!((after[k][0] - next[0]).norm() < 1e-10, "{k}");
        assert!((after[k][1] - next[1]).norm() < 1e-10, "{k}");
    }
}
