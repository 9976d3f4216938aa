//! Links that are dragged, without a window.

use crate::gallery::{FILES, SIZE, from_text, mechanism, near, player};
use mech_runtime::overlay::Spot;
use mech_studio::play::{Control, Free, Grip, Player};
use std::f64::consts::TAU;

#[test]
fn a_dragged_crank_points_at_the_pointer() {
    let mut player = player("four_bar");
    player.obey(Control::PlayOrPause);
    let pin = Spot { link: 1, at: [1.0, 0.0] };
    let camera = player.camera().clone();
    player.obey(Control::Press(player.pixel(pin).expect("it is there")));
    let held = player.held_spot().expect("a link is there");
    // The link there may be the coupler: its end goes the same circle.
    assert!(held.link == 1 || held.link == 2, "{held:?}");
    for step in 1..200 {
        let angle = 0.11 * f64::from(step);
        let distance = if step % 2 == 0 { 0.4 } else { 2.5 };
        player.obey(Control::Point(camera.pixel([distance * angle.cos(), distance * angle.sin()])));
        // Of a circle, what is nearest to a place lies in its direction; the motor counts turns.
        assert!(near(player.motors(), &[angle], 2e-3), "{:?}, not {angle}", player.motors());
    }
    player.obey(Control::Release);
    let motors = player.motors().to_vec();
    player.obey(Control::Point([0.0, 0.0]));
    assert_eq!(player.motors(), motors);
}

#[test]
fn what_is_held_comes_as_near_as_it_can() {
    let mut pulled = 0;
    for file in FILES {
        let mut mechanism = mechanism(file);
        let motors = mechanism.motors().len();
        let free: Vec<Free> = (0..motors).map(|motor| Free { motor, reach: TAU }).collect();
        for phase in [0.13, 0.38, 0.71] {
            let target = mechanism.motion(phase);
            assert_eq!(mechanism.move_toward(&target), None, "{file}");
            for link in 1..=3 {
                let spot = Spot { link, at: [0.3, 0.2] };
                let start = mechanism.place(spot).expect("it is there");
                for side in 0..4 {
                    let (sin, cos) = (0.4 + TAU / 4.0 * f64::from(side)).sin_cos();
                    let size = 0.1 * start[0].hypot(start[1]).max(0.01);
                    let aim = [start[0] + size * cos, start[1] + size * sin];
                    let distance = |[x, y]: [f64; 2]| (aim[0] - x).hypot(aim[1] - y);
                    let before = distance(mechanism.place(spot).expect("it is there"));
                    Grip { spot }.follow(&mut mechanism, &free, aim);
                    let after = distance(mechanism.place(spot).expect("it is there"));
                    assert!(after <= before);
                    // No motor by itself brings it nearer by a thousandth of the way.
                    for motor in 0..motors {
                        for turn in [-1e-2, -1e-3, 1e-3, 1e-2] {
                            let mut motors = mechanism.motors().to_vec();
                            motors[motor] += turn;
                            let other = mechanism.place_toward(spot, &motors).expect("numbers");
                            let nearer = after - distance(other);
                            assert!(
                                nearer < 5e-3 * before,
                                "{file} {phase} {link} {side}: {after} of {before}, by {turn} nearer by {nearer}"
                            );
                        }
                    }
                    pulled += usize::from(after < 0.9 * before);
                }
            }
        }
    }
    assert!(pulled > 200, "{pulled}");
}

#[test]
fn a_hand_is_led_where_three_motors_reach() {
    let mut player = player("rocker_arm");
    player.obey(Control::PlayOrPause);
    let hand = Spot { link: 5, at: [1.2, 0.3] };
    let start = player.pixel(hand).expect("it is there");
    player.obey(Control::Press(start));
    let held = player.held_spot().expect("a link is there");
    for step in 0..30 {
        let aim = [start[0] - 2.0 * f64::from(step), start[1] + 1.5 * f64::from(step)];
        player.obey(Control::Point(aim));
        let [x, y] = player.pixel(held).expect("it is there");
        let distance = (x - aim[0]).hypot(y - aim[1]);
        assert!(distance < 0.1, "step {step}: {distance} pixels away");
    }
}

#[test]
fn dragged_to_a_limit_and_back() {
    let mut player = player("crane");
    let head = Spot { link: 1, at: [7.4, 0.0] };
    let start = player.pixel(head).expect("it is there");
    player.obey(Control::Press(start));
    // Far to the left: the jib cannot lean back beyond its dead point.
    for step in 1..=20 {
        player.obey(Control::Point([start[0] - 15.0 * f64::from(step), start[1]]));
    }
    let limit = player.limit().expect("it is at one");
    assert_eq!(limit.motors, [0]);
    assert!(player.status().contains("stopped at 82."), "{}", player.status());
    for step in (0..=20).rev() {
        player.obey(Control::Point([start[0] - 15.0 * f64::from(step), start[1]]));
    }
    assert!(player.limit().is_none());
    let [x, y] = player.pixel(head).expect("it is there");
    assert!((x - start[0]).hypot(y - start[1]) < 1.0);
}

#[test]
fn a_diagram_without_shapes_is_dragged_by_its_bars() {
    let mut player = player("diagram");
    player.obey(Control::PlayOrPause);
    let rod = Spot { link: 3, at: [2.0, 0.0] };
    player.obey(Control::Press(player.pixel(rod).expect("it is there")));
    assert_eq!(player.held_spot().map(|spot| spot.link), Some(3));
}

/// A place on a link of a text that is dragged round, and how far it ever is from the pointer.
fn dragged(text: &str, spot: Spot<f64>, radius: f64) -> (Player, f64) {
    let mut player = Player::new(from_text(text), Vec::new(), SIZE);
    player.obey(Control::PlayOrPause);
    let camera = player.camera().clone();
    let start = player.mechanism().place(spot).expect("it is there");
    player.obey(Control::Press(camera.pixel(start)));
    let held = player.held_spot().expect("a link is there");
    let mut worst: f64 = 0.0;
    for step in 0..=90 {
        let turn = TAU * f64::from(step) / 60.0;
        let aim = [start[0] + radius * (turn.cos() - 1.0), start[1] + radius * turn.sin()];
        player.obey(Control::Point(camera.pixel(aim)));
        let [x, y] = player.mechanism().place(held).expect("it is there");
        worst = worst.max((x - aim[0]).hypot(y - aim[1]));
    }
    (player, worst)
}

#[test]
fn what_follow_leads_is_dragged_exactly() {
    let plotter = include_str!("../../../tests/tests/subjects/inverse/plotter.mech");
    let tip = Spot { link: 3, at: [2.5, 0.0] };
    let (mut player, worst) = dragged(plotter, tip, 0.6);
    assert!(worst < 1e-12, "{worst:e}");
    assert!(player.limit().is_none());
    // Beyond its arms it comes as near as it can, and back again.
    let start = player.pixel(tip).expect("it is there");
    player.obey(Control::Point([start[0] + 3000.0, start[1]]));
    let place = player.mechanism().place(tip).expect("it is there");
    assert!(place.iter().all(|part| part.is_finite()) && place[0] > 1.0, "{place:?}");
    player.obey(Control::Point(start));
    let [x, y] = player.pixel(tip).expect("it is there");
    assert!((x - start[0]).hypot(y - start[1]) < 1e-9, "{x}, {y}");
    // Of a pose any place of the link is led, and the link keeps its angle.
    let platform = include_str!("../../../tests/tests/subjects/inverse/platform.mech");
    let corner = Spot { link: 1, at: [3.8, 1.2] };
    let (player, worst) = dragged(platform, corner, 0.2);
    assert!(worst < 1e-12, "{worst:e}");
    let held = player.held_spot().expect("it is held");
    let pose = player.mechanism().poses()[held.link].expect("it is shown");
    assert!(pose.sin.abs() < 1e-12, "{pose:?}");
}
