//! Joints that could stand in place of others.

use super::Repair;
use super::declaration::{
    Declaration, Ends, NewJoint, NewKind, NewNames, Purpose, drawn_joint, turns_freely,
};
use super::sketch::{FEW, Sketch, leaves};
use super::tie::{Joined, both};
use crate::model::{JointId, JointKind, LinkId, Model};

/// So many welds are tried.
const WELDS: usize = 3;
/// The bend of two arms on one side of a joint.
const MOST_BENT: f64 = 2.0;

/// The links that these joints join could be one bent link. Those at the end of a chain are tried first, then those that bend least.
pub(super) fn welds(model: &Model, joints: &[JointId]) -> Vec<Repair> {
    let leaves = leaves(model);
    let mut inner: Vec<JointId> = joints
        .iter()
        .copied()
        .filter(|&joint| {
            let (a, b) = model.ends(joint);
            a != LinkId::GROUND && b != LinkId::GROUND && turns_freely(model, joint)
        })
        .collect();
    let joined = Joined::of(model);
    inner.sort_by(|a, b| {
        let is_inside = |joint: &JointId| leaves.iter().all(|(_, held)| held != joint);
        // What turns on the ground is a crank or a rocker: a coupler rather has a knee.
        let is_crank = |joint: &JointId| {
            let (a, b) = model.ends(*joint);
            joined.are_joined([LinkId::GROUND, a]) || joined.are_joined([LinkId::GROUND, b])
        };
        let first = (is_inside(a), is_crank(a)).cmp(&(is_inside(b), is_crank(b)));
        first.then(bend(model, *a).total_cmp(&bend(model, *b)))
    });
    let weld = |joint: JointId| {
        let (links, at) = drawn_joint(model, joint)?;
        Some(rewrite(model, Purpose::Stiffen, joint, NewKind::Weld, links, at))
    };
    inner.into_iter().filter_map(weld).take(WELDS).collect()
}

/// Returns the bend of two links where a joint joins them: from 0, if they are drawn in one line, to 2.
fn bend(model: &Model, joint: JointId) -> f64 {
    let Some((links, at)) = drawn_joint(model, joint) else {
        return MOST_BENT;
    };
    // A link leads to the middle of its other joints.
    let arms = links.map(|link| {
        let others = model.joint_ids().filter(|&other| other != joint);
        let drawn = others.filter_map(|other| drawn_joint(model, other));
        let own = drawn.filter(|(links, _)| links.contains(&link));
        own.fold([0.0, 0.0], |[x, y], (_, [u, v])| [x + (u - at[0]), y + (v - at[1])])
    });
    bend_between(arms)
}

/// The same of two arms.
fn bend_between([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    let cosine = (a * c + b * d) / (a.hypot(b) * c.hypot(d));
    if cosine.is_nan() { MOST_BENT } else { 1.0 + cosine }
}

/// The slots among these joints whose pins could keep their direction.
pub(super) fn guides(model: &Model, joints: &[JointId]) -> Vec<Repair> {
    let guide = |&pivot: &JointId| {
        let JointKind::Revolute(point, die) = model.joint(pivot).kind else {
            return None;
        };
        let (_, line) = model.link(model.axis(die).link).die?;
        let slide = model.joint_ids().find(|&joint| {
            let kind = model.joint(joint).kind;
            matches!(kind, JointKind::Prismatic(guide, other) if guide == line && model.axis(other).link == model.axis(die).link)
        })?;
        let (point, line) = (model.axis(point), model.axis(line));
        let is_drawn = [point, line].iter().all(|axis| axis.name.is_none() && !axis.varies());
        is_drawn.then(|| {
            let links = [line.link, point.link];
            let kind = NewKind::Prismatic(line.direction);
            rewrite(model, Purpose::Guide, slide, kind, links, point.at)
        })
    };
    joints.iter().filter_map(guide).collect()
}

/// The slides among these joints that could turn as well.
pub(super) fn slots(model: &Model, joints: &[JointId]) -> Vec<Repair> {
    let slot = |&joint: &JointId| {
        let JointKind::Prismatic(line, _) = model.joint(joint).kind else {
            return None;
        };
        let ([a, b], at) = drawn_joint(model, joint)?;
        let kind = NewKind::Slot(model.axis(line).direction);
        let moving = |link: &LinkId| *link != LinkId::GROUND;
        let repairs = [[b, a], [a, b]].into_iter().filter(move |ends| moving(&ends[0]));
        let repairs: Vec<Repair> =
            repairs.map(|links| rewrite(model, Purpose::Turn, joint, kind, links, at)).collect();
        Some(repairs)
    };
    joints.iter().filter_map(slot).flatten().take(FEW).collect()
}

fn rewrite(
    model: &Model,
    purpose: Purpose,
    joint: JointId,
    kind: NewKind,
    links: [LinkId; 2],
    at: [f64; 2],
) -> Repair {
    let new =
        NewJoint { name: model.joint(joint).name.clone(), kind, ends: Ends::Drawn { links, at } };
    Declaration::instead(purpose, new, joint).into()
}

/// Where several of these joints pin links to the ground at one place: the links joined to each other.
pub(super) fn free_from_ground(model: &Model, joints: &[JointId]) -> Vec<Repair> {
    let pinned = |&joint: &JointId| {
        let (links, at) = drawn_joint(model, joint).filter(|_| turns_freely(model, joint))?;
        let [a, b] = links;
        match (a, b) {
            (LinkId::GROUND, link) | (link, LinkId::GROUND) => Some((joint, link, at)),
            _ => None,
        }
    };
    let all: Vec<(JointId, LinkId, [f64; 2])> =
        model.joint_ids().collect::<Vec<_>>().iter().filter_map(pinned).collect();
    let sketch = Sketch::of(model);
    let mut found = Vec::new();
    for (number, &(first, base, at)) in all.iter().enumerate() {
        let here = |other: &&(JointId, LinkId, [f64; 2])| sketch.is_same(other.2, at);
        let others: Vec<_> = all[number + 1..].iter().filter(here).collect();
        let is_first = !all[..number].iter().any(|other| here(&other));
        let touched = joints.contains(&first) || others.iter().any(|one| joints.contains(&one.0));
        if others.is_empty() || !is_first || !touched {
            continue;
        }
        let joint = |&&(joint, link, _): &&(JointId, LinkId, [f64; 2])| NewJoint {
            name: model.joint(joint).name.clone(),
            kind: NewKind::Revolute,
            ends: Ends::Drawn { links: [base, link], at },
        };
        let replaced = std::iter::once(first).chain(others.iter().map(|one| one.0));
        found.push(Repair::Declare(Declaration {
            purpose: Purpose::Free,
            link: None,
            joints: others.iter().map(joint).collect(),
            replaced: replaced.collect(),
        }));
    }
    found
}

/// Links with three places for joints that could be two links, joined where the link is straightest: as it is drawn, it holds fast what
/// its halves would let move.
pub(super) fn splits(model: &Model, links: &[LinkId]) -> Vec<Repair> {
    let sketch = Sketch::of(model);
    let mut found: Vec<(bool, f64, Repair)> = Vec::new();
    let declared = |link: &&LinkId| **link != LinkId::GROUND && model.link(**link).die.is_none();
    for &link in links.iter().filter(declared) {
        let joints: Vec<(JointId, [LinkId; 2], [f64; 2])> = model
            .joint_ids()
            .filter_map(|joint| drawn_joint(model, joint).map(|(ends, at)| (joint, ends, at)))
            .filter(|(_, ends, _)| ends.contains(&link))
            .collect();
        let ends = sketch.ends.iter().filter(|end| end.link == link);
        let ends = ends.map(|end| (end.at, end.name.as_deref()));
        let bends = sketch.bends.iter().filter(|bend| bend.0 == link);
        let free = ends.chain(bends.map(|bend| (bend.1, None)));
        let knees = free.chain(joints.iter().map(|joint| (joint.2, None)));
        for (at, name) in knees {
            let others = joints.iter().filter(|joint| !sketch.is_same(joint.2, at));
            let others: Vec<_> = others.collect();
            let is_used = others.len() < joints.len();
            if let [first, second] = others[..] {
                let split = split(model, link, (at, name), second);
                found.extend(split.map(|split| {
                    (
                        is_used,
                        bend_between([first.2, second.2].map(|[x, y]| [x - at[0], y - at[1]])),
                        split,
                    )
                }));
            }
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    found.into_iter().map(|(.., split)| split).take(FEW).collect()
}

/// Two links instead of one: a joint goes to the new one.
fn split(
    model: &Model,
    link: LinkId,
    (at, name): ([f64; 2], Option<&str>),
    &(joint, ends, place): &(JointId, [LinkId; 2], [f64; 2]),
) -> Option<Repair> {
    if !turns_freely(model, joint) {
        return None;
    }
    let mut names = NewNames::new(model);
    let part = names.like(Some(&format!("{}2", model.link(link).name)), "part");
    let new = LinkId::new(model.links.len());
    let knee = NewJoint {
        name: names.like(name, "pin"),
        kind: NewKind::Revolute,
        ends: Ends::Drawn { links: [link, new], at },
    };
    let moved = NewJoint {
        name: model.joint(joint).name.clone(),
        kind: NewKind::Revolute,
        ends: Ends::Drawn { links: ends.map(|end| if end == link { new } else { end }), at: place },
    };
    Some(Repair::Declare(Declaration {
        purpose: Purpose::Split,
        link: Some(part),
        joints: vec![knee, moved],
        replaced: vec![joint],
    }))
}

/// Two links that several of these joints hold still on each other, welded by the first of them.
pub(super) fn bolts(model: &Model, joints: &[JointId]) -> Option<Repair> {
    let (&first, others) = joints.split_first()?;
    let pair = both(model, first);
    if others.is_empty() || others.iter().any(|&joint| both(model, joint) != pair) {
        return None;
    }
    let (links, at) = drawn_joint(model, first)?;
    let purpose = if pair[0] == LinkId::GROUND { Purpose::Fix } else { Purpose::Stiffen };
    let weld = rewrite(model, purpose, first, NewKind::Weld, links, at);
    match weld {
        Repair::Declare(declared) => {
            Some(Repair::Declare(Declaration { replaced: joints.to_vec(), ..declared }))
        }
        _ => None,
    }
}
