//! Repairs as changes of the text: the text after a repair is as right as the repair promised, and everything else in it stays.

use crate::run::{refused, repository};
use mech_compiler::model::Model;
use mech_compiler::repair::{Repair, edits};
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax;
use mech_studio::{Document, Mending, Reading, Remainder, Source, mendings};
use proptest::prelude::*;
use std::fs;

/// Makes every repair of every mechanism of a text; returns how many there are.
fn mend_all(source: Source) -> usize {
    let mut count = 0;
    let document = Document::of(source);
    for (index, declaration) in document.declarations().iter().enumerate() {
        let reading = document.analyse(declaration).expect("the compiler works");
        let found = mendings(&document, declaration, &reading).expect("the compiler works");
        let promised = declaration.body.iter().flat_map(|body| {
            let text = document.source().masked(body);
            promised(&text, &reading)
        });
        let promised: Vec<Model> = promised.collect();
        count += found.len();
        for mending in found {
            examine(&document, index, &mending, &promised);
        }
    }
    count
}

/// Reads the models after each repair that the compiler offers for a text: it changes tokens, and reads a few of them again.
fn promised(text: &str, reading: &Reading) -> Vec<Model> {
    let Err(faults) = &reading.result else {
        return Vec::new();
    };
    proc_macro2::extra::invalidate_current_thread_spans();
    let source = syntax::Source::read(text.parse().expect("tokens"));
    let alone = |repairs: &[Repair]| -> Vec<Vec<Repair>> {
        repairs.iter().map(|repair| vec![repair.clone()]).collect()
    };
    let offered = faults.offers.iter().flat_map(|offers| {
        let coupled = offers.coupled.iter();
        let coupled = coupled.map(|repair| vec![repair.clone(), Repair::AllowCoupled]);
        let pairs = offers.pairs.iter().map(|pair| pair.to_vec());
        let lists = [&offers.single, &offers.elsewhere, &offers.partial];
        let single = lists.into_iter().flat_map(|list| alone(list));
        single.chain(coupled).chain(pairs).collect::<Vec<_>>()
    });
    let edits = offered.filter_map(|repairs| edits(&repairs, &reading.model, source.tokens()));
    edits.filter_map(|edits| source.model_with(&edits)).collect()
}

/// The text after a repair compiles as the repair promised, and has everything that the repair did not change.
fn examine(document: &Document, index: usize, mending: &Mending, promised: &[Model]) {
    let text = &*mending.text;
    let path = document.source().path();
    let said = format!("{}: {}\n{text}", path.display(), mending.words);
    let after = Document::of(Source::new(path, text));
    assert_eq!(after.declarations().len(), document.declarations().len(), "{said}");
    let reading = after.analyse(&after.declarations()[index]).expect("the compiler works");
    let is_choice = mending.words.contains(" near ");
    let is_slip = is_small_change(document.source().text(), text);
    assert!(is_choice || is_slip || promised.contains(&reading.model), "{said}");
    let is_enough = |result: Result<(), &[Diagnosis]>| match result {
        Ok(()) | Err([Diagnosis::SeveralAssemblies { .. }]) => true,
        Err(_) => false,
    };
    let found = reading.result.as_ref().map(drop);
    let found = found.map_err(|faults| &faults.diagnoses[..]);
    let is_start = |faults: &[Diagnosis]| {
        matches!(faults, [Diagnosis::CannotClose { .. } | Diagnosis::DeadStart { .. }])
    };
    let is_as_promised = match mending.remainder {
        Remainder::Nothing => is_enough(found) || found.is_err_and(is_start),
        Remainder::OtherStart => found.is_err_and(is_start),
        Remainder::OtherFaults => !is_enough(found),
    };
    assert!(is_as_promised, "{said}");
    // Comments that belong to nothing stand between all statements of some texts.
    let marks = |text: &str| text.matches("/*").count();
    assert_eq!(marks(text), marks(document.source().text()), "{said}");
    let outside = |document: &Document, text: &str| {
        let whole = &document.declarations()[index].whole;
        (text[..whole.start].to_owned(), text[whole.end..].to_owned())
    };
    assert_eq!(outside(&after, text), outside(document, document.source().text()), "{said}");
}

/// Whether two texts differ by a statement or less, in one place.
fn is_small_change(before: &str, after: &str) -> bool {
    const SMALL: usize = 160;
    let alike = |a: &mut dyn Iterator<Item = u8>, b: &mut dyn Iterator<Item = u8>| {
        a.zip(b).take_while(|(a, b)| a == b).count()
    };
    let start = alike(&mut before.bytes(), &mut after.bytes());
    let [before, after] = [before, after].map(|text| &text.as_bytes()[start..]);
    let end = alike(&mut before.iter().rev().copied(), &mut after.iter().rev().copied());
    before.len().max(after.len()) - end <= SMALL
}

/// The blocks of text in a page of documentation, each as a file of its own.
fn examples(page: &str) -> Vec<String> {
    let blocks = page.split("```text\n").skip(1);
    let blocks = blocks.filter_map(|block| Some(block.split_once("```")?.0.to_owned()));
    blocks.filter(|block| block.starts_with("struct ")).collect()
}

/// Formulas are looked up in a map, whose order is another in each.
#[test]
fn params_do_not_hinder_repairs() {
    let text = "struct Bar; param a = 1.5; param b = 2.5; param c = 0.5;
        link bar { point o = (0, 0); point e = (a, b); point f = (c * a, b); }
        joint j = revolute(ground, bar) at (0, 0);";
    for _ in 0..16 {
        assert_eq!(mend_all(Source::new("bar.mech", text)), 1);
    }
}

#[test]
fn mechanisms_with_every_diagnosis() {
    let mut count = 0;
    let page = fs::read_to_string(repository("docs/diagnoses.md")).expect("the page");
    for text in examples(&page) {
        count += mend_all(Source::new("a.mech", text));
    }
    for path in refused().into_iter().flat_map(|(_, cases)| cases) {
        count += mend_all(Source::read(&path).expect("a case"));
    }
    assert!(count > 100, "{count} repairs");
}

/// Mechanisms that are coherent, between empty lines, with a statement in each line: a name, then what may be broken.
const COHERENT: &str = include_str!("coherent.txt");

/// Statements that break a mechanism if they are added.
const TOO_MUCH: [&str; 3] = [
    "motor MORE;",
    "link brace; joint brace1 = revolute(FIRST, brace) at (0.5, 0.5); joint brace2 = revolute(SECOND, brace) at (2, 1);",
    "link spare;",
];

fn names<'s>(statements: &'s str, word: &str) -> Vec<&'s str> {
    let declared = statements.lines().filter_map(|one| {
        let name = one.trim().strip_prefix(word)?.trim_start();
        name.split(|letter: char| !letter.is_alphanumeric()).next()
    });
    declared.collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn mechanisms_that_were_broken(
        which in prop::sample::select(COHERENT.split("\n\n").collect::<Vec<_>>()),
        out in prop::collection::vec(any::<prop::sample::Index>(), 0..3),
        more in prop::option::of((0..TOO_MUCH.len(), any::<prop::sample::Index>(), any::<prop::sample::Index>())),
        lines in any::<bool>(),
    ) {
        let mut statements: Vec<String> = which.lines().map(str::to_owned).collect();
        if let Some((what, first, second)) = more {
            let (joints, links) = (names(which, "joint"), names(which, "link"));
            let text = TOO_MUCH[what].replace("MORE", joints[first.index(joints.len())]);
            let text = text.replace("FIRST", links[first.index(links.len())]);
            statements.push(text.replace("SECOND", links[second.index(links.len())]));
        }
        for index in out {
            // The name stays.
            statements.remove(1 + index.index(statements.len() - 1));
        }
        let between = if lines { " /* kept */\n    " } else { " /* kept */ " };
        let text = statements.join(between);
        mend_all(Source::new("a.mech", text));
    }
}
