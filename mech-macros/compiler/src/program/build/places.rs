//! What is carried of params: where axes are in their links that something tells, and what shapes are made of.

use super::Writer;
use crate::model::{AxisId, Between, JointKind};
use crate::program::Place;

impl Writer<'_> {
    /// Carries what depends on params of axes that are told by themselves, by a joint's coordinate, by a spring or by the overlay, and
    /// of shapes.
    pub(super) fn keep_places(&mut self) {
        let model = self.model;
        let axes = self.told_axes().into_iter();
        let of_axes = axes.flat_map(|id| model.axis(id).all_formulas());
        let shapes = model.links.iter().flat_map(|link| &link.shapes);
        let of_shapes = shapes.flat_map(|shape| shape.formulas.iter().flatten().copied());
        for formula in of_axes.chain(of_shapes) {
            if self.places.iter().all(|place| place.formula != formula) {
                let (value, state) = (self.builder.formula(formula), self.state.len());
                self.keep(self.builder.at_start(value));
                self.state[state] = value;
                self.places.push(Place { formula, state });
            }
        }
    }

    /// The axes that vary and that a point, the coordinate of a joint, the force of a spring or the overlay tells, each once.
    fn told_axes(&self) -> Vec<AxisId> {
        let model = self.model;
        let joints = model.joint_ids().filter(|&id| model.shows_joint(id));
        let of_joints = joints.filter_map(|id| match model.joint(id).kind {
            JointKind::Prismatic(a, b) => Some([a, b].map(|axis| model.seen_axis(axis))),
            _ => None,
        });
        // The forces of springs are told from where their ends are.
        let springs = model.actions.springs.iter();
        let sprung = springs.filter_map(|spring| match spring.between {
            Between::Points(a, b) if model.effects.needs_actions() => Some([a, b]),
            _ => None,
        });
        // The overlay draws whatever there is.
        let all = if model.effects.overlay {
            model.axes.len()
        } else {
            0
        };
        let drawn = (0..all).map(AxisId::new);
        let mut told: Vec<AxisId> = model
            .shown_points()
            .chain(of_joints.flatten())
            .chain(sprung.flatten())
            .chain(drawn)
            .filter(|&id| model.axis(id).varies())
            .collect();
        told.sort_unstable();
        told.dedup();
        told
    }
}
