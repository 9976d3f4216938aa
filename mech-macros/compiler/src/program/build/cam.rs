//! Followers of cams.

use super::Positions;
use super::lowering::Lowering;
use super::pass::{Follower, PositionPass};
use super::tangent::{Seed, Tangents};
use crate::bug::bug;
use crate::model::{JointId, JointKind};
use crate::plan::{Arithmetic, Cam, ConnectionKind, Rational, Source, float_of};
use crate::program::node::Value;

impl Lowering<'_> {
    /// The rate of a cam's follower if its shaft moves at a rate of one.
    pub(super) fn slope(&mut self, positions: &Positions, cam: JointId) -> Option<Value> {
        let mut followers = positions.followers.iter();
        let follower = followers.find(|follower| follower.cam == cam)?;
        // No motor moves but what turns the shaft.
        let mut tangents = Tangents::new(Seed::Alone(usize::MAX), self.model.motors.len());
        let one = self.ssa.constant(1.0);
        tangents.set(&mut self.ssa, follower.shaft, one);
        Some(tangents.of_all_up_to(&mut self.ssa, follower.value))
    }
}

impl PositionPass<'_> {
    /// A joint whose coordinate follows from the law of its cam.
    pub(super) fn cam(&mut self, cam: &Cam) {
        let model = self.lowering.model;
        let JointKind::Cam { shaft, law, .. } = model.joint(cam.by).kind else {
            return;
        };
        let (law, name) = (model.law(law), &model.joint(cam.by).name);
        let title = format!("Moved by cam `{name}`.");
        self.lowering.ssa.block(format!("follow_{name}"), title);
        let turns = model.turns(shaft);
        let winding = law.winding().filter(|_| turns);
        // Of a coordinate that grows by whole turns with its shaft, an angle needs only what it is in one turn, and what returns anything.
        let in_one_turn = match cam.connection.kind {
            ConnectionKind::Revolute => winding.is_some_and(|turns| turns.fract() == 0.0),
            ConnectionKind::Prismatic => winding == Some(0.0),
        };
        let angle = self.shaft(cam, in_one_turn);
        let ssa = &mut self.lowering.ssa;
        ssa.name(angle, &model.joint(shaft).name);
        let value = ssa.law(law, angle);
        let follower = &model.joint(cam.connection.joint).name;
        ssa.name(value, follower);
        self.followers.push(Follower {
            cam: cam.by,
            shaft: angle,
            value,
            wanders: winding.is_none(),
        });
        if self.continuous.contains(cam.connection) {
            let shaft = self.shaft(cam, law.winding() == Some(0.0));
            let whole = self.lowering.ssa.law(law, shaft);
            self.continuous.note(cam.connection, whole);
        }
        self.lowering.place(cam.connection, value, follower);
    }

    /// The coordinate of the shaft of a cam; less whole turns, if that is enough.
    fn shaft(&mut self, cam: &Cam, in_one_turn: bool) -> Value {
        let (model, plan) = (self.lowering.model, self.lowering.plan);
        let mut starts = plan.start.cams.iter();
        let Some(start) = starts.find(|start| start.cam == cam.by) else {
            bug!("cam `{}` starts nowhere", model.joint(cam.by).name);
        };
        let mut offset = start.shaft;
        let mut moved = self.lowering.ssa.constant(0.0);
        for (number, part) in &cam.parts {
            offset -= float_of(part) * plan.start.sources[*number];
            let share = self.shaft_share(*number, part, in_one_turn);
            moved = self.lowering.ssa.add(moved, share);
        }
        let offset = self.lowering.ssa.constant(offset);
        self.lowering.ssa.add(offset, moved)
    }

    /// The part of a source in the shaft's coordinate. Whole turns of an angle that loops give are followed only where they are needed.
    fn shaft_share(&mut self, number: usize, part: &Rational, in_one_turn: bool) -> Value {
        match self.lowering.plan.sources[number] {
            Source::Angle { from, to } if in_one_turn && part.is_integer() => {
                let links = [from, to];
                let angle = self.sources.principal(&mut self.lowering, number, links);
                let factor = self.lowering.ssa.constant(float_of(part));
                self.lowering.ssa.mul(factor, angle)
            }
            _ => self.share(number, part, in_one_turn),
        }
    }
}
