//! The hard cases, each by name, in both precisions and by every method that applies: texts of `tests/cases/hard/`.
//!
//! What must come out is a formula of the motor's value `t`, or plain geometry in double precision ([`geometry`]); that links keep their
//! lengths and pins their places is read off the declaration and the poses alone ([`bed`]). Above a text stand such facts:
//!
//! - `// by exact newton_f64`: its methods, in both precisions or in one.
//! - `// with WORD 1, 2: exact newton`: each of these numbers stands for the word, and these are its methods.
//! - `// expanded`: generated code gives the bits of the interpreter, too (`tests/tests/alike.rs`).
//! - `// point rocker 1 0 = cos(t), 2 sine sin(t)`: where a point of a link is, and the sine of the transmission angle, by which rounding
//!   is greater; `within 8` are so many roundings instead. `four_bar 4 1 2 1.5` and `slider_crank 1 3 0` have both. `// seen` is held only
//!   where rounding does not hide the side.
//! - `// at PI / 6: rocker 1 0 = 1, 2` is so at one value. It is come to by degrees.
//!
//! The other facts are moves ([`moves`]), after each of which all points are looked at.

mod bed;
mod geometry;
mod moves;
mod sizes;
mod turns;

use bed::{Bed, Tried};
use geometry::Expected;
use mech_compiler::compile;
use mech_compiler::model::{Method, Precision};
use mech_compiler::program::Real;
use mech_test_support::{Case, folder, model};
use std::thread;

/// A method by its name, and the precisions in which it is tried.
fn method(name: &str) -> (Method, Vec<Precision>) {
    let both = vec![Precision::F64, Precision::F32];
    let (name, precisions) = match name.strip_suffix("_f64") {
        Some(name) => (name, vec![Precision::F64]),
        None => (name, both),
    };
    let method = match name {
        "exact" => Method::Exact,
        "newton" => Method::Newton,
        "newton_3" => Method::NewtonSteps(3),
        "newton_4" => Method::NewtonSteps(4),
        "linear" => Method::Linear,
        _ => panic!("no method: {name}"),
    };
    (method, precisions)
}

/// Makes all moves of a text by one method. Gives how many facts are moves.
fn hold<T: Real>(case: &Case, method: Method, precision: Precision) -> usize {
    let mut model = model(&case.text);
    (model.method, model.precision) = (Some(method), precision);
    let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{}: {wrong:?}", case.name));
    let tried = Tried::new(&model, &compiled.program);
    let points = |word: &'static str| case.marks(word).map(Expected::new);
    let points = points("point ").chain(points("seen ").map(Expected::where_seen));
    let bed = Bed::<T>::new(&tried, points.collect());
    let moves = case.marks("").filter(|fact| moves::make(&bed, fact));
    moves.count()
}

/// A text with each of its numbers, and the methods by which it is tried.
fn variants(case: &Case) -> Vec<(Case, String)> {
    let plain = case.marks("by ");
    let plain = plain.map(|methods| (case.text.clone(), methods.to_owned()));
    let with = case.marks("with ").flat_map(|fact| {
        let (word, rest) = fact.split_once(' ').expect("a word and numbers");
        let (values, methods) = rest.rsplit_once(": ").expect("numbers and methods");
        let each = values.split(", ");
        each.map(move |value| (case.text.replace(word, value), methods.to_owned()))
    });
    let named = |(text, methods)| {
        let name = case.name.clone();
        (Case { name, text }, methods)
    };
    plain.chain(with).map(named).collect()
}

fn hold_by_all((case, methods): &(Case, String)) {
    for name in methods.split(' ') {
        let (method, precisions) = method(name);
        for precision in precisions {
            let count = match precision {
                Precision::F64 => hold::<f64>(case, method, precision),
                Precision::F32 => hold::<f32>(case, method, precision),
            };
            assert!(count > 0, "{}: it is not moved", case.name);
        }
    }
}

/// Each text has a thread of its own.
#[test]
fn hard_cases_are_what_stands_above_them() {
    let cases = folder("hard");
    assert!(cases.len() > 30, "{}", cases.len());
    let all = thread::scope(|scope| {
        let each = cases.iter().map(|case| {
            let judge = || variants(case).iter().for_each(hold_by_all);
            let named = thread::Builder::new().name(case.name.clone());
            named.spawn_scoped(scope, judge).expect("a thread")
        });
        let each: Vec<_> = each.collect();
        let failed = each.into_iter().zip(&cases).filter_map(|(thread, case)| {
            let outcome = thread.join();
            outcome.is_err().then_some(&case.name[..])
        });
        failed.collect::<Vec<&str>>()
    });
    assert!(all.is_empty(), "{all:?}");
}
