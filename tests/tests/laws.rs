//! Laws of motors: their values and rates against other ways of finding them, and mechanisms that are moved by the time alone.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{
    Arithmetic, BinaryFunction, Effects, FormulaArithmetic, Function, Law, Method, Model, Now,
    ParamId, Precision,
};
use mech_compiler::program::{Timing, build_timing};
use mech_runtime::Cause;
use mech_tests::{Dice, differences, grow, size};

fn cases() -> u64 {
    mech_tests::cases(200)
}

/// A random expression in `t` that is smooth wherever it has a value.
fn smooth(dice: &mut Dice, depth: u32) -> String {
    if depth == 0 {
        return match dice.below(3) {
            0 => format!("{:.3}", dice.between(-2.0, 2.0)),
            _ => "t".to_owned(),
        };
    }
    let mut part = || smooth(dice, depth - 1);
    let (a, b) = (part(), part());
    match dice.below(16) {
        0 | 1 => format!("({a} + {b})"),
        2 => format!("({a} - {b})"),
        3 | 4 => format!("{a} * ({b})"),
        5 => format!("({a}) / (2 + ({b}) * ({b}))"),
        6 => format!("sqrt(1 + ({a}) * ({a}))"),
        7 => format!("sin({a})"),
        8 => format!("cos({a} - 30 deg)"),
        9 => format!("atan({a})"),
        10 => format!("exp(-({a}) * ({a}))"),
        11 => format!("asin(0.9 * sin({a}))"),
        12 => format!("acos(-0.8 * cos({a}))"),
        13 => format!("atan2({a}, 1 + ({b}) * ({b}))"),
        14 => format!("hypot(1 + ({a}) * ({a}), {b})"),
        _ => format!("-tan(0.3 * sin({a}))"),
    }
}

/// The same with corners in it.
fn cornered(dice: &mut Dice, depth: u32) -> String {
    let (a, b) = (smooth(dice, depth), smooth(dice, depth));
    match dice.below(6) {
        0 => format!("max({a}, {b})"),
        1 => format!("{a} + min(0.5, {b})"),
        2 => format!("abs({a}) * ({b})"),
        3 => format!("floor({a}) * ({b})"),
        4 => format!("mod({a}, 1.5 + sin({b}))"),
        _ => format!("sign({a}) + {b}"),
    }
}

const EFFECTS: Effects = Effects {
    force: false,
    dynamics: false,
    overlay: false,
    sensitivity: false,
    velocity: true,
    acceleration: true,
};

/// A mechanism of one motor with this law.
fn model(law: &str) -> Model {
    let text = format!(
        "struct M; ground {{ point o = (0, 0); }} link crank {{ point o = (0, 0); }}
        joint a = revolute(ground.o, crank.o); motor a = {law};"
    );
    let mut model = mech_tests::model(&text);
    model.effects = EFFECTS;
    model
}

fn timing(model: &Model) -> Timing {
    build_timing(model).expect("a motor has a law")
}

/// The greatest size of anything from which a law is computed.
fn extent(law: &Law, time: f64) -> f64 {
    let params = &[];
    let sizes = law.formulas().evaluate(&mut Now {
        variable: time,
        params,
    });
    sizes.iter().map(|size| size.abs()).fold(1.0, f64::max)
}

fn five(at: impl Fn(f64) -> f64, time: f64, step: f64) -> [f64; 5] {
    [-2.0, -1.0, 0.0, 1.0, 2.0].map(|number| at(time + number * step))
}

#[test]
fn rates_of_random_laws_are_their_derivatives() {
    const STEP: f64 = 1e-3;
    let (mut compared, mut worst) = (0, 0.0_f64);
    for seed in mech_tests::seeds(5 * cases()) {
        let mut dice = Dice::new(seed);
        let depth = 1 + u32::try_from(dice.below(4)).expect("small");
        let text = smooth(&mut dice, depth);
        let model = model(&text);
        let (law, timing) = (&model.laws[0], timing(&model));
        for _ in 0..5 {
            let time = dice.between(-3.0, 3.0);
            let [value, rate, second] = timing.at(time, &[])[0];
            let direct = law.at(time, &[]);
            let scale = extent(law, time);
            assert!(
                (value - direct).abs() <= 1e-12 * scale * (1.0 + rate.abs()),
                "{text} at {time}: {value}, {direct}"
            );
            let near = differences(five(|time| law.at(time, &[]), time, STEP), STEP);
            let far = differences(five(|time| law.at(time, &[]), time, 2.0 * STEP), 2.0 * STEP);
            for (order, exact) in [(0, rate), (1, second)] {
                let truncation = (near[order] - far[order]).abs();
                let power = i32::try_from(order).expect("small") + 1;
                let most = truncation + 1e-14 * scale / STEP.powi(power) + 1e-9 * exact.abs();
                let off = (near[order] - exact).abs();
                assert!(
                    off <= most,
                    "{text} at {time}, order {order}: {exact}, {} by differences, explained {most:e}",
                    near[order]
                );
                worst = worst.max(off / most);
                compared += 1;
            }
        }
    }
    println!("{compared} compared, worst {worst}");
    assert!(compared > 10 * cases());
}

/// What a law is, to second order, in another arithmetic: Taylor's.
#[derive(Clone, Copy, Debug)]
struct Jet([f64; 3]);

impl Jet {
    fn product(self, other: Self) -> Self {
        let (Self([a, b, c]), Self([p, q, r])) = (self, other);
        Self([a * p, a * q + b * p, a * r + 2.0 * b * q + c * p])
    }

    /// A function of it, by its value and its first two derivatives there.
    fn through(self, [value, first, second]: [f64; 3]) -> Self {
        let Self([_, b, c]) = self;
        Self([value, first * b, second * b * b + first * c])
    }

    fn plus(self, other: Self, sign: f64) -> Self {
        Self(std::array::from_fn(|order| {
            self.0[order] + sign * other.0[order]
        }))
    }
}

/// What gives the jet of a law at a time.
struct At(f64);

impl Arithmetic for At {
    type Scalar = Jet;

    fn constant(&mut self, value: f64) -> Jet {
        Jet([value, 0.0, 0.0])
    }

    fn neg(&mut self, Jet(a): Jet) -> Jet {
        Jet(a.map(|part| -part))
    }

    fn add(&mut self, a: Jet, b: Jet) -> Jet {
        a.plus(b, 1.0)
    }

    fn sub(&mut self, a: Jet, b: Jet) -> Jet {
        a.plus(b, -1.0)
    }

    fn mul(&mut self, a: Jet, b: Jet) -> Jet {
        a.product(b)
    }

    fn div(&mut self, a: Jet, b: Jet) -> Jet {
        let below = b.0[0];
        let inverse = [1.0 / below, -below.powi(-2), 2.0 * below.powi(-3)];
        a.product(b.through(inverse))
    }
}

impl FormulaArithmetic for At {
    fn variable(&mut self) -> Jet {
        Jet([self.0, 1.0, 0.0])
    }

    fn param(&mut self, _: ParamId) -> Jet {
        unreachable!("no law here has a param")
    }

    fn of(&mut self, function: Function, a: Jet) -> Jet {
        let x = a.0[0];
        a.through(match function {
            Function::Sqrt => [x.sqrt(), 0.5 / x.sqrt(), -0.25 / (x * x.sqrt())],
            Function::Sin => [x.sin(), x.cos(), -x.sin()],
            Function::Cos => [x.cos(), -x.sin(), -x.cos()],
            Function::Tan => {
                let first = 1.0 + x.tan() * x.tan();
                [x.tan(), first, 2.0 * x.tan() * first]
            }
            Function::Asin | Function::Acos => {
                let first = (1.0 - x * x).sqrt().recip();
                let second = x * first.powi(3);
                if function == Function::Asin {
                    [x.asin(), first, second]
                } else {
                    [x.acos(), -first, -second]
                }
            }
            Function::Atan => {
                let first = 1.0 / (1.0 + x * x);
                [x.atan(), first, -2.0 * x * first * first]
            }
            Function::Exp => [x.exp(); 3],
            Function::Abs => [x.abs(), x.signum(), 0.0],
            Function::Floor => [x.floor(), 0.0, 0.0],
            Function::Sign => [x.signum(), 0.0, 0.0],
        })
    }

    fn of_both(&mut self, function: BinaryFunction, a: Jet, b: Jet) -> Jet {
        let (x, y) = (a.0[0], b.0[0]);
        match function {
            BinaryFunction::Min if x > y => b,
            BinaryFunction::Max if x <= y => b,
            BinaryFunction::Min | BinaryFunction::Max => a,
            BinaryFunction::Atan2 => {
                let angle = x.atan2(y);
                let square = a.product(a).plus(b.product(b), 1.0);
                let (s, [_, ds, _]) = (square.0[0], square.0);
                let rate = (a.0[1] * y - b.0[1] * x) / s;
                let change = a.0[2] * y - b.0[2] * x;
                Jet([angle, rate, change / s - rate * ds / s])
            }
            BinaryFunction::Hypot => {
                let square = a.product(a).plus(b.product(b), 1.0);
                let root = square.0[0].sqrt();
                square.through([root, 0.5 / root, -0.25 / (root * square.0[0])])
            }
            BinaryFunction::Mod => {
                let times = Jet([(x / y).floor(), 0.0, 0.0]);
                let Jet([_, first, second]) = a.plus(b.product(times), -1.0);
                Jet([x - y * (x / y).floor(), first, second])
            }
        }
    }
}

fn jet(law: &Law, time: f64) -> Jet {
    law.evaluate(&mut At(time))
}

#[test]
fn laws_with_corners_have_the_rates_of_the_side_they_are_on() {
    let mut compared = 0;
    for seed in mech_tests::seeds(5 * cases()) {
        let mut dice = Dice::new(seed);
        let depth = u32::try_from(dice.below(4)).expect("small");
        let text = cornered(&mut dice, depth);
        let model = model(&text);
        let (law, timing) = (&model.laws[0], timing(&model));
        for _ in 0..5 {
            let time = dice.between(-3.0, 3.0);
            let (found, Jet(expected)) = (timing.at(time, &[])[0], jet(law, time));
            for order in 0..3 {
                let scale = extent(law, time) * (1.0 + expected[1].abs() + expected[2].abs());
                assert!(
                    (found[order] - expected[order]).abs() <= 1e-9 * scale,
                    "{text} at {time}, order {order}: {} instead of {}",
                    found[order],
                    expected[order]
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 10 * cases());
}

#[test]
fn what_has_no_value_does_not_get_one_from_its_surroundings() {
    for law in [
        "max(0, sqrt(1 - t))",
        "max(sqrt(1 - t), 0)",
        "min(t, sqrt(1 - t))",
        "min(sqrt(1 - t), 0)",
        "0 * sqrt(1 - t) + t",
        "abs(sqrt(1 - t))",
        "asin(t)",
        "acos(-t)",
        "max(0, asin(t))",
        "floor(sqrt(1 - t))",
        "sign(sqrt(1 - t))",
        "mod(sqrt(1 - t), 2)",
        "mod(2, sqrt(1 - t))",
        "hypot(t, sqrt(1 - t))",
        "atan2(2 - t, t * (2 - t))",
    ] {
        let found = timing(&model(law)).at(2.0, &[])[0][0];
        assert_eq!(found.is_nan(), !law.starts_with('0'), "{law}: {found}");
    }
}

/// A random mechanism whose motors all follow smooth laws from where they start.
fn lawful(dice: &mut Dice, seed: u64) -> Model {
    let additions = 1 + dice.below(6);
    let mut model = grow(dice, additions).model;
    model.effects = EFFECTS;
    model.precision = Precision::F64;
    if seed.is_multiple_of(3) {
        model.method = Some(Method::Newton);
    }
    for motor in 0..model.motors.len() {
        let (speed, pace) = (dice.between(-0.7, 0.7), dice.between(0.3, 1.5));
        let start = model.start.value(model.motors[motor].joint);
        let text = match dice.below(3) {
            0 => format!("{start} + {speed} * sin({pace} * t)"),
            1 => format!("{start} + {speed} * t / (1 + t * t)"),
            _ => format!("{start} + {speed} * (1 - exp(-t * t))"),
        };
        model.motors[motor].law = Some(mech_compiler::model::LawId::new(model.laws.len()));
        model.laws.push(mech_tests::law(&text));
    }
    model
}

#[test]
fn velocities_in_time_are_those_of_positions_in_time() {
    const STEP: f64 = 1e-3;
    let mut compared = 0;
    for seed in mech_tests::seeds(cases()) {
        let mut dice = Dice::new(seed);
        let model = lawful(&mut dice, seed);
        let Ok(compiled) = compile(&model) else {
            continue;
        };
        let (moving, timing) = (
            compiled.moving.expect("velocities were asked for"),
            compiled.timing.expect("motors have laws"),
        );
        let values = |time: f64| -> Vec<f64> {
            timing
                .at(time, &[])
                .iter()
                .map(|[value, ..]| *value)
                .collect()
        };
        for _ in 0..4 {
            let time = dice.between(0.1, 1.0);
            let mut machine = Machine::<f64>::new(&moving);
            if machine.move_to(&values(time)).is_err() {
                continue;
            }
            let at = timing.at(time, &[]);
            let rates: Vec<f64> = at.iter().map(|[_, rate, _]| *rate).collect();
            let seconds: Vec<f64> = at.iter().map(|[.., second]| *second).collect();
            let Ok(found) = machine.motion(&rates, &seconds) else {
                continue;
            };
            let there = machine.position().clone();
            let place = |time: f64| {
                let mut machine = Machine::<f64>::new(&moving);
                machine.put_back(there.clone());
                machine.move_to(&values(time)).ok()?;
                Some(machine.position().poses.clone())
            };
            let sampled = |step: f64| -> Option<Vec<_>> {
                (-2..=2)
                    .map(|number| place(time + f64::from(number) * step))
                    .collect()
            };
            let (Some(fine), Some(coarse)) = (sampled(STEP), sampled(2.0 * STEP)) else {
                continue;
            };
            let accelerations = found.accelerations.expect("accelerations were asked for");
            for link in 0..moving.links.len() {
                for (number, part) in [(1, 2), (2, 3)] {
                    let of = |poses: &Vec<Vec<[f64; 4]>>, step| {
                        differences(std::array::from_fn(|index| poses[index][link][part]), step)
                    };
                    let (near, far) = (of(&fine, STEP), of(&coarse, 2.0 * STEP));
                    let exact = [found.velocities[link][number], accelerations[link][number]];
                    for order in 0..2 {
                        let reach = size(&model) + there.poses[link][part].abs() + 1.0;
                        let power = i32::try_from(order).expect("small") + 1;
                        let most =
                            (near[order] - far[order]).abs() + 1e-12 * reach / STEP.powi(power);
                        let off = (near[order] - exact[order]).abs();
                        assert!(
                            off <= most,
                            "seed {seed}, link {link}, order {order}: {} instead of {}, explained {most:e}",
                            exact[order],
                            near[order]
                        );
                        compared += 1;
                    }
                }
            }
        }
    }
    println!("{compared} compared");
    assert!(compared > 10 * cases());
}

mod generated {
    use mech_runtime::mechanism;

    mechanism! {
        /// A four-bar that is driven at an even speed, with an arm that swings on its coupler.
        pub struct FourBar;
        const SPEED = 1.5;
        link crank; link coupler; link rocker; link arm { point tip = (3.5, 4); }
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.8, 0.6);
        joint c = revolute(coupler, rocker) at (3.3, 2.9);
        joint d = revolute(ground, rocker) at (4, 0);
        joint e = revolute(coupler, arm) at (2, 3);
        motor a = SPEED * t;
        motor e = 0.3 * sin(2 * t) * exp(-0.1 * t);
        effects { velocity; acceleration; }
    }

    mechanism! {
        /// The same without effects, and with a motor that has no law.
        pub struct Plain;
        link crank; link coupler; link rocker; link arm { point tip = (3.5, 4); }
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.8, 0.6);
        joint c = revolute(coupler, rocker) at (3.3, 2.9);
        joint d = revolute(ground, rocker) at (4, 0);
        joint e = revolute(coupler, arm) at (2, 3);
        motor a = 1.5 * t;
        motor e;
    }

    mechanism! {
        /// A slide that stops being anywhere when the time is one.
        pub struct Ending;
        ground { line rail = (0, 0) -> (1, 0); point o = (0, 0); }
        link cart { line rail = (0, 0) -> (1, 0); }
        link wheel { point o = (0, 0); }
        joint x = prismatic(ground.rail, cart.rail);
        joint w = revolute(ground.o, wheel.o);
        motor x = sqrt(1 - t);
        motor w = 1 / (t - 3) + 2 * t;
        effects { velocity; }
    }

    mechanism! {
        /// A wheel in single precision, whose motor turns fifty times a second, and another geared to it.
        pub struct Fast: f32;
        ground { point o = (0, 0); point p = (3, 0); }
        link wheel { point o = (0, 0); }
        link other { point o = (0, 0); }
        joint w = revolute(ground.o, wheel.o);
        joint v = revolute(ground.p, other.o);
        joint mesh = gear(wheel, other, 20 : 40);
        motor w = 2 * PI * 50 * t;
        effects { velocity; }
    }

    mechanism! {
        /// A motor that must not leave its range.
        pub struct Ranged;
        ground { point o = (0, 0); }
        link wheel { point o = (0, 0); }
        joint w = revolute(ground.o, wheel.o);
        motor w = 2 * sin(t) in -1 ..= 1;
    }

    mechanism! {
        /// A motor that stays where it is.
        pub struct Still;
        ground { point o = (0, 0); }
        link wheel { point o = (0, 0); }
        joint w = revolute(ground.o, wheel.o);
        motor w = 0.25;
    }
}

#[test]
fn the_time_gives_motors_the_values_of_their_laws() {
    let source = include_str!("laws.rs");
    let (_, compiled) = mech_tests::mechanisms(source).swap_remove(0);
    let timing = compiled.timing.expect("motors have laws");
    let (mut timed, mut given) = (generated::FourBar::new(), generated::FourBar::new());
    for step in 0..500 {
        let time = f64::from(step) * 0.01;
        let at = timing.at(time, &[]);
        let [values, rates, seconds] = [0, 1, 2].map(|part| [at[0][part], at[1][part]]);
        timed.at_time(time).expect("it moves");
        given.move_with(values, rates, seconds).expect("it moves");
        assert_eq!(timed, given);
    }
}

#[test]
fn without_effects_it_moves_as_if_it_were_told_the_values() {
    let (mut timed, mut given) = (generated::Plain::new(), generated::Plain::new());
    timed.move_to([0.0, 0.4]).expect("it moves");
    for step in 0..500 {
        let time = f64::from(step) * 0.01;
        timed.at_time(time).expect("it moves");
        given.move_to([1.5 * time, 0.4]).expect("it moves");
        assert_eq!(timed, given);
    }
}

#[test]
fn accelerations_in_time_are_those_of_a_point() {
    const STEP: f64 = 1e-3;
    let tip = |time: f64| {
        let mut four_bar = generated::FourBar::new();
        four_bar.at_time(time).expect("it moves");
        four_bar.arm_tip()
    };
    for step in 1..50 {
        let time = f64::from(step) * 0.1;
        let mut four_bar = generated::FourBar::new();
        four_bar.at_time(time).expect("it moves");
        let (velocity, acceleration) =
            (four_bar.arm_tip_velocity(), four_bar.arm_tip_acceleration());
        let x = differences(five(|time| tip(time).x, time, STEP), STEP);
        let y = differences(five(|time| tip(time).y, time, STEP), STEP);
        assert!((velocity.x - x[0]).abs() < 1e-9 && (velocity.y - y[0]).abs() < 1e-9);
        assert!((acceleration.x - x[1]).abs() < 1e-7 && (acceleration.y - y[1]).abs() < 1e-7);
    }
}

#[test]
fn a_law_without_a_value_is_an_error_that_names_its_motor() {
    let mut ending = generated::Ending::new();
    ending.at_time(0.5).expect("it moves");
    let there = ending;
    for (time, place) in [
        (1.5, "x"),
        // The root ends steeply: there is a value, and no rate.
        (1.0, "x"),
        (f64::NAN, "x"),
        (f64::INFINITY, "x"),
        (-1e308 * 10.0, "x"),
    ] {
        let blocked = ending.at_time(time).expect_err("there is no value");
        assert_eq!(
            (blocked.place, blocked.cause),
            (place, Cause::NotFinite),
            "{time}"
        );
        assert_eq!(blocked.reached, there.motors());
        assert_eq!(ending, there);
    }
    ending.at_time(-4.0).expect("it moves");
    assert_eq!(ending.x(), 5.0_f64.sqrt());
    let blocked = ending.at_time(3.0).expect_err("there is no value");
    assert_eq!(blocked.cause, Cause::NotFinite);
}

#[test]
fn single_precision_turns_exactly_for_hours() {
    let mut fast = generated::Fast::new();
    for hour in 1..10 {
        let time = 3600.0 * f64::from(hour) + 0.003;
        fast.at_time(time).expect("it moves");
        let turns = 50.0 * time;
        let angle = std::f64::consts::TAU * (turns - turns.floor());
        let off = f64::from(fast.wheel().rotation.angle()) - angle;
        let off =
            (off + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        assert!(off.abs() < 1e-6, "{off}");
        // The gear has half the turns, and knows which half.
        let half = -std::f64::consts::TAU * (0.5 * turns - (0.5 * turns).floor());
        let off = f64::from(fast.other().rotation.angle()) - half;
        let off =
            (off + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        assert!(off.abs() < 1e-6, "{off}");
        assert_eq!(fast.w_rate(), 314.159_27);
    }
    let blocked = fast.at_time(1e300).expect_err("it is too far");
    assert_eq!((blocked.place, blocked.cause), ("w", Cause::Overflow));
}

#[test]
fn a_law_does_not_lead_out_of_a_range() {
    let mut ranged = generated::Ranged::new();
    ranged.at_time(0.5).expect("it is within its range");
    let blocked = ranged.at_time(1.0).expect_err("it is outside");
    assert_eq!((blocked.place, blocked.cause), ("w", Cause::OutOfRange));
    assert_eq!(blocked.reached, [1.0]);
    assert_eq!(ranged.w(), 2.0 * 0.5_f64.sin());
}

#[test]
fn a_constant_is_a_law_too() {
    let mut still = generated::Still::new();
    assert_eq!(still.w(), 0.25);
    still.move_to([1.0]).expect("it moves");
    still.at_time(7.0).expect("it moves");
    assert_eq!(still.w(), 0.25);
    assert!(still.at_time(f64::NAN).is_err());
}

#[test]
fn the_report_tells_the_laws() {
    assert!(
        generated::FourBar::REPORT.contains(
            "  law       a = SPEED * t\n  law       e = 0.3 * sin(2 * t) * exp(-0.1 * t)\n"
        )
    );
    assert!(generated::FourBar::REPORT.contains("  at time   "));
    assert!(!<generated::Plain as mech_runtime::Mechanism>::REPORT.contains("law       e"));
}
