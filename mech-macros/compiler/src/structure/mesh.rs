//! Whether wheels of their sizes can roll on each other where their axes are.

use super::diagnosis::{Diagnosis, MeshTrouble};
use super::pin;
use super::rolling::{Rolling, Shafts};
use crate::model::{JointKind, LinkId, Model, Ratio};

/// Drawings are rounded: radii may differ from what the places of the axes ask for by this part of the greater radius.
const ROUNDED: f64 = 1e-3;
/// Axes nearer to each other than this part of the mechanism's size are one shaft.
const ONE_SHAFT: f64 = 1e-9;

/// Whether the sizes of what rolls contradict each other, or the places of its axes on the carrier.
pub(super) fn check(model: &Model, shafts: Shafts<'_>, rolling: &Rolling) -> Result<(), Diagnosis> {
    let (joint, carrier) = (rolling.joint, rolling.carrier);
    let (is_belt, ratio) = match model.joint(joint).kind {
        JointKind::Gear { ratio, .. } => (false, ratio),
        JointKind::Belt { ratio, .. } => (true, ratio),
        _ => return Ok(()),
    };
    let fails = |trouble| Diagnosis::NoMesh {
        joint,
        carrier,
        ratio,
        trouble,
    };
    let is_internal = ratio.is_internal();
    if is_internal && ratio.ring_is_small() {
        return Err(fails(MeshTrouble::SmallRing));
    }
    let [(a, _), (b, _)] = rolling.ends;
    let places = [a, b].map(|end| place(model, shafts, end.link(), carrier));
    let [Some(first), Some(second)] = places else {
        return Ok(());
    };
    let distance = f64::hypot(second[0] - first[0], second[1] - first[1]);
    if distance <= ONE_SHAFT * model.size() && !is_internal {
        return Err(fails(MeshTrouble::OneShaft));
    }
    match ratio {
        Ratio::Radii(a, b) if !is_belt => {
            let asked = (a + b).abs();
            let slack = ROUNDED * a.abs().max(b.abs());
            if (asked - distance).abs() <= slack {
                Ok(())
            } else {
                Err(fails(MeshTrouble::Distance { distance, asked }))
            }
        }
        _ => Ok(()),
    }
}

/// Where a wheel turns on its carrier, in the frame of that.
fn place(
    model: &Model,
    (pins, welded): Shafts<'_>,
    wheel: LinkId,
    carrier: LinkId,
) -> Option<[f64; 2]> {
    let [_, axis] = pin::hub(pins, welded, wheel, carrier)?;
    Some(welded.place(model.axis(axis), carrier))
}
