//! A joint's coordinate, followed by hand.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, JointKind, Model};
use mech_compiler::program::Position;
use std::f64::consts::TAU;

/// A joint's coordinate between −π and π, computed from the poses alone.
pub(super) fn principal(model: &Model, joint: JointId, position: &Position<f64>) -> f64 {
    let JointKind::Revolute(a, b) = model.joint(joint).kind else {
        panic!("a joint that does not turn");
    };
    let heading = |axis| {
        let axis = model.axis(axis);
        let [cos, sin] = match axis.link.index() {
            0 => [1.0, 0.0],
            link => [position.poses[link - 1][0], position.poses[link - 1][1]],
        };
        let [x, y] = axis.direction;
        [cos * x - sin * y, sin * x + cos * y]
    };
    let ([a, b], [c, d]) = (heading(a), heading(b));
    (a * d - b * c).atan2(a * c + b * d)
}

/// The value of an angle that is nearest to another one.
pub(super) fn near(principal: f64, last: f64) -> f64 {
    principal + TAU * ((last - principal) / TAU).round()
}

/// The first part of a move by so much: all motors keep the proportion of their displacements.
pub(super) fn part(from: &[f64], displacement: &[f64], part: f64) -> Vec<f64> {
    let both = from.iter().zip(displacement);
    both.map(|(from, displacement)| from + displacement * part)
        .collect()
}

/// A mechanism that moves in small steps, and the coordinates of some of its joints.
pub(super) struct Follower<'a> {
    model: &'a Model,
    /// The mechanism where it is.
    pub(super) machine: Machine<'a, f64>,
    joints: Vec<JointId>,
    /// The coordinates of the joints, over any number of turns.
    pub(super) angles: Vec<f64>,
    step: f64,
}

impl<'a> Follower<'a> {
    /// At the start of a machine, to move in steps of this length.
    pub(super) fn new(
        model: &'a Model,
        machine: Machine<'a, f64>,
        joints: &[JointId],
        step: f64,
    ) -> Self {
        let angle = |&joint| principal(model, joint, machine.position());
        let angles = joints.iter().map(angle).collect();
        Self {
            model,
            machine,
            joints: joints.to_vec(),
            angles,
            step,
        }
    }

    /// Moves all motors by so much; whether it went all the way.
    pub(super) fn move_by(&mut self, displacement: &[f64]) -> bool {
        let from = self.machine.position().motors.clone();
        let longest = displacement
            .iter()
            .fold(0.0_f64, |most, displacement| most.max(displacement.abs()));
        let pieces = (longest / self.step).ceil().max(1.0);
        let mut piece = 0.0;
        while piece < pieces {
            piece += 1.0;
            let between = part(&from, displacement, piece / pieces);
            if self.machine.move_to(&between).is_err() {
                return false;
            }
            for (joint, angle) in self.joints.iter().zip(&mut self.angles) {
                *angle = near(
                    principal(self.model, *joint, self.machine.position()),
                    *angle,
                );
            }
        }
        true
    }
}
