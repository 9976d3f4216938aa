//! Motion under forces, against numbers nobody here made and against what mechanics says: energy, exact periods, other ways to
//! write the equations of motion.
#![allow(
    clippy::approx_constant,
    clippy::excessive_precision,
    reason = "numbers are as they were published"
)]

use super::literature::Andrews;
use mech_runtime::{Cause, GaussLegendre};
use std::f64::consts::{PI, TAU};

include!(concat!(env!("OUT_DIR"), "/dynamics.rs"));

#[test]
fn andrews_squeezer_is_where_the_literature_says_after_three_hundredths_of_a_second() {
    let mut squeezer = Andrews::new();
    let first = squeezer.motor_accelerations([0.033]).expect("regular")[0];
    assert!((first / 14_222.443_919_954_138_7 - 1.0).abs() < 1e-9, "{first}");
    let steps = 6000;
    for _ in 0..steps {
        squeezer
            .simulate_by(GaussLegendre::Order6, 0.03 / f64::from(steps), [0.033])
            .expect("it turns");
    }
    let [beta] = squeezer.motors();
    println!(
        "beta {:e}, rate {:e}",
        beta - 15.810_771_196_299_04,
        squeezer.rates()[0] / 1_139.920_302_151_208 - 1.0
    );
    // The literature's own tolerance is 1e-7 relative for velocities and 1e-5 for accelerations.
    assert!((beta - 15.810_771_196_299_04).abs() < 1e-7, "{beta}");
    let relative = |found: f64, published: f64, tolerance: f64| {
        assert!((found / published - 1.0).abs() < tolerance, "{found}, not {published}");
    };
    relative(squeezer.beta_rate(), 1_139.920_302_151_208, 1e-7);
    relative(squeezer.theta_rate(), -1_424.379_294_994_111, 1e-7);
    relative(squeezer.gamma_rate(), 11.032_912_219_371_34, 1e-6);
    relative(squeezer.delta_rate(), 0.573_569_928_479_080_8, 1e-5);
    relative(squeezer.beta_acceleration(), -24_631.763_169_451_96, 1e-5);
    relative(squeezer.phi_acceleration(), 566_749.364_517_621_3, 1e-5);
}

/// The complete elliptic integral of the first kind by the arithmetic-geometric mean of Gauss.
fn quarter_period(modulus: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - modulus * modulus).sqrt());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

#[test]
fn a_pendulum_keeps_the_time_that_elliptic_integrals_tell() {
    // From 120 degrees, let go; after a quarter of a period it is at the bottom.
    let amplitude = TAU / 3.0;
    let quarter = quarter_period((amplitude / 2.0).sin()) * (1.5_f64 / 9.81).sqrt();
    for (method, tolerance) in [
        (GaussLegendre::Order2, 2e-4),
        (GaussLegendre::Order4, 1e-8),
        (GaussLegendre::Order6, 1e-12),
    ] {
        let mut pendulum = Pendulum::new();
        pendulum.move_to([amplitude - PI / 2.0]).expect("free");
        for _ in 0..200 {
            pendulum.simulate_by(method, quarter / 200.0, [0.0]).expect("free");
        }
        let error = (pendulum.motors()[0] + PI / 2.0).abs();
        println!("{method:?}: {error:e}");
        assert!(error < tolerance, "{method:?}: {error:e}");
    }
}

#[test]
fn the_orders_of_the_methods_are_those_of_gauss() {
    let after = |method, steps: i32| {
        let mut pendulum = Pendulum::new();
        pendulum.set_rates([3.0]).expect("finite");
        for _ in 0..steps {
            pendulum.simulate_by(method, 2.0 / f64::from(steps), [0.5]).expect("free");
        }
        pendulum.motors()[0]
    };
    let exact = after(GaussLegendre::Order6, 4000);
    for (method, steps, order) in [
        (GaussLegendre::Order2, 100, 2),
        (GaussLegendre::Order4, 50, 4),
        (GaussLegendre::Order6, 20, 6),
    ] {
        let [coarse, fine] = [steps, 2 * steps].map(|steps| (after(method, steps) - exact).abs());
        let measured = (coarse / fine).log2();
        println!("{method:?}: order {measured}");
        assert!((measured - f64::from(order)).abs() < 0.2, "{method:?}: {measured}");
    }
}

#[test]
fn energy_does_not_drift_in_a_thousand_turns() {
    let mut machine = CrankRocker::new();
    machine.set_rates([8.0]).expect("finite");
    let energy = |machine: &CrankRocker| machine.energy().expect("regular").iter().sum::<f64>();
    let start = energy(&machine);
    let mut worst: f64 = 0.0;
    let mut steps = 0;
    while machine.motors()[0] < 1000.0 * TAU {
        machine.simulate(0.004, [0.0]).expect("it turns");
        worst = worst.max((energy(&machine) - start).abs());
        steps += 1;
    }
    let kinetic = machine.energy().expect("regular")[0];
    println!("{steps} steps, energy {start}, kinetic {kinetic}, off by {worst:e}");
    assert!(worst < 1e-6 * kinetic, "off by {worst:e} of {kinetic}");
}

#[test]
fn power_is_the_change_of_energy() {
    let mut machine = CrankRocker::new();
    machine.set_rates([2.0]).expect("finite");
    let energy = |machine: &CrankRocker| machine.energy().expect("regular").iter().sum::<f64>();
    let start = energy(&machine);
    // A constant torque does the work torque times angle.
    for _ in 0..4000 {
        machine.simulate_by(GaussLegendre::Order6, 0.001, [1.75]).expect("it turns");
    }
    let work = 1.75 * machine.motors()[0];
    let gained = energy(&machine) - start;
    assert!((work - gained).abs() < 1e-9 * work.abs(), "{work} against {gained}");
}

#[test]
fn a_double_pendulum_is_accelerated_as_in_the_book() {
    // Angles from the vertical, masses at the ends (Goldstein): solved for the second rates here.
    let [m, n, l, k, g] = [1.5, 0.7, 1.2, 0.9, 9.81];
    let mut pendulum = DoublePendulum::new();
    for (angles, rates) in
        [([0.3, 0.4], [1.0, -2.0]), ([-1.2, 2.5], [0.0, 3.0]), ([2.0, -0.6], [-4.0, 0.5])]
    {
        pendulum.move_to(angles).expect("free");
        pendulum.set_rates(rates).expect("finite");
        let (p, q) = (angles[0] + PI / 2.0, angles[0] + angles[1] + PI / 2.0);
        let (u, v) = (rates[0], rates[0] + rates[1]);
        let (sin, cos) = (p - q).sin_cos();
        let inertia =
            nalgebra::Matrix2::new((m + n) * l * l, n * l * k * cos, n * l * k * cos, n * k * k);
        let drive = nalgebra::Vector2::new(
            -n * l * k * v * v * sin - (m + n) * g * l * p.sin(),
            n * l * k * u * u * sin - n * g * k * q.sin(),
        );
        let second = inertia.lu().solve(&drive).expect("it has mass");
        let found = pendulum.motor_accelerations([0.0, 0.0]).expect("regular");
        assert!((found[0] - second[0]).abs() < 1e-11 * second.norm(), "{found:?}, {second}");
        assert!(
            (found[0] + found[1] - second[1]).abs() < 1e-11 * second.norm(),
            "{found:?}, {second}"
        );
    }
}

#[test]
fn a_five_bar_that_nobody_drives_bounces_on_its_spring() {
    let mut bouncing = Bouncing::new();
    let energy = |machine: &Bouncing| machine.energy().expect("regular").iter().sum::<f64>();
    let start = energy(&bouncing);
    let (mut worst, mut most): (f64, f64) = (0.0, 0.0);
    for _ in 0..5000 {
        bouncing.simulate(0.002, [0.0, 0.0]).expect("it bounces");
        worst = worst.max((energy(&bouncing) - start).abs());
        most = most.max(bouncing.energy().expect("regular")[0]);
    }
    println!("kinetic up to {most}, energy off by {worst:e}");
    assert!(most > 1.0, "it hardly moves: {most}");
    assert!(worst < 1e-6 * most, "{worst:e} of {most}");
}

/// What has come to rest stays there, however long it is waited for: its forces cancel each other but for rounding.
#[test]
fn what_stands_still_stays() {
    for time in [0.001, 0.002, 0.005, 0.0071, 0.01] {
        for method in [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6] {
            let mut block = Damped::new();
            for step in 0..4000 {
                let outcome = block.simulate_by(method, time, [0.0]);
                assert_eq!(outcome, Ok(()), "{method:?}, {time}: step {step}");
            }
            let [at] = block.motors();
            assert!((at + 0.1).abs() < 1e-12, "{method:?}, {time}: at {at}");
            assert!(block.rates()[0].abs() < 1e-10, "{method:?}, {time}");
        }
    }
    for time in [1e-4, 3e-4, 9e-4, 1e-3] {
        for method in [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6] {
            let mut arm = Suspension::new();
            for step in 0..6000 {
                let outcome = arm.simulate_by(method, time, [0.0]);
                assert_eq!(outcome, Ok(()), "{method:?}, {time}: step {step}");
            }
            let [kinetic, _] = arm.energy().expect("regular");
            assert!(kinetic < 1e-3, "{method:?}, {time}: {kinetic:e}");
        }
    }
}

macro_rules! passing {
    ($module:ident, $float:ident) => {
        /// Mechanisms that fall through poses in which their bars lie in one line.
        mod $module {
            use mech_runtime::mechanism;

            mechanism! {
                pub(super) struct Swing: $float;
                ground { point a = (0, 0); point d = (3, 0); }
                link left { point a = (0, 0); point b = (1, 0); mass 1 at (0.5, 0) inertia 0.1; }
                link seat { point b = (0, 0); point c = (3, 0); mass 2 at (1.5, 0) inertia 1; }
                link right { point d = (0, 0); point c = (1, 0); mass 1 at (0.5, 0) inertia 0.1; }
                joint j = revolute(ground.a, left.a);
                joint k = revolute(left.b, seat.b);
                joint l = revolute(seat.c, right.c);
                joint m = revolute(ground.d, right.d);
                motor j;
                gravity (0, -9.81);
                start { j = 30 deg; seat near 0 deg; }
                effects { dynamics; velocity; acceleration; }
            }

            mechanism! {
                pub(super) struct Slider: $float;
                ground { point o = (0, 0); line x = (0, 0) -> (1, 0); }
                link a { point o = (0, 0); point q = (1, 0); mass 1 at (0.5, 0) inertia 0.1; }
                link b { point q = (0, 0); point r = (1, 0); mass 1 at (0.5, 0) inertia 0.1; }
                link c { point r = (0, 0); line x = (0, 0) -> (1, 0); mass 2; }
                joint j = revolute(ground.o, a.o);
                joint k = revolute(a.q, b.q);
                joint l = revolute(b.r, c.r);
                joint m = prismatic(ground.x, c.x);
                motor j;
                start { j = 60 deg; b near -60 deg; }
                gravity (0, -9.81);
                effects { dynamics; }
            }
        }
    };
}
passing!(double, f64);
passing!(single, f32);

/// Falls from 30 degrees, in steps of this method and length, for two seconds. Gives by how much its energy changed, as a part of the
/// greatest kinetic one, how often the crank came through the line, and its angle and rate after 0.4 seconds.
macro_rules! fall {
    ($machine:path, $float:ident, $method:expr, $time:expr) => {{
        let mut machine = <$machine>::new();
        machine.move_to([$float::to_radians(30.0)]).expect("it turns");
        let energy = |machine: &$machine| machine.energy().expect("it has a limit").map(f64::from);
        let start: f64 = energy(&machine).iter().sum();
        let (mut worst, mut most, mut passages, mut early) = (0.0_f64, 0.0_f64, 0, [0.0_f64; 2]);
        for step in 0..(2.0_f64 / $time) as u32 {
            let before = machine.motors()[0];
            let outcome = machine.simulate_by($method, $time as $float, [0.0]);
            assert_eq!(outcome, Ok(()), "{:?} {}: step {step}", $method, $time);
            let [now, half_turn] = [machine.motors()[0], core::$float::consts::PI];
            passages += u32::from((before / half_turn).floor() != (now / half_turn).floor());
            let [kinetic, potential] = energy(&machine);
            worst = worst.max((kinetic + potential - start).abs());
            most = most.max(kinetic);
            if (f64::from(step + 1) * $time - 0.4).abs() < 1e-9 {
                early = [now, machine.rates()[0]].map(f64::from);
            }
        }
        assert!(passages > 1, "it comes through the line {passages} times");
        (worst / most, early)
    }};
}

/// At a change point accelerations have a limit: a fall goes on through it, whatever the step, and keeps its energy as well as the method.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a few thousand steps, in either precision"
)]
fn falls_go_straight_on(method: GaussLegendre, kept: f64, times: &[f64]) {
    for &time in times {
        let (swing, [angle, rate]) = fall!(double::Swing, f64, method, time);
        let (slider, _) = fall!(double::Slider, f64, method, time);
        println!("{method:?} {time}: {swing:e} and {slider:e}");
        assert!(swing < kept && slider < 5.0 * kept, "{method:?} {time}: {swing:e} and {slider:e}");
        let (swing, early) = fall!(single::Swing, f32, method, time);
        let (slider, _) = fall!(single::Slider, f32, method, time);
        assert!(swing < 1e-4 && slider < 2e-3, "{method:?} {time}: {swing:e} and {slider:e}");
        // th'' = -10.9 cos th, integrated elsewhere.
        if time == 1e-3 && method != GaussLegendre::Order2 {
            assert!((angle + 0.271_549_375).abs() < 1e-8, "{angle}");
            assert!((rate + 4.092_345_42).abs() < 1e-7, "{rate}");
            assert!((early[0] - angle).abs() < 1e-5, "{early:?}");
        }
    }
}

/// The shortest steps, of which there are most, are made by the method with the fewest stages.
#[test]
fn what_falls_goes_straight_on_through_its_change_points() {
    falls_go_straight_on(GaussLegendre::Order2, 1e-4, &[1e-4, 4e-4, 1e-3, 2e-3, 3e-3]);
}

#[test]
fn what_falls_goes_straight_on_by_two_stages() {
    falls_go_straight_on(GaussLegendre::Order4, 1e-7, &[4e-4, 1e-3, 2e-3, 3e-3]);
}

#[test]
fn what_falls_goes_straight_on_by_three_stages() {
    falls_go_straight_on(GaussLegendre::Order6, 1e-8, &[4e-4, 1e-3, 2e-3, 3e-3]);
}

#[test]
fn what_cannot_be_simulated_is_refused_and_leaves_everything_as_it_was() {
    let mut machine = CrankRocker::new();
    machine.set_rates([2.0]).expect("finite");
    let before = machine;
    let cause = |blocked: mech_runtime::Blocked<[f64; 1]>| (blocked.place, blocked.cause);
    assert_eq!(machine.simulate(f64::NAN, [0.0]).map_err(cause), Err(("time", Cause::NotFinite)));
    assert_eq!(machine.simulate(0.1, [f64::INFINITY]).map_err(cause), Err(("a", Cause::NotFinite)));
    assert_eq!(machine.set_rates([f64::NAN]).map_err(cause), Err(("a", Cause::NotFinite)));
    assert_eq!(
        machine.simulate(1e3, [1.0]).map_err(|blocked| blocked.cause),
        Err(Cause::StepTooLong)
    );
    assert_eq!(machine, before);
    machine.move_to([1.0]).expect("it turns");
    assert_eq!(machine.rates(), [0.0]);
}
