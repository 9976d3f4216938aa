//! Texts that went through a mill.

use super::model::GEARED_PISTON;
use crate::syntax::parse;
use proc_macro2::{Group, TokenStream, TokenTree};

/// Knuth's linear congruential generator: the same texts each time.
struct Dice(u64);

impl Dice {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % bound
    }
}

const DRAWN: &str = "
struct Drawn: f32;
link crank { circle (0, 0) radius 1; } link rod; link slider;
joint a = revolute(ground, crank) at (0, 0);
joint b = slot(crank, rod) at (0.5, 0.8) along (1, 2);
joint c = belt(rod, slider, 1.0 : 3.0 on crank);
joint f = weld(rod, slider); joint g = weld(crank, ground) at (1, 0);
joint d = prismatic(ground, slider) at (3, 0) along (cos(30 deg), -sin(30deg));
joint e = rack(crank, slider, radius sqrt(2) / 2 on ground);
motor a in 0 ..= 2 * PI by 1 deg;
accuracy 1e-9; cost cortex_m4f; at change points keep branch; effects { velocity; } show crank, rod.p; continuous shaft, drawn; allow coupled; param x = 1; certify;
";

/// Changes one token somewhere, in brackets or out of them.
fn mangle(text: TokenStream, dice: &mut Dice) -> TokenStream {
    let mut trees: Vec<TokenTree> = text.into_iter().collect();
    if trees.is_empty() {
        return TokenStream::new();
    }
    let index = dice.below(trees.len());
    if let TokenTree::Group(group) = &trees[index]
        && dice.below(4) > 0
    {
        let delimiter = group.delimiter();
        trees[index] = Group::new(delimiter, mangle(group.stream(), dice)).into();
        return trees.into_iter().collect();
    }
    let other = dice.below(trees.len());
    match dice.below(5) {
        0 => drop(trees.remove(index)),
        1 => trees.insert(index, trees[index].clone()),
        2 => trees.swap(index, other),
        3 => trees[index] = trees[other].clone(),
        _ => trees.truncate(index),
    }
    trees.into_iter().collect()
}

#[test]
fn nothing_makes_it_panic() {
    let mut dice = Dice(1);
    for text in [GEARED_PISTON, DRAWN] {
        let whole: TokenStream = text.parse().expect("tokens");
        for _ in 0..3000 {
            let mut mangled = whole.clone();
            for _ in 0..=dice.below(6) {
                mangled = mangle(mangled, &mut dice);
            }
            let parsed = parse(mangled);
            for error in &parsed.errors {
                assert!(
                    !error.text.is_empty() && !error.text.ends_with('.'),
                    "{}",
                    error.text
                );
            }
            names_are_distinct(&parsed.model);
            dies_are_last(&parsed.model);
        }
    }
}

/// Whatever was wrong, all names of the model would make different methods.
fn names_are_distinct(model: &crate::model::Model) {
    let links = model
        .declared_links()
        .map(|link| model.link(link).name.clone());
    let joints = model.joints.iter().filter(|joint| !joint.hidden);
    let joints = joints.map(|joint| joint.name.clone());
    let points = model
        .axes
        .iter()
        .filter(|axis| axis.kind == crate::model::AxisKind::Point);
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
    assert_eq!(methods.len(), count);
}

/// Whatever was wrong, links that nobody declared come after those that somebody did.
fn dies_are_last(model: &crate::model::Model) {
    assert!(model.links.is_sorted_by_key(|link| link.die.is_some()));
}
