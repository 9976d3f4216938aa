//! Whether the judge itself is right: closed forms of mechanisms that have them, through change points and up to dead points.

use mech_compiler::model::LinkId;
use mech_test_support::Dice;
use mech_test_support::journeys::Subject;
use mech_test_support::judge::{Curve, End, Place};
use mech_test_support::sketch::{Bond, Sketch};
use std::f64::consts::{PI, TAU};

/// A ring of four links between these bonds, drawn anywhere in any order, with a ground and a driven joint.
fn ring(bonds: [Bond; 4], ground: usize, motor: usize, dice: &mut Dice) -> Subject {
    let mut sketch = Sketch { links: 4, ground, motors: vec![motor], ..Sketch::default() };
    for (number, bond) in bonds.into_iter().enumerate() {
        sketch.join(number, (number + 1) % 4, bond);
    }
    let exact = dice.once_in(2);
    sketch.place(dice, exact);
    Subject::of(&sketch.text(dice))
}

/// The angle of one link of a sketch relative to another.
fn turned(subject: &Subject, place: &Place, links: [usize; 2], ground: usize) -> f64 {
    let angle = |link: usize| {
        let named = |id: &LinkId| subject.model.link(*id).name == format!("l{link}");
        let id = subject.model.declared_links().find(named);
        if link == ground { 0.0 } else { place.angle(id.expect("a link")) }
    };
    angle(links[1]) - angle(links[0])
}

/// Follows the one motor to both sides and looks at many places of its curve. Of two ways in which it may be mirrored one is right.
fn every_place(subject: &Subject, far: f64, off: impl Fn(&Place, f64) -> [f64; 2]) {
    let judge = subject.judge();
    let start = subject.compiled.program.start.motors[0];
    let mut worst = [0.0_f64; 2];
    for by in [far, -far] {
        let curve = Curve::new(&judge, &judge.start(), [&[start], &[start + by]]);
        assert_eq!(curve.end, End::Arrives, "{}", subject.text);
        for part in 0..=200 {
            let part = f64::from(part) / 200.0;
            let (place, condition) = curve.at(part).expect("on the curve");
            let off = off(&place, part * by);
            worst = [0, 1].map(|way| worst[way].max(off[way].abs() / condition));
        }
    }
    assert!(worst[0].min(worst[1]) < 1e-9, "off by {worst:?}\n{}", subject.text);
}

/// Opposite links of a parallelogram, or a rhombus, stay parallel, whoever is ground and whatever is driven.
#[test]
fn parallelograms() {
    let mut dice = Dice::new(1);
    for case in 0..16 {
        let (u, v) = ([if case < 8 { 2.0 } else { 1.5 }, 0.5], [0.5, 1.5]);
        let pins = [[0.0, 0.0], u, [u[0] + v[0], u[1] + v[1]], v].map(Bond::Pin);
        let (ground, motor) = (case % 4, dice.below(4));
        let subject = ring(pins, ground, motor, &mut dice);
        every_place(&subject, 12.0, |place, by| {
            let across = [[0, 2], [1, 3]].map(|pair| turned(&subject, place, pair, ground).abs());
            let own = turned(&subject, place, [motor, (motor + 1) % 4], ground).abs() - by.abs();
            [across[0].max(across[1]).max(own.abs()); 2]
        });
    }
}

/// A kite driven at the tip between its short sides: half of the angle at the other tip is the arc sine of a part of the sine of half of
/// the angle at this one, through the places where the pins between meet.
#[test]
fn kites() {
    let mut dice = Dice::new(2);
    for ground in 0..4 {
        let (a, b, c) = (0.75, 1.25, 2.5);
        let pins = [[-a, 0.0], [0.0, b], [c, 0.0], [0.0, -b]].map(Bond::Pin);
        let subject = ring(pins, ground, 0, &mut dice);
        let (short, long) = (f64::hypot(a, b), f64::hypot(c, b));
        let begin = [b.atan2(a), b.atan2(c)];
        every_place(&subject, 9.0, |place, by| {
            let own = turned(&subject, place, [0, 1], ground);
            let other = turned(&subject, place, [2, 3], ground);
            [1.0, -1.0].map(|way: f64| {
                let half = (short / long * (begin[0] + way * own / 2.0).sin()).asin() - begin[1];
                (way * half - other / 2.0).abs().max((own.abs() - by.abs()).abs())
            })
        });
    }
}

/// The rod of a slider-crank whose crank is as long turns back as far as the crank turns: through the place where the pins meet.
#[test]
fn isosceles_slider_cranks() {
    let mut dice = Dice::new(3);
    for ground in 0..4 {
        let bonds = [
            Bond::Pin([0.0, 0.0]),
            Bond::Pin([1.0, 2.0]),
            Bond::Pin([2.0, 0.0]),
            Bond::Slide([2.0, 0.0], [1.0, 0.0]),
        ];
        for motor in 0..3 {
            let subject = ring(bonds, ground, motor, &mut dice);
            every_place(&subject, 7.0, |place, _| {
                let crank = turned(&subject, place, [0, 1], ground);
                let rod = turned(&subject, place, [3, 2], ground);
                [crank + rod; 2]
            });
        }
    }
}

/// A crank that cannot go round stops where coupler and rocker are in line, by the law of cosines.
#[test]
fn four_bars_stop_where_two_links_are_in_line() {
    let mut dice = Dice::new(4);
    for _ in 0..20 {
        let (crank, apart) = (dice.between(1.0, 2.0), dice.between(2.5, 4.0));
        let begin = dice.between(0.4, 1.2);
        let pin = [crank * begin.cos(), crank * begin.sin()];
        // The rocker's end is on one side of the line from the crank's to its pivot.
        let top = [dice.between(0.2, 1.0) + 1.5, 1.2 + dice.between(0.2, 0.6)];
        let coupler = f64::hypot(top[0] - pin[0], top[1] - pin[1]);
        let rocker = f64::hypot(top[0] - apart, top[1]);
        let cosine =
            |reach: f64| (crank * crank + apart * apart - reach * reach) / (2.0 * crank * apart);
        let stretched = cosine(coupler + rocker);
        let folded = cosine((coupler - rocker).abs());
        let subject = ring([[0.0, 0.0], pin, top, [apart, 0.0]].map(Bond::Pin), 0, 0, &mut dice);
        let judge = subject.judge();
        let start = subject.compiled.program.start.motors[0];
        let mut found: Vec<f64> = [PI, -PI]
            .into_iter()
            .filter_map(|by| {
                let curve = Curve::new(&judge, &judge.start(), [&[start], &[start + by]]);
                if let End::Stops(part) = curve.end { Some(part * PI) } else { None }
            })
            .collect();
        let limit = |cosine: f64| (cosine.abs() < 1.0).then(|| cosine.acos());
        // Outwards it stops stretched, inwards folded or, through the line of ground, stretched on the other side.
        let outwards = limit(stretched)
            .or_else(|| limit(folded).map(|angle| TAU - angle))
            .map(|angle| angle - begin);
        let inwards = limit(folded)
            .map(|angle| begin - angle)
            .or_else(|| limit(stretched).map(|angle| begin + angle));
        let mut truth: Vec<f64> =
            [outwards, inwards].into_iter().flatten().filter(|angle| *angle < PI).collect();
        found.sort_by(f64::total_cmp);
        truth.sort_by(f64::total_cmp);
        assert_eq!(found.len(), truth.len(), "{found:?} {truth:?}\n{}", subject.text);
        for (found, truth) in found.iter().zip(&truth) {
            assert!((found - truth).abs() < 1e-9, "{found} {truth}\n{}", subject.text);
        }
    }
}

/// An antiparallelogram stays its own mirror image: its short links turn by as much together as one long link does by the other.
#[test]
fn antiparallelograms() {
    let mut dice = Dice::new(5);
    let (a, b, h) = (1.0, 2.0, 1.5);
    let pins = [[-a, 0.0], [b, h], [a, 0.0], [-b, h]].map(Bond::Pin);
    let ground = 3;
    for motor in 0..4 {
        let subject = ring(pins, ground, motor, &mut dice);
        every_place(&subject, 2.0, |place, _| {
            let [x, y] = [[3, 0], [3, 2]].map(|pair| turned(&subject, place, pair, ground));
            let one = turned(&subject, place, [3, 1], ground);
            [x + y - one; 2]
        });
    }
}
