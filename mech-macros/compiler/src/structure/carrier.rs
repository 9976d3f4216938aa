//! The links that carry what rolls.

use super::diagnosis::{Diagnosis, MeshTrouble};
use super::pin;
use super::rolling::{Factor, Rolling, RollingEnd, Shafts};
use super::welded::Welded;
use crate::model::{JointId, JointKind, LinkId, Model, Ratio};

/// Finds the carrier of everything that rolls.
pub(super) fn rollings(model: &Model, shafts: Shafts<'_>) -> Result<Vec<Rolling>, Vec<Diagnosis>> {
    let mut rollings = Vec::new();
    let mut diagnoses = Vec::new();
    for joint in model.joint_ids().filter(|&joint| model.joint(joint).kind.rolls()) {
        let rolling = rolling(model, shafts, joint);
        let rolling = rolling.and_then(|rolling| {
            check_mesh(model, shafts, &rolling)?;
            Ok(rolling)
        });
        match rolling {
            Ok(rolling) => rollings.push(rolling),
            Err(diagnosis) => diagnoses.push(diagnosis),
        }
    }
    if diagnoses.is_empty() { Ok(rollings) } else { Err(diagnoses) }
}

fn rolling(model: &Model, shafts: Shafts<'_>, joint: JointId) -> Result<Rolling, Diagnosis> {
    let on = match model.joint(joint).kind {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => on,
        _ => None,
    };
    if let Some(named) = on {
        let found = rolling_on(model, shafts, joint, named);
        return found.ok_or(Diagnosis::NotCarrier { joint, link: named });
    }
    let candidates = candidates(model, shafts, joint);
    let direct = |rolling: &&Rolling| {
        rolling
            .ends
            .iter()
            .all(|(end, _)| declared_between(model, shafts.1, end.link(), rolling.carrier))
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
pub(super) fn carriers(model: &Model, shafts: Shafts<'_>, joint: JointId) -> Vec<LinkId> {
    let candidates = candidates(model, shafts, joint).into_iter();
    candidates.map(|rolling| rolling.carrier).collect()
}

/// The rolling on each body that could carry it: on the link of it that has both axes, or else on its first.
fn candidates(model: &Model, shafts: Shafts<'_>, joint: JointId) -> Vec<Rolling> {
    let (pins, welded) = shafts;
    let mut candidates: Vec<Rolling> = Vec::new();
    for link in model.link_ids() {
        let Some(rolling) = rolling_on(model, shafts, joint, link) else {
            continue;
        };
        let has_axes = |rolling: &Rolling| {
            rolling.ends.iter().all(|(end, _)| match *end {
                RollingEnd::Wheel(wheel) => {
                    let mut pins = pins.iter();
                    pins.any(|pin| {
                        pin.axis_of(wheel).is_some() && pin.axis_of(rolling.carrier).is_some()
                    })
                }
                RollingEnd::Bar { slide, .. } => {
                    let (a, b) = model.ends(slide);
                    [a, b].contains(&rolling.carrier)
                }
            })
        };
        let same = |known: &&mut Rolling| welded.are_one(known.carrier, link);
        match candidates.iter_mut().find(same) {
            None => candidates.push(rolling),
            Some(known) if !has_axes(known) && has_axes(&rolling) => *known = rolling,
            Some(_) => {}
        }
    }
    candidates
}

/// The rolling on this carrier, if both axes keep their place in it: directly, or through a coaxial joint or a weld.
fn rolling_on(
    model: &Model,
    (pins, welded): Shafts<'_>,
    joint: JointId,
    carrier: LinkId,
) -> Option<Rolling> {
    let (a, b) = model.ends(joint);
    if welded.are_one(carrier, a) || welded.are_one(carrier, b) {
        return None;
    }
    let wheel = |link| pin::hub(pins, welded, link, carrier).map(|_| RollingEnd::Wheel(link));
    let ends = match model.joint(joint).kind {
        JointKind::Gear { a, b, ratio, .. } => {
            let (first, second) = factors(ratio);
            [(wheel(a)?, first), (wheel(b)?, second)]
        }
        JointKind::Belt { a, b, ratio, .. } => {
            let (first, second) = factors(ratio);
            [(wheel(a)?, first), (wheel(b)?, second.negate())]
        }
        JointKind::Rack { pinion, bar, radius, .. } => {
            let bar = slides_on(model, welded, bar, carrier)?;
            [(wheel(pinion)?, Factor::Float(radius)), (bar, Factor::Whole(-1))]
        }
        _ => return None,
    };
    Some(Rolling { joint, carrier, ends })
}

fn factors(ratio: Ratio) -> (Factor, Factor) {
    match ratio {
        Ratio::Teeth(a, b) => (Factor::Whole(a), Factor::Whole(b)),
        Ratio::Radii(a, b) => (Factor::Float(a), Factor::Float(b)),
    }
}

/// The bar's slide on the carrier.
fn slides_on(model: &Model, welded: &Welded, bar: LinkId, carrier: LinkId) -> Option<RollingEnd> {
    let ends = [(carrier, bar, true), (bar, carrier, false)];
    let found = model.joint_ids().find_map(|slide| {
        let JointKind::Prismatic(..) = model.joint(slide).kind else {
            return None;
        };
        let (a, b) = model.ends(slide);
        let joins = |(from, to, _): &(LinkId, LinkId, bool)| {
            welded.are_one(a, *from) && welded.are_one(b, *to)
        };
        let (_, _, forwards) = ends.into_iter().find(joins)?;
        Some((slide, forwards))
    });
    found.map(|(slide, forwards)| RollingEnd::Bar { link: bar, slide, forwards })
}

/// Whether a joint other than a rolling one was declared between these two links, or what is welded to them.
fn declared_between(model: &Model, welded: &Welded, a: LinkId, b: LinkId) -> bool {
    let joined = [a, b].map(|link| welded.body(link));
    model.joint_ids().any(|joint| {
        let (a, b) = model.ends(joint);
        let [a, b] = [a, b].map(|link| welded.body(link));
        !model.joint(joint).kind.ties() && (joined == [a, b] || joined == [b, a])
    })
}

/// Drawings are rounded: radii may differ from what the places of the axes ask for by this part of the greater radius.
const ROUNDED: f64 = 1e-3;
/// Axes nearer to each other than this part of the mechanism's size are one shaft.
const ONE_SHAFT: f64 = 1e-9;

/// Whether the sizes of what rolls contradict each other, or the places of its axes on the carrier.
fn check_mesh(model: &Model, shafts: Shafts<'_>, rolling: &Rolling) -> Result<(), Diagnosis> {
    let (joint, carrier) = (rolling.joint, rolling.carrier);
    let (is_belt, ratio) = match model.joint(joint).kind {
        JointKind::Gear { ratio, .. } => (false, ratio),
        JointKind::Belt { ratio, .. } => (true, ratio),
        _ => return Ok(()),
    };
    let fails = |trouble| Diagnosis::NoMesh { joint, carrier, ratio, trouble };
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
