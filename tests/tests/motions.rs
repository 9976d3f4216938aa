//! Motions in segments: against the segments one after the other, and rates against differences.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Effects, Law};
use mech_compiler::program::build_timing;
use mech_core::MotionLaw;
use mech_test_support::{Dice, differences, model, model_of_law, seeds};
use std::f64::consts::TAU;
use std::fmt::Write;

mod generated {
    include!(concat!(env!("OUT_DIR"), "/motions.rs"));
}

/// How long a segment takes, how far it goes, and how.
type Segment = (f64, f64, MotionLaw);

/// How far all segments have gone at a time.
fn gone(segments: &[Segment], time: f64) -> f64 {
    let (mut sum, mut begin) = (0.0, 0.0);
    for (span, height, law) in segments {
        let share = ((time - begin) / span).clamp(0.0, 1.0);
        sum += height * law.at(0, share);
        begin += span;
    }
    sum
}

/// The same if they begin anew after a period.
fn gone_round(segments: &[Segment], period: f64, time: f64) -> f64 {
    let all: f64 = segments.iter().map(|(_, height, _)| height).sum();
    let rounds = (time / period).floor();
    rounds * all + gone(segments, time - rounds * period)
}

/// Random segments, and their text: those of a shaft take a turn together.
fn random(dice: &mut Dice, turn: bool) -> (Vec<Segment>, String) {
    let count = 2 + dice.below(5);
    let mut spans: Vec<f64> = (0..=count).map(|_| dice.between(0.2, 1.0)).collect();
    if turn {
        let sum: f64 = spans.iter().sum();
        for span in &mut spans {
            *span *= TAU / sum;
        }
    }
    let (mut segments, mut text, mut sum) = (Vec::new(), String::new(), 0.0);
    for (number, span) in spans.iter().enumerate() {
        let law = *dice.pick(&MotionLaw::ALL[1..]);
        let name = law.name();
        let height = dice.between(0.1, 1.0);
        let is_last = number == spans.len() - 1;
        let _ = match dice.below(4) {
            _ if is_last && sum != 0.0 => {
                segments.push((*span, -sum, law));
                write!(text, "return over {span} with {name}")
            }
            0 | 1 => {
                sum += height;
                segments.push((*span, height, law));
                write!(text, "rise {height} over {span} with {name}, ")
            }
            2 if number > 0 => {
                sum -= height;
                segments.push((*span, -height, law));
                write!(text, "fall {height} over {span} with {name}, ")
            }
            _ => {
                segments.push((*span, 0.0, law));
                write!(text, "dwell {span}{}", if is_last { "" } else { ", " })
            }
        };
    }
    (segments, text.trim_end_matches(", ").to_owned())
}

fn law_of(text: &str) -> Law {
    let laws = model_of_law(text).laws;
    laws.into_iter().next().expect("a law")
}

#[test]
fn motions_are_their_segments_one_after_the_other() {
    for seed in seeds(300) {
        let mut dice = Dice::new(seed);
        let (segments, text) = random(&mut dice, false);
        let period: f64 = segments.iter().map(|(span, ..)| span).sum();
        let (once, round) = (law_of(&text), law_of(&format!("{text}, repeat")));
        let from = law_of(&format!("from -0.5, {text}"));
        for _ in 0..40 {
            let time = dice.between(-2.0, 3.0) * period;
            let expected = gone(&segments, time);
            assert!((once.at(time, &[]) - expected).abs() < 1e-13, "{text} at {time}");
            assert!((from.at(time, &[]) + 0.5 - expected).abs() < 1e-13, "{text} at {time}");
            let expected = gone_round(&segments, period, time);
            assert!((round.at(time, &[]) - expected).abs() < 1e-12, "{text} at {time}");
        }
    }
}

#[test]
fn rates_of_motions_are_their_slopes() {
    const STEP: f64 = 1e-4;
    let effects = Effects { velocity: true, acceleration: true, ..Effects::default() };
    for seed in seeds(100) {
        let mut dice = Dice::new(seed);
        let (segments, text) = random(&mut dice, false);
        let mut model = model_of_law(&format!("{text}, repeat"));
        model.effects = effects;
        let timing = build_timing(&model).expect("a law");
        let period: f64 = segments.iter().map(|(span, ..)| span).sum();
        for _ in 0..20 {
            let time = dice.between(-1.0, 2.0) * period;
            // Nowhere near a place where an acceleration may jump.
            let (mut begin, mut ends) = (0.0, vec![0.0]);
            for (span, _, law) in &segments {
                let changes: Vec<f64> = law.changes().collect();
                let mirrored = changes.iter().map(|change| 1.0 - change);
                ends.extend(
                    changes.iter().copied().chain(mirrored).map(|change| begin + change * span),
                );
                begin += span;
                ends.push(begin);
            }
            let within = time.rem_euclid(period);
            if ends.iter().any(|end| (within - end).abs() < 4.0 * STEP) {
                continue;
            }
            let at = |number: f64| gone_round(&segments, period, time + number * STEP);
            let [first, second] = differences([-2.0, -1.0, 0.0, 1.0, 2.0].map(at), STEP);
            let [_, rate, acceleration] = timing.at(time, &[])[0];
            assert!((rate - first).abs() < 1e-8, "{text} at {time}: {rate} {first}");
            assert!(
                (acceleration - second).abs() < 1e-4,
                "{text} at {time}: {acceleration} {second}"
            );
        }
    }
}

/// Cams by random segments of a turn: the follower is where they have it, whichever way the shaft turns, and is back after each turn.
#[test]
fn cams_by_segments_have_their_followers_where_they_say() {
    for seed in seeds(60) {
        let mut dice = Dice::new(seed);
        let (segments, mut text) = random(&mut dice, true);
        if dice.once_in(2) {
            text += ", repeat";
        }
        let text = format!(
            "struct M; link disk; link lever; joint s = revolute(ground, disk) at (0, 0);
            joint f = prismatic(ground, lever) at (3, 0) along (0, 1); joint c = cam(s, f, {text}); motor s;"
        );
        let model = model(&text);
        assert_eq!(model.laws[0].winding(), Some(0.0), "{text}");
        let compiled = mech_compiler::compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}"));
        let mut machine = Machine::<f64>::new(&compiled.program);
        for _ in 0..20 {
            let angle = dice.between(-20.0, 20.0);
            machine.move_to(&[angle]).expect("it moves");
            let poses = &machine.position().poses;
            let found = poses[compiled
                .program
                .place_of(model.ends(mech_compiler::model::JointId::new(1)).1)
                .expect("shown")][3];
            let expected = gone_round(&segments, TAU, angle);
            assert!((found - expected).abs() < 1e-12, "{text} at {angle}: {found} {expected}");
        }
    }
}

#[test]
fn generated_cams_are_where_their_segments_have_them() {
    let degrees = |list: &[(f64, f64, MotionLaw)]| -> Vec<Segment> {
        let segments = list.iter().copied();
        segments.map(|(span, height, law)| (span.to_radians(), height, law)).collect()
    };
    let mut press = generated::Press::new();
    for lift in [9.0, 4.5] {
        press.set_lift(lift).expect("it may be changed");
        let valve = degrees(&[
            (90.0, lift, MotionLaw::ModifiedSine),
            (30.0, 0.0, MotionLaw::Linear),
            (50.0, -lift / 3.0, MotionLaw::Polynomial4567),
            (100.0, -lift * 2.0 / 3.0, MotionLaw::ModifiedTrapezoid),
        ]);
        let lever = degrees(&[
            (60.0, 20_f64.to_radians(), MotionLaw::Cycloidal),
            (20.0, 0.0, MotionLaw::Linear),
            (100.0, -20_f64.to_radians(), MotionLaw::Harmonic),
        ]);
        for step in -300..300 {
            // At no end of a segment.
            let angle = 0.05 * f64::from(step) + 0.013;
            press.move_with([angle], [1.5], [0.7]).expect("it moves");
            let at = |angle: f64| 2.0 + gone_round(&valve, TAU, angle);
            assert!((press.h() - at(angle)).abs() < 1e-12, "{angle}");
            let [first, _] = around(at, angle);
            assert!((press.h_rate() - 1.5 * first).abs() < 1e-6, "{angle}");
            // The gear turns the wheel backwards at half the speed; mirrored, it and the lever count the other way round.
            let at = |angle: f64| -gone_round(&lever, TAU / 2.0, angle / 2.0);
            let found = press.left().swing();
            assert!((found - at(angle)).abs() < 1e-12, "{angle}: {found} {}", at(angle));
            let [first, _] = around(at, angle);
            assert!((press.left().swing_rate() - 1.5 * first).abs() < 1e-6, "{angle}");
        }
    }
}

/// First and second differences of a function round a place.
fn around(at: impl Fn(f64) -> f64, place: f64) -> [f64; 2] {
    const STEP: f64 = 1e-4;
    differences([-2.0, -1.0, 0.0, 1.0, 2.0].map(|number| at(place + number * STEP)), STEP)
}

#[test]
fn a_motor_goes_on_by_a_step_in_each_round() {
    let segments =
        [(0.4, 60_f64.to_radians(), MotionLaw::Cycloidal), (0.1, 0.0, MotionLaw::Linear)];
    let mut table = generated::Indexing::new();
    for step in 0..400 {
        let time = 0.011 * f64::from(step);
        table.at_time(time).expect("it moves");
        let expected = 15_f64.to_radians() + gone_round(&segments, 0.5, time);
        assert!((f64::from(table.a()) - expected).abs() < 3e-6, "{time}");
        let within = time.rem_euclid(0.5);
        let rate = if within < 0.4 {
            60_f64.to_radians() / 0.4 * (1.0 - (TAU * within / 0.4).cos())
        } else {
            0.0
        };
        assert!((f64::from(table.a_rate()) - rate).abs() < 1e-5, "{time}");
    }
}

#[test]
fn motions_come_back_whatever_their_heights_are() {
    for heights in [
        "rise 0.1 over 1, rise 0.2 over 1, fall 0.3 over 1, dwell",
        "rise p over 1, rise 2 * p + 1 over 1, return over 1, dwell",
        "from p, rise p * p over 1, fall p * p over 2, dwell",
    ] {
        let text = format!(
            "struct M; param p = 1.5; link disk; link lever; joint s = revolute(ground, disk) at (0, 0);
            joint f = prismatic(ground, lever) at (0, 3) along (0, 1);
            joint c = cam(s, f, {heights}); motor s;"
        );
        let law = model(&text).laws.swap_remove(0);
        assert_eq!(law.winding(), Some(0.0), "{heights}");
        for p in [1.5, 0.7] {
            for turns in [-3.0, 1.0, 8.0] {
                let off = law.at(1.3 + turns * TAU, &[p]) - law.at(1.3, &[p]);
                assert!(off.abs() < 1e-13, "{heights}: {off:e}");
            }
        }
    }
    // One that goes on with its param is another in each turn.
    let screw = "struct M; param p = 1.5; link disk; link lever; joint s = revolute(ground, disk) at (0, 0);
        joint f = prismatic(ground, lever) at (0, 3) along (0, 1); joint c = cam(s, f, p * q); motor s;";
    assert_eq!(model(screw).laws[0].winding(), None);
}

/// A cam that a stranger wrote with minima, maxima and remainders, for want of segments.
#[test]
fn segments_are_what_a_stranger_spelt_out() {
    let law = |law: &str| {
        let text = format!(
            "struct M; const beta = 120 deg; link disk; link lever; joint s = revolute(ground, disk) at (0, 0);
            joint f = prismatic(ground, lever) at (0, 3) along (0, 1); joint c = cam(s, f, {law}); motor s;"
        );
        model(&text).laws.swap_remove(0)
    };
    let spelt_out = law("min(mod(q, 2 * PI), beta) / beta - sin(2 * PI * min(mod(q, 2 * PI), beta) / beta) / (2 * PI)
        - max(0, min(mod(q, 2 * PI) - 180 deg, beta)) / beta
        + sin(2 * PI * max(0, min(mod(q, 2 * PI) - 180 deg, beta)) / beta) / (2 * PI)");
    let said = law("rise 1 over beta, dwell 60 deg, return over beta, dwell");
    for step in -500..500 {
        let angle = 0.0217 * f64::from(step);
        let [found, expected] = [&said, &spelt_out].map(|law| law.at(angle, &[]));
        assert!((found - expected).abs() < 1e-14, "{angle}: {found} {expected}");
    }
}
