//! How long random mechanisms take from their text to the code: the slowest, one of a hundred, and what of that is the picture's box.
//! `cargo bench -p mech-tests --bench slowest`; `MECH_CASES` says how many, and names of files after `--` are timed instead.

use mech_compiler::model::Model;
use mech_compiler::{analyse, expand, looks};
use mech_test_support::{
    Dice, add_cam, cases, chain, grow, grow_coupled, painted_outside, seeds, text, worked,
};
use proc_macro2::TokenStream;
use quote::quote;

/// What the slowest expansion may take, and the box of any, in milliseconds.
const MOST: f64 = 2_000.0;
const MOST_OF_BOX: f64 = 50.0;

/// What one mechanism took, in milliseconds.
struct Taken {
    text: String,
    analysis: f64,
    looks: f64,
    extent: f64,
    expansion: f64,
    /// How far anything is painted outside of the box.
    outside: f64,
    motors: usize,
}

fn main() {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let files = files.iter().filter(|name| !name.starts_with("--"));
    let texts: Vec<String> =
        files.map(|name| std::fs::read_to_string(name).expect("a text")).collect();
    let texts =
        if texts.is_empty() { seeds(cases(2_000)).map(random_text).collect() } else { texts };
    let mut all: Vec<Taken> = texts.into_iter().filter_map(taken).collect();
    #[expect(clippy::type_complexity, reason = "a table")]
    let parts: [(&str, fn(&Taken) -> f64); 4] = [
        ("analysis", |taken| taken.analysis),
        ("looks", |taken| taken.looks),
        ("box", |taken| taken.extent),
        ("expansion", |taken| taken.expansion),
    ];
    println!(
        "{:>10} {:>10} {:>10} {:>10} of {} that move",
        "ms",
        "median",
        "99 %",
        "slowest",
        all.len()
    );
    for (name, part) in parts {
        all.sort_by(|a, b| part(a).total_cmp(&part(b)));
        let at = |share: usize| part(&all[(all.len() - 1) * share / 100]);
        println!("{name:>10} {:>10.2} {:>10.2} {:>10.2}", at(50), at(99), at(100));
    }
    let boxes: f64 = all.iter().map(|taken| taken.extent).sum();
    let whole: f64 = all.iter().map(|taken| taken.expansion).sum();
    println!("boxes are {:.1} % of all expansions", 100.0 * boxes / whole);
    for several in [false, true] {
        let of = || all.iter().filter(move |taken| (taken.motors > 1) == several);
        let outside = of().filter(|taken| taken.outside > 1e-6).count();
        let worst = of().map(|taken| taken.outside).fold(0.0, f64::max);
        println!(
            "several motors: {several}: painted outside {outside} of {}, at most {worst:.1e} of the box",
            of().count()
        );
    }
    if let Some(worst) = all.iter().max_by(|a, b| a.outside.total_cmp(&b.outside)) {
        println!("worst: {:e}\n{}", worst.outside, worst.text);
    }
    for taken in all.iter().rev().take(1) {
        println!(
            "\nanalysis {:.1}, looks {:.1}, box {:.1}, expansion {:.1} ms:\n{}",
            taken.analysis, taken.looks, taken.extent, taken.expansion, taken.text
        );
    }
    let slow = all.iter().filter(|taken| taken.expansion > MOST || taken.extent > MOST_OF_BOX);
    assert!(
        slow.count() == 0,
        "an expansion took more than {MOST} ms, or a box more than {MOST_OF_BOX}"
    );
}

/// A mechanism of any kind.
fn random_text(seed: u64) -> String {
    let mut dice = Dice::new(seed);
    let additions = 1 + dice.below(12);
    let model: Model = match seed % 8 {
        0..=3 => grow(&mut dice, additions).model,
        4 | 5 => grow_coupled(&mut dice, additions.min(6)).model,
        6 => {
            let mut model = grow(&mut dice, additions).model;
            add_cam(&mut model, &mut dice);
            model
        }
        _ => chain(1 + dice.below(40)),
    };
    let mut text = text(&model);
    match dice.below(8) {
        0 => text += "accuracy 1e-3;\n",
        1 => text = text.replacen("motor j0;", "motor j0 by 0.5 deg;", 1),
        _ => {}
    }
    text
}

/// How long everything takes; none of what does not move.
fn taken(text: String) -> Option<Taken> {
    let body: TokenStream = text.parse().expect("tokens");
    let start = worked();
    let analysis = analyse(body.clone());
    let compiled = analysis.result.ok()?;
    let analysed = worked();
    let model = &analysis.parsed.model;
    let looks = looks(model, &compiled);
    let looked = worked();
    let _ = looks.extent(model, &compiled);
    let boxed = worked();
    let expanded = expand(quote!(::mech_runtime; #body));
    let end = worked();
    assert!(!expanded.to_string().contains("compile_error"), "{text}");
    let mut dice = Dice::new(text.len() as u64);
    Some(Taken {
        analysis: analysed - start,
        looks: looked - analysed,
        extent: boxed - looked,
        expansion: end - boxed,
        outside: painted_outside(model, &compiled, &mut dice, 200),
        motors: model.motors.len(),
        text,
    })
}
