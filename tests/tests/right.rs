//! Texts of `tests/cases/right/`: each compiles and expands to Rust, and what stands above it is true of it.
//!
//! Texts stand between empty lines. Facts are judged, never renewed:
//!
//! - `//= ` begins a line of the report, `//+ ` words in it, and `//- ` words that it has nowhere.
//! - `//box ` begins the least x and y, and the greatest, of what may be seen however it moves.
//! - `//^` begins a block that stands before each of the texts below, until the next one.
//! - `//!` stands above a text that does not follow such a block.

use super::looks::compiled;
use mech_test_support::folder;

/// Whether a fact is true of a mechanism, if a line is one.
fn is_true(line: &str, report: &str, seen: &[f64]) -> bool {
    if let Some(whole) = line.strip_prefix("//= ") {
        return report.lines().any(|line| line.trim() == whole);
    }
    if let Some(words) = line.strip_prefix("//+ ") {
        return report.contains(words);
    }
    if let Some(words) = line.strip_prefix("//- ") {
        return !report.contains(words);
    }
    let Some(expected) = line.strip_prefix("//box ") else {
        // What is misspelt is no fact.
        return !line.starts_with("//") || line.starts_with("// ");
    };
    let expected = expected.split(' ').map(str::parse::<f64>);
    let expected: Vec<f64> = expected.collect::<Result<_, _>>().expect("numbers");
    let mut pairs = seen.iter().zip(&expected);
    expected.len() == 4 && pairs.all(|(is, should)| (is - should).abs() < 1e-6)
}

fn check(text: &str) {
    let (model, compiled, looks) = compiled(text);
    let seen = looks.extent(&model, &compiled);
    for line in text.lines() {
        let (report, seen) = (&compiled.report, seen.as_flattened());
        assert!(is_true(line, report, seen), "{line}\n{text}\n{report}{seen:?}");
    }
    let tokens: proc_macro2::TokenStream = text.parse().expect("tokens");
    let expansion = mech_compiler::expand(quote::quote!(::mech_runtime; #tokens));
    syn::parse2::<syn::File>(expansion).expect("the expansion is Rust");
}

#[test]
fn what_is_right_compiles_and_is_as_it_says() {
    let mut count = 0;
    for case in folder("right") {
        let mut before = "";
        for block in case.text.split("\n\n") {
            if let Some(shared) = block.strip_prefix("//^") {
                before = shared;
            } else if !block.lines().all(|line| line.starts_with("// ")) {
                let own = block.strip_prefix("//!").map(ToOwned::to_owned);
                check(&own.unwrap_or_else(|| format!("{before}\n{block}")));
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count}");
}
