//! Whatever a text is mangled to, what the macro makes of it is Rust, or says what is wrong at a place. `MECH_CASES=20000` for more.

use mech_compiler::model::{AxisKind, Model};
use mech_compiler::syntax::parse;
use mech_test_support::{Dice, bodies, cases, folder, seeds};
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::quote;

/// Texts with all kinds of statements.
fn texts() -> Vec<TokenStream> {
    let own = folder("mangled").into_iter();
    let own = own.map(|case| case.text.parse().expect("tokens"));
    let gallery = [
        include_str!("../../examples/gallery/src/mechanisms/four_bar.rs"),
        include_str!("../../examples/gallery/src/mechanisms/rocker_arm.rs"),
        include_str!("../../examples/gallery/src/mechanisms/geared_piston.rs"),
    ];
    own.chain(gallery.into_iter().flat_map(bodies)).collect()
}

/// Changes one token somewhere, in brackets or out of them.
fn mangle(text: TokenStream, strange: &[TokenTree], dice: &mut Dice) -> TokenStream {
    let mut trees: Vec<TokenTree> = text.into_iter().collect();
    if trees.is_empty() {
        return trees.into_iter().collect();
    }
    let index = dice.below(trees.len());
    if let TokenTree::Group(group) = &trees[index]
        && !dice.once_in(4)
    {
        let inside = mangle(group.stream(), strange, dice);
        trees[index] = Group::new(group.delimiter(), inside).into();
        return trees.into_iter().collect();
    }
    let other = dice.below(trees.len());
    match dice.below(7) {
        0 => drop(trees.remove(index)),
        1 => trees.insert(index, trees[index].clone()),
        2 => trees.swap(index, other),
        3 => trees[index] = trees[other].clone(),
        4 => trees[index] = dice.pick(strange).clone(),
        5 => trees.insert(index, dice.pick(strange).clone()),
        _ => trees.truncate(index),
    }
    trees.into_iter().collect()
}

/// Tokens that stand in no text.
fn strange() -> Vec<TokenTree> {
    let words =
        ["use", "fn", "self", "crate", "Self", "_", "r#fn", "struct", "part", "dyn", "other"];
    let words = words.map(|word| word.parse::<TokenStream>().expect("a word"));
    let marks = "::;:#!$,.'=<>".chars().filter(|mark| *mark != '\'');
    let marks = marks.map(|mark| TokenTree::from(Punct::new(mark, Spacing::Alone)));
    let colons: TokenStream = quote!(::);
    let groups = [Delimiter::Brace, Delimiter::Bracket, Delimiter::Parenthesis, Delimiter::None];
    let groups = groups.map(|delimiter| {
        let inside = Ident::new("inside", Span::call_site());
        TokenTree::from(Group::new(delimiter, quote!(#inside ::)))
    });
    words.into_iter().flatten().chain(colons).chain(marks).chain(groups).collect()
}

/// One of the texts, with up to so many tokens changed.
fn mangled(texts: &[TokenStream], strange: &[TokenTree], seed: u64, most: usize) -> TokenStream {
    let mut dice = Dice::new(seed);
    let text = dice.pick(texts).clone();
    let changes = 0..=dice.below(most);
    changes.fold(text, |text, _| mangle(text, strange, &mut dice))
}

#[test]
fn what_the_macro_makes_of_anything_is_rust() {
    let (texts, strange) = (texts(), strange());
    let krate = quote!(::mech_runtime);
    let mut said = 0;
    for seed in seeds(cases(3000)) {
        let text = mangled(&texts, &strange, seed, 4);
        let written = text.to_string();
        let part = mech_compiler::expand_part(&text);
        let whole = mech_compiler::expand(quote!(#krate; #text));
        for made in [part, whole] {
            let items = syn::parse2::<syn::File>(made.clone());
            let items =
                items.unwrap_or_else(|wrong| panic!("seed {seed}: {wrong}\n{written}\n{made}"));
            let made = made.to_string();
            assert!(!made.contains("internal error"), "seed {seed}: {made}\n{written}");
            said += usize::from(made.contains("compile_error"));
            // A text without a single item is not even a message.
            assert!(!items.items.is_empty(), "seed {seed}: {written}");
        }
    }
    assert!(said > 0);
}

/// Whatever was wrong is said in words, and what is left is a model without doubles.
#[test]
fn what_is_read_of_anything_is_in_order() {
    let (texts, strange) = (texts(), strange());
    for seed in seeds(cases(6000)) {
        let text = mangled(&texts, &strange, seed, 6);
        let written = text.to_string();
        let parsed = parse(text);
        for error in &parsed.errors {
            let said = &error.text;
            assert!(!said.is_empty() && !said.ends_with('.'), "seed {seed}: {said}\n{written}");
        }
        assert!(names_are_distinct(&parsed.model), "seed {seed}: {written}");
        // Links that nobody declared come after those that somebody did.
        let links = &parsed.model.links;
        assert!(links.is_sorted_by_key(|link| link.die.is_some()), "seed {seed}: {written}");
    }
}

/// Whether all names of the model would make different methods.
fn names_are_distinct(model: &Model) -> bool {
    let links = model.declared_links().map(|link| model.link(link).name.clone());
    let joints = model.joints.iter().filter(|joint| !joint.hidden);
    let joints = joints.map(|joint| joint.name.clone());
    let points = model.axes.iter().filter(|axis| axis.kind == AxisKind::Point);
    let points = points
        .filter_map(|axis| Some(format!("{}_{}", model.link(axis.link).name, axis.name.as_ref()?)));
    let mut methods: Vec<_> = links.chain(joints).chain(points).collect();
    let count = methods.len();
    methods.sort();
    methods.dedup();
    methods.len() == count
}

/// What is wrong in the path of a part is said there, in the macro's own words.
#[test]
fn a_path_of_a_part_that_is_none() {
    const MISSING: &str = "the name of a part is missing here";
    const NEXT: &str = "expected `::` or `;`";
    const NAME: &str = "expected the name of a module or a part";
    for (path, place, said) in [
        ("other ::", ":", MISSING),
        (":: ", ":", MISSING),
        ("other legs", "legs", NEXT),
        ("other as legs", "as", NEXT),
        ("other::fn", "fn", NAME),
        ("other::_", "_", NAME),
        ("a::crate::Leg", "crate", NAME),
        ("self", "self", NAME),
        ("a:::Leg", ":", NAME),
    ] {
        let text: TokenStream =
            format!("struct Elsewhere; use {path}; link a;").parse().expect("tokens");
        let import = mech_compiler::Import::first(&text).expect("an import");
        let fault = import.fault().unwrap_or_else(|| panic!("{path} is a path"));
        let found = format!("{said}, found `{place}`");
        let words = if said == MISSING { said } else { &found };
        assert!(fault.text.contains(words), "{path}: {}", fault.text);
        let at = fault.place.start.source_text();
        assert_eq!(at.as_deref(), Some(place), "{path}");
        let made = mech_compiler::expand(quote!(::mech_runtime; #text)).to_string();
        assert!(made.contains("compile_error") && made.contains("struct Elsewhere"), "{made}");
    }
    let right = "Leg ::legs::Leg crate::legs::Leg self::Leg super::super::Leg r#fn::Leg";
    for path in right.split(' ') {
        let text: TokenStream = format!("use {path};").parse().expect("tokens");
        let import = mech_compiler::Import::first(&text).expect("an import");
        assert!(import.fault().is_none(), "{path}");
    }
}
