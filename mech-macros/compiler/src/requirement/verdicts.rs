//! Verdicts on whether a mechanism moves, each found once.

use crate::certify::{Interval, Verdict, certify};
use crate::program::Program;
use std::cell::RefCell;

/// Verdicts on whether a mechanism moves through values of its motors: each is found once for all requirements and their details.
pub(super) struct Verdicts<'a> {
    program: &'a Program,
    known: RefCell<Vec<(Vec<Interval>, Verdict)>>,
}

impl<'a> Verdicts<'a> {
    pub(super) fn new(program: &'a Program) -> Self {
        Self { program, known: RefCell::default() }
    }

    pub(super) fn on(&self, values: &[Interval]) -> Verdict {
        let mut known = self.known.borrow_mut();
        if let Some((_, verdict)) = known.iter().find(|(on, _)| on == values) {
            return verdict.clone();
        }
        let verdict = certify(self.program, values);
        known.push((values.to_vec(), verdict.clone()));
        verdict
    }
}
