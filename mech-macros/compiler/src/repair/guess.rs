//! Places for joints where the drawing has none: somebody would put them there.

use super::Repair;
use super::declaration::{
    Declaration, Ends, NewJoint, NewKind, NewNames, Purpose, drawn_joint, join, on_ground,
};
use super::sketch::{FEW, NEAR, Sketch, distance, leaves};
use super::tie::ties;
use super::tie::{Joined, both};
use crate::digits::round_to;
use crate::model::{JointId, JointKind, LinkId, Model};

/// The links that hang on one joint, and of which nothing else is drawn, each with the place of that joint.
pub(super) fn bare_leaves(model: &Model, sketch: &Sketch) -> Vec<(LinkId, [f64; 2])> {
    let leaves = leaves(model).into_iter();
    let bare = leaves.filter(|(link, _)| {
        let ends = sketch.ends.iter().any(|end| end.link == *link);
        model.link(*link).shapes.is_empty() && !ends
    });
    bare.filter_map(|(link, joint)| Some((link, drawn_joint(model, joint)?.1))).collect()
}

/// If nothing says how long the last link of a chain is: it ends at the height of the first pivot on the ground. If it hangs on a joint
/// at that height, or above or below that pivot, it is a block on a line through both.
pub(super) fn below(
    model: &Model,
    sketch: &Sketch,
    joined: &Joined,
    bare: &[(LinkId, [f64; 2])],
) -> Vec<Repair> {
    let mut pivots = sketch.pins.iter();
    let Some(pivot) = pivots.find(|pin| pin.links.contains(&LinkId::GROUND)) else {
        return Vec::new();
    };
    let is_half = |link: LinkId| {
        let mut joints = model.joint_ids().filter(|&joint| model.motor_of(joint).is_some());
        joints.any(|joint| {
            let slides = matches!(model.joint(joint).kind, JointKind::Prismatic(..));
            slides && both(model, joint).contains(&link)
        })
    };
    let moving = bare.iter().filter(|(link, place)| {
        if is_half(*link) {
            return false;
        }
        !joined.are_joined([LinkId::GROUND, *link]) && !sketch.is_same(*place, pivot.at)
    });
    let lone = moving.map(|&(link, place)| {
        let [x, y] = [0, 1].map(|part| (place[part] - pivot.at[part]).abs());
        let near = NEAR * sketch.size;
        if y <= near || x <= near {
            let along = if y <= x { [1.0, 0.0] } else { [0.0, 1.0] };
            slide_on_ground(model, link, place, along)
        } else {
            on_ground(model, link, None, [place[0], pivot.at[1]])
        }
    });
    lone.take(FEW).collect()
}

/// If nothing says where two links meet: over the middle of the joints on which they hang.
pub(super) fn apexes(model: &Model, joined: &Joined, bare: &[(LinkId, [f64; 2])]) -> Vec<Repair> {
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
            let name = NewNames::new(model).like(None, "pin");
            found.push(join(Purpose::Meet, name, [a, b], apex(p, q)));
        }
    }
    found
}

/// A place over the middle of two others.
pub(super) fn apex(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    let over = if q[0] < p[0] { -0.5 } else { 0.5 };
    let at =
        [0.5 * (p[0] + q[0]) - over * (q[1] - p[1]), 0.5 * (p[1] + q[1]) + over * (q[0] - p[0])];
    at.map(|part| handy(part, distance(p, q)))
}

/// A coordinate with as many digits as somebody would write where things are so far apart.
pub(super) fn handy(coordinate: f64, width: f64) -> f64 {
    const MOST: u8 = 12;
    let fine = |places: &u8| 10.0_f64.powi(-i32::from(*places)) <= 0.1 * width;
    let places = usize::from((0..MOST).find(fine).unwrap_or(MOST));
    round_to(coordinate, places)
}

/// The pivots of driven cylinders of which one half hangs on the other: as far from the stroke as the other end is.
pub(super) fn cylinders(model: &Model, joined: &Joined) -> Vec<Repair> {
    let ties = ties(model);
    let pivot = |(half, joint): (LinkId, JointId)| {
        let ([a, b], at) = drawn_joint(model, joint)?;
        let other = if a == half { b } else { a };
        let slides = matches!(model.joint(joint).kind, JointKind::Prismatic(..));
        if !slides || model.motor_of(joint).is_none() || joined.are_joined([LinkId::GROUND, half]) {
            return None;
        }
        let mut ends = ties.iter().filter(|tie| tie.has(other) && !tie.has(half));
        let end = ends.next()?.at;
        let at = [0, 1].map(|part| handy(2.0 * at[part] - end[part], distance(at, end)));
        Some(on_ground(model, half, None, at))
    };
    leaves(model).into_iter().filter_map(pivot).collect()
}

fn slide_on_ground(model: &Model, link: LinkId, at: [f64; 2], along: [f64; 2]) -> Repair {
    let joint = NewJoint {
        name: NewNames::new(model).like(None, "guide"),
        kind: NewKind::Prismatic(along),
        ends: Ends::Drawn { links: [LinkId::GROUND, link], at },
    };
    Declaration::joint(Purpose::Slide, joint).into()
}

/// If nothing is joined to the ground, and nothing says where links end: those that hang on one joint stand on pivots below it.
pub(super) fn floors(model: &Model, sketch: &Sketch, bare: &[(LinkId, [f64; 2])]) -> Vec<Repair> {
    let mut joints = model.joint_ids();
    let is_grounded = joints.any(|joint| {
        let (a, b) = model.ends(joint);
        a == LinkId::GROUND || b == LinkId::GROUND
    });
    if is_grounded {
        return Vec::new();
    }
    let heights = sketch.pins.iter().map(|pin| pin.at[1]);
    let size = if sketch.size > 0.0 { sketch.size } else { 1.0 };
    let floor = handy(heights.fold(f64::INFINITY, f64::min) - 0.5 * size, size);
    let stands = |&(link, [x, _]): &(LinkId, [f64; 2])| on_ground(model, link, None, [x, floor]);
    bare.iter().map(stands).take(FEW).collect()
}
