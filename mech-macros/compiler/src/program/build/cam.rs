//! Followers of cams.

use super::Writer;
use super::tangent::{Seed, Tangents};
use crate::bug::bug;
use crate::model::{JointId, JointKind};
use crate::plan::{Algebra, Cam, ConnectionKind, Rational, Source, float_of};
use crate::program::node::Value;

/// A follower that was put where its cam has it.
pub(super) struct Followed {
    pub(super) cam: JointId,
    /// The coordinate of the shaft.
    pub(super) shaft: Value,
    /// The coordinate of the follower.
    pub(super) value: Value,
}

impl Writer<'_> {
    /// How fast a follower is if the shaft of its cam moves at a rate of one.
    pub(super) fn slope(&mut self, cam: JointId) -> Option<Value> {
        let followed = self.followed.iter().find(|followed| followed.cam == cam)?;
        let (shaft, value) = (followed.shaft, followed.value);
        // No motor moves but what turns the shaft.
        let mut tangents = Tangents::new(Seed::Alone(usize::MAX), self.model.motors.len());
        let one = self.builder.constant(1.0);
        tangents.set(&mut self.builder, shaft, one);
        Some(tangents.of_all_up_to(&mut self.builder, value))
    }

    /// Puts a follower where the law of its cam has it.
    pub(super) fn cam(&mut self, cam: &Cam) {
        let JointKind::Cam { shaft, law, .. } = self.model.joint(cam.by).kind else {
            return;
        };
        let (law, name) = (self.model.law(law), &self.model.joint(cam.by).name);
        self.builder
            .block(format!("follow_{name}"), format!("Moved by cam `{name}`."));
        let turns = matches!(self.model.joint(shaft).kind, JointKind::Revolute(..));
        let winding = law.winding().filter(|_| turns);
        // Of what goes on by whole turns with its shaft, an angle needs only what it is in one turn, and what returns anything.
        let in_one_turn = match cam.connection.kind {
            ConnectionKind::Revolute => winding.is_some_and(|turns| turns.fract() == 0.0),
            ConnectionKind::Prismatic => winding == Some(0.0),
        };
        self.wanders |= winding.is_none();
        let shaft = self.model.joint(shaft).name.clone();
        let angle = self.shaft(cam, in_one_turn);
        self.builder.name(angle, shaft);
        let value = self.builder.law(law, angle);
        let follower = self.model.joint(cam.connection.joint).name.clone();
        self.builder.name(value, &follower);
        self.followed.push(Followed {
            cam: cam.by,
            shaft: angle,
            value,
        });
        self.note_cam(cam, law);
        self.put(cam.connection, value, &follower);
    }

    /// The coordinate of the shaft of a cam; less whole turns, if that is enough.
    pub(super) fn shaft(&mut self, cam: &Cam, in_one_turn: bool) -> Value {
        let mut starts = self.plan.start.cams.iter();
        let Some(start) = starts.find(|start| start.cam == cam.by) else {
            bug!("cam `{}` starts nowhere", self.model.joint(cam.by).name);
        };
        let mut offset = start.shaft;
        let mut moved = self.builder.constant(0.0);
        for (number, exact) in &cam.parts {
            offset -= float_of(exact) * self.plan.start.sources[*number];
            let share = self.part(*number, exact, in_one_turn);
            moved = self.builder.add(moved, share);
        }
        let offset = self.builder.constant(offset);
        self.builder.add(offset, moved)
    }

    /// A part of what a source gives. Of an angle that loops have solved, whole turns are followed only where they are needed.
    fn part(&mut self, number: usize, exact: &Rational, in_one_turn: bool) -> Value {
        match self.plan.sources[number] {
            Source::Angle { from, to } if in_one_turn && exact.is_integer() => {
                let angle = self.principal(number, [from, to]);
                let factor = self.builder.constant(float_of(exact));
                self.builder.mul(factor, angle)
            }
            _ => self.share(number, exact, in_one_turn),
        }
    }
}
