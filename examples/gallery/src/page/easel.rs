//! The easel, on which scenes become pictures.

use super::strips::Strips;
use crate::{Film, Picture, Scene};
use mech_runtime::files::Sheet;
use mech_runtime::{Palette, View};

/// The longer side of a picture, and the least of the shorter one.
const LONG: u16 = 640;
const SHORT: u16 = 240;
/// The margin of a picture.
const MARGIN: u16 = 24;
/// The height in pixels of the strips in which a picture is painted.
const STRIP: usize = 64;

/// A painter of the scenes of one film, all in the same view.
#[derive(Clone)]
pub struct Easel {
    strips: Strips<{ LONG as usize }, STRIP>,
    /// The view of the whole picture.
    view: View,
    width: u16,
    height: u16,
}

impl Easel {
    /// An easel whose size and view show everything in the film, as large as possible. `None` if nothing is visible.
    #[must_use]
    pub fn for_film(film: &Film) -> Option<Self> {
        let [low, high] = film.bounds()?;
        let extent = [high[0] - low[0], high[1] - low[1]];
        let longer = extent[0].max(extent[1]);
        let [width, height] = extent.map(|extent| {
            // Of a point, NaN: a number for which `max` has no ear.
            let inner = f64::from(LONG - 2 * MARGIN) * (extent / longer);
            let outer = (inner.ceil() + f64::from(2 * MARGIN)).max(SHORT.into());
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "in SHORT..=LONG"
            )]
            let even = outer as u16 & !1;
            even
        });
        let view = View::fit(low, high, width.into(), height.into(), MARGIN.into());
        Some(Self { strips: Strips::default(), view, width, height })
    }

    /// The number of pixels per scene unit.
    #[must_use]
    pub const fn scale(&self) -> f64 {
        self.view.scale()
    }

    /// A sheet with the size, view and colours of its pictures.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        Sheet::new(self.width.into(), self.height.into())
            .look_at(self.view)
            .palette(self.strips.palette().clone())
    }

    /// Changes the colours.
    pub fn set_palette(&mut self, palette: Palette) {
        self.strips.set_palette(palette);
    }

    /// Paints a scene.
    #[must_use]
    pub fn paint(&mut self, scene: &Scene) -> Picture {
        let size = [self.width, self.height];
        self.strips.paint(scene, self.view, size)
    }
}
