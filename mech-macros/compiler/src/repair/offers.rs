//! Which changes cure what is wrong.

use super::candidates::candidates;
use super::trial::{Trial, Trials};
use super::{Repair, apply_all};
use crate::model::{JointId, Model};
use crate::structure::{self, Diagnosis};

/// What would mend a mechanism, as far as it was searched for. Everything in it was applied, and compiled.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Offers {
    /// Changes each of which is enough. What is then left to do, at most, is to pick one of several assemblies.
    pub single: Vec<Repair>,
    /// Changes each of which would be enough if the mechanism started elsewhere: as given, it does not close then.
    pub elsewhere: Vec<Repair>,
    /// Motors that would settle everything, but with loops that wait for each other: they need `allow coupled;`.
    pub coupled: Vec<Repair>,
    /// Where nothing is enough because more is wrong than this: changes that cure this and make nothing else worse.
    pub partial: Vec<Repair>,
    /// Where no single change is enough: changes that are, together.
    pub pairs: Vec<[Repair; 2]>,
    /// How far it was searched.
    pub search: Search,
}

/// How far cures were searched for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Search {
    /// Single changes.
    #[default]
    Singles,
    /// Single changes and pairs of them: all that are known.
    Pairs,
    /// As many as there was time for; there may be more.
    Bounded,
}

/// The most pairs that are found.
const PAIRS: usize = 6;

/// What would mend a mechanism, for each of the things that are wrong with it.
#[must_use]
pub fn offers(model: &Model, diagnoses: &[Diagnosis]) -> Vec<Offers> {
    let mut trials = Trials::new(model);
    diagnoses
        .iter()
        .enumerate()
        .map(|(index, _)| for_one(&mut trials, diagnoses, index))
        .collect()
}

fn for_one(trials: &mut Trials<'_>, all: &[Diagnosis], index: usize) -> Offers {
    let Some(diagnosis) = all.get(index) else {
        return Offers::default();
    };
    let one_is_enough = matches!(
        diagnosis,
        Diagnosis::DeadStart { .. }
            | Diagnosis::Undetermined { freedom: 2.., .. }
            | Diagnosis::NoMotor { freedom: 2.., .. }
    );
    let mut offers = Offers::default();
    let mut reducing = Vec::new();
    for repair in candidates(trials.model, all, diagnosis) {
        if one_is_enough && !offers.single.is_empty() {
            break;
        }
        if offers.single.iter().any(|known| same_place(known, &repair)) {
            continue;
        }
        match trials.of(std::slice::from_ref(&repair)) {
            Trial::Closes => offers.single.push(repair),
            Trial::OpensAtStart => offers.elsewhere.push(repair),
            Trial::Coupled => {
                if let Repair::AddMotors(_) = repair {
                    offers.coupled.push(repair);
                }
            }
            Trial::Fails(found) => {
                if all.len() > 1 && is_better(&found, all, index) {
                    offers.partial.push(repair.clone());
                }
                reducing.push((repair, found));
            }
            Trial::Untried => {}
        }
    }
    offers.coupled.retain(|repair| {
        let trial = trials.of(&[repair.clone(), Repair::AllowCoupled]);
        matches!(trial, Trial::Closes | Trial::OpensAtStart)
    });
    if one_is_enough && !(offers.single.is_empty() && offers.elsewhere.is_empty()) {
        offers.coupled.clear();
        offers
            .elsewhere
            .truncate(usize::from(offers.single.is_empty()));
    }
    for list in [
        &mut offers.single,
        &mut offers.elsewhere,
        &mut offers.partial,
    ] {
        list.sort_by_key(declared);
    }
    // The same in another direction.
    let single = &offers.single;
    offers
        .elsewhere
        .retain(|repair| !single.iter().any(|known| same_place(known, repair)));
    offers
        .elsewhere
        .dedup_by(|next, first| same_place(first, next));
    if offers.is_enough() {
        offers.partial.clear();
    } else if offers.partial.is_empty() && is_held(diagnosis) {
        pairs(trials, all, &reducing, &mut offers);
    }
    if trials.exhausted {
        offers.search = Search::Bounded;
    }
    offers
}

impl Offers {
    fn is_enough(&self) -> bool {
        !(self.single.is_empty() && self.elsewhere.is_empty() && self.coupled.is_empty())
    }

    /// Whether nothing was found.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.is_enough() && self.partial.is_empty() && self.pairs.is_empty()
    }
}

/// In which order changes are told: those of links and joints as declared, others as they were tried.
fn declared(repair: &Repair) -> (usize, usize) {
    match repair {
        Repair::RemoveLink(link) => (1, link.index()),
        Repair::RemoveJoint(joint) => (2, joint.index()),
        Repair::MakeSlot { joint, .. } => (3, joint.index()),
        Repair::Unweld(joint) => (4, joint.index()),
        _ => (0, 0),
    }
}

/// Whether two changes differ only in the direction of a slot.
fn same_place(a: &Repair, b: &Repair) -> bool {
    match (a, b) {
        (Repair::MakeSlot { joint: a, .. }, Repair::MakeSlot { joint: b, .. }) => a == b,
        _ => false,
    }
}

fn is_held(diagnosis: &Diagnosis) -> bool {
    matches!(
        diagnosis,
        Diagnosis::Blocked { .. }
            | Diagnosis::TooManyMotors { .. }
            | Diagnosis::Overdetermined { .. }
            | Diagnosis::Rigid
    )
}

/// Whether of all that was wrong this one is gone and nothing has come.
fn is_better(found: &[Diagnosis], all: &[Diagnosis], index: usize) -> bool {
    let mut rest: Vec<_> = all
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != index)
        .map(|(_, diagnosis)| std::mem::discriminant(diagnosis))
        .collect();
    found.iter().all(|diagnosis| {
        let kind = std::mem::discriminant(diagnosis);
        let known = rest.iter().position(|other| *other == kind);
        known.map(|at| rest.swap_remove(at)).is_some()
    })
}

/// Searches for two changes that are enough together.
fn pairs(
    trials: &mut Trials<'_>,
    all: &[Diagnosis],
    tried: &[(Repair, Vec<Diagnosis>)],
    offers: &mut Offers,
) {
    offers.search = Search::Pairs;
    let model = trials.model;
    let excess = |repairs: &[Repair], found: &[Diagnosis]| {
        let changed = apply_all(repairs, model)?;
        let free = i64::try_from(freedom(found)?).ok()?;
        let motors = i64::try_from(changed.motors.len()).ok()?;
        Some(free + motors - structure::mobility(&changed))
    };
    let Some(before) = excess(&[], all) else {
        return;
    };
    let mut by_freedom: Vec<(usize, &Repair, &[Diagnosis])> = tried
        .iter()
        .filter_map(|(repair, found)| Some((freedom(found)?, repair, &found[..])))
        .collect();
    by_freedom.sort_by_key(|(freedom, ..)| *freedom);
    for (_, repair, found) in &by_freedom {
        for motors in motors_for(model, repair, found) {
            attempt(trials, offers, [(*repair).clone(), motors]);
        }
    }
    // Only what takes away something of what is too much can be half of a cure by two changes to links and joints.
    let halves: Vec<_> = by_freedom
        .into_iter()
        .filter(|(_, repair, found)| {
            let after = excess(std::slice::from_ref(repair), found);
            after.is_some_and(|after| after < before)
        })
        .collect();
    for (index, (_, second, _)) in halves.iter().enumerate() {
        for (_, first, _) in &halves[..index] {
            attempt(trials, offers, [(*first).clone(), (*second).clone()]);
        }
    }
}

fn attempt(trials: &mut Trials<'_>, offers: &mut Offers, pair: [Repair; 2]) {
    let same = |a: &Repair, b: &Repair| a == b || same_place(a, b);
    let is_known = |[a, b]: &[Repair; 2]| {
        let [first, second] = &pair;
        (same(a, first) && same(b, second)) || (same(a, second) && same(b, first))
    };
    let done = offers.pairs.len() >= PAIRS || offers.pairs.iter().any(is_known);
    if !done && trials.of(&pair) == Trial::Closes {
        offers.pairs.push(pair);
    }
}

/// How many motors are missing, if what is wrong is a matter of freedom.
fn freedom(diagnoses: &[Diagnosis]) -> Option<usize> {
    let missing = |diagnosis: &Diagnosis| match diagnosis {
        Diagnosis::NoMotor { freedom, .. } | Diagnosis::Undetermined { freedom, .. } => {
            Some(*freedom)
        }
        other => is_held(other).then_some(0),
    };
    diagnoses.iter().map(missing).sum()
}

/// Motors that a change makes room for: each of a few alone, or several together.
fn motors_for(model: &Model, repair: &Repair, found: &[Diagnosis]) -> Vec<Repair> {
    const FEW: usize = 3;
    let (freedom, candidates) = match found {
        [
            Diagnosis::NoMotor {
                freedom,
                candidates,
            },
        ]
        | [
            Diagnosis::Undetermined {
                freedom,
                candidates,
                ..
            },
        ] => (*freedom, candidates),
        _ => return Vec::new(),
    };
    let Some(changed) = repair.apply(model) else {
        return Vec::new();
    };
    let original = |joint: &JointId| {
        let name = &changed.joint(*joint).name;
        let same = |id: &JointId| model.joint(*id).name == *name && !model.joint(*id).hidden;
        model.joint_ids().find(same)
    };
    let joints: Vec<JointId> = candidates.iter().filter_map(original).collect();
    if freedom > 1 {
        return vec![Repair::AddMotors(joints)];
    }
    joints
        .into_iter()
        .take(FEW)
        .map(|joint| Repair::AddMotors(vec![joint]))
        .collect()
}
