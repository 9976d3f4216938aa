//! Animated SVG: at any time of its period everything is where the mechanism has it, to a tenth of a pixel.

use crate::{distance, player, seen};
use mech_gallery::four_bar::CrankRocker;
use mech_gallery::geared_piston::GearedPiston;
use mech_gallery::rocker_arm::RockerArm;
use mech_gallery::watt::Watt;
use mech_runtime::files::{AnimatedSvg, Sheet, Svg, animate};
use mech_runtime::{Blocked, Canvas, Mechanism, Outline, Pose, View, mechanism};
use proptest::prelude::*;
use resvg::usvg::roxmltree::Document;
use std::f64::consts::TAU;
use std::time::Duration;

/// The farthest that anything is from where it should be, in pixels; that it is the right thing, in the right order.
fn deviation<M: Mechanism>(view: View, motion: impl Fn(f64) -> M::Motors) -> f32 {
    let sheet = Sheet::new(640, 480).look_at(view);
    let film = animate::<M>(&sheet, Duration::from_millis(2700), &motion).expect("it moves");
    assert!(film.contains(".move{animation:linear 2.7s infinite}"));
    let mut mechanism = M::new();
    let mut worst = 0.0_f32;
    // By the golden ratio: spread over the turn, and in step with no frames.
    let mut phases: Vec<_> =
        (0..200).map(|number: u16| (0.618_034 * f64::from(number)).fract()).collect();
    phases.sort_by(f64::total_cmp);
    for phase in phases {
        mechanism.move_to(motion(phase)).expect("it moves");
        let mut wanted = Svg::new(sheet.clone());
        mechanism.draw(&mut wanted);
        worst = worst.max(distance(&film, phase, wanted));
    }
    println!("{}: {worst:.3} pixels, {} bytes", M::NAME, film.len());
    worst
}

#[test]
fn where_the_mechanism_is() {
    let turn = |phase: f64| [phase * TAU];
    let near = View::new([0.5, 1.0], 60.0);
    for worst in [
        deviation::<FourBar>(near, turn),
        deviation::<GearedPiston>(near, |phase| [2.0 * phase * TAU]),
        deviation::<Watt>(near, turn),
        deviation::<Leg>(View::new([0.0, 0.0], 4.0), turn),
        deviation::<RockerArm>(near, |phase| {
            let turn = phase * TAU;
            [turn, -1.35 + 0.55 * turn.sin(), -0.45 + 0.6 * (2.0 * turn).cos()]
        }),
        deviation::<Single>(near, |phase| {
            #[expect(clippy::cast_possible_truncation, reason = "of a few digits")]
            let turn = (phase * TAU) as f32;
            [-3.0 * turn, 2.0 * turn]
        }),
    ] {
        assert!(worst < 0.1, "{worst} pixels");
    }
}

mechanism! {
    /// Without a trace, which would be one shape more.
    struct FourBar;
    link crank;
    link coupler { point tip = (2.5, 3); }
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;
}

mechanism! {
    /// The same.
    struct Leg;
    use mech_runtime::parts::JansenLeg;
    link axle;
    joint main = revolute(ground, axle) at (0, 0);
    motor main;
    use leg: JansenLeg { frame = ground, crank = axle };
}

mechanism! {
    /// Backwards, three times a period, in single precision.
    struct Single: f32;
    ground { point o = (0, 0); circle (0, 0) radius 0.3 on plane 3 color 1; circle (1, 0) radius 0.3 on plane 0 color 4; }
    link crank {
        point shaft = (0, 0); point pin = (1, 0);
        polygon [(0, -0.1), (1, -0.1), (1, 0.1), (0, 0.1)] on plane 1 color 2;
    }
    link flag { point pin = (0, 0); polygon [(0, 0), (2, 0.5), (2, -0.5)] on plane 2 color 3; }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, flag.pin);
    motor a;
    motor b;
}

mechanism! {
    /// Its trace is shorter than its path.
    struct Traced;
    look none;
    ground { circle (0, 0) radius 0.3 on plane 0 color 1; }
    link crank;
    link coupler { point tip = (2.5, 3); circle (2.5, 3) radius 0.2 on plane 1 color 2; }
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;
    effects { trace coupler.tip 40 color 5; }
}

/// A trace that changes its form is the whole path of its point, behind what is in front of it.
#[test]
fn traces() {
    let sheet = Sheet::new(320, 240).look_at(View::new([2.0, 2.0], 60.0));
    let motion = |phase: f64| [phase * TAU];
    let text = animate::<Traced>(&sheet, Duration::from_secs(2), motion).expect("it turns");
    let seen = seen(&player::still(&text, 0.3));
    let fills = seen.iter().map(|(name, ..)| !name.starts_with("None"));
    // The paper is one.
    assert_eq!(fills.collect::<Vec<_>>(), [true, true, false, true]);
    let path = seen[2].2.iter();
    let path: Vec<_> = path.map(|point| [point.x, point.y].map(f64::from)).collect();
    assert_eq!(path.first(), path.last());
    let mut mechanism = Traced::new();
    for degrees in 0..720 {
        mechanism.move_to(motion(f64::from(degrees) / 720.0)).expect("it turns");
        let tip = mechanism.coupler_tip();
        let tip = [160.0 + 60.0 * (tip.x - 2.0), 120.0 - 60.0 * (tip.y - 2.0)];
        let distances = path.windows(2).map(|pair| to_line(tip, pair));
        let nearest = distances.fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.1, "{nearest} pixels at {degrees}");
    }
    let length: f64 = path.windows(2).map(|pair| to_line(pair[0], &[pair[1], pair[1]])).sum();
    assert!(length < 600.0, "more than once round: {length}");
}

/// From a point to a straight line from one point to another.
fn to_line(point: [f64; 2], line: &[[f64; 2]]) -> f64 {
    let [x, y] = [line[1][0] - line[0][0], line[1][1] - line[0][1]];
    let [to_x, to_y] = [point[0] - line[0][0], point[1] - line[0][1]];
    let share = ((to_x * x + to_y * y) / (x * x + y * y).max(1e-30)).clamp(0.0, 1.0);
    (to_x - share * x).hypot(to_y - share * y)
}

#[test]
fn what_blocks_is_reported() {
    let sheet = Sheet::new(64, 48);
    let beyond = |phase: f64| [phase * f64::INFINITY];
    let error = animate::<CrankRocker>(&sheet, Duration::from_secs(1), beyond);
    assert!(matches!(error, Err(Blocked { place: "a", .. })), "{error:?}");
}

#[test]
fn nothing_moves() {
    let still = AnimatedSvg::new(Sheet::new(3, 2), Duration::ZERO).finish();
    assert!(!still.contains("<style"));
    Document::parse(&still).expect("well-formed");
    let mut svg = AnimatedSvg::new(Sheet::new(3, 2), Duration::ZERO);
    for x in [f64::NAN, f64::INFINITY] {
        svg.add(|canvas| {
            let circle = Outline::Circle { center: [x, 0.0], radius: 1.0 };
            canvas.fill(circle, Pose::identity(), 1);
        });
    }
    assert_eq!(svg.finish(), still);
}

mechanism! {
    /// A wheel on a cart.
    struct Cart;
    ground { circle (0, 0) radius 0.3 on plane 3 color 1; }
    link cart { point hub = (0, 0); polygon [(-0.5, -0.2), (0.5, -0.2), (0.5, 0.2), (-0.5, 0.2)] on plane 1 color 2; }
    link wheel { point hub = (0, 0); polygon [(0, 0), (0.8, 0.2), (0.8, -0.2)] on plane 2 color 3; }
    joint x = prismatic(ground, cart) at (0, 0) along (1, 0);
    joint b = revolute(cart.hub, wheel.hub);
    motor x;
    motor b;
}

/// A wheel that turns once, or half a turn, from one of the first moments to the next.
#[test]
fn in_step_with_the_moments() {
    for turns in [64.0, 127.0, -128.0, 256.0, 1024.0] {
        let worst =
            deviation::<Cart>(View::new([0.0, 0.0], 20.0), |phase| [0.0, turns * phase * TAU]);
        assert!(worst < 0.1, "{worst} pixels");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// However often something turns in a period, it turns so often, and that way round.
    #[test]
    fn as_often_as_it_turns(turns in -1500..1500_i32, sway in 0.0..0.4, swings in 0..5_i32, more in 0..5_i32) {
        let worst = deviation::<Cart>(View::new([0.0, 0.0], 20.0), |phase| {
            let angle = phase * TAU;
            let there = 1.5 * (f64::from(swings) * angle).sin();
            [there, f64::from(turns) * angle + sway * (f64::from(more) * angle).cos()]
        });
        prop_assert!(worst < 0.1, "{} pixels", worst);
    }
}
