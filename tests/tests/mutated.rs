//! Whatever a text is mangled to, what the macro makes of it is Rust, or says what is wrong at a place. `MECH_CASES=20000` for more.

use mech_compiler::model::{AxisKind, Model};
use mech_compiler::syntax::parse;
use mech_test_support::{Dice, bodies, cases, seeds};
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::quote;

/// Texts with all kinds of statements.
fn texts() -> Vec<TokenStream> {
    const OWN: [&str; 5] = [
        "struct Elsewhere; use crate::legs::Leg; use mech_runtime::parts::JansenLeg; link crank;
        use left: Leg(size = 2) mirrored { crank = crank at (1, 0) }; joint a = revolute(ground, crank) at (0, 0); motor a;",
        "#[allow(dead_code)] pub(crate) struct Drawn: f32; param w = 2; const H = w / 2;
        link crank { circle (0, 0) radius 1 on plane 2 color teal; mass 1 at (1, 0); } link rod; link slider;
        joint a = revolute(ground, crank) at (0, 0); joint b = revolute(crank, rod) at (0.5, 0.8);
        joint c = revolute(rod, slider) at (3, 0); joint d = prismatic(ground, slider) at (3, 0) along (cos(30 deg), -sin(30 deg));
        motor a = 2 * PI * t; accuracy 1e-9; cost cortex_m4f; at change points keep branch; continuous b;
        gravity (0, -9.81); load push = force(slider); effects { velocity; force; trace slider.p 20; }",
        "struct Scene: f32; link crank { circle (0, 0) radius 1; } link rod; link slider;
        joint a = revolute(ground, crank) at (0, 0); joint b = slot(crank, rod) at (0.5, 0.8) along (1, 2);
        joint c = belt(rod, slider, 1.0 : 3.0 on crank); joint f = weld(rod, slider); joint g = weld(crank, ground) at (1, 0);
        joint d = prismatic(ground, slider) at (3, 0) along (cos(30 deg), -sin(30deg)); joint e = rack(crank, slider, radius sqrt(2) / 2 on ground);
        motor a in 0 ..= 2 * PI by 1 deg; accuracy 1e-9; cost cortex_m4f; at change points keep branch; effects { velocity; } show crank, rod.p;
        continuous shaft, drawn; allow coupled; param x = 1; certify;",
        "struct Wheels; link sun; link arm; link planet; part Leg(phase = 0 deg) { port crank { point pin = (1, 0) turned phase; } link foot; joint k = revolute(crank.pin, foot) at (1, 0); }
        joint s = revolute(ground, sun) at (0, 0); joint r = revolute(ground, arm) at (0, 0); joint p = revolute(arm, planet) at (3, 0);
        joint g = gear(sun, planet, 20 : 10 on arm); motor s in 0 deg ..= 90 deg by 1 deg; motor r; show sun, g; allow redundant;",
        "pub Leg(size = 1, phase = 0 deg) { port crank { point pin = (size, 0) turned phase; } link foot { point tip = (0, -size); }
        joint k = revolute(crank.pin, foot); }",
    ];
    let own = OWN.map(|text| text.parse().expect("tokens"));
    let gallery = [
        include_str!("../../examples/gallery/src/mechanisms/four_bar.rs"),
        include_str!("../../examples/gallery/src/mechanisms/rocker_arm.rs"),
        include_str!("../../examples/gallery/src/mechanisms/geared_piston.rs"),
    ];
    own.into_iter()
        .chain(gallery.into_iter().flat_map(bodies))
        .collect()
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
    let words = [
        "use", "fn", "self", "crate", "Self", "_", "r#fn", "struct", "part", "dyn", "other",
    ];
    let words = words.map(|word| word.parse::<TokenStream>().expect("a word"));
    let marks = "::;:#!$,.'=<>".chars().filter(|mark| *mark != '\'');
    let marks = marks.map(|mark| TokenTree::from(Punct::new(mark, Spacing::Alone)));
    let colons: TokenStream = quote!(::);
    let groups = [
        Delimiter::Brace,
        Delimiter::Bracket,
        Delimiter::Parenthesis,
        Delimiter::None,
    ];
    let groups = groups.map(|delimiter| {
        let inside = Ident::new("inside", Span::call_site());
        TokenTree::from(Group::new(delimiter, quote!(#inside ::)))
    });
    words
        .into_iter()
        .flatten()
        .chain(colons)
        .chain(marks)
        .chain(groups)
        .collect()
}

#[test]
fn what_the_macro_makes_of_anything_is_rust() {
    let (texts, strange) = (texts(), strange());
    let krate = quote!(::mech_runtime);
    let mut said = 0;
    for seed in seeds(cases(3000)) {
        let mut dice = Dice::new(seed);
        let mut text = dice.pick(&texts).clone();
        for _ in 0..=dice.below(4) {
            text = mangle(text, &strange, &mut dice);
        }
        let written = text.to_string();
        let part = mech_compiler::expand_part(&text);
        let whole = mech_compiler::expand(quote!(#krate; #text));
        for made in [part, whole] {
            let items = syn::parse2::<syn::File>(made.clone());
            let items =
                items.unwrap_or_else(|wrong| panic!("seed {seed}: {wrong}\n{written}\n{made}"));
            let made = made.to_string();
            assert!(
                !made.contains("internal error"),
                "seed {seed}: {made}\n{written}"
            );
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
        let mut dice = Dice::new(seed);
        let mut text = dice.pick(&texts).clone();
        for _ in 0..=dice.below(6) {
            text = mangle(text, &strange, &mut dice);
        }
        let written = text.to_string();
        let parsed = parse(text);
        for error in &parsed.errors {
            let said = &error.text;
            assert!(
                !said.is_empty() && !said.ends_with('.'),
                "seed {seed}: {said}\n{written}"
            );
        }
        assert!(names_are_distinct(&parsed.model), "seed {seed}: {written}");
        // Links that nobody declared come after those that somebody did.
        let links = &parsed.model.links;
        assert!(
            links.is_sorted_by_key(|link| link.die.is_some()),
            "seed {seed}: {written}"
        );
    }
}

/// Whether all names of the model would make different methods.
fn names_are_distinct(model: &Model) -> bool {
    let links = model
        .declared_links()
        .map(|link| model.link(link).name.clone());
    let joints = model.joints.iter().filter(|joint| !joint.hidden);
    let joints = joints.map(|joint| joint.name.clone());
    let points = model
        .axes
        .iter()
        .filter(|axis| axis.kind == AxisKind::Point);
    let points = points.filter_map(|axis| {
        Some(format!(
            "{}_{}",
            model.link(axis.link).name,
            axis.name.as_ref()?
        ))
    });
    let mut methods: Vec<_> = links.chain(joints).chain(points).collect();
    let count = methods.len();
    methods.sort();
    methods.dedup();
    methods.len() == count
}

/// What is wrong in the path of a part is said there, in the macro's own words.
#[test]
fn a_path_of_a_part_that_is_none() {
    for (path, place, word) in [
        ("other ::", ":", "the name of a part is missing here"),
        (":: ", ":", "the name of a part is missing here"),
        ("other legs", "legs", "expected `::` or `;`, found `legs`"),
        ("other as legs", "as", "expected `::` or `;`, found `as`"),
        (
            "other::fn",
            "fn",
            "expected the name of a module or a part, found `fn`",
        ),
        (
            "other::_",
            "_",
            "expected the name of a module or a part, found `_`",
        ),
        (
            "a::crate::Leg",
            "crate",
            "expected the name of a module or a part, found `crate`",
        ),
        (
            "self",
            "self",
            "expected the name of a module or a part, found `self`",
        ),
        (
            "a:::Leg",
            ":",
            "expected the name of a module or a part, found `:`",
        ),
    ] {
        let text: TokenStream = format!("struct Elsewhere; use {path}; link a;")
            .parse()
            .expect("tokens");
        let import = mech_compiler::Import::first(&text).expect("an import");
        let fault = import.fault().unwrap_or_else(|| panic!("{path} is a path"));
        assert!(fault.text.contains(word), "{path}: {}", fault.text);
        let at = fault.place.start.source_text();
        assert_eq!(at.as_deref(), Some(place), "{path}");
        let made = mech_compiler::expand(quote!(::mech_runtime; #text)).to_string();
        assert!(
            made.contains("compile_error") && made.contains("struct Elsewhere"),
            "{made}"
        );
    }
    for path in [
        "Leg",
        "::legs::Leg",
        "crate::legs::Leg",
        "self::Leg",
        "super::super::Leg",
        "r#fn::Leg",
    ] {
        let text: TokenStream = format!("use {path};").parse().expect("tokens");
        let import = mech_compiler::Import::first(&text).expect("an import");
        assert!(import.fault().is_none(), "{path}");
    }
}
