//! Links, points, lines and shapes.

use super::good;

#[test]
fn a_direction_may_be_an_angle() {
    let direction = |text: &str| {
        let text = format!("struct M; const TILT = 15; link a {{ line l = (0, 0) -> {text}; }}");
        good(&text).model.axes[0].direction
    };
    for (text, expected) in [
        ("0", [1.0, 0.0]),
        ("90 deg", [0.0, 1.0]),
        ("PI", [-1.0, 0.0]),
        ("-90 deg", [0.0, -1.0]),
        ("(360 + 270) deg", [0.0, -1.0]),
        (
            "(90 + TILT) deg",
            [
                libm::cos(105_f64.to_radians()),
                libm::sin(105_f64.to_radians()),
            ],
        ),
        ("atan2(3, 4)", [0.8, 0.6]),
        ("(cos(0), sin(0))", [1.0, 0.0]),
    ] {
        let found = direction(text);
        let off = (found[0] - expected[0])
            .abs()
            .max((found[1] - expected[1]).abs());
        assert!(off <= f64::EPSILON, "{text}: {found:?}");
        let is_exact = expected.contains(&0.0);
        assert!(!is_exact || found == expected, "{text}: {found:?}");
    }
    let text = "struct M; link a; joint j = prismatic(ground, a) at (0, 0) along 30 deg;";
    let axis = &good(text).model.axes[0];
    assert!((axis.direction[1] - 0.5).abs() < 1e-15);
}

#[test]
fn an_axis_may_be_turned_about_the_origin_of_its_link() {
    let parsed = super::parsed(
        "struct M; link a {
            point p = (2, 0) turned 90 deg;
            point q = (1, 0) -> (0, 1) turned 180 deg;
            line l = (0, 3) -> 0 deg turned -90 deg;
        }",
    );
    assert!(parsed.errors.is_empty());
    let axes = |index: usize| {
        (
            parsed.model.axes[index].at,
            parsed.model.axes[index].direction,
        )
    };
    assert_eq!(axes(0), ([0.0, 2.0], [1.0, 0.0]));
    assert_eq!(axes(1), ([-1.0, 0.0], [0.0, -1.0]));
    assert_eq!(axes(2), ([3.0, 0.0], [0.0, -1.0]));
}
