//! The motors that determine loops, other than through other loops.

use crate::model::{JointId, JointKind, LinkId, Model, MotorId};
use crate::plan::{Loop, Plan};

/// A motor that determines a loop.
pub(super) struct Driver {
    pub(super) motor: MotorId,
    /// The index of the loop.
    pub(super) ring: usize,
    /// The gear, belt, rack or weld that passes the motion on to the loop; none if the motor's joint is in it.
    pub(super) by: Option<JointId>,
}

/// The motors of all loops, loop by loop.
pub(super) fn drivers(model: &Model, plan: &Plan) -> Vec<Driver> {
    let rings: Vec<&Loop> = plan.loops().collect();
    let mut drivers: Vec<Driver> = Vec::new();
    // For each loop, the motors that determine it, directly or through other loops.
    let mut known: Vec<Vec<MotorId>> = Vec::new();
    for (number, ring) in rings.iter().enumerate() {
        let before = ring.needs.iter().map(|&need| &known[need]);
        let mut all: Vec<MotorId> = before.flatten().copied().collect();
        for motor in model.motor_ids() {
            let is_member = ring.members.contains(&model.motor(motor).joint);
            let by = connecting_joint(model, motor, ring).filter(|_| !is_member);
            let drives = is_member || (ring.needs.is_empty() && by.is_some());
            if drives && !all.contains(&motor) {
                all.push(motor);
                drivers.push(Driver { motor, ring: number, by });
            }
        }
        known.push(all);
    }
    drivers
}

/// The joint without a coordinate that passes the motion of a motor on to a link of a loop.
fn connecting_joint(model: &Model, motor: MotorId, ring: &Loop) -> Option<JointId> {
    let in_ring = |link: LinkId| {
        let mut ends = ring.members.iter().map(|&member| model.ends(member));
        ends.any(|(a, b)| a == link || b == link)
    };
    let (a, b) = model.ends(model.motor(motor).joint);
    let mut moved: Vec<LinkId> =
        [a, b].into_iter().filter(|&link| link != LinkId::GROUND).collect();
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

/// Whether a joint passes motion on and has no coordinate of its own, as gears do.
fn passes_on(model: &Model, joint: JointId) -> bool {
    !matches!(model.joint(joint).kind, JointKind::Revolute(..) | JointKind::Prismatic(..))
}
