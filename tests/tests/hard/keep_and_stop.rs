//! Change points where something else was declared than to go on.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_compiler::compile;
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::syntax::parse;
use mech_runtime::{Mechanism, Real};
use std::f64::consts::PI;

const LENGTHS: [f64; 4] = [2.0, 1.0, 2.0, 1.0];

variants! {
    branch_keeper by [exact newton] four_bar [2, 1, 2, 1] {
        motor ja;
        start { ja = 60 deg; rocker near 60 deg; }
        at change points keep branch;
    } {
        it_is_always_folded_in_the_same_sense: same_sense;
    }
}

/// Where rounding hides the side: a sine of so many roots of a unit of rounding.
const HIDDEN: f64 = 16.0;

fn same_sense<M: Mechanism>(bed: Bed<M>) {
    let hidden = HIDDEN * Bed::<M>::EPSILON.sqrt();
    for step in [1.0, 7.0, 30.0, 45.0, 90.0, 120.0, 180.0, -50.0] {
        let mut bed = bed.fresh();
        for number in 1..=1000_u32 {
            let target = f64::to_radians(60.0 + step * f64::from(number));
            if let Err(stuck) = bed.go(&[target]) {
                // An iteration may stop where the branches meet; the closed form has no reason to.
                panic!("{target}: {stuck:?}");
            }
            let should = four_bar(LENGTHS, bed.motor(), true);
            if should.sine > hidden {
                bed.assert_at(("rocker", [1.0, 0.0]), should.at, should.sine);
            }
        }
    }
}

/// By the interpreter: the generated code of a mechanism that does nothing but stop does not compile yet (it reads `last`,
/// which its step does not take).
fn stops<T: Real>(scalar: &str, method: &str) {
    let text = format!(
        "struct Stopper: {scalar};
        ground {{ point a = (0, 0); point d = (2, 0); }}
        link crank {{ point a = (0, 0); point b = (1, 0); }}
        link coupler {{ point b = (0, 0); point c = (2, 0); }}
        link rocker {{ point d = (0, 0); point c = (1, 0); }}
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        motor ja;
        start {{ ja = 60 deg; rocker near 60 deg; }}
        at change points stop;
        method {method};"
    );
    let model = parse(text.parse().expect("it is Rust")).model;
    let program = compile(&model).expect("it is coherent").program;
    let hidden = HIDDEN * T::EPSILON.sqrt();
    for (target, place) in [(4.0, PI), (3.2, PI), (10.0, PI), (-1.0, 0.0), (-20.0, 0.0)] {
        let mut machine = Machine::<T>::new(&program);
        let start = machine.position().clone();
        let stop = machine.move_to(&[T::from_f64(target)]);
        assert!(matches!(stop, Err(Stop::ChangePoint(_))), "{stop:?}");
        assert_eq!(machine.position(), &start);
        let stop = machine.move_toward(&[T::from_f64(target)]);
        assert!(matches!(stop, Ok(Some(Stop::ChangePoint(_)))), "{stop:?}");
        let reached = machine.position().motors[0].to_f64();
        assert!((reached - place).abs() < hidden, "{target}: {reached}");
        let again = machine.move_to(&[T::from_f64(target)]);
        assert!(matches!(again, Err(Stop::ChangePoint(_))), "{again:?}");
        for angle in [1.0, 2.5] {
            assert_eq!(machine.move_to(&[T::from_f64(angle)]), Ok(()));
            let [cos, sin, ..] = machine.position().poses[2].map(Real::to_f64);
            let (should_sin, should_cos) = machine.position().motors[0].to_f64().sin_cos();
            let off = (cos - should_cos).hypot(sin - should_sin);
            assert!(off < 512.0 * T::EPSILON, "at {angle} off by {off:e}");
        }
    }
}

#[test]
fn in_closed_form_it_stops_at_its_change_points() {
    stops::<f64>("f64", "exact");
    stops::<f32>("f32", "exact");
}

#[test]
fn iterated_it_stops_at_its_change_points() {
    stops::<f64>("f64", "newton");
    stops::<f32>("f32", "newton");
}
