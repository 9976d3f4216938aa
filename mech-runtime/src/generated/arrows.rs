//! Arrows at the points of a mechanism.

use crate::overlay::{Arrows, Spot};
use crate::{Acceleration, Canvas, Pose, Reaction, Scalar, Velocity};

/// Draws the velocities of points of moving links.
pub fn draw_velocities<T: Scalar, const LINKS: usize>(
    points: &[Spot<T>],
    poses: &[Pose<T>; LINKS],
    velocities: &[Velocity<T>; LINKS],
    arrows: &Arrows<T>,
    canvas: &mut impl Canvas<T>,
) {
    for (index, point) in on_links(points) {
        if let (Some(&pose), Some(velocity)) = (poses.get(index), velocities.get(index)) {
            arrows.draw(canvas, pose.apply(point), velocity.of_point(pose, point));
        }
    }
}

/// Draws the accelerations of points of moving links.
pub fn draw_accelerations<T: Scalar, const LINKS: usize>(
    points: &[Spot<T>],
    poses: &[Pose<T>; LINKS],
    (velocities, accelerations): (&[Velocity<T>; LINKS], &[Acceleration<T>; LINKS]),
    arrows: &Arrows<T>,
    canvas: &mut impl Canvas<T>,
) {
    for (index, point) in on_links(points) {
        if let (Some(&pose), Some(velocity), Some(acceleration)) =
            (poses.get(index), velocities.get(index), accelerations.get(index))
        {
            let vector = acceleration.of_point(pose, velocity.angular, point);
            arrows.draw(canvas, pose.apply(point), vector);
        }
    }
}

/// Draws the forces of reactions on the second link of each joint that has a place.
pub fn draw_reactions<T: Scalar, const LINKS: usize, const JOINTS: usize>(
    points: &[Option<Spot<T>>; JOINTS],
    poses: &[Pose<T>; LINKS],
    reactions: &[Reaction<T>; JOINTS],
    arrows: &Arrows<T>,
    canvas: &mut impl Canvas<T>,
) {
    for (point, reaction) in points.iter().zip(reactions) {
        if let Some(point) = point {
            draw_force(point, poses, [reaction.x, reaction.y], arrows, canvas);
        }
    }
}

/// Draws a force at a point.
pub fn draw_force<T: Scalar, const LINKS: usize>(
    point: &Spot<T>,
    poses: &[Pose<T>; LINKS],
    force: [T; 2],
    arrows: &Arrows<T>,
    canvas: &mut impl Canvas<T>,
) {
    if let Some(pose) = Pose::of_link(point.link, poses) {
        arrows.draw(canvas, pose.apply(point.at), force);
    }
}

/// The places of points among poses and rates, and where they are in their links.
fn on_links<T: Scalar>(points: &[Spot<T>]) -> impl Iterator<Item = (usize, [T; 2])> + '_ {
    points.iter().filter_map(|point| Some((point.link.checked_sub(1)?, point.at)))
}
