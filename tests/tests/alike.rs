//! Loops that are alike share a function: the generated code beside the interpreter, bit by bit, where a part stands several times with
//! other numbers, and where alike loops are typed out.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::Model;
use mech_runtime::Real;
use mech_test_support::{
    Dice, chain_text, folder, grow_from, model, part_of, text, uneven_chain_text,
};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

/// How often each mechanism is moved.
const MOVES: usize = 12;

/// The rates of motors, and their second rates.
const RATES: [f64; 2] = [0.75, -0.5];

/// A mechanism, and how it is moved.
pub(crate) struct Case {
    pub(crate) text: String,
    pub(crate) motors: Vec<Vec<f64>>,
}

/// What a mechanism shows after a move.
struct Shown<T> {
    is_ok: bool,
    numbers: Vec<T>,
}

impl<T: Real> Shown<T> {
    /// A number that differs where any bit does.
    fn mixed(&self) -> (bool, u64) {
        let bits = self.numbers.iter().map(|&number| Real::to_f64(number).to_bits());
        (self.is_ok, bits.fold(0, mix))
    }
}

impl Case {
    /// A mechanism that is moved by random steps, now and then by a large one.
    fn new(text: String, dice: &mut Dice) -> Self {
        let mut motors = vec![0.0; model(&text).motors.len()];
        let steps = (0..MOVES).map(|_| {
            let step = if dice.once_in(4) { 1.5 } else { 0.05 };
            for motor in &mut motors {
                *motor += dice.between(-step, step);
            }
            motors.clone()
        });
        let motors = steps.collect();
        Self { text, motors }
    }

    /// A hard case that goes onto its change points, beside and past them, and towards where it cannot go, by one of two methods.
    fn hard(text: String, number: usize) -> Self {
        const VALUES: [f64; 14] =
            [1.0, 2.5, PI, 3.2, PI + 1e-9, 4.0, TAU, 7.5, 40.0, 3.0, -0.5, 0.0, 1e-7, 1.5];
        let method = ["", "method newton;"][number % 2];
        let motors = VALUES.map(|value| vec![value]).to_vec();
        let text = text + method;
        Self { text, motors }
    }

    /// A module that moves the mechanism in the same way and compares.
    pub(crate) fn module<T: Real>(&self, number: usize, kind: &str) -> String {
        let text = self.text.replacen(';', &format!(": {kind};"), 1);
        let (model, motors) = (model(&text), &self.motors);
        let expected = expected::<T>(&model, motors);
        let name = &model.name;
        let (count, [rate, second]) = (model.motors.len(), RATES);
        let (call, rates) = if model.effects.velocity {
            let given = format!("[{rate:?}; {count}], [{second:?}; {count}]");
            (
                format!("move_with(*motors, {given})"),
                "numbers.extend(moved.velocities().iter().flat_map(|rate| [rate.angular, rate.x, rate.y]));
                numbers.extend(moved.accelerations().iter().flat_map(|rate| [rate.angular, rate.x, rate.y]));",
            )
        } else {
            ("move_to(*motors)".to_owned(), "")
        };
        format!(
            "pub mod {kind}_{number} {{
                mech_runtime::mechanism! {{ {text} }}
                const MOTORS: &[[{kind}; {count}]] = &{motors:?};
                const EXPECTED: &[(bool, u64)] = &{expected:?};
                pub fn run() {{
                    let mut moved = {name}::new();
                    for (step, (motors, expected)) in MOTORS.iter().zip(EXPECTED).enumerate() {{
                        let reached = moved.{call}.err().map(|blocked| blocked.reached);
                        let is_ok = reached.is_none();
                        let mut numbers: Vec<{kind}> = reached.into_iter().flatten().collect();
                        numbers.extend(moved.poses().iter().flat_map(|pose| [pose.cos, pose.sin, pose.x, pose.y]));
                        if is_ok {{ {rates} }}
                        let bits = numbers.into_iter().map(|number| f64::from(number).to_bits());
                        assert_eq!((is_ok, bits.fold(0, super::mix)), *expected, \"{kind} {number}, step {{step}}\");
                    }}
                }}
            }}\n"
        )
    }
}

/// What the interpreter shows after each move.
fn expected<T: Real>(model: &Model, motors: &[Vec<f64>]) -> Vec<(bool, u64)> {
    let compiled = compile(model).unwrap_or_else(|_| panic!("{} is coherent", model.name));
    let mut machine = Machine::<T>::new(&compiled.program);
    let steps = motors.iter().map(|motors| {
        let motors: Vec<T> = motors.iter().map(|&motor| T::from_f64(motor)).collect();
        let before = machine.position().clone();
        let mut is_ok = machine.move_to(&motors).is_ok();
        let (mut reached, mut rates) = (Vec::new(), Vec::new());
        if !is_ok {
            let mut toward = machine.clone();
            let _ = toward.move_toward(&motors);
            reached.clone_from(&toward.position().motors);
        }
        if let (true, Some(moving)) = (is_ok, &compiled.moving) {
            let mut moving = Machine::<T>::new(moving);
            moving.put_back(machine.position().clone());
            let given = RATES.map(|rate| vec![T::from_f64(rate); motors.len()]);
            if let Ok(found) = moving.motion(&given[0], &given[1]) {
                rates.extend(found.velocities);
                rates.extend(found.accelerations.into_iter().flatten());
            } else {
                machine.put_back(before);
                (is_ok, reached) = (false, motors);
            }
        }
        let poses = machine.position().poses.iter().flatten();
        let numbers = reached.iter().chain(poses).chain(rates.iter().flatten());
        let numbers = numbers.copied().collect();
        Shown { is_ok, numbers }.mixed()
    });
    steps.collect()
}

/// Numbers that differ in a bit have another mix.
const fn mix(all: u64, bits: u64) -> u64 {
    (all ^ bits).wrapping_mul(0x0100_0000_01b3).rotate_left(17)
}

/// A random mechanism that stands several times, as it is, mirrored and scaled.
fn several(dice: &mut Dice) -> String {
    let additions: Vec<Dice> = (0..=dice.below(5)).map(|_| Dice::new(dice.bits())).collect();
    let (body, motors, _) = part_of(&text(&grow_from(dice, &additions).model));
    let mut text = format!("struct Several;\npart Whole {{\n{body}}}\n");
    for (name, mirrored) in [("plain", ""), ("mirrored", " mirrored")] {
        for copy in 0..2 {
            let (count, scale) = (2 + dice.below(3), dice.between(0.5, 2.0));
            let _ = writeln!(
                text,
                "use {name}_{copy}[{count}]: Whole{mirrored} scaled {scale:?} {{ frame = ground }};"
            );
            for instance in 0..count {
                for motor in &motors {
                    let _ = writeln!(text, "motor {name}_{copy}[{instance}].{motor}");
                }
            }
        }
    }
    text
}

/// A chain of four-bars whose lengths are random, typed out.
fn uneven_chain(dice: &mut Dice) -> String {
    uneven_chain_text(5 + dice.below(6), dice)
}

/// Sliders and rockers on one crank, typed out with random lengths.
fn star(dice: &mut Dice) -> String {
    let mut text =
        "struct Star; link crank; joint j = revolute(ground, crank) at (0, 0); motor j;".to_owned();
    for number in 0..4 + dice.below(6) {
        let (angle, length) = (dice.between(0.0, 6.2), dice.between(3.0, 5.0));
        let pin = [0.5 * angle.cos(), 0.5 * angle.sin()];
        let rod = [pin[0] + length, dice.between(-0.2, 0.2)];
        let _ = write!(
            text,
            "link rod_{number}; link piston_{number};
            joint a_{number} = revolute(crank, rod_{number}) at ({:?}, {:?});
            joint b_{number} = revolute(rod_{number}, piston_{number}) at ({:?}, {:?});
            joint c_{number} = prismatic(ground, piston_{number}) at ({:?}, {:?}) along (1, 0);",
            pin[0], pin[1], rod[0], rod[1], rod[0], rod[1]
        );
    }
    text
}

/// A walker whose legs stand at random phases.
fn walker(dice: &mut Dice) -> String {
    let [left, right] = [0, 0].map(|_| dice.between(0.1, 6.0));
    format!(
        "struct Walker;
        part Leg(phase = 0) {{
            port frame {{ point hip = (-3.8, -0.78); }}
            port crank {{ point pin = (1.5, 0) turned phase; }}
            link rod {{ point pin = (0, 0); point knee = (5, 0); }}
            link shank {{ point pin = (0, 0); point ankle = (6.19, 0); }}
            link thigh {{ point hip = (0, 0); point knee = (4.15, 0); }}
            link shin {{ point hip = (0, 0); point ankle = (3.93, 0); }}
            joint a = revolute(crank.pin, rod.pin);
            joint b = revolute(crank.pin, shank.pin);
            joint c = revolute(frame.hip, thigh.hip);
            joint d = revolute(frame.hip, shin.hip);
            joint e = revolute(rod.knee, thigh.knee);
            joint f = revolute(shank.ankle, shin.ankle);
            start {{ thigh near 106 deg; shin near -36 deg; }}
        }}
        ground {{ point shaft = (0, 0); }}
        link axle {{ point shaft = (0, 0); }}
        joint main = revolute(ground.shaft, axle.shaft);
        motor main;
        use left[4]: Leg(phase = k * 90 deg) {{ frame = ground, crank = axle }};
        use right[5]: Leg(phase = {left:?} + {right:?} * k) mirrored {{ frame = ground, crank = axle }};"
    )
}

#[test]
fn what_is_shared_gives_the_bits_of_the_interpreter() {
    let mut dice = Dice::new(mech_test_support::seeds(16).start);
    let mut cases = vec![Case::new(chain_text(30), &mut dice)];
    let texts = [several, uneven_chain, star, walker];
    let effects = ["", "\neffects { velocity; acceleration; }"];
    for round in 0..usize::try_from(mech_test_support::cases(1)).expect("not so many") {
        for (number, text) in texts.iter().enumerate() {
            // Two rounds try each of them with and without effects.
            let text = text(&mut dice) + effects[(round + number) % 2];
            cases.push(Case::new(text, &mut dice));
        }
    }
    let soft = cases.len();
    let mut hard = folder("hard");
    hard.retain(|case| case.marks("expanded").next().is_some());
    assert!(hard.len() > 12, "{}", hard.len());
    for (number, case) in hard.iter().enumerate() {
        cases.push(Case::hard(case.statements().collect(), number));
    }
    let (mut program, mut calls) = (String::new(), String::new());
    for (number, case) in cases.iter().enumerate() {
        // Of hard cases each has one precision.
        let hard = number.checked_sub(soft).map(|number| number / 2 % 2);
        if hard != Some(1) {
            program += &case.module::<f64>(number, "f64");
            let _ = write!(calls, "f64_{number}::run();");
        }
        if hard != Some(0) {
            program += &case.module::<f32>(number, "f32");
            let _ = write!(calls, "f32_{number}::run();");
        }
    }
    // Optimised, so that several rows are computed at once, but with all checks.
    let flags = ["-C", "opt-level=2", "-C", "debug-assertions"];
    run("alike", &program, &calls, &flags);
}

/// Compiles some modules with these flags, and makes these calls.
#[track_caller]
pub(crate) fn run(name: &str, modules: &str, calls: &str, flags: &[&str]) {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let mut rustc = mech_test_support::rustc(&root);
    let source = root.join(name).with_extension("rs");
    let program = format!(
        "#![allow(dead_code)]
        {modules}
        const fn mix(all: u64, bits: u64) -> u64 {{ (all ^ bits).wrapping_mul(0x0100_0000_01b3).rotate_left(17) }}
        fn main() {{ {calls} }}"
    );
    fs::write(&source, program).expect("a file");
    let status = rustc.args(flags).arg(&source).status();
    assert!(status.expect("the compiler runs").success(), "they compile");
    let status = Command::new(root.join(name)).status();
    assert!(status.expect("a program").success(), "they move");
}
