//! Gears and the links that carry them.

use super::diagnosis::Diagnosis;
use super::pin::Pin;
use crate::model::{JointId, JointKind, LinkId, Model, Ratio};

/// A gear with the link in which both of its wheels keep their place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gear {
    /// The joint.
    pub joint: JointId,
    /// The link on which both wheels turn.
    pub carrier: LinkId,
    /// The first wheel, and the index of the pin about which it turns on the carrier.
    pub a: (LinkId, usize),
    /// The second wheel, and the index of the pin about which it turns on the carrier.
    pub b: (LinkId, usize),
    /// The sizes of the two.
    pub ratio: Ratio,
}

/// Finds the carrier of every gear.
pub(crate) fn gears(model: &Model, pins: &[Pin]) -> Result<Vec<Gear>, Vec<Diagnosis>> {
    let mut gears = Vec::new();
    let mut diagnoses = Vec::new();
    for joint in model.joint_ids() {
        let JointKind::Gear { a, b, ratio } = model.joint(joint).kind else {
            continue;
        };
        let found: Vec<Gear> = model
            .link_ids()
            .filter(|&carrier| carrier != a && carrier != b)
            .filter_map(|carrier| {
                let on = |wheel| {
                    pins.iter()
                        .position(|pin| joins(model, pin, wheel, carrier))
                };
                Some(Gear {
                    joint,
                    carrier,
                    a: (a, on(a)?),
                    b: (b, on(b)?),
                    ratio,
                })
            })
            .collect();
        match found[..] {
            [gear] => gears.push(gear),
            [] => diagnoses.push(Diagnosis::NoCarrier { gear: joint }),
            _ => {
                let carriers = found.iter().map(|gear| gear.carrier).collect();
                diagnoses.push(Diagnosis::SeveralCarriers {
                    gear: joint,
                    carriers,
                });
            }
        }
    }
    if diagnoses.is_empty() {
        Ok(gears)
    } else {
        Err(diagnoses)
    }
}

/// Whether a revolute joint was declared between these two links on this pin. That two links happen to share a pin is
/// not enough: a wheel's carrier is the link it was said to turn on.
fn joins(model: &Model, pin: &Pin, wheel: LinkId, carrier: LinkId) -> bool {
    pin.joints.iter().any(|&joint| matches!(model.ends(joint), ends if ends == (wheel, carrier) || ends == (carrier, wheel)))
}
