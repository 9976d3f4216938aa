//! Changes to a changed mechanism.

use super::{Declaration, Ends, NewJoint, NewMotor, Repair};
use crate::model::{AxisId, JointId, LinkId, Model};

/// A change to a changed mechanism, as one to the original: what has the same name is the same.
pub(super) fn translate(repair: &Repair, changed: &Model, original: &Model) -> Option<Repair> {
    let joint = |id: JointId| {
        let name = &changed.joint(id).name;
        let same = |id: &JointId| original.joint(*id).name == *name && !original.joint(*id).hidden;
        original.joint_ids().find(same)
    };
    let link = |id: LinkId| {
        let name = &changed.link(id).name;
        let same =
            |id: &LinkId| original.link(*id).name == *name && original.link(*id).die.is_none();
        original.link_ids().find(same)
    };
    let end = |id: LinkId| {
        // A link that is declared with the joint comes after all others.
        if id.index() == changed.links.len() {
            return Some(LinkId::new(original.links.len()));
        }
        link(id)
    };
    let point = |id: AxisId| {
        let axis = changed.axis(id);
        let owner = link(axis.link)?;
        let same = |other: &AxisId| {
            let other = original.axis(*other);
            other.link == owner && other.name == axis.name
        };
        (0..original.axes.len()).map(AxisId::new).find(same)
    };
    let ends = |ends: &Ends| {
        Some(match *ends {
            Ends::Drawn { links: [a, b], at } => Ends::Drawn { links: [end(a)?, end(b)?], at },
            Ends::Points([a, b]) => Ends::Points([point(a)?, point(b)?]),
        })
    };
    let declaration = |declared: &Declaration| {
        let joints = declared
            .joints
            .iter()
            .map(|new| Some(NewJoint { ends: ends(&new.ends)?, ..new.clone() }));
        let replaced = declared.replaced.iter().map(|&id| joint(id));
        Some(Declaration {
            purpose: declared.purpose,
            link: declared.link.clone(),
            joints: joints.collect::<Option<_>>()?,
            replaced: replaced.collect::<Option<_>>()?,
        })
    };
    Some(match repair {
        Repair::Declare(declared) => Repair::Declare(declaration(declared)?),
        Repair::RemoveJoint(id) => Repair::RemoveJoint(joint(*id)?),
        Repair::RemoveLink(id) => Repair::RemoveLink(link(*id)?),
        Repair::Replace { joint: id, by } => Repair::Replace { joint: joint(*id)?, by: *by },
        Repair::RemoveMotor(id) => {
            Repair::RemoveMotor(original.motor_of(joint(changed.motor(*id).joint)?)?)
        }
        Repair::AddMotors(motors) => {
            let motors =
                motors.iter().map(|motor| Some(NewMotor { joint: joint(motor.joint)?, ..*motor }));
            Repair::AddMotors(motors.collect::<Option<_>>()?)
        }
        _ => return None,
    })
}
