//! Pins that do not turn in their slots: two of a link stand in two parallel slots of another that are exactly as far apart as they. These
//! slots let the link turn to the first order, so no equations of theirs would tell its direction; but it keeps it, as on a guide.

use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};

/// A pin that does not turn in its slot.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StillPin {
    /// The joint of the pin and the die of its slot.
    pub joint: JointId,
    /// The direction of the slot, seen from the link that has the pin.
    pub direction: [f64; 2],
}

/// A pin in a slot.
struct Slot<'m> {
    joint: JointId,
    links: [LinkId; 2],
    pin: &'m Axis,
    line: &'m Axis,
}

/// So much of their distance may pins and slots differ by rounding.
const ROUNDING: f64 = 1e-12;

/// Finds the pins that do not turn in their slots.
pub(crate) fn still_pins(model: &Model) -> Vec<StillPin> {
    let slots: Vec<Slot<'_>> = model.joint_ids().filter_map(|id| slot(model, id)).collect();
    let still = |slot: &Slot<'_>| {
        let others = slots.iter().filter(|other| other.joint != slot.joint);
        let direction = others
            .filter(|other| other.links == slot.links)
            .find_map(|other| direction(slot, other))?;
        Some(StillPin { joint: slot.joint, direction })
    };
    slots.iter().filter_map(still).collect()
}

/// The slot whose pin this joint is, if nothing varies in it.
fn slot(model: &Model, joint: JointId) -> Option<Slot<'_>> {
    let JointKind::Revolute(_, pivot) = model.joint(joint).kind else {
        return None;
    };
    let (pin, line): (AxisId, AxisId) = model.link(model.axis(pivot).link).die?;
    let [pin, line] = [pin, line].map(|axis| model.axis(axis));
    (!pin.varies() && !line.varies()).then_some(Slot {
        joint,
        links: [pin.link, line.link],
        pin,
        line,
    })
}

/// The direction of a slot, seen from the link of its pin, if this slot and another of the same links keep that link's direction.
fn direction(slot: &Slot<'_>, other: &Slot<'_>) -> Option<[f64; 2]> {
    let along = slot.line.direction;
    let [u, v] = between(slot.line, other.line);
    let across = along[0] * v - along[1] * u;
    let [x, y] = between(slot.pin, other.pin);
    let apart = x.hypot(y);
    let [cos, sin] = other.line.direction;
    let is_parallel = (along[0] * sin - along[1] * cos).abs() <= ROUNDING;
    let is_as_far = (apart - across.abs()).abs() <= ROUNDING * apart;
    // Turned by a right angle the slot points from pin to pin, or back.
    let sign = across.signum() / apart;
    (is_parallel && is_as_far && apart > 0.0).then_some([sign * y, -sign * x])
}

fn between(from: &Axis, to: &Axis) -> [f64; 2] {
    [to.at[0] - from.at[0], to.at[1] - from.at[1]]
}
