//! Joints whose twin is there: parts of a mechanism are drawn twice, mirrored, turned by half a turn or moved, and one of them lacks it.

use super::declaration::{Declaration, Ends, NewJoint, NewNames, Purpose};
use super::guess::handy;
use super::sketch::{Sketch, distance};
use super::tie::{Tie, ties};
use super::{NewKind, Repair};
use crate::model::{LinkId, Model};
use std::collections::BTreeMap;

/// Twins are drawn by hand: so far they are off, as a part of the size.
const OFF: f64 = 0.03;
/// The same of what is moved without being turned.
const COPIED: f64 = 0.001;
/// Directions that differ by less are the same.
const ASKEW: f64 = 0.05;
/// In larger drawings it takes too long to look for twins.
const LARGEST: usize = 30;
/// So many are offered.
const FEW: usize = 4;

/// How one part of a drawing becomes another.
#[derive(Clone, Copy)]
struct Image {
    turn: [f64; 2],
    shift: [f64; 2],
}

impl Image {
    fn place(self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|part| self.turn[part] * at[part] + self.shift[part])
    }

    fn kind(self, kind: NewKind) -> NewKind {
        let turned = |along: [f64; 2]| [0, 1].map(|part| self.turn[part] * along[part] + 0.0);
        match kind {
            NewKind::Prismatic(along) => NewKind::Prismatic(turned(along)),
            NewKind::Slot(along) => NewKind::Slot(turned(along)),
            other => other,
        }
    }
}

fn is_alike(a: NewKind, b: NewKind) -> bool {
    match (a, b) {
        (NewKind::Prismatic([a, b]), NewKind::Prismatic([c, d]))
        | (NewKind::Slot([a, b]), NewKind::Slot([c, d])) => (a * d - b * c).abs() < ASKEW,
        _ => a == b,
    }
}

/// The joints that would complete the likeness of two parts, those first that leave the fewest differences.
pub(super) fn twins(model: &Model, sketch: &Sketch) -> Vec<Repair> {
    const TURNS: [[f64; 2]; 4] = [[1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, 1.0]];
    let ties = ties(model);
    if ties.len() > LARGEST {
        return Vec::new();
    }
    let near = OFF * sketch.size;
    let mut found: Vec<((usize, usize), Repair)> = Vec::new();
    let mut seen: Vec<Image> = Vec::new();
    for (number, first) in ties.iter().enumerate() {
        for second in &ties[..number] {
            for turn in TURNS {
                let shift = [0, 1].map(|part| first.at[part] - turn[part] * second.at[part]);
                let image = Image { turn, shift };
                let is_known =
                    |other: &Image| other.turn == turn && distance(other.shift, shift) < 0.1 * near;
                if !is_alike(image.kind(second.kind), first.kind) || seen.iter().any(is_known) {
                    continue;
                }
                seen.push(image);
                found.extend(completed(model, sketch, &ties, image));
            }
        }
    }
    found.sort_by_key(|one| one.0);
    let mut repairs: Vec<Repair> = found.into_iter().map(|(_, repair)| repair).collect();
    repairs.dedup();
    repairs.truncate(FEW);
    repairs
}

/// The one joint that lacks its image, with the number of differences and of likenesses; none if the parts are not alike.
fn completed(
    model: &Model,
    sketch: &Sketch,
    ties: &[Tie],
    image: Image,
) -> Option<((usize, usize), Repair)> {
    // What is moved along is copied by number.
    let is_moved = image.turn == [1.0, 1.0];
    let near = if is_moved { COPIED } else { OFF } * sketch.size;
    let is_there = |tie: &Tie, other: &Tie| {
        is_alike(image.kind(tie.kind), other.kind)
            && distance(image.place(tie.at), other.at) <= near
    };
    let pairs: Vec<(&Tie, &Tie)> = ties
        .iter()
        .flat_map(|tie| {
            let there: Vec<&Tie> = ties.iter().filter(|other| is_there(tie, other)).collect();
            // What is on the axis of a mirror is its own image, unless it has another.
            let is_alone = there.len() == 1;
            let others = there.into_iter();
            let others = others.filter(move |other| is_alone || !std::ptr::eq(*other, tie));
            others.map(move |other| (tie, other))
        })
        .collect();
    let images = images(&pairs);
    let both = |tie: &Tie| {
        let [a, b] = tie.links.map(|link| images.get(&link).copied());
        Some([a?, b?])
    };
    let joins = |tie: &Tie, links: [LinkId; 2]| links.iter().all(|link| tie.has(*link));
    // A guide does its work wherever it is.
    let is_parallel = |tie: &Tie, other: &Tie, links| {
        let is_guide = matches!(other.kind, NewKind::Prismatic(_));
        is_guide && is_alike(image.kind(tie.kind), other.kind) && joins(other, links)
    };
    let (mut alike, mut same, mut different) = (0, 0, Vec::new());
    for tie in ties {
        let Some(links) = both(tie) else { continue };
        if pairs.iter().any(|(one, other)| std::ptr::eq(*one, tie) && joins(other, links)) {
            alike += usize::from(links != tie.links);
            same += usize::from(links == tie.links);
        } else if !ties.iter().any(|other| is_parallel(tie, other, links)) {
            different.push((tie, links));
        }
    }
    different.retain(|(_, links)| links[0] != links[1]);
    let &(tie, links) = different.first()?;
    let is_joined =
        ties.iter().any(|other| is_alike(image.kind(tie.kind), other.kind) && joins(other, links))
            && tie.along().is_none();
    // One way back and forth is two likenesses.
    let enough = if is_moved { 2 } else { 3 };
    let is_part = alike < 2 || alike + same < enough || 3 * (alike + same) < ties.len();
    if is_part || 2 * different.len() > alike || is_joined {
        return None;
    }
    let at = image.place(tie.at);
    // Where something is drawn already, it is there.
    let ends = sketch.ends.iter().map(|end| (end.link, end.at));
    let ties = ties.iter().flat_map(|other| other.links.map(|link| (link, other.at)));
    let mut drawn: Vec<[f64; 2]> = ends
        .chain(ties)
        .filter(|(link, other)| {
            *link != LinkId::GROUND && links.contains(link) && distance(*other, at) <= near
        })
        .map(|one| one.1)
        .collect();
    drawn.sort_by(|a, b| distance(*a, at).total_cmp(&distance(*b, at)));
    let fine = 0.01 * sketch.size;
    let at = drawn.first().copied();
    let at = at.unwrap_or_else(|| image.place(tie.at).map(|part| handy(part, fine)));
    // Of two directions of a line the one that is written already.
    let kind = image.kind(tie.kind);
    let kind = if is_alike(kind, tie.kind) { tie.kind } else { kind };
    let word = match kind {
        NewKind::Revolute | NewKind::Weld => "pin",
        NewKind::Prismatic(_) => "guide",
        NewKind::Slot(_) => "slot",
    };
    let joint = NewJoint {
        name: NewNames::new(model).like(None, word),
        kind,
        ends: Ends::Drawn { links, at },
    };
    let rank = (different.len(), usize::MAX - alike - same);
    Some((rank, Declaration::joint(Purpose::Twin, joint).into()))
}

/// The image of each link: where most of its joints say so.
fn images(pairs: &[(&Tie, &Tie)]) -> BTreeMap<LinkId, LinkId> {
    let mut votes: BTreeMap<(LinkId, LinkId), usize> = BTreeMap::new();
    for (tie, other) in pairs {
        for link in tie.links {
            for image in other.links {
                *votes.entry((link, image)).or_default() += 1;
            }
        }
    }
    let mut votes: Vec<_> = votes.into_iter().collect();
    // The ground rather stays what it is.
    votes.sort_by_key(|((link, image), count)| {
        (usize::MAX - count, (*link == LinkId::GROUND) != (*image == LinkId::GROUND), link != image)
    });
    let mut images: BTreeMap<LinkId, LinkId> = BTreeMap::new();
    for ((link, image), _) in votes {
        if !images.contains_key(&link) && images.values().all(|known| *known != image) {
            images.insert(link, image);
        }
    }
    if images.values().all(|image| *image != LinkId::GROUND) {
        images.entry(LinkId::GROUND).or_insert(LinkId::GROUND);
    }
    images
}
