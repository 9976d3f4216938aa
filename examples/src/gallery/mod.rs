//! The exhibits.

use crate::Exhibit;

/// All of them, in the order in which they hang.
#[must_use]
pub fn exhibits() -> Vec<Box<dyn Exhibit>> {
    vec![]
}
