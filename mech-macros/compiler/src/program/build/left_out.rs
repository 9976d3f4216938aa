//! Steps that nothing that is shown depends on.

use super::Writer;
use crate::plan::{Source, Step};
use crate::program::choice::Choice;

impl Writer<'_> {
    /// Leaves a step out; everything after it keeps its number. A source that it would have been the first to read is read all
    /// the same, if a later step needs it: here, so that it is the same as in the whole program bit by bit.
    pub(super) fn leave_out(&mut self, step: &Step, sources: &[bool]) {
        match step {
            Step::Weld(_) | Step::Drive(_) | Step::Cam(_) => {}
            Step::Mesh(_) => self.meshes += 1,
            Step::Close(_) => self.loops += 1,
        }
        for (number, _) in step.sources() {
            let is_motor = matches!(self.plan.sources[*number], Source::Motor(_));
            if sources[*number] && !is_motor && self.sources[*number].is_none() {
                let title = "What gears are solved from.".to_owned();
                self.builder.block("source".to_owned(), title);
                match (step, self.plan.sources[*number]) {
                    // It may be that nothing needs its whole turns.
                    (Step::Cam(_), Source::Angle { from, to }) => {
                        self.principal(*number, [from, to]);
                    }
                    _ => {
                        self.source(*number);
                    }
                }
            }
        }
    }

    /// What was decided for the present loop.
    pub(super) fn choice(&self) -> Choice {
        let number = self.loops - 1;
        let otherwise = || Choice {
            predictor: self.model.predictor,
            ..Choice::by(self.model.method.unwrap_or_default())
        };
        let choice = self.choices.get(number).cloned().unwrap_or_else(otherwise);
        if !self.idle.contains(&number) {
            return choice;
        }
        // It only says how its links hang together.
        Choice {
            watching: None,
            predictor: 0,
            ..choice
        }
    }
}
