//! Tells whether what a player shows is still what it was.

use std::sync::atomic::{AtomicU64, Ordering};

/// A number that is given once: two players that show different things never have the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Revision(u64);

impl Revision {
    /// One that was never given before.
    pub(super) fn next() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}
