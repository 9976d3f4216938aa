//! Slides that stay parallel whatever moves: their links keep their directions to each other, and the lines were declared parallel.
//! Of a loop of such slides only one equation is left, that along them.

use crate::bug::bug;
use crate::model::{Axis, AxisId, FormulaId, JointId, JointKind, LinkId, Model};

/// Below this sine of the angle between them, lines that were declared in one direction are parallel: what is left is rounding.
const ROUNDING: f64 = 1e-12;

/// For each joint that slides its direction.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Parallels(Vec<Option<Heading>>);

/// The direction of a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Heading {
    /// The number of the direction: slides of one number stay parallel.
    pub(crate) number: usize,
    /// Whether the joint's coordinate grows in that direction, and not against it.
    pub(crate) forwards: bool,
}

impl Parallels {
    /// The direction of a joint; none if it does not slide.
    pub(crate) fn of(&self, joint: JointId) -> Option<Heading> {
        self.0[joint.index()]
    }
}

/// Lines of one direction in links that keep their directions to each other.
struct Direction {
    /// The first of these links.
    first: LinkId,
    /// The formulas by which params turn the lines in their links.
    formulas: [Option<FormulaId>; 2],
    /// The direction seen from the first link, at the start.
    along: [f64; 2],
    heading: Heading,
}

/// Finds the slides that stay parallel.
pub(super) fn parallels(model: &Model) -> Parallels {
    let frames = frames(model);
    let mut directions: Vec<Direction> = Vec::new();
    let mut sides = Vec::new();
    for joint in model.joint_ids() {
        let JointKind::Prismatic(a, b) = model.joint(joint).kind else {
            sides.push(None);
            continue;
        };
        let [a, b] = [a, b].map(|axis| place(&mut directions, &frames, model.axis(axis)));
        unite(&mut directions, a, b);
        sides.push(Some(a));
    }
    let heading = |(index, forwards): (usize, bool)| turned(directions[index].heading, forwards);
    Parallels(sides.into_iter().map(|side| side.map(heading)).collect())
}

fn turned(heading: Heading, forwards: bool) -> Heading {
    Heading { forwards: heading.forwards == forwards, ..heading }
}

/// The direction of a line, by its place in the list, and whether the line points that way.
fn place(
    directions: &mut Vec<Direction>,
    frames: &[(LinkId, [f64; 2])],
    line: &Axis,
) -> (usize, bool) {
    let (first, frame) = frames[line.link.index()];
    let along = rotate(frame, line.direction);
    let formulas = line.direction_formulas;
    let cross = |[x, y]: [f64; 2]| x * along[1] - y * along[0];
    let same = |known: &Direction| {
        (known.first, known.formulas) == (first, formulas) && cross(known.along).abs() < ROUNDING
    };
    if let Some(index) = directions.iter().position(same) {
        let [x, y] = directions[index].along;
        return (index, x * along[0] + y * along[1] > 0.0);
    }
    let heading = Heading { number: directions.len(), forwards: true };
    directions.push(Direction { first, formulas, along, heading });
    (directions.len() - 1, true)
}

/// Makes two directions one: the lines on both links of a slide, which params may turn against each other.
fn unite(directions: &mut [Direction], a: (usize, bool), b: (usize, bool)) {
    let [stays, goes] = [a, b].map(|(index, forwards)| turned(directions[index].heading, forwards));
    if stays.number == goes.number {
        return;
    }
    for direction in directions {
        if direction.heading.number == goes.number {
            let forwards = (direction.heading.forwards == goes.forwards) == stays.forwards;
            direction.heading = Heading { number: stays.number, forwards };
        }
    }
}

/// For each link the first of those to which it keeps its direction, and its own direction seen from there.
fn frames(model: &Model) -> Vec<(LinkId, [f64; 2])> {
    let mut joints: Vec<Vec<[AxisId; 2]>> = vec![Vec::new(); model.links.len()];
    for joint in &model.joints {
        if let JointKind::Prismatic(a, b) | JointKind::Weld(a, b) = joint.kind {
            let [of_a, of_b] = [a, b].map(|axis| model.axis(axis).direction_formulas);
            if of_a == of_b {
                joints[model.axis(a).link.index()].push([a, b]);
                joints[model.axis(b).link.index()].push([b, a]);
            }
        }
    }
    let mut frames: Vec<Option<(LinkId, [f64; 2])>> = vec![None; model.links.len()];
    for first in model.link_ids() {
        if frames[first.index()].is_some() {
            continue;
        }
        frames[first.index()] = Some((first, [1.0, 0.0]));
        let mut waiting = vec![first];
        while let Some(link) = waiting.pop() {
            let Some((_, own)) = frames[link.index()] else {
                bug!("a link waits that has no direction");
            };
            for &[here, there] in &joints[link.index()] {
                let (here, there) = (model.axis(here), model.axis(there));
                let frame = &mut frames[there.link.index()];
                if frame.is_none() {
                    let [x, y] = there.direction;
                    let across = rotate(here.direction, [x, -y]);
                    *frame = Some((first, rotate(own, across)));
                    waiting.push(there.link);
                }
            }
        }
    }
    let known = |frame: Option<_>| frame.unwrap_or_else(|| bug!("a link has no direction"));
    frames.into_iter().map(known).collect()
}

fn rotate([cos, sin]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [cos * x - sin * y, sin * x + cos * y]
}
