//! What is expected of velocities, accelerations, torques and reactions, against closed forms of slider-cranks and differences of positions.

use super::courses::Slider;
use super::requirements::{Subject, judged, reach, troubles};
use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Actions, Effects, Model, Precision};
use mech_compiler::program::Program;
use mech_compiler::structure::RequirementTrouble;
use mech_test_support::{
    Dice, cases, differences, dot, for_all, known_texts, samples, seeds, text,
};
use proc_macro2::TokenStream;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Limits are this part of the greatest value away from an extreme.
const MARGIN: f64 = 1e-3;
const PLACES: u32 = 720;

/// Asks for limits of a subject beside its extremes in a round, on both sides of each.
fn is_decided(slider: &Slider, subject: &str, when: &str, value: impl Fn(f64) -> f64) {
    let places = (0..PLACES).map(|place| TAU * f64::from(place) / f64::from(PLACES));
    is_decided_within(slider, subject, when, &places.map(value).collect::<Vec<f64>>());
}

/// The same, where it has these values.
fn is_decided_within(slider: &Slider, subject: &str, when: &str, values: &[f64]) {
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let slack = MARGIN * greatest.abs().max(least.abs());
    // A length is least in a corner, which lies between places.
    let has_corner = least >= 0.0 && least < 0.2 * greatest;
    for (sign, limit, holds) in [
        ("<", greatest + slack, true),
        ("<", greatest - slack, false),
        (">", least - slack, true),
        (">", least + slack, false),
    ] {
        if has_corner && sign == ">" {
            continue;
        }
        let expect = format!("{subject} {sign} {limit} {when}");
        let met = slider.meets(&expect);
        assert_eq!(met, holds, "{expect}, {least} to {greatest}: {}", slider.text);
    }
}

/// The crank's angles between two ends, in any order.
fn turning(ends: [f64; 2]) -> String {
    let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])].map(f64::to_degrees);
    format!("a in {low} deg ..= {high} deg")
}

/// The first and the second derivative of something.
pub(super) fn slopes(of: impl Fn(f64) -> f64, at: f64) -> [f64; 2] {
    const STEP: f64 = 2e-3;
    let around = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|step| of(at + step * STEP));
    differences(around, STEP)
}

/// The masses of a slider-crank, with the distances of their centres from the first pin of each link, and moments of inertia.
pub(super) struct Masses {
    crank: [f64; 3],
    rod: [f64; 3],
    piston: f64,
    gravity: [f64; 2],
}

impl Masses {
    pub(super) fn new(slider: &Slider, dice: &mut Dice) -> Self {
        let mut link = |length: f64| {
            let at = length * dice.between(-0.2, 1.1);
            [dice.between(0.1, 3.0), at, dice.between(0.0, 1.0)]
        };
        Self {
            crank: link(slider.crank),
            rod: link(slider.rod),
            piston: dice.between(0.1, 3.0),
            gravity: [0; 2].map(|_| dice.between(-10.0, 10.0)),
        }
    }

    /// The same slider-crank with these masses, and with a law for its motor if one is given.
    pub(super) fn on(&self, slider: &Slider, law: Option<&str>) -> Slider {
        let mass =
            |[mass, at, inertia]: [f64; 3]| format!("mass {mass} at ({at}, 0) inertia {inertia};");
        let [gx, gy] = self.gravity;
        let mut text = slider
            .text
            .replace("link crank {", &format!("link crank {{ {}", mass(self.crank)))
            .replace("link rod {", &format!("link rod {{ {}", mass(self.rod)))
            .replace("link piston {", &format!("link piston {{ mass {};", self.piston));
        if let Some(law) = law {
            text = text.replace("motor a;", &format!("motor a = {law};"));
            text = text.replace(&format!("a = {}; rod", slider.start), "rod");
        }
        text += &format!(
            "gravity ({gx}, {gy}); load push = force(piston.q); load twist = torque(rod); effects {{ acceleration; force; }}"
        );
        Slider { text, ..slider.clone() }
    }

    /// The mechanism's inertia as the motor feels it, and its potential energy.
    pub(super) fn energies(&self, slider: &Slider, angle: f64) -> [f64; 2] {
        let [crank, rod] = [self.crank, self.rod];
        let lean = slopes(|angle| places(slider, angle).lean, angle)[0];
        let mut inertia = crank[2] + rod[2] * lean * lean;
        let mut potential = 0.0;
        for (number, mass) in self.all().into_iter().enumerate() {
            let center = |angle| self.centers(slider, angle)[number];
            let velocity = [0, 1].map(|axis| slopes(|angle| center(angle)[axis], angle)[0]);
            inertia += mass * dot(velocity, velocity);
            potential -= mass * dot(self.gravity, center(angle));
        }
        [inertia, potential]
    }

    fn all(&self) -> [f64; 3] {
        [self.crank[0], self.rod[0], self.piston]
    }

    /// The centres of the masses in the scene.
    fn centers(&self, slider: &Slider, angle: f64) -> [[f64; 2]; 3] {
        let Places { pin, end, .. } = places(slider, angle);
        let along = [end[0] - pin[0], end[1] - pin[1]];
        let (crank, rod) = (self.crank[1] / slider.crank, self.rod[1] / slider.rod);
        let center = [0, 1].map(|axis| pin[axis] + along[axis] * rod);
        [pin.map(|part| part * crank), center, end]
    }

    /// The force on the ground and its moment about the origin, where the crank turns at a rate: weights less what accelerates masses.
    fn on_ground(&self, slider: &Slider, angle: f64, rate: f64, gravity: [f64; 2]) -> [f64; 3] {
        let faster = slopes(|angle| places(slider, angle).lean, angle)[1];
        let mut sum = [0.0, 0.0, -self.rod[2] * rate * rate * faster];
        for (number, mass) in self.all().into_iter().enumerate() {
            let center = |angle| self.centers(slider, angle)[number];
            let force = [0, 1].map(|axis| {
                let faster = slopes(|angle| center(angle)[axis], angle)[1];
                mass * (gravity[axis] - rate * rate * faster)
            });
            let [x, y] = center(angle);
            let parts = [force[0], force[1], x * force[1] - y * force[0]];
            sum = [0, 1, 2].map(|part| sum[part] + parts[part]);
        }
        sum
    }
}

/// The places of a slider-crank in the scene.
pub(super) struct Places {
    pin: [f64; 2],
    pub(super) end: [f64; 2],
    /// The angle of its rod, near to that of its rail.
    pub(super) lean: f64,
}

pub(super) fn places(slider: &Slider, angle: f64) -> Places {
    let (along, _) = slider.at(angle);
    let (sin, cos) = slider.turn.sin_cos();
    let scene = |x: f64, y: f64| {
        let y = slider.mirror * y;
        [cos * x - sin * y, sin * x + cos * y]
    };
    let pin = scene(slider.crank * angle.cos(), slider.crank * angle.sin());
    let across = slider.offset - slider.crank * angle.sin();
    Places {
        pin,
        end: scene(along, slider.offset),
        lean: slider.mirror * (across / slider.rod).asin(),
    }
}

#[test]
fn rates_torques_and_reactions_are_those_of_closed_forms() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let plain = Slider::new(&mut dice);
        let masses = Masses::new(&plain, &mut dice);
        let push = [0; 2].map(|_| dice.between(-50.0, 50.0));
        let twist = dice.between(-5.0, 5.0);
        let when = format!("for push = ({}, {}), twist = {twist}", push[0], push[1]);
        let rate = dice.between(0.5, 20.0) * if dice.once_in(2) { -1.0 } else { 1.0 };
        let law = format!("{} + {rate} * t", plain.start);
        let sense = plain.mirror;
        // At rest velocities are those at a rate of 1, and torques those that hold it.
        for (slider, rate, pushed) in
            [(masses.on(&plain, None), 1.0, 0.0), (masses.on(&plain, Some(&law)), rate, rate)]
        {
            let way = |angle: f64| slider.at(angle).0;
            is_decided(&slider, "velocity:x", "", |angle| sense * rate * slopes(way, angle)[0]);
            is_decided(&slider, "acceleration:x", "", |angle| rate * rate * slopes(way, angle)[1]);
            let torque = |angle: f64| {
                let [inertia, potential] = [0, 1].map(|number| {
                    slopes(|angle| masses.energies(&slider, angle)[number], angle)[0]
                });
                let speed =
                    [0, 1].map(|axis| slopes(|angle| places(&slider, angle).end[axis], angle)[0]);
                let lean = slopes(|angle| places(&slider, angle).lean, angle)[0];
                // What the loads do, what lifts the masses, and what makes them faster.
                let work = potential - dot(push, speed) - twist * lean;
                let faster = 0.5 * pushed * pushed * inertia;
                sense * (work + faster)
            };
            is_decided(&slider, "torque:a", &when, torque);
            if pushed != 0.0 {
                is_decided(&slider, "power:a", &when, |angle| torque(angle) * pushed);
            }
            let words = ["x", "y", "torque"].into_iter().enumerate();
            for (part, word) in words {
                is_decided(&slider, &format!("reaction:ground.{word}"), &when, |angle| {
                    let own = masses.on_ground(&slider, angle, pushed, masses.gravity);
                    let [x, y] = places(&slider, angle).end;
                    let loads = [push[0], push[1], x * push[1] - y * push[0] + twist];
                    own[part] + loads[part]
                });
                if pushed != 0.0 {
                    let word = ["force.x", "force.y", "moment"][part];
                    is_decided(&slider, &format!("shaking:{word}"), "", |angle| {
                        masses.on_ground(&slider, angle, pushed, [0.0; 2])[part]
                    });
                }
            }
        }
    }
}

#[test]
fn advantages_and_instant_centres_are_those_of_closed_forms() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let mut slider = Slider::new(&mut dice);
        slider.text +=
            "load push = force(piston.q); load twist = torque(rod); effects { velocity; force; }";
        let push = [0; 2].map(|_| dice.between(-50.0, 50.0));
        let when = format!("for push = ({}, {})", push[0], push[1]);
        let ways = |angle: f64| {
            let [x, y] =
                [0, 1].map(|axis| slopes(|angle| places(&slider, angle).end[axis], angle)[0]);
            let lean = slopes(|angle| places(&slider, angle).lean, angle)[0];
            ([x, y], lean)
        };
        // At a dead point there is no limit to an advantage: of the piston where it turns round, of the rod a quarter of a turn farther.
        for (load, quarter) in [("push", 1.0), ("twist", 0.0)] {
            let middle = FRAC_PI_2 * (quarter + 2.0 * f64::from(u8::from(dice.once_in(2))));
            let ends = [middle - 0.3, middle + 0.3].map(|end| slider.turn + slider.mirror * end);
            let values = (-300..=300).map(|place| {
                let (speed, lean) = ways(middle + 0.001 * f64::from(place));
                let ratio = match load {
                    "push" => dot(speed, push) / push[0].hypot(push[1]),
                    _ => lean,
                };
                slider.mirror / ratio
            });
            is_decided_within(
                &slider,
                &format!("advantage({load}, a)"),
                &format!("{when}, {}", turning(ends)),
                &values.collect::<Vec<f64>>(),
            );
        }
        // The rod turns about where the line through the crank meets what is at right angles to the rail. Both links' pin is their own centre.
        for (part, word) in ["x", "y"].into_iter().enumerate() {
            is_decided(&slider, &format!("centre(crank, rod).{word}"), "", |angle| {
                places(&slider, angle).pin[part]
            });
        }
        let middle = dice.between(-0.6, 0.6) + if dice.once_in(2) { 0.0 } else { PI };
        let ends = [middle - 0.3, middle + 0.3].map(|end| slider.turn + slider.mirror * end);
        let distances = (-300..=300).map(|place| {
            let angle = middle + 0.001 * f64::from(place);
            (slider.at(angle).0 / angle.cos()).abs()
        });
        is_decided_within(
            &slider,
            "centre(rod, ground).norm",
            &format!("for {}", turning(ends)),
            &distances.collect::<Vec<f64>>(),
        );
    }
}

#[test]
fn a_rod_without_mass_carries_what_pushes_its_piston() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let mut slider = Slider::new(&mut dice);
        slider.text += "load push = force(piston.q); effects { force; }";
        let (sin, cos) = slider.turn.sin_cos();
        let (along, across) = (dice.between(-50.0, 50.0), dice.between(-50.0, 50.0));
        let push = [along * cos - across * sin, along * sin + across * cos];
        let when = format!("for push = ({}, {})", push[0], push[1]);
        let lean = |angle: f64| places(&slider, angle).lean;
        for joint in ["a", "b", "c"] {
            is_decided(&slider, &format!("reaction:{joint}"), &when, |angle| {
                (along / lean(angle).cos()).abs()
            });
        }
        // The rail takes what is across.
        is_decided(&slider, "reaction:x.norm", &when, |angle| {
            (across - along * lean(angle).tan()).abs()
        });
    }
}

/// What was proved or refused, and what was left open.
#[derive(Debug, Default)]
struct Count {
    decided: usize,
    open: usize,
}

/// A mechanism whose motor moves something: how fast, and with which torque.
struct Moving<'m> {
    model: &'m Model,
    program: &'m Program,
    motor: usize,
    ends: [f64; 2],
    subject: Subject,
    /// A point that is pushed, and by what.
    pushed: Option<([Subject; 2], [f64; 2])>,
}

/// What is measured of it.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Velocity,
    Acceleration,
    Torque,
}

impl Moving<'_> {
    /// It where the motor is at a value, by differences of positions.
    fn at(&self, kind: Kind, value: f64) -> Option<f64> {
        let step = (1e-3 * (self.ends[1] - self.ends[0])).clamp(1e-5, 1e-3);
        let place = |value: f64| {
            let mut goal = self.program.start.motors.clone();
            goal[self.motor] = value;
            let mut machine = Machine::<f64>::new(self.program);
            machine.move_to(&goal).ok()?;
            Some(machine.into_position().poses)
        };
        let around = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| place(value + steps * step));
        let slopes = |subject: Subject| {
            let mut last = None;
            let mut values = [0.0; 5];
            for (value, poses) in values.iter_mut().zip(&around) {
                *value = subject.of(self.model, poses.as_ref()?, last);
                last = Some(*value);
            }
            Some(differences(values, step))
        };
        match (kind, self.pushed) {
            (Kind::Velocity, _) => Some(slopes(self.subject)?[0]),
            (Kind::Acceleration, _) => Some(slopes(self.subject)?[1]),
            (Kind::Torque, Some((parts, push))) => {
                let speed = [slopes(parts[0])?[0], slopes(parts[1])?[0]];
                Some(-dot(push, speed))
            }
            (Kind::Torque, None) => None,
        }
    }
}

impl Count {
    /// Asks for limits of rates and torques in a mechanism beside their extremes, for one motor.
    fn judge(&mut self, body: &TokenStream, dice: &mut Dice) {
        let asked = |extra: &str| {
            let mut all = body.clone();
            all.extend(extra.parse::<TokenStream>().expect("tokens"));
            all
        };
        let parsed = mech_compiler::analyse(body.clone()).parsed;
        let whole = Model {
            show: None,
            method: None,
            accuracy: None,
            precision: Precision::F64,
            effects: Effects::default(),
            ..parsed.model
        };
        let is_moved = !whole.motors.is_empty() && whole.lawful_motors().next().is_none();
        let Ok(compiled) = compile(&whole) else {
            return;
        };
        let acts =
            parsed.model.effects != Effects::default() || whole.actions != Actions::default();
        if !is_moved || !whole.params.is_empty() || acts || parsed.model.show.is_some() {
            return;
        }
        let program = &compiled.program;
        let motor = dice.below(whole.motors.len());
        let [low, high] = reach(&whole, program, &program.start.motors, motor);
        // Beside dead points everything is fast.
        let ends = [0.1, 0.9].map(|part| low + part * (high - low));
        let subjects = Subject::all(&whole);
        if subjects.is_empty() {
            return;
        }
        let (name, subject) = dice.pick(&subjects);
        let points = subjects.chunks(2).filter(|pair| {
            let is_point = |(_, one): &(String, Subject)| matches!(one, Subject::Place(..));
            pair.len() == 2 && pair.iter().all(is_point)
        });
        let points: Vec<&[(String, Subject)]> = points.collect();
        let pushed = (!points.is_empty()).then(|| *dice.pick(&points));
        let push = [0; 2].map(|_| dice.between(-9.0, 9.0));
        let moving = Moving {
            model: &whole,
            program,
            motor,
            ends,
            subject: *subject,
            pushed: pushed.map(|pair| ([pair[0].1, pair[1].1], push)),
        };
        let load = pushed.map(|pair| {
            let point = pair[0].0.trim_end_matches(".x");
            format!("load push = force({point}); ")
        });
        let text = asked(&match &load {
            Some(load) => format!("{load} effects {{ acceleration; force; }}"),
            None => "effects { acceleration; }".to_owned(),
        });
        let joint = |motor: usize| &whole.joint(whole.motors[motor].joint).name;
        let others = (0..whole.motors.len()).filter(|other| *other != motor);
        let others: Vec<String> = others
            .map(|other| format!("{} = {}", joint(other), program.start.motors[other]))
            .collect();
        let at =
            if others.is_empty() { String::new() } else { format!(" at {}", others.join(", ")) };
        let range = format!("for {} in {} ..= {}", joint(motor), ends[0], ends[1]);
        for kind in [Kind::Velocity, Kind::Acceleration, Kind::Torque] {
            let (subject, range) = match kind {
                Kind::Velocity => (format!("velocity:{name}"), range.clone()),
                Kind::Acceleration => (format!("acceleration:{name}"), range.clone()),
                Kind::Torque if load.is_none() => continue,
                Kind::Torque => (
                    format!("torque:{}", joint(motor)),
                    format!("{range}, push = ({}, {})", push[0], push[1]),
                ),
            };
            self.judge_one(&text, &moving, kind, &subject, &format!("{range}{at};"));
        }
    }

    fn judge_one(
        &mut self,
        text: &TokenStream,
        moving: &Moving<'_>,
        kind: Kind,
        subject: &str,
        when: &str,
    ) {
        let ends = moving.ends;
        let places =
            (0..=200).map(|place| ends[0] + (ends[1] - ends[0]) * f64::from(place) / 200.0);
        let Some(values) = places.map(|value| moving.at(kind, value)).collect::<Option<Vec<f64>>>()
        else {
            return;
        };
        let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let size = greatest.abs().max(least.abs());
        // Differences tell no more of what is smaller.
        if size < 1e-3 * moving.model.size() || greatest - least < 1e-2 * size {
            return;
        }
        let slack = 2.0 * MARGIN * size;
        for (sign, way, extreme) in [("<=", 1.0, greatest), (">=", -1.0, least)] {
            for beyond in [1.0, -1.0] {
                let limit = extreme + way * beyond * slack;
                let found =
                    troubles(&judged(text, &format!("expect {subject} {sign} {limit} {when}")));
                let told =
                    || format!("{} {subject} {sign} {limit} {when} {text}", moving.model.name);
                match &found[..] {
                    [] => {
                        assert!(beyond > 0.0, "falsely proved: {}, {extreme}", told());
                        self.decided += 1;
                    }
                    [RequirementTrouble::Fails(witness)] => {
                        let [place] = &witness.places[..] else {
                            panic!("{}: {witness:?}", told());
                        };
                        let at =
                            place.motors.iter().find(|(motor, _)| motor.index() == moving.motor);
                        let value = at.and_then(|(_, at)| moving.at(kind, *at));
                        let value = value.expect("it comes to where it fails");
                        let is_broken = way * (value - limit) > -1e-4 * size;
                        // At a change point rounding takes digits from a rate.
                        let is_told = (value - witness.value).abs() < MARGIN * size;
                        assert!(is_broken && is_told, "{}: {value}, {witness:?}", told());
                        self.decided += 1;
                    }
                    [
                        RequirementTrouble::Iterated { .. }
                        | RequirementTrouble::Together
                        | RequirementTrouble::NoForces,
                    ] => {}
                    [RequirementTrouble::Undecided { .. } | RequirementTrouble::TooHard] => {
                        self.open += 1;
                    }
                    other => panic!("{}: {other:?}", told()),
                }
            }
        }
    }
}

#[test]
fn rates_and_torques_are_those_of_differences_in_random_mechanisms() {
    let (mut count, mut dice) = (Count::default(), Dice::new(7));
    for_all(25, &samples(1..4), |sample| {
        let body = text(&sample.grown.model).parse().expect("tokens");
        count.judge(&body, &mut dice);
    });
    println!("{count:?}");
    assert!(count.decided > 20 && 10 * count.open <= count.decided, "{count:?}");
}

#[test]
fn rates_and_torques_are_those_of_differences_in_the_gallery() {
    let (mut count, mut dice) = (Count::default(), Dice::new(8));
    for body in known_texts() {
        count.judge(&body, &mut dice);
    }
    println!("{count:?}");
    assert!(count.decided > 20 && 10 * count.open <= count.decided, "{count:?}");
}
