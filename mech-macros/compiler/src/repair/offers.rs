//! Which changes cure what is wrong.

use super::candidates::candidates;
use super::numbers::numbers;
use super::rank::Ranking;
use super::translation::translate;
use super::trial::{Trial, Trials};
use super::{Declaration, Purpose, Repair, edits};
use crate::model::{JointId, LinkId, Model};
use crate::structure::{Diagnosis, MeshTrouble};
use crate::syntax::Source;

/// The repairs that mend a mechanism, as far as they were searched for. Each of them was applied, and compiled.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Offers {
    /// Changes each of which is enough. What is then left to do, at most, is to pick one of several assemblies.
    pub single: Vec<Repair>,
    /// Changes each of which would be enough if the mechanism started elsewhere: as given, it does not close then.
    pub elsewhere: Vec<Repair>,
    /// Motors, or an allowance, that would settle everything, but with loops that wait for each other: they need `allow coupled;`.
    pub coupled: Vec<Repair>,
    /// Where more is wrong than this: changes that cure this, and make nothing else worse, without being enough.
    pub partial: Vec<Repair>,
    /// Where no single change is enough: changes that are, together.
    pub pairs: Vec<[Repair; 2]>,
    /// The extent of the search.
    pub search: Search,
}

/// The extent of a search for repairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

/// Repairs are sought for so many diagnoses: after the first ones are mended, others may not be wrong any more.
const SEARCHED: usize = 20;

/// No repairs are sought for a mechanism with more links and joints: there is no time to try two.
const LARGEST: usize = 1000;

/// Finds the repairs of the mechanism of a text, for each of its diagnoses; of very many, for the first.
#[must_use]
pub fn offers(model: &Model, source: &Source, diagnoses: &[Diagnosis]) -> Vec<Offers> {
    if model.links.len() + model.joints.len() > LARGEST {
        let none = Offers { search: Search::Bounded, ..Offers::default() };
        return vec![none; diagnoses.len()];
    }
    let mut trials = Trials::new(model, source);
    let searched =
        (0..diagnoses.len().min(SEARCHED)).map(|index| for_one(&mut trials, diagnoses, index));
    let mut offers: Vec<Offers> = searched.collect();
    offers.resize_with(diagnoses.len(), Offers::default);
    let is_enough =
        |one: &Offers| !(one.single.is_empty() && one.pairs.is_empty() && one.coupled.is_empty());
    let joins = |one: &Diagnosis| {
        let on_wheels = matches!(
            one,
            Diagnosis::NoCarrier { .. } | Diagnosis::NotCarrier { .. } | Diagnosis::NoMesh { .. }
        );
        let waits = matches!(one, Diagnosis::NotSequential { .. } | Diagnosis::DeadStart { .. });
        is_held(one) || is_free(one) || is_apart(one) || on_wheels || waits
    };
    if diagnoses.iter().any(joins) && !offers.iter().any(is_enough) {
        trials.refill();
        offers[0].single = attachments(&mut trials, diagnoses);
    }
    offers
}

fn for_one(trials: &mut Trials<'_>, all: &[Diagnosis], index: usize) -> Offers {
    let diagnosis = &all[index];
    let one_is_enough = matches!(
        diagnosis,
        Diagnosis::DeadStart { .. }
            | Diagnosis::Inverse { .. }
            | Diagnosis::Undetermined { freedom: 2.., .. }
            | Diagnosis::NoMotor { freedom: 2.., .. }
    );
    let mut offers = Offers::default();
    let (mut failed, mut unproved) = (Vec::new(), Vec::new());
    for repair in candidates(trials.model, all, diagnosis) {
        let is_known = |known: &Repair| {
            let kind = std::mem::discriminant(&repair);
            let same = one_is_enough && is_motor(known) && std::mem::discriminant(known) == kind;
            same || same_place(known, &repair)
        };
        if offers.single.iter().any(is_known) || has_enough(&offers.single, &repair) {
            continue;
        }
        match trials.of(std::slice::from_ref(&repair)) {
            Trial::Closes => match trials.proved(std::slice::from_ref(&repair)) {
                Some(mut proved) => offers.single.append(&mut proved),
                None => unproved.push(repair),
            },
            Trial::OpensAtStart => offers.elsewhere.push(repair),
            Trial::Coupled => {
                if let Repair::AddMotors(_) | Repair::AllowRedundant = repair {
                    offers.coupled.push(repair);
                }
            }
            Trial::Fails => failed.push(repair),
            Trial::Untried => {}
        }
    }
    if all.len() > 1 {
        let found = failed.iter().filter(|repair| {
            let wrong = trials.wrong(repair);
            !wrong.is_empty() && is_better(&wrong, all, index)
        });
        offers.partial = found.cloned().collect();
        if one_is_enough {
            let motor = offers.partial.iter().position(is_motor);
            let mut number = 0..;
            offers.partial.retain(|repair| number.next() == motor || !is_motor(repair));
        }
    }
    // What is left then is a range.
    offers.partial.extend(unproved);
    offers.coupled.retain(|repair| {
        let both = [repair.clone(), Repair::AllowCoupled];
        match trials.of(&both) {
            Trial::Closes => trials.proved(&both).is_some_and(|proved| proved == both),
            trial => trial == Trial::OpensAtStart,
        }
    });
    if one_is_enough && !(offers.single.is_empty() && offers.elsewhere.is_empty()) {
        offers.coupled.clear();
        offers.elsewhere.truncate(usize::from(offers.single.is_empty()));
    }
    let ranking = Ranking::new(trials.model, diagnosis);
    for list in [&mut offers.single, &mut offers.elsewhere, &mut offers.partial] {
        ranking.sort(list);
    }
    // The sizes of wheels are as likely wrong as their places.
    let first = usize::from(!offers.single.is_empty() && is_misplaced(diagnosis));
    let numbers = numbers(trials, diagnosis);
    offers.single.splice(first..first, numbers);
    // The same in another direction.
    let single = &offers.single;
    offers.elsewhere.retain(|repair| !single.iter().any(|known| same_place(known, repair)));
    for list in [&mut offers.elsewhere, &mut offers.partial] {
        list.dedup_by(|next, first| same_place(first, next));
    }
    let others = failed.iter().any(|repair| !is_motor(repair));
    let hard = is_held(diagnosis) || is_apart(diagnosis) || is_one_shaft(diagnosis);
    let bare = offers.is_empty() && hard;
    if bare || all.len() == 1 && others && is_free(diagnosis) && offers.single.iter().all(is_motor)
    {
        pairs(trials, &failed, &ranking, &mut offers);
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

/// Whether motors are added or moved.
fn is_motor(repair: &Repair) -> bool {
    matches!(repair, Repair::AddMotors(_) | Repair::MoveMotor { .. } | Repair::StartAt { .. })
}

/// Whether there are new joints enough that serve the same purpose.
fn has_enough(found: &[Repair], repair: &Repair) -> bool {
    let enough = match repair {
        Repair::Declare(Declaration { purpose: Purpose::Guess, .. }) => 1,
        _ => 2,
    };
    let purpose = |repair: &Repair| match repair {
        Repair::Declare(Declaration { purpose, .. }) => Some(std::mem::discriminant(purpose)),
        _ => None,
    };
    let same = |known: &&Repair| purpose(known) == purpose(repair);
    purpose(repair).is_some() && found.iter().filter(same).count() >= enough
}

/// Whether two changes differ only in the direction of a slot, or in a place that nothing tells.
fn same_place(a: &Repair, b: &Repair) -> bool {
    match (a, b) {
        (Repair::Replace { joint: a, .. }, Repair::Replace { joint: b, .. }) => a == b,
        (Repair::Declare(a), Repair::Declare(b)) => {
            let pairs = [a, b].map(Declaration::only_joint);
            pairs[0].is_some() && pairs[0] == pairs[1]
        }
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

fn is_free(diagnosis: &Diagnosis) -> bool {
    matches!(
        diagnosis,
        Diagnosis::Undetermined { .. } | Diagnosis::NoMotor { .. } | Diagnosis::OnOnePin { .. }
    )
}

fn is_apart(diagnosis: &Diagnosis) -> bool {
    matches!(diagnosis, Diagnosis::Loose { .. } | Diagnosis::Disconnected { .. })
}

fn is_misplaced(diagnosis: &Diagnosis) -> bool {
    matches!(diagnosis, Diagnosis::NoMesh { trouble: MeshTrouble::Distance { .. }, .. })
}

fn is_one_shaft(diagnosis: &Diagnosis) -> bool {
    matches!(diagnosis, Diagnosis::NoMesh { trouble: MeshTrouble::OneShaft, .. })
}

/// Whether a change mends this diagnosis, and nothing new is wrong.
fn is_better(found: &[Diagnosis], all: &[Diagnosis], index: usize) -> bool {
    let mut rest: Vec<_> = all
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != index)
        .map(|(_, diagnosis)| std::mem::discriminant(diagnosis))
        .collect();
    let missing = |diagnoses: &[Diagnosis]| freedom(diagnoses).unwrap_or(0);
    let no_freer = missing(found) <= missing(all);
    no_freer
        && found.iter().all(|diagnosis| {
            let kind = std::mem::discriminant(diagnosis);
            let known = rest.iter().position(|other| *other == kind);
            known.map(|at| rest.swap_remove(at)).is_some()
        })
}

/// Searches for two changes that are enough together: after the first, whatever would mend what is then wrong.
fn pairs(trials: &mut Trials<'_>, tried: &[Repair], ranking: &Ranking<'_>, offers: &mut Offers) {
    offers.search = Search::Pairs;
    let tried = tried.iter().filter(|repair| is_half(repair));
    let mut halves: Vec<(usize, &Repair, Vec<Diagnosis>)> = tried
        .filter_map(|repair| {
            let found = trials.wrong(repair);
            Some((freedom(&found)?, repair, found))
        })
        .collect();
    halves.retain(|(.., found)| !found.is_empty());
    halves.sort_by_key(|(freedom, repair, found)| {
        let suggested = ranking.of(repair).0 == 0;
        (!suggested, *freedom, found.len())
    });
    for (_, first, found) in &halves {
        if trials.exhausted || offers.pairs.len() >= PAIRS {
            break;
        }
        for second in seconds(trials, first, found) {
            attempt(trials, offers, &[(*first).clone(), second]);
        }
    }
    offers.pairs.truncate(PAIRS);
    offers.pairs.sort_by_key(|pair| ranking.of_pair(pair));
}

/// Whether a change may be one of two: a joint that the drawing suggests, or something that goes. There is no time for all of them.
fn is_half(repair: &Repair) -> bool {
    match repair {
        Repair::Declare(Declaration { purpose, .. }) => matches!(
            purpose,
            Purpose::Ground | Purpose::Join { .. } | Purpose::Meet | Purpose::Free
        ),
        other => !is_motor(other),
    }
}

fn attempt(trials: &mut Trials<'_>, offers: &mut Offers, pair: &[Repair; 2]) {
    let same = |a: &Repair, b: &Repair| {
        let motors = matches!((a, b), (Repair::AddMotors(_), Repair::AddMotors(_)));
        a == b || motors || same_place(a, b)
    };
    let is_known = |[a, b]: &[Repair; 2]| {
        let [first, second] = pair;
        (same(a, first) && same(b, second)) || (same(a, second) && same(b, first))
    };
    if !offers.pairs.iter().any(is_known) && trials.of(pair) == Trial::Closes {
        let proved = trials.proved(pair).and_then(|pair| pair.try_into().ok());
        offers.pairs.extend(proved);
    }
}

/// Returns the number of missing motors, if a diagnosis is about freedom.
fn freedom(diagnoses: &[Diagnosis]) -> Option<usize> {
    let missing = |diagnosis: &Diagnosis| match diagnosis {
        Diagnosis::NoMotor { freedom, .. } | Diagnosis::Undetermined { freedom, .. } => {
            Some(*freedom)
        }
        other => is_held(other).then_some(0),
    };
    diagnoses.iter().map(missing).sum()
}

/// Finds changes that might mend the remaining faults after a first change.
fn seconds(trials: &mut Trials<'_>, first: &Repair, found: &[Diagnosis]) -> Vec<Repair> {
    /// Of the joints on which a motor would do, so many are enough.
    const MOTORS: usize = 3;
    let changed = trials.model_with(std::slice::from_ref(first));
    let (Some(changed), Some(rest)) = (changed, found.first()) else {
        return Vec::new();
    };
    let model = trials.model;
    let mut seconds: Vec<Repair> = Vec::new();
    for second in candidates(&changed, found, rest) {
        let fits = is_half(&second) || matches!(second, Repair::AddMotors(_));
        if fits && !has_enough(&seconds, &second) {
            seconds.extend(translate(&second, &changed, model));
        }
    }
    let adds = |repair: &Repair| matches!(repair, Repair::AddMotors(_));
    let (motors, others): (Vec<Repair>, Vec<Repair>) = seconds.into_iter().partition(adds);
    others.into_iter().chain(motors.into_iter().take(MOTORS)).collect()
}

/// The changes of one end of a joint after which nothing is wrong: of those first that a diagnosis names. What was declared last is the
/// likelier slip.
fn attachments(trials: &mut Trials<'_>, diagnoses: &[Diagnosis]) -> Vec<Repair> {
    let model = trials.model;
    let mut joints: Vec<JointId> = model.declared_joints().collect();
    joints.retain(|joint| model.joint(*joint).kind.axes().is_some());
    joints.sort_by_key(|joint| {
        let is_told = diagnoses.iter().any(|one| is_told(one, *joint));
        (!is_told, std::cmp::Reverse(*joint))
    });
    let links = || [LinkId::GROUND].into_iter().chain(model.declared_links());
    let changes = joints.into_iter().flat_map(|joint| {
        let ends = ends(model, joint);
        let changes = ends.into_iter().flat_map(move |from| {
            let others = links().filter(move |to| !ends.contains(to));
            others.map(move |to| Repair::Attach { joint, from, to })
        });
        changes.collect::<Vec<_>>()
    });
    trials.first_that_mend(changes)
}

/// Whether a diagnosis is about a joint.
fn is_told(diagnosis: &Diagnosis, joint: JointId) -> bool {
    match diagnosis {
        Diagnosis::Blocked { joints, .. }
        | Diagnosis::Overdetermined { joints, .. }
        | Diagnosis::OnOnePin { joints, .. } => joints.contains(&joint),
        Diagnosis::Undetermined { free, .. } => free.contains(&joint),
        _ => false,
    }
}

/// The two links that a joint holds, as they are written: instead of a die, that of its pin.
fn ends(model: &Model, joint: JointId) -> [LinkId; 2] {
    let (a, b) = model.ends(joint);
    [a, b].map(|link| match model.link(link).die {
        Some((pin, _)) => model.axis(pin).link,
        None => link,
    })
}

/// Asks for these effects; nothing if the mechanism does not compile with them, as `compiles` tells.
pub(crate) fn add_effects(
    model: &Model,
    source: &Source,
    words: &[String],
    compiles: impl Fn(&Model) -> bool,
) -> Option<Repair> {
    let repair = Repair::AddEffects(words.to_vec());
    let edits = edits(std::slice::from_ref(&repair), model, source.tokens())?;
    let changed = source.model_with(&edits)?;
    compiles(&changed).then_some(repair)
}
