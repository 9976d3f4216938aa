//! Where the joints of a mechanism are, read out of the source that declares it.

use super::graphs;
use mech_compiler::model::{AxisId, JointKind, Model};

/// A place that is fixed to a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// Where, in the link's frame, in scene units.
    pub at: [f64; 2],
}

/// A joint, where each of its two links has it.
#[derive(Clone, Debug, PartialEq)]
struct Landmark {
    joint: String,
    slides: bool,
    spots: [Spot; 2],
}

/// The joints of a mechanism that have a place: those that turn, slide or weld.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Landmarks {
    landmarks: Vec<Landmark>,
}

impl Landmarks {
    /// Of the mechanism with this name, declared by a `mechanism!` that stands by itself in this Rust source; these are its `links`.
    /// If it is not there, no joint is known.
    #[must_use]
    pub fn find(source: &str, name: &str, links: &[&str]) -> Self {
        let Some(model) = graphs::model(source, name) else {
            return Self::default();
        };
        let spot = |axis: AxisId| spot(&model, axis, links);
        let joints = model.joints.iter();
        let landmarks = joints.filter_map(|joint| {
            let (a, b, slides) = match joint.kind {
                JointKind::Revolute(a, b) | JointKind::Weld(a, b) => (a, b, false),
                JointKind::Prismatic(a, b) => (a, b, true),
                _ => return None,
            };
            Some(Landmark {
                joint: joint.name.clone(),
                slides,
                spots: [spot(a)?, spot(b)?],
            })
        });
        let landmarks = landmarks.collect();
        Self { landmarks }
    }

    /// Where a joint is: what slides, on its second link.
    #[must_use]
    pub fn joint(&self, name: &str) -> Option<Spot> {
        let [_, second] = self.named(name)?.spots;
        Some(second)
    }

    /// Whether a joint slides: then its coordinate is a length.
    #[must_use]
    pub fn slides(&self, name: &str) -> bool {
        self.named(name).is_some_and(|landmark| landmark.slides)
    }

    /// All places of joints on a link.
    pub fn on_link(&self, link: usize) -> impl Iterator<Item = [f64; 2]> + Clone + '_ {
        let spots = self.landmarks.iter().flat_map(|landmark| landmark.spots);
        spots
            .filter(move |spot| spot.link == link)
            .map(|spot| spot.at)
    }

    fn named(&self, name: &str) -> Option<&Landmark> {
        self.landmarks.iter().find(|one| one.joint == name)
    }
}

/// The place of an axis, if its link is the ground or one of these.
fn spot(model: &Model, axis: AxisId, links: &[&str]) -> Option<Spot> {
    let axis = model.axes.get(axis.index())?;
    let link = match axis.link.index() {
        0 => 0,
        moving => {
            let name = &model.links.get(moving)?.name;
            1 + links.iter().position(|link| link == name)?
        }
    };
    Some(Spot { link, at: axis.at })
}
