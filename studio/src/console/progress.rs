//! How far long work is.

use super::Console;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

impl Console {
    /// Shows how far long work of so many steps is, to somebody who watches.
    #[must_use]
    pub fn progress(steps: u64) -> ProgressBar {
        let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::stderr());
        match ProgressStyle::with_template("{bar:40} {pos}/{len} {eta}") {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }
}
