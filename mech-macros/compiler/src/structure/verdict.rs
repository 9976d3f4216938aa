//! Does it move, and do its motors determine the motion? Counted exactly, at random geometry.

use super::Structure;
use super::constraints::Constraints;
use super::diagnosis::Diagnosis;
use super::elimination::{Elimination, RowKind};
use super::field::{Dice, Element};
use super::graph::KinematicGraph;
use crate::model::{JointId, JointKind, LinkId, Model, MotorId};

/// An arbitrary number: the random geometry is the same in every build.
const SEED: u64 = 0x6a09_e667_f3bc_c908;

/// A motor whose joint's rate follows from others.
#[derive(Clone)]
struct Idle {
    motor: MotorId,
    /// The motors it depends on, itself included.
    among: Vec<MotorId>,
    /// The joints it depends on.
    joints: Vec<JointId>,
}

/// The rows of all joints and motors, eliminated.
struct Rank<'m> {
    model: &'m Model,
    constraints: Constraints<'m>,
    dice: Dice,
    /// The joints alone.
    joints: Elimination,
    /// The joints and the motors.
    driven: Elimination,
    /// Joints whose rows follow from those of others.
    dependent: Vec<JointId>,
    /// The motors that add nothing.
    idle: Vec<Idle>,
}

impl<'m> Rank<'m> {
    fn new(model: &'m Model, structure: &'m Structure) -> Self {
        let mut dice = Dice::new(SEED);
        let constraints = Constraints::new(model, structure, &mut dice);
        let mut joints = Elimination::new(constraints.unknowns());
        let mut joint_of_row = Vec::new();
        let mut dependent = vec![false; model.joints.len()];
        for id in model.joint_ids() {
            for row in constraints.of_joint(id) {
                joint_of_row.push(id);
                if let RowKind::Dependent(rows) = joints.add(row) {
                    for row in rows {
                        dependent[joint_of_row[row].index()] = true;
                    }
                }
            }
        }
        let mut driven = joints.clone();
        let mut idle = Vec::new();
        for id in model.motor_ids() {
            let row = constraints.rate_of_coordinate(model.motor(id).joint);
            if let RowKind::Dependent(rows) = driven.add(row) {
                let among = rows
                    .iter()
                    .filter_map(|row| row.checked_sub(joint_of_row.len()))
                    .map(MotorId::new);
                let mut joints: Vec<JointId> =
                    rows.iter().filter_map(|&row| joint_of_row.get(row).copied()).collect();
                joints.dedup();
                idle.push(Idle { motor: id, among: among.collect(), joints });
            }
        }
        let dependent = model.joint_ids().filter(|id| dependent[id.index()]).collect();
        Self { model, constraints, dice, joints, driven, dependent, idle }
    }

    /// The joints that move in a random motion of what is left free.
    fn moving_joints(&self, motion: &[Element]) -> Vec<JointId> {
        let moves = |id: &JointId| !self.rate(*id, motion).is_zero();
        self.model.joint_ids().filter(moves).collect()
    }

    /// The rate of a joint's coordinate in a motion.
    fn rate(&self, id: JointId, motion: &[Element]) -> Element {
        // A joint without a coordinate does not move.
        let rate = self.constraints.rate(id).unwrap_or_default();
        rate.iter().fold(Element::ZERO, |sum, &(column, factor)| sum + factor * motion[column])
    }

    /// The links that keep their place relative to this one in every motion of the joints.
    fn rigid_part(&mut self, link: LinkId) -> Vec<LinkId> {
        let motion = self.joints.random_motion(&mut self.dice);
        let rates = |id| self.constraints.of_link(id, &motion);
        self.model.link_ids().filter(|&id| rates(id) == rates(link)).collect()
    }

    /// Joints for motors that would take all freedom that is left: each of them alone where one is missing, all of them
    /// together where several are.
    fn candidates(&mut self) -> Vec<JointId> {
        let motion = self.driven.random_motion(&mut self.dice);
        let free = self.moving_joints(&motion);
        if self.driven.freedom() <= 1 {
            return free;
        }
        // A motor takes freedom if its row says something new. Rows are sparse: motions of a long chain are not.
        let mut taken = self.driven.forgetful();
        let takes = |id: &JointId| {
            let rate = self.constraints.rate(*id);
            taken.extend(rate.unwrap_or_default())
        };
        free.into_iter().filter(takes).collect()
    }
}

/// Whether the joints leave exactly the freedom that the motors take, and nothing is held twice: counted without finding out why.
pub(super) fn is_sound(model: &Model, structure: &Structure) -> bool {
    let mut dice = Dice::new(SEED);
    let constraints = Constraints::new(model, structure, &mut dice);
    let mut rows = Elimination::new(constraints.unknowns());
    let mut joints = model.joint_ids();
    let mut motors = model.motor_ids();
    joints.all(|id| constraints.of_joint(id).into_iter().all(|row| rows.extend(row)))
        && motors.all(|id| {
            let rate = constraints.rate(model.motor(id).joint);
            rate.is_some_and(|row| rows.extend(row))
        })
        && rows.freedom() == 0
        && !model.motors.is_empty()
}

/// Checks that the joints leave exactly the freedom that the motors take. Repairs are not looked for.
pub(super) fn verdict(model: &Model, structure: &Structure) -> Result<(), Vec<Diagnosis>> {
    let mut rank = Rank::new(model, structure);
    let mut diagnoses = blocked_motors(model, &mut rank);
    let freedom = rank.driven.freedom();
    // Whether it moves is asked when nothing else is wrong.
    let is_allowed = model.allow.redundant && freedom > 0;
    if rank.joints.freedom() == 0 && model.motors.is_empty() {
        diagnoses.push(Diagnosis::Rigid);
    } else if diagnoses.is_empty() && !rank.dependent.is_empty() && !is_allowed {
        diagnoses
            .push(Diagnosis::Overdetermined { joints: rank.dependent.clone(), is_mobile: false });
    }
    if freedom > 0 && model.motors.is_empty() {
        diagnoses.push(Diagnosis::NoMotor { freedom, candidates: rank.candidates() });
    } else if freedom > 0 {
        let motion = rank.driven.random_motion(&mut rank.dice);
        let free = rank.moving_joints(&motion);
        diagnoses.push(Diagnosis::Undetermined { freedom, free, candidates: rank.candidates() });
    }
    if diagnoses.is_empty() {
        return Ok(());
    }
    // What else is wrong may follow from it.
    let pointless = on_one_pin(model, structure);
    Err(if pointless.is_empty() { diagnoses } else { pointless })
}

/// The links that several joints hold, all on one pin, and no motor.
fn on_one_pin(model: &Model, structure: &Structure) -> Vec<Diagnosis> {
    let graph = KinematicGraph::new(model);
    let on_one_pin = |link: LinkId| {
        let mut joints: Vec<JointId> = graph.joints(link).map(|(joint, _)| joint).collect();
        joints.sort_unstable();
        let first = joints.first()?;
        let mut pins = structure.pins.iter();
        let pin = pins.find(|pin| pin.joints.contains(first))?;
        let is_free = |joint| pin.joints.contains(joint) && model.motor_of(*joint).is_none();
        let is_it = joints.len() > 1 && joints.iter().all(is_free);
        is_it.then_some(Diagnosis::OnOnePin { link, joints })
    };
    model.declared_links().filter_map(on_one_pin).collect()
}

fn blocked_motors(model: &Model, rank: &mut Rank<'_>) -> Vec<Diagnosis> {
    let mut diagnoses = Vec::new();
    for Idle { motor, among, joints } in rank.idle.clone() {
        if among.len() > 1 {
            diagnoses.push(Diagnosis::TooManyMotors { motor, among });
            continue;
        }
        let ends = model.ends(model.motor(motor).joint);
        let holding = if joints.is_empty() { aligning_joints(model, ends) } else { joints };
        let touched = |link: &LinkId| {
            let joins = |&joint: &JointId| {
                let (a, b) = model.ends(joint);
                *link == a || *link == b
            };
            *link == ends.0 || *link == ends.1 || holding.iter().any(joins)
        };
        let part = rank.rigid_part(ends.0).into_iter().filter(touched);
        diagnoses.push(Diagnosis::Blocked { motor, part: part.collect(), joints: holding });
    }
    diagnoses
}

/// The slides and welds by which two links keep their direction to each other.
fn aligning_joints(model: &Model, (a, b): (LinkId, LinkId)) -> Vec<JointId> {
    let keeps = |joint| {
        let kind = model.joint(joint).kind;
        matches!(kind, JointKind::Prismatic(..) | JointKind::Weld(..)).then_some(0)
    };
    KinematicGraph::new(model).path(a, b, keeps)
}
