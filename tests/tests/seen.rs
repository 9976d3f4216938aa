//! What is declared is seen: at the start every pin, slot, wheel and rack has places at which nothing lies over it.

use crate::looks::{compiled, covers, frame};
use mech_compiler::model::{JointId, JointKind, LinkId, Model, Shape, ShapeKind};
use mech_compiler::structure::{Pin, Rolling};
use mech_compiler::{Compiled, Looks, Measure, Outline, Painted, Place, compile, looks};
use mech_runtime::Palette;
use mech_test_support::{Sample, for_all, samples};
use nalgebra::Point2;
use std::f64::consts::TAU;

/// What is painted of a mechanism at its start.
struct Picture<'m> {
    model: &'m Model,
    compiled: &'m Compiled,
    looks: &'m Looks,
}

impl Picture<'_> {
    /// A place of a link in the scene.
    fn place(&self, link: LinkId, [x, y]: [f64; 2]) -> Option<Point2<f64>> {
        let poses = &self.compiled.program.start.poses;
        Some(frame(self.compiled, poses, link)? * Point2::new(x, y))
    }

    /// Whether an outline covers a place of the scene.
    fn is_over(&self, painted: &Painted, place: Point2<f64>) -> bool {
        let poses = &self.compiled.program.start.poses;
        let Some(frame) = frame(self.compiled, poses, painted.link) else {
            return false;
        };
        let own = frame.inverse() * place;
        match &painted.outline {
            Outline::Toothed(wheel) => {
                let corners = wheel.corners().into_iter();
                let corners = corners.map(|corner| corner.map(measure)).collect();
                let outline = Outline::Polygon(corners);
                covers(
                    &Painted {
                        outline,
                        ..painted.clone()
                    },
                    own,
                )
            }
            Outline::Ring {
                center,
                radius,
                hole,
            } => {
                let away = (own - Point2::from(center.map(Measure::at_start))).norm();
                away < radius.at_start() && away > hole.at_start()
            }
            _ => covers(painted, own),
        }
    }

    /// Whether one of these outlines is in front of all others at one of these places.
    fn is_seen(&self, numbers: &[usize], places: &[Point2<f64>]) -> bool {
        places.iter().any(|place| {
            let mut all = self.looks.painted.iter().enumerate().rev();
            let front = all.find(|(_, painted)| self.is_over(painted, *place));
            front.is_some_and(|(number, _)| numbers.contains(&number))
        })
    }

    /// The numbers of outlines of a kind.
    fn numbers(&self, is: impl Fn(&Painted) -> bool) -> Vec<usize> {
        let all = self.looks.painted.iter().enumerate();
        all.filter(|(_, painted)| is(painted))
            .map(|(number, _)| number)
            .collect()
    }
}

/// A number that depends on no param.
fn measure(value: f64) -> Measure {
    Measure {
        value,
        formula: None,
        share: 1.0,
    }
}

/// Places in a disc.
fn disc(center: Point2<f64>, radius: f64) -> Vec<Point2<f64>> {
    let around = (0..32).map(|number| {
        let (sin, cos) = (f64::from(number) * TAU / 16.0).sin_cos();
        let part = if number < 16 { 0.45 } else { 0.95 };
        center + part * radius * nalgebra::Vector2::new(cos, sin)
    });
    around.chain([center]).collect()
}

/// What is declared and not seen, in words.
fn hidden(model: &Model, compiled: &Compiled, looks: &Looks) -> Vec<String> {
    let picture = Picture {
        model,
        compiled,
        looks,
    };
    let pins = compiled.structure.pins.iter().enumerate();
    let pins = pins.filter(|(_, pin)| !picture.shows_pin(pin));
    let pins = pins.map(|(number, _)| format!("pin {number}"));
    let joints = model
        .joint_ids()
        .filter(|&joint| !picture.shows_joint(joint));
    pins.chain(joints.map(|joint| format!("joint {}", model.joint(joint).name)))
        .collect()
}

impl Picture<'_> {
    /// Whether the eye of a pin is seen.
    fn shows_pin(&self, pin: &Pin) -> bool {
        let seen = pin
            .members
            .iter()
            .filter(|member| self.model.link(member.0).die.is_none());
        let place = seen
            .clone()
            .find_map(|&(link, axis)| self.place(link, self.model.axis(axis).at));
        let Some(place) = place else { return true };
        let eye = |painted: &Painted| match &painted.outline {
            Outline::Circle { center, radius }
                if [Palette::INK, Palette::EYE].contains(&painted.color) =>
            {
                let center = self.place(painted.link, center.map(Measure::at_start));
                center.filter(|center| (center - place).norm() < 1e-3 * radius.at_start())?;
                Some(radius.at_start())
            }
            _ => None,
        };
        let numbers = self.numbers(|painted| eye(painted).is_some());
        let radius = self
            .looks
            .painted
            .iter()
            .filter_map(eye)
            .fold(0.0, f64::max);
        self.is_seen(&numbers, &disc(place, radius))
    }

    /// Whether a slot, and the wheels or the bar of a gear, belt or rack, are seen.
    fn shows_joint(&self, joint: JointId) -> bool {
        match self.model.joint(joint).kind {
            JointKind::Prismatic(..) => {
                let Some([guide, block]) = self.model.guide_and_block(joint) else {
                    return true;
                };
                let [guide, block] = [guide, block].map(|axis| self.model.axis(axis).link);
                self.model.link(block).die.is_none() || self.shows_slot(guide)
            }
            JointKind::Gear { .. } | JointKind::Rack { .. } => {
                let own = |rolling: &&Rolling| rolling.joint == joint;
                let rolling = self.compiled.structure.rollings.iter().find(own);
                rolling.is_none_or(|rolling| {
                    rolling
                        .ends
                        .iter()
                        .all(|(end, _)| self.shows_teeth(end.link()))
                })
            }
            _ => true,
        }
    }

    /// Whether all openings of slots of a link are seen, or its rails.
    fn shows_slot(&self, link: LinkId) -> bool {
        let open = self.numbers(|painted| {
            let is_opening =
                matches!(painted.outline, Outline::Line { .. }) && painted.color == Palette::PAPER;
            painted.link == link && (is_opening || link == LinkId::GROUND)
        });
        !open.is_empty() && open.iter().all(|&number| self.shows(number))
    }

    /// Whether something toothed of a link is seen.
    fn shows_teeth(&self, link: LinkId) -> bool {
        let teeth = self.numbers(|painted| {
            let corners = match &painted.outline {
                Outline::Toothed(_) => usize::MAX,
                Outline::Polygon(corners) => corners.len(),
                // Without teeth: the edge of a pulley.
                Outline::Circle { .. } => 20,
                _ => 0,
            };
            painted.link == link && corners >= 20
        });
        teeth.iter().any(|&number| self.shows(number))
    }

    /// Whether an outline is in front of all others somewhere.
    fn shows(&self, number: usize) -> bool {
        let painted = &self.looks.painted[number];
        let at_start = |places: &[Place]| {
            places
                .iter()
                .map(|place| place.map(Measure::at_start))
                .collect()
        };
        let corners: Vec<[f64; 2]> = match &painted.outline {
            Outline::Toothed(wheel) => wheel.corners(),
            Outline::Polygon(corners) => at_start(corners),
            Outline::Line { points, .. } => at_start(points),
            Outline::Circle { center, radius } => {
                let [x, y] = center.map(Measure::at_start);
                disc(Point2::new(x, y), radius.at_start())
                    .into_iter()
                    .map(Into::into)
                    .collect()
            }
            _ => return true,
        };
        // Between each corner and one a few farther on is mostly a place that is within.
        let pairs = (1..6).flat_map(|ahead| corners.iter().zip(corners.iter().cycle().skip(ahead)));
        let within = pairs.flat_map(|(a, b)| {
            (0..=8).map(move |part| {
                let part = f64::from(part) / 8.0;
                [0, 1].map(|axis| a[axis] + part * (b[axis] - a[axis]))
            })
        });
        let places = within.filter_map(|place| self.place(painted.link, place));
        self.is_seen(&[number], &places.collect::<Vec<_>>())
    }
}

/// The kinds of what hid something once.
const TEXTS: [&str; 7] = [
    // A plate with a ring, over the pinion on the ground.
    "struct Wankel; ground { point o = (0, 0); } link shaft { point o = (0, 0); point e = (1, 0); }
    link rotor { point c = (0, 0); point p = (7, 0); point q = (7, 0) turned 120 deg; point r = (7, 0) turned 240 deg; }
    joint a = revolute(ground.o, shaft.o); joint b = revolute(shaft.e, rotor.c); joint m = gear(ground, rotor, 20 : -30); motor a;",
    // A shape on one link.
    "struct Shape; link crank { circle (0, 1) radius 0.3; } link b; joint a = revolute(ground, crank) at (0, 0);
    joint c = revolute(crank, b) at (0, 1); motor a; motor c;",
    "struct Plate; link crank; link coupler { polygon [(0.5, 0.5), (3.6, 2.5), (3.4, 3.3), (0.4, 0.9)]; } link rocker;
    joint a = revolute(ground, crank) at (0, 0); joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9); joint d = revolute(ground, rocker) at (4, 0); motor a;",
    // A bar along its own slot.
    "struct Shaper; link crank; link lever; link rod; link ram; joint a = revolute(ground, crank) at (0, 0);
    joint b = slot(crank, lever) at (1, 0) along (1, 3); joint c = revolute(ground, lever) at (0, -3);
    joint d = revolute(lever, rod) at (1.581, 1.743); joint r = revolute(rod, ram) at (3.36, 3.5);
    joint x = prismatic(ground, ram) at (3.36, 3.5) along (1, 0); motor a;",
    // A rack on the ground.
    "struct Truck; link cart; link wheel; joint x = prismatic(ground, cart) at (0, 0) along (1, 0);
    joint w = revolute(cart, wheel) at (0, 1); joint r = rack(wheel, ground, radius 1); motor x in -3 ..= 3;",
    "struct Lift; link mast; link pinion; link fork { polygon [(2, 0), (3, 0), (3, 1)]; }
    joint x = prismatic(ground, mast) at (0, 0) along (0, 1); joint w = revolute(mast, pinion) at (0.5, 0);
    joint y = prismatic(mast, fork) at (2, 0) along (0, 1); joint r = rack(pinion, ground, radius 0.5);
    joint s = rack(pinion, fork, radius -0.5); motor x in 0 ..= 3;",
    // A cylinder.
    "struct Boom; link boom { point tip = (0, 4); } link barrel; link rod; joint o = revolute(ground, boom) at (0, 0);
    joint g = revolute(ground, barrel) at (3, 0); joint s = prismatic(barrel, rod) at (1.5, 2) along (-3, 4);
    joint c = revolute(rod, boom) at (0, 4); motor s;",
];

#[test]
fn what_is_declared_is_seen() {
    for text in TEXTS {
        let (model, compiled, looks) = compiled(text);
        let hidden = hidden(&model, &compiled, &looks);
        assert!(hidden.is_empty(), "{hidden:?} in {text}");
    }
}

/// Bodies may lie over each other however they are ordered. A shape that comes to a link hides nothing that was seen, unless it lies over it.
#[test]
fn shapes_hide_nothing_else() {
    let (mut seen, mut all) = (0, 0);
    for_all(60, &samples(1..6), |Sample { grown, mut dice }: Sample| {
        let mut model = grown.model;
        let Ok(compiled) = compile(&model) else {
            return;
        };
        model.look = None;
        let before = hidden(&model, &compiled, &looks(&model, &compiled));
        let links: Vec<LinkId> = model.declared_links().collect();
        let link = links[dice.below(links.len())];
        let center = [0, 1].map(|_| 40.0 * model.size() * dice.between(1.0, 2.0));
        let radius = 0.1 * model.size();
        let shape = Shape {
            origin: model.link(link).origin,
            kind: ShapeKind::Circle { center, radius },
            plane: 0,
            color: Palette::RED,
            formulas: vec![None; 3],
        };
        let mut shaped = model.clone();
        shaped.links[link.index()].shapes.push(shape);
        let after = hidden(&shaped, &compiled, &looks(&shaped, &compiled));
        assert_eq!(before, after);
        (seen, all) = (seen + usize::from(before.is_empty()), all + 1);
    });
    println!("everything is seen in {seen} of {all}");
    assert!(all > 20 && 10 * seen >= 9 * all, "{seen} of {all}");
}
