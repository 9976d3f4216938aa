//! Forces at change points and beside them, against the closed form of a parallelogram: its coupler only shifts, so that it swings as one
//! body of constant inertia.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::program::Forces;
use mech_runtime::Real;
use mech_test_support::{Dice, cases, model, seeds, shuffle};

/// The rate of its motor: what is left of the forces by which links are turned and stopped is nothing.
const RATE: f64 = 3.0;

/// A parallelogram in any position, and what its links weigh.
struct Parallelogram {
    length: f64,
    /// The direction of its ground.
    angle: f64,
    gravity: [f64; 2],
    /// Mass, centre along and across, inertia: of both cranks and the coupler.
    masses: [[f64; 4]; 3],
    /// Whether the motor is between crank and coupler.
    between: bool,
    text: String,
}

impl Parallelogram {
    fn new(dice: &mut Dice, precision: &str) -> Self {
        let size = *dice.pick(&[0.02_f64, 1.0, 300.0]);
        let (length, base) = (size * dice.between(0.5, 2.0), size * dice.between(0.5, 4.0));
        let angle: f64 = *dice.pick(&[0.0, 0.5, 2.0, -2.6]);
        let gravity = [dice.between(-5.0, 5.0), -9.81];
        let mut mass = |length: f64| {
            let mass = dice.between(0.2, 3.0);
            [
                mass,
                length * dice.between(-0.5, 1.0),
                length * dice.between(-0.5, 0.5),
                mass * length * length * 0.1,
            ]
        };
        let masses = [mass(length), mass(length), mass(base)];
        let [a, c, b] = masses
            .map(|[mass, x, y, inertia]| format!("mass {mass} at ({x}, {y}) inertia {inertia};"));
        let (x, y) = (base * angle.cos(), base * angle.sin());
        let mut links = [
            format!("ground {{ point o = (0, 0); point p = ({x}, {y}); }}"),
            format!("link a {{ point o = (0, 0); point q = ({length}, 0); {a} }}"),
            format!("link b {{ point q = (0, 0); point r = ({base}, 0); {b} }}"),
            format!("link c {{ point p = (0, 0); point r = ({length}, 0); {c} }}"),
        ];
        let swapped = dice.once_in(2);
        let joint = |name: &str, first: &str, second: &str| {
            let (first, second) = if swapped && name != "j" && name != "k" {
                (second, first)
            } else {
                (first, second)
            };
            format!("joint {name} = revolute({first}, {second});")
        };
        let mut joints = [
            joint("j", "ground.o", "a.o"),
            joint("k", "a.q", "b.q"),
            joint("l", "b.r", "c.r"),
            joint("m", "ground.p", "c.p"),
        ];
        shuffle(&mut links, dice);
        shuffle(&mut joints, dice);
        // Between two links, single precision does not keep positions on their branch.
        let between = dice.once_in(2) && precision == "f64";
        let (b, a) = (angle.to_degrees(), angle.to_degrees() + 60.0);
        let motor = if between {
            "motor k; start { k = -60 deg;"
        } else {
            "motor j; start { j = START deg;"
        };
        let motor = motor.replace("START", &a.to_string());
        let [gx, gy] = gravity;
        let text = format!(
            "struct Flat: {precision}; {} {} {motor} a near {a} deg; b near {b} deg; c near {a} deg; }}
            gravity ({gx}, {gy}); effects {{ force; dynamics; }}",
            links.concat(),
            joints.concat()
        );
        Self { length, angle, gravity, masses, between, text }
    }

    /// The reduced inertia, and the torque of gravity on the crank at an angle.
    fn swings(&self, crank: f64) -> [f64; 2] {
        let [first, second, coupler] = self.masses;
        let mut inertia = coupler[0] * self.length * self.length;
        let (mut along, mut across) = (coupler[0] * self.length, 0.0);
        for [mass, x, y, own] in [first, second] {
            inertia += own + mass * (x * x + y * y);
            (along, across) = (along + mass * x, across + mass * y);
        }
        let (sin, cos) = crank.sin_cos();
        let [x, y] = self.gravity;
        let torque = x * (-sin * along - cos * across) + y * (cos * along - sin * across);
        [inertia, torque]
    }

    /// The worst error of torque and inertia there, by their greatest sizes, of a machine that goes over both change points.
    fn error<T: Real>(&self) -> f64 {
        let compiled =
            compile(&model(&self.text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{}", self.text));
        let (mut worst, mut astray) = (0.0_f64, 0);
        let [holding, inertia] = [&compiled.forced.holding, &compiled.forced.inertia]
            .map(|program| program.as_ref().expect("asked for"));
        let greatest = {
            let [a, b] = [self.angle, self.angle + 1.5].map(|angle| self.swings(angle)[1]);
            a.hypot(b)
        };
        let offsets = [
            0.3, 0.1, 0.03, 0.01, 1e-3, 1e-5, 1e-8, 0.0, -1e-9, -1e-6, -1e-4, -0.004, -0.02, -0.15,
            -0.4,
        ];
        let places = [0.0, -std::f64::consts::PI];
        for (flat, offset) in
            places.into_iter().flat_map(|flat| offsets.map(|offset| (flat, offset)))
        {
            let crank = T::from_f64(self.angle + flat + offset);
            let sign = if self.between { -1.0 } else { 1.0 };
            let motor = if self.between { T::from_f64(-flat - offset) } else { crank };
            let mut machine = Machine::<T>::new(&compiled.program);
            let from = machine.position().motors[0];
            for part in 1..=8 {
                let part = T::from_f64(f64::from(part) / 8.0);
                machine.move_to(&[from + (motor - from) * part]).expect("it turns");
            }
            let coupler =
                compiled.program.links.iter().position(|name| name == "b").expect("it is there");
            let pose = machine.position().poses[coupler].map(Real::to_f64);
            let turned = (pose[0] - self.angle.cos()).hypot(pose[1] - self.angle.sin());
            // Where positions are is judged elsewhere.
            if turned > 16.0 * T::EPSILON.sqrt() {
                println!("{:e}: astray by {turned:e} at {offset}", T::EPSILON);
                astray += 1;
                continue;
            }
            let [own, torque] = self.swings(if self.between {
                self.angle - motor.to_f64()
            } else {
                motor.to_f64()
            });
            let at = |program| {
                let mut there = Machine::<T>::new(program);
                there.put_back(machine.position().clone());
                there
                    .forces(&[T::from_f64(RATE)], &[T::ZERO], &[])
                    .unwrap_or_else(|stop| panic!("{stop:?} at {offset}: {}", self.text))
            };
            let found = match (at(holding), at(inertia)) {
                (Forces::Holding(holding), Forces::Inertia(inertia)) => [
                    (-holding[0].to_f64() * sign - torque) / greatest,
                    (inertia.drive[0].to_f64() * sign - torque) / (greatest + own * RATE * RATE),
                    inertia.matrix[0][0].to_f64() / own - 1.0,
                ],
                _ => panic!("other forces"),
            };
            for error in found {
                worst = worst.max(error.abs());
            }
        }
        assert!(2 * astray < offsets.len(), "{astray}: {}", self.text);
        worst
    }
}

#[test]
fn forces_pass_change_points_as_positions_do() {
    let mut worst = [0.0_f64; 2];
    for seed in seeds(cases(12)) {
        let mut dice = Dice::new(seed);
        let double = Parallelogram::new(&mut dice, "f64").error::<f64>();
        let single = Parallelogram::new(&mut dice, "f32").error::<f32>();
        worst = [worst[0].max(double), worst[1].max(single)];
    }
    println!("off by {:e} in f64, {:e} in f32", worst[0], worst[1]);
    assert!(worst[0] < 1e-8, "{worst:?}");
    assert!(worst[1] < 2e-4, "{worst:?}");
}
