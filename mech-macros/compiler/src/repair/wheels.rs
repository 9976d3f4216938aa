//! Joints by which a link would carry what rolls.

use super::Repair;
use super::declaration::{
    Declaration, Ends, NewJoint, NewKind, NewNames, Purpose, drawn_joint, join,
};
use super::sketch::FEW;
use super::tie::{Tie, ties};
use crate::digits::of_four_digits;
use crate::model::{JointId, JointKind, LinkId, Model, Ratio};
use crate::structure::{self, MeshTrouble, Pin};

/// The pins on which a wheel could turn, and the guides on which a bar could slide: on a link that already carries the other, the ground
/// last; or on the one that is named.
pub(super) fn axles(model: &Model, rolling: JointId, on: Option<LinkId>) -> Vec<Repair> {
    let (a, b) = model.ends(rolling);
    let pins = structure::pins(model);
    match model.joint(rolling).kind {
        JointKind::Gear { ratio, .. } => {
            let apart = match ratio {
                Ratio::Radii(first, second) => (first + second).abs(),
                Ratio::Teeth(..) => 1.0,
            };
            let turning =
                |[wheel, other]: [LinkId; 2]| turning(model, &pins, [wheel, other], apart, on);
            [[b, a], [a, b]].into_iter().flat_map(turning).collect()
        }
        JointKind::Rack { radius, .. } => on_bars(model, &pins, [a, b], radius, on),
        _ => Vec::new(),
    }
}

/// The pins of one wheel, on the links that carry the other.
fn turning(
    model: &Model,
    pins: &[Pin],
    [wheel, other]: [LinkId; 2],
    apart: f64,
    on: Option<LinkId>,
) -> Vec<Repair> {
    let mut found = Vec::new();
    for pin in pins.iter().filter(|pin| pin.axis_of(other).is_some()) {
        let Some([x, y]) = place(model, pin) else {
            continue;
        };
        let mut carriers: Vec<LinkId> = pin.members.iter().map(|member| member.0).collect();
        carriers.retain(|&link| {
            let turns =
                pins.iter().any(|pin| pin.axis_of(wheel).is_some() && pin.axis_of(link).is_some());
            let is_new = link != wheel && link != other && !turns;
            is_new && wheel != LinkId::GROUND && on.is_none_or(|on| link == on)
        });
        carriers.sort_by_key(|&link| (link == LinkId::GROUND, link));
        for carrier in carriers {
            // Where the carrier turns on something else, the wheel may turn with it.
            let shafts = pins.iter().filter(|shaft| {
                let is_pinned = shaft.axis_of(carrier).is_some() && shaft.axis_of(wheel).is_none();
                carrier != LinkId::GROUND && is_pinned && !std::ptr::eq(*shaft, pin)
            });
            for shaft in shafts {
                let base =
                    shaft.members.iter().map(|member| member.0).find(|&link| link != carrier);
                if let (Some(base), Some(at)) = (base, place(model, shaft)) {
                    found.push(axle(model, [base, wheel], at));
                }
            }
            found.push(axle(model, [carrier, wheel], [x + apart, y]));
        }
    }
    found
}

/// What a rack lacks on a link: the pin of its pinion, or the guide of its bar.
fn on_bars(
    model: &Model,
    pins: &[Pin],
    [pinion, bar]: [LinkId; 2],
    radius: f64,
    on: Option<LinkId>,
) -> Vec<Repair> {
    let ties = ties(model);
    let guides = |link: LinkId| {
        let guided = ties.iter().filter(move |tie| tie.has(link));
        guided.filter(|tie| matches!(tie.kind, NewKind::Prismatic(_)))
    };
    let mut found = Vec::new();
    for carrier in model.link_ids().filter(|&link| on.is_none_or(|on| link == on)) {
        let turns = |pin: &&Pin| pin.axis_of(pinion).is_some() && pin.axis_of(carrier).is_some();
        let pin = pins.iter().find(turns);
        let slides = guides(carrier).find(|tie| tie.has(bar));
        match (pin, slides) {
            (None, Some(guide)) if pinion != carrier => {
                let [u, v] = guide.along().unwrap_or_default();
                let at = [guide.at[0] - radius * v, guide.at[1] + radius * u];
                found.push(axle(model, [carrier, pinion], at));
            }
            (Some(pin), None) if bar != carrier => {
                let Some([x, y]) = place(model, pin) else {
                    continue;
                };
                let known = ties.iter().filter_map(Tie::along);
                for [u, v] in known.chain([[1.0, 0.0], [0.0, 1.0]]).take(FEW) {
                    let joint = NewJoint {
                        name: NewNames::new(model).like(None, "guide"),
                        kind: NewKind::Prismatic([u, v]),
                        ends: Ends::Drawn {
                            links: [carrier, bar],
                            at: [x + radius * v, y - radius * u],
                        },
                    };
                    found.push(Declaration::joint(Purpose::Guess, joint).into());
                }
            }
            _ => {}
        }
    }
    found
}

fn axle(model: &Model, links: [LinkId; 2], at: [f64; 2]) -> Repair {
    let name = NewNames::new(model).like(None, "pin");
    join(Purpose::Meet, name, links, at)
}

/// Where a pin is drawn.
fn place(model: &Model, pin: &Pin) -> Option<[f64; 2]> {
    let mut joints = pin.joints.iter();
    joints.find_map(|&joint| Some(drawn_joint(model, joint)?.1))
}

/// A wheel of fewer teeth than this is none.
const FEWEST_TEETH: u8 = 12;
/// Nor is one so many times as large as the other.
const LARGEST: f64 = 100.0;
/// Ratios are looked for among these numbers.
const MOST_PARTS: u8 = 100;
/// So exactly is a ratio met by whole numbers.
const EXACT: f64 = 1e-9;

/// Returns sizes that would fit a gear, the likely ones first: the same ratio, then one of the wheels as it is.
pub(super) fn fitting_sizes(ratio: Ratio, trouble: MeshTrouble) -> Vec<Ratio> {
    let distance = match trouble {
        MeshTrouble::OneShaft => return Vec::new(),
        MeshTrouble::SmallRing if ratio.turned_out().ring_is_small() => return Vec::new(),
        MeshTrouble::SmallRing => return vec![ratio.turned_out()],
        MeshTrouble::Distance { distance, .. } => distance,
    };
    let [a, b] = ratio.sizes();
    let scale = distance / (a + b).abs();
    let signed = |beside: f64| if a + b < 0.0 { -beside } else { beside };
    let sizes = [[a * scale, b * scale], [a, signed(distance) - a], [signed(distance) - b, b]];
    let radii = sizes.map(|sizes| sizes.map(of_four_digits));
    let radii = radii.map(|[a, b]| Ratio::Radii(a, b));
    let mut all: Vec<Ratio> = radii.into_iter().filter(is_gear).collect();
    let place = all.len().min(1);
    all.splice(place..place, teeth(a, b));
    all
}

/// Whether there are two wheels, at most one of them a ring and that the larger.
fn is_gear(ratio: &Ratio) -> bool {
    let [a, b] = ratio.sizes();
    let sizes = [a, b].iter().all(|size| size.is_normal());
    let [less, more] = [a.abs().min(b.abs()), a.abs().max(b.abs())];
    sizes && more <= LARGEST * less && (a > 0.0 || b > 0.0) && !ratio.ring_is_small()
}

/// Numbers of teeth of this ratio, if it is one of small numbers.
fn teeth(a: f64, b: f64) -> Option<Ratio> {
    let ratio = (b / a).abs();
    let fits = |first: u8, second: u8| {
        (ratio * f64::from(first) - f64::from(second)).abs() <= EXACT * f64::from(second)
    };
    let all = || 1..=MOST_PARTS;
    let (first, second) = all().find_map(|first| {
        let second = all().find(|&second| fits(first, second))?;
        Some((first, second))
    })?;
    let times = i64::from(FEWEST_TEETH.div_ceil(first.min(second)));
    let signed = |part: u8, size: f64| {
        let teeth = times * i64::from(part);
        if size < 0.0 { -teeth } else { teeth }
    };
    Some(Ratio::Teeth(signed(first, a), signed(second, b)))
}
