//! A place that was picked.

use crate::editor::Item;
use crate::editor::drawing::{Drawing, Hit};

/// A place that was picked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pick {
    /// Where, in the scene.
    pub(crate) place: [f64; 2],
    /// What is there.
    pub(crate) hit: Hit,
}

/// A place that was picked, with what is there by its name: it outlasts a change of the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NamedPick {
    place: [f64; 2],
    item: Option<Item>,
}

impl NamedPick {
    /// What was picked in a drawing.
    pub(crate) fn of(pick: &Pick, drawing: Option<&Drawing>) -> Self {
        Self {
            place: pick.place,
            item: drawing.and_then(|drawing| drawing.item_of(&pick.hit)),
        }
    }

    /// What that is in another drawing. Where nothing was, or what was there is gone, it is what is within reach now.
    pub(crate) fn within(&self, drawing: Option<&Drawing>, reach: f64) -> Pick {
        let hit = drawing.map_or(Hit::Paper, |drawing| {
            let named = self.item.as_ref().and_then(|item| drawing.hit_of(item));
            named.unwrap_or_else(|| drawing.hit(self.place, reach))
        });
        Pick {
            place: self.place,
            hit,
        }
    }
}
