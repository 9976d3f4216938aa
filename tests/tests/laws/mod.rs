//! Laws of motors: their values and rates against other methods, and mechanisms that are moved by the time alone.

mod generated;
mod jet;
mod period;

use jet::{Jet, jet};
use mech_compiler::model::{Effects, Law, Model, Now};
use mech_compiler::program::{Timing, build_timing};
use mech_test_support::{differences, for_all, model_of_law};
use proptest::prelude::*;

/// A random expression in `t` that is smooth wherever it has a value.
fn smooth() -> impl Strategy<Value = String> {
    let number = (-2.0..2.0).prop_map(|number: f64| format!("{number:.3}"));
    let leaf = prop_oneof![1 => number, 2 => Just("t".to_owned())];
    leaf.prop_recursive(4, 16, 2, |part| {
        (0..16, part.clone(), part).prop_map(|(kind, a, b)| match kind {
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
        })
    })
}

/// The same with corners in it.
fn cornered() -> impl Strategy<Value = String> {
    (0..6, smooth(), smooth()).prop_map(|(kind, a, b)| match kind {
        0 => format!("max({a}, {b})"),
        1 => format!("{a} + min(0.5, {b})"),
        2 => format!("abs({a}) * ({b})"),
        3 => format!("floor({a}) * ({b})"),
        4 => format!("mod({a}, 1.5 + sin({b}))"),
        _ => format!("sign({a}) + {b}"),
    })
}

/// Five times at which a law is tried.
fn times() -> impl Strategy<Value = [f64; 5]> {
    prop::array::uniform5(-3.0..3.0)
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
    let mut model = model_of_law(law);
    model.effects = EFFECTS;
    model
}

fn timing(model: &Model) -> Timing {
    build_timing(model).expect("a motor has a law")
}

/// The greatest size of anything from which a law is computed.
fn extent(law: &Law, time: f64) -> f64 {
    let params = &[];
    let sizes = law.formulas().evaluate(&mut Now { variables: &[time], params });
    sizes.iter().map(|size| size.abs()).fold(1.0, f64::max)
}

fn five(at: impl Fn(f64) -> f64, time: f64, step: f64) -> [f64; 5] {
    [-2.0, -1.0, 0.0, 1.0, 2.0].map(|number| at(time + number * step))
}

#[test]
fn rates_of_random_laws_are_their_derivatives() {
    const STEP: f64 = 1e-3;
    for_all(1_000, &(smooth(), times()), |(text, times)| {
        let model = model(&text);
        let (law, timing) = (&model.laws[0], timing(&model));
        for time in times {
            let [value, rate, second] = timing.at(time, &[])[0];
            let direct = law.at(time, &[]);
            let scale = extent(law, time);
            assert!(
                (value - direct).abs() <= 1e-12 * scale * (1.0 + rate.abs()),
                "{text} at {time}: {value}, {direct}"
            );
            let by_differences =
                |step: f64| differences(five(|time| law.at(time, &[]), time, step), step);
            let (near, far) = (by_differences(STEP), by_differences(2.0 * STEP));
            for (order, power, exact) in [(0, 1, rate), (1, 2, second)] {
                let truncation = (near[order] - far[order]).abs();
                let most = truncation + 1e-14 * scale / STEP.powi(power) + 1e-9 * exact.abs();
                assert!(
                    (near[order] - exact).abs() <= most,
                    "{text} at {time}, order {order}: {exact}, {} by differences, explained {most:e}",
                    near[order]
                );
            }
        }
    });
}

#[test]
fn laws_with_corners_have_the_rates_of_the_side_they_are_on() {
    for_all(1_000, &(cornered(), times()), |(text, times)| {
        let model = model(&text);
        let (law, timing) = (&model.laws[0], timing(&model));
        for time in times {
            let (found, Jet(expected)) = (timing.at(time, &[])[0], jet(law, time));
            let scale = extent(law, time) * (1.0 + expected[1].abs() + expected[2].abs());
            for order in 0..3 {
                assert!(
                    (found[order] - expected[order]).abs() <= 1e-9 * scale,
                    "{text} at {time}, order {order}: {} instead of {}",
                    found[order],
                    expected[order]
                );
            }
        }
    });
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

#[test]
fn what_is_compared_with_a_constant_comes_out_exactly() {
    for law in [
        "max(-1e300, t)",
        "max(t, -1e300)",
        "min(t, 1e300)",
        "min(1e300, t)",
        "max(-1e6, min(1e6, t))",
        "max(t, 0)",
    ] {
        let at = |time| timing(&model(law)).at(time, &[])[0];
        assert_eq!(at(0.1), [0.1, 1.0, 0.0], "{law}");
    }
    for (law, value) in [("max(2, t)", 2.0), ("min(t, -2)", -2.0)] {
        let at = |time| timing(&model(law)).at(time, &[])[0];
        assert_eq!(at(0.1), [value, 0.0, 0.0], "{law}");
    }
}
