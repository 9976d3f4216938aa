//! The scene: a mechanism, its motion and the width of its bars, from which its links get bodies.

use super::hull::distance_to;
use super::survey::Slide;
use super::survey::Survey;
use crate::compiled::Compiled;
use crate::model::{AxisId, AxisKind, JointKind, LinkId, Model, Place, Shape, ShapeKind};
use crate::structure::Structure;
use nalgebra::{Point2, distance};

/// The width of a bar, as parts of the whole mechanism and of the shortest link.
const OF_WHOLE: [f64; 2] = [0.02, 0.055];
const OF_SHORTEST: f64 = 0.4;
/// Places of a link that are nearer to each other than this part of their distance from its origin are one.
const NEAR: f64 = 1e-9;

/// A mechanism, how it moves, and how thick its bars are.
pub(super) struct Scene<'a> {
    pub(super) model: &'a Model,
    pub(super) structure: &'a Structure,
    pub(super) survey: Survey,
    /// The width of a bar, in scene units.
    pub(super) width: f64,
    /// For each link what is fixed to it.
    mounts: Vec<Vec<Mount>>,
    slides: Vec<Slide>,
    /// For each link the numbers of the slides that it has a part in.
    slides_of: Vec<Vec<usize>>,
}

/// A place of a link at which something is fixed.
#[derive(Clone, Copy)]
pub(super) struct Mount {
    pub(super) at: Point2<f64>,
    pub(super) place: Place,
    /// Whether something turns about it, or is welded to it; else it is only a named point.
    pub(super) is_joint: bool,
}

impl<'a> Scene<'a> {
    pub(super) fn new(model: &'a Model, compiled: &'a Compiled) -> Self {
        let structure = &compiled.structure;
        let slides: Vec<Slide> = model.joint_ids().filter_map(|id| Slide::of(model, id)).collect();
        let survey = Survey::new(model, &compiled.plan, &compiled.program, &slides);
        let mut scene = Self {
            model,
            structure,
            width: 0.0,
            survey,
            mounts: mounts(model, structure),
            slides_of: vec![Vec::new(); model.links.len()],
            slides,
        };
        for (number, slide) in scene.slides.iter().enumerate() {
            for link in scene.ends(*slide) {
                scene.slides_of[link.index()].push(number);
            }
        }
        scene.width = scene.bar_width();
        scene
    }

    /// The width of bars: not too thick for the shortest link, and not too thin beside the whole.
    fn bar_width(&self) -> f64 {
        let size = self.survey.size(self.model).unwrap_or(1.0);
        let lengths = self.model.declared_links().flat_map(|link| {
            let joints = self.mounts(link).iter().filter(|mount| mount.is_joint);
            let joints: Vec<Point2<f64>> = joints.map(|mount| mount.at).collect();
            let pairs =
                (1..joints.len()).map(|number| distance(&joints[number - 1], &joints[number]));
            pairs.collect::<Vec<f64>>()
        });
        let shortest = lengths.fold(f64::INFINITY, f64::min);
        let [low, high] = OF_WHOLE.map(|part| part * size);
        (OF_SHORTEST * shortest).clamp(low, high)
    }

    /// Whether a link is shown.
    pub(super) fn is_shown(&self, link: LinkId) -> bool {
        self.survey.at_start(link).is_some() && self.model.link(link).die.is_none()
    }

    /// The links that are shown, the ground aside.
    pub(super) fn shown(&self) -> impl Iterator<Item = LinkId> {
        let links = self.model.declared_links();
        links.filter(|&link| self.is_shown(link))
    }

    /// Whether the shapes of a link are its body: they cover all its pins and blocks. Else they come to its body.
    pub(super) fn is_drawn(&self, link: LinkId) -> bool {
        let pins = self.mounts(link).iter().filter(|mount| mount.is_joint);
        let pins = pins.map(|mount| mount.at);
        let blocks = self.slides_of(link).filter_map(|slide| {
            let block = self.model.axis(slide.block);
            (block.link == link).then(|| Point2::from(block.at))
        });
        let shapes = &self.model.link(link).shapes;
        !shapes.is_empty() && pins.chain(blocks).all(|place| covers(shapes, place))
    }

    /// Whether a declared bar has an eye at this place of a link.
    pub(super) fn has_eye(&self, link: LinkId, place: Point2<f64>) -> bool {
        let shapes = self.model.link(link).shapes.iter();
        let mut bars = shapes.filter(|shape| matches!(shape.kind, ShapeKind::Bar { .. }));
        let reach = NEAR * place.coords.norm();
        let is_near = |pin: &[f64; 2]| distance(&Point2::from(*pin), &place) <= reach;
        bars.any(|bar| bar.kind.reach().0.iter().any(is_near))
    }

    /// Whether a shape of a link covers a place of it.
    pub(super) fn is_covered(&self, link: LinkId, place: Point2<f64>) -> bool {
        covers(&self.model.link(link).shapes, place)
    }

    /// The pins of a link, what is welded to it, and its named points, each place once.
    pub(super) fn mounts(&self, link: LinkId) -> &[Mount] {
        &self.mounts[link.index()]
    }

    /// All prismatic joints and slots.
    pub(super) fn slides(&self) -> impl Iterator<Item = Slide> {
        self.slides.iter().copied()
    }

    /// Those that have a link at an end.
    pub(super) fn slides_of(&self, link: LinkId) -> impl Iterator<Item = Slide> {
        let own = self.slides_of[link.index()].iter();
        own.map(|&number| self.slides[number])
    }

    /// The link with the guide of a slide, and the link that slides; of a slot, that of its pin.
    pub(super) fn ends(&self, slide: Slide) -> [LinkId; 2] {
        let other = slide.pin.unwrap_or(slide.block);
        [slide.guide, other].map(|axis| self.model.axis(axis).link)
    }

    /// Returns the least and greatest place of a slide's block along its guide, from the guide's origin.
    pub(super) fn travel(&self, slide: Slide) -> Option<[f64; 2]> {
        self.survey.range(|frames| frames.travel(self.model, slide))
    }
}

/// Returns the mounts of each link: pins and welds, then named points.
fn mounts(model: &Model, structure: &Structure) -> Vec<Vec<Mount>> {
    let pins = structure.pins.iter().flat_map(|pin| &pin.members);
    let pins = pins.map(|member| member.1);
    let welds = model.joints.iter().flat_map(|joint| match joint.kind {
        JointKind::Weld(a, b) => vec![a, b],
        _ => Vec::new(),
    });
    let points = (0..model.axes.len()).map(AxisId::new).filter(|&axis| {
        let axis = model.axis(axis);
        axis.kind == AxisKind::Point && axis.name.is_some()
    });
    let all = pins.chain(welds).map(|axis| (axis, true));
    let mut mounts: Vec<Vec<Mount>> = vec![Vec::new(); model.links.len()];
    for (axis, is_joint) in all.chain(points.map(|axis| (axis, false))) {
        let axis = model.axis(axis);
        let at = Point2::from(axis.at);
        let own = &mut mounts[axis.link.index()];
        let reach = NEAR * at.coords.norm();
        // The ground may have very many: most are told apart by their first coordinate.
        let is_near = |known: &Mount| {
            (known.at.x - at.x).abs() <= 2.0 * reach && distance(&known.at, &at) <= reach
        };
        if !own.iter().any(is_near) {
            own.push(Mount { at, place: axis.place(), is_joint });
        }
    }
    mounts
}

/// A place this near to an edge, as a part of its distance from the origin, lies on the edge.
const ON_EDGE: f64 = 1e-9;

/// Whether one of these shapes covers a place, holes included: what is around a pin carries it.
fn covers(shapes: &[Shape], place: Point2<f64>) -> bool {
    shapes.iter().any(|shape| is_within(&shape.kind, place))
}

fn is_within(kind: &ShapeKind, place: Point2<f64>) -> bool {
    let (points, reach) = kind.reach();
    let points: Vec<Point2<f64>> = points.iter().copied().map(Point2::from).collect();
    let near = ON_EDGE * place.coords.norm();
    let is_near_line =
        |ends: &[Point2<f64>]| distance_to([ends[0], ends[1]], place) <= reach + near;
    match kind {
        ShapeKind::Bar { .. } => points.windows(2).any(is_near_line),
        ShapeKind::Polygon(_) => {
            let last = [points[points.len() - 1], points[0]];
            is_inside(&points, place) || points.windows(2).any(is_near_line) || is_near_line(&last)
        }
        ShapeKind::Circle { .. } | ShapeKind::Ring { .. } | ShapeKind::Figure(_) => {
            points.iter().any(|point| (place - point).norm() <= reach + near)
        }
    }
}

/// Whether a place is inside a polygon, by the even-odd rule.
fn is_inside(corners: &[Point2<f64>], place: Point2<f64>) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(next).filter(|(a, b)| {
        (a.y > place.y) != (b.y > place.y)
            && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}
