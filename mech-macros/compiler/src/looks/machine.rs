//! A machine: every link has a body that is made from what it carries.

use super::Symbols;
use super::body::{Body, Form, body};
use super::cam::{CamBody, cams};
use super::color::Colors;
use super::declared::eye;
use super::ground::{rails, stands};
use super::outline::{Grid, Measure, Outline, Painted, painted, place_of};
use super::planes::{Order, order};
use super::rolling;
use super::scene::Scene;
use super::wheel::Wheels;
use crate::bug::bug;
use crate::model::LinkId;
use crate::symbols::{Symbol, elastic_symbols};
use mech_core::colors::GROUND;

/// The ground lies behind everything. Each link has two planes, of which the nearer one has its eyes.
const GROUND_PLANE: i32 = 0;
const FIRST_PLANE: i32 = 2;
/// A pixel of the symbols of springs and dampers, in widths of a bar.
const PIXEL: f64 = 0.12;
/// What a spring is fixed to on the ground: a disc of this radius, in widths of a bar.
const ANCHOR: f64 = 0.7;

/// The outlines of all links without shapes, and what stretches between them.
pub(super) fn machine(scene: &Scene<'_>, wheels: &Wheels) -> (Vec<Painted>, Option<Symbols>) {
    let grid = Grid::for_width(scene.width);
    let arrangement = Arrangement::new(scene, wheels);
    let elastic = elastic(scene);
    let mut all = ground(scene, wheels, elastic.as_ref());
    all.extend(slot_pins(scene, &arrangement));
    all.extend(belts(scene, wheels, &arrangement));
    all.extend(arrangement.painted());
    for painted in &mut all {
        painted.outline = painted.outline.clone().rounded(grid);
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
        let links: Vec<LinkId> = scene.bodies().collect();
        let wardrobe = Wardrobe {
            scene,
            wheels,
            cams: cams(scene),
            colors: Colors::new(scene.model),
        };
        let before = in_front(scene);
        let arrange = |forms: &[Form]| {
            let pairs = links.iter().zip(forms);
            let bodies = pairs.map(|(&link, &form)| wardrobe.dress(link, form));
            let bodies: Vec<Body> = bodies.collect();
            let order = order(scene, &links, &bodies, &before);
            Self {
                links: links.clone(),
                bodies,
                order,
            }
        };
        let plates = arrange(&vec![Form::Plate; links.len()]);
        // A plate that crosses a pin wherever it lies leaves its corners open instead.
        let forms: Vec<Form> = plates.forms_of_branches().collect();
        if !forms.contains(&Form::Branches) {
            return plates;
        }
        let branches = arrange(&forms);
        if branches.conflicts() < plates.conflicts() {
            branches
        } else {
            plates
        }
    }

    /// How each link looks if plates that cross a pin are branches instead.
    fn forms_of_branches(&self) -> impl Iterator<Item = Form> {
        let pairs = self.bodies.iter().zip(&self.order.conflicts);
        pairs.map(|(body, &conflicts)| {
            if body.is_plate && conflicts > 0 {
                Form::Branches
            } else {
                Form::Plate
            }
        })
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

    /// The nearer plane of the nearer of two links.
    fn top(&self, links: [LinkId; 2]) -> i32 {
        let [one, other] = links.map(|link| self.plane(link));
        one.max(other) + 1
    }

    /// The outlines of all bodies.
    fn painted(self) -> Vec<Painted> {
        let planes: Vec<i32> = (0..self.links.len())
            .map(|number| self.plane_of(number))
            .collect();
        let bodies = self.links.into_iter().zip(self.bodies).zip(planes);
        let outlines = bodies.flat_map(|((link, body), plane)| {
            painted(link, plane, body.outlines).chain(painted(link, plane + 1, body.top))
        });
        outlines.collect()
    }
}

/// What bodies are made from.
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
    let seen = slots.filter(|(slide, _)| scene.gets_body(scene.ends(*slide)[1]));
    let pins = seen.flat_map(|(slide, pin)| {
        let axis = scene.model.axis(pin);
        let outlines = eye(place_of(axis), Measure::fixed(scene.width));
        painted(axis.link, arrangement.top(scene.ends(slide)), outlines)
    });
    pins.collect()
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

/// Stands and rails, and wheels that do not turn.
fn ground(scene: &Scene<'_>, wheels: &Wheels, elastic: Option<&Symbols>) -> Vec<Painted> {
    if !scene.gets_body(LinkId::GROUND) {
        return Vec::new();
    }
    let fixed = wheels.on(LinkId::GROUND);
    let fixed = fixed.flat_map(|wheel| rolling::wheel(scene, wheel, GROUND));
    let outlines = rails(scene).into_iter().chain(stands(scene, wheels));
    let outlines = outlines.chain(fixed).chain(anchors(scene, elastic));
    painted(LinkId::GROUND, GROUND_PLANE, outlines).collect()
}

/// What springs and dampers on the ground are fixed to.
fn anchors(scene: &Scene<'_>, elastic: Option<&Symbols>) -> Vec<(Outline, u8)> {
    let Some(Symbols::Elastic { symbols, .. }) = elastic else {
        return Vec::new();
    };
    let ends = symbols.iter().flat_map(Symbol::spots);
    let on_ground = ends.filter(|end| end.link == LinkId::GROUND);
    let anchors = on_ground.flat_map(|end| {
        let center = place_of(scene.model.axis(end.axis));
        let radius = Measure::fixed(ANCHOR * scene.width);
        let disc = (Outline::Circle { center, radius }, GROUND);
        std::iter::once(disc).chain(eye(center, Measure::fixed(scene.width)))
    });
    anchors.collect()
}

/// Pairs of links of which the first has to be in front of the second: sleeves in front of their guides, barrels in front of piston rods,
/// pins in front of slots.
fn in_front(scene: &Scene<'_>) -> Vec<[LinkId; 2]> {
    let pairs = scene.slides().map(|slide| {
        let [guide, block] = scene.ends(slide);
        if scene.cylinder(slide).is_some() {
            [guide, block]
        } else {
            [block, guide]
        }
    });
    pairs.collect()
}
