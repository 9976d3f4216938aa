//! The joints of a drawing: kinds, links and places.

use super::NewKind;
use super::declaration::drawn_joint;
use super::sketch::Scene;
use crate::model::{JointId, JointKind, LinkId, Model};

/// A joint that is drawn. Of a slot the first link has the pin.
pub(super) struct Tie {
    pub(super) kind: NewKind,
    pub(super) links: [LinkId; 2],
    pub(super) at: [f64; 2],
}

impl Tie {
    pub(super) fn has(&self, link: LinkId) -> bool {
        self.links.contains(&link)
    }

    /// The direction in which something slides.
    pub(super) fn along(&self) -> Option<[f64; 2]> {
        match self.kind {
            NewKind::Prismatic(along) | NewKind::Slot(along) => Some(along),
            NewKind::Revolute | NewKind::Weld => None,
        }
    }
}

/// All joints that are drawn, as they were declared.
pub(super) fn ties(model: &Model) -> Vec<Tie> {
    let scene = Scene::of(model);
    let tie = |joint: JointId| {
        let kind = match model.joint(joint).kind {
            JointKind::Revolute(..) => NewKind::Revolute,
            JointKind::Weld(..) => NewKind::Weld,
            JointKind::Prismatic(line, die) => {
                let along = model.axis(line).direction;
                if let Some((pin, _)) = model.link(model.axis(die).link).die {
                    let (pin, line) = (model.axis(pin), model.axis(line));
                    let is_drawn =
                        [pin, line].iter().all(|axis| axis.name.is_none() && scene.draws(axis));
                    return is_drawn.then_some(Tie {
                        kind: NewKind::Slot(along),
                        links: [pin.link, line.link],
                        at: pin.at,
                    });
                }
                NewKind::Prismatic(along)
            }
            _ => return None,
        };
        let (links, at) = drawn_joint(model, joint)?;
        Some(Tie { kind, links, at })
    };
    model.declared_joints().filter_map(tie).collect()
}
