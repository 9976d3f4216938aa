//! Where everything is seen: a model with the poses of its links.

use super::Item;
use super::index::{self, HandleKind, Index};
use super::placement::{Pose, SCENE, closed, ends, placed};
use crate::play::distance_to_line;
use mech_compiler::model::{AxisId, Between, JointId, JointKind, LinkId, Model};
use mech_compiler::plan::have_same_steps;
use std::sync::Arc;

/// A mechanism as it is drawn, whether or not it moves.
#[derive(Clone, Debug)]
pub struct Drawing {
    pub(crate) model: Arc<Model>,
    poses: Vec<Pose>,
    /// Where each link rests: neither where a motor has it, nor where it has jumped to a joint.
    rests: Vec<Pose>,
    index: Arc<Index>,
}

/// A place that can be taken hold of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle<'d> {
    /// The item there.
    pub item: &'d Item,
    /// Where, in the scene.
    pub place: [f64; 2],
    /// The look of the handle.
    pub kind: HandleKind,
}

/// The thing that is at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Hit {
    Joint(JointId),
    /// A point or a line that no joint has.
    Axis(AxisId),
    Link(LinkId),
    Paper,
}

impl Drawing {
    /// A mechanism whose links have these poses, as far as these are known. The others are put where their joints want them.
    pub(crate) fn new(model: Model, known: Vec<Option<Pose>>) -> Self {
        let rests = placed(&model, known);
        let poses = closed(&model, rests.clone());
        let index = Arc::new(Index::of(&model));
        Self { model: Arc::new(model), poses, rests, index }
    }

    /// The same mechanism with other numbers. Joints that come to the same place may share an axis from then on.
    pub(crate) fn with_numbers(&self, model: Model, known: Vec<Option<Pose>>) -> Self {
        let rests = placed(&model, known);
        let poses = closed(&model, rests.clone());
        let index = if have_same_steps(&self.model, &model) {
            self.index.clone()
        } else {
            Arc::new(Index::of(&model))
        };
        Self { model: Arc::new(model), poses, rests, index }
    }

    /// Where a link rests: neither where a motor has it, nor where it has jumped to a joint.
    pub(crate) fn rest(&self, link: LinkId) -> Pose {
        self.rests.get(link.index()).copied().unwrap_or(SCENE)
    }

    /// Puts links where they are known to be.
    pub(crate) fn set_poses(&mut self, known: Vec<Option<Pose>>) {
        for (pose, known) in self.poses.iter_mut().zip(known) {
            if let Some(known) = known {
                *pose = known;
            }
        }
    }

    pub(crate) fn has(&self, item: &Item) -> bool {
        match item {
            Item::Link(name) => self.link(name).is_some(),
            Item::Joint(name) => self.joint(name).is_some(),
            Item::Axis(path) => self.axis(path).is_some(),
            Item::Action(name) => {
                let actions = &self.model.actions;
                let springs = actions.springs.iter().map(|one| &one.name);
                let dampers = actions.dampers.iter().map(|one| &one.name);
                let loads = actions.loads.iter().map(|one| &one.name);
                springs.chain(dampers).chain(loads).any(|one| one == name)
            }
        }
    }

    pub(crate) fn pose(&self, link: LinkId) -> Pose {
        self.poses.get(link.index()).copied().unwrap_or(SCENE)
    }

    pub(crate) fn is_in_scene(&self, link: LinkId) -> bool {
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
        let parts = <[f64; 4]>::from;
        parts(self.pose(link)).iter().zip(&parts(SCENE)).all(near)
    }

    /// Where an axis is in the scene.
    pub(crate) fn place(&self, axis: AxisId) -> [f64; 2] {
        let axis = self.model.axis(axis);
        self.pose(axis.link).apply(axis.at)
    }

    pub(crate) fn direction(&self, axis: AxisId) -> [f64; 2] {
        let axis = self.model.axis(axis);
        self.pose(axis.link).turn(axis.direction)
    }

    pub(crate) fn in_frame(&self, link: LinkId, place: [f64; 2]) -> [f64; 2] {
        self.pose(link).relative(place)
    }

    pub(crate) fn link(&self, name: &str) -> Option<LinkId> {
        let mut links = self.model.link_ids();
        let is_it = |link: &LinkId| {
            let link = self.model.link(*link);
            link.die.is_none() && link.name == name
        };
        links.find(is_it)
    }

    pub(crate) fn declared_links(&self) -> impl Iterator<Item = String> {
        let links = self.model.declared_links();
        links.map(|link| self.model.link(link).name.clone())
    }

    pub(crate) fn joint(&self, name: &str) -> Option<JointId> {
        self.index.joints.get(name).copied()
    }

    /// The path of an axis that has a name.
    pub(crate) fn path(&self, axis: AxisId) -> Option<String> {
        index::path(&self.model, axis)
    }

    pub(crate) fn axis(&self, path: &str) -> Option<AxisId> {
        self.index.axes.get(path).copied()
    }

    /// The axis by which a joint is seen, and moved.
    pub(crate) fn axis_of_joint(&self, joint: JointId) -> Option<AxisId> {
        index::axis_of_joint(&self.model, joint)
    }

    /// The place of a joint of this name.
    pub(crate) fn place_of_joint(&self, name: &str) -> Option<[f64; 2]> {
        let axis = self.axis_of_joint(self.joint(name)?)?;
        Some(self.place(axis))
    }

    /// Finds the path to move in the text so that a joint or a point changes its place, and the axis that moves with it. A joint that was
    /// placed in the drawing moves itself; any other moves by its point.
    pub(crate) fn mover(&self, item: &Item) -> Option<(String, AxisId)> {
        match item {
            Item::Joint(name) => {
                let axis = self.axis_of_joint(self.joint(name)?)?;
                Some((self.path(axis).unwrap_or_else(|| name.clone()), axis))
            }
            Item::Axis(path) => Some((path.clone(), self.axis(path)?)),
            Item::Link(_) | Item::Action(_) => None,
        }
    }

    /// All joints that were placed in the drawing where this one was; this one is the first.
    pub(crate) fn on_same_pin(&self, item: &Item) -> Vec<Item> {
        let mut found = vec![item.clone()];
        let is_placed = |item: &Item, path: &str| matches!(item, Item::Joint(name) if name == path);
        let Some((_, axis)) = self.mover(item).filter(|(path, _)| is_placed(item, path)) else {
            return found;
        };
        let at = self.model.axis(axis).at;
        let others = self.index.handles.iter().map(|(other, ..)| other);
        let others = others.filter(|other| *other != item && matches!(other, Item::Joint(_)));
        let others = others.filter(|other| {
            let mover = self.mover(other);
            mover.is_some_and(|(path, axis)| {
                is_placed(other, &path) && self.model.axis(axis).at == at
            })
        });
        found.extend(others.cloned());
        found
    }

    /// The joints and points that have to be moved so that something moves: of a link, all that give it its place.
    pub(crate) fn handles_of(&self, item: &Item) -> Vec<Item> {
        let Item::Link(name) = item else {
            return self.on_same_pin(item);
        };
        let Some(link) = self.link(name) else {
            return Vec::new();
        };
        let handles = self.index.handles.iter().map(|(item, ..)| item);
        let own = handles.filter(|item| match item {
            Item::Joint(name) => self.joint(name).is_some_and(|joint| {
                let (a, b) = self.model.ends(joint);
                a == link || b == link
            }),
            Item::Axis(path) => {
                let axis = self.axis(path);
                let is_drawn = self.model.link(link).drawn;
                axis.is_some_and(|axis| is_drawn && self.model.axis(axis).link == link)
            }
            Item::Link(_) | Item::Action(_) => false,
        });
        own.flat_map(|item| self.on_same_pin(item)).collect()
    }

    /// All that can be taken hold of, joints first.
    pub fn handles(&self) -> impl Iterator<Item = Handle<'_>> + Clone {
        self.index.handles.iter().map(|(item, axis, kind)| Handle {
            item,
            place: self.place(*axis),
            kind: *kind,
        })
    }

    /// Where each joint is seen, and where the end of its other link is: apart, if that does not close as drawn.
    pub(crate) fn ends_of_joints(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let joints = self.model.joint_ids();
        joints.filter_map(|joint| {
            let seen = self.place(self.axis_of_joint(joint)?);
            let [one, other] = ends(&self.model, &self.poses, self.model.joint(joint))?;
            let is_one = distance(seen, one) <= distance(seen, other);
            Some(if is_one { [one, other] } else { [other, one] })
        })
    }

    pub(crate) fn has_motor(&self, name: &str) -> bool {
        let joint = self.joint(name);
        joint.is_some_and(|joint| self.model.motor_of(joint).is_some())
    }

    /// Finds the item at a place, no farther away than `reach`.
    pub(crate) fn item_at(&self, place: [f64; 2], reach: f64) -> Option<Item> {
        for (name, [from, to]) in self.actions() {
            if distance_to_line(place, [from, to]) <= reach {
                return Some(Item::Action(name.to_owned()));
            }
        }
        self.item_of(&self.hit(place, reach))
    }

    /// Names a hit; none if it is the paper.
    pub(crate) fn item_of(&self, hit: &Hit) -> Option<Item> {
        match *hit {
            Hit::Joint(joint) => Some(Item::Joint(self.model.joint(joint).name.clone())),
            Hit::Axis(axis) => self.path(axis).map(Item::Axis),
            Hit::Link(link) => Some(Item::Link(self.model.link(link).name.clone())),
            Hit::Paper => None,
        }
    }

    /// Finds the hit for an item; none if the item is not there.
    pub(crate) fn hit_of(&self, item: &Item) -> Option<Hit> {
        match item {
            Item::Joint(name) => self.joint(name).map(Hit::Joint),
            Item::Axis(path) => self.axis(path).map(Hit::Axis),
            Item::Link(name) => self.link(name).map(Hit::Link),
            Item::Action(_) => None,
        }
    }

    /// The springs and dampers that go from a place to another, by their names.
    pub(crate) fn actions(&self) -> impl Iterator<Item = (&str, [[f64; 2]; 2])> {
        let actions = &self.model.actions;
        let springs = actions.springs.iter().map(|one| (&*one.name, one.between));
        let dampers = actions.dampers.iter().map(|one| (&*one.name, one.between));
        springs.chain(dampers).filter_map(|(name, between)| match between {
            Between::Points(a, b) => Some((name, [self.place(a), self.place(b)])),
            Between::Joint(_) => None,
        })
    }

    /// Finds the thing at a place, no farther away than `reach`.
    pub(crate) fn hit(&self, place: [f64; 2], reach: f64) -> Hit {
        let near = self.handles().map(|handle| (distance(place, handle.place), handle.item));
        let near = near.filter(|(away, _)| *away <= reach);
        if let Some((_, item)) = near.min_by(|a, b| a.0.total_cmp(&b.0))
            && let Some(hit) = self.hit_of(item)
        {
            return hit;
        }
        let links = self.model.declared_links();
        let links = links.map(|link| (self.distance_to(link, place), link));
        let link = links.filter(|(away, _)| *away <= reach).min_by(|a, b| a.0.total_cmp(&b.0));
        link.map_or(Hit::Paper, |(_, link)| Hit::Link(link))
    }

    /// Computes the distance of a place from the bars of a link, or from its wheel.
    fn distance_to(&self, link: LinkId, place: [f64; 2]) -> f64 {
        let bars = self.bars_of(link);
        let away = bars.map(|line| distance_to_line(place, line));
        let mut least = away.fold(f64::INFINITY, f64::min);
        if let Some((center, radius)) = self.wheel(link) {
            least = least.min((distance(place, center) - radius).max(0.0));
        }
        least
    }

    /// The bar of a link that is nearest to a place, no farther away than `reach`.
    pub(crate) fn bar_at(
        &self,
        link: LinkId,
        place: [f64; 2],
        reach: f64,
    ) -> Option<[[f64; 2]; 2]> {
        let away = |line: &[[f64; 2]; 2]| distance_to_line(place, *line);
        let bars = self.bars_of(link).filter(|[from, to]| from != to);
        let nearest = bars.min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.filter(|bar| away(bar) <= reach)
    }

    /// The stretches between the points and joints of a link, and these themselves.
    fn bars_of(&self, link: LinkId) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let places = self.places_on(link);
        (0..places.len()).flat_map(move |index| {
            let from = places[index];
            let others = places[index..].to_vec();
            others.into_iter().map(move |to| [from, to])
        })
    }

    pub(crate) fn axes_on(&self, link: LinkId) -> impl Iterator<Item = AxisId> {
        self.index.on_link[link.index()].iter().copied()
    }

    /// Where the axes of a link are in the scene.
    pub(crate) fn places_on(&self, link: LinkId) -> Vec<[f64; 2]> {
        let own = self.index.on_link[link.index()].iter();
        own.map(|axis| self.place(*axis)).collect()
    }

    /// Where the points and joints of the link of this name are in the scene; none if it is not there.
    #[must_use]
    pub fn places_of(&self, link: &str) -> Option<Vec<[f64; 2]>> {
        Some(self.places_on(self.link(link)?))
    }

    /// The pitch circle of a link that rolls on another, about a pivot.
    pub(crate) fn wheel(&self, link: LinkId) -> Option<([f64; 2], f64)> {
        let (joint, side) = self.index.wheels[link.index()]?;
        let kind = &self.model.joint(joint).kind;
        let (JointKind::Gear { a, b, ratio, .. } | JointKind::Belt { a, b, ratio, .. }) = kind
        else {
            return None;
        };
        let centers = [self.pivot(*a)?, self.pivot(*b)?];
        let apart = distance(centers[0], centers[1]);
        let radii = match kind {
            JointKind::Gear { .. } => ratio.pitch_radii(apart),
            _ => ratio.pulley_radii(apart),
        };
        Some((centers[side], radii[side]))
    }

    /// Where a link turns: its first joint that does.
    pub(crate) fn pivot(&self, link: LinkId) -> Option<[f64; 2]> {
        let axis = self.index.pivots[link.index()]?;
        Some(self.place(axis))
    }
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
