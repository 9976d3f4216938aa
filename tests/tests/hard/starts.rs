//! Starts that are themselves singular.

use mech_compiler::{compile, reporter, syntax};

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

/// A `mechanism!` that does not compile cannot stand in a test: hence the text.
#[test]
fn a_parallelogram_may_start_where_it_is_flat() {
    assert_compiles(
        "struct Flat;
        ground { point a = (0, 0); point d = (2, 0); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link coupler { point b = (0, 0); point c = (2, 0); }
        link rocker { point d = (0, 0); point c = (1, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        motor ja;
        start { ja = 0 deg; rocker near 0 deg; }",
    );
}

#[test]
fn the_same_parallelogram_may_start_anywhere_else() {
    for degrees in [1e-3, 1.0, 89.0, 91.0, 179.0, -60.0] {
        assert_compiles(&format!(
            "struct Nearly;
            ground {{ point a = (0, 0); point d = (2, 0); }}
            link crank {{ point a = (0, 0); point b = (1, 0); }}
            link coupler {{ point b = (0, 0); point c = (2, 0); }}
            link rocker {{ point d = (0, 0); point c = (1, 0); }}
            joint ja = revolute(ground.a, crank.a);
            joint jb = revolute(crank.b, coupler.b);
            joint jc = revolute(coupler.c, rocker.c);
            joint jd = revolute(ground.d, rocker.d);
            motor ja;
            start {{ ja = {degrees} deg; rocker near {degrees} deg; }}"
        ));
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
