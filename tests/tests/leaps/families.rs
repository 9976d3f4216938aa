//! Families of mechanisms, by name, in which leaps went wrong once or easily could.

use super::comparing::{Finding, Kind, compare, shorten};
use super::reading::Subject;
use mech_compiler::evaluate::Machine;
use mech_test_support::{Dice, for_all};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// What is wrong with one leap, and where it ends.
fn wrong(
    subject: &Subject,
    from: &Position,
    to: &[f64],
) -> (impl Iterator<Item = String> + use<>, Option<Position>) {
    let (found, end) = compare(subject, from, &shorten(subject, from, to, 20_000.0));
    let counts = |finding: &Finding| finding.kind != Kind::Undecided;
    let line = |finding: Finding| format!("{:?}: {}", finding.kind, finding.text);
    (found.into_iter().filter(counts).map(line), end)
}

type Position = mech_compiler::program::Position<f64>;

fn start(subject: &Subject) -> Position {
    let machine = Machine::<f64>::new(&subject.compiled.program);
    machine.position().clone()
}

/// Tests leaps from the start to each of these targets.
#[track_caller]
pub(crate) fn assert_leaps(subject: &Subject, targets: &[Vec<f64>]) {
    let start = start(subject);
    let found = targets.iter().flat_map(|to| wrong(subject, &start, to).0);
    none(subject, &found.collect::<Vec<_>>());
}

/// Tests leaps to these targets, each from where the one before led to.
#[track_caller]
pub(crate) fn assert_leaps_in_a_row(subject: &Subject, targets: &[Vec<f64>]) {
    none(subject, &wrong_in_a_row(subject, targets));
}

fn wrong_in_a_row(subject: &Subject, targets: &[Vec<f64>]) -> Vec<String> {
    let start = start(subject);
    let (mut at, mut all) = (start.clone(), Vec::new());
    for to in targets {
        let (found, end) = wrong(subject, &at, to);
        all.extend(found);
        at = end.unwrap_or_else(|| start.clone());
    }
    all
}

/// What is wrong with the first of so many equal steps, by so much in all, after which links are off by more than a millionth.
pub(crate) fn wrong_in_steps(
    subject: &Subject,
    far: f64,
    steps: u32,
    off: impl Fn(&Machine<'_, f64>) -> f64,
) -> Option<String> {
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    (1..=steps).find_map(|step| {
        let to = far * f64::from(step) / f64::from(steps);
        let outcome = machine.move_to(&[to]);
        let off = off(&machine);
        let fails = outcome.is_err() || off > 1e-6;
        fails.then(|| format!("to {far} in {steps} steps: at {to} {outcome:?}, off by {off:.2e}"))
    })
}

/// Tests that nothing wrong was found with a mechanism.
#[track_caller]
pub(crate) fn none(subject: &Subject, found: &[String]) {
    assert!(
        found.is_empty(),
        "{} wrong\n{}\n{}",
        found.len(),
        found[..4.min(found.len())].join("\n"),
        subject.text
    );
}

/// Targets of one motor.
pub(crate) fn values(values: &[f64]) -> Vec<Vec<f64>> {
    values.iter().map(|value| vec![*value]).collect()
}

/// Random targets, each motor by no more than its reach from its start, and within its range.
pub(crate) fn targets(subject: &Subject, seed: u64, count: usize, reach: &[f64]) -> Vec<Vec<f64>> {
    let mut dice = Dice::new(seed);
    let start = &subject.compiled.program.start.motors;
    let mut target = || {
        let part = *dice.pick(&[0.05, 0.3, 1.0]);
        let all = start.iter().zip(reach).zip(&subject.model.motors);
        all.map(|((start, reach), motor)| {
            let to = start + dice.between(-part * reach, part * reach);
            motor
                .range
                .map_or(to, |range| to.clamp(range.low, range.high))
        })
        .collect()
    };
    (0..count).map(|_| target()).collect()
}

#[test]
fn a_dead_zone_behind_a_reduction() {
    let far = values(&[-226.0, 100.0, 226.0, -90.0, 300.0, -300.0, 40.0]);
    for ratio in ["1 : 40", "17 : 40", "1 : 3", "1 : 100"] {
        let subject = Subject::with(include_str!("texts/worm-rocker.txt"), "RATIO", ratio);
        assert_leaps(&subject, &far);
    }
}

#[test]
fn a_dead_zone_behind_a_cam_that_reduces() {
    let far = values(&[-60.0, 25.0, 60.0, 100.0, -100.0, 9.0]);
    for ratio in ["0.1", "0.025", "-0.3", "3"] {
        let subject = Subject::with(include_str!("texts/cam-rocker.txt"), "RATIO", ratio);
        assert_leaps(&subject, &far);
    }
}

#[test]
fn a_rack_of_a_large_or_a_small_pinion() {
    let displacements = [0.5, -0.5, 2.0, -2.0, 4.5, -4.5, 7.0, -7.0, 40.0];
    for radius in ["20", "80", "4", "0.1", "0.01"] {
        let number: f64 = radius.parse().expect("a number");
        let subject = Subject::with(include_str!("texts/rack-rocker.txt"), "RATIO", radius);
        assert_leaps(&subject, &values(&displacements.map(|by| by / number)));
        let subject = Subject::with(include_str!("texts/rack-crank.txt"), "RATIO", radius);
        assert_leaps(&subject, &values(&displacements.map(|by| by * number)));
    }
}

/// The slider of a ring of four unknowns is a rack on the ground, which is its pinion: nothing else is undetermined.
#[test]
fn a_rack_in_a_loop() {
    let text = include_str!("texts/rack1.txt");
    for text in [text.to_owned(), format!("{text} allow coupled;")] {
        let subject = Subject::of(&text);
        assert_leaps(&subject, &targets(&subject, 1, 20, &[30.0]));
    }
}

#[test]
fn a_dead_zone_behind_gears_that_speed_up() {
    let displacements = [
        0.1, -0.3, 1.0, -1.0, 2.0, 3.0, -3.0, 5.0, 7.0, -7.0, 40.0, -100.0,
    ];
    for (ratio, speed) in [
        ("100 : 1", 100.0),
        ("400 : 1", 400.0),
        ("7 : 1", 7.0),
        ("40 : 17", 40.0 / 17.0),
    ] {
        let subject = Subject::with(include_str!("texts/worm-rocker.txt"), "RATIO", ratio);
        assert_leaps(&subject, &values(&displacements.map(|by| by / speed)));
    }
}

/// A four-bar whose crank cannot pass in line with the ground, by less than a hundredth of a radian to both sides.
#[derive(Clone, Copy, Debug)]
struct NarrowZone {
    /// Half of what the crank cannot reach, in radians.
    half: f64,
    /// Whether the crank points at the far pivot in the zone, or away from it.
    inner: bool,
    crank: f64,
    ground: f64,
    /// Where the rocker's length is in what is possible, from 0 to 1.
    part: f64,
    pivot: [f64; 2],
    /// The angle of the ground.
    turned: f64,
    /// The angle from the ground to the crank at the start.
    begin: f64,
}

fn narrow_zones() -> impl Strategy<Value = NarrowZone> {
    let sizes = prop::sample::select(vec![4e-3, 1e-3, 2e-4, 3e-5]);
    (
        (sizes, 0.5..1.0).prop_map(|(size, part)| size * part),
        any::<bool>(),
        (0.5..2.0, 2.5..6.0, 0.0..1.0),
        [-5.0..5.0, -5.0..5.0],
        (-3.0..3.0, 0.5..2.6),
    )
        .prop_map(
            |(half, inner, (crank, ground, part), pivot, (turned, begin))| NarrowZone {
                half,
                inner,
                crank,
                ground,
                part,
                pivot,
                turned,
                begin,
            },
        )
}

impl NarrowZone {
    /// The lengths of coupler and rocker, which just reach from the crank's end to the far pivot at the ends of the zone.
    fn lengths(&self) -> [f64; 2] {
        let (a, d) = (self.crank, self.ground);
        let angle = if self.inner {
            self.half
        } else {
            PI - self.half
        };
        let reach = (a * a + d * d - 2.0 * a * d * angle.cos()).sqrt();
        if self.inner {
            let rocker = (0.7 + 0.5 * self.part) * d;
            [rocker + reach, rocker]
        } else {
            let coupler = (0.35 + 0.3 * self.part) * reach;
            [coupler, reach - coupler]
        }
    }

    fn text(&self) -> String {
        let ([x, y], [coupler, rocker]) = (self.pivot, self.lengths());
        let (sin, cos) = self.turned.sin_cos();
        format!(
            "struct M;
            ground {{ point a = ({x:?}, {y:?}); point d = ({:?}, {:?}); }}
            link crank {{ point a = (0, 0); point b = ({:?}, 0); }}
            link coupler {{ point b = (0, 0); point c = ({coupler:?}, 0); }}
            link rocker {{ point d = (0, 0); point c = ({rocker:?}, 0); }}
            joint a = revolute(ground.a, crank.a);
            joint b = revolute(crank.b, coupler.b);
            joint c = revolute(coupler.c, rocker.c);
            joint d = revolute(ground.d, rocker.d);
            motor a; start {{ a = {:?}; coupler near {:?}; }}",
            x + self.ground * cos,
            y + self.ground * sin,
            self.crank,
            self.turned + self.begin,
            self.turned + 0.4,
        )
    }

    /// The middle of the zone in either direction from the start, and where the crank stops before it.
    fn limits(&self) -> [(f64, f64); 2] {
        let start = self.turned + self.begin;
        let zone = self.turned + if self.inner { TAU } else { PI };
        let high = if start > zone { zone + TAU } else { zone };
        let low = high - TAU;
        [(low, low + self.half), (high, high - self.half)]
    }
}

/// Where it stops is known in closed form.
#[test]
fn a_narrow_dead_zone_is_found() {
    for_all(40, &narrow_zones(), |zone| {
        let subject = Subject::of(&zone.text());
        for (beyond, limit) in zone.limits() {
            for more in [1e-2, 0.3, 1.0, 2.5, 30.0] {
                let to = beyond + (beyond - zone.turned - zone.begin).signum() * more;
                let mut machine = Machine::<f64>::new(&subject.compiled.program);
                let outcome = machine.move_to(&[to]);
                let toward = machine.move_toward(&[to]);
                let at = machine.position().motors[0];
                let stops = outcome.is_err() && !toward.is_ok_and(|stop| stop.is_none());
                assert!(
                    stops && (at - limit).abs() <= 1e-6,
                    "limit {limit}: to {to}: {outcome:?}, it stops at {at}\n{}",
                    subject.text
                );
            }
        }
    });
}

/// A move that begins where one was stopped, at the edge of a dead zone, does not pass it: not even where rounding lets the loop close
/// here and there beside the edge.
#[test]
fn narrow_dead_zones_are_not_passed_from_their_edge() {
    for (text, to) in [
        (include_str!("texts/s1002237.txt"), -21.204_729_507_848_814),
        (include_str!("texts/s1000495.txt"), 0.815_875_395_140_976_1),
    ] {
        assert_leaps(&Subject::of(text), &[vec![to]]);
    }
}

#[test]
fn a_boom_in_polar_coordinates() {
    for text in [
        include_str!("texts/boom.txt"),
        include_str!("texts/polar.txt"),
        include_str!("texts/s5256.txt"),
    ] {
        let subject = Subject::of(text);
        let reach = &[4.0, 30.0, 30.0][..subject.model.motors.len()];
        assert_leaps_in_a_row(&subject, &targets(&subject, 3, 30, reach));
    }
    let subject = Subject::of(include_str!("texts/boom.txt"));
    assert_leaps_in_a_row(&subject, &[vec![0.3, 14.0], vec![2.8, 14.0]]);
}

#[test]
fn drag_links_near_the_change_over_turn_their_wheels_right() {
    let mut found = Vec::new();
    for ratio in ["20 : 40", "1 : 3", "7 : 1", "17 : 40", "40 : 1", "1 : 40"] {
        for long in ["1.003", "1.0001", "1.05", "1.3"] {
            let text = include_str!("texts/drag-link.txt").replace("LONG", long);
            let subject = Subject::with(&text, "RATIO", ratio);
            for step in [0.02, 0.25, 1.0, 3.0, 6.0, 12.0] {
                let at = subject.compiled.program.start.motors[0];
                let goals = values(&[at + step, at + 2.0 * step, at - step]);
                let wrong = wrong_in_a_row(&subject, &goals).into_iter();
                found.extend(wrong.map(|wrong| format!("{ratio}, {long}: {wrong}")));
            }
        }
    }
    assert!(
        found.is_empty(),
        "{} wrong\n{}",
        found.len(),
        found[..4.min(found.len())].join("\n")
    );
}

/// The groove of an arm and a rail: where the arm has turned by half, they are parallel.
#[test]
fn a_groove_that_turns_by_half() {
    assert_leaps(
        &Subject::of(include_str!("texts/tanhalf.txt")),
        &values(&[0.1, 1.5, 3.0, -1.5, 3.1, 3.2, 4.0, -3.0, -2.0, 7.0, 40.0]),
    );
}

/// Tests random leaps in a row: the test's name, the text, the seed and number of the targets, and the reach of each motor.
macro_rules! random_leaps {
    ($($(#[$doc:meta])* $name:ident: $text:literal, $seed:literal, $count:literal, $reach:expr;)*) => {$(
        $(#[$doc])*
        #[test]
        fn $name() {
            let subject = Subject::of(include_str!(concat!("texts/", $text)));
            assert_leaps_in_a_row(&subject, &targets(&subject, $seed, $count, &$reach));
        }
    )*};
}

random_leaps! {
    coupled_s1008: "s1008.txt", 8, 15, [5.0];
    coupled_s1022: "s1022.txt", 8, 15, [5.0, 5.0];
    coupled_s25: "s25.txt", 8, 15, [5.0];
    coupled_with_a_gear_order_a: "order-a.txt", 8, 15, [5.0];
    /// One Newton step a move promises no long moves: none of more than its declared step.
    one_newton_step_by_small_moves_s2050: "s2050.txt", 8, 40, [0.3];
    found_once_s5180: "s5180.txt", 4, 3, [4.0, 4.0, 4.0];
    found_once_s1100: "s1100.txt", 4, 15, [0.05, 20.0];
    found_once_kite: "kite.txt", 4, 15, [4.0, 4.0];
    found_once_t3: "t3.txt", 4, 15, [10.0];
    found_once_drag: "drag.txt", 4, 15, [20.0];
}
