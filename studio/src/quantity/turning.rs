//! Angles over whole turns: those of joints are carried by the program, those of links are sums of these.

use super::position::Position;
use mech_compiler::Compiled;
use mech_compiler::model::{JointId, JointKind, LinkId, Model};
use std::f64::consts::TAU;

/// The joints from the ground to a link that turn it.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Each turning joint, and the sense in which it turns the link.
    joints: Vec<(JointId, f64)>,
    /// The sum of the joints' angles less the angle of the link.
    ahead: f64,
}

impl Chain {
    /// The chain of joints that turns a link against the ground.
    pub(super) fn to(model: &Model, link: LinkId) -> Self {
        let mut chains: Vec<Option<Vec<(JointId, f64)>>> = vec![None; model.links.len()];
        chains[LinkId::GROUND.index()] = Some(Vec::new());
        let mut is_growing = true;
        while is_growing && chains[link.index()].is_none() {
            is_growing = false;
            for joint in model.joint_ids() {
                let kind = model.joint(joint).kind;
                let Some(axes) = kind.axes() else {
                    continue;
                };
                let [a, b] = axes.map(|axis| model.axis(axis).link.index());
                for (from, to, sense) in [(a, b, 1.0), (b, a, -1.0)] {
                    if let (Some(known), None) = (&chains[from], &chains[to]) {
                        let mut longer = known.clone();
                        if let JointKind::Revolute(..) = kind {
                            longer.push((joint, sense));
                        }
                        chains[to] = Some(longer);
                        is_growing = true;
                    }
                }
            }
        }
        Self { joints: chains.swap_remove(link.index()).unwrap_or_default(), ahead: 0.0 }
    }

    /// The same angle, counted from a position in which it is `heading`, between −π and π.
    pub(super) fn from(
        self,
        model: &Model,
        compiled: &Compiled,
        at: &Position,
        heading: f64,
    ) -> Self {
        let ahead = self.turned(model, compiled, at) - heading;
        Self { ahead, ..self }
    }

    /// The joints that turn it.
    pub(super) fn joints(&self) -> impl Iterator<Item = JointId> {
        self.joints.iter().map(|(joint, _)| *joint)
    }

    /// The angle of the link over any number of turns, from that between −π and π.
    pub(super) fn whole(
        &self,
        model: &Model,
        compiled: &Compiled,
        at: &Position,
        heading: f64,
    ) -> f64 {
        let near = self.turned(model, compiled, at) - self.ahead;
        heading + TAU * ((near - heading) / TAU).round()
    }

    fn turned(&self, model: &Model, compiled: &Compiled, at: &Position) -> f64 {
        let angles = self.joints.iter().map(|(joint, sense)| {
            let angle = whole_angle(model, compiled, at, *joint);
            sense * angle.unwrap_or(0.0)
        });
        angles.sum()
    }
}

/// The coordinate of a joint over any number of turns, if a motor gives it or the program carries it.
pub(super) fn whole_angle(
    model: &Model,
    compiled: &Compiled,
    at: &Position,
    joint: JointId,
) -> Option<f64> {
    match model.motor_of(joint) {
        Some(motor) => at.motor(motor.index()),
        None => at.state(compiled.program.angle_state(joint)?),
    }
}
