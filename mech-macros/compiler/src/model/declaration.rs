//! Joints that are to be declared.

use super::{AxisId, DrawnAxis, Joint, JointKind, LinkId, Model, Origin};

/// A joint as it is to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct NewJoint {
    /// Its name.
    pub name: String,
    /// What it allows.
    pub kind: NewKind,
    /// What it joins.
    pub ends: Ends,
}

/// What a joint allows that is to be declared. Directions are of length one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NewKind {
    /// To turn.
    Revolute,
    /// Nothing.
    Weld,
    /// To slide in this direction of the scene.
    Prismatic([f64; 2]),
    /// To turn, and to slide in this direction of the scene: the first end has the pin.
    Slot([f64; 2]),
}

/// What a joint joins that is to be declared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// Two links, at a place in the scene, as the drawing has them.
    Drawn {
        /// The links.
        links: [LinkId; 2],
        /// The place.
        at: [f64; 2],
    },
    /// Two points that links have in frames of their own: for a revolute joint.
    Points([AxisId; 2]),
}

impl Ends {
    /// The two links.
    #[must_use]
    pub fn links(&self, model: &Model) -> [LinkId; 2] {
        match *self {
            Self::Drawn { links, .. } => links,
            Self::Points(points) => points.map(|point| model.axis(point).link),
        }
    }
}

impl NewJoint {
    /// Adds it to a mechanism, after all other joints.
    pub(super) fn declare(&self, model: &mut Model) {
        let origin = Origin::default();
        let [a, b] = match self.ends {
            Ends::Points(points) => points,
            Ends::Drawn { links, at } => {
                let axes = match self.kind {
                    NewKind::Revolute | NewKind::Weld => [DrawnAxis::point(at); 2],
                    NewKind::Prismatic(along) => [DrawnAxis::line(at, along); 2],
                    NewKind::Slot(along) => [DrawnAxis::point(at), DrawnAxis::line(at, along)],
                };
                let [first, second] = links;
                [(first, axes[0]), (second, axes[1])].map(|(link, axis)| {
                    model.links[link.index()].drawn |= link != LinkId::GROUND;
                    model.drawn_axis(link, axis, origin)
                })
            }
        };
        let kind = match self.kind {
            NewKind::Revolute => JointKind::Revolute(a, b),
            NewKind::Weld => JointKind::Weld(a, b),
            NewKind::Prismatic(_) => JointKind::Prismatic(a, b),
            NewKind::Slot(_) => {
                model.add_slot(&self.name, origin, a, b);
                return;
            }
        };
        model.joints.push(Joint {
            name: self.name.clone(),
            origin,
            kind,
            hidden: false,
        });
    }
}
