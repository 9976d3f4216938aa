//! `mech rest`, against energies that are computed from what was declared.

use crate::run::Folder;
use mech_test_support::{Dice, cases, seeds, valley};

type Vector = [f64; 2];

const GRAVITY: f64 = 9.81;

/// A lamp of two links, held up by a spring and by a torsional one.
struct Lamp {
    lengths: [f64; 2],
    masses: [f64; 2],
    centers: [Vector; 2],
    hook: Vector,
    stiffness: [f64; 2],
    rests: [f64; 2],
    start: [f64; 2],
}

impl Lamp {
    fn new(dice: &mut Dice) -> Self {
        let mut number = |low: f64, high: f64| dice.between(low, high);
        Self {
            lengths: [number(1.0, 3.0), number(1.0, 3.0)],
            masses: [number(0.1, 1.0), number(0.1, 1.0)],
            centers: [[number(0.0, 2.0), number(-0.5, 0.5)], [number(0.0, 2.0), number(-0.5, 0.5)]],
            hook: [number(-2.0, 2.0), number(1.0, 4.0)],
            stiffness: [number(1.0, 20.0), number(5.0, 40.0)],
            rests: [number(0.1, 2.0), number(-0.5, 0.5)],
            start: [number(-1.0, 2.0), number(-0.5, 0.5)],
        }
    }

    fn text(&self) -> String {
        let [[x, y], [u, v]] = self.centers;
        format!(
            "struct Lamp; gravity (0, -{GRAVITY});
            ground {{ point o = (0, 0); point hook = ({}, {}); }}
            link lower {{ point o = (0, 0); point elbow = ({}, 0); mass {} at ({x}, {y}); }}
            link upper {{ point elbow = (0, 0); mass {} at ({u}, {v}); point tip = ({}, 0); }}
            joint a = revolute(ground.o, lower.o); joint b = revolute(lower.elbow, upper.elbow);
            motor a; motor b; start {{ a = {}; b = {}; }}
            spring s = linear(ground.hook, lower.elbow) stiffness {} rest {};
            spring t = torsional(b) stiffness {} rest {};",
            self.hook[0],
            self.hook[1],
            self.lengths[0],
            self.masses[0],
            self.masses[1],
            self.lengths[1],
            self.start[0],
            self.start[1],
            self.stiffness[0],
            self.rests[0],
            self.stiffness[1],
            self.rests[1],
        )
    }

    fn energy(&self, [a, b]: Vector) -> f64 {
        let turned = |angle: f64, [x, y]: Vector| {
            let (sin, cos) = angle.sin_cos();
            [cos * x - sin * y, sin * x + cos * y]
        };
        let elbow = turned(a, [self.lengths[0], 0.0]);
        let heights = [turned(a, self.centers[0])[1], elbow[1] + turned(a + b, self.centers[1])[1]];
        let weights: f64 =
            self.masses.iter().zip(heights).map(|(mass, height)| mass * GRAVITY * height).sum();
        let stretch = (elbow[0] - self.hook[0]).hypot(elbow[1] - self.hook[1]) - self.rests[0];
        let twist = b - self.rests[1];
        weights
            + 0.5 * self.stiffness[0] * stretch * stretch
            + 0.5 * self.stiffness[1] * twist * twist
    }
}

/// The values of motors that are told, in degrees or scene units.
fn values_told(text: &str) -> Vec<f64> {
    let lines = text.lines().filter(|line| line.starts_with("  motor "));
    let values = lines.map(|line| {
        let (_, value) = line.split_once(" at ").expect("a value");
        let end = value.find([' ', ',']).unwrap_or(value.len());
        value[..end].parse().expect("a number")
    });
    values.collect()
}

#[test]
fn a_lamp_rests_where_its_energy_is_least() {
    for seed in seeds(cases(6)) {
        let mut dice = Dice::new(seed);
        let lamp = Lamp::new(&mut dice);
        let folder = Folder::new().with("a.mech", lamp.text());
        let [a, b] = values_told(&folder.mech("rest a.mech").done())[..] else {
            panic!("seed {seed}");
        };
        let here = [a.to_radians(), b.to_radians()];
        let least = lamp.energy(here);
        assert!(least <= lamp.energy(lamp.start), "seed {seed}");
        // As far as the digits go, every way leads upwards.
        for way in 0..32 {
            let (sin, cos) = (0.2 * f64::from(way)).sin_cos();
            let beside = [here[0] + 1e-3 * cos, here[1] + 1e-3 * sin];
            assert!(lamp.energy(beside) > least, "seed {seed}, {way}");
        }
    }
}

#[test]
fn a_pendulum_on_a_slider_crank_rests_in_the_nearest_valley() {
    for seed in seeds(cases(6)) {
        let mut dice = Dice::new(seed);
        let (crank, rod) = (dice.between(0.5, 1.0), dice.between(2.0, 3.0));
        let (mass, stiffness) = (dice.between(0.1, 2.0), dice.between(1.0, 30.0));
        let (rest, start) = (dice.between(1.0, 4.0), dice.between(-3.0, 3.0));
        let text = format!(
            "struct M; gravity (0, -{GRAVITY}); ground {{ line rail = (0, 0) -> (1, 0); point o = (0, 0); }}
            link crank {{ point o = (0, 0); point p = ({crank}, 0); mass {mass} at ({crank}, 0); }}
            link rod {{ point p = (0, 0); point q = ({rod}, 0); }} link piston {{ line rail = (0, 0) -> (1, 0); point q = (0, 0); }}
            joint a = revolute(ground.o, crank.o); joint b = revolute(rod.p, crank.p); joint c = revolute(rod.q, piston.q);
            joint x = prismatic(ground.rail, piston.rail); motor a; start {{ a = {start}; rod near {}; }}
            spring s = linear(ground.o, piston.q) stiffness {stiffness} rest {rest};",
            -(crank * start.sin() / rod).asin()
        );
        let energy = |angle: f64| {
            let across = crank * angle.sin();
            let place = crank * angle.cos() + (rod * rod - across * across).sqrt();
            mass * GRAVITY * across + 0.5 * stiffness * (place - rest).powi(2)
        };
        let here = valley(energy, start);
        let folder = Folder::new().with("a.mech", &text);
        let found = values_told(&folder.mech("rest a.mech").done())[0].to_radians();
        assert!((found - here).abs() < 3e-4, "seed {seed}: {found}, {here}");
    }
}

#[test]
fn what_is_held_stays_and_what_is_pulled_leans() {
    let lamp = |motor: &str| {
        format!(
            "struct Bob; gravity (0, -10); ground {{ point o = (0, 0); }} link bob {{ point o = (0, 0); mass 2 at (3, 0); }}
            joint a = revolute(ground.o, bob.o); {motor} load push = torque(bob); effects {{ force; }}"
        )
    };
    let folder = Folder::new()
        .with("free.mech", lamp("motor a; start { a = 90 deg; }"))
        .with("ends.mech", lamp("motor a in -60 deg ..= 90 deg;"))
        .with("led.mech", lamp("motor a = 0.1 * t;"))
        .with(
            "idle.mech",
            "struct M; link bar; joint a = revolute(ground, bar) at (0, 0); motor a;",
        );
    // Upright it does not stay.
    assert_eq!(values_told(&folder.mech("rest free.mech").done())[0].rem_euclid(360.0), 270.0);
    // The weight turns by 2 · 10 · 3 · cos 60 deg.
    let text = folder.mech("rest ends.mech").done();
    assert!(text.contains("at -60 deg, its end, against which it leans with 30"), "{text}");
    // Three quarters of the weight.
    let text = folder.mech("rest ends.mech --load push=45").done();
    assert!((values_told(&text)[0] + 0.75_f64.acos().to_degrees()).abs() < 1e-4, "{text}");
    for (words, code, why) in [
        ("rest led.mech", 2, "every motor is held"),
        ("rest free.mech --at a=10", 2, "every motor is held"),
        ("rest free.mech --at b=10", 2, "no motor `b`"),
        ("rest free.mech --load pull=1", 2, "no load `pull`"),
        ("rest idle.mech", 1, "nothing pulls"),
        ("rest free.mech --load push=1000", 1, "does not come to rest"),
    ] {
        let told = folder.mech(words).refused(code);
        assert!(told.contains(why), "{words}: {told}");
    }
}
