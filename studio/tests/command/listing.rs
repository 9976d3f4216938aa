//! The places of names and numbers.

use crate::run::{refused, repository};
use mech_compiler::syntax::{self, Edits};
use mech_studio::{Document, Listing, Source};
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::fs;
use std::ops::Range;
use std::path::PathBuf;

/// Files with mechanisms: the gallery, examples, and what is refused.
fn files() -> Vec<PathBuf> {
    let folders = ["examples/gallery/src/mechanisms", "examples"];
    let entries =
        folders.iter().flat_map(|folder| fs::read_dir(repository(folder)).expect("a folder"));
    let paths = entries.map(|entry| entry.expect("a file").path());
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect();
    paths.sort();
    paths.extend(refused().into_iter().flat_map(|(_, cases)| cases));
    paths
}

/// The places of all literals that are numbers.
fn literals(tokens: TokenStream, found: &mut BTreeSet<(usize, usize)>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => literals(group.stream(), found),
            TokenTree::Literal(literal)
                if literal.to_string().starts_with(|first: char| first.is_ascii_digit()) =>
            {
                let range = literal.span().byte_range();
                found.insert((range.start, range.end));
            }
            _ => {}
        }
    }
}

/// The listings of all mechanisms of a file that are right, with their bodies.
fn listings(document: &Document) -> Vec<(Listing, Range<usize>)> {
    let declarations = document.declarations().iter();
    let right = declarations.filter_map(|declaration| {
        let reading = document.analyse(declaration).expect("the compiler works");
        let is_read =
            reading.result.as_ref().err().is_none_or(|faults| !faults.diagnoses.is_empty());
        let listing = document.listing(declaration).expect("the compiler works");
        let body = declaration.body.clone();
        listing.zip(body).filter(|_| is_read)
    });
    right.collect()
}

#[test]
fn every_number_of_a_text_has_its_place() {
    let mut total = 0;
    for path in files() {
        let document = Document::of(Source::read(&path).expect("a file"));
        for (listing, body) in listings(&document) {
            let masked = document.source().masked(&body);
            proc_macro2::extra::invalidate_current_thread_spans();
            let mut expected = BTreeSet::new();
            literals(masked.parse().expect("tokens"), &mut expected);
            let colors = listing.numbers.iter().filter(|one| one.role.ends_with("color"));
            let colors: Vec<&Range<usize>> = colors.map(|one| &one.place).collect();
            expected.retain(|(start, end)| {
                !colors.iter().any(|range| range.start <= *start && *end <= range.end)
            });
            let listed = listing.numbers.iter().flat_map(|one| &one.literals);
            let listed: Vec<(usize, usize)> =
                listed.map(|range| (range.start, range.end)).collect();
            total += listed.len();
            let found: BTreeSet<(usize, usize)> = listed.iter().copied().collect();
            // Each once.
            assert_eq!(found.len(), listed.len(), "{}", path.display());
            let text = document.source().text();
            let missing: Vec<&str> = expected
                .symmetric_difference(&found)
                .map(|(start, end)| &text[*start..*end])
                .collect();
            assert!(missing.is_empty(), "{}: {missing:?}", path.display());
        }
    }
    assert!(total > 1000, "{total} numbers");
}

#[test]
fn every_name_stands_at_its_place() {
    let mut total = 0;
    for path in files() {
        let document = Document::of(Source::read(&path).expect("a file"));
        let text = document.source().text();
        for (listing, body) in listings(&document) {
            total += listing.names.len();
            for name in &listing.names {
                let word = name.path.rsplit('.').next().expect("a word");
                assert_eq!(&text[name.place.clone()], word, "{}", path.display());
                assert!(body.start <= name.place.start && name.place.end <= body.end);
            }
            for number in &listing.numbers {
                assert!(body.start <= number.place.start && number.place.end <= body.end);
                let inner = |range: &Range<usize>| {
                    number.place.start <= range.start && range.end <= number.place.end
                };
                assert!(number.literals.iter().all(inner), "{number:?}");
            }
        }
    }
    assert!(total > 1000, "{total} names");
}

#[test]
fn a_statement_that_is_read_alone_means_the_same() {
    let mut total = 0;
    for path in files() {
        let document = Document::of(Source::read(&path).expect("a file"));
        for body in document.declarations().iter().filter_map(|one| one.body.clone()) {
            let masked = document.source().masked(&body);
            proc_macro2::extra::invalidate_current_thread_spans();
            let tokens: TokenStream = masked.parse().expect("tokens");
            let parsed = syntax::parse(tokens.clone());
            let is_right = parsed.errors.is_empty() && parsed.header.is_some();
            let model = is_right.then_some(parsed.model);
            let source = syntax::Source::read(tokens);
            let places: Vec<Range<usize>> =
                source.tokens().places().map(|place| place.start.byte_range()).collect();
            for statement in source.tokens().statements().iter().skip(1) {
                let range = statement.range();
                let text = &masked[places[range.start].start..places[range.end - 1].end];
                let with = |by: String| {
                    let mut edits = Edits::default();
                    edits.replace(range.clone(), by);
                    source.model_with(&edits)
                };
                // A statement that is wrong is not one: then the whole text has to be read.
                let again = with(text.to_owned());
                assert!(again == model, "{}: {text}", path.display());
                // Two statements are not one.
                assert!(with([text, text].concat()).is_none());
                total += usize::from(model.is_some());
            }
            let unchanged = source.model_with(&Edits::default());
            assert!(unchanged == model, "{}", path.display());
        }
    }
    assert!(total > 500, "{total} statements");
}
