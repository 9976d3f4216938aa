//! The joints and links that could be added: those that a drawing suggests, and joints of other kinds.

use super::Repair;
use super::declaration::{
    Declaration, Ends, NewJoint, NewKind, NewNames, Purpose, drawn_joint, join, on_ground,
};
use super::guess::{apexes, bare_leaves, below, cylinders, floors};
use super::sketch::{DrawnPin, FEW, LooseEnd, NEAR, Scene, Sketch, distance, leaves, unjoined};
use super::tie::Joined;
use super::twins::twins;
use crate::model::{AxisId, AxisKind, LinkId, Model};
use std::collections::BTreeSet;

/// The joints that the drawing suggests, the likeliest first: ends that nearly meet, then ends that stand alone. Of each kind a few.
pub(super) fn joints(model: &Model, sketch: &Sketch) -> Vec<Repair> {
    let bare = bare_leaves(model, sketch);
    let joined = Joined::of(model);
    let kinds = [
        twins(model, sketch),
        meeting_joints(model, sketch, &joined),
        between_axes(model, &joined),
        reaching_joints(model, sketch, &joined, &bare),
        alone(model, sketch, &joined),
        cylinders(model, &joined),
        below(model, sketch, &joined, &bare),
        floors(model, sketch, &bare),
        apexes(model, &joined, &bare),
    ];
    kinds.concat()
}

/// The pivots on the ground where ends stand alone.
fn alone(model: &Model, sketch: &Sketch, joined: &Joined) -> Vec<Repair> {
    let ends = sketch.ends.iter().filter(|end| {
        let on_ground = |pin: &DrawnPin| pin.links.contains(&LinkId::GROUND);
        let pinned = joined.are_joined([LinkId::GROUND, end.link]);
        !pinned && end.link != LinkId::GROUND && !sketch.pin_at(end.at).is_some_and(on_ground)
    });
    let grounded = |end: &LooseEnd| on_ground(model, end.link, end.name.as_deref(), end.at);
    ends.map(grounded).take(FEW).collect()
}

/// The joints between ends of links and pins, or ends of other links, that are near.
fn meeting_joints<'s>(model: &Model, sketch: &'s Sketch, joined: &Joined) -> Vec<Repair> {
    let mut found: Vec<(f64, &LooseEnd, [LinkId; 2], [f64; 2])> = Vec::new();
    let mut add = |end: &'s LooseEnd, other: LinkId, at: [f64; 2], apart: f64| {
        let mut links = [other, end.link];
        links.sort();
        if apart <= NEAR * sketch.size && !joined.are_joined(links) {
            found.push((apart, end, links, at));
        }
    };
    for (number, end) in sketch.ends.iter().enumerate() {
        for pin in sketch.pins.iter().chain(&sketch.blocks) {
            let first = pin.links.iter().min();
            if let Some(&other) = first
                && !pin.links.contains(&end.link)
            {
                add(end, other, pin.at, distance(end.at, pin.at));
            }
        }
        for other in &sketch.ends[..number] {
            if other.link != end.link {
                add(other, end.link, other.at, distance(end.at, other.at));
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let joint = |(apart, end, links, at): (f64, &LooseEnd, [LinkId; 2], [f64; 2])| {
        let name = NewNames::new(model).like(end.name.as_deref(), "pin");
        join(Purpose::Join { apart }, name, links, at)
    };
    found.into_iter().map(joint).take(FEW).collect()
}

/// The joints between points and lines of links with frames of their own: pins, guides and slots, those of one name first.
fn between_axes(model: &Model, joined: &Joined) -> Vec<Repair> {
    let [points, lines] = [AxisKind::Point, AxisKind::Line].map(|kind| unjoined(model, kind));
    let scene = Scene::of(model);
    let link = |id: AxisId| model.axis(id).link;
    let own = |id: AxisId| !scene.has(link(id));
    let along = |line: AxisId| model.axis(line).direction;
    let mut pairs: Vec<(NewKind, [AxisId; 2])> = Vec::new();
    for (number, &b) in points.iter().enumerate() {
        let before = points[..number].iter();
        pairs.extend(before.map(|&a| (NewKind::Revolute, [a, b])));
        let shafts = shafts(model, model.axis(b).name.as_deref());
        pairs.extend(shafts.into_iter().map(|a| (NewKind::Revolute, [a, b])));
    }
    for (number, &b) in lines.iter().enumerate() {
        let before = lines[..number].iter();
        pairs.extend(before.map(|&a| (NewKind::Prismatic(along(a)), [a, b])));
        pairs.extend(points.iter().map(|&a| (NewKind::Slot(along(b)), [a, b])));
    }
    pairs.retain(|(_, [a, b])| {
        let links = [link(*a), link(*b)];
        links[0] != links[1] && (own(*a) || own(*b)) && !joined.are_joined(links)
    });
    // What the ground has is there to be joined.
    let differ = |ends: &[AxisId; 2]| {
        let [a, b] = ends.map(|id| &model.axis(id).name);
        let moves = ends.iter().all(|end| link(*end) != LinkId::GROUND);
        (a != b, moves)
    };
    // Of each kind the likeliest.
    let mut all = Vec::new();
    for word in ["pin", "guide", "slot"] {
        let of_word = |kind: &NewKind| match kind {
            NewKind::Revolute | NewKind::Weld => "pin",
            NewKind::Prismatic(_) => "guide",
            NewKind::Slot(_) => "slot",
        };
        let mut some: Vec<_> = pairs.iter().filter(|(kind, _)| of_word(kind) == word).collect();
        some.sort_by_key(|(_, ends)| differ(ends));
        let joint = |&&(kind, [a, b]): &&(NewKind, [AxisId; 2])| {
            let joint = NewJoint {
                name: NewNames::new(model).like(model.axis(b).name.as_deref(), word),
                kind,
                ends: Ends::Points([a, b]),
            };
            let apart = 0.0;
            Declaration::joint(Purpose::Join { apart }, joint).into()
        };
        all.extend(some.iter().take(FEW).map(joint));
    }
    all
}

/// The points of this name on which several links turn, or on the ground one.
fn shafts(model: &Model, name: Option<&str>) -> Vec<AxisId> {
    let joints = model.joints.iter().filter_map(|joint| joint.kind.axes());
    let mut shafts: Vec<AxisId> = joints.flatten().collect();
    shafts.retain(|id| name.is_some() && model.axis(*id).name.as_deref() == name);
    let uses = |id: AxisId| shafts.iter().filter(|other| **other == id).count();
    let is_shaft = |id: &AxisId| model.axis(*id).link == LinkId::GROUND || uses(*id) > 1;
    let found: BTreeSet<AxisId> = shafts.iter().copied().filter(is_shaft).collect();
    found.into_iter().collect()
}

/// The joints between ends of links, or what slides, and links that could reach there.
fn reaching_joints(
    model: &Model,
    sketch: &Sketch,
    joined: &Joined,
    bare: &[(LinkId, [f64; 2])],
) -> Vec<Repair> {
    let ends = sketch.ends.iter();
    let ends = ends.map(|end| (end.link, end.name.as_deref(), end.at));
    let blocks = sketch.blocks.iter();
    let leaves = leaves(model);
    let is_idle = |link: &LinkId| leaves.iter().any(|leaf| leaf.0 == *link);
    let blocks = blocks.flat_map(|block| {
        let idle = block.links.iter().copied().filter(is_idle);
        idle.map(|link| (link, None, block.at))
    });
    let moving = ends.chain(blocks).filter(|(link, ..)| *link != LinkId::GROUND);
    let joints = moving.flat_map(|(end, name, at)| {
        let others = bare.iter().map(|(link, _)| *link);
        let others = others.filter(move |&link| {
            let here = sketch.pin_at(at).is_some_and(|pin| pin.links.contains(&link));
            link != end && !here && !joined.are_held([link, end])
        });
        others.map(move |link| {
            let mut links = [link, end];
            links.sort();
            let name = NewNames::new(model).like(name, "pin");
            join(Purpose::Join { apart: 0.0 }, name, links, at)
        })
    });
    joints.take(FEW).collect()
}

/// A link between two ends that no joint holds, or from a single one to the nearest pin that moves.
pub(super) fn connecting_links(model: &Model, sketch: &Sketch) -> Vec<Repair> {
    let Sketch { size, pins, .. } = sketch;
    let ends = [&sketch.ends[..], &idle_blocks(model, sketch)].concat();
    if ends.len() > FEW {
        return Vec::new();
    }
    let mut found: Vec<[LooseEnd; 2]> = Vec::new();
    for (number, b) in ends.iter().enumerate() {
        let before = ends[..number].iter();
        let others = before.filter(|a| a.link != b.link && distance(a.at, b.at) > NEAR * size);
        found.extend(others.map(|a| [a.clone(), b.clone()]));
    }
    if let [end] = &ends[..] {
        let moves = |pin: &&DrawnPin| {
            !pin.links.contains(&LinkId::GROUND) && !pin.links.contains(&end.link)
        };
        let moving = pins.iter().filter(moves);
        let nearest =
            moving.min_by(|a, b| distance(a.at, end.at).total_cmp(&distance(b.at, end.at)));
        found.extend(nearest.into_iter().filter_map(|pin| {
            let pin = LooseEnd { link: *pin.links.first()?, name: None, at: pin.at };
            Some([pin, end.clone()])
        }));
    }
    found.extend(ends.iter().filter_map(|end| {
        let first = pins.iter().find(|pin| pin.links.contains(&LinkId::GROUND));
        let height = first?.at[1];
        let moves = !Joined::of(model).are_joined([LinkId::GROUND, end.link]);
        let foot = LooseEnd { link: LinkId::GROUND, name: None, at: [end.at[0], height] };
        (moves && end.at[1] != height).then(|| [end.clone(), foot])
    }));
    found.iter().map(|ends| connect(model, ends)).collect()
}

/// The blocks on the ground that are joined to nothing else: somebody may have forgotten the link that moves them.
fn idle_blocks(model: &Model, sketch: &Sketch) -> Vec<LooseEnd> {
    let idle = leaves(model).into_iter().filter_map(|(link, joint)| {
        let (a, b) = model.ends(joint);
        let block = sketch.blocks.iter().find(|block| block.links == [link])?;
        let end = LooseEnd { link, name: None, at: block.at };
        (a == LinkId::GROUND || b == LinkId::GROUND).then_some(end)
    });
    idle.collect()
}

fn connect(model: &Model, ends: &[LooseEnd; 2]) -> Repair {
    let mut names = NewNames::new(model);
    let name = names.like(None, "bar");
    let new = LinkId::new(model.links.len());
    let joints = ends.each_ref().map(|end| NewJoint {
        name: names.like(end.name.as_deref(), "pin"),
        kind: NewKind::Revolute,
        ends: Ends::Drawn { links: [end.link, new], at: end.at },
    });
    Repair::Declare(Declaration {
        purpose: Purpose::Connect,
        link: Some(name),
        joints: joints.into(),
        replaced: Vec::new(),
    })
}

/// One of these links, which float, could be a part of the ground: the one with the most joints first.
pub(super) fn fix_to_ground(model: &Model, links: &[LinkId]) -> Vec<Repair> {
    let places = |link: LinkId| {
        let joints = model.joint_ids().filter_map(move |joint| {
            let (ends, at) = drawn_joint(model, joint)?;
            ends.contains(&link).then_some(at)
        });
        joints.collect::<Vec<_>>()
    };
    let mut links: Vec<(LinkId, Vec<[f64; 2]>)> =
        links.iter().map(|&link| (link, places(link))).collect();
    links.sort_by_key(|(_, places)| std::cmp::Reverse(places.len()));
    let weld = |(link, places): (LinkId, Vec<[f64; 2]>)| {
        let joint = NewJoint {
            name: NewNames::new(model).like(None, "frame"),
            kind: NewKind::Weld,
            ends: Ends::Drawn { links: [LinkId::GROUND, link], at: *places.first()? },
        };
        Some(Declaration::joint(Purpose::Fix, joint).into())
    };
    links.into_iter().filter_map(weld).take(FEW).collect()
}
