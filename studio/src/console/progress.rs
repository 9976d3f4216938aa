//! The progress of a job, as shown to a user.

use super::Console;
use crate::job::Listener;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

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

fn bar(steps: u32) -> ProgressBar {
    let target = ProgressDrawTarget::stderr();
    let bar = ProgressBar::with_draw_target(Some(steps.into()), target);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
