//! Whatever numbers are taken from intervals, the result lies in the result's interval.

use super::super::Interval;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Numbers of all sizes, the awkward ones among them.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -10.0..10.0,
        2 => -1e6..1e6,
        1 => prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        1 => prop_oneof![
            Just(0.0),
            Just(-0.0),
            Just(1.0),
            Just(-1.0),
            Just(f64::MAX),
            Just(f64::MIN),
            Just(f64::MIN_POSITIVE),
            Just(f64::EPSILON),
            Just(PI),
            Just(-FRAC_PI_2),
        ],
    ]
}

/// An interval and a number in it: an end, or between.
fn inside() -> impl Strategy<Value = (Interval, f64)> {
    (number(), number(), 0.0..=1.0, 0..4).prop_map(|(a, b, part, which): (f64, f64, f64, i32)| {
        let interval = Interval::new(a, if which == 3 { a } else { b });
        let at = match which {
            0 => interval.low(),
            1 => interval.high(),
            _ => (interval.low() * (1.0 - part) + interval.high() * part)
                .clamp(interval.low(), interval.high()),
        };
        (interval, at)
    })
}

/// An interval of angles and an angle in it.
fn angle() -> impl Strategy<Value = (Interval, f64)> {
    let quarter = (-40_i32..40, -2_i32..3).prop_map(|(quarters, off)| {
        let near = f64::from(quarters) * FRAC_PI_4;
        near + f64::from(off) * near.abs() * f64::EPSILON
    });
    let end = prop_oneof![-20.0..20.0, quarter, -1e5..1e5];
    (end, -7.0..7.0, 0.0..=1.0).prop_map(|(from, width, part): (f64, f64, f64)| {
        let interval = Interval::new(from, from + width);
        let at = (from + part * width).clamp(interval.low(), interval.high());
        (interval, at)
    })
}

fn is_sound(interval: Interval) -> bool {
    interval.low() <= interval.high()
        && interval.low() < f64::INFINITY
        && interval.high() > f64::NEG_INFINITY
}

/// Returns the rounding error of a sum, exactly.
fn lost(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let remainder = sum - a;
    (a - (sum - remainder)) + (b - remainder)
}

/// Whether an interval holds a number and a small correction to it.
fn holds(interval: Interval, number: f64, correction: f64) -> bool {
    is_sound(interval)
        && interval.contains(number)
        && (correction <= 0.0 || interval.high() > number || !number.is_finite())
        && (correction >= 0.0 || interval.low() < number || !number.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn sums_are_inside((a, x) in inside(), (b, y) in inside()) {
        prop_assert!(holds(a + b, x + y, lost(x, y)));
        prop_assert!(holds(a - b, x - y, lost(x, -y)));
    }

    #[test]
    fn products_are_inside((a, x) in inside(), (b, y) in inside()) {
        prop_assert!(holds(a * b, x * y, x.mul_add(y, -(x * y))));
        prop_assert!(holds(a.square(), x * x, x.mul_add(x, -(x * x))));
        prop_assert!(a.square().low() >= 0.0);
    }

    #[test]
    fn quotients_are_inside((a, x) in inside(), (b, y) in inside()) {
        let quotient = x / y;
        prop_assert!(is_sound(a / b));
        if y != 0.0 {
            // The correction has the sign of the remainder, times that of the divisor.
            let remainder = (-quotient).mul_add(y, x);
            prop_assert!(holds(a / b, quotient, remainder * y.signum()));
        }
        if b.contains(0.0) {
            prop_assert_eq!(a / b, Interval::ENTIRE);
        }
    }

    #[test]
    fn roots_are_inside((a, x) in inside()) {
        let root = x.max(0.0).sqrt();
        prop_assert!(holds(a.sqrt(), root, (-root).mul_add(root, x.max(0.0))));
        prop_assert!(a.sqrt().low() >= 0.0);
    }

    #[test]
    fn powers_are_inside((a, x) in inside()) {
        let (by_library, of_system) = (libm::exp(x), x.exp());
        let powers = a.exp();
        prop_assert!(is_sound(powers) && powers.low() >= 0.0);
        for power in [by_library, of_system] {
            prop_assert!(powers.low() <= power && (power <= powers.high() || power == f64::INFINITY));
        }
    }

    #[test]
    fn what_is_exact_is_inside((a, x) in inside(), (b, y) in inside()) {
        prop_assert!(holds(a.abs(), x.abs(), 0.0));
        prop_assert!(holds(-a, -x, 0.0));
        prop_assert!(holds(a.max(b), x.max(y), 0.0));
        prop_assert!(holds(a.copysign(b), x.copysign(y), 0.0));
        prop_assert!(holds(a.round(), libm::round(x), 0.0));
        prop_assert!(holds(a.hull(b), x, 0.0) && holds(a.hull(b), y, 0.0));
        prop_assert!(is_sound(a.meet(b)) && a.contains(a.middle()));
        prop_assert!(a.width() >= x - a.low());
    }

    #[test]
    fn waves_are_inside((a, x) in angle()) {
        // Two libraries, neither of which is right to the last digit.
        for (wave, own, other) in [(a.sin(), libm::sin(x), x.sin()), (a.cos(), libm::cos(x), x.cos())] {
            prop_assert!(holds(wave, own, 0.0) && holds(wave, other, 0.0), "{wave:?} {own} {other}");
            prop_assert!(wave.low() >= -1.0 && wave.high() <= 1.0);
        }
    }

    #[test]
    fn waves_are_narrow((a, _) in angle()) {
        // As wide as what a thousand numbers between show, or a little more.
        let numbers = || (0..=1000_u32).map(|part| {
            let part = f64::from(part) / 1000.0;
            (a.low() * (1.0 - part) + a.high() * part).clamp(a.low(), a.high())
        });
        let step = a.width() / 1000.0;
        let discriminant = step * step + 1e-15;
        for (wave, number) in [(a.sin(), f64::sin as fn(f64) -> f64), (a.cos(), f64::cos)] {
            let least = numbers().map(number).fold(f64::INFINITY, f64::min);
            let most = numbers().map(number).fold(f64::NEG_INFINITY, f64::max);
            prop_assert!(wave.low() >= least - discriminant && wave.high() <= most + discriminant, "{wave:?} {least} {most}");
        }
    }

    #[test]
    fn arcs_are_inside((a, y) in inside(), (b, x) in inside()) {
        let arc = a.atan2(b);
        prop_assert!(holds(arc, libm::atan2(y, x), 0.0) && holds(arc, y.atan2(x), 0.0), "{arc:?} {y} {x}");
    }

    #[test]
    fn whatever_bounds_are_given_there_is_a_number(a in prop::num::f64::ANY, b in prop::num::f64::ANY) {
        let a = Interval::new(a, b);
        prop_assert!(is_sound(a) && a.contains(a.middle()));
        for result in [a.sin(), a.cos(), a.sqrt(), a.square(), a.abs(), a.round(), a + a, a - a, a * a, a / a, a.atan2(a)] {
            prop_assert!(is_sound(result), "{a:?} {result:?}");
        }
    }
}

#[test]
fn extrema_are_exact() {
    let around = |middle: f64| Interval::new(middle - 0.1, middle + 0.1);
    assert_eq!(around(0.0).cos().high(), 1.0);
    assert_eq!(around(PI).cos().low(), -1.0);
    assert_eq!(around(FRAC_PI_2).sin().high(), 1.0);
    assert_eq!(around(-FRAC_PI_2).sin().low(), -1.0);
    assert!(around(0.0).cos().low() > 0.995 - 1e-5);
    assert!(around(PI).cos().high() < -0.995 + 1e-5);
    let turn = Interval::new(0.0, TAU);
    assert_eq!((turn.sin().low(), turn.sin().high()), (-1.0, 1.0));
    assert_eq!((turn.cos().low(), turn.cos().high()), (-1.0, 1.0));
}

#[test]
fn small_whole_numbers_stay_sharp() {
    let [two, three] = [2.0, 3.0].map(Interval::point);
    assert_eq!(two + three, Interval::point(5.0));
    assert_eq!(two - three, Interval::point(-1.0));
    assert_eq!(Interval::ZERO * Interval::ENTIRE, Interval::ZERO);
    assert_eq!(Interval::ZERO / three, Interval::ZERO);
}

#[test]
fn angles_too_large_to_have_a_sine_have_any() {
    let wide = Interval::new(-1.0, 1.0);
    assert_eq!(Interval::point(1e300).sin(), wide);
    assert_eq!(Interval::ENTIRE.cos(), wide);
}
