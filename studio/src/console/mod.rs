//! Where a command writes what it says.

use crate::check::render;
use crate::document::{Message, Source};
use crate::failure::Failure;
#[cfg(not(target_arch = "wasm32"))]
use crate::job::Listener;
use crate::text::masked;
#[cfg(not(target_arch = "wasm32"))]
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{self, ErrorKind, IsTerminal, Write};

/// Where a command writes what it says.
pub struct Console {
    answers: Box<dyn Write>,
    complaints: Box<dyn Write>,
    /// Whether complaints are read by somebody who sees colours.
    has_colors: bool,
    /// Whether a terminal shows the answers.
    is_shown: bool,
    /// The progress of the present job.
    #[cfg(not(target_arch = "wasm32"))]
    progress: Option<ProgressBar>,
}

impl Console {
    /// The standard output, and the standard error for complaints.
    #[must_use]
    pub fn standard() -> Self {
        let is_wanted = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Self {
            answers: Box::new(io::stdout()),
            complaints: Box::new(io::stderr()),
            has_colors: is_wanted && io::stderr().is_terminal(),
            is_shown: io::stdout().is_terminal(),
            #[cfg(not(target_arch = "wasm32"))]
            progress: None,
        }
    }

    /// A console that writes answers and complaints to these.
    #[must_use]
    pub fn to(answers: impl Write + 'static, complaints: impl Write + 'static) -> Self {
        Self {
            answers: Box::new(answers),
            complaints: Box::new(complaints),
            has_colors: false,
            is_shown: false,
            #[cfg(not(target_arch = "wasm32"))]
            progress: None,
        }
    }

    /// Writes an answer to the user. What would command a terminal is masked.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn answer(&mut self, text: impl AsRef<str>) -> Result<(), Failure> {
        self.write(masked(text.as_ref()).as_bytes())
    }

    /// Writes what was asked for, as a file would have it: byte for byte, unless a terminal shows it.
    pub(crate) fn deliver(&mut self, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
        if self.is_shown {
            return self.answer(String::from_utf8_lossy(bytes.as_ref()));
        }
        self.write(bytes.as_ref())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let written = self.answers.write_all(bytes);
        written.and_then(|()| self.answers.flush()).map_err(|error| {
            if error.kind() == ErrorKind::BrokenPipe {
                Failure::unread()
            } else {
                Failure::file(format!("cannot write the answer: {error}"))
            }
        })
    }

    /// Writes a complaint. What would command a terminal is masked. Where it cannot be written, only the exit code is left to say it.
    pub(crate) fn complain(&mut self, text: &str) {
        self.complain_in_colors(&masked(text));
    }

    /// Writes messages on a text, in colours if these are seen.
    pub(crate) fn complain_of(&mut self, source: &Source, messages: &[Message]) {
        self.complain_in_colors(&render(source, messages, self.has_colors));
    }

    /// Writes a complaint that has colours of ours, and in which everything else is masked.
    fn complain_in_colors(&mut self, text: &str) {
        let _ = self.complaints.write_all(text.as_bytes());
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Listener for Console {
    fn note(&mut self, text: &str) {
        self.complain(&format!("note: {text}\n"));
    }

    fn progress(&mut self, done: u32, of: u32) {
        let bar = self.progress.get_or_insert_with(|| bar(of));
        bar.set_position(done.into());
        if done == of {
            bar.finish_and_clear();
            self.progress = None;
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn bar(steps: u32) -> ProgressBar {
    let target = ProgressDrawTarget::stderr();
    let bar = ProgressBar::with_draw_target(Some(steps.into()), target);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
