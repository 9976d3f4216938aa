//! What would mend a mechanism: each change is made and the whole mechanism compiled again before it is offered.

mod candidates;
mod completions;
mod declaration;
mod offers;
mod rank;
mod sizes;
mod sketch;
mod translation;
mod trial;

pub use declaration::{Declaration, Purpose};
pub use offers::{Offers, Search, offers};

use crate::model::{Edit, JointId, JointKind, LinkId, Model, MotorId, NewKind, Ratio, StartValue};

/// A change that a user can make. The ids are those of the mechanism that is to be mended.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
        /// What it becomes.
        by: NewKind,
    },
    /// Take this motor away.
    RemoveMotor(MotorId),
    /// Let this motor drive another joint.
    MoveMotor {
        /// The motor.
        motor: MotorId,
        /// The joint it should drive.
        to: JointId,
    },
    /// Put a motor on each of these joints.
    AddMotors(Vec<JointId>),
    /// Let joints hold a part more than once.
    AllowRedundant,
    /// Solve loops that wait for each other together.
    AllowCoupled,
    /// Start this motor elsewhere: the assembly is not drawn, but found from there.
    StartAt {
        /// The motor.
        motor: MotorId,
        /// The coordinate of its joint, in radians or scene units.
        value: f64,
    },
    /// Name this link as the carrier of what rolls here.
    Carry {
        /// The gear, belt or rack.
        joint: JointId,
        /// Its carrier; none to leave it to be found.
        on: Option<LinkId>,
    },
    /// Give these wheels other sizes.
    Resize {
        /// The gear.
        joint: JointId,
        /// The sizes.
        sizes: Ratio,
    },
}

impl Repair {
    /// The mechanism with this change; none if the change cannot be made to it.
    #[must_use]
    pub fn apply(&self, model: &Model) -> Option<Model> {
        apply_all(std::slice::from_ref(self), model)
    }

    /// Makes the change; returns whether it can be made.
    fn make(&self, model: &Model, edit: &mut Edit) -> bool {
        match *self {
            Self::Declare(ref declaration) => declaration.make(model, edit),
            Self::RemoveJoint(joint) => {
                edit.remove_joint(joint);
                !model.joint(joint).hidden && !is_in_cam(model, joint)
            }
            Self::RemoveLink(link) => {
                edit.remove_link(link);
                link != LinkId::GROUND && model.link(link).die.is_none() && !carries(model, link)
            }
            Self::Replace { joint, by } => {
                edit.replace(joint, by);
                match by {
                    NewKind::Revolute => matches!(model.joint(joint).kind, JointKind::Weld(..)),
                    _ => declaration::turns_freely(model, joint),
                }
            }
            Self::RemoveMotor(motor) => {
                edit.remove_motor(motor);
                true
            }
            Self::MoveMotor { motor, to } => {
                edit.move_motor(motor, to);
                drivable(model, to)
            }
            Self::AddMotors(ref joints) => {
                for &joint in joints {
                    edit.add_motor(joint);
                }
                !joints.is_empty() && joints.iter().all(|&joint| drivable(model, joint))
            }
            Self::AllowRedundant => {
                let allow = &mut edit.settings().allow;
                !std::mem::replace(&mut allow.redundant, true)
            }
            Self::AllowCoupled => {
                let allow = &mut edit.settings().allow;
                !std::mem::replace(&mut allow.coupled, true)
            }
            Self::StartAt { motor, value } => {
                start_at(edit.settings(), motor, value);
                true
            }
            Self::Carry { joint, on } => {
                edit.carry(joint, on);
                model.joint(joint).kind.rolls()
            }
            Self::Resize { joint, sizes } => {
                edit.resize(joint, sizes);
                matches!(model.joint(joint).kind, JointKind::Gear { .. })
            }
        }
    }
}

/// The mechanism with all these changes; none if they cannot be made to it.
#[must_use]
pub fn apply_all(repairs: &[Repair], model: &Model) -> Option<Model> {
    let mut edit = Edit::new(model);
    let made = repairs.iter().all(|repair| repair.make(model, &mut edit));
    made.then(|| edit.finish())
}

/// Whether a motor could sit on this joint, and none does.
fn drivable(model: &Model, joint: JointId) -> bool {
    let moves = matches!(
        model.joint(joint).kind,
        JointKind::Revolute(..) | JointKind::Prismatic(..)
    );
    moves && !model.joint(joint).hidden && model.motor_of(joint).is_none()
}

/// Whether a gear, belt or rack names this link as its carrier, or a cam has it for one.
fn carries(model: &Model, link: LinkId) -> bool {
    model.joints.iter().any(|joint| match joint.kind {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => {
            on == Some(link)
        }
        JointKind::Cam {
            shaft, follower, ..
        } => model.carrier_of_cam(shaft, follower) == Some(link),
        _ => false,
    })
}

/// Whether a cam names this joint.
fn is_in_cam(model: &Model, joint: JointId) -> bool {
    let mut cams = model.cams();
    cams.any(|(_, shaft, follower, _)| shaft == joint || follower == joint)
}

fn start_at(model: &mut Model, motor: MotorId, value: f64) {
    let motor = *model.motor(motor);
    for link in &mut model.links {
        link.drawn = false;
    }
    let values = &mut model.start.values;
    values.retain(|value| value.joint != motor.joint);
    values.push(StartValue {
        joint: motor.joint,
        value,
        origin: motor.origin,
    });
}
