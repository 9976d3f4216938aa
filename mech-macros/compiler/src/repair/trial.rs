//! Changes that are tried out.

use super::motor::variants;
use super::{Repair, edits};
use crate::cancel;
use crate::compile::{check, compile};
use crate::model::{Model, MotorId, StartValue};
use crate::structure::{self, Diagnosis};
use crate::syntax::{Source, Tokens};

/// The outcome of a change that was tried on a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Trial {
    /// It compiles, or would with a `near`.
    Closes,
    /// It would compile if it started elsewhere.
    OpensAtStart,
    /// It moves as its motors say, but its loops wait for each other.
    Coupled,
    /// It does not compile.
    Fails,
    /// The change cannot be made, or there was no time left to try it.
    Untried,
}

/// A mechanism that is to be mended, and how much may still be tried.
///
/// The work is counted and not timed, so that a build says the same on every machine.
pub(super) struct Trials<'m> {
    pub(super) model: &'m Model,
    source: &'m Source,
    left: usize,
    /// Links and joints.
    size: usize,
    known: Vec<(Vec<Repair>, Trial)>,
    /// Whether something was left untried.
    pub(super) exhausted: bool,
}

/// All the work that may be done for the messages about one mechanism. A unit is about a microsecond where nothing is optimised.
const WORK: usize = 250_000;
/// The work of counting whether a link or a joint is held: changing the mechanism, and the rank of its joints.
const COUNTING: usize = 20;
/// The work of finding out why it is held.
const EXPLAINING: usize = 60;
/// The work of assembling a link or a joint.
const COMPILING: usize = 130;
/// The work of moving a link or a joint through its ranges.
const PROVING: usize = 600;
/// Of changes of one kind so many are tried, and so many that mend everything are enough.
const TRIED: usize = 60;
const ENOUGH: usize = 2;
/// Larger mechanisms take so many times longer for each link or joint as they have times this many.
const LARGE: usize = 500;
/// The work of assembling loops that are solved together.
const COUPLED: usize = 50_000;

impl<'m> Trials<'m> {
    pub(super) fn new(model: &'m Model, source: &'m Source) -> Self {
        Self {
            model,
            source,
            left: WORK,
            size: model.joints.len() + model.links.len(),
            known: Vec::new(),
            exhausted: false,
        }
    }

    /// The tokens of the text.
    pub(super) fn tokens(&self) -> &'m Tokens {
        self.source.tokens()
    }

    /// Tries these changes and returns the outcome.
    pub(super) fn of(&mut self, repairs: &[Repair]) -> Trial {
        if let Some((_, trial)) = self.known.iter().find(|(known, _)| known == repairs) {
            return *trial;
        }
        if !self.has_work() {
            return Trial::Untried;
        }
        let changed = self.model_with(repairs);
        let trial = changed.map_or(Trial::Untried, |model| self.run(&model));
        self.known.push((repairs.to_vec(), trial));
        trial
    }

    /// The same changes so that motors which are new, or at other joints, move as far as the text says: with ranges that are proved, where
    /// that takes some. None if they cannot. Nothing else is examined so far: that would take most of the time.
    pub(super) fn proved(&mut self, repairs: &[Repair]) -> Option<Vec<Repair>> {
        let model = self.model;
        let drives = |one: &Repair| matches!(one, Repair::AddMotors(_) | Repair::MoveMotor { .. });
        if !self.is_proved() || !repairs.iter().any(drives) {
            return Some(repairs.to_vec());
        }
        let mut variants = variants(model, repairs).into_iter();
        variants.find(|variant| self.compiles(variant))
    }

    /// The first of these changes after which nothing is wrong.
    pub(super) fn first_that_mend(&mut self, changes: impl Iterator<Item = Repair>) -> Vec<Repair> {
        let mends = |change: &Repair| {
            self.of(std::slice::from_ref(change)) == Trial::Closes && self.holds(change)
        };
        changes.take(TRIED).filter(mends).take(ENOUGH).collect()
    }

    /// Whether the motors move as far as the text says after a change that leaves them where they are.
    fn holds(&mut self, repair: &Repair) -> bool {
        !self.is_proved() || self.compiles(std::slice::from_ref(repair))
    }

    /// Whether the text asks for what takes a proof.
    fn is_proved(&self) -> bool {
        let model = self.model;
        let is_ranged = model.motors.iter().any(|motor| motor.range.is_some());
        is_ranged || model.accuracy.is_some() || model.effects.dynamics
    }

    fn compiles(&mut self, repairs: &[Repair]) -> bool {
        self.has_work() && {
            self.spend(PROVING);
            let changed = self.model_with(repairs);
            changed.is_some_and(|model| outcome(compile(&model).map(drop)) == Trial::Closes)
        }
    }

    /// Returns the diagnoses of the structure after this change; none if there is no time left to find them.
    pub(super) fn wrong(&mut self, repair: &Repair) -> Vec<Diagnosis> {
        if !self.has_work() {
            return Vec::new();
        }
        self.spend(EXPLAINING);
        // A change that cannot be made breaks nothing.
        let changed = self.model_with(std::slice::from_ref(repair));
        changed.and_then(|model| structure::analyse(&model).err()).unwrap_or_default()
    }

    /// The mechanism with these changes; none if they cannot be made to its text.
    pub(super) fn model_with(&mut self, repairs: &[Repair]) -> Option<Model> {
        cancel::check();
        if let [Repair::StartAt { motor, value }] = *repairs
            && self.model.links.iter().any(|link| link.drawn)
        {
            return Some(redrawn(self.model, motor, value));
        }
        let edits = edits(repairs, self.model, self.tokens())?;
        self.source.model_with(&edits)
    }

    /// Leaves some work for a last attempt.
    pub(super) fn refill(&mut self) {
        self.left = self.left.max(WORK / 4);
    }

    fn has_work(&mut self) -> bool {
        cancel::check();
        self.exhausted |= self.left == 0;
        self.left > 0
    }

    /// Spends so much for each link and joint.
    fn spend(&mut self, each: usize) {
        let work = self.size * each;
        self.left = self.left.saturating_sub(work + work * self.size / LARGE);
    }

    fn run(&mut self, model: &Model) -> Trial {
        self.spend(COUNTING);
        // A mechanism that may not be redundant must pass the count, which takes little time.
        if !model.allow.redundant && !structure::is_sound(model) {
            return Trial::Fails;
        }
        self.spend(COMPILING);
        if model.allow.coupled {
            self.left = self.left.saturating_sub(COUPLED);
        }
        outcome(check(model))
    }
}

/// A mechanism as it would be drawn with a motor at another value: the assembly is found from there. No change of the text says so.
fn redrawn(model: &Model, motor: MotorId, value: f64) -> Model {
    let mut model = model.clone();
    for link in &mut model.links {
        link.drawn = false;
    }
    let motor = *model.motor(motor);
    let values = &mut model.start.values;
    values.retain(|value| value.joint != motor.joint);
    values.push(StartValue { joint: motor.joint, value, origin: motor.origin });
    model
}

fn outcome(compiled: Result<(), Vec<Diagnosis>>) -> Trial {
    let diagnoses = match compiled {
        Ok(()) => return Trial::Closes,
        Err(diagnoses) => diagnoses,
    };
    match diagnoses[..] {
        [Diagnosis::SeveralAssemblies { .. }] => Trial::Closes,
        [Diagnosis::CannotClose { .. } | Diagnosis::DeadStart { .. }] => Trial::OpensAtStart,
        [Diagnosis::NotSequential { .. }] => Trial::Coupled,
        _ => Trial::Fails,
    }
}
