//! A machine: every link has a body that is made from what it carries.

use super::body::{Body, Form, body};
use super::cam::{CamBody, cams};
use super::declared::eye;
use super::ground::{rails, stands};
use super::outline::{Grid, Outline, Painted, painted, rounded};
use super::planes::{INSIDE, LAID, Order, Pair, order};
use super::scene::Scene;
use super::wheel::Wheels;
use super::{Symbols, rolling};
use crate::bug::bug;
use crate::model::{self, LinkId, Measure, Model};
use crate::symbols::{elastic_symbols, spots};
use mech_core::colors::GROUND;
use nalgebra::Point2;
use std::collections::HashMap;

/// The ground lies behind everything. Each link has two planes, of which the nearer one has its eyes.
const GROUND_PLANE: i32 = 0;
const FIRST_PLANE: i32 = 2;
/// A pixel of the symbols of springs and dampers, in widths of a bar.
const PIXEL: f64 = 0.12;
/// The disc on the ground to which a spring is fixed: its radius, in widths of a bar.
const ANCHOR: f64 = 0.7;

/// The outlines of the ground and of all links, and the symbols of what stretches between links. Of a link whose shapes are its body,
/// only the pins.
pub(super) fn machine(scene: &Scene<'_>, wheels: &Wheels) -> (Vec<Painted>, Option<Symbols>) {
    let grid = Grid::for_width(scene.width);
    let arrangement = Arrangement::new(scene, wheels);
    let elastic = elastic(scene);
    let mut all = ground(scene, wheels, elastic.as_ref());
    all.extend(slot_pins(scene, &arrangement));
    all.extend(hidden_pins(scene, &arrangement));
    all.extend(belts(scene, wheels, &arrangement));
    all.extend(arrangement.painted());
    for painted in &mut all {
        painted.outline = rounded(&painted.outline, grid);
    }
    (all, elastic)
}

/// The bodies of links, and their planes.
struct Arrangement {
    links: Vec<LinkId>,
    bodies: Vec<Body>,
    order: Order,
}

impl Arrangement {
    fn new(scene: &Scene<'_>, wheels: &Wheels) -> Self {
        let links: Vec<LinkId> = scene.shown().collect();
        let wardrobe =
            Wardrobe { scene, wheels, cams: cams(scene), colors: Colors::new(scene.model) };
        let before = in_front(scene);
        let arrange = |forms: &[Form]| {
            let pairs = links.iter().zip(forms);
            let bodies = pairs.map(|(&link, &form)| wardrobe.dress(link, form));
            let bodies: Vec<Body> = bodies.collect();
            let order = order(scene, &links, &bodies, &before);
            Self { links: links.clone(), bodies, order }
        };
        let plates = arrange(&vec![Form::Plate; links.len()]);
        // A plate that crosses a pin wherever it lies leaves its corners open instead.
        let forms: Vec<Form> = plates.forms_of_branches().collect();
        if !forms.contains(&Form::Branches) {
            return plates;
        }
        let branches = arrange(&forms);
        if branches.conflicts() < plates.conflicts() { branches } else { plates }
    }

    /// Returns the form of each link if plates that cross a pin become branches.
    fn forms_of_branches(&self) -> impl Iterator<Item = Form> {
        let pairs = self.bodies.iter().zip(&self.order.conflicts);
        pairs.map(
            |(body, &conflicts)| {
                if body.is_plate && conflicts > 0 { Form::Branches } else { Form::Plate }
            },
        )
    }

    fn conflicts(&self) -> usize {
        self.order.conflicts.iter().sum()
    }

    /// The rear plane of a body: of the number in the order.
    fn plane_of(&self, number: usize) -> i32 {
        let Ok(rank) = i32::try_from(self.order.ranks[number]) else {
            bug!("there are more planes than numbers");
        };
        FIRST_PLANE + 2 * rank
    }

    /// The rear plane of a link; of what has no body, the ground's.
    fn plane(&self, link: LinkId) -> i32 {
        let number = self.links.iter().position(|known| *known == link);
        number.map_or(GROUND_PLANE, |number| self.plane_of(number))
    }

    /// Whether a body in front of a plane covers a place of the scene at the start.
    fn covers(&self, scene: &Scene<'_>, place: Point2<f64>, plane: i32) -> bool {
        let bodies = self.links.iter().zip(&self.bodies).enumerate();
        let mut front = bodies.filter(|(number, _)| self.plane_of(*number) > plane);
        front.any(|(_, (&link, body))| {
            let frame = scene.survey.at_start(link);
            frame.is_some_and(|frame| body.footprint.touches(frame.inverse() * place, 0.0))
        })
    }

    /// The nearer plane of the nearer of two links.
    fn top(&self, links: [LinkId; 2]) -> i32 {
        let [one, other] = links.map(|link| self.plane(link));
        one.max(other) + 1
    }

    /// The outlines of all bodies.
    fn painted(self) -> Vec<Painted> {
        let planes: Vec<i32> = (0..self.links.len()).map(|number| self.plane_of(number)).collect();
        let bodies = self.links.into_iter().zip(self.bodies).zip(planes);
        let outlines = bodies.flat_map(|((link, body), plane)| {
            // No shape of a link covers its pins.
            let top = body.over.max(plane + 1);
            painted(link, plane, body.outlines).chain(painted(link, top, body.top))
        });
        outlines.collect()
    }
}

/// The data from which bodies are made.
struct Wardrobe<'a, 's> {
    scene: &'a Scene<'s>,
    wheels: &'a Wheels,
    cams: Vec<CamBody>,
    colors: Colors,
}

impl Wardrobe<'_, '_> {
    /// A link's body, with its cam disc or its roller.
    fn dress(&self, link: LinkId, form: Form) -> Body {
        let color = self.colors.of(link);
        let mut body = body(self.scene, self.wheels, link, color, form);
        for cam in &self.cams {
            if cam.disc.0 == link {
                let disc = cam.disc_outlines(self.scene, color);
                body.outlines.splice(0..0, disc);
                let (center, radius) = cam.extent();
                body.footprint.add_disc(center, radius);
            }
            if cam.roller.0 == link {
                body.top.extend(cam.roller_outlines(color));
            }
        }
        body
    }
}

/// Springs and dampers: they stretch, so they are painted anew in each position.
fn elastic(scene: &Scene<'_>) -> Option<Symbols> {
    let has_pose = |link| scene.survey.at_start(link).is_some();
    let symbols = elastic_symbols(scene.model, scene.structure, has_pose);
    let unit = PIXEL * scene.width;
    (!symbols.is_empty()).then_some(Symbols::Elastic { symbols, unit })
}

/// The pins of slots, each in the plane in which it is seen in its slot.
fn slot_pins(scene: &Scene<'_>, arrangement: &Arrangement) -> Vec<Painted> {
    let slots = scene.slides().filter_map(|slide| Some((slide, slide.pin?)));
    let seen = slots.filter(|(slide, _)| scene.is_shown(scene.ends(*slide)[1]));
    let pins = seen.flat_map(|(slide, pin)| {
        let axis = scene.model.axis(pin);
        let outlines = eye(axis.place(), Measure::fixed(scene.width));
        painted(axis.link, arrangement.top(scene.ends(slide)), outlines)
    });
    pins.collect()
}

/// The pins that bodies in front of them hide at the start: they are seen through these.
fn hidden_pins(scene: &Scene<'_>, arrangement: &Arrangement) -> Vec<Painted> {
    let front = arrangement.links.len();
    let front = (0..front).map(|number| arrangement.plane_of(number) + 2).max();
    let pins = scene.structure.pins.iter().filter_map(|pin| {
        let own = pin.members.iter().filter(|member| scene.is_shown(member.0));
        let &(link, axis) = own.clone().max_by_key(|member| arrangement.plane(member.0))?;
        let place = scene.survey.start().place(scene.model, axis)?;
        let is_hidden = arrangement.covers(scene, place, arrangement.plane(link));
        let eye = eye(scene.model.axis(axis).place(), Measure::fixed(scene.width));
        is_hidden.then(|| painted(link, front.unwrap_or(GROUND_PLANE), eye))
    });
    pins.flatten().collect()
}

/// The belts, each on the carrier of its pulleys.
fn belts(scene: &Scene<'_>, wheels: &Wheels, arrangement: &Arrangement) -> Vec<Painted> {
    let belts = wheels.belts.iter().filter_map(|(carrier, over)| {
        let plane = arrangement.top(over.map(|wheel| wheels.all[wheel].link));
        let outlines = rolling::belt(scene, wheels, *carrier, *over)?;
        Some(painted(*carrier, plane, outlines))
    });
    belts.flatten().collect()
}

/// Stands and rails, and wheels and racks that do not move.
fn ground(scene: &Scene<'_>, wheels: &Wheels, elastic: Option<&Symbols>) -> Vec<Painted> {
    let fixed = wheels.on(LinkId::GROUND).filter(|wheel| !wheel.is_drawn(scene));
    let fixed = fixed.flat_map(|wheel| rolling::wheel(scene, wheel, GROUND));
    let racks = wheels.racks_on(LinkId::GROUND);
    let racks = racks.filter_map(|rack| rolling::rack(scene, wheels, rack, GROUND));
    let outlines = rails(scene).into_iter().chain(stands(scene, wheels));
    let outlines = outlines.chain(fixed).chain(racks.flatten()).chain(anchors(scene, elastic));
    painted(LinkId::GROUND, GROUND_PLANE, outlines).collect()
}

/// Returns the discs on the ground to which springs and dampers are fixed.
fn anchors(scene: &Scene<'_>, elastic: Option<&Symbols>) -> Vec<(Outline, u8)> {
    let Some(Symbols::Elastic { symbols, .. }) = elastic else {
        return Vec::new();
    };
    let ends = symbols.iter().flat_map(spots);
    let on_ground = ends.filter(|end| end.link == LinkId::GROUND);
    let anchors = on_ground.flat_map(|end| {
        let center = end.at;
        let radius = Measure::fixed(ANCHOR * scene.width);
        let disc = (Outline::Circle { center, radius }, GROUND);
        std::iter::once(disc).chain(eye(center, Measure::fixed(scene.width)))
    });
    anchors.collect()
}

/// Pairs of links of which the first has to be in front of the second: sleeves in front of their guides, barrels in front of piston rods,
/// pins in front of slots.
fn in_front(scene: &Scene<'_>) -> Vec<Pair<LinkId>> {
    let pairs = scene.slides().map(|slide| {
        let [guide, block] = scene.ends(slide);
        let (front, back, weight) = if scene.cylinder(slide).is_some() {
            (guide, block, INSIDE)
        } else {
            (block, guide, LAID)
        };
        Pair { front, back, weight }
    });
    pairs.collect()
}

/// The colours of all links' bodies. What is the same link in several instances of a part has the same colour.
struct Colors(Vec<u8>);

impl Colors {
    pub(super) fn new(model: &Model) -> Self {
        let parts = model.instances.iter();
        let parts: HashMap<&str, &str> =
            parts.map(|instance| (&instance.path[..], &instance.part[..])).collect();
        let mut numbers: HashMap<(Option<&str>, &str), usize> = HashMap::new();
        let colors = model.link_ids().map(|link| {
            if link == LinkId::GROUND {
                return model::color_of(link);
            }
            let name = &model.link(link).name[..];
            let kind = match name.rsplit_once('.') {
                None => (None, name),
                Some((path, own)) => (parts.get(path).copied(), own),
            };
            let next = numbers.len() + 1;
            model::color_of(LinkId::new(*numbers.entry(kind).or_insert(next)))
        });
        Self(colors.collect())
    }

    /// The colour of a link.
    pub(super) fn of(&self, link: LinkId) -> u8 {
        self.0[link.index()]
    }
}
