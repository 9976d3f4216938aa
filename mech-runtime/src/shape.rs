//! What is seen of a link.

use crate::Scalar;

/// A coloured spot fixed to a link, in the link's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape<T: 'static> {
    /// The link it is fixed to: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// Its outline.
    pub outline: Outline<T>,
    /// Its entry in the palette.
    pub color: u8,
}

/// The outline of a shape, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline<T: 'static> {
    /// A filled circle.
    Circle {
        /// Its centre.
        center: [T; 2],
        /// Its radius.
        radius: T,
    },
    /// A filled polygon, by the even-odd rule.
    Polygon(&'static [[T; 2]]),
}

impl<T: Scalar> Shape<T> {
    /// The smallest upright box around the shape when its link is at `pose`: lower left and upper right corner.
    #[must_use]
    pub fn bounds(&self, pose: crate::Pose<T>) -> ([T; 2], [T; 2]) {
        match self.outline {
            Outline::Circle { center, radius } => {
                let [x, y] = pose.apply(center);
                ([x - radius, y - radius], [x + radius, y + radius])
            }
            Outline::Polygon(corners) => {
                let mut low = [pose.x, pose.y];
                let mut high = low;
                for (i, &corner) in corners.iter().enumerate() {
                    let [x, y] = pose.apply(corner);
                    low = if i == 0 {
                        [x, y]
                    } else {
                        [low[0].min(x), low[1].min(y)]
                    };
                    high = if i == 0 {
                        [x, y]
                    } else {
                        [
                            nalgebra::RealField::max(high[0], x),
                            nalgebra::RealField::max(high[1], y),
                        ]
                    };
                }
                (low, high)
            }
        }
    }
}
