//! Charts of what is measured.

use super::{Analysed, Measure, StillKind};
#[cfg(not(target_arch = "wasm32"))]
use crate::chart::Chart;
use crate::failure::Failure;

/// Charts of what is measured: quantities with the same unit share one.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Plot {
    pub(crate) measure: Measure,
    pub(crate) kind: StillKind,
    /// The title; without, the name of the mechanism.
    pub(crate) title: Option<String>,
}

impl Plot {
    /// The letters of charts are not in a page.
    #[cfg(target_arch = "wasm32")]
    pub(super) fn run(&self, _: &Analysed) -> Result<Vec<u8>, Failure> {
        Err(Failure::file(
            "a page in a browser draws no charts; export the table, or use `mech plot` on a computer",
        ))
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn run(&self, analysed: &Analysed) -> Result<Vec<u8>, Failure> {
        let table = self.measure.table(analysed)?;
        let title = self.title.as_deref().unwrap_or(&analysed.model.name);
        let chart = Chart::new(title, &table);
        match self.kind {
            StillKind::Svg => chart.svg().map(String::into_bytes),
            StillKind::Png => chart.png(),
        }
    }
}
