//! Tells a listener what was found.

use super::told::Told;
use crate::Listener;

/// No more words are told in one line: lines are written to places of a fixed size.
const MOST: usize = 48;

/// Tells a listener what was found.
pub(super) struct Teller<'l, L> {
    listener: &'l mut L,
    precision: &'static str,
}

impl<'l, L: Listener> Teller<'l, L> {
    /// For what is found in this precision.
    pub(super) const fn new(listener: &'l mut L, precision: &'static str) -> Self {
        Self {
            listener,
            precision,
        }
    }

    /// Tells what was found by something of this name.
    pub(super) fn tell(&mut self, name: &str, found: &impl Told) {
        let mut words = 0;
        self.listener.begin("ability", name, self.precision);
        found.tell(&mut |word| {
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
