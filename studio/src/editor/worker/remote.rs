//! A worker with which the window shares no memory, as a page has it.

use super::transfer::{Call, Known, Reply, bytes_of, read};
use super::{Finding, Task, Undone};
use crate::failure::Failure;
use std::collections::VecDeque;

/// The way to a worker that runs a [`Server`](super::Server).
pub trait Port {
    /// Sends a task.
    ///
    /// # Errors
    /// If it cannot be sent: why.
    fn post(&mut self, call: Vec<u8>) -> Result<(), String>;

    /// Ends the worker, whatever it does, and begins another.
    ///
    /// # Errors
    /// If there can be no other: why.
    fn restart(&mut self) -> Result<(), String>;
}

pub(in crate::editor) struct Remote {
    port: Box<dyn Port>,
    known: Known,
    found: VecDeque<Finding>,
}

impl Remote {
    /// One that is reached by this way.
    pub(in crate::editor) fn new(port: Box<dyn Port>) -> Self {
        Self {
            port,
            known: Known::default(),
            found: VecDeque::new(),
        }
    }

    pub(super) fn give(&mut self, task: Task) -> Result<(), Failure> {
        let Some(call) = Call::of(task, &self.known) else {
            return Ok(());
        };
        let posted = self.port.post(bytes_of(&call)?);
        posted.map_err(|why| Failure::internal(format!("the worker cannot be reached: {why}")))
    }

    pub(in crate::editor) fn hear(&mut self, reply: &[u8]) {
        match read::<Reply>(reply) {
            Ok(reply) => self.found.extend(reply.finding(&mut self.known)),
            Err(failure) => self.found.push_back(Finding::Undone(Undone::All, failure)),
        }
    }

    /// Begins anew after the worker has broken: this is why.
    pub(in crate::editor) fn lose(&mut self, why: &str) {
        self.restart();
        let failure = Failure::internal(format!("the analysis broke: {why}"));
        self.found.push_back(Finding::Undone(Undone::All, failure));
    }

    pub(super) fn restart(&mut self) {
        self.known.clear();
        self.found.clear();
        if let Err(why) = self.port.restart() {
            let failure = Failure::internal(format!("there is no other worker: {why}"));
            self.found.push_back(Finding::Undone(Undone::All, failure));
        }
    }

    pub(super) fn next(&mut self) -> Option<Finding> {
        self.found.pop_front()
    }
}
