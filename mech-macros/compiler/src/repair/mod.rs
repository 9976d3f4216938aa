//! Repairs of a mechanism: each is written as a change of the text, and the changed text compiled, before it is offered.

mod candidates;
mod completions;
mod declaration;
mod guess;
mod guides;
mod limit;
mod motor;
mod numbers;
mod offers;
mod rank;
mod replacement;
mod sketch;
mod tie;
mod translation;
mod trial;
mod twins;
mod union;
mod wheels;
mod writing;

pub use declaration::{Declaration, Ends, NewJoint, NewKind, Purpose};
pub(crate) use limit::nearest_limit;
pub use motor::NewMotor;
pub(crate) use offers::add_effects;
pub use offers::{Offers, Search, offers};
pub use writing::edits;

use crate::model::{JointId, JointKind, LinkId, Model, MotorId, Ratio};
use std::ops::Range;

/// A change that a user can make. The ids are those of the mechanism that is to be mended.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Repair {
    /// Declare joints and links.
    Declare(Declaration),
    /// Take this joint away.
    RemoveJoint(JointId),
    /// Take this link away, with all its joints and the motors on them.
    RemoveLink(LinkId),
    /// Replace this revolute joint by a slot in its second link, with a direction in that link's frame; or this weld by a revolute joint.
    Replace {
        /// The joint.
        joint: JointId,
        /// Its new kind.
        by: NewKind,
    },
    /// Take this motor away.
    RemoveMotor(MotorId),
    /// Let this motor drive another joint.
    MoveMotor {
        /// The motor.
        motor: MotorId,
        /// The joint it should drive, with the range it has there.
        to: NewMotor,
    },
    /// Declare these motors.
    AddMotors(Vec<NewMotor>),
    /// Let joints hold a part more than once.
    AllowRedundant,
    /// Solve loops that wait for each other together.
    AllowCoupled,
    /// Ask for these effects.
    AddEffects(Vec<String>),
    /// Start this motor elsewhere: the assembly is not drawn, but found from there.
    StartAt {
        /// The motor.
        motor: MotorId,
        /// The coordinate of its joint, in radians or scene units.
        value: f64,
    },
    /// Let these motors follow the point.
    Follow(Vec<MotorId>),
    /// Name this link as the carrier of what rolls here.
    Carry {
        /// The gear, belt or rack.
        joint: JointId,
        /// Its carrier; none to leave it to be found.
        on: Option<LinkId>,
    },
    /// Let this joint hold another link than is written.
    Attach {
        /// The joint.
        joint: JointId,
        /// The link that is written.
        from: LinkId,
        /// The link that it should hold.
        to: LinkId,
    },
    /// Write other numbers where these stand.
    Numbers(NewNumbers),
    /// Give these wheels other sizes.
    Resize {
        /// The gear.
        joint: JointId,
        /// The sizes.
        sizes: Ratio,
    },
}

/// Numbers that stand in the text, and what to write for them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NewNumbers {
    /// Their tokens, counted in the text.
    pub tokens: Range<usize>,
    /// The numbers as they are written.
    pub old: String,
    /// The numbers that may be meant.
    pub new: String,
    /// The first words of their statement: `joint a`.
    pub statement: String,
}

/// Whether a motor could sit on this joint, and none does.
fn drivable(model: &Model, joint: JointId) -> bool {
    let moves =
        matches!(model.joint(joint).kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
    moves && !model.joint(joint).hidden && model.motor_of(joint).is_none()
}

/// Whether a cam names this joint.
fn is_in_cam(model: &Model, joint: JointId) -> bool {
    let mut cams = model.cams();
    cams.any(|(_, shaft, follower, _)| shaft == joint || follower == joint)
}
