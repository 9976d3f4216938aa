//! Prints what mechanisms report.

use firmware::Line;
use mech_probes::Listener;

/// Prints what mechanisms report, a line for each thing.
pub struct Printer {
    line: Line,
    heard: bool,
}

impl Printer {
    /// One that has printed nothing yet.
    pub const fn new() -> Self {
        Self { line: Line::new(), heard: true }
    }

    /// Whether everything could be printed.
    pub const fn is_heard(&self) -> bool {
        self.heard
    }
}

impl Default for Printer {
    fn default() -> Self {
        Self::new()
    }
}

impl Listener for Printer {
    fn begin(&mut self, what: &str, name: &str, precision: &str) {
        self.line = Line::new();
        self.line.text(what).name(name).name(precision);
    }

    fn word(&mut self, word: u64) {
        self.heard &= self.line.make_room().is_ok();
        self.line.bits(word);
    }

    fn end(&mut self) {
        self.heard &= self.line.print().is_ok();
    }
}
