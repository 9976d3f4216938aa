//! The symbols of wheels, belts and racks.

use super::diagram::Diagram;
use super::{Spot, Symbol};
use crate::model::{JointId, JointKind, LinkId, Measure, Ratio};
use crate::structure::{Rolling, RollingEnd};

/// The hub of a wheel.
struct Hub {
    /// Its place on the wheel; none if the wheel has no pose.
    spot: Option<Spot>,
    /// Its place on the carrier, in scene units.
    at: [f64; 2],
}

impl Diagram<'_> {
    /// The symbols of a gear, a belt or a rack; none if a hub is not found.
    pub(super) fn rolling(&self, rolling: &Rolling) -> Vec<Symbol> {
        let hub = |wheel: LinkId| self.hub(wheel, rolling.carrier);
        let [a, b] = rolling.ends.map(|(end, _)| end);
        let symbols = match (self.model.joint(rolling.joint).kind, a, b) {
            (JointKind::Gear { ratio, .. }, RollingEnd::Wheel(a), RollingEnd::Wheel(b)) => {
                hub(a).zip(hub(b)).map(|(a, b)| gear([a, b], ratio))
            }
            (JointKind::Belt { ratio, .. }, RollingEnd::Wheel(a), RollingEnd::Wheel(b)) => {
                hub(a).zip(hub(b)).and_then(|(a, b)| belt(&[a, b], ratio))
            }
            (
                JointKind::Rack { radius, .. },
                RollingEnd::Wheel(pinion),
                RollingEnd::Bar { slide, forwards, .. },
            ) => {
                let pinion = hub(pinion).and_then(|hub| hub.spot);
                pinion.and_then(|pinion| self.rack(pinion, radius, (slide, forwards)))
            }
            _ => None,
        };
        symbols.unwrap_or_default()
    }

    /// A pinion and its rack. The radius is in scene units, negative if the bar is on the other side.
    fn rack(
        &self,
        pinion: Spot,
        radius: f64,
        (slide, forwards): (JointId, bool),
    ) -> Option<Vec<Symbol>> {
        let JointKind::Prismatic(a, b) = self.model.joint(slide).kind else {
            return None;
        };
        let line = if forwards { b } else { a };
        let wheel = Symbol::Wheel { center: pinion, radius: Measure::fixed(radius.abs()) };
        let rack = self.first_visible(&[line]).map(|bar| Symbol::Rack {
            pinion,
            radius: Measure::fixed(radius),
            bar,
            along: self.along(line),
        });
        Some([wheel].into_iter().chain(rack).collect())
    }

    /// The hub of a wheel that turns on a carrier.
    fn hub(&self, wheel: LinkId, carrier: LinkId) -> Option<Hub> {
        let welded = &self.structure.welded;
        let [own, on_carrier] = self.structure.hub(wheel, carrier)?;
        Some(Hub {
            spot: Some(self.spot(own)).filter(|spot| (self.has_pose)(spot.link)),
            at: welded.place(self.model.axis(on_carrier), carrier),
        })
    }
}

/// Two meshing wheels, as far as they have poses.
fn gear(hubs: [Hub; 2], ratio: Ratio) -> Vec<Symbol> {
    let radii = ratio.pitch_radii(distance(&hubs));
    let wheels = hubs.into_iter().zip(radii).filter_map(|(hub, radius)| {
        let center = hub.spot.filter(|_| radius.is_finite() && radius > 0.0)?;
        let radius = Measure::fixed(radius);
        Some(Symbol::Wheel { center, radius })
    });
    wheels.collect()
}

/// Two wheels and their belt; none unless both have poses.
fn belt(hubs: &[Hub; 2], ratio: Ratio) -> Option<Vec<Symbol>> {
    let centers = [hubs[0].spot?, hubs[1].spot?];
    let radii = ratio.pulley_radii(distance(hubs)).map(Measure::fixed);
    let wheels = centers.into_iter().zip(radii);
    let wheels = wheels.map(|(center, radius)| Symbol::Wheel { center, radius });
    Some(wheels.chain([Symbol::Belt { centers, radii }]).collect())
}

/// The distance of two hubs, in scene units.
fn distance([a, b]: &[Hub; 2]) -> f64 {
    libm::hypot(b.at[0] - a.at[0], b.at[1] - a.at[1])
}
