//! Starts that are themselves singular.

use mech_compiler::{compile, reporter, syntax};
use mech_test_support::four_bar_text;

#[track_caller]
fn assert_compiles(text: &str) {
    let model = syntax::parse(text.parse().expect("it is Rust")).model;
    if let Err(wrong) = compile(&model) {
        let messages: Vec<String> = wrong
            .iter()
            .map(|wrong| reporter::text(wrong, &model))
            .collect();
        panic!("{}", messages.join("; "));
    }
}

/// A parallelogram that starts with its crank at this angle.
fn parallelogram(degrees: f64) -> String {
    let start = format!("start {{ ja = {degrees} deg; rocker near {degrees} deg; }}");
    four_bar_text([2.0, 1.0, 2.0, 1.0]) + &start
}

/// A `mechanism!` that does not compile cannot stand in a test: hence the text.
#[test]
fn a_parallelogram_may_start_where_it_is_flat() {
    assert_compiles(&parallelogram(0.0));
}

#[test]
fn the_same_parallelogram_may_start_anywhere_else() {
    for degrees in [1e-3, 1.0, 89.0, 91.0, 179.0, -60.0] {
        assert_compiles(&parallelogram(degrees));
    }
}

#[test]
fn nearly_parallel_guides_may_start_as_drawn() {
    for (scalar, slope) in [
        ("f64", 1e-6),
        ("f64", 1e-8),
        ("f64", 1e-10),
        ("f64", 1e-12),
        ("f32", 1e-6),
    ] {
        assert_compiles(&format!(
            "struct Guides: {scalar};
            link crank;
            link block;
            link yoke;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, block) at (0.6, 0.8);
            joint s = prismatic(block, yoke) at (0.6, 0.8) along (1, {slope:?});
            joint x = prismatic(ground, yoke) at (0.6, 0.8) along (1, 0);
            motor a;"
        ));
    }
}
