//! What is carried of params: where axes are in their links that something tells, and what says so must be a number.

use super::Writer;
use crate::model::{AxisId, Between, JointKind};
use crate::plan::Algebra;
use crate::program::Place;

impl Writer<'_> {
    /// Carries where axes are that are told by themselves, by a joint's coordinate, by a spring or by the overlay, if it depends on
    /// params.
    pub(super) fn keep_places(&mut self) {
        for id in self.told_axes() {
            let axis = self.model.axis(id);
            let place = self.builder.place(axis);
            for part in (0..2).filter(|&part| axis.formulas[part].is_some()) {
                let state = self.state.len();
                self.keep(self.builder.at_start(place[part]));
                self.state[state] = place[part];
                self.places.push(Place {
                    axis: id,
                    part,
                    state,
                });
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
