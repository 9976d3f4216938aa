//! Pressure angles and curvatures of cams, against differences of the places where the mechanism has the roller.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, LinkId, Model};
use mech_compiler::program::{CamContact, Program};
use mech_compiler::{Compiled, analyse, compile};
use mech_test_support::{Dice, model, seeds};
use proc_macro2::TokenStream;
use std::f64::consts::TAU;

type Vector = [f64; 2];

/// A cam with a roller: in any orientation, on the ground or on a link that rests on it, turned either way.
fn text(dice: &mut Dice, expect: &str) -> String {
    let carrier = *dice.pick(&["ground", "frame"]);
    let mut ends = |one: &str| {
        let ends = [carrier, one];
        let [a, b] = if dice.once_in(2) { [ends[1], ends[0]] } else { ends };
        format!("{a}, {b}")
    };
    let (shaft, follower) = (ends("disk"), ends("lever"));
    let mut number = |low: f64, high: f64| dice.between(low, high);
    let (turn, away) = (number(-3.0, 3.0), number(3.0, 5.0));
    let (x, y) = (away * turn.cos(), away * turn.sin());
    let (px, py) = (x + number(2.0, 4.0), y + number(2.0, 4.0));
    let (along, scale) = (turn + number(-0.4, 0.4), number(0.3, 0.6));
    let (second, phase) = (number(-0.2, 0.2), number(0.5, 2.0));
    let radius = number(0.2, 0.8);
    let joint = if dice.once_in(2) {
        format!("prismatic({follower}) at ({x}, {y}) along {along}")
    } else {
        format!("revolute({follower}) at ({px}, {py})")
    };
    let frame = if carrier == "frame" {
        "link frame; joint hold = weld(ground, frame) at (1, 1);"
    } else {
        ""
    };
    let law = format!("{scale} * (1 - cos(q)) + {second} * (sin(2 * q + {phase}) - sin({phase}))");
    format!(
        "struct M; {frame} link disk; link lever {{ point foot = ({x}, {y}); }}
        joint s = revolute({shaft}) at (0, 0); joint f = {joint};
        joint c = cam(s, f, {law}) roller lever.foot radius {radius}; motor s; {expect}"
    )
}

/// A mechanism whose roller is looked at.
struct Seen<'p> {
    model: &'p Model,
    program: &'p Program,
    machine: Machine<'p, f64>,
}

impl<'p> Seen<'p> {
    fn new(model: &'p Model, compiled: &'p Compiled) -> Self {
        let program = &compiled.program;
        Self { model, program, machine: Machine::new(program) }
    }

    fn link(&self, joint: &str) -> LinkId {
        let mut joints = self.model.joint_ids();
        let found = joints.find(|id| self.model.joint(*id).name == joint);
        let (a, b) = self.model.ends(found.expect("it is there"));
        let is_carrier =
            |link: LinkId| link == LinkId::GROUND || self.model.link(link).name == "frame";
        if is_carrier(a) { b } else { a }
    }

    fn pose(&self, link: LinkId) -> [f64; 4] {
        let place = self.program.place_of(link).expect("it is shown");
        self.machine.position().poses[place]
    }

    /// The middle of the roller in the scene, where the carrier rests, and seen from the cam.
    fn roller(&mut self, shaft: f64) -> [Vector; 2] {
        self.machine.move_to(&[shaft]).expect("it moves");
        let foot = self.model.axis(self.model.rollers[0].point).at;
        let [cos, sin, x, y] = self.pose(self.link("f"));
        let scene = [x + cos * foot[0] - sin * foot[1], y + sin * foot[0] + cos * foot[1]];
        let [cos, sin, x, y] = self.pose(self.link("s"));
        let (dx, dy) = (scene[0] - x, scene[1] - y);
        [scene, [cos * dx + sin * dy, cos * dy - sin * dx]]
    }

    /// The direction of the follower's way: along its slide, or across its lever.
    fn way(&mut self, shaft: f64) -> Vector {
        let [place, _] = self.roller(shaft);
        let joints = self.model.joint_ids();
        let mut joints = joints.map(|id| self.model.joint(id));
        let follower = joints.find(|joint| joint.name == "f").expect("it is there");
        let JointKind::Revolute(pivot, _) = follower.kind else {
            // Any two places of the roller tell it.
            let [a, b] = [0.3, 2.9].map(|shaft| self.roller(shaft)[0]);
            return [b[0] - a[0], b[1] - a[1]];
        };
        let axis = self.model.axis(pivot);
        let [x, y] = if axis.link == LinkId::GROUND {
            axis.at
        } else {
            let [cos, sin, x, y] = self.pose(axis.link);
            [x + cos * axis.at[0] - sin * axis.at[1], y + sin * axis.at[0] + cos * axis.at[1]]
        };
        [y - place[1], place[0] - x]
    }

    /// The pressure angle and the curvature by differences.
    fn contact(&mut self, shaft: f64) -> [f64; 2] {
        const STEP: f64 = 1e-3;
        let places = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| self.roller(shaft + k * STEP));
        let [[tx, cx], [ty, cy]] = [0, 1]
            .map(|part| mech_test_support::differences(places.map(|place| place[1][part]), STEP));
        let way = self.way(shaft);
        self.machine.move_to(&[shaft]).expect("it moves");
        // The way of the follower, seen from the cam as it stands now.
        let [cos, sin, ..] = self.pose(self.link("s"));
        let seen = [cos * way[0] + sin * way[1], cos * way[1] - sin * way[0]];
        let curvature = (tx * cy - ty * cx) / tx.hypot(ty).powi(3);
        let (along, across) = (tx * seen[0] + ty * seen[1], tx * seen[1] - ty * seen[0]);
        [along.abs().atan2(across.abs()), self.round() * curvature]
    }

    /// Whether the roller goes round the cam counter-clockwise, 1, or clockwise, −1: by the area within.
    fn round(&mut self) -> f64 {
        let places = (0_u8..=48).map(|number| {
            let [_, place] = self.roller(f64::from(number) * TAU / 48.0);
            place
        });
        let places: Vec<Vector> = places.collect();
        let pairs = places.windows(2);
        let areas = pairs.map(|pair| pair[0][0] * pair[1][1] - pair[0][1] * pair[1][0]);
        areas.sum::<f64>().signum()
    }
}

#[test]
fn contacts_are_those_of_the_roller_as_it_moves() {
    for seed in seeds(60) {
        let mut dice = Dice::new(seed);
        let text = text(&mut dice, "");
        let model = model(&text);
        let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{text}: {wrong:?}"));
        let cam = model.rollers[0].cam;
        assert!(matches!(model.joint(cam).kind, JointKind::Cam { .. }));
        let contact = CamContact::new(&model, &compiled.program, cam).expect("it turns");
        let mut seen = Seen::new(&model, &compiled);
        for _ in 0..20 {
            let shaft = dice.between(-7.0, 7.0);
            let [pressure, curvature] = seen.contact(shaft);
            let found = contact.at(shaft);
            let off = [found.pressure - pressure, found.curvature - curvature];
            assert!(
                off[0].abs() < 1e-7 && off[1].abs() < 1e-6,
                "{text} at {shaft}: {found:?}, off by {off:?}"
            );
        }
    }
}

/// The greatest pressure angle and curvature in a turn, by the places of the roller.
fn greatest(text: &str) -> [f64; 2] {
    let model = model(text);
    let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{text}: {wrong:?}"));
    let mut seen = Seen::new(&model, &compiled);
    let mut greatest = [0.0_f64; 2];
    for number in 0..720 {
        let shaft = f64::from(number) * TAU / 720.0;
        for (most, found) in greatest.iter_mut().zip(seen.contact(shaft)) {
            *most = most.max(found);
        }
    }
    greatest
}

#[test]
fn contacts_are_proved_up_to_their_extremes() {
    for seed in seeds(30) {
        let [pressure, curvature] = greatest(&text(&mut Dice::new(seed), ""));
        // No follower is pressed straight across its way: that is where an angle has a corner.
        if pressure > 1.4 {
            continue;
        }
        for (word, most) in [("pressure", pressure), ("curvature", curvature)] {
            for (factor, holds) in [(1.001, true), (0.999, false)] {
                let most = most * factor;
                let expect = format!("const MOST = {most}; expect max({word}(c)) < MOST;");
                let text = text(&mut Dice::new(seed), &expect);
                let analysis = analyse(text.parse::<TokenStream>().expect("tokens")).prove();
                let said = analysis.result.err().map(|faults| faults.messages[0].text.clone());
                assert_eq!(said.is_none(), holds, "{text}: {said:?}");
                assert!(holds || said.is_some_and(|said| said.contains("does not hold")), "{text}");
            }
        }
    }
}

#[test]
fn contacts_that_a_param_moves_are_not_proved() {
    for (x, is_proved) in [("3", true), ("p", false)] {
        let text = format!(
            "struct M; param p = 3; link disk; link lever {{ point foot = ({x}, 0); }}
            joint s = revolute(ground, disk) at (0, 0); joint f = prismatic(ground, lever) at (3, 0) along (1, 0);
            joint c = cam(s, f, rise 1 over 2, return over 2, dwell) roller lever.foot radius 0.5; motor s;
            expect pressure(c) < 60 deg;"
        );
        let analysis = analyse(text.parse::<TokenStream>().expect("tokens")).prove();
        let said = analysis.result.err().map(|faults| faults.messages[0].text.clone());
        assert_eq!(said.is_none(), is_proved, "{said:?}");
        assert!(is_proved || said.is_some_and(|said| said.contains("param `p`")), "{text}");
    }
}
