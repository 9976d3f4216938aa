//! The answers for parts of a requirement: for each side of its loops, or for each detail that it is about.

use crate::structure::{RequirementTrouble, Witness};

/// Answers for parts, all of which have to keep a requirement.
#[derive(Default)]
pub(super) struct Answers {
    effort: usize,
    worst: Option<Witness>,
    open: Option<RequirementTrouble>,
}

impl Answers {
    /// Takes the answer for a part: the intervals that were computed, or what is wrong there.
    pub(super) fn add(&mut self, answer: Result<usize, RequirementTrouble>) {
        match answer {
            Ok(effort) => self.effort += effort,
            Err(RequirementTrouble::Fails(witness)) => {
                self.worst = Some(match self.worst.take() {
                    Some(worst) => worse(worst, witness),
                    None => witness,
                });
            }
            Err(trouble) => {
                self.open.get_or_insert(trouble);
            }
        }
    }

    /// The answer for all parts: a place that breaks it is enough. Where parts are left open, no other limit is proved.
    pub(super) fn of_all(self) -> Result<usize, RequirementTrouble> {
        match (self.worst, self.open) {
            (Some(worst), open) => {
                let proved = worst.proved.filter(|_| open.is_none());
                Err(RequirementTrouble::Fails(Witness { proved, ..worst }))
            }
            (None, Some(trouble)) => Err(trouble),
            (None, None) => Ok(self.effort),
        }
    }
}

/// The worse of two places, with a limit that both parts keep. Where one is too great and the other too small, none is known.
fn worse(first: Witness, second: Witness) -> Witness {
    let is_upper = first.is_upper;
    let further = |a: f64, b: f64| if is_upper { a.max(b) } else { a.min(b) };
    let proved = first.proved.zip(second.proved);
    let proved = proved.filter(|_| second.is_upper == is_upper);
    let proved = proved.map(|(a, b)| further(a, b));
    let is_second =
        second.is_upper == is_upper && further(first.value, second.value) != first.value;
    let worst = if is_second { second } else { first };
    Witness { proved, ..worst }
}
