//! What shapes are painted on.

use super::{Frame, circle, polygon};
use crate::{Outline, Pose, Real, Scalar};

/// Something that shapes can be painted on.
pub trait Canvas<T: Scalar> {
    /// Fills an outline given in the frame of a link that is at `pose`, with entry `color` of the palette.
    fn fill(&mut self, outline: Outline<T>, pose: Pose<T>, color: u8);

    /// Fills a polygon given in the scene, by the even-odd rule, with entry `color` of the palette.
    fn fill_polygon(&mut self, corners: &[[T; 2]], color: u8);

    /// How many pixels a scene unit is: whatever has a size in pixels asks for it. Infinite for a canvas that only wants to
    /// know where things are: then they have no size.
    fn scale(&self) -> T;
}

impl<T: Scalar, const W: usize, const H: usize> Canvas<T> for Frame<W, H> {
    fn fill(&mut self, outline: Outline<T>, pose: Pose<T>, color: u8) {
        let projection = self.view().projection(W, H);
        match outline {
            Outline::Circle { center, radius } => {
                let center = projection.point(pose.apply(center));
                circle::fill(self.rows(), center, projection.length(radius), color);
            }
            Outline::Polygon(corners) => {
                let corners = corners
                    .iter()
                    .map(|&corner| projection.point(pose.apply(corner)));
                polygon::fill(self.rows(), &corners, color);
            }
        }
    }

    fn fill_polygon(&mut self, corners: &[[T; 2]], color: u8) {
        let projection = self.view().projection(W, H);
        let corners = corners.iter().map(|&corner| projection.point(corner));
        polygon::fill(self.rows(), &corners, color);
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view().scale())
    }
}
