//! Where links, axes and joints are at a position, by numbers.

use crate::bug::bug;
use crate::model::{AxisId, Joint, JointId, JointKind, LinkId, Model};
use nalgebra::{Complex, Isometry2, Point2, Translation2, UnitComplex, Vector2};

/// The frames of all links at a position.
pub(crate) struct LinkFrames<'m> {
    model: &'m Model,
    frames: Vec<Isometry2<f64>>,
}

impl<'m> LinkFrames<'m> {
    /// The frames of links with these poses: cosine, sine, x and y of every link, the ground first.
    pub(crate) fn new(model: &'m Model, poses: &[[f64; 4]]) -> Self {
        let frames = poses.iter().copied().map(frame).collect();
        Self { model, frames }
    }

    /// The frames if the declared links have these poses. A die is where its pin is, and points where its slot does.
    pub(crate) fn with_dies(model: &'m Model, declared: &[[f64; 4]]) -> Self {
        let mut all = Self::new(model, declared);
        all.frames.insert(0, Isometry2::identity());
        for (pin, guide) in model.links.iter().filter_map(|link| link.die) {
            let (place, direction) = (all.place(pin), all.direction(guide));
            all.frames
                .push(frame([direction.x, direction.y, place.x, place.y]));
        }
        all
    }

    fn frame(&self, link: LinkId) -> Isometry2<f64> {
        let Some(frame) = self.frames.get(link.index()) else {
            bug!("link {} has no pose", link.index());
        };
        *frame
    }

    fn place(&self, axis: AxisId) -> Point2<f64> {
        let axis = self.model.axis(axis);
        self.frame(axis.link) * Point2::from(axis.at)
    }

    fn direction(&self, axis: AxisId) -> Vector2<f64> {
        let axis = self.model.axis(axis);
        self.frame(axis.link) * Vector2::from(axis.direction)
    }

    /// The angle from one link to another, in radians, up to whole turns.
    pub(crate) fn turn(&self, from: LinkId, to: LinkId) -> f64 {
        let [from, to] = [from, to].map(|link| self.frame(link).rotation);
        from.angle_to(&to)
    }

    /// The coordinate of a revolute or prismatic joint, an angle up to whole turns.
    pub(crate) fn coordinate(&self, joint: JointId) -> Option<f64> {
        match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => {
                let [a, b] = [a, b].map(|axis| self.direction(axis));
                Some(a.perp(&b).atan2(a.dot(&b)))
            }
            JointKind::Prismatic(a, b) => {
                Some((self.place(b) - self.place(a)).dot(&self.direction(a)))
            }
            _ => None,
        }
    }

    /// The greatest distance, and sine of an angle, by which axes that a joint makes coincide do not.
    pub(crate) fn gap(&self) -> f64 {
        let apart = |joint: &Joint| match joint.kind {
            JointKind::Revolute(a, b) | JointKind::Weld(a, b) | JointKind::Prismatic(a, b) => {
                let offset = self.place(b) - self.place(a);
                let along = self.direction(a);
                let twist = along.perp(&self.direction(b)).abs();
                match joint.kind {
                    JointKind::Revolute(..) => offset.norm(),
                    JointKind::Weld(..) => offset.norm().max(twist),
                    _ => along.perp(&offset).abs().max(twist),
                }
            }
            // What rolls is looked at apart.
            JointKind::Gear { .. }
            | JointKind::Belt { .. }
            | JointKind::Rack { .. }
            | JointKind::Cam { .. } => 0.0,
        };
        self.model.joints.iter().map(apart).fold(0.0, f64::max)
    }
}

/// The frame of a link with this pose: cosine, sine, x and y.
pub(crate) fn frame([cos, sin, x, y]: [f64; 4]) -> Isometry2<f64> {
    let rotation = UnitComplex::new_unchecked(Complex::new(cos, sin));
    Isometry2::from_parts(Translation2::new(x, y), rotation)
}
