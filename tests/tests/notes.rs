//! Notes about loops that come near change points, against the closed form of a four-bar: where the two links at its driven joint lie in one
//! line, their ends are as far apart as the sum or the difference of their lengths; those of the other two may be a little more or less.

use mech_compiler::compile;
use mech_compiler::model::{JointKind, Model};
use mech_test_support::sketch::{Bond, Sketch};
use mech_test_support::{Dice, cases, known, model, seeds, with_own_params};
use std::f64::consts::{PI, TAU};

/// What is farther from a change point, as a part of the loop's size, is not told.
const NEAR: f64 = 5e-4;

type Point = [f64; 2];

fn distance([a, b]: Point, [c, d]: Point) -> f64 {
    (a - c).hypot(b - d)
}

/// A four-bar that is driven at the first of its pins and comes near a change point, or passes it.
struct FourBar {
    /// In the order of the ring.
    pins: [Point; 4],
    folded: bool,
}

impl FourBar {
    /// The lengths at the driven joint may differ from what they must be by `off`.
    fn new(dice: &mut Dice, off: f64) -> Self {
        loop {
            let [p, r, s] = [0; 3].map(|_| 0.25 * dice.between(2.0, 14.0).round());
            let folded = dice.once_in(2);
            let q = if folded { p + (r - s).abs() + off } else { r + s - p + off };
            let (turn, angle) = (dice.between(-PI, PI), dice.between(0.5, 2.6));
            let at = |length: f64, angle: f64| [length * angle.cos(), length * angle.sin()];
            let (a, b) = (at(p, turn), at(q, turn + angle));
            let d = distance(a, b);
            let along = (d * d + r * r - s * s) / (2.0 * d);
            let height = (r * r - along * along).sqrt();
            if q > 0.3 && height > 0.3 {
                let [x, y] = [(b[0] - a[0]) / d, (b[1] - a[1]) / d];
                let side = if dice.once_in(2) { height } else { -height };
                let c = [a[0] + along * x - side * y, a[1] + along * y + side * x];
                return Self { pins: [[0.0, 0.0], a, c, b], folded };
            }
        }
    }

    /// Anywhere, in any order, any link being the ground.
    fn text(&mut self, dice: &mut Dice) -> String {
        let mut sketch = Sketch { links: 4, ..Sketch::default() };
        for (number, pin) in self.pins.into_iter().enumerate() {
            sketch.join((number + 3) % 4, number, Bond::Pin(pin));
        }
        sketch.motors = vec![0];
        sketch.ground = dice.below(4);
        sketch.place(dice, false);
        for (pin, (_, _, bond)) in self.pins.iter_mut().zip(&sketch.joints) {
            if let Bond::Pin(at) = bond {
                *pin = *at;
            }
        }
        sketch.text(dice)
    }

    /// By how much the ends of the links at the driven joint are too far apart in line, as a part of the loop's size: folded or not. And the
    /// same of the squares of their distances: that is what rounding hides.
    fn gap(&self, folded: bool) -> [f64; 2] {
        let [o, a, c, b] = self.pins;
        let [p, q, r, s] = [distance(o, a), distance(o, b), distance(a, c), distance(c, b)];
        let (ends, arms) = if folded { ((p - q).abs(), (r - s).abs()) } else { (p + q, r + s) };
        let size = distance(a, b) + r + s;
        let gap = (ends - arms) / size;
        [gap, gap * (ends + arms) / size]
    }

    /// The motor's value there.
    fn place(&self, model: &Model) -> f64 {
        let [o, a, _, b] = self.pins;
        let heading = |[x, y]: Point| (y - o[1]).atan2(x - o[0]);
        // The motor's joint may be declared from either link to the other.
        let JointKind::Revolute(first, _) = model.joint(model.motors[0].joint).kind else {
            panic!("a pin is driven");
        };
        let name = &model.link(model.axis(first).link).name;
        let is_ground = model.link_ids().all(|id| model.link(id).name != "l0");
        let angle = heading(a) - heading(b);
        let straight = if self.folded { 0.0 } else { PI };
        if name == if is_ground { "ground" } else { "l0" } {
            straight + angle
        } else {
            straight - angle
        }
    }
}

#[test]
fn four_bars_near_change_points_are_told_how_near_and_where() {
    let mut told = [0; 2];
    for seed in seeds(cases(300)) {
        let mut dice = Dice::new(seed);
        let off = 10_f64.powf(dice.between(-10.0, -1.5)) * *dice.pick(&[1.0, -1.0, 0.0]);
        let mut bar = FourBar::new(&mut dice, off);
        let text = bar.text(&mut dice);
        let model = model(&text);
        let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
        let [gap, square] = bar.gap(bar.folded);
        let [other, other_square] = bar.gap(!bar.folded);
        if other_square.abs() > 1e-15 && other.abs() < 2.0 * NEAR {
            // It comes near in two places.
            continue;
        }
        let at = bar.place(&model);
        let misses = &compiled.near_misses;
        assert_eq!(misses.len(), compiled.notes.len());
        if square.abs() > 1e-15 && square.abs() < 1e-12 {
            // So little may be rounding or not.
            continue;
        }
        if square.abs() < 1e-15 || gap.abs() > 1.001 * NEAR {
            assert!(misses.is_empty(), "off by {gap:e}: {misses:?}\n{text}");
            continue;
        }
        if gap.abs() > 0.999 * NEAR {
            continue;
        }
        let [miss] = &misses[..] else {
            panic!("off by {gap:e}: {misses:?}\n{text}");
        };
        let closes = (gap < 0.0) != bar.folded;
        assert_eq!(miss.passes, closes, "off by {gap:e}: {miss:?}\n{text}");
        assert!(
            (miss.distance - gap.abs()).abs() < 1e-3 * gap.abs() + 1e-14,
            "off by {gap:e}: {miss:?}\n{text}"
        );
        let turned = (miss.at - at) / TAU;
        let turned = turned - turned.round();
        assert!(turned.abs() < 1e-4, "at {at}: {miss:?}\n{text}");
        told[usize::from(miss.passes)] += 1;
    }
    println!("{told:?}");
    assert!(told[0].min(told[1]) > 20, "{told:?}");
}

#[test]
fn decimals_hide_the_change_points_of_roberts() {
    for decimals in 2..=10 {
        let height = format!("{:.decimals$}", 8_f64.sqrt());
        let text = format!(
            "struct Roberts;
            link left; link right; link plate {{ point p = (2, 0); }}
            joint a = revolute(ground, left) at (0, 0);
            joint c = revolute(left, plate) at (1, {height});
            joint d = revolute(plate, right) at (3, {height});
            joint b = revolute(ground, right) at (4, 0);
            motor a;"
        );
        let compiled = compile(&model(&text)).expect("it moves");
        let [miss] = &compiled.near_misses[..] else {
            panic!("{decimals} decimals: {:?}", compiled.near_misses);
        };
        let height: f64 = height.parse().expect("a number");
        let leg = height.hypot(1.0);
        // The ends of ground and leg are as far apart as those of plate and leg are near.
        let goal = height.hypot(3.0);
        let off = (2.0 * leg - 6.0) / (goal + 2.0 + leg);
        assert!((miss.distance - off.abs()).abs() < 1e-4 * off.abs() + 1e-14, "{miss:?}, {off:e}");
        assert!((miss.at + height.atan()).abs() < 1e-3, "{miss:?}");
        if decimals == 10 {
            let note = &compiled.notes[0];
            let told =
                "the loop `b`, `d`, `c` passes within 1e-11 of a change point at a = -70.53 deg";
            assert_eq!(note, told);
            assert!(compiled.report.contains(note), "{}", compiled.report);
        }
    }
}

#[test]
fn ordinary_mechanisms_come_near_no_change_point() {
    for model in known().into_iter().chain(with_own_params()) {
        if let Ok(compiled) = compile(&model) {
            let (name, misses) = (&model.name, &compiled.near_misses);
            assert!(misses.is_empty(), "{name}: {misses:?}");
        }
    }
}

/// What is noted of a motor that follows a law, and of a cam between a shaft and a slide.
fn notes_of_laws(time: &str, cam: &str) -> Vec<String> {
    let text = format!(
        "struct M; link disk; link lever; link table; joint s = revolute(ground, disk) at (0, 0);
        joint f = prismatic(ground, lever) at (3, 0) along (0, 1); joint c = cam(s, f, {cam}); motor s;
        joint a = revolute(ground, table) at (9, 0); motor a = {time};"
    );
    compile(&model(&text)).expect("it moves").notes
}

#[test]
fn laws_that_jump_are_told() {
    let none = "sin(q)";
    for (law, told) in [
        ("max(0, t - 1)", "the rate of `a` jumps at t = 1, from 0 to 1"),
        ("abs(t - 20) - 20", "the rate of `a` jumps at t = 20, from -1 to 1"),
        ("floor(t)", "`a` jumps at t = 1, from 0 to 1"),
        ("mod(3 * t, 6)", "`a` jumps at t = 2, from 6 to 0"),
        ("rise 2 over 0.5 with linear", "the rate of `a` jumps at t = 0.5, from 4 to 0"),
        ("t + max(0, t - 0.002)", "the rate of `a` jumps at t = 0.002, from 1 to 2"),
    ] {
        let expected = format!("by its law {told}: nothing that has mass can follow");
        assert_eq!(notes_of_laws(law, none), [expected], "{law}");
    }
    for (law, told) in [
        (
            "max(0, sin(q))",
            "the rate of `f` jumps at q = 0 deg, from 0 to 1 for each radian of `s`",
        ),
        (
            "dwell 90 deg, rise 2 over 1, return over 2 with linear, dwell",
            "the rate of `f` jumps at q = 147.3 deg, from 0 to -1 for each radian of `s`",
        ),
    ] {
        let expected = format!("by cam `c` {told}: nothing that has mass can follow");
        assert_eq!(notes_of_laws("t", law), [expected], "{law}");
    }
}

#[test]
fn laws_whose_rates_are_continuous_are_not_told() {
    for time in [
        "sin(20 * t)",
        "max(0, t - 1) * max(0, t - 1)",
        "exp(t) - 1",
        "rise 2 over 0.5, dwell 0.1, return over 0.01, repeat",
        "rise 2 over 0.5 with parabolic",
        "min(0, abs(t))",
        "mod(t, 1) * (1 - mod(t, 1)) * mod(t, 1) * (1 - mod(t, 1))",
    ] {
        let cam = "max(0, sin(q)) * max(0, sin(q)) + 0.1 * sin(9 * q)";
        assert_eq!(notes_of_laws(time, cam), Vec::<String>::new(), "{time}");
    }
}
