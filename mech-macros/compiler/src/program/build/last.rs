//! The last position: there iterations begin, and it determines the side of a dyad.

use crate::model::{JointKind, LinkId, Model};
use crate::plan::{Algebra, Arithmetic, Pose, Solution, Unknown};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Part, Slot, Value};
use crate::program::state::number_among_all;

/// An unknown at the last position.
pub(super) struct LastUnknown {
    pub(super) name: String,
    pub(super) value: Solution<Value>,
}

/// The pose that the last position left behind. A die was where the pin and the guide of its slot were.
pub(super) fn last_pose(ssa: &mut SsaBuilder, model: &Model, link: LinkId) -> Pose<Value> {
    if let Some((pin, guide)) = model.link(link).die {
        let (pin, guide) = (model.axis(pin), model.axis(guide));
        let origin = last_pose(ssa, model, pin.link).carry(ssa, pin);
        let direction = last_pose(ssa, model, guide.link).heading(ssa, guide);
        return Pose { direction, origin };
    }
    match number_among_all(link) {
        None => Pose::identity(ssa),
        Some(index) => {
            let [cos, sin, x, y] =
                Part::ALL.map(|part| ssa.make(Op::Last(Slot::Pose(index, part))));
            Pose { direction: [cos, sin], origin: [x, y] }
        }
    }
}

/// An unknown at the last position, seen from the base of the first cluster.
pub(super) fn last_unknown(
    ssa: &mut SsaBuilder,
    model: &Model,
    unknown: Unknown,
    base: LinkId,
) -> LastUnknown {
    match unknown {
        Unknown::Direction(link) => {
            let frame = last_pose(ssa, model, base).direction;
            let back = ssa.conjugate(frame);
            let direction = last_pose(ssa, model, link).direction;
            let direction = ssa.rotate(back, direction);
            let name = model.link(link).name.clone();
            let value = Solution::Direction(ssa.normalise(direction, &name));
            LastUnknown { name, value }
        }
        Unknown::Slide(joint) => {
            let name = model.joint(joint).name.clone();
            let displacement = match model.joint(joint).kind {
                JointKind::Prismatic(from, to) => {
                    let (from, to) = (model.axis(from), model.axis(to));
                    let (start, end) =
                        (last_pose(ssa, model, from.link), last_pose(ssa, model, to.link));
                    let heading = start.heading(ssa, from);
                    let start = start.carry(ssa, from);
                    let end = end.carry(ssa, to);
                    let displacement = ssa.minus(end, start);
                    ssa.dot(heading, displacement)
                }
                _ => ssa.constant(0.0),
            };
            let value = Solution::Slide(displacement);
            LastUnknown { name, value }
        }
    }
}
