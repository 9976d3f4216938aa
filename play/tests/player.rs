//! The player, without a window.

#[allow(dead_code, reason = "no test needs all of it")]
mod common;

use common::{SIZE, near, player};
use mech_gallery::{Layer, Picture, Showcase, all_effects, exhibits};
use mech_play::{Camera, Command, Drive, Key, Medium, Painter, Player, Request, keys};
use mech_runtime::{Cause, Palette, mechanism};
use std::f64::consts::TAU;

mechanism! {
    /// A slide on a rail with two ends, and an arm on it that has none.
    pub struct Trolley;
    ground { line rail = (0, 0) -> (1, 0); }
    link slide { line rail = (0, 0) -> (1, 0); point pin = (0.5, 0); polygon [(-0.5, -0.3), (0.5, -0.3), (0.5, 0.3), (-0.5, 0.3)] color 2; }
    link arm { point pin = (0, 0); polygon [(0, -0.1), (2, -0.1), (2, 0.1), (0, 0.1)] color 3; }
    joint x = prismatic(ground.rail, slide.rail);
    joint turn = revolute(slide.pin, arm.pin);
    motor x in -1 ..= 2;
    motor turn in -720 deg ..= 720 deg;
    effects { acceleration; overlay; }
}

fn trolley() -> Player {
    let showcase = Showcase::<Trolley> {
        slug: "trolley",
        title: "Trolley",
        caption: "",
        source: include_str!("player.rs"),
        motion: |phase| [(phase * TAU).sin(), phase],
        frames: 60,
        still: 0.0,
        effects: Some(all_effects!(Trolley)),
    };
    Player::new(vec![Box::new(showcase)], 0, SIZE).expect("it moves")
}

fn picture(player: &Player) -> Picture {
    Painter::default().paint(player)
}

#[test]
fn every_exhibit_makes_its_own_motion() {
    for (index, exhibit) in exhibits().into_iter().enumerate() {
        let mut player = Player::new(exhibits(), index, SIZE).expect("it moves");
        let start = player.motors();
        let playable = exhibit.playable();
        let mut phase = 0.0;
        for frame in 0..100 {
            let seconds = 0.01 + 0.0002 * f64::from(frame);
            player.advance(seconds);
            phase += seconds / exhibit.seconds();
        }
        // It goes the way that its film goes, from wherever it was assembled.
        let pairs = playable.motion(phase).into_iter().zip(playable.motion(0.0));
        let expected: Vec<f64> = pairs
            .zip(start)
            .map(|((to, from), start)| start + to - from)
            .collect();
        let reached = player.motors();
        assert!(
            near(&reached, &expected, 1e-9),
            "{}: {reached:?}, not {expected:?}",
            exhibit.slug()
        );
        assert!(player.limit().is_none() && player.plays());
    }
}

#[test]
fn paused_means_still() {
    let mut player = player("jansen-leg");
    player.advance(0.3);
    let before = picture(&player);
    player.advance(0.1);
    assert_ne!(picture(&player), before);
    player.obey(Command::PlayOrPause);
    let (motors, paused) = (player.motors(), picture(&player));
    player.advance(0.1);
    assert_eq!((player.motors(), picture(&player)), (motors, paused));
}

#[test]
fn steps_speed_and_direction() {
    let mut player = player("four-bar");
    let [start] = player.motors()[..] else {
        panic!("one motor");
    };
    for _ in 0..120 {
        player.obey(Command::Step(1.0));
        assert!(!player.plays());
    }
    assert!(near(&player.motors(), &[start + TAU], 1e-9)); // a whole motion is a turn
    for _ in 0..120 {
        player.obey(Command::Step(-1.0));
    }
    assert!(near(&player.motors(), &[start], 1e-9));

    let distance = |player: &mut Player, commands: &[Command]| {
        player.obey(Command::Reset);
        for &command in commands {
            player.obey(command);
        }
        let before = player.motors()[0];
        player.advance(0.05);
        player.motors()[0] - before
    };
    player.obey(Command::PlayOrPause);
    let usual = distance(&mut player, &[]);
    assert!((usual - TAU * 0.05 / 2.7).abs() < 1e-9); // 90 frames of 30 ms
    let faster = distance(&mut player, &[Command::Faster, Command::Faster]);
    let slower = distance(&mut player, &[Command::Slower]);
    let back = distance(&mut player, &[Command::Reverse]);
    assert!(near(
        &[faster, slower, back],
        &[4.0 * usual, usual / 2.0, -usual],
        1e-9
    ));
}

#[test]
fn a_motor_alone() {
    let mut player = player("rocker-arm");
    let start = player.motors();
    player.obey(Command::NextMotor);
    player.obey(Command::NextMotor);
    assert_eq!(player.drive(), Drive::Motor(1));
    player.advance(0.1);
    let moved = player.motors();
    assert!(moved[0] == start[0] && moved[1] > start[1] && moved[2] == start[2]);
    player.obey(Command::NextMotor);
    player.obey(Command::NextMotor);
    assert_eq!(player.drive(), Drive::Motion);
    player.obey(Command::PreviousMotor);
    assert_eq!(player.drive(), Drive::Motor(2));
}

/// How many pixels have the red of a mark.
fn red(picture: &Picture) -> usize {
    let red = Palette::TEXTBOOK.rgba(Palette::RED);
    picture.pixels.iter().filter(|&&pixel| pixel == red).count()
}

#[test]
fn a_dead_point_stops_it_and_is_shown() {
    let mut player = player("luffing-crane");
    player.obey(Command::NextMotor);
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
    assert!(
        near(&player.motors(), &[angle(tie - back)], 1e-9),
        "{:?}",
        player.motors()
    );
    assert!(!player.plays());
    let limit = player.limit().expect("it is at one");
    assert_eq!(limit.blocked.cause, Cause::Open);
    let status = player.status();
    assert!(
        status.starts_with("motor `luff` stopped at 82."),
        "{status}"
    );
    assert!(status.contains("swing") && status.contains("back") && status.contains("head"));
    assert!(red(&picture(&player)) > before + 300);
    // Playing on there leads nowhere, a step beyond neither.
    player.obey(Command::PlayOrPause);
    player.advance(0.05);
    player.obey(Command::Step(1.0));
    assert!(!player.plays() && player.limit().is_some());
    assert!(near(&player.motors(), &[angle(tie - back)], 1e-9));
    // The other way it goes on, as far as the other one.
    player.obey(Command::Reverse);
    player.obey(Command::PlayOrPause);
    player.advance(0.05);
    assert!(player.plays() && player.limit().is_none());
    for _ in 0..200 {
        player.advance(0.05);
    }
    assert!(
        near(&player.motors(), &[angle(tie + back)], 1e-9),
        "{:?}",
        player.motors()
    );
    assert!(player.limit().is_some());
}

#[test]
fn the_end_of_a_range_stops_it_and_is_shown() {
    let mut player = trolley();
    player.obey(Command::NextMotor);
    for _ in 0..200 {
        player.advance(0.05);
    }
    assert_eq!(player.motors(), [2.0, 0.0]);
    let limit = player.limit().expect("it is at one");
    assert_eq!(
        (limit.blocked.cause, limit.motors.as_slice()),
        (Cause::OutOfRange, &[0][..])
    );
    assert_eq!(
        player.status(),
        "motor `x` stopped at 2.000: end of the declared range of `x`"
    );
    assert!(red(&picture(&player)) > 100);
    // The limit of one motor is not in the way of another.
    player.obey(Command::NextMotor);
    player.obey(Command::Step(1.0));
    assert!(player.limit().is_none());
    assert!(player.motors()[1] > 0.0);
}

#[test]
fn paper_is_panned_and_the_wheel_zooms() {
    let mut player = player("four-bar");
    player.obey(Command::PlayOrPause);
    let corner = [2.0, 2.0];
    let place = player.camera().place(corner);
    player.obey(Command::Press(corner));
    assert_eq!(player.held_spot(), None);
    player.obey(Command::Point([52.0, 22.0]));
    player.obey(Command::Release);
    let [x, y] = player.camera().pixel(place);
    assert!((x - 52.0).abs() + (y - 22.0).abs() < 1e-9);
    let place = player.camera().place([100.0, 80.0]);
    player.obey(Command::Zoom([100.0, 80.0], 1.5));
    let [x, y] = player.camera().pixel(place);
    assert!((x - 100.0).abs() + (y - 80.0).abs() < 1e-9);
    let zoomed = player.camera().view().scale();
    player.obey(Command::Fit);
    assert!(player.camera().view().scale() < zoomed);
}

#[test]
fn the_whole_motion_is_seen() {
    for (index, exhibit) in exhibits().into_iter().enumerate() {
        let player = Player::new(exhibits(), index, [333, 200]).expect("it moves");
        let bounds = exhibit
            .film()
            .expect("it moves")
            .bounds()
            .expect("it is seen");
        for corner in bounds {
            let [x, y] = player.camera().pixel(corner);
            assert!((0.0..=333.0).contains(&x) && (0.0..=200.0).contains(&y));
        }
    }
}

#[test]
fn layers_are_seen() {
    let mut player = player("four-bar");
    player.advance(0.1);
    player.obey(Command::PlayOrPause);
    let mut last = picture(&player);
    for layer in Layer::ALL.into_iter().rev() {
        player.obey(Command::Toggle(layer));
        let next = picture(&player);
        assert_ne!(next, last, "{}", layer.name());
        last = next;
    }
    let day = picture(&player);
    player.obey(Command::DayOrNight);
    assert_ne!(picture(&player), day);
    // A diagram has no shapes, and says so.
    let mut diagram = self::player("geared-piston-diagram");
    let layers = diagram.layers();
    diagram.obey(Command::Toggle(Layer::Shapes));
    assert_eq!(diagram.layers(), layers);
    assert!(
        diagram.status().contains("has no shapes"),
        "{}",
        diagram.status()
    );
}

#[test]
fn exhibits_follow_each_other() {
    let mut player = player("geared-piston");
    let slugs: Vec<_> = exhibits().iter().map(|exhibit| exhibit.slug()).collect();
    for slug in slugs.iter().cycle().take(slugs.len() + 1) {
        assert_eq!(player.slug(), *slug);
        player.obey(Command::NextExhibit);
    }
    player.obey(Command::PreviousExhibit);
    player.obey(Command::PreviousExhibit);
    assert_eq!(Some(&player.slug()), slugs.last());
}

#[test]
fn what_is_no_number_changes_nothing() {
    let mut player = player("rocker-arm");
    player.advance(0.1);
    let motors = player.motors();
    let camera = player.camera().clone();
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        player.advance(wrong);
        player.obey(Command::Step(wrong));
        player.obey(Command::Press([wrong, 3.0]));
        player.obey(Command::Point([wrong, wrong]));
        player.obey(Command::Zoom([wrong, 0.0], 2.0));
        player.obey(Command::Zoom([0.0, 0.0], wrong));
        player.obey(Command::Press([200.0, 200.0]));
        player.obey(Command::Point([wrong, 200.0]));
        player.obey(Command::Release);
    }
    player.obey(Command::Zoom([10.0, 10.0], 0.0));
    assert_eq!(player.motors(), motors);
    player.obey(Command::Fit);
    assert_eq!(player.camera(), &camera);
    for size in [[0, 0], [1, 1], [0, 50], [5000, 3]] {
        player.obey(Command::Resize(size));
        let picture = picture(&player);
        assert_eq!(picture.pixels.len(), size[0] * size[1]);
    }
    assert!(Player::new(exhibits(), 99, SIZE).is_err());
}

#[test]
fn a_camera_of_nothing_is_usable() {
    let camera = Camera::new([[0.0, 0.0]; 2], [0, 0]);
    assert!(camera.place([0.0, 0.0]).iter().all(|c| c.is_finite()));
}

#[test]
fn keys_do_what_help_says() {
    let help = keys::help().join("\n");
    for (letter, command) in [
        (' ', Command::PlayOrPause),
        ('b', Command::Reverse),
        ('d', Command::DayOrNight),
        ('n', Command::NextExhibit),
        ('r', Command::Reset),
        ('f', Command::Fit),
        ('s', Command::Save),
        ('h', Command::Help),
        ('q', Command::Quit),
    ] {
        assert_eq!(Key::Char(letter).command(), Some(command));
        assert_eq!(
            Key::Char(letter.to_ascii_uppercase()).command(),
            Some(command)
        );
        let label = if letter == ' ' {
            "space".into()
        } else {
            letter.to_string()
        };
        assert!(
            help.lines().any(|line| line.starts_with(&label)),
            "{letter}"
        );
    }
    for (letter, layer) in ('1'..='7').zip(Layer::ALL) {
        assert_eq!(Key::Char(letter).command(), Some(Command::Toggle(layer)));
    }
    assert_eq!(Key::Char('x').command(), None);
}

#[test]
fn command_lines() {
    let read = |line: &str| Request::read(line.split_whitespace().map(str::to_owned));
    let shown = |name: Option<&str>, medium| {
        let name = name.map(str::to_owned);
        Ok(Request::Show { name, medium })
    };
    assert_eq!(read(""), shown(None, Medium::Window));
    assert_eq!(
        read("four-bar --terminal"),
        shown(Some("four-bar"), Medium::Terminal)
    );
    assert_eq!(
        read("--after 1.5 x --picture y.png"),
        shown(Some("x"), Medium::Picture("y.png".into(), 1.5))
    );
    assert_eq!(read("--list --wat"), Ok(Request::List));
    for (line, what) in [
        ("--wat", "there is no option `--wat`"),
        ("a b", "`b` is one name too many"),
        ("--picture", "`--picture` needs"),
        ("--picture f --after NaN", "`--after` needs"),
        ("--picture f --after -1", "`--after` needs"),
        ("--after 1", "`--after` needs a `--picture`"),
    ] {
        let error = read(line).expect_err(line).to_string();
        assert!(error.starts_with(what), "{error}");
    }
}
