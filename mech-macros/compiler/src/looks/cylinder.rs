//! Cylinders: a barrel on one link and a piston rod on another, in line with the pins of both.

use super::scene::Scene;
use super::survey::Slide;
use crate::model::LinkId;
use nalgebra::{Point2, Vector2};

/// A pin that is so near to the line of a slide is on it, in widths of a bar.
const ON_LINE: f64 = 0.05;
/// The least distance between barrel and pin, in widths of a bar.
const CLEAR: f64 = 1.2;
/// The least part of the distance of both pins at the start that the barrel takes.
const LEAST: f64 = 0.45;
/// The length of the rod that stays in the barrel, in widths of a bar.
const HELD: f64 = 1.0;

/// Where the parts of a cylinder begin and end: the barrel along the line of its link, the rod along that of its own.
#[derive(Clone, Copy)]
pub(super) struct Cylinder {
    pub(super) barrel: [f64; 2],
    pub(super) rod: [f64; 2],
}

impl Scene<'_> {
    /// The cylinder that a slide between moving links is, if both have a pin in its line.
    pub(super) fn cylinder(&self, slide: Slide) -> Option<Cylinder> {
        let [guide, block] = self.ends(slide);
        if slide.pin.is_some() || guide == LinkId::GROUND {
            return None;
        }
        let [foot, head] = [self.only_on(guide, slide.guide)?, self.only_on(block, slide.block)?];
        // Displacements of the block's line along the guide's; the pin of the rod is `head` farther.
        let travel = self.travel(slide)?;
        let [near, far] = travel.map(|offset| offset + head - foot);
        // The rod comes out on the side of its pin: where that is behind the foot, everything is mirrored.
        let start = self.survey.start();
        let at_start = start.place(self.model, slide.block)?;
        let at_start = start.along(self.model, slide.guide, at_start)? + head - foot;
        let sign = 1.0_f64.copysign(at_start);
        let [near, far] = if sign < 0.0 { [-far, -near] } else { [near, far] };
        if at_start.abs() < 3.0 * self.width {
            return None;
        }
        // Where motors may go farther than a cylinder can, it is one at the start.
        let length = (near - CLEAR * self.width).max(LEAST * at_start.abs());
        let held = |offset: f64| offset - length + HELD * self.width;
        let within = held(far).min(near - 0.5 * self.width);
        let within = within.max(held(at_start.abs()));
        Some(Cylinder { barrel: [foot, foot + sign * length], rod: [head, head - sign * within] })
    }

    /// Returns the place of a link's joints along a line of it, if all are at one place on the line.
    fn only_on(&self, link: LinkId, line: crate::model::AxisId) -> Option<f64> {
        let line = self.model.axis(line);
        let (at, along) = (Point2::from(line.at), Vector2::from(line.direction));
        let mounts = self.mounts(link);
        let mut joints = mounts.iter().filter(|mount| mount.is_joint);
        let offset = joints.next()?.at - at;
        let is_on_it = along.perp(&offset).abs() < ON_LINE * self.width;
        (is_on_it && joints.next().is_none()).then(|| along.dot(&offset))
    }

    /// Whether a motor turns something at this place of a link, other than the link that carries the place.
    pub(super) fn is_driven(&self, link: LinkId, at: Point2<f64>) -> bool {
        self.model.motors.iter().any(|motor| {
            let crate::model::JointKind::Revolute(a, b) = self.model.joint(motor.joint).kind else {
                return false;
            };
            let carrier = self.model.axis(a).link;
            let driven =
                if carrier == link && self.model.axis(b).link == LinkId::GROUND { a } else { b };
            let axis = self.model.axis(driven);
            axis.link == link && (Point2::from(axis.at) - at).norm() < ON_LINE * self.width
        })
    }
}
