//! How long `mechanism!` itself takes, from the tokens of the text to those of the code: each mechanism of the gallery, and
//! chains by their number of loops.

use mech_test_support::{GALLERY, bodies, chain_text, median};
use proc_macro2::TokenStream;
use quote::quote;
use std::hint::black_box;
use std::time::Instant;

/// What an expansion in the gallery may take.
const THRESHOLD: f64 = 5.0;

fn main() {
    println!("{:>16} {:>10} {:>12}", "gallery", "ms", "at most");
    let mut slow = Vec::new();
    for (name, source) in GALLERY {
        let bodies = bodies(source);
        assert!(!bodies.is_empty(), "{name} declares a mechanism");
        for body in bodies {
            let time = expansion(&body, 51);
            println!("{name:>16} {time:>10.2} {THRESHOLD:>12.2}");
            if time > THRESHOLD {
                slow.push(name);
            }
        }
    }
    println!("{:>16} {:>10} {:>12}", "loops in a chain", "ms", "ms a loop");
    for (loops, shown) in [(1, 1.0), (10, 10.0), (100, 100.0), (300, 300.0)] {
        let body = chain_text(loops).parse().expect("tokens");
        let time = expansion(&body, 11);
        println!("{loops:>16} {time:>10.2} {:>12.3}", time / shown);
    }
    assert!(slow.is_empty(), "above {THRESHOLD} ms: {slow:?}");
}

/// The median time of one expansion, in milliseconds.
fn expansion(body: &TokenStream, rounds: usize) -> f64 {
    let input = quote!(::mech_runtime; #body);
    let expanded = mech_compiler::expand(input.clone()).to_string();
    assert!(!expanded.contains("compile_error"), "{expanded}");
    median((0..rounds).map(|_| {
        let input = input.clone();
        let start = Instant::now();
        let expanded = black_box(mech_compiler::expand(black_box(input)));
        let time = start.elapsed().as_secs_f64() * 1e3;
        drop(expanded);
        time
    }))
}
