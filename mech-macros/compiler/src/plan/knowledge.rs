//! The dependences of a known coordinate.

/// On which loops a known coordinate depends directly, and how many loops lead to it one after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Knowledge {
    pub(super) needs: Vec<usize>,
    pub(super) level: usize,
}

impl Knowledge {
    /// The knowledge of something that depends on all of these.
    pub(super) fn of<'k>(parts: impl Iterator<Item = &'k Self>) -> Self {
        let mut all = Self::default();
        for part in parts {
            all.needs.extend(&part.needs);
            all.level = all.level.max(part.level);
        }
        all.needs.sort_unstable();
        all.needs.dedup();
        all
    }
}
