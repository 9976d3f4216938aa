//! The player, without a window.

use crate::gallery::{FILES, SIZE, from_text, mechanism, near, picture, player};
use mech_compiler::evaluate::Stop;
use mech_runtime::{HeapSmooth, Palette};
use mech_studio::play::{Camera, Control, Key, Layer, Obstacle, Player, Selection, keys};
use std::f64::consts::TAU;

/// A slide on a rail with two ends, and an arm on it that has none.
const TROLLEY: &str = "struct Trolley;
ground { line rail = (0, 0) -> (1, 0); }
link slide { line rail = (0, 0) -> (1, 0); point pin = (0.5, 0); polygon [(-0.5, -0.3), (0.5, -0.3), (0.5, 0.3), (-0.5, 0.3)] color 2; }
link arm { point pin = (0, 0); polygon [(0, -0.1), (2, -0.1), (2, 0.1), (0, 0.1)] color 3; }
joint x = prismatic(ground.rail, slide.rail);
joint turn = revolute(slide.pin, arm.pin);
motor x in -1 ..= 2;
motor turn in -720 deg ..= 720 deg;";

fn trolley() -> Player {
    Player::new(from_text(TROLLEY), Vec::new(), SIZE)
}

#[test]
fn paused_means_still() {
    let mut player = player("jansen");
    player.advance(0.3);
    let before = picture(&player);
    player.advance(0.1);
    assert!(picture(&player) != before);
    player.obey(Control::PlayOrPause);
    let (motors, paused) = (player.motors().to_vec(), picture(&player));
    player.advance(0.1);
    assert!(player.motors() == motors && picture(&player) == paused);
}

#[test]
fn steps_speed_and_direction() {
    let mut player = player("four_bar");
    let [start] = player.motors()[..] else {
        panic!("one motor");
    };
    for _ in 0..120 {
        player.obey(Control::Step(1.0));
        assert!(!player.plays());
    }
    assert!(near(player.motors(), &[start + TAU], 1e-9)); // a whole motion is a turn
    for _ in 0..120 {
        player.obey(Control::Step(-1.0));
    }
    assert!(near(player.motors(), &[start], 1e-9));

    let distance = |player: &mut Player, controls: &[Control]| {
        player.obey(Control::Reset);
        for &control in controls {
            player.obey(control);
        }
        let before = player.motors()[0];
        player.advance(0.05);
        player.motors()[0] - before
    };
    player.obey(Control::PlayOrPause);
    let usual = distance(&mut player, &[]);
    assert!((usual - TAU * 0.05 / 4.0).abs() < 1e-9); // a stroke takes 4 s
    let faster = distance(&mut player, &[Control::Faster, Control::Faster]);
    let slower = distance(&mut player, &[Control::Slower]);
    let back = distance(&mut player, &[Control::Reverse]);
    assert!(near(&[faster, slower, back], &[4.0 * usual, usual / 2.0, -usual], 1e-9));
}

#[test]
fn a_motor_alone() {
    let mut player = player("rocker_arm");
    let start = player.motors().to_vec();
    player.obey(Control::NextMotor);
    player.obey(Control::NextMotor);
    assert_eq!(player.selection(), Selection::Motor(1));
    player.advance(0.1);
    let moved = player.motors();
    assert!(moved[0] == start[0] && moved[1] > start[1] && moved[2] == start[2]);
    player.obey(Control::NextMotor);
    player.obey(Control::NextMotor);
    assert_eq!(player.selection(), Selection::Motion);
    player.obey(Control::PreviousMotor);
    assert_eq!(player.selection(), Selection::Motor(2));
}

/// Counts the pixels that have the red of a mark.
fn red(picture: &HeapSmooth) -> usize {
    let red = Palette::TEXTBOOK.rgba(Palette::RED);
    picture.pixels().iter().filter(|&&pixel| pixel == red).count()
}

#[test]
fn a_dead_point_stops_it_and_is_shown() {
    let mut player = player("crane");
    player.obey(Control::NextMotor);
    let before = red(&picture(&player));
    for _ in 0..200 {
        player.advance(0.05);
    }
    // Where tie and back of the nose lie upon each other: by the cosine law, from what is declared.
    let ([jib, tie, back], foot) = ([7.4, 7.3, 1.5], [-2.2, 2.5_f64]);
    let ground = f64::hypot(foot[0], foot[1]);
    let angle = |far: f64| {
        let cosine = (jib * jib + ground * ground - far * far) / (2.0 * jib * ground);
        foot[1].atan2(foot[0]) - cosine.acos()
    };
    assert!(near(player.motors(), &[angle(tie - back)], 1e-9), "{:?}", player.motors());
    assert!(!player.plays());
    let limit = player.limit().expect("it is at one");
    assert!(matches!(limit.obstacle, Obstacle::Stop(Stop::Open(_))));
    let status = player.status();
    assert!(status.starts_with("motor `luff` stopped at 82."), "{status}");
    assert!(status.contains("swing") && status.contains("back") && status.contains("head"));
    assert!(red(&picture(&player)) > before + 300);
    // Playing on there leads nowhere, a step beyond neither.
    player.obey(Control::PlayOrPause);
    player.advance(0.05);
    player.obey(Control::Step(1.0));
    assert!(!player.plays() && player.limit().is_some());
    assert!(near(player.motors(), &[angle(tie - back)], 1e-9));
    // The other way it goes on, as far as the other one.
    player.obey(Control::Reverse);
    player.obey(Control::PlayOrPause);
    player.advance(0.05);
    assert!(player.plays() && player.limit().is_none());
    for _ in 0..200 {
        player.advance(0.05);
    }
    assert!(near(player.motors(), &[angle(tie + back)], 1e-9), "{:?}", player.motors());
    assert!(player.limit().is_some());
}

#[test]
fn the_end_of_a_range_stops_it_and_is_shown() {
    let mut player = trolley();
    player.obey(Control::NextMotor);
    for _ in 0..200 {
        player.advance(0.05);
    }
    assert_eq!(player.motors(), [2.0, 0.0]);
    let limit = player.limit().expect("it is at one");
    assert!(matches!(limit.obstacle, Obstacle::Range(_)));
    assert_eq!(limit.motors, [0]);
    assert_eq!(player.status(), "motor `x` stopped at 2.000: end of the declared range of `x`");
    assert!(red(&picture(&player)) > 100);
    // The limit of one motor is not in the way of another.
    player.obey(Control::NextMotor);
    player.obey(Control::Step(1.0));
    assert!(player.limit().is_none());
    assert!(player.motors()[1] > 0.0);
}

#[test]
fn paper_is_panned_and_the_wheel_zooms() {
    let mut player = player("four_bar");
    player.obey(Control::PlayOrPause);
    let corner = [2.0, 2.0];
    let place = player.camera().place(corner);
    player.obey(Control::Press(corner));
    assert_eq!(player.held_spot(), None);
    player.obey(Control::Point([52.0, 22.0]));
    player.obey(Control::Release);
    let [x, y] = player.camera().pixel(place);
    assert!((x - 52.0).abs() + (y - 22.0).abs() < 1e-9);
    let place = player.camera().place([100.0, 80.0]);
    player.obey(Control::Zoom([100.0, 80.0], 1.5));
    let [x, y] = player.camera().pixel(place);
    assert!((x - 100.0).abs() + (y - 80.0).abs() < 1e-9);
    let zoomed = player.camera().view().scale();
    player.obey(Control::Fit);
    assert!(player.camera().view().scale() < zoomed);
}

#[test]
fn the_whole_motion_is_seen() {
    for file in FILES {
        let player = Player::new(mechanism(file), Vec::new(), [333, 200]);
        for corner in player.mechanism().bounds() {
            let [x, y] = player.camera().pixel(corner);
            assert!((0.0..=333.0).contains(&x) && (0.0..=200.0).contains(&y));
        }
    }
}

#[test]
fn layers_are_seen() {
    let mut player = player("four_bar");
    player.advance(0.1);
    player.obey(Control::PlayOrPause);
    let mut last = picture(&player);
    for layer in Layer::ALL.into_iter().rev() {
        player.prepare(layer);
        player.obey(Control::Toggle(layer));
        let next = picture(&player);
        assert!(next != last, "{}", layer.name());
        last = next;
    }
    let day = picture(&player);
    player.obey(Control::DayOrNight);
    assert!(picture(&player) != day);
    // A diagram has no shapes, and says so.
    let mut diagram = self::player("diagram");
    let layers = diagram.layers();
    diagram.obey(Control::Toggle(Layer::Shapes));
    assert_eq!(diagram.layers(), layers);
    assert!(diagram.status().contains("has no shapes"), "{}", diagram.status());
}

#[test]
fn mechanisms_follow_each_other() {
    let files = ["geared_piston", "crane", "watt"];
    let titles = ["GearedPiston", "LuffingCrane", "Watt"];
    let others = files[1..].iter().map(|file| mechanism(file)).collect();
    let mut player = Player::new(mechanism(files[0]), others, SIZE);
    for title in titles.iter().cycle().take(4) {
        assert_eq!(player.title(), *title);
        player.advance(0.1);
        player.obey(Control::NextMechanism);
    }
    for title in ["GearedPiston", "Watt", "LuffingCrane"] {
        player.obey(Control::PreviousMechanism);
        assert_eq!(player.title(), title);
    }
}

#[test]
fn what_is_no_number_changes_nothing() {
    let mut player = player("rocker_arm");
    player.advance(0.1);
    let motors = player.motors().to_vec();
    let camera = player.camera().clone();
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        player.advance(wrong);
        player.obey(Control::Step(wrong));
        player.obey(Control::Press([wrong, 3.0]));
        player.obey(Control::Point([wrong, wrong]));
        player.obey(Control::Zoom([wrong, 0.0], 2.0));
        player.obey(Control::Zoom([0.0, 0.0], wrong));
        player.obey(Control::Press([200.0, 200.0]));
        player.obey(Control::Point([wrong, 200.0]));
        player.obey(Control::Release);
    }
    player.obey(Control::Zoom([10.0, 10.0], 0.0));
    assert_eq!(player.motors(), motors);
    player.obey(Control::Fit);
    assert_eq!(player.camera(), &camera);
    for size in [[0, 0], [1, 1], [0, 50], [5000, 3]] {
        player.obey(Control::Resize(size));
        let picture = picture(&player);
        assert_eq!(picture.pixels().len(), size[0] * size[1]);
    }
}

#[test]
fn a_camera_of_nothing_is_usable() {
    let camera = Camera::new([[0.0, 0.0]; 2], [0, 0]);
    assert!(camera.place([0.0, 0.0]).iter().all(|c| c.is_finite()));
}

#[test]
fn keys_do_what_help_says() {
    let help = keys::help().join("\n");
    for (letter, control) in [
        (' ', Control::PlayOrPause),
        ('b', Control::Reverse),
        ('d', Control::DayOrNight),
        ('n', Control::NextMechanism),
        ('r', Control::Reset),
        ('f', Control::Fit),
        ('s', Control::Save),
        ('h', Control::Help),
        ('q', Control::Quit),
    ] {
        assert_eq!(Key::Char(letter).control(), Some(control));
        assert_eq!(Key::Char(letter.to_ascii_uppercase()).control(), Some(control));
        let label = if letter == ' ' { "space".into() } else { letter.to_string() };
        assert!(help.lines().any(|line| line.starts_with(&label)), "{letter}");
    }
    for (letter, layer) in ('1'..='7').zip(Layer::ALL) {
        assert_eq!(Key::Char(letter).control(), Some(Control::Toggle(layer)));
    }
    assert_eq!(Key::Char('x').control(), None);
}
