//! The places of joints.

use mech_runtime::{Anchor, JointKind, Mechanism};

/// A place that is fixed to a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// The place in the link's frame, in scene units.
    pub at: [f64; 2],
}

impl Spot {
    /// The place of a joint on a link, if the link has a pose.
    fn of(anchor: &Anchor<f64>) -> Option<Self> {
        anchor.link.map(|link| Self {
            link,
            at: anchor.at,
        })
    }
}

/// A joint, and its place on each of its two links.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Landmark {
    joint: &'static str,
    slides: bool,
    spots: [Spot; 2],
}

/// The joints of a mechanism that have a place: those that turn, slide or weld.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Landmarks {
    landmarks: Vec<Landmark>,
}

impl Landmarks {
    /// The joints of the mechanism `M` on links that have poses.
    #[must_use]
    pub fn of<M: Mechanism<Scalar = f64>>() -> Self {
        let landmarks = M::JOINTS.iter().filter_map(|joint| {
            let slides = match joint.kind {
                JointKind::Revolute | JointKind::Weld => false,
                JointKind::Prismatic => true,
                _ => return None,
            };
            let [first, second] = joint.anchors?;
            Some(Landmark {
                joint: joint.name,
                slides,
                spots: [Spot::of(&first)?, Spot::of(&second)?],
            })
        });
        Self {
            landmarks: landmarks.collect(),
        }
    }

    /// The place of a joint on its second link.
    #[must_use]
    pub fn joint(&self, name: &str) -> Option<Spot> {
        let [_, second] = self.find(name)?.spots;
        Some(second)
    }

    /// Whether a joint slides: then its coordinate is a length.
    #[must_use]
    pub fn slides(&self, name: &str) -> bool {
        self.find(name).is_some_and(|landmark| landmark.slides)
    }

    /// All places of joints on a link.
    pub fn on_link(&self, link: usize) -> impl Iterator<Item = [f64; 2]> + Clone + '_ {
        let spots = self.landmarks.iter().flat_map(|landmark| landmark.spots);
        spots
            .filter(move |spot| spot.link == link)
            .map(|spot| spot.at)
    }

    fn find(&self, name: &str) -> Option<&Landmark> {
        self.landmarks.iter().find(|one| one.joint == name)
    }
}
