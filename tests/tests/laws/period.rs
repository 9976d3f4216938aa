//! After what time laws are back where they began.

use mech_test_support::model;
use std::f64::consts::{PI, TAU};

#[test]
fn laws_are_back_after_their_common_period() {
    let text = |laws: [&str; 2]| {
        let motors = [("a", laws[0]), ("s", laws[1])];
        let motors = motors.map(|(joint, law)| match law {
            "" => String::new(),
            law => format!("motor {joint} = {law};"),
        });
        format!(
            "struct M; const K = 3; param p = 4;
            ground {{ point o = (0, 0); line x = (1, 0) -> (1, 0); }}
            link c {{ point o = (0, 0); }} link b {{ line x = (0, 0) -> (1, 0); }}
            joint a = revolute(ground.o, c.o);
            joint s = prismatic(ground.x, b.x);
            {}",
            motors.concat()
        )
    };
    for (turning, sliding, expected) in [
        ("2 * PI * t", "", Some(1.0)),
        ("-90 deg * t", "", Some(4.0)),
        ("0.5 + K * t / 2", "", Some(2.0 * TAU / 3.0)),
        ("0.3 * sin(2 * PI * t / K)", "", Some(3.0)),
        ("p * t", "", Some(PI / 2.0)),
        ("t + sin(2 * t)", "", Some(TAU)),
        ("t", "cos(3 * t) * sin(2 * t)", Some(TAU)),
        ("", "sqrt(2 + sin(t))", Some(TAU)),
        ("", "mod(3 * t, 6)", Some(2.0)),
        ("", "max(0, sin(4 * PI * t))", Some(0.5)),
        ("PI * t", "sin(4 * PI * t / 3)", Some(6.0)),
        // These never come back, or nobody knows when.
        ("0.3 * t * t", "", None),
        ("", "t", None),
        ("", "exp(-t) * sin(t)", None),
        ("t", "sin(sqrt(2) * t)", None),
        ("1", "", None),
    ] {
        let found = model(&text([turning, sliding])).period();
        let is_it = match (found, expected) {
            (Some(found), Some(expected)) => (found - expected).abs() < 1e-9,
            (found, expected) => found.is_none() && expected.is_none(),
        };
        assert!(is_it, "{turning}, {sliding}: {found:?}, not {expected:?}");
    }
}
