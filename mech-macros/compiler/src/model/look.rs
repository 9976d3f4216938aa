//! The look of a mechanism.

use super::{Axis, LinkId, Model, Shape};
use crate::bug::bug;
use mech_core::colors::{GROUND, MAIN_COUNT, darker, lighter, main};

/// The look of a mechanism where no shape is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Look {
    /// Every link without shapes has a body that is made from what it carries.
    Machine,
    /// The diagram of a textbook: symbols of joints and lines between them.
    Diagram,
    /// Nothing but the declared shapes.
    Shapes,
}

impl Model {
    /// Returns its look: the declared one, or else a machine, unless every link and the ground have shapes.
    #[must_use]
    pub fn look(&self) -> Look {
        self.look.unwrap_or_else(|| {
            let mut seen = self.links.iter().filter(|link| link.die.is_none());
            if seen.all(|link| !link.shapes.is_empty()) { Look::Shapes } else { Look::Machine }
        })
    }

    /// Whether more is painted than constant shapes: traces, symbols, and what params change.
    pub(crate) fn paints_more(&self) -> bool {
        let mut shapes = self.links.iter().flat_map(|link| &link.shapes);
        let actions = &self.actions;
        let of_look = match self.look() {
            Look::Shapes => false,
            Look::Diagram => true,
            Look::Machine => {
                let stretches = !(actions.springs.is_empty() && actions.dampers.is_empty());
                stretches || self.axes.iter().any(Axis::varies)
            }
        };
        of_look || !self.traces.is_empty() || shapes.any(Shape::varies)
    }
}

/// The colour of a link that names none: round the main colours of the palette, then their lighter and their darker kinds, and so on. Ink,
/// hatching and steel are no colours of links.
#[must_use]
pub(crate) fn color_of(link: LinkId) -> u8 {
    let Some(earlier) = link.index().checked_sub(1) else {
        return GROUND;
    };
    let count = usize::from(MAIN_COUNT);
    let Ok(number) = u8::try_from(earlier % count) else {
        bug!("a palette has no {count} main colors");
    };
    match earlier / count % 3 {
        0 => main(number),
        1 => lighter(main(number)),
        _ => darker(main(number)),
    }
}
