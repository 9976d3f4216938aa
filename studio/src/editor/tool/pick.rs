//! Places that are picked with a tool.

use super::Tool;
use crate::editor::Item;
use crate::editor::drawing::{Drawing, Hit};

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pick {
    /// Where, in the scene.
    pub(crate) place: [f64; 2],
    pub(crate) hit: Hit,
}

/// The tool that is chosen, with what was picked for it.
#[derive(Default)]
pub(crate) struct Picking {
    pub(crate) tool: Tool,
    pub(crate) picks: Vec<Pick>,
}

impl Picking {
    /// Picks a place. Gives all places when the last is picked.
    pub(crate) fn pick(&mut self, pick: Pick) -> Option<Vec<Pick>> {
        self.picks.push(pick);
        let is_last = self.wanted().is_none();
        is_last.then(|| std::mem::take(&mut self.picks))
    }

    /// Returns the description of the next place to pick.
    pub(crate) fn wanted(&self) -> Option<&'static str> {
        self.tool.picks().get(self.picks.len()).copied()
    }
}

/// A place that was picked, with what is there by its name: it outlasts a change of the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NamedPick {
    place: [f64; 2],
    item: Option<Item>,
}

impl NamedPick {
    pub(crate) fn all(picks: &[Pick], drawing: Option<&Drawing>) -> Vec<Self> {
        let named = picks.iter().map(|pick| Self {
            place: pick.place,
            item: drawing.and_then(|drawing| drawing.item_of(&pick.hit)),
        });
        named.collect()
    }

    /// Finds the same picks in another drawing.
    pub(crate) fn picks(all: &[Self], drawing: Option<&Drawing>, reach: f64) -> Vec<Pick> {
        let picks = all.iter().map(|pick| pick.within(drawing, reach));
        picks.collect()
    }

    /// Finds the same pick in another drawing. Where nothing was, or the item is gone, it hits what is within reach now.
    fn within(&self, drawing: Option<&Drawing>, reach: f64) -> Pick {
        let hit = drawing.map_or(Hit::Paper, |drawing| {
            let named = self.item.as_ref().and_then(|item| drawing.hit_of(item));
            named.unwrap_or_else(|| drawing.hit(self.place, reach))
        });
        Pick { place: self.place, hit }
    }
}
