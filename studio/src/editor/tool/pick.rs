//! A place that was picked.

use crate::editor::drawing::Hit;

/// A place that was picked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pick {
    /// Where, in the scene.
    pub(crate) place: [f64; 2],
    /// What is there.
    pub(crate) hit: Hit,
}
