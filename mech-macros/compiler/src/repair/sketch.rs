//! The drawn parts of a mechanism: its pins, and the ends of links that no joint holds.

use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model, ShapeKind};
use std::collections::HashSet;

/// Two places are one if they are no farther apart than this part of the size.
const SAME: f64 = 1e-9;

/// Ends that are no farther apart than this part of the size may be meant to be one.
pub(super) const NEAR: f64 = 0.15;
/// So many joints of a kind are tried, and links between no more ends than these.
pub(super) const FEW: usize = 4;

/// A pin as it is drawn.
pub(super) struct DrawnPin {
    pub(super) at: [f64; 2],
    /// The links that turn on it, the ground among them.
    pub(super) links: Vec<LinkId>,
}

/// A place on a link where a joint could be, and none is.
#[derive(Clone)]
pub(super) struct LooseEnd {
    pub(super) link: LinkId,
    /// The name of the point, if it has one.
    pub(super) name: Option<String>,
    pub(super) at: [f64; 2],
}

/// The drawn places of the scene. Places that depend on params are left out.
pub(super) struct Sketch {
    /// The diagonal of the box around all places.
    pub(super) size: f64,
    pub(super) pins: Vec<DrawnPin>,
    /// The middles of what slides: each with what slides there.
    pub(super) blocks: Vec<DrawnPin>,
    pub(super) ends: Vec<LooseEnd>,
    /// The places between the ends of bars.
    pub(super) bends: Vec<(LinkId, [f64; 2])>,
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

impl Sketch {
    pub(super) fn of(model: &Model) -> Self {
        let scene = Scene::of(model);
        let mut sketch = Self {
            size: size(model, &scene),
            pins: Vec::new(),
            blocks: Vec::new(),
            ends: Vec::new(),
            bends: Vec::new(),
        };
        for joint in &model.joints {
            match joint.kind {
                JointKind::Revolute(a, b) => sketch.note_pin(model, &scene, [a, b]),
                JointKind::Prismatic(a, b) => sketch.note_block(model, &scene, [a, b]),
                _ => {}
            }
        }
        for id in unjoined(model, AxisKind::Point) {
            let axis = model.axis(id);
            let name = axis.name.clone();
            if scene.draws(axis) {
                sketch.note_end(model, axis.link, name, axis.at);
            }
        }
        for link in model.declared_links().filter(|&id| scene.has(id)) {
            let shapes = model.link(link).shapes.iter();
            for shape in shapes.filter(|shape| !shape.varies()) {
                if let ShapeKind::Bar { pins, .. } = &shape.kind {
                    for at in [pins.first(), pins.last()].into_iter().flatten() {
                        sketch.note_end(model, link, None, *at);
                    }
                    let inner = pins.get(1..pins.len() - 1).unwrap_or_default();
                    sketch.bends.extend(inner.iter().map(|&at| (link, at)));
                }
            }
        }
        sketch
    }

    pub(super) fn is_same(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let near = SAME * self.size;
        // Most places differ, and this is quick.
        (a[0] - b[0]).abs() <= near && distance(a, b) <= near
    }

    /// The pin at a place.
    pub(super) fn pin_at(&self, at: [f64; 2]) -> Option<&DrawnPin> {
        self.pins.iter().find(|pin| self.is_same(pin.at, at))
    }

    fn note_block(&mut self, model: &Model, scene: &Scene, axes: [AxisId; 2]) {
        let axes = axes.map(|id| model.axis(id));
        if axes.iter().all(|axis| scene.draws(axis)) {
            let links = axes.map(|axis| axis.link);
            let moving = links.into_iter().filter(|link| *link != LinkId::GROUND);
            self.blocks.push(DrawnPin { at: axes[0].at, links: moving.collect() });
        }
    }

    fn note_pin(&mut self, model: &Model, scene: &Scene, axes: [AxisId; 2]) {
        let axes = axes.map(|id| model.axis(id));
        if !axes.iter().all(|axis| scene.draws(axis)) {
            return;
        }
        let (at, links) = (axes[0].at, axes.map(|axis| axis.link));
        let known = self.pins.iter().position(|pin| self.is_same(pin.at, at));
        let known = known.unwrap_or_else(|| {
            self.pins.push(DrawnPin { at, links: Vec::new() });
            self.pins.len() - 1
        });
        for link in links {
            if !self.pins[known].links.contains(&link) {
                self.pins[known].links.push(link);
            }
        }
    }

    /// Notes the end of a link, unless a joint of that link is there.
    fn note_end(&mut self, model: &Model, link: LinkId, name: Option<String>, at: [f64; 2]) {
        let mut axes = joined_axes(model).map(|id| model.axis(id));
        let held = axes.any(|axis| axis.link == link && self.is_same(axis.at, at));
        let mut ends = self.ends.iter();
        let known = ends.any(|end| end.link == link && self.is_same(end.at, at));
        if !held && !known {
            self.ends.push(LooseEnd { link, name, at });
        }
    }
}

/// The axes that joints make coincide.
fn joined_axes(model: &Model) -> impl Iterator<Item = AxisId> + '_ {
    let axes = model.joints.iter().filter_map(|joint| joint.kind.axes());
    axes.flatten()
}

/// The named points or lines that no joint makes coincide with another. Traced points are left out: they need no joint.
pub(super) fn unjoined(model: &Model, kind: AxisKind) -> Vec<AxisId> {
    let ids = (0..model.axes.len()).map(AxisId::new);
    let joined: HashSet<AxisId> = joined_axes(model).collect();
    let traced: HashSet<AxisId> = model.traces.iter().map(|trace| trace.point).collect();
    let is_free = |id: &AxisId| {
        let axis = model.axis(*id);
        let named = axis.name.is_some();
        let own = axis.kind == kind && model.link(axis.link).die.is_none();
        named && own && !traced.contains(id) && !joined.contains(id)
    };
    ids.filter(is_free).collect()
}

/// The links whose frame is that of the scene: the ground, those that are drawn, and those that no joint places, if any is drawn or
/// there is no joint.
pub(super) struct Scene(Vec<bool>);

impl Scene {
    pub(super) fn of(model: &Model) -> Self {
        let others = model.joints.is_empty() || model.links.iter().any(|link| link.drawn);
        let links = model.links.iter();
        let mut is_there: Vec<bool> = links.map(|link| link.die.is_none() && others).collect();
        for axis in joined_axes(model) {
            is_there[model.axis(axis).link.index()] = false;
        }
        for (is_there, link) in is_there.iter_mut().zip(&model.links) {
            *is_there |= link.drawn;
        }
        is_there[LinkId::GROUND.index()] = true;
        Self(is_there)
    }

    /// Whether the frame of this link is that of the scene.
    pub(super) fn has(&self, link: LinkId) -> bool {
        self.0[link.index()]
    }

    /// Whether an axis is where the drawing has it, whatever the params.
    pub(super) fn draws(&self, axis: &Axis) -> bool {
        self.has(axis.link) && !axis.varies()
    }
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

/// The diagonal of the box around everything that is in the scene.
fn size(model: &Model, scene: &Scene) -> f64 {
    let axes = model.axes.iter().filter(|axis| scene.has(axis.link));
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for axis in axes {
        for side in [0, 1] {
            low[side] = low[side].min(axis.at[side]);
            high[side] = high[side].max(axis.at[side]);
        }
    }
    let diagonal = (high[0] - low[0]).hypot(high[1] - low[1]);
    if diagonal.is_finite() { diagonal } else { 0.0 }
}
