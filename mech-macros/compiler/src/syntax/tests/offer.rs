//! Mistakes of newcomers: the texts that are offered instead can be read.

use super::parsed;

/// The value of a constant that is offered.
fn offered_value(wrong: &str) -> f64 {
    let text = format!("struct M; const X = 3; const Y = 4; const A = {wrong};");
    let message = &parsed(&text).errors[0].text;
    let (_, rest) = message.split_once("write `").expect("an offer");
    let (offer, _) = rest.split_once('`').expect("its end");
    let text =
        format!("struct M; const X = 3; const Y = 4; ground {{ point p = (2 / {offer}, 0); }}");
    2.0 / super::good(&text).model.axes[0].at[0]
}

#[test]
fn functions_of_other_languages_are_written_by_ours() {
    for (wrong, value) in [
        ("arccos(-0.9)", (-0.9_f64).acos()),
        ("arcsin(X / 5)", 0.6_f64.asin()),
        ("arctan(X)", 3.0_f64.atan()),
        ("arctan2(-X, 1 - Y)", (-3.0_f64).atan2(-3.0)),
        ("sinh(X - 4)", (-1.0_f64).sinh()),
        ("cosh(2)", 2.0_f64.cosh()),
        ("tanh(-0.5)", (-0.5_f64).tanh()),
        ("exp2(X)", 8.0),
        ("sind(30)", 0.5),
        ("cosd(X * 20)", 0.5),
        ("cot(0.5)", 1.0 / 0.5_f64.tan()),
        ("sec(0.5)", 1.0 / 0.5_f64.cos()),
        ("pow(X + 1, 2)", 16.0),
        ("pow(Y, 0.5)", 2.0),
        ("signum(-X)", -1.0),
        ("ceil(X - 0.5)", 3.0),
        ("(X + Y) % X", 1.0),
        ("radians(90 + 90)", std::f64::consts::PI),
        ("X ^ 2", 9.0),
        ("(X - Y) ** 3", -1.0),
        ("X ^ 1", 3.0),
        ("Y ^ 0.5", 2.0),
    ] {
        let offered = offered_value(wrong);
        assert!((offered - value).abs() < 1e-12, "{wrong}: {offered} is not {value}");
    }
}

#[test]
fn a_name_of_a_color_is_its_entry_of_the_palette() {
    let parsed = parsed(
        "struct M; const red = 200; link a { circle (0, 0) radius 1 color teal; ring (0, 0) radius 2 hole 1 color steel dark; \
         circle (0, 0) radius 1 color sky light; circle (0, 0) radius 1 color red; }",
    );
    let colors: Vec<u8> = parsed.model.links[1].shapes.iter().map(|shape| shape.color).collect();
    assert_eq!(colors, [4, 32, 42, 200]);
}
