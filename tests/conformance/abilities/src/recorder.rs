//! Tells a listener what was found.

use super::words::Words;
use mech_probes::Listener;

/// No more words are in one line: lines are written to places of a fixed size.
const MOST: usize = 48;

/// Tells a listener what was found.
pub(super) struct Recorder<'l, L> {
    listener: &'l mut L,
    precision: &'static str,
}

impl<'l, L: Listener> Recorder<'l, L> {
    /// For what is found in this precision.
    pub(super) const fn new(listener: &'l mut L, precision: &'static str) -> Self {
        Self { listener, precision }
    }

    /// Tells what was found by something of this name.
    pub(super) fn record(&mut self, name: &str, found: &impl Words) {
        let mut words = 0;
        self.listener.begin("ability", name, self.precision);
        found.record(&mut |word| {
            if words == MOST {
                words = 0;
                self.listener.end();
                self.listener.begin("ability", name, self.precision);
            }
            words += 1;
            self.listener.word(word);
        });
        self.listener.end();
    }
}
