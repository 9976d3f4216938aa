//! What is carried of params: where axes are in their links that something tells, and what says so must be a number.

use super::Writer;
use crate::model::{AxisId, JointKind};
use crate::plan::Algebra;
use crate::program::Place;

impl Writer<'_> {
    /// Carries where axes are that are told by themselves or by a joint's coordinate, if it depends on params.
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

    /// The axes that vary and that a point or the coordinate of a joint tells, each once.
    fn told_axes(&self) -> Vec<AxisId> {
        let model = self.model;
        let joints = model.joint_ids().filter(|&id| model.shows_joint(id));
        let of_joints = joints.filter_map(|id| match model.joint(id).kind {
            JointKind::Prismatic(a, b) => Some([a, b].map(|axis| model.seen_axis(axis))),
            _ => None,
        });
        let mut told: Vec<AxisId> = model
            .told_points()
            .chain(of_joints.flatten())
            .filter(|&id| model.axis(id).varies())
            .collect();
        told.sort_unstable();
        told.dedup();
        told
    }
}
