//! What is expected of mechanisms whose motors follow laws that change their rates: against closed forms of these laws, of cranks and of
//! slider-cranks, and differences of them.

use super::courses::Slider;
use super::efforts::{Masses, places, slopes};
use super::requirements::{judged, troubles};
use mech_compiler::structure::RequirementTrouble;
use mech_test_support::{Dice, cases, differences, dot, seeds, shuffle};
use std::f64::consts::{PI, TAU};

/// Limits are this part of the greatest value away from an extreme.
const MARGIN: f64 = 1e-3;
/// So many places of each piece of a law are looked at, and differences are taken over this part of it.
const PLACES: u32 = 2000;
const STEP: f64 = 1e-4;

/// A law of the time, and where its formula changes.
struct Law {
    text: String,
    at: Box<dyn Fn(f64) -> f64>,
    /// Ascending times: in the pieces between them it is smooth.
    pieces: Vec<f64>,
}

impl Law {
    /// Its value and two rates at some times, and close beside all places where its formula changes.
    fn samples(&self) -> Vec<(f64, [f64; 3])> {
        let pieces = self.pieces.windows(2).flat_map(|ends| {
            let step = STEP * (ends[1] - ends[0]);
            let from = 2.0 * step;
            let way = ends[1] - ends[0] - 2.0 * from;
            (0..=PLACES).map(move |place| {
                let time = ends[0] + from + way * f64::from(place) / f64::from(PLACES);
                (time, step)
            })
        });
        let values = pieces.map(|(time, step)| {
            let around = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| (self.at)(time + steps * step));
            let [rate, second] = differences(around, step);
            (time, [around[2], rate, second])
        });
        values.collect()
    }

    /// A motion that goes to several places and back, over and over again, or farther and farther.
    fn motion(dice: &mut Dice) -> Self {
        let (mut words, mut segments) = (Vec::new(), Vec::new());
        let mut height = 0.0;
        for _ in 0..=dice.below(3) {
            let (span, rise) = (dice.between(0.2, 1.5), dice.between(0.3, 2.0));
            let (word, shape) = *dice.pick(&SHAPES);
            let is_down = dice.once_in(3);
            let verb = if is_down { "fall" } else { "rise" };
            words.push(format!("{verb} {rise} over {span} with {word}"));
            let rise = if is_down { -rise } else { rise };
            segments.push((span, rise, shape));
            height += rise;
            if JUMPING.contains(&word) || dice.once_in(2) {
                let rest = dice.between(0.05, 0.5);
                words.push(format!("dwell {rest}"));
                segments.push((rest, 0.0, rests as Shape));
            }
        }
        let (span, (word, shape)) = (dice.between(0.3, 1.5), *dice.pick(&SHAPES));
        words.push(format!("return over {span} with {word}, dwell 0.1, repeat"));
        segments.push((span, -height, shape));
        segments.push((0.1, 0.0, rests as Shape));
        let mut pieces = vec![0.0];
        for (span, ..) in &segments {
            let begin = pieces[pieces.len() - 1];
            pieces.extend([begin + 0.5 * span, begin + span]);
        }
        let at = move |time: f64| {
            let mut left = time.rem_euclid(segments.iter().map(|(span, ..)| span).sum());
            let mut height = 0.0;
            for (span, rise, shape) in &segments {
                if left <= *span {
                    return height + rise * shape(left / span);
                }
                left -= span;
                height += rise;
            }
            height
        };
        Self { text: words.join(", "), at: Box::new(at), pieces }
    }

    /// A turn that is now faster, now slower.
    fn uneven(dice: &mut Dice) -> Self {
        let speed = dice.between(1.0, 9.0) * if dice.once_in(2) { -1.0 } else { 1.0 };
        let (from, size, phase) =
            (dice.between(-PI, PI), dice.between(0.1, 0.8), dice.between(-PI, PI));
        let times = f64::from(*dice.pick(&[1_u8, 2, 3]));
        let quick = times * speed;
        Self {
            text: format!("{from} + {speed} * t + {size} * sin({quick} * t + {phase})"),
            at: Box::new(move |time| from + speed * time + size * (quick * time + phase).sin()),
            pieces: vec![0.0, TAU / speed.abs()],
        }
    }
}

/// The part of a way after a part of the time.
type Shape = fn(f64) -> f64;

/// Those whose acceleration jumps at both ends. Where two of them meet, bounds are those of both together.
const JUMPING: [&str; 2] = ["parabolic", "harmonic"];

/// The motion laws that have a short closed form, and no velocity at their ends.
const SHAPES: [(&str, Shape); 5] = [
    ("parabolic", |time| {
        if time < 0.5 { 2.0 * time * time } else { 1.0 - 2.0 * (1.0 - time) * (1.0 - time) }
    }),
    ("harmonic", |time| 0.5 - 0.5 * (PI * time).cos()),
    ("cycloidal", |time| time - (TAU * time).sin() / TAU),
    ("polynomial_345", |time| time.powi(3) * (10.0 - 15.0 * time + 6.0 * time * time)),
    ("polynomial_4567", |time| {
        time.powi(4) * (35.0 - 84.0 * time + 70.0 * time.powi(2) - 20.0 * time.powi(3))
    }),
];

fn rests(_: f64) -> f64 {
    0.0
}

/// Asks for limits of a subject beside its extremes in the samples of a law, on both sides of each. Where one is refused, the law and the
/// value at the time that is told break it.
fn is_decided(text: &str, law: &Law, (subject, when): (&str, &str), of: impl Fn([f64; 3]) -> f64) {
    let samples = law.samples();
    let values: Vec<f64> = samples.iter().map(|(_, motion)| of(*motion)).collect();
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let size = greatest.abs().max(least.abs());
    let slack = MARGIN * size;
    let body = text.parse().expect("tokens");
    for (sign, limit, holds) in [
        ("<", greatest + slack, true),
        ("<", greatest - slack, false),
        (">", least - slack, true),
        (">", least + slack, false),
    ] {
        let expect = format!("expect {subject} {sign} {limit} {when};");
        let found = troubles(&judged(&body, &expect));
        let told = || format!("{expect} {least} to {greatest}: {text}");
        match &found[..] {
            [] => assert!(holds, "falsely proved: {}", told()),
            [RequirementTrouble::Fails(witness)] => {
                assert!(!holds, "{}: {witness:?}", told());
                let [place] = &witness.places[..] else {
                    panic!("{}: {witness:?}", told());
                };
                let time = place.time.expect("a law is followed");
                // Its motor was declared first.
                let (_, motor) = place.motors[0];
                assert!((motor - (law.at)(time)).abs() < 1e-9, "{}", told());
                let is_near = |(sample, _): &&(f64, [f64; 3])| (sample - time).abs() < 1e-2 * PI;
                let near = samples.iter().zip(&values).filter(|(sample, _)| is_near(sample));
                let way = if sign == "<" { 1.0 } else { -1.0 };
                let near = near.map(|(_, value)| way * value).fold(f64::MIN, f64::max);
                let is_broken = way * (witness.value - limit) > 0.0 && near > way * limit - slack;
                assert!(is_broken, "{}: {near}, {witness:?}", told());
            }
            other => panic!("{}: {other:?}", told()),
        }
    }
}

/// A crank that turns or a block that slides, alone, with what it weighs against its motor.
fn alone(law: &Law, dice: &mut Dice) -> (String, f64) {
    let [mass, at, inertia] =
        [dice.between(0.1, 3.0), dice.between(-2.0, 2.0), dice.between(0.0, 1.0)];
    let ends = |first: &str, second: &str, dice: &mut Dice| {
        if dice.once_in(2) {
            (format!("{first}, {second}"), 1.0)
        } else {
            (format!("{second}, {first}"), -1.0)
        }
    };
    let angle = dice.between(-PI, PI);
    let (joint, weight, _) = if dice.once_in(2) {
        let (ends, sign) = ends("ground", "body", dice);
        let joint = format!("joint a = revolute({ends}) at (0, 0);");
        (joint, inertia + mass * at * at, sign)
    } else {
        let (ends, sign) = ends("ground", "body", dice);
        let (sin, cos) = angle.sin_cos();
        let joint = format!("joint a = prismatic({ends}) at (0, 0) along ({cos}, {sin});");
        (joint, mass, sign)
    };
    let mut statements = [
        format!("link body {{ mass {mass} at ({at}, 0) inertia {inertia}; }}"),
        "effects { acceleration; force; }".to_owned(),
    ];
    shuffle(&mut statements, dice);
    let text = format!("struct M; {} {joint} motor a = {};", statements.concat(), law.text);
    (text, weight)
}

#[test]
fn what_moves_alone_takes_its_inertia_times_the_second_rate_of_its_law() {
    for seed in seeds(cases(6)) {
        let mut dice = Dice::new(seed);
        let law = Law::motion(&mut dice);
        let (text, weight) = alone(&law, &mut dice);
        is_decided(&text, &law, ("velocity:a", ""), |[_, rate, _]| rate);
        is_decided(&text, &law, ("acceleration:a", ""), |[.., second]| second);
        is_decided(&text, &law, ("torque:a", ""), |[.., second]| weight * second);
        is_decided(&text, &law, ("power:a", ""), |[_, rate, second]| weight * rate * second);
    }
}

#[test]
fn a_slider_crank_on_an_uneven_law_takes_what_its_energy_says() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let plain = Slider::new(&mut dice);
        let masses = Masses::new(&plain, &mut dice);
        let push = [0; 2].map(|_| dice.between(-50.0, 50.0));
        let when = format!("for push = ({}, {})", push[0], push[1]);
        let law = if dice.once_in(2) { Law::uneven(&mut dice) } else { Law::motion(&mut dice) };
        // The law decides where it starts.
        let sense = plain.mirror;
        let angle = |motor: f64| sense * (motor - plain.turn);
        let first = plain.turn + places(&plain, angle((law.at)(0.0))).lean;
        let mut slider = masses.on(&plain, Some(&law.text));
        let (before, after) = slider.text.split_once("rod near").expect("a start");
        let (_, after) = after.split_once(';').expect("its end");
        slider.text = format!("{before}rod near {first};{after}");
        let text = &slider.text;
        let way = |angle: f64| slider.at(angle).0;
        is_decided(text, &law, ("velocity:x", ""), |[motor, rate, _]| {
            sense * rate * slopes(way, angle(motor))[0]
        });
        is_decided(text, &law, ("acceleration:x", ""), |[motor, rate, second]| {
            let [slope, bend] = slopes(way, angle(motor));
            sense * second * slope + rate * rate * bend
        });
        let lean = |angle: f64| places(&plain, angle).lean;
        is_decided(text, &law, ("velocity:rod", ""), |[motor, rate, _]| {
            sense * rate * slopes(lean, angle(motor))[0]
        });
        is_decided(text, &law, ("acceleration:rod", ""), |[motor, rate, second]| {
            let [slope, bend] = slopes(lean, angle(motor));
            sense * second * slope + rate * rate * bend
        });
        let times = format!("for t in 0 ..= {}", law.pieces[law.pieces.len() - 1]);
        is_decided(text, &law, ("d(x, a)", &times), |[motor, ..]| {
            sense * slopes(way, angle(motor))[0]
        });
        let torque = |[motor, rate, second]: [f64; 3]| {
            let angle = angle(motor);
            let energies = |angle: f64| masses.energies(&slider, angle);
            let [inertia, potential] =
                [0, 1].map(|number| slopes(|angle| energies(angle)[number], angle)[0]);
            let speed =
                [0, 1].map(|axis| slopes(|angle| places(&slider, angle).end[axis], angle)[0]);
            // What the load does, what lifts the masses, and what makes them faster.
            let faster = 0.5 * rate * rate * inertia + sense * second * energies(angle)[0];
            sense * (potential - dot(push, speed) + faster)
        };
        is_decided(text, &law, ("torque:a", &when), torque);
        is_decided(text, &law, ("power:a", &when), |motion| torque(motion) * motion[1]);
    }
}

/// The troubles with one statement.
fn troubles_with(text: &str, expect: &str) -> Vec<RequirementTrouble> {
    troubles(&judged(&text.parse().expect("tokens"), expect))
}

#[test]
fn a_motor_that_has_no_part_needs_no_times() {
    for seed in seeds(cases(2)) {
        let mut dice = Dice::new(seed);
        let law = Law::motion(&mut dice);
        let (text, weight) = alone(&law, &mut dice);
        let mut others = [
            "link other { mass 1; } joint o = revolute(ground, other) at (20, 0); motor o = 0.1 * t * t;",
            "link free { mass 1; } joint f = revolute(ground, free) at (40, 0); motor f;",
        ];
        shuffle(&mut others, &mut dice);
        let text = text + &others.concat();
        is_decided(&text, &law, ("velocity:a", ""), |[_, rate, _]| rate);
        is_decided(&text, &law, ("torque:a", ""), |[.., second]| weight * second);
        let found = troubles_with(&text, "expect velocity:o < 9;");
        assert!(matches!(found[..], [RequirementTrouble::NoTimes { goes_on: false }]));
    }
}

/// A crank that turns by a law, and moves a wheel of twice its size.
fn geared(law: &str) -> String {
    format!(
        "struct M; ground {{ point o = (0, 0); point p = (3, 0); }}
        link crank {{ point o = (0, 0); }} link wheel {{ point p = (0, 0); point rim = (2, 0); }}
        joint a = revolute(ground.o, crank.o); joint b = revolute(ground.p, wheel.p);
        joint mesh = gear(crank, wheel, 1 : 2); motor a = {law}; start {{ wheel near 0 deg; }} effects {{ velocity; }}"
    )
}

#[test]
fn a_wheel_that_is_back_after_two_turns_is_looked_at_for_two() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let (size, phase) = (dice.between(0.1, 0.6), dice.between(-PI, PI));
        let law = format!("2 * PI * t + {size} * sin(2 * PI * t + {phase})");
        let at = |time: f64| TAU * time + size * (TAU * time + phase).sin();
        let text = geared(&law);
        // A wheel turns against its neighbour.
        let place = |time: f64| 2.0 * (0.5 * (at(0.0) - at(time))).cos();
        let velocity = |time: f64| (place(time + 1e-4) - place(time - 1e-4)) / 2e-4;
        let most = |turn: f64, way: f64| {
            let times = (0..=4000).map(|step| turn + f64::from(step) / 4000.0);
            times.map(|time| way * velocity(time)).fold(f64::MIN, f64::max)
        };
        for (sign, way) in [("<", 1.0), (">", -1.0)] {
            let turns = [0.0, 1.0].map(|turn| most(turn, way));
            // One turn alone would tell less of one of both directions.
            assert!((turns[0] - turns[1]).abs() > 1.0, "{turns:?}");
            let most = turns[0].max(turns[1]);
            let [within, beyond] = [0.999, 1.001].map(|part| way * part * most);
            let expect = |limit: f64| format!("expect velocity:wheel.rim.x {sign} {limit};");
            assert!(
                matches!(troubles_with(&text, &expect(within))[..], [RequirementTrouble::Fails(_)]),
                "{text}"
            );
            assert!(troubles_with(&text, &expect(beyond)).is_empty(), "{text}");
        }
    }
}

#[test]
fn laws_that_are_never_back_need_times() {
    let text = |law: &str| {
        format!(
            "struct M; link crank {{ mass 1; }} joint a = revolute(ground, crank) at (0, 0); motor a = {law}; effects {{ acceleration; force; }}"
        )
    };
    let never = text("0.1 * t * t + 0.2 * sin(t)");
    let [RequirementTrouble::NoTimes { goes_on: false }] =
        troubles_with(&never, "expect velocity:a < 9;")[..]
    else {
        panic!("{never}");
    };
    // 0.2 t + 0.2 cos t is greatest at the end: 0.6 + 0.2 cos 3.
    let most = 0.6 + 0.2 * 3.0_f64.cos();
    let at_end = 0.2_f64.mul_add(5.0, 0.2 * 5.0_f64.cos());
    for (ends, most) in [("0 ..= 3", most.max(0.4_f64)), ("4 ..= 5", at_end)] {
        for (part, holds) in [(1.001, true), (0.999, false)] {
            let expect = format!("expect velocity:a < {} for t in {ends};", most * part);
            assert_eq!(troubles_with(&never, &expect).is_empty(), holds, "{expect}");
        }
    }
    let at = format!("expect velocity:a in {} ..= {} at t = 5;", at_end - 1e-6, at_end + 1e-6);
    assert!(troubles_with(&never, &at).is_empty());
    let follows = troubles_with(&never, "expect velocity:a < 9 for a in 0 deg ..= 9 deg;");
    assert!(matches!(follows[..], [RequirementTrouble::Follows { .. }]));
    // Where it is needs no rates, and laws may be even.
    let even = text("2 * t");
    assert!(troubles_with(&even, "expect a < 6.001 for t in 0 ..= 3;").is_empty());
    assert!(!troubles_with(&even, "expect a < 5.999 for t in 0 ..= 3;").is_empty());
}

#[test]
fn nothing_is_proved_of_an_acceleration_where_a_velocity_jumps() {
    let text = |law: &str| {
        format!(
            "struct M; ground {{ point o = (0, 0); }} link crank {{ point o = (0, 0); mass 1 at (1, 0); }} joint a = revolute(ground.o, crank.o); motor a = {law};
            effects {{ acceleration; force; }}"
        )
    };
    // Each with a time between which its velocity, or it itself, jumps, and the greatest velocity.
    let jumping = [
        ("0.5 * max(0, sin(t))", [6.0, 6.6], Some(0.5)),
        ("0.3 * abs(sin(2 * t + 1))", [0.9, 1.2], Some(0.6)),
        ("max(0, t - 1)", [0.8, 1.7], Some(1.0)),
        ("min(t * t, 2 * t)", [1.5, 2.5], Some(4.0)),
        ("rise 1 over 0.5 with linear, dwell 0.5", [0.2, 0.7], Some(2.0)),
        ("0.2 * sign(t - 2)", [1.1, 2.3], None),
        ("floor(t)", [0.6, 1.4], None),
        ("atan2(sin(t), cos(t))", [3.0, 3.3], None),
    ];
    for (law, [low, high], velocity) in jumping {
        let text = text(law);
        let when = format!("for t in {low} ..= {high}");
        for subject in [
            "acceleration:a",
            "torque:a",
            "power:a",
            "shaking:force",
            "shaking:force.x",
            "shaking:moment",
        ] {
            let found = troubles_with(&text, &format!("expect {subject} < 1000000 {when};"));
            let [RequirementTrouble::Jumps { at, is_rate, .. }] = found[..] else {
                panic!("{law}: {found:?}");
            };
            assert!(low <= at && at <= high, "{law}: {at}");
            assert_eq!(is_rate, velocity.is_some(), "{law}");
        }
        let below =
            |limit: f64| troubles_with(&text, &format!("expect velocity:a < {limit} {when};"));
        match velocity {
            Some(most) => {
                assert!(below(1.001 * most).is_empty(), "{law}: {:?}", below(most));
                assert!(matches!(below(0.999 * most)[..], [RequirementTrouble::Fails(_)]));
            }
            None => assert!(matches!(
                below(1e6)[..],
                [RequirementTrouble::Jumps { is_rate: false, .. }]
            )),
        }
    }
    // What meets without a jump has accelerations on both sides.
    for (law, ends, most) in [
        ("0.5 * max(0, t - 1) * max(0, t - 1)", "0 ..= 2", 1.0),
        ("rise 1 over 1 with parabolic", "-1 ..= 2", 4.0),
        ("rise 1 over 1 with harmonic", "-1 ..= 2", 0.5 * PI * PI),
    ] {
        for (part, holds) in [(1.001, true), (0.999, false)] {
            let expect = format!("expect torque:a < {} for t in {ends};", part * most);
            let found = troubles_with(&text(law), &expect);
            assert_eq!(found.is_empty(), holds, "{law}: {found:?}");
        }
    }
}

#[test]
fn laws_that_lead_where_a_mechanism_does_not_go_are_told_with_the_time() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        // A crank on an axle that a rod joins to a guide, too far away to let it turn right round.
        let [crank, rod] = [0; 2].map(|_| dice.between(1.0, 2.0));
        let offset = rod + dice.between(0.1, 0.8) * crank;
        let speed = dice.between(0.5, 3.0) * if dice.once_in(2) { -1.0 } else { 1.0 };
        // The rod is at right angles to the guide where it stops: its end is at this angle on the circle of the crank.
        let limit = ((offset - rod) / crank).asin();
        let (begin, way) = (0.5 * PI, 0.5 * PI - limit);
        let text = |law: &str| {
            format!(
                "struct M; ground {{ point o = (0, 0); line guide = (0, {offset}) -> (1, 0); }}
                link crank {{ point o = (0, 0); point pin = ({crank}, 0); }} link rod {{ point pin = (0, 0); point end = ({rod}, 0); }}
                link block {{ point end = (0, 0); line edge = (0, 0) -> (1, 0); mass 1; }}
                joint a = revolute(ground.o, crank.o); joint b = revolute(crank.pin, rod.pin); joint c = revolute(rod.end, block.end);
                joint x = prismatic(ground.guide, block.edge); motor a = {law}; start {{ rod near 30 deg; }}
                effects {{ acceleration; force; }}"
            )
        };
        let goes = text(&format!("{begin} + {speed} * t"));
        let stops = way / speed.abs();
        let within = |part: f64| format!("for t in 0 ..= {}", part * stops);
        for subject in ["x", "velocity:x", "acceleration:x", "torque:a", "shaking:force"] {
            let beyond =
                troubles_with(&goes, &format!("expect {subject} < 1000000000 {};", within(1.01)));
            let [RequirementTrouble::Astray { at }] = beyond[..] else {
                panic!("{subject}: {beyond:?} {goes}");
            };
            assert!((at - stops).abs() < 0.02 * stops, "{subject}: {at} and {stops}: {goes}");
            let before =
                troubles_with(&goes, &format!("expect {subject} < 1000000000 {};", within(0.9)));
            assert!(before.is_empty(), "{subject}: {before:?} {goes}");
        }
        // The same to and fro.
        let swings = text(&format!("{begin} + {} * sin({speed} * t)", 1.1 * way));
        let found = troubles_with(&swings, "expect velocity:x < 1000000000;");
        assert!(matches!(found[..], [RequirementTrouble::Astray { .. }]), "{found:?} {swings}");
        let swings = text(&format!("{begin} + {} * sin({speed} * t)", 0.9 * way));
        let found = troubles_with(&swings, "expect velocity:x < 1000000000;");
        assert!(found.is_empty(), "{found:?} {swings}");
    }
}

#[test]
fn two_motors_on_laws_of_their_own_move_a_point_as_fast_as_both() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let [first, second] = [0; 2].map(|_| dice.between(0.2, 2.0));
        let (phase, quick) = (dice.between(-PI, PI), f64::from(*dice.pick(&[2_u8, 3])));
        let text = format!(
            "struct M; link column {{ }} link head {{ point tip = (0.3, 0.2); }}
            joint x = prismatic(ground, column) at (0, 0) along (1, 0);
            joint y = prismatic(column, head) at (0, 0) along (0, 1);
            motor x = {first} * sin(t); motor y = {second} * (sin({quick} * t + {phase}) - sin({phase})); effects {{ velocity; }}"
        );
        let speed = |time: f64| {
            let (x, y) = (first * time.cos(), second * quick * (quick * time + phase).cos());
            x.hypot(y)
        };
        let times = (0..100_000).map(|step| TAU * f64::from(step) / 100_000.0);
        let most = times.map(speed).fold(0.0, f64::max);
        for (part, holds) in [(1.001, true), (0.999, false)] {
            let expect = format!("expect velocity:head.tip < {};", most * part);
            assert_eq!(troubles_with(&text, &expect).is_empty(), holds, "{expect} {text}");
        }
    }
}
