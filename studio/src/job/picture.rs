//! The settings of pictures that drawings and films have in common.

use super::Analysed;
use crate::construction::{Board, Construction, Filmed};
use crate::failure::Failure;
use crate::motion::{Drive, Setting};
use crate::painting::Painting;
use crate::quantity::Load;
use mech_compiler::model::Look;
use mech_runtime::Palette;
use mech_runtime::files::Sheet;

#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Picture {
    pub(crate) size: Size,
    /// The look of the mechanism, in place of the declared one.
    pub(crate) look: Option<Look>,
    /// Whether the symbols of joints, motors and axes are painted over it.
    pub(crate) overlay: bool,
    /// Whether the names of joints and links are written over it.
    pub(crate) names: bool,
    /// What is constructed over it.
    pub(crate) constructions: Vec<Construction>,
    /// What loads the mechanism, where its forces are constructed.
    pub(crate) loads: Vec<Load>,
    /// Whether the ground is dark.
    pub(crate) night: bool,
    pub(crate) at: Vec<Setting>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Size {
    pub(crate) width: usize,
    /// Without, the height that fits.
    pub(crate) height: Option<usize>,
}

impl Default for Size {
    fn default() -> Self {
        Self { width: 800, height: None }
    }
}

/// A mechanism that is ready to be painted.
pub(super) struct Sitter {
    pub(super) analysed: Analysed,
    pub(super) painting: Painting,
    pub(super) board: Board,
    pub(super) sheet: Sheet,
    pub(super) size: [usize; 2],
    pub(super) palette: Palette,
}

impl Picture {
    /// The mechanism, with its look, what is constructed in these parts of a motion, the first, and a sheet that has room for all. The
    /// second is the whole motion.
    pub(super) fn sitter(
        &self,
        mut analysed: Analysed,
        drives: Option<[&Drive; 2]>,
        parts: &[f64],
    ) -> Result<Sitter, Failure> {
        let Analysed { model, compiled } = &mut analysed;
        model.look = self.look.or(model.look);
        let mut painting = Painting::new(model, compiled, self.overlay);
        if self.look == Some(Look::Diagram) {
            painting = painting.with_room_for_bodies(model, compiled);
        }
        if self.names {
            painting = painting.with_names(model, compiled);
        }
        let filmed =
            drives.map(|[drive, whole]| Filmed { model, drive, whole, parts, loads: &self.loads });
        let board = match &filmed {
            Some(filmed) => Board::new(&self.constructions, filmed, painting.extent())?,
            None => Board::empty(painting.extent()),
        };
        painting = painting.with_extent(board.extent());
        let Size { width, height } = self.size;
        let size = [width, height.unwrap_or_else(|| painting.height(width))];
        let palette = if self.night { Palette::NIGHT } else { Palette::TEXTBOOK };
        let sheet = Sheet::new(size[0], size[1])
            .look_at(painting.view(size))
            .palette(palette.clone())
            .title(&model.name);
        Ok(Sitter { analysed, painting, board, sheet, size, palette })
    }
}
