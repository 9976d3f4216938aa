//! The joints and links that could be added: those that a drawing suggests, and joints of other kinds.

use super::Repair;
use super::declaration::{
    Declaration, Ends, NewJoint, NewKind, NewNames, Purpose, drawn_joint, turns_freely,
};
use super::joined::Joined;
use super::sketch::{DrawnPin, LooseEnd, Scene, Sketch, distance, unjoined};
use crate::digits::round_to;
use crate::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model};

/// Ends that are no farther apart than this part of the size may be meant to be one.
const NEAR: f64 = 0.15;
/// So many joints of a kind are tried, and links between no more ends than these.
const FEW: usize = 4;
/// So many welds are tried.
const WELDS: usize = 3;

/// The joints that the drawing suggests, the likeliest first: ends that nearly meet, then ends that stand alone. Of each kind a few.
pub(super) fn joints(model: &Model, sketch: &Sketch) -> Vec<Repair> {
    let bare = bare_leaves(model, sketch);
    let joined = Joined::of(model);
    let kinds = [
        meeting_joints(model, sketch, &joined),
        between_axes(model, &joined),
        reaching_joints(model, sketch, &joined, &bare),
        alone(model, sketch, &joined),
        below(model, sketch, &joined, &bare),
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
    let differ = |[a, b]: &[AxisId; 2]| model.axis(*a).name != model.axis(*b).name;
    // Of each kind the likeliest.
    let mut all = Vec::new();
    for word in ["pin", "guide", "slot"] {
        let of_word = |kind: &NewKind| match kind {
            NewKind::Revolute | NewKind::Weld => "pin",
            NewKind::Prismatic(_) => "guide",
            NewKind::Slot(_) => "slot",
        };
        let mut some: Vec<_> = pairs
            .iter()
            .filter(|(kind, _)| of_word(kind) == word)
            .collect();
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

fn on_ground(model: &Model, link: LinkId, name: Option<&str>, at: [f64; 2]) -> Repair {
    let name = NewNames::new(model).like(name, "pin");
    join(Purpose::Ground, name, [LinkId::GROUND, link], at)
}

/// The links that hang on one joint, and of which nothing else is drawn, each with the place of that joint.
fn bare_leaves(model: &Model, sketch: &Sketch) -> Vec<(LinkId, [f64; 2])> {
    let leaves = leaves(model).into_iter();
    let bare = leaves.filter(|(link, _)| {
        let ends = sketch.ends.iter().any(|end| end.link == *link);
        model.link(*link).shapes.is_empty() && !ends
    });
    bare.filter_map(|(link, joint)| Some((link, drawn_joint(model, joint)?.1)))
        .collect()
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
    let blocks = blocks.flat_map(|block| block.links.iter().map(|&link| (link, None, block.at)));
    let moving = ends
        .chain(blocks)
        .filter(|(link, ..)| *link != LinkId::GROUND);
    let joints = moving.flat_map(|(end, name, at)| {
        let others = bare.iter().map(|(link, _)| *link);
        let others = others.filter(move |&link| link != end && !joined.are_held([link, end]));
        others.map(move |link| {
            let mut links = [link, end];
            links.sort();
            let name = NewNames::new(model).like(name, "pin");
            join(Purpose::Join { apart: 0.0 }, name, links, at)
        })
    });
    joints.take(FEW).collect()
}

fn join(purpose: Purpose, name: String, links: [LinkId; 2], at: [f64; 2]) -> Repair {
    let joint = NewJoint {
        name,
        kind: NewKind::Revolute,
        ends: Ends::Drawn { links, at },
    };
    Declaration::joint(purpose, joint).into()
}

/// If nothing says how long the last link of a chain is: it ends at the height of the first pivot on the ground. If it hangs on a joint
/// at that height, or above or below that pivot, it is a block on a line through both.
fn below(
    model: &Model,
    sketch: &Sketch,
    joined: &Joined,
    bare: &[(LinkId, [f64; 2])],
) -> Vec<Repair> {
    let mut pivots = sketch.pins.iter();
    let Some(pivot) = pivots.find(|pin| pin.links.contains(&LinkId::GROUND)) else {
        return Vec::new();
    };
    let moving = bare.iter().filter(|(link, place)| {
        !joined.are_joined([LinkId::GROUND, *link]) && !sketch.is_same(*place, pivot.at)
    });
    let lone = moving.map(|&(link, place)| {
        let [x, y] = [0, 1].map(|part| (place[part] - pivot.at[part]).abs());
        let near = NEAR * sketch.size;
        if y <= near || x <= near {
            let along = if y <= x { [1.0, 0.0] } else { [0.0, 1.0] };
            let joint = NewJoint {
                name: NewNames::new(model).like(None, "guide"),
                kind: NewKind::Prismatic(along),
                ends: Ends::Drawn {
                    links: [LinkId::GROUND, link],
                    at: place,
                },
            };
            Declaration::joint(Purpose::Slide, joint).into()
        } else {
            on_ground(model, link, None, [place[0], pivot.at[1]])
        }
    });
    lone.take(FEW).collect()
}

/// If nothing says where two links meet: over the middle of the joints on which they hang.
fn apexes(model: &Model, joined: &Joined, bare: &[(LinkId, [f64; 2])]) -> Vec<Repair> {
    let mut found = Vec::new();
    for (number, &(b, q)) in bare.iter().enumerate() {
        for &(a, p) in &bare[..number] {
            let width = distance(p, q);
            if width == 0.0 || joined.are_held([a, b]) {
                continue;
            }
            if found.len() == FEW {
                return found;
            }
            let over = if q[0] < p[0] { -0.5 } else { 0.5 };
            let at = [
                0.5 * (p[0] + q[0]) - over * (q[1] - p[1]),
                0.5 * (p[1] + q[1]) + over * (q[0] - p[0]),
            ];
            let name = NewNames::new(model).like(None, "pin");
            found.push(join(
                Purpose::Meet,
                name,
                [a, b],
                at.map(|part| handy(part, width)),
            ));
        }
    }
    found
}

/// A coordinate with as many digits as somebody would write where things are so far apart.
fn handy(coordinate: f64, width: f64) -> f64 {
    const MOST: u8 = 12;
    let fine = |places: &u8| 10.0_f64.powi(-i32::from(*places)) <= 0.1 * width;
    let places = usize::from((0..MOST).find(fine).unwrap_or(MOST));
    round_to(coordinate, places)
}

/// The links that hang on one joint, with that.
pub(super) fn leaves(model: &Model) -> Vec<(LinkId, JointId)> {
    let lone = model.declared_links().filter_map(|link| {
        let mut joints = model.joint_ids().filter(|&joint| {
            let (a, b) = model.ends(joint);
            a == link || b == link
        });
        Some((link, joints.next()?)).filter(|_| joints.next().is_none())
    });
    lone.collect()
}

/// A link between two ends that no joint holds, or from a single one to the nearest pin that moves.
pub(super) fn connecting_links(model: &Model, sketch: &Sketch) -> Vec<Repair> {
    let Sketch {
        ends, size, pins, ..
    } = sketch;
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
            let pin = LooseEnd {
                link: *pin.links.first()?,
                name: None,
                at: pin.at,
            };
            Some([pin, end.clone()])
        }));
    }
    found.iter().map(|ends| connect(model, ends)).collect()
}

fn connect(model: &Model, ends: &[LooseEnd; 2]) -> Repair {
    let mut names = NewNames::new(model);
    let name = names.like(None, "bar");
    let new = LinkId::new(model.links.len());
    let joints = ends.each_ref().map(|end| NewJoint {
        name: names.like(end.name.as_deref(), "pin"),
        kind: NewKind::Revolute,
        ends: Ends::Drawn {
            links: [end.link, new],
            at: end.at,
        },
    });
    Repair::Declare(Declaration {
        purpose: Purpose::Connect,
        link: Some(name),
        joints: joints.into(),
        replaced: Vec::new(),
    })
}

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
    inner.sort_by(|a, b| {
        let is_inside = |joint: &JointId| leaves.iter().all(|(_, held)| held != joint);
        let first = is_inside(a).cmp(&is_inside(b));
        first.then(bend(model, *a).total_cmp(&bend(model, *b)))
    });
    let weld = |joint: JointId| {
        let (links, at) = drawn_joint(model, joint)?;
        Some(rewrite(
            model,
            Purpose::Stiffen,
            joint,
            NewKind::Weld,
            links,
            at,
        ))
    };
    inner.into_iter().filter_map(weld).take(WELDS).collect()
}

/// Returns the bend of two links where a joint joins them: from 0, if they are drawn in one line, to 2.
fn bend(model: &Model, joint: JointId) -> f64 {
    const MOST: f64 = 2.0;
    let Some((links, at)) = drawn_joint(model, joint) else {
        return MOST;
    };
    // A link leads to the middle of its other joints.
    let arms = links.map(|link| {
        let others = model.joint_ids().filter(|&other| other != joint);
        let drawn = others.filter_map(|other| drawn_joint(model, other));
        let own = drawn.filter(|(links, _)| links.contains(&link));
        own.fold([0.0, 0.0], |[x, y], (_, [u, v])| {
            [x + (u - at[0]), y + (v - at[1])]
        })
    });
    let [[a, b], [c, d]] = arms;
    let cosine = (a * c + b * d) / (a.hypot(b) * c.hypot(d));
    if cosine.is_nan() { MOST } else { 1.0 + cosine }
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
        let is_drawn = [point, line]
            .iter()
            .all(|axis| axis.name.is_none() && !axis.varies());
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
        let repairs = [[b, a], [a, b]]
            .into_iter()
            .filter(move |ends| moving(&ends[0]));
        let repairs: Vec<Repair> = repairs
            .map(|links| rewrite(model, Purpose::Turn, joint, kind, links, at))
            .collect();
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
    let new = NewJoint {
        name: model.joint(joint).name.clone(),
        kind,
        ends: Ends::Drawn { links, at },
    };
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
    let all: Vec<(JointId, LinkId, [f64; 2])> = model
        .joint_ids()
        .collect::<Vec<_>>()
        .iter()
        .filter_map(pinned)
        .collect();
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
            ends: Ends::Drawn {
                links: [base, link],
                at,
            },
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
            ends: Ends::Drawn {
                links: [LinkId::GROUND, link],
                at: *places.first()?,
            },
        };
        Some(Declaration::joint(Purpose::Fix, joint).into())
    };
    links.into_iter().filter_map(weld).take(FEW).collect()
}

impl From<Declaration> for Repair {
    fn from(declaration: Declaration) -> Self {
        Self::Declare(declaration)
    }
}
