//! Steps that nothing that is shown depends on.

use super::Writer;
use crate::plan::{Source, Step};

impl Writer<'_> {
    /// Leaves a step out; everything after it keeps its number. A source that it would have been the first to read is read all
    /// the same, if a later step needs it: here, so that it is the same as in the whole program bit by bit.
    pub(super) fn leave_out(&mut self, step: &Step, sources: &[bool]) {
        match step {
            Step::Weld(_) | Step::Drive(_) => {}
            Step::Mesh(_) => self.meshes += 1,
            Step::Close(_) => self.loops += 1,
        }
        for (number, _) in step.sources() {
            let is_motor = matches!(self.plan.sources[*number], Source::Motor(_));
            if sources[*number] && !is_motor && self.sources[*number].is_none() {
                let title = "What gears are solved from.".to_owned();
                self.builder.block("source".to_owned(), title);
                self.source(*number);
            }
        }
    }
}
