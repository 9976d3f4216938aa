//! The symbols of springs and dampers.

use super::diagram::Diagram;
use super::{Spot, Symbol};
use crate::model::{AxisId, Between, JointId};

/// The place of a spring or damper, in pixels to the left of the line between its ends: beside it, if another has the same ends.
const MIDDLE: f32 = 0.0;
const LEFT: f32 = 8.0;
const RIGHT: f32 = -8.0;

impl Diagram<'_> {
    /// The symbols of all springs and dampers whose ends have poses.
    pub(super) fn elastic(&self) -> Vec<Symbol> {
        let actions = &self.model.actions;
        let springs = actions.springs.iter().filter_map(|spring| {
            let is_beside = |[a, b]: [AxisId; 2]| {
                let both = [Between::Points(a, b), Between::Points(b, a)];
                let mut dampers = actions.dampers.iter();
                dampers.any(|damper| both.contains(&damper.between))
            };
            match spring.between {
                Between::Points(a, b) => {
                    let beside = if is_beside([a, b]) { LEFT } else { MIDDLE };
                    let ends = self.ends([a, b])?;
                    Some(Symbol::Spring { ends, beside })
                }
                Between::Joint(joint) => self.joint_spot(joint).map(Symbol::TorsionSpring),
            }
        });
        let dampers = actions.dampers.iter().filter_map(|damper| {
            let has_spring = |between: Between| {
                let mut springs = actions.springs.iter();
                springs.any(|spring| spring.between == between)
            };
            match damper.between {
                Between::Points(a, b) => {
                    // The spring is to the left of the line from its own first end.
                    let beside = if has_spring(Between::Points(a, b)) {
                        RIGHT
                    } else if has_spring(Between::Points(b, a)) {
                        LEFT
                    } else {
                        MIDDLE
                    };
                    let ends = self.ends([a, b])?;
                    Some(Symbol::Damper { ends, beside })
                }
                Between::Joint(joint) => self.joint_spot(joint).map(Symbol::TorsionDamper),
            }
        });
        springs.chain(dampers).collect()
    }

    fn ends(&self, [a, b]: [AxisId; 2]) -> Option<[Spot; 2]> {
        Some([self.first_visible(&[a])?, self.first_visible(&[b])?])
    }

    fn joint_spot(&self, joint: JointId) -> Option<Spot> {
        self.first_visible(&self.model.joint(joint).kind.axes()?)
    }
}
