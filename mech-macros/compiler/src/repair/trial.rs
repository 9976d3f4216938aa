//! Changes that are tried out.

use super::{Repair, apply_all};
use crate::model::Model;
use crate::structure::{self, Diagnosis};

/// What becomes of a mechanism that was changed to see whether that would mend it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Trial {
    /// It compiles, or would with a `near`.
    Closes,
    /// It would compile if it started elsewhere.
    OpensAtStart,
    /// It moves as its motors say, but its loops wait for each other.
    Coupled,
    /// It does not compile.
    Fails(Vec<Diagnosis>),
    /// The change cannot be made, or there was no time left to try it.
    Untried,
}

/// A mechanism that is to be mended, and how much may still be tried.
///
/// The work is counted and not timed, so that a build says the same on every machine.
pub(super) struct Trials<'m> {
    pub(super) model: &'m Model,
    left: usize,
    /// The work of analysing a mechanism of this size.
    light: usize,
    /// The work of compiling one.
    heavy: usize,
    known: Vec<(Vec<Repair>, Trial)>,
    /// Whether something was left untried.
    pub(super) exhausted: bool,
}

/// All the work that may be done for the messages about one mechanism.
const WORK: usize = 60_000;
/// No more changes than this are tried for one mechanism, however small it is.
const MOST: usize = 300;

impl<'m> Trials<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let size = model.joints.len() + model.links.len();
        let light = (size / 2).max(WORK / MOST);
        Self {
            model,
            left: WORK,
            light,
            heavy: light + 4 * size,
            known: Vec::new(),
            exhausted: false,
        }
    }

    /// How it goes with these changes.
    pub(super) fn of(&mut self, repairs: &[Repair]) -> Trial {
        if let Some((_, trial)) = self.known.iter().find(|(known, _)| known == repairs) {
            return trial.clone();
        }
        if self.left < self.heavy {
            self.exhausted = true;
            return Trial::Untried;
        }
        let trial = apply_all(repairs, self.model).map_or(Trial::Untried, |model| self.run(&model));
        self.known.push((repairs.to_vec(), trial.clone()));
        trial
    }

    fn run(&mut self, model: &Model) -> Trial {
        self.left -= self.light;
        // What is not allowed to be redundant must pass the analysis: that is soon known.
        if !model.allow.redundant
            && let Err(diagnoses) = structure::analyse(model)
        {
            return Trial::Fails(diagnoses);
        }
        // Loops that are solved together take long to be assembled.
        let times = if model.allow.coupled { 8 } else { 1 };
        self.left = self.left.saturating_sub(times * (self.heavy - self.light));
        outcome(crate::compile(model).map(|_| ()))
    }
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
        _ => Trial::Fails(diagnoses),
    }
}
