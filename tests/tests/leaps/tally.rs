//! Counts what was found, kind by kind, with a small example of each.

use super::comparing::{Finding, Kind};
use std::collections::BTreeMap;

/// More examples than these of a kind are not reported.
const MOST_EXAMPLES: usize = 3;

/// What was found in many mechanisms.
#[derive(Default)]
pub(crate) struct Tally {
    kinds: BTreeMap<Kind, (usize, Vec<String>)>,
    pub(crate) mechanisms: usize,
    pub(crate) refused: Vec<String>,
    pub(crate) moves: usize,
}

impl Tally {
    /// Whether an example of this kind is still wanted.
    pub(crate) fn wants(&self, kind: Kind) -> bool {
        self.kinds
            .get(&kind)
            .is_none_or(|(_, examples)| examples.len() < MOST_EXAMPLES)
    }

    /// Counts it.
    pub(crate) fn count(&mut self, finding: &Finding) {
        self.kinds.entry(finding.kind).or_default().0 += 1;
    }

    /// An example of a kind that was counted.
    pub(crate) fn example(&mut self, kind: Kind, text: String) {
        self.kinds.entry(kind).or_default().1.push(text);
    }

    /// All of it as text.
    pub(crate) fn table(&self) -> String {
        let mut text = format!(
            "{} mechanisms ({} more did not compile), {} moves\n",
            self.mechanisms,
            self.refused.len(),
            self.moves
        );
        for (kind, (count, _)) in &self.kinds {
            text += &format!("{count:8} {kind:?}\n");
        }
        for (kind, (_, examples)) in &self.kinds {
            for example in examples {
                text += &format!("--- {kind:?}: {example}\n");
            }
        }
        for why in self.refused.iter().take(MOST_EXAMPLES) {
            text += &format!("--- refused: {why}\n");
        }
        text
    }

    /// Nothing was found but what is not counted.
    #[track_caller]
    pub(crate) fn assert_clean(&self) {
        let wrong = self.kinds.keys().any(|kind| *kind != Kind::Undecided);
        assert!(!wrong, "{}", self.table());
        println!("{}", self.table());
    }
}
