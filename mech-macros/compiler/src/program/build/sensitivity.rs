//! Sensitivities: the rates of everything with each param. A param is an input like a motor, and these are its influence coefficients.
//! All params share the loops' linear systems and differ only in the right sides.

use super::Positions;
use super::lowering::Lowering;
use super::tangent::{Seed, Tangents};
use crate::model::{AxisId, JointId, JointKind};
use crate::plan::{Algebra, Arithmetic};
use crate::program::LinearEquations;
use crate::program::node::Value;
use crate::program::sensitivity::{ParamRates, Sensitivity};

impl Lowering<'_> {
    /// Derives the rates of everything with each param.
    pub(super) fn derive_sensitivity(
        &mut self,
        positions: &Positions,
        poses: &[[Value; 4]],
        equations: &mut LinearEquations,
    ) -> Sensitivity {
        let (points, joints) = (
            self.model.shown_points().collect::<Vec<AxisId>>(),
            self.model.dependent_joints().collect::<Vec<JointId>>(),
        );
        let mut of_params = Vec::new();
        let motors = self.model.motors.len();
        for (number, param) in self.model.params.all().iter().enumerate() {
            let seed = Seed::Alone(motors + number);
            let (mut tangents, _) = self.all_rates(positions, seed, equations);
            let links = self.link_rates(&format!("{}_rates", param.name), poses, &mut tangents);
            of_params.push(ParamRates {
                links,
                points: self.point_rates(&points, &mut tangents),
                joints: self.joint_rates(&joints, &mut tangents),
            });
        }
        Sensitivity { points, joints, of_params }
    }

    fn point_rates(&mut self, points: &[AxisId], tangents: &mut Tangents) -> Vec<[Value; 2]> {
        let rates = points.iter().map(|&point| {
            let spot = self.point(point);
            tangents.of_vector(&mut self.ssa, spot)
        });
        rates.collect()
    }

    fn joint_rates(&mut self, joints: &[JointId], tangents: &mut Tangents) -> Vec<Value> {
        let rates = joints.iter().map(|&joint| {
            let (a, b, turns) = match self.model.joint(joint).kind {
                JointKind::Revolute(a, b) => (a, b, true),
                JointKind::Prismatic(a, b) => (a, b, false),
                _ => return self.ssa.constant(0.0),
            };
            let [a, b] = [a, b].map(|axis| self.model.seen_axis(axis));
            if turns {
                let [a, b] = [a, b].map(|axis| {
                    let direction = self.placement.pose(self.link_of(axis)).direction;
                    tangents.angular_velocity(&mut self.ssa, direction)
                });
                return self.ssa.sub(b, a);
            }
            let heading = self.placement.heading(&mut self.ssa, a);
            let span = self.placement.span(&mut self.ssa, a, b);
            let displacement = self.ssa.dot(heading, span);
            tangents.of(&mut self.ssa, displacement)
        });
        rates.collect()
    }
}
