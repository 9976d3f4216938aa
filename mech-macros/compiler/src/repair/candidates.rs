//! The changes that might cure a diagnosis.

use super::guides::Guides;
use super::sketch::{Sketch, leaves};
use super::twins::twins;
use super::union::unions;
use super::{NewKind, Repair, completions, drivable, replacement, wheels};
use crate::model::{JointId, JointKind, LinkId, Model, MotorId};
use crate::structure::{self, Diagnosis, InverseTrouble, MeshTrouble};

/// All single changes that might cure this, the likely ones first.
pub(super) fn candidates(model: &Model, all: &[Diagnosis], of: &Diagnosis) -> Vec<Repair> {
    match of {
        Diagnosis::Blocked { motor, part, joints } => {
            let mut repairs = relocations(model, all, &[*motor]);
            repairs.push(Repair::RemoveMotor(*motor));
            let mut links = ends(model, joints);
            links.extend(part);
            let joints = with_slides(model, joints, &mut links);
            repairs.extend(replacement::slots(model, &joints));
            repairs.extend(replacement::free_from_ground(model, &joints));
            repairs.extend(replacement::splits(model, &links));
            repairs.extend(on_part(model, &links, &joints));
            repairs
        }
        Diagnosis::TooManyMotors { among, .. } => {
            let mut repairs = relocations(model, all, among);
            repairs.extend(among.iter().map(|&motor| Repair::RemoveMotor(motor)));
            let (links, joints): (Vec<_>, Vec<_>) =
                (model.link_ids().collect(), model.joint_ids().collect());
            repairs.extend(on_part(model, &links, &joints));
            repairs
        }
        Diagnosis::Overdetermined { joints, is_mobile } => {
            let mut repairs = Vec::new();
            if *is_mobile {
                repairs.push(Repair::AllowRedundant);
            }
            repairs.extend(replacement::bolts(model, joints));
            let mut joints = joints.clone();
            if *is_mobile {
                joints.extend(held_joints(model));
            }
            let mut links = ends(model, &joints);
            let joints = with_slides(model, &joints, &mut links);
            repairs.extend(replacement::slots(model, &joints));
            repairs.extend(replacement::free_from_ground(model, &joints));
            if !is_mobile {
                repairs.extend(replacement::splits(model, &links));
            }
            repairs.extend(on_part(model, &links, &joints));
            repairs
        }
        Diagnosis::Rigid => {
            let (links, joints): (Vec<_>, Vec<_>) =
                (model.link_ids().collect(), model.joint_ids().collect());
            let mut repairs = replacement::slots(model, &joints);
            repairs.extend(replacement::free_from_ground(model, &joints));
            repairs.extend(replacement::splits(model, &links));
            repairs.extend(on_part(model, &links, &joints));
            repairs
        }
        Diagnosis::Loose { link } => {
            let mut repairs = vec![Repair::RemoveLink(*link)];
            repairs.extend(completions::joints(model, &Sketch::of(model)));
            repairs
        }
        Diagnosis::Disconnected { links } => {
            let mut repairs = completions::joints(model, &Sketch::of(model));
            repairs.extend(completions::fix_to_ground(model, links));
            repairs
        }
        Diagnosis::NoMotor { candidates, .. } => {
            let free: Vec<JointId> = model.joint_ids().collect();
            free_to_move(model, all, of, &free, candidates)
        }
        Diagnosis::Undetermined { free, candidates, .. } => {
            free_to_move(model, all, of, free, candidates)
        }
        Diagnosis::OnOnePin { joints, .. } => free_to_move(model, all, of, joints, &[]),
        Diagnosis::NotSequential { .. } => {
            let mut repairs = vec![Repair::AllowCoupled];
            for motor in model.motor_ids() {
                let joints = ground_first(model, model.joint_ids());
                repairs.extend(joints.map(|to| moved(motor, to)));
            }
            repairs
        }
        Diagnosis::NoCarrier { joint } => carriers(model, *joint, None),
        Diagnosis::NotCarrier { joint, link } => {
            [on_wheels(model, of), carriers(model, *joint, Some(*link))].concat()
        }
        Diagnosis::NoMesh { .. } => on_wheels(model, of),
        Diagnosis::DeadStart { .. } => {
            let motors = model.motor_ids();
            let mut repairs = twins(model, &Sketch::of(model));
            repairs.extend(motors.flat_map(|motor| elsewhere(model, motor)));
            for motor in model.motor_ids() {
                let joints = ground_first(model, model.joint_ids());
                repairs.extend(joints.map(|to| moved(motor, to)));
            }
            repairs
        }
        Diagnosis::Inverse { trouble } => followers(model, trouble),
        _ => Vec::new(),
    }
}

/// Changes that might let motors follow the point.
fn followers(model: &Model, trouble: &InverseTrouble) -> Vec<Repair> {
    let Some(inverse) = &model.inverse else {
        return Vec::new();
    };
    let motors = inverse.motors.iter();
    let mut repairs = match trouble {
        InverseTrouble::DeadStart { .. } => {
            motors.rev().flat_map(|motor| elsewhere(model, *motor)).collect()
        }
        InverseTrouble::Coupled { .. } => vec![Repair::AllowCoupled],
        InverseTrouble::Idle { .. } | InverseTrouble::Bound => Vec::new(),
        InverseTrouble::StartsOutside { .. }
        | InverseTrouble::Region { .. }
        | InverseTrouble::Trajectory { .. } => return Vec::new(),
    };
    if inverse.is_least {
        return repairs;
    }
    let lawless = model.motor_ids().filter(|id| model.motor(*id).law.is_none());
    let lawless: Vec<MotorId> = lawless.collect();
    let sets = several(&lawless, inverse.motors.len());
    let mut named = inverse.motors.clone();
    named.sort_unstable();
    let others = sets.filter(|set| *set != named);
    repairs.extend(others.map(Repair::Follow));
    repairs
}

/// Joints and links that may be missing, and motors.
fn free_to_move(
    model: &Model,
    all: &[Diagnosis],
    of: &Diagnosis,
    free: &[JointId],
    candidates: &[JointId],
) -> Vec<Repair> {
    let sketch = Sketch::of(model);
    let guides = Guides::new(model, &sketch, free);
    let is_one = matches!(
        of,
        Diagnosis::NoMotor { freedom: 1, .. } | Diagnosis::Undetermined { freedom: 1, .. }
    );
    let joints = completions::joints(model, &sketch);
    let mut repairs =
        if is_one { [joints, guides.slots()].concat() } else { [guides.slides(), joints].concat() };
    repairs.extend(unions(model, &sketch, free));
    repairs.extend(motors(model, all, of, candidates));
    let on_ground = |joint: JointId| {
        let (a, b) = model.ends(joint);
        a == LinkId::GROUND || b == LinkId::GROUND
    };
    // A single crank without a motor is no link too many.
    let lone = model.motors.is_empty();
    let leaves = leaves(model).into_iter();
    let leaves = leaves.filter(|(_, joint)| free.contains(joint) && !(lone && on_ground(*joint)));
    repairs.extend(leaves.map(|(link, _)| Repair::RemoveLink(link)));
    repairs.extend(replacement::guides(model, free));
    repairs.extend(completions::connecting_links(model, &sketch));
    if !lone {
        repairs.extend(replacement::welds(model, free));
    }
    repairs
}

/// Motors that would hold what is free.
fn motors(model: &Model, all: &[Diagnosis], of: &Diagnosis, candidates: &[JointId]) -> Vec<Repair> {
    let (Diagnosis::NoMotor { freedom, .. } | Diagnosis::Undetermined { freedom, .. }) = of else {
        return Vec::new();
    };
    if *freedom == 1 {
        let mut repairs = relocations_to(model, all, candidates);
        let motors = ground_first(model, candidates.iter().copied());
        repairs.extend(motors.map(|joint| Repair::AddMotors(vec![joint.into()])));
        return repairs;
    }
    let free: Vec<JointId> = ground_first(model, model.joint_ids()).collect();
    let mut repairs = vec![added(candidates)];
    let others = several(&free, *freedom).filter(|joints| !same_joints(joints, candidates));
    repairs.extend(others.map(|joints| added(&joints)));
    repairs
}

fn added(joints: &[JointId]) -> Repair {
    Repair::AddMotors(joints.iter().map(|&joint| joint.into()).collect())
}

fn moved(motor: MotorId, to: JointId) -> Repair {
    Repair::MoveMotor { motor, to: to.into() }
}

/// Whether these are the same joints, in whatever order.
fn same_joints(some: &[JointId], others: &[JointId]) -> bool {
    some.len() == others.len() && some.iter().all(|joint| others.contains(joint))
}

/// Joints by which a link, or this one, would carry what rolls.
fn carriers(model: &Model, rolling: JointId, on: Option<LinkId>) -> Vec<Repair> {
    let sketch = Sketch::of(model);
    let joints = completions::joints(model, &sketch);
    [joints, wheels::axles(model, rolling, on)].concat()
}

/// Other carriers, or other sizes, of wheels.
fn on_wheels(model: &Model, of: &Diagnosis) -> Vec<Repair> {
    match of {
        Diagnosis::NotCarrier { joint, .. } => {
            let named = structure::carriers(model, *joint).into_iter().map(Some);
            [None].into_iter().chain(named).map(|on| Repair::Carry { joint: *joint, on }).collect()
        }
        Diagnosis::NoMesh { joint, trouble: MeshTrouble::OneShaft, .. } => {
            let (a, b) = model.ends(*joint);
            let links = [b, a].map(Repair::RemoveLink);
            [Repair::RemoveJoint(*joint)].into_iter().chain(links).collect()
        }
        Diagnosis::NoMesh { joint, ratio, trouble, .. } => {
            let resize = |sizes| Repair::Resize { joint: *joint, sizes };
            let sizes = wheels::fitting_sizes(*ratio, *trouble).into_iter();
            sizes.map(resize).collect()
        }
        _ => Vec::new(),
    }
}

/// Every change to one link or joint of a part, of each kind in turn. What was declared last is tried first: it may be what
/// broke the mechanism.
fn on_part(model: &Model, links: &[LinkId], joints: &[JointId]) -> Vec<Repair> {
    let declared = |link: &LinkId| *link != LinkId::GROUND && model.link(*link).die.is_none();
    let shown = |joint: &JointId| !model.joint(*joint).hidden;
    let links = links.iter().copied().filter(declared);
    let joints: Vec<JointId> = joints.iter().copied().filter(shown).collect();
    let turns = |joint: &JointId| model.turns(*joint) && model.motor_of(*joint).is_none();
    let welded = |joint: &JointId| matches!(model.joint(*joint).kind, JointKind::Weld(..));
    let slots = joints.iter().copied().filter(turns).flat_map(|joint| {
        [[1.0, 0.0], [0.0, 1.0]].map(|along| Repair::Replace { joint, by: NewKind::Slot(along) })
    });
    let kinds: [Vec<Repair>; 4] = [
        links.map(Repair::RemoveLink).collect(),
        joints.iter().copied().map(Repair::RemoveJoint).collect(),
        joints
            .iter()
            .copied()
            .filter(welded)
            .map(|joint| Repair::Replace { joint, by: NewKind::Revolute })
            .collect(),
        slots.collect(),
    ];
    let longest = kinds.iter().map(Vec::len).max().unwrap_or(0);
    (0..longest)
        .flat_map(|index| {
            kinds.iter().filter_map(move |kind| kind.iter().rev().nth(index).cloned())
        })
        .collect()
}

/// The motors that could drive what is left free instead.
fn relocations(model: &Model, all: &[Diagnosis], motors: &[MotorId]) -> Vec<Repair> {
    let free = all.iter().find_map(|diagnosis| match diagnosis {
        Diagnosis::Undetermined { freedom: 1, candidates, .. } => Some(candidates),
        _ => None,
    });
    let to = |motor| {
        let joints = free.into_iter().flatten().copied();
        ground_first(model, joints).map(move |to| moved(motor, to))
    };
    motors.iter().copied().flat_map(to).collect()
}

/// The motors that do nothing where they are and could drive one of these joints.
fn relocations_to(model: &Model, all: &[Diagnosis], joints: &[JointId]) -> Vec<Repair> {
    let idle = all.iter().flat_map(|diagnosis| match diagnosis {
        Diagnosis::Blocked { motor, .. } => vec![*motor],
        Diagnosis::TooManyMotors { among, .. } => among.clone(),
        _ => Vec::new(),
    });
    let to = |motor| {
        let joints = joints.iter().copied();
        ground_first(model, joints).map(move |to| moved(motor, to))
    };
    idle.flat_map(to).collect()
}

/// The joints that could take a motor, those on the ground first, because that is where motors like to sit.
fn ground_first(
    model: &Model,
    joints: impl Iterator<Item = JointId>,
) -> std::vec::IntoIter<JointId> {
    let aloft = |joint: &JointId| {
        let (a, b) = model.ends(*joint);
        (a != LinkId::GROUND && b != LinkId::GROUND, *joint)
    };
    let mut joints: Vec<JointId> = joints.filter(|&joint| drivable(model, joint)).collect();
    joints.sort_by_key(aloft);
    joints.into_iter()
}

/// The links that these joints join.
fn ends(model: &Model, joints: &[JointId]) -> Vec<LinkId> {
    let mut links: Vec<LinkId> =
        joints.iter().flat_map(|&joint| <[LinkId; 2]>::from(model.ends(joint))).collect();
    links.sort();
    links.dedup();
    links
}

/// The joints that hold each other whatever the lengths.
fn held_joints(model: &Model) -> Vec<JointId> {
    let diagnoses = structure::analyse(model).err().unwrap_or_default();
    diagnoses
        .into_iter()
        .flat_map(|diagnosis| match diagnosis {
            Diagnosis::Blocked { joints, .. } | Diagnosis::Overdetermined { joints, .. } => joints,
            _ => Vec::new(),
        })
        .collect()
}

/// These joints, and the slides and welds by which these links keep their direction to others; those links are added.
fn with_slides(model: &Model, joints: &[JointId], links: &mut Vec<LinkId>) -> Vec<JointId> {
    let mut joints = joints.to_vec();
    let slides: Vec<JointId> = model
        .joint_ids()
        .filter(|&joint| {
            let kind = model.joint(joint).kind;
            matches!(kind, JointKind::Prismatic(..) | JointKind::Weld(..))
        })
        .collect();
    loop {
        let before = (joints.len(), links.len());
        for &slide in &slides {
            let (a, b) = model.ends(slide);
            let touches = [a, b].iter().any(|link| *link != LinkId::GROUND && links.contains(link));
            if touches {
                joints.push(slide);
                links.extend([a, b]);
            }
        }
        joints.sort();
        joints.dedup();
        links.sort();
        links.dedup();
        if before == (joints.len(), links.len()) {
            return joints;
        }
    }
}

/// Some choices of so many of these.
fn several<T: Copy>(all: &[T], count: usize) -> impl Iterator<Item = Vec<T>> {
    const MOST: usize = 60;
    let mut chosen: Vec<usize> = (0..count).collect();
    let total = all.len();
    let mut choices = Vec::new();
    while count <= total && choices.len() < MOST {
        choices.push(chosen.iter().map(|&index| all[index]).collect());
        let Some(at) = (0..count).rfind(|&at| chosen[at] < total - count + at) else {
            break;
        };
        let next = chosen[at] + 1;
        for (step, index) in chosen[at..].iter_mut().enumerate() {
            *index = next + step;
        }
    }
    choices.into_iter()
}

/// A motor a little further or less far.
fn elsewhere(model: &Model, motor: MotorId) -> [Repair; 2] {
    let joint = model.motor(motor).joint;
    let value = model.start.value(joint);
    [0.1, -0.1].map(|share| {
        let value = if let JointKind::Prismatic(..) = model.joint(joint).kind {
            value + share * if value == 0.0 { 1.0 } else { value.abs() }
        } else {
            (value.to_degrees() + 100.0 * share).to_radians()
        };
        Repair::StartAt { motor, value }
    })
}
