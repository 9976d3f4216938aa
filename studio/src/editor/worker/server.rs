//! The other side of a window that has its analysis elsewhere.

use super::agenda::Agenda;
use super::transfer::{Call, Known, Reply, bytes_of, read};
use super::{Finding, Undone, Work};
use crate::failure::Failure;

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
        bytes_of(&reply)
            .or_else(|failure| undone_bytes(&failure))
            .ok()
    }
}

/// The bytes of a reply that nothing was done, as it cannot be sent.
fn undone_bytes(failure: &Failure) -> Result<Vec<u8>, Failure> {
    bytes_of(&Reply::Plain(Finding::Undone(Undone::All, failure.clone())))
}
