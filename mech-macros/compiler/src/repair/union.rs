//! Pairs of links that a forgotten pin may have joined, where nothing says so but what is free.

use super::Repair;
use super::declaration::{NewKind, NewNames, Purpose, join};
use super::guess::{apex, handy};
use super::sketch::{Sketch, distance};
use super::tie::{Joined, both, gaps};
use super::tie::{Tie, ties};
use crate::model::{JointId, LinkId, Model};
use std::collections::{BTreeMap, BTreeSet};

/// So many pairs are tried.
const MOST: usize = 12;
/// In larger mechanisms there are too many pairs to look at.
const LINKS: usize = 60;

/// The pins between two links of which one at least is free, the likeliest first: of two links that hang on one joint each, then of
/// one. Among these first where the list of joints reads as a chain that comes apart, then those that are near.
pub(super) fn unions(model: &Model, sketch: &Sketch, free: &[JointId]) -> Vec<Repair> {
    if model.links.len() > LINKS {
        return Vec::new();
    }
    let ties = ties(model);
    let places = places(&ties);
    // The halves of a cylinder have what they need.
    let is_half = |link: LinkId| {
        let slides = |tie: &Tie| matches!(tie.kind, NewKind::Prismatic(_)) && tie.has(link);
        link != LinkId::GROUND && places[&link].len() > 1 && ties.iter().any(slides)
    };
    let joined = Joined::of(model);
    let gaps = gaps(model);
    let loose: BTreeSet<LinkId> = free.iter().flat_map(|&joint| both(model, joint)).collect();
    let links: Vec<LinkId> = places.keys().copied().collect();
    let mut found = Vec::new();
    for (number, &b) in links.iter().enumerate() {
        for &a in &links[..number] {
            let is_free = |link: LinkId| link != LinkId::GROUND && loose.contains(&link);
            if !(is_free(a) || is_free(b)) || joined.are_held([a, b]) {
                continue;
            }
            let hangs = |link: LinkId| is_free(link) && places[&link].len() == 1;
            let firm = [a, b].iter().filter(|link| !hangs(**link)).count();
            let both_free = is_free(a) && is_free(b);
            let near = nearest(&places[&a], &places[&b]);
            let is_whole = !gaps.contains(&[a, b]);
            let halves = is_half(a) || is_half(b);
            found.push(((firm, halves, is_whole, !both_free), near, [a, b]));
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let pin = |(.., links): ((usize, bool, bool, bool), f64, [LinkId; 2])| {
        let at = between(links.map(|link| &places[&link][..]), sketch)?;
        let name = NewNames::new(model).like(None, "pin");
        Some(join(Purpose::Meet, name, links, at))
    };
    found.into_iter().take(MOST).filter_map(pin).collect()
}

/// Where the joints of each link are drawn.
fn places(ties: &[Tie]) -> BTreeMap<LinkId, Vec<[f64; 2]>> {
    let mut places: BTreeMap<LinkId, Vec<[f64; 2]>> = BTreeMap::new();
    for tie in ties {
        for link in tie.links {
            places.entry(link).or_default().push(tie.at);
        }
    }
    places
}

fn nearest(some: &[[f64; 2]], others: &[[f64; 2]]) -> f64 {
    let all = some.iter().flat_map(|&a| others.iter().map(move |&b| distance(a, b)));
    all.fold(f64::INFINITY, f64::min)
}

/// A place amid the joints of two links, aside of each of them.
pub(super) fn between(places: [&[[f64; 2]]; 2], sketch: &Sketch) -> Option<[f64; 2]> {
    if let [[p], [q]] = places {
        return Some(apex(*p, *q)).filter(|_| p != q);
    }
    let middles = places.map(|places| {
        let sum = places.iter().fold([0.0, 0.0], |[x, y], at| [x + at[0], y + at[1]]);
        #[expect(clippy::cast_precision_loss, reason = "a link has few joints")]
        let count = places.len() as f64;
        sum.map(|part| part / count)
    });
    let [[a, b], [c, d]] = middles;
    let at = [0.5 * (a + c), 0.5 * (b + d)].map(|part| handy(part, sketch.size));
    let mut known = places.iter().flat_map(|places| places.iter());
    known.all(|&other| !sketch.is_same(other, at)).then_some(at)
}
