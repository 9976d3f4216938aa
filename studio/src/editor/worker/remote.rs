//! A worker with which the window shares no memory, as a page has it: both ends.

use super::agenda::Agenda;
use super::transfer::{Call, Known, Reply, bytes_of, read};
use super::{Finding, Task, Undone, Work};
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
        Self { port, known: Known::default(), found: VecDeque::new() }
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

/// Does the tasks of a window with which it shares no memory, piece by piece.
#[derive(Default)]
pub struct Server {
    agenda: Agenda,
    known: Known,
    /// The number of snapshots that were sent.
    count: u64,
    present: Option<Work>,
}

impl Server {
    /// Takes a task, as [`Port::post`](super::Port::post) was given it. Gives what the window is to be told, if it cannot be read.
    pub fn take(&mut self, call: &[u8]) -> Option<Vec<u8>> {
        match read::<Call>(call) {
            Ok(call) => self.agenda.add(call.task(&self.known)),
            Err(failure) => return self.reply(Finding::Undone(Undone::All, failure)),
        }
        None
    }

    /// Takes up the next piece. Gives what the window is to be told before it is done; none if there is nothing to do.
    pub fn begin(&mut self) -> Option<Vec<u8>> {
        let work = self.agenda.begin()?;
        self.present = Some(work.clone());
        self.reply(Finding::Begun(work))
    }

    /// Does the piece that was taken up. Gives what the window is to be told.
    pub fn go_on(&mut self) -> Vec<Vec<u8>> {
        let found = self.agenda.go_on().and_then(|found| self.reply(found));
        let ended = self.present.take();
        let ended = ended.and_then(|work| self.reply(Finding::Ended(work)));
        found.into_iter().chain(ended).collect()
    }

    /// Whether there is nothing to do.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.agenda.is_done()
    }

    fn reply(&mut self, finding: Finding) -> Option<Vec<u8>> {
        let reply = Reply::of(finding, &mut self.known, &mut self.count)?;
        bytes_of(&reply).or_else(|failure| undone_bytes(&failure)).ok()
    }
}

/// The bytes of a reply that nothing was done, as it cannot be sent.
fn undone_bytes(failure: &Failure) -> Result<Vec<u8>, Failure> {
    bytes_of(&Reply::Plain(Finding::Undone(Undone::All, failure.clone())))
}
