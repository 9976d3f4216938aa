//! The places of joints.

use crate::painting::number_of;
use mech_compiler::Compiled;
use mech_compiler::model::{AxisId, JointId, JointKind, Model};
use mech_runtime::overlay::Spot;

/// A joint, and its place on each of its two links.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Landmark {
    joint: JointId,
    spots: [Spot<f64>; 2],
}

/// The joints of a mechanism that have a place: those that turn, slide or weld.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Landmarks {
    landmarks: Vec<Landmark>,
}

impl Landmarks {
    /// The joints between links that have poses.
    pub(super) fn new(model: &Model, compiled: &Compiled) -> Self {
        let spot = |axis: AxisId| {
            let axis = model.axis(axis);
            let link = number_of(compiled, axis.link)?;
            Some(Spot { link, at: axis.at })
        };
        let landmarks = model.declared_joints().filter_map(|joint| {
            let kind = model.joint(joint).kind;
            if !matches!(
                kind,
                JointKind::Revolute(..) | JointKind::Prismatic(..) | JointKind::Weld(..)
            ) {
                return None;
            }
            let [a, b] = kind.axes()?.map(|axis| model.seen_axis(axis));
            let spots = [spot(a)?, spot(b)?];
            Some(Landmark { joint, spots })
        });
        Self { landmarks: landmarks.collect() }
    }

    /// The place of a joint on its second link.
    pub(super) fn joint(&self, joint: JointId) -> Option<Spot<f64>> {
        let found = self.landmarks.iter().find(|one| one.joint == joint)?;
        let [_, second] = found.spots;
        Some(second)
    }

    /// All places of joints on a link.
    pub(super) fn on_link(&self, link: usize) -> impl Iterator<Item = [f64; 2]> + Clone + '_ {
        let spots = self.landmarks.iter().flat_map(|landmark| landmark.spots);
        spots.filter(move |spot| spot.link == link).map(|spot| spot.at)
    }
}
