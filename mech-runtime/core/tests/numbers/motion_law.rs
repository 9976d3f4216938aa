//! Motion laws, against their accelerations as textbooks draw them, which are integrated here.

use mech_core::{MotionLaw, Staircase};
use proptest::prelude::*;
use std::f64::consts::PI;

/// Panels in a unit of time: the laws change at eighths of it.
const PANELS: u32 = 4000;

/// The acceleration of a law at a time, but for a factor.
fn acceleration(law: MotionLaw, s: f64) -> f64 {
    // The second half mirrors the first.
    if s > 0.5 {
        return -acceleration(law, 1.0 - s);
    }
    match law {
        MotionLaw::Linear => 0.0,
        MotionLaw::Parabolic => 1.0,
        MotionLaw::Harmonic => (PI * s).cos(),
        MotionLaw::Cycloidal => (2.0 * PI * s).sin(),
        MotionLaw::Polynomial345 => s * (1.0 - s) * (1.0 - 2.0 * s),
        MotionLaw::Polynomial4567 => (s * (1.0 - s)).powi(2) * (1.0 - 2.0 * s),
        MotionLaw::ModifiedSine | MotionLaw::ModifiedTrapezoid if s < 0.125 => (4.0 * PI * s).sin(),
        MotionLaw::ModifiedSine => (4.0 * PI / 3.0 * (s - 0.125)).cos(),
        MotionLaw::ModifiedTrapezoid if s < 0.375 => 1.0,
        MotionLaw::ModifiedTrapezoid => (4.0 * PI * (s - 0.375)).cos(),
    }
}

/// The integral over one panel by five points of Gauss: of the acceleration, and of it times the time to the panel's end.
fn panel(law: MotionLaw, from: f64, width: f64) -> [f64; 2] {
    let nodes = [
        (0.0, 128.0 / 225.0),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    nodes.iter().fold([0.0; 2], |[sum, moment], (node, weight)| {
        let s = 0.5 * width * (1.0 + node);
        let part = 0.5 * width * weight * acceleration(law, from + s);
        [sum + part, moment + part * (width - s)]
    })
}

/// A law at all ends of panels: its way, velocity and acceleration, so that the way is 1 at the end.
fn integrated(law: MotionLaw) -> Vec<[f64; 3]> {
    let width = 1.0 / f64::from(PANELS);
    let first = if law == MotionLaw::Linear { 1.0 } else { 0.0 };
    let (mut way, mut velocity) = (0.0, first);
    let mut all = vec![[way, velocity, acceleration(law, 0.0)]];
    for number in 0..PANELS {
        let [sum, moment] = panel(law, f64::from(number) * width, width);
        way += velocity * width + moment;
        velocity += sum;
        let at = f64::from(number + 1) * width;
        all.push([way, velocity, acceleration(law, at)]);
    }
    all.into_iter().map(|row| row.map(|part| part / way)).collect()
}

#[test]
fn laws_are_the_integrals_of_their_accelerations() {
    for law in MotionLaw::ALL {
        let rows = integrated(law);
        for (row, number) in rows.iter().zip(0_u32..) {
            let s = f64::from(number) / f64::from(PANELS);
            for (order, expected) in (0_u8..).zip(row) {
                // Where the acceleration jumps, it has two values.
                let jumps = law == MotionLaw::Parabolic && order == 2 && number * 2 == PANELS;
                let found = law.at(order, s);
                let is_near = (found - expected).abs() < 2e-12;
                assert!(jumps || is_near, "{law:?} {order} {s}: {found} {expected}");
            }
        }
    }
}

#[test]
fn the_greatest_velocities_and_accelerations_are_known() {
    // In closed form, of which the tables of Rothbart and Norton print three decimals.
    let (sine, trapezoid) = (PI / (4.0 + PI), PI / (2.0 + PI));
    for (law, velocity, acceleration) in [
        (MotionLaw::Parabolic, 2.0, 4.0),
        (MotionLaw::Harmonic, 0.5 * PI, 0.5 * PI * PI),
        (MotionLaw::Cycloidal, 2.0, 2.0 * PI),
        (MotionLaw::Polynomial345, 1.875, 10.0 / 3.0_f64.sqrt()),
        (MotionLaw::Polynomial4567, 2.1875, 84.0 * 5.0_f64.sqrt() / 25.0),
        (MotionLaw::ModifiedSine, 4.0 * sine, 4.0 * PI * sine),
        (MotionLaw::ModifiedTrapezoid, 2.0, 8.0 * trapezoid),
    ] {
        for (order, expected) in [(1, velocity), (2, acceleration)] {
            let times = (0..=100_000).map(|number| f64::from(number) / 100_000.0);
            let found = times.map(|s| law.at(order, s).abs()).fold(0.0, f64::max);
            assert!((found - expected).abs() < 1e-8, "{law:?}: {found}");
            assert!(found <= law.bound(order), "{law:?}");
        }
    }
}

proptest! {
    /// Each derivative is the slope of the one before, but where the law changes its formula.
    #[test]
    fn derivatives_are_slopes(number in 0..8_usize, order in 0..4_u8, s in 0.001..0.999_f64) {
        const STEP: f64 = 1e-4;
        let law = MotionLaw::ALL[number];
        let is_far = |change: f64| (s - change).abs() > 3.0 * STEP && (1.0 - s - change).abs() > 3.0 * STEP;
        prop_assume!(law.changes().all(is_far) && s > 3.0 * STEP && s < 1.0 - 3.0 * STEP);
        let at = |k: f64| law.at(order, s + k * STEP);
        let slope = (at(-2.0) - 8.0 * at(-1.0) + 8.0 * at(1.0) - at(2.0)) / (12.0 * STEP);
        let size = 1.0 + law.bound(order + 1);
        prop_assert!((law.at(order + 1, s) - slope).abs() < 1e-8 * size);
    }

    /// A staircase is the whole steps below and the part of the one that is climbed, also below zero and in single precision.
    #[test]
    fn staircases_are_steps_one_after_the_other(
        number in 0..8_usize,
        step in -1000..1000_i32,
        within in 0.0..1.0_f64,
        share in 0.01..1.0_f64,
    ) {
        let law = MotionLaw::ALL[number];
        let stairs = Staircase::endless(law, 0);
        let place = f64::from(step) + within;
        let within = place - f64::from(step);
        let climbed = if within < share { law.at(0, within / share) } else { 1.0 };
        prop_assert!((stairs.at(place, share) - f64::from(step) - climbed).abs() < 1e-12);
        // Only the last digits of a single are those of a step.
        #[allow(clippy::cast_possible_truncation)]
        let single = f64::from(Staircase::single(law, 0).at(within as f32, share as f32));
        let slope = law.bound(1) / share;
        prop_assert!((single - climbed).abs() < 1e-6 + 2e-7 * slope, "{single} {climbed}");
        let rate = Staircase::endless(law, 1).at(place, share);
        prop_assert_eq!(rate == 0.0, within >= share || law.at(1, within / share) == 0.0);
    }
}

#[test]
fn a_single_step_has_nothing_before_and_behind_it() {
    for law in MotionLaw::ALL {
        let at = |order: u8, place: f64| Staircase::single(law, order).at(place, 1.0);
        assert_eq!([at(0, -3.0), at(0, 0.0), at(0, 1.0), at(0, 7.5)], [0.0, 0.0, 1.0, 1.0]);
        assert_eq!([at(1, -1e-9), at(1, 1.0), at(2, 1.0)], [0.0; 3]);
        assert!(at(0, f64::NAN).is_nan(), "{law:?}");
        let endless = Staircase::endless(law, 0);
        assert!(endless.at(f64::NAN, 1.0).is_nan() && endless.at(f64::INFINITY, 1.0).is_nan());
        assert_eq!([-2.0, 0.0, 5.0].map(|place| endless.at(place, 0.3)), [-2.0, 0.0, 5.0]);
    }
}
