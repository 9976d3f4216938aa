//! Which motors lead to which loops, other than by way of loops.

use crate::model::{JointId, JointKind, LinkId, Model, MotorId};
use crate::plan::{Loop, Plan};

/// A motor that leads to a loop.
pub(super) struct Driver {
    pub(super) motor: MotorId,
    /// The loop, by its number.
    pub(super) ring: usize,
    /// The joint that passes the motion on to the loop, if the motor's own is not in it.
    pub(super) by: Option<JointId>,
}

/// All of them, loop by loop.
pub(super) fn drivers(model: &Model, plan: &Plan) -> Vec<Driver> {
    let rings: Vec<&Loop> = plan.loops().collect();
    let mut drivers: Vec<Driver> = Vec::new();
    // Of each loop, the motors that lead to it in any way.
    let mut known: Vec<Vec<MotorId>> = Vec::new();
    for (number, ring) in rings.iter().enumerate() {
        let before = ring.needs.iter().map(|&need| &known[need]);
        let mut all: Vec<MotorId> = before.flatten().copied().collect();
        for motor in model
            .motor_ids()
            .filter(|motor| !all.contains(motor))
            .collect::<Vec<_>>()
        {
            let by = if ring.members.contains(&model.motor(motor).joint) {
                None
            } else if !ring.needs.is_empty() {
                continue;
            } else if let Some(joint) = by_way_of(model, motor, ring) {
                Some(joint)
            } else {
                continue;
            };
            all.push(motor);
            drivers.push(Driver {
                motor,
                ring: number,
                by,
            });
        }
        known.push(all);
    }
    drivers
}

/// The joint without a coordinate that passes the motion of a motor on to a link of this loop.
fn by_way_of(model: &Model, motor: MotorId, ring: &Loop) -> Option<JointId> {
    let in_ring = |link: LinkId| {
        let mut ends = ring.members.iter().map(|&member| model.ends(member));
        ends.any(|(a, b)| a == link || b == link)
    };
    let (a, b) = model.ends(model.motor(motor).joint);
    let mut moved: Vec<LinkId> = [a, b]
        .into_iter()
        .filter(|&link| link != LinkId::GROUND)
        .collect();
    let mut next = 0;
    while let Some(&link) = moved.get(next) {
        next += 1;
        for joint in model.joint_ids().filter(|&joint| passes_on(model, joint)) {
            let (a, b) = model.ends(joint);
            let other = if a == link { b } else { a };
            if (a != link && b != link) || other == LinkId::GROUND || moved.contains(&other) {
                continue;
            }
            if in_ring(other) {
                return Some(joint);
            }
            moved.push(other);
        }
    }
    None
}

/// Gears and the like: they tie links to each other and have no coordinate of their own.
fn passes_on(model: &Model, joint: JointId) -> bool {
    !matches!(
        model.joint(joint).kind,
        JointKind::Revolute(..) | JointKind::Prismatic(..)
    )
}
