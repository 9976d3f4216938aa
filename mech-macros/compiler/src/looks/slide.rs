//! Prismatic joints and slots, as they are painted.

use crate::model::{AxisId, JointId, Model};

/// A prismatic joint: which link has the guide, and which one slides along it.
#[derive(Clone, Copy)]
pub(super) struct Slide {
    /// The line of the guide.
    pub(super) guide: AxisId,
    /// The line of what slides; of a slot, of its hidden die.
    pub(super) block: AxisId,
    /// The pin that slides in it, if it is a slot.
    pub(super) pin: Option<AxisId>,
}

impl Slide {
    /// The slide that a joint is, if it is one.
    pub(super) fn of(model: &Model, joint: JointId) -> Option<Self> {
        let [guide, block] = model.guide_and_block(joint)?;
        let die = model.link(model.axis(block).link).die;
        Some(Self { guide, block, pin: die.map(|(pin, _)| pin) })
    }
}
