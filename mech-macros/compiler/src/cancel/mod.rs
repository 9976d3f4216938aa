//! The end of an analysis that nobody waits for any longer.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag by which somebody else ends an analysis.
#[derive(Clone, Debug, Default)]
pub struct Cancellation(Arc<AtomicBool>);

/// The payload of the unwinding of work that ends early. No panic hook sees it, and only [`Cancellation::heed`] catches it.
pub(crate) struct Cancelled;

#[cfg(test)]
mod tests;

thread_local! {
    /// The flags that this thread heeds, the innermost last.
    static HEEDED: RefCell<Vec<Cancellation>> = const { RefCell::new(Vec::new()) };
}

/// Heeds one flag less when it is dropped, also by a panic.
struct Heeding;

impl Drop for Heeding {
    fn drop(&mut self) {
        HEEDED.with_borrow_mut(Vec::pop);
    }
}

impl Cancellation {
    /// Ends the work that heeds it.
    pub fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether somebody has set it.
    #[must_use]
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Does some work, which ends early if the flag is set meanwhile: then there is no result.
    ///
    /// The work has to be on this thread, and to let panics through. Where panics abort, a flag that is set ends the program.
    pub fn heed<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        HEEDED.with_borrow_mut(|heeded| heeded.push(self.clone()));
        let heeding = Heeding;
        // Nothing that the work changes is read after it ended early.
        let done = catch_unwind(AssertUnwindSafe(work));
        drop(heeding);
        match done {
            Ok(result) => Some(result),
            Err(panic) if panic.is::<Cancelled>() => None,
            Err(panic) => resume_unwind(panic),
        }
    }
}

/// Ends the work here if somebody has asked for that. Without a flag it does nothing, as in the macro.
///
/// It stands at the head of each loop that may take long, so that no work goes on for more than moments.
pub fn check() {
    if HEEDED.with_borrow(|heeded| heeded.iter().any(Cancellation::is_set)) {
        resume_unwind(Box::new(Cancelled));
    }
}
