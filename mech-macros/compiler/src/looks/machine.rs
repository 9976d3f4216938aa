//! A machine: every link has a body that is made from what it carries.

use super::Symbols;
use super::body::{Body, Form, body};
use super::cam::{CamBody, cams};
use super::color::Colors;
use super::declared::eye;
use super::ground::{rails, stands};
use super::outline::{Grid, Measure, Outline, Painted, place_of};
use super::planes::{Order, order};
use super::rolling;
use super::scene::Scene;
use super::wheel::Wheels;
use crate::model::{AxisId, LinkId};
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
    let cams = cams(scene);
    let grid = Grid::for_width(scene.width);
    let colors = Colors::new(scene.model);
    let mut all = ground(scene, wheels);
    let links: Vec<LinkId> = scene.bodies().collect();
    let mut forms = vec![Form::Plate; links.len()];
    let make = |forms: &[Form]| -> Vec<Body> {
        let pairs = links.iter().zip(forms);
        pairs
            .map(|(&link, &form)| dressed(scene, wheels, &cams, (link, colors.of(link)), form))
            .collect()
    };
    let before = in_front(scene);
    let mut bodies = make(&forms);
    let mut planes = order(scene, &links, &bodies, &before);
    // A plate that crosses a pin wherever it lies leaves its corners open instead.
    let mut crosses = false;
    for (number, form) in forms.iter_mut().enumerate() {
        if bodies[number].is_plate && planes.conflicts[number] > 0 {
            (*form, crosses) = (Form::Branches, true);
        }
    }
    if crosses {
        let branched = make(&forms);
        let open = order(scene, &links, &branched, &before);
        if open.conflicts.iter().sum::<usize>() < planes.conflicts.iter().sum() {
            (bodies, planes) = (branched, open);
        }
    }
    let plane = |number: usize| plane_of(&planes, number);
    for (number, body) in bodies.into_iter().enumerate() {
        let (link, plane) = (links[number], plane(number));
        all.extend(painted(link, plane, body.outlines));
        all.extend(painted(link, plane + 1, body.top));
    }
    let of_link = |link: LinkId| {
        let number = links.iter().position(|known| *known == link);
        number.map_or(GROUND_PLANE, plane)
    };
    for (pin, plane) in slot_pins(scene, of_link) {
        let axis = scene.model.axis(pin);
        let outlines = eye(place_of(axis), Measure::fixed(scene.width));
        all.extend(painted(axis.link, plane, outlines.to_vec()));
    }
    for (carrier, over) in &wheels.belts {
        let plane = over.map(|wheel| of_link(wheels.all[wheel].link) + 1);
        let outlines = rolling::belt(scene, wheels, *carrier, *over);
        all.extend(painted(
            *carrier,
            plane[0].max(plane[1]),
            outlines.unwrap_or_default(),
        ));
    }
    for painted in &mut all {
        painted.outline = painted.outline.clone().rounded(grid);
    }
    (all, elastic(scene))
}

/// Springs and dampers: they stretch, so they are painted anew in each position.
fn elastic(scene: &Scene<'_>) -> Option<Symbols> {
    let has_pose = |link| scene.survey.at_start(link).is_some();
    let symbols = elastic_symbols(scene.model, scene.structure, has_pose);
    let unit = PIXEL * scene.width;
    (!symbols.is_empty()).then_some(Symbols::Elastic { symbols, unit })
}

/// The pins of slots, each with the plane in which it is seen in its slot.
fn slot_pins(scene: &Scene<'_>, plane_of: impl Fn(LinkId) -> i32) -> Vec<(AxisId, i32)> {
    let slots = scene.slides().filter_map(|slide| {
        let [guide, other] = scene.ends(slide);
        let is_seen = scene.gets_body(other);
        Some((
            slide.pin.filter(|_| is_seen)?,
            plane_of(guide).max(plane_of(other)) + 1,
        ))
    });
    slots.collect()
}

/// The plane of a body: of the number in an order.
fn plane_of(order: &Order, number: usize) -> i32 {
    let rank = i32::try_from(order.ranks[number]).unwrap_or(i32::MAX / 4);
    FIRST_PLANE + 2 * rank
}

fn painted(
    link: LinkId,
    plane: i32,
    outlines: Vec<(Outline, u8)>,
) -> impl Iterator<Item = Painted> {
    outlines.into_iter().map(move |(outline, color)| Painted {
        link,
        plane,
        outline,
        color,
    })
}

/// Stands and rails, and wheels that do not turn.
fn ground(scene: &Scene<'_>, wheels: &Wheels) -> Vec<Painted> {
    if !scene.gets_body(LinkId::GROUND) {
        return Vec::new();
    }
    let fixed = wheels.on(LinkId::GROUND);
    let fixed = fixed.flat_map(|wheel| rolling::wheel(scene, wheel, GROUND));
    let outlines = rails(scene).into_iter().chain(stands(scene, wheels));
    let outlines = outlines.chain(fixed).chain(anchors(scene));
    painted(LinkId::GROUND, GROUND_PLANE, outlines.collect()).collect()
}

/// What springs and dampers on the ground are fixed to.
fn anchors(scene: &Scene<'_>) -> Vec<(Outline, u8)> {
    let Some(Symbols::Elastic { symbols, .. }) = elastic(scene) else {
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

/// A link's body, with its cam disc or its roller.
fn dressed(
    scene: &Scene<'_>,
    wheels: &Wheels,
    cams: &[CamBody],
    (link, color): (LinkId, u8),
    form: Form,
) -> Body {
    let mut body = body(scene, wheels, link, color, form);
    for cam in cams {
        if cam.disc.0 == link {
            let disc = cam.disc_outlines(scene, color);
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
