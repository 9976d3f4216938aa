//! Wheels: which links are wheels, how many teeth they have, and how these stand so that they mesh at the start.

use super::scene::Scene;
use super::tooth::Side;
use crate::model::{JointKind, LinkId, Ratio};
use crate::structure::{Rolling, RollingEnd};
use nalgebra::{Point2, Rotation2, Vector2, distance};
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// If the smaller of two wheels would have fewer teeth than this, both get a multiple of their teeth.
const FEWEST_TEETH: i64 = 9;
const ENOUGH_TEETH: i64 = 16;
/// A wheel with more teeth is drawn smooth.
const MOST_TEETH: i64 = 600;
/// Where radii are declared: the size of a tooth, as a part of a bar's width.
const MODULE: f64 = 0.4;
/// Numbers that differ by no more than this part are the same: centres, ratios, and numbers of teeth that are nearly whole.
const WHOLE: f64 = 1e-6;

/// Shapes are a wheel if they cover it as far as this part of its radius.
const OF_WHEEL: f64 = 0.8;

/// A wheel on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wheel {
    pub(super) link: LinkId,
    /// Its centre, in the frame of the link.
    pub(super) center: Point2<f64>,
    /// Its pitch radius, in scene units.
    pub(super) radius: f64,
    /// The number of teeth; none if it is smooth.
    pub(super) teeth: Option<u32>,
    pub(super) side: Side,
    /// The direction of its first tooth in the frame of the link.
    pub(super) phase: f64,
}

impl Wheel {
    /// Whether the shapes of its link are its body: they cover most of it.
    pub(super) fn is_drawn(&self, scene: &Scene<'_>) -> bool {
        let rim = (0..8).map(|eighth| Rotation2::new(f64::from(eighth) * FRAC_PI_4));
        let rim = rim.map(|turn| self.center + turn * Vector2::x() * (OF_WHEEL * self.radius));
        rim.into_iter().all(|place| scene.is_covered(self.link, place))
    }
}

/// Two wheels that mesh.
struct Mesh {
    wheels: [usize; 2],
    /// The direction in the scene, at the start, from the centre of the first to that of the second.
    direction: f64,
}

/// A toothed bar and its pinion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rack {
    pub(super) rolling: Rolling,
    /// Which of the wheels its pinion is.
    pub(super) pinion: usize,
    /// The pinion's radius as it was declared: negative on the other side.
    pub(super) radius: f64,
}

/// All wheels of a mechanism.
pub(super) struct Wheels {
    pub(super) all: Vec<Wheel>,
    pub(super) racks: Vec<Rack>,
    /// Belts: the carrier, and which wheels they run over.
    pub(super) belts: Vec<(LinkId, [usize; 2])>,
    meshes: Vec<Mesh>,
}

/// The place of a wheel's axis: on the wheel, and on its carrier.
struct Hub {
    own: Point2<f64>,
    on_carrier: Point2<f64>,
}

impl Wheels {
    pub(super) fn new(scene: &Scene<'_>) -> Self {
        let mut wheels =
            Self { all: Vec::new(), racks: Vec::new(), belts: Vec::new(), meshes: Vec::new() };
        for rolling in &scene.structure.rollings {
            // Wheels of links without poses are not drawn.
            let _ = wheels.add(scene, rolling);
        }
        // A rack's teeth are as large as those of the wheels with which its pinion meshes.
        for rolling in &scene.structure.rollings {
            let _ = wheels.add_rack(scene, rolling);
        }
        wheels.mesh(scene);
        wheels
    }

    /// The wheels on a link.
    pub(super) fn on(&self, link: LinkId) -> impl Iterator<Item = &Wheel> {
        self.all.iter().filter(move |wheel| wheel.link == link)
    }

    /// The racks whose bar a link is.
    pub(super) fn racks_on(&self, link: LinkId) -> impl Iterator<Item = &Rack> {
        let racks = self.racks.iter();
        racks.filter(move |rack| rack.rolling.ends[1].0.link() == link)
    }

    fn add(&mut self, scene: &Scene<'_>, rolling: &Rolling) -> Option<()> {
        let [(RollingEnd::Wheel(a), _), (RollingEnd::Wheel(b), _)] = rolling.ends else {
            return None;
        };
        let hubs = [hub(scene, a, rolling.carrier)?, hub(scene, b, rolling.carrier)?];
        let apart = distance(&hubs[0].on_carrier, &hubs[1].on_carrier);
        match scene.model.joint(rolling.joint).kind {
            JointKind::Gear { ratio, .. } => {
                let sizes = ratio.sizes();
                let radii = ratio.pitch_radii(apart);
                let teeth = teeth(ratio, radii, MODULE * scene.width);
                let links = [a, b];
                let wheels = [0, 1].map(|end| Wheel {
                    link: links[end],
                    center: hubs[end].own,
                    radius: radii[end],
                    teeth: teeth.map(|teeth| teeth[end]),
                    side: if sizes[end] < 0.0 { Side::Inside } else { Side::Outside },
                    phase: 0.0,
                });
                let carrier = scene.survey.at_start(rolling.carrier)?;
                let direction = carrier * (hubs[1].on_carrier - hubs[0].on_carrier);
                if radii.iter().any(|radius| !radius.is_finite() || *radius <= 0.0) {
                    return None;
                }
                let wheels = wheels.map(|wheel| self.number(scene, wheel));
                self.meshes.push(Mesh { wheels, direction: angle(direction) });
            }
            JointKind::Belt { ratio, .. } => {
                let radii = ratio.pulley_radii(apart);
                let pulley = |link: LinkId, hub: &Hub, radius: f64| Wheel {
                    link,
                    center: hub.own,
                    radius,
                    teeth: None,
                    side: Side::Outside,
                    phase: 0.0,
                };
                let pulleys = [pulley(a, &hubs[0], radii[0]), pulley(b, &hubs[1], radii[1])];
                let pulleys = pulleys.map(|wheel| self.number(scene, wheel));
                self.belts.push((rolling.carrier, pulleys));
            }
            _ => {}
        }
        Some(())
    }

    fn add_rack(&mut self, scene: &Scene<'_>, rolling: &Rolling) -> Option<()> {
        let JointKind::Rack { radius, .. } = scene.model.joint(rolling.joint).kind else {
            return None;
        };
        let [(RollingEnd::Wheel(link), _), _] = rolling.ends else {
            return None;
        };
        let center = hub(scene, link, rolling.carrier)?.own;
        let same = |wheel: &&Wheel| wheel.teeth.is_some() && is_near(wheel.radius, radius.abs());
        let known = self.on(link).find(same).and_then(|wheel| wheel.teeth);
        let teeth = known.unwrap_or_else(|| {
            let count = (2.0 * radius.abs() / (MODULE * scene.width)).round();
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "between 12 and 60"
            )]
            let count = count.clamp(12.0, 60.0) as u32;
            count
        });
        let pinion = self.number(
            scene,
            Wheel {
                link,
                center,
                radius: radius.abs(),
                teeth: Some(teeth),
                side: Side::Outside,
                phase: 0.0,
            },
        );
        self.racks.push(Rack { rolling: *rolling, pinion, radius });
        Some(())
    }

    /// The number of a wheel, which may be known from another joint.
    fn number(&mut self, scene: &Scene<'_>, wheel: Wheel) -> usize {
        let same = |known: &Wheel| {
            known.link == wheel.link
                && known.side == wheel.side
                && known.teeth == wheel.teeth
                && is_near(known.radius, wheel.radius)
                && distance(&known.center, &wheel.center) < WHOLE * scene.width
        };
        self.all.iter().position(same).unwrap_or_else(|| {
            self.all.push(wheel);
            self.all.len() - 1
        })
    }

    /// Turns the teeth so that those of meshing wheels fit at the start: from wheel to wheel. Where meshes form a ring they may not fit in
    /// all of them.
    fn mesh(&mut self, scene: &Scene<'_>) {
        let mut settled = vec![false; self.all.len()];
        for first in 0..self.all.len() {
            if settled[first] {
                continue;
            }
            settled[first] = true;
            let mut waiting = vec![first];
            while let Some(wheel) = waiting.pop() {
                for mesh in &self.meshes {
                    let [a, b] = mesh.wheels;
                    let (next, direction) = match wheel {
                        _ if wheel == a => (b, mesh.direction),
                        _ if wheel == b => (a, mesh.direction + PI),
                        _ => continue,
                    };
                    if settled[next] {
                        continue;
                    }
                    if let Some(phase) =
                        fitting_phase(scene, [self.all[wheel], self.all[next]], direction)
                    {
                        self.all[next].phase = phase;
                    }
                    settled[next] = true;
                    waiting.push(next);
                }
            }
        }
    }
}

/// The direction of the second wheel's first tooth, in its link, that lets it mesh with the first. `direction` is that from the centre of
/// the first to that of the second, in the scene at the start.
fn fitting_phase(scene: &Scene<'_>, [one, other]: [Wheel; 2], direction: f64) -> Option<f64> {
    let turned = |wheel: Wheel| Some(scene.survey.at_start(wheel.link)?.rotation.angle());
    // Seen from each centre, in which direction the pitch point is.
    let [from_one, from_other] = match (one.side, other.side) {
        (Side::Inside, _) => [direction; 2],
        (_, Side::Inside) => [direction + PI; 2],
        _ => [direction, direction + PI],
    };
    let pitch = |wheel: Wheel| Some(TAU / f64::from(wheel.teeth?));
    let beyond_tooth = (from_one - turned(one)? - one.phase) / pitch(one)?;
    // A tooth meets a gap; the gaps of a ring are the teeth of its outline.
    let beyond_other = if one.side == other.side { 0.5 - beyond_tooth } else { beyond_tooth };
    Some(from_other - turned(other)? - beyond_other * pitch(other)?)
}

/// Numbers of teeth for a pair of wheels with these radii; none if it has none.
fn teeth(ratio: Ratio, radii: [f64; 2], module: f64) -> Option<[u32; 2]> {
    let whole = match ratio {
        Ratio::Teeth(a, b) => [a.abs(), b.abs()],
        Ratio::Radii(..) => {
            let least = radii[0].min(radii[1]);
            let [low, high] = [0.5, 2.0].map(|part| part * 2.0 * least / module);
            let fits = |count: &f64| {
                radii.iter().all(|radius| {
                    let teeth = count * radius / least;
                    (teeth - teeth.round()).abs() < WHOLE * teeth
                })
            };
            let middle = (2.0 * least / module).round().clamp(10.0, 60.0);
            let mut counts = (0..64).map(f64::from).flat_map(|off| [middle + off, middle - off]);
            let count = counts
                .find(|count| *count >= low.max(9.0) && *count <= high.max(30.0) && fits(count))?;
            #[expect(clippy::cast_possible_truncation, reason = "a few hundred teeth")]
            radii.map(|radius| (count * radius / least).round() as i64)
        }
    };
    let least = whole[0].min(whole[1]);
    let times = if least < FEWEST_TEETH {
        ENOUGH_TEETH / least + i64::from(ENOUGH_TEETH % least > 0)
    } else {
        1
    };
    let whole = whole.map(|count| count.saturating_mul(times));
    let is_fine = whole.iter().all(|count| (1..=MOST_TEETH).contains(count));
    let [a, b] = whole.map(|count| u32::try_from(count).ok());
    is_fine.then_some([a?, b?])
}

/// The hub of a wheel that turns on a carrier.
fn hub(scene: &Scene<'_>, wheel: LinkId, carrier: LinkId) -> Option<Hub> {
    scene.survey.at_start(wheel)?;
    let axes = scene.structure.hub(wheel, carrier)?;
    let [own, on_carrier] = [(axes[0], wheel), (axes[1], carrier)].map(|(axis, link)| {
        let place = scene.structure.welded.place(scene.model.axis(axis), link);
        Point2::from(place)
    });
    Some(Hub { own, on_carrier })
}

/// The place of a wheel's centre on its carrier.
pub(super) fn hub_on(scene: &Scene<'_>, wheel: LinkId, carrier: LinkId) -> Option<Point2<f64>> {
    Some(hub(scene, wheel, carrier)?.on_carrier)
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < WHOLE * a.abs().max(b.abs())
}

/// The angle of a direction.
pub(super) fn angle(direction: Vector2<f64>) -> f64 {
    direction.y.atan2(direction.x)
}
