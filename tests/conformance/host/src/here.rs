//! What mechanisms report on this machine.

use mech_conformance::{Subject, Things};
use mech_probes::{Listener, Probe, Probed, ask_all, pictures, poses};

#[derive(Default)]
struct Ear {
    subject: Option<Subject>,
    words: Vec<u64>,
    things: Things,
}

impl Listener for Ear {
    fn begin(&mut self, what: &str, name: &str, precision: &str) {
        let [what, name, precision] = [what, name, precision].map(str::to_owned);
        self.subject = Some(Subject { what, name, precision });
    }

    fn word(&mut self, word: u64) {
        self.words.push(word);
    }

    fn end(&mut self) {
        let words = std::mem::take(&mut self.words);
        if let Some(subject) = self.subject.take() {
            self.things.entry(subject).or_default().push(words);
        }
    }
}

impl Probe for Ear {
    fn ask<M: Probed>(&mut self) {
        poses::<M>(self);
        pictures::<M>(self);
    }
}

/// Where links are, and what pictures look like.
pub(crate) fn poses_and_pictures() -> Things {
    let mut ear = Ear::default();
    ask_all(&mut ear);
    ear.things
}

/// What comes of everything that mechanisms and pictures can do.
pub(crate) fn abilities() -> Things {
    let mut ear = Ear::default();
    mech_abilities::abilities(&mut ear);
    ear.things
}
