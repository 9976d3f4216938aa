//! Gears, belts and racks, and the links that carry them.

use super::diagnosis::Diagnosis;
use super::mesh;
use super::pin::Pin;
use crate::model::{JointId, JointKind, LinkId, Model, Ratio};

/// Two coordinates tied by rolling: `factor · coordinate` of the one and of the other sum to a constant, both seen from the
/// carrier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// The joint.
    pub joint: JointId,
    /// The link in which both axes keep their place.
    pub carrier: LinkId,
    /// What rolls.
    pub ends: [(RollingEnd, Factor); 2],
}

/// A part that rolls on another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RollingEnd {
    /// A wheel: its coordinate is the angle from the carrier to it.
    Wheel(LinkId),
    /// A toothed bar: its coordinate is that of its sliding joint on the carrier; negated if that is declared from the bar.
    Bar {
        /// The bar.
        link: LinkId,
        /// The joint by which it slides on the carrier.
        slide: JointId,
        /// Whether the slide is declared from the carrier to the bar.
        forwards: bool,
    },
}

impl RollingEnd {
    /// The wheel or bar.
    #[must_use]
    pub fn link(self) -> LinkId {
        match self {
            Self::Wheel(link) | Self::Bar { link, .. } => link,
        }
    }
}

/// An exact number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor {
    /// A number of teeth.
    Whole(i64),
    /// A radius: a float stands for exactly itself.
    Float(f64),
}

/// Finds the carrier of everything that rolls.
pub(crate) fn rollings(model: &Model, pins: &[Pin]) -> Result<Vec<Rolling>, Vec<Diagnosis>> {
    let mut rollings = Vec::new();
    let mut diagnoses = Vec::new();
    for joint in model
        .joint_ids()
        .filter(|&joint| model.joint(joint).kind.rolls())
    {
        let rolling = rolling(model, pins, joint);
        let rolling = rolling.and_then(|rolling| {
            mesh::check(model, pins, &rolling)?;
            Ok(rolling)
        });
        match rolling {
            Ok(rolling) => rollings.push(rolling),
            Err(diagnosis) => diagnoses.push(diagnosis),
        }
    }
    if diagnoses.is_empty() {
        Ok(rollings)
    } else {
        Err(diagnoses)
    }
}

fn rolling(model: &Model, pins: &[Pin], joint: JointId) -> Result<Rolling, Diagnosis> {
    let on = match model.joint(joint).kind {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => on,
        _ => None,
    };
    let candidates = candidates(model, pins, joint);
    if let Some(named) = on {
        let found = candidates
            .into_iter()
            .find(|rolling| rolling.carrier == named);
        return found.ok_or(Diagnosis::NotCarrier { joint, link: named });
    }
    let direct = |rolling: &&Rolling| {
        rolling
            .ends
            .iter()
            .all(|(end, _)| declared_between(model, end.link(), rolling.carrier))
    };
    let directly: Vec<&Rolling> = candidates.iter().filter(direct).collect();
    match (&candidates[..], &directly[..]) {
        ([only], _) => Ok(*only),
        (_, [only]) => Ok(**only),
        ([], _) => Err(Diagnosis::NoCarrier { joint }),
        (all, _) => {
            let carriers = all.iter().map(|rolling| rolling.carrier).collect();
            Err(Diagnosis::SeveralCarriers { joint, carriers })
        }
    }
}

/// The links that could carry it.
pub(super) fn carriers(model: &Model, pins: &[Pin], joint: JointId) -> Vec<LinkId> {
    let candidates = candidates(model, pins, joint).into_iter();
    candidates.map(|rolling| rolling.carrier).collect()
}

/// The rolling on each link that could carry it.
fn candidates(model: &Model, pins: &[Pin], joint: JointId) -> Vec<Rolling> {
    let (a, b) = model.ends(joint);
    model
        .link_ids()
        .filter(|&carrier| carrier != a && carrier != b)
        .filter_map(|carrier| rolling_on(model, pins, joint, carrier))
        .collect()
}

/// The rolling on this carrier, if both axes keep their place in it: directly, or through a coaxial joint.
fn rolling_on(model: &Model, pins: &[Pin], joint: JointId, carrier: LinkId) -> Option<Rolling> {
    let wheel = |link| {
        let shares = |pin: &&Pin| pin.axis_of(link).is_some() && pin.axis_of(carrier).is_some();
        pins.iter().find(shares).map(|_| RollingEnd::Wheel(link))
    };
    let ends = match model.joint(joint).kind {
        JointKind::Gear { a, b, ratio, .. } => {
            let (first, second) = factors(ratio);
            [(wheel(a)?, first), (wheel(b)?, second)]
        }
        JointKind::Belt { a, b, ratio, .. } => {
            let (first, second) = factors(ratio);
            [(wheel(a)?, first), (wheel(b)?, second.negate())]
        }
        JointKind::Rack {
            pinion,
            bar,
            radius,
            ..
        } => {
            let bar = slides_on(model, bar, carrier)?;
            [
                (wheel(pinion)?, Factor::Float(radius)),
                (bar, Factor::Whole(-1)),
            ]
        }
        _ => return None,
    };
    Some(Rolling {
        joint,
        carrier,
        ends,
    })
}

fn factors(ratio: Ratio) -> (Factor, Factor) {
    match ratio {
        Ratio::Teeth(a, b) => (Factor::Whole(a), Factor::Whole(b)),
        Ratio::Radii(a, b) => (Factor::Float(a), Factor::Float(b)),
    }
}

impl Factor {
    fn negate(self) -> Self {
        match self {
            Self::Whole(value) => Self::Whole(-value),
            Self::Float(value) => Self::Float(-value),
        }
    }
}

/// The bar's slide on the carrier.
fn slides_on(model: &Model, bar: LinkId, carrier: LinkId) -> Option<RollingEnd> {
    model
        .joint_ids()
        .find_map(|slide| match model.joint(slide).kind {
            JointKind::Prismatic(..) if model.ends(slide) == (carrier, bar) => {
                Some(RollingEnd::Bar {
                    link: bar,
                    slide,
                    forwards: true,
                })
            }
            JointKind::Prismatic(..) if model.ends(slide) == (bar, carrier) => {
                Some(RollingEnd::Bar {
                    link: bar,
                    slide,
                    forwards: false,
                })
            }
            _ => None,
        })
}

/// Whether a joint other than a rolling one was declared between these two links.
fn declared_between(model: &Model, a: LinkId, b: LinkId) -> bool {
    model.joint_ids().any(|joint| {
        let ends = model.ends(joint);
        !model.joint(joint).kind.ties() && (ends == (a, b) || ends == (b, a))
    })
}
