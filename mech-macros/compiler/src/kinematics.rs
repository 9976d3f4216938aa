//! Where links, axes and joints are at a position, by numbers.

use crate::bug::bug;
use crate::model::{AxisId, JointId, JointKind, LinkId, Model};
use mech_core::Pose;
use nalgebra::{Isometry2, Point2, Vector2};

/// The frames of all links at a position.
pub(crate) struct LinkFrames<'m> {
    model: &'m Model,
    frames: Vec<Isometry2<f64>>,
}

impl<'m> LinkFrames<'m> {
    /// The frames of links with these poses: cosine, sine, x and y of every link, the ground first.
    pub(crate) fn new(model: &'m Model, poses: &[[f64; 4]]) -> Self {
        let frames = poses.iter().map(|pose| Pose::from(*pose).isometry()).collect();
        Self { model, frames }
    }

    /// The frames where only these links have known poses. What is asked of others is NaN. The die of a slot is where its pin is, and
    /// points as its slot.
    pub(crate) fn of_some(model: &'m Model, links: &[LinkId], poses: &[[f64; 4]]) -> Self {
        let mut all = Self::new(model, &vec![[f64::NAN; 4]; model.links.len()]);
        all.frames[LinkId::GROUND.index()] = Isometry2::identity();
        for (link, pose) in links.iter().zip(poses) {
            all.frames[link.index()] = Pose::from(*pose).isometry();
        }
        for (number, link) in model.links.iter().enumerate() {
            if let Some((pin, guide)) = link.die {
                let (place, direction) = (all.place(pin), all.direction(guide));
                let pose = Pose::from([direction.x, direction.y, place.x, place.y]);
                all.frames[number] = pose.isometry();
            }
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

    /// The place in the scene of a place of a link.
    pub(crate) fn place_of(&self, link: LinkId, at: [f64; 2]) -> [f64; 2] {
        (self.frame(link) * Point2::from(at)).into()
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

    /// By how much the axes of a joint fail to coincide: a distance, and the sine of an angle. None for gears, belts, racks and cams.
    pub(crate) fn misfit(&self, joint: JointId) -> Option<[f64; 2]> {
        let kind = self.model.joint(joint).kind;
        let [a, b] = kind.axes()?;
        let offset = self.place(b) - self.place(a);
        let along = self.direction(a);
        let askew = along.perp(&self.direction(b)).abs();
        Some(match kind {
            JointKind::Revolute(..) => [offset.norm(), 0.0],
            JointKind::Weld(..) => [offset.norm(), askew],
            _ => [along.perp(&offset).abs(), askew],
        })
    }

    /// The greatest of all misfits.
    pub(crate) fn gap(&self) -> f64 {
        let joints = self.model.joint_ids();
        let misfits = joints.filter_map(|joint| self.misfit(joint)).flatten();
        misfits.fold(0.0, f64::max)
    }

    /// Returns the greatest distance of an axis from the origins of the scene and of its link.
    pub(crate) fn extent(&self) -> f64 {
        let axes = self.model.axes.iter().zip(0..);
        let far = axes.flat_map(|(axis, id)| {
            let place = self.place(AxisId::new(id));
            [place.coords.norm(), axis.at[0].hypot(axis.at[1])]
        });
        far.fold(0.0, f64::max)
    }
}
