//! Numbers of axes and shapes that depend on params: a position carries what accessors, springs, the overlay and `draw` read.

use super::lowering::Lowering;
use crate::model::{AxisId, Between, JointKind, Look};
use crate::program::Place;

impl Lowering<'_> {
    /// Carries the numbers of axes and shapes that depend on params and that something outside of the program reads.
    pub(super) fn carry_places(&mut self) {
        let model = self.model;
        let axes = self.exposed_axes().into_iter();
        let of_axes = axes.flat_map(|id| model.axis(id).all_formulas());
        let shapes = model.links.iter().flat_map(|link| &link.shapes);
        let of_shapes = shapes.flat_map(|shape| shape.formulas.iter().flatten().copied());
        for formula in of_axes.chain(of_shapes) {
            let places = &mut self.layout.places;
            if places.iter().all(|place| place.formula != formula) {
                let value = self.ssa.formulas[formula.index()];
                let state = self.ssa.record(value).index;
                places.push(Place { formula, state });
            }
        }
    }

    /// The axes that depend on params and are read outside of the program: for points, coordinates, springs and the overlay. Each stands
    /// once.
    fn exposed_axes(&self) -> Vec<AxisId> {
        let model = self.model;
        let joints = model.joint_ids().filter(|&id| model.shows_joint(id));
        let of_joints = joints.filter_map(|id| match model.joint(id).kind {
            JointKind::Prismatic(a, b) => Some([a, b].map(|axis| model.seen_axis(axis))),
            _ => None,
        });
        // The forces of springs are computed from their ends.
        let springs = model.actions.springs.iter();
        let sprung = springs.filter_map(|spring| match spring.between {
            Between::Points(a, b) if model.effects.needs_actions() => Some([a, b]),
            _ => None,
        });
        // Bodies and diagrams are drawn from whatever there is.
        let all = if model.effects.overlay || model.look() != Look::Shapes {
            model.axes.len()
        } else {
            0
        };
        let drawn = (0..all).map(AxisId::new);
        let mut exposed: Vec<AxisId> = model
            .shown_points()
            .chain(of_joints.flatten())
            .chain(sprung.flatten())
            .chain(drawn)
            .filter(|&id| model.axis(id).varies())
            .collect();
        exposed.sort_unstable();
        exposed.dedup();
        exposed
    }
}
