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
    /// The work of compiling it, once it is analysed.
    heavy: usize,
    known: Vec<(Vec<Repair>, Trial)>,
    /// Whether something was left untried.
    pub(super) exhausted: bool,
}

/// All the work that may be done for the messages about one mechanism. A unit is what it takes to analyse a link or a joint:
/// about half a microsecond.
const WORK: usize = 1_000_000;
/// Every trial is counted at least so much: more than some hundred are not for a mechanism of a few links.
const LEAST: usize = 1_000;
/// The work of compiling a link or a joint.
const COMPILING: usize = 20;
/// The work of assembling loops that are solved together.
const COUPLED: usize = 200_000;

impl<'m> Trials<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let size = model.joints.len() + model.links.len();
        Self {
            model,
            left: WORK,
            light: size.max(LEAST),
            heavy: size * COMPILING,
            known: Vec::new(),
            exhausted: false,
        }
    }

    /// How it goes with these changes.
    pub(super) fn of(&mut self, repairs: &[Repair]) -> Trial {
        if let Some((_, trial)) = self.known.iter().find(|(known, _)| known == repairs) {
            return trial.clone();
        }
        if self.left == 0 {
            self.exhausted = true;
            return Trial::Untried;
        }
        let trial = apply_all(repairs, self.model).map_or(Trial::Untried, |model| self.run(&model));
        self.known.push((repairs.to_vec(), trial.clone()));
        trial
    }

    fn spend(&mut self, work: usize) {
        self.left = self.left.saturating_sub(work);
    }

    fn run(&mut self, model: &Model) -> Trial {
        self.spend(self.light);
        // What is not allowed to be redundant must pass the analysis: that is soon known.
        if !model.allow.redundant
            && let Err(diagnoses) = structure::analyse(model)
        {
            return Trial::Fails(diagnoses);
        }
        let coupled = if model.allow.coupled { COUPLED } else { 0 };
        self.spend(self.heavy + coupled);
        outcome(crate::check(model))
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
