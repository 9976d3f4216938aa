//! The body of a moving link, made from what it carries.

use super::declared::{FACE, bar, eye};
use super::footprint::Footprint;
use super::hull::hull;
use super::outline::{Outline, fixed};
use super::rolling;
use super::scene::{Mount, Scene};
use super::survey::Slide;
use super::tooth::Side;
use super::wheel::Wheels;
use crate::cancel;
use crate::model::{Axis, LinkId, Measure, Place};
use mech_core::colors::{INK, PAPER, darker, lighter};
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

/// A link of a single pin is a disc, of this radius in widths of a bar.
const DISC: f64 = 0.9;
/// The distance of the lighter inset of a plate from the plate's middle lines, in widths of a bar. An inset smaller than the second number,
/// as a part of the plate, is left out.
const INSET: f64 = 0.75;
const LEAST_INSET: f64 = 0.3;
/// A block: half its length and half its height; a slot: how wide it is, and its cheeks.
const BLOCK: [f64; 2] = [1.3, 0.8];
const SLOT: f64 = 0.62;
const CHEEKS: f64 = 1.5;
/// A guide on a moving link, and a piston rod, as parts of a bar's width.
const ROD: f64 = 0.5;
/// The ring around the pin of a motor: its radius and that of its hole, in widths of a bar.
const MOTOR: [f64; 2] = [0.48, 0.38];
/// A named point without a joint.
const POINT: f64 = 0.2;

/// The form of a link with three or more pins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A plate that fills the corners between its pins.
    Plate,
    /// Bars from pin to pin.
    Branches,
}

/// A link's body: outlines and their colours from back to front, and what it covers.
#[derive(Clone, Default)]
pub(super) struct Body {
    pub(super) outlines: Vec<(Outline, u8)>,
    /// The outlines above all bodies of its plane, such as eyes and marks.
    pub(super) top: Vec<(Outline, u8)>,
    pub(super) footprint: Footprint,
    /// The nearest plane of the link's own shapes.
    pub(super) over: i32,
    /// Whether another form would look otherwise.
    pub(super) is_plate: bool,
}

/// Makes the body of a link.
pub(super) struct Builder<'a, 's> {
    scene: &'a Scene<'s>,
    link: LinkId,
    color: u8,
    body: Body,
}

/// The body of a link in a colour.
pub(super) fn body(
    scene: &Scene<'_>,
    wheels: &Wheels,
    link: LinkId,
    color: u8,
    form: Form,
) -> Body {
    let mut builder = Builder { scene, link, color, body: Body::default() };
    let mounts = scene.mounts(link);
    let planes = scene.model.link(link).shapes.iter().map(|shape| shape.plane);
    builder.body.over = planes.max().unwrap_or(i32::MIN);
    if scene.is_drawn(link) {
        builder.wheels(wheels, Side::Outside);
        builder.wheels(wheels, Side::Inside);
        builder.racks(wheels);
        for mount in mounts.iter().filter(|mount| mount.is_joint) {
            builder.mount(mount);
        }
        return builder.body;
    }
    builder.wheels(wheels, Side::Outside);
    builder.guides(mounts);
    builder.bars(wheels, mounts, form);
    builder.slots();
    builder.wheels(wheels, Side::Inside);
    if !builder.racks(wheels) {
        builder.blocks();
    }
    if builder.body.footprint.is_empty()
        && let Some(mount) = mounts.first()
    {
        builder.disc(mount.at, DISC * scene.width);
    }
    for mount in mounts {
        builder.mount(mount);
    }
    builder.body
}

impl Builder<'_, '_> {
    fn width(&self) -> Measure {
        Measure::fixed(self.scene.width)
    }

    fn paint(&mut self, outline: Outline, color: u8) {
        self.body.outlines.push((outline, color));
    }

    fn disc(&mut self, center: Point2<f64>, radius: f64) {
        for (share, color) in [(1.0, darker(self.color)), (FACE, self.color)] {
            let outline = Outline::Circle {
                center: fixed([center.x, center.y]),
                radius: Measure::fixed(radius * share),
            };
            self.paint(outline, color);
        }
        self.body.footprint.add_disc(center, radius);
    }

    /// Adds the wheels of the link with teeth on this side, unless the link's own shapes show them.
    fn wheels(&mut self, wheels: &Wheels, side: Side) {
        let own = wheels.on(self.link).filter(|wheel| wheel.side == side);
        for wheel in own.filter(|wheel| !wheel.is_drawn(self.scene)) {
            let outlines = rolling::wheel(self.scene, wheel, self.color);
            self.body.outlines.extend(outlines);
            if side == Side::Outside {
                self.body.footprint.add_disc(wheel.center, wheel.radius);
            }
        }
    }

    /// A bar, a plate or branches between the pins that are not within a wheel.
    fn bars(&mut self, wheels: &Wheels, mounts: &[Mount], form: Form) {
        let within = |mount: &&Mount| {
            wheels.on(self.link).any(|wheel| {
                let away = (mount.at - wheel.center).norm();
                away > 0.1 * self.scene.width && away < wheel.radius
            })
        };
        let outside: Vec<&Mount> = mounts.iter().filter(|mount| !within(mount)).collect();
        let blocks = self.block_places();
        let mut points: Vec<Point2<f64>> = outside.iter().map(|mount| mount.at).collect();
        let mut places: Vec<Place> = outside.iter().map(|mount| mount.place).collect();
        for place in blocks {
            let at = Point2::from(place.map(Measure::at_start));
            if points.iter().all(|point| (point - at).norm() > 0.5 * self.scene.width) {
                points.push(at);
                places.push(place);
            }
        }
        match points.len() {
            0 | 1 => {}
            2 => self.bar([0, 1], &points, &places),
            _ => self.many(wheels, &points, &places, form),
        }
    }

    fn bar(&mut self, ends: [usize; 2], points: &[Point2<f64>], places: &[Place]) {
        // Its eyes come when all of the body is painted.
        let pins = ends.map(|end| places[end]);
        let lines = bar(&pins, self.width(), self.color).into_iter().take(2);
        self.body.outlines.extend(lines);
        self.body.footprint.add_bar(ends.map(|end| points[end]), self.scene.width);
    }

    fn many(&mut self, wheels: &Wheels, points: &[Point2<f64>], places: &[Place], form: Form) {
        let varies = places.iter().flatten().any(|measure| measure.formula.is_some());
        let corners = hull(points, 0.6 * self.scene.width);
        if corners.is_empty() || varies || form == Form::Branches {
            self.body.is_plate = !corners.is_empty() && !varies && form == Form::Plate;
            for ends in branches(points) {
                self.bar(ends, points, places);
            }
            return;
        }
        self.body.is_plate = true;
        // A ring is open: what meshes within it is seen.
        let hole = wheels.on(self.link).find(|wheel| wheel.side == Side::Inside);
        let hole = hole.map(|wheel| (wheel.center, rolling::rim(wheel)));
        let mut around: Vec<Place> = corners.iter().map(|&corner| places[corner]).collect();
        let filled = Outline::Polygon(with_hole(around.clone(), hole).into());
        around.push(around[0]);
        for (share, color) in [(1.0, darker(self.color)), (FACE, self.color)] {
            let edge =
                Outline::Line { points: around.clone().into(), width: self.width().times(share) };
            self.paint(edge, color);
        }
        self.paint(filled, self.color);
        let corners: Vec<Point2<f64>> = corners.iter().map(|&corner| points[corner]).collect();
        if let Some(inset) = inset(&corners, INSET * self.scene.width) {
            self.paint(Outline::Polygon(with_hole(inset, hole).into()), lighter(self.color));
        }
        self.body.footprint.add_plate(corners, self.scene.width);
        if let Some((center, radius)) = hole {
            self.body.footprint.add_hole(center, radius);
        }
    }

    /// The prismatic joints and slots of a link: whether it is the one that guides.
    fn slides(&self, guides: bool) -> Vec<Slide> {
        let slides = self.scene.slides_of(self.link).filter(|slide| {
            let [guide, block] = self.scene.ends(*slide);
            let own = if guides { guide } else { block };
            own == self.link && guide != LinkId::GROUND || !guides && block == self.link
        });
        slides.filter(|slide| guides || slide.pin.is_none()).collect()
    }

    /// Where the blocks of this link are on it.
    fn block_places(&self) -> Vec<Place> {
        let slides = self.slides(false).into_iter();
        let blocks = slides.filter(|slide| self.scene.cylinder(*slide).is_none());
        let places = blocks.map(|slide| self.scene.model.axis(slide.block).place());
        places.collect()
    }

    /// The openings of its slots, which nothing of the link covers.
    fn slots(&mut self) {
        for slide in self.slides(true) {
            let Some(travel) = self.scene.travel(slide).filter(|_| slide.pin.is_some()) else {
                continue;
            };
            let line = self.scene.model.axis(slide.guide);
            let (at, along) = (Point2::from(line.at), Vector2::from(line.direction));
            let ends = travel.map(|offset| at + along * offset);
            let width = self.scene.width;
            self.line(ends, SLOT * width + 0.2 * width, darker(self.color));
            self.line(ends, SLOT * width, PAPER);
        }
    }

    /// The cheeks of slots, barrels and guides.
    fn guides(&mut self, mounts: &[Mount]) {
        for slide in self.slides(true) {
            let Some([low, high]) = self.scene.travel(slide) else {
                continue;
            };
            let line = self.scene.model.axis(slide.guide);
            let (at, along) = (Point2::from(line.at), Vector2::from(line.direction));
            let place = |offset: f64| at + along * offset;
            let width = self.scene.width;
            if slide.pin.is_some() {
                let ends = [place(low), place(high)];
                self.rod(ends, CHEEKS * width, self.color);
                self.reach_mounts(ends, mounts);
                continue;
            }
            if let Some(cylinder) = self.scene.cylinder(slide) {
                self.barrel(cylinder.barrel.map(place), CHEEKS * width);
                continue;
            }
            let ends = [place(low - BLOCK[0] * width), place(high + BLOCK[0] * width)];
            self.rod(ends, ROD * width, self.color);
            self.reach_mounts(ends, mounts);
        }
    }

    /// A cylinder's barrel.
    fn barrel(&mut self, ends: [Point2<f64>; 2], width: f64) {
        let along = (ends[1] - ends[0]).normalize();
        let across = Vector2::new(-along.y, along.x) * (0.5 * width);
        for (share, color) in [(1.0, darker(self.color)), (FACE, self.color)] {
            let half = across * share;
            let short = along * (0.5 * width * (1.0 - share));
            let corners = [
                ends[0] + half + short,
                ends[0] - half + short,
                ends[1] - half - short,
                ends[1] + half - short,
            ];
            self.paint(polygon(&corners), color);
        }
        self.body.footprint.add_bar(ends, width);
    }

    /// A bar without eyes.
    fn rod(&mut self, ends: [Point2<f64>; 2], width: f64, color: u8) {
        self.line(ends, width, darker(color));
        self.line(ends, width * FACE, color);
        self.body.footprint.add_bar(ends, width);
    }

    fn line(&mut self, ends: [Point2<f64>; 2], width: f64, color: u8) {
        let points = ends.map(|end| fixed([end.x, end.y])).to_vec();
        let width = Measure::fixed(width);
        self.paint(Outline::Line { points: points.into(), width }, color);
    }

    /// Joins a guide with the pins of its link.
    fn reach_mounts(&mut self, ends: [Point2<f64>; 2], mounts: &[Mount]) {
        let nearest = mounts.iter().map(|mount| {
            let along = ends[1] - ends[0];
            let part =
                (mount.at - ends[0]).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
            (mount.at, ends[0] + along * part.clamp(0.0, 1.0))
        });
        let apart = nearest.min_by(|a, b| (a.0 - a.1).norm().total_cmp(&(b.0 - b.1).norm()));
        if let Some((mount, foot)) = apart
            && (mount - foot).norm() > 0.3 * self.scene.width
        {
            self.rod([mount, foot], self.scene.width, self.color);
        }
    }

    /// Its toothed bars; whether it has any.
    fn racks(&mut self, wheels: &Wheels) -> bool {
        let racks = wheels.racks_on(self.link);
        let racks = racks.filter_map(|rack| rolling::rack(self.scene, wheels, rack, self.color));
        let outlines: Vec<_> = racks.flatten().collect();
        let has_racks = !outlines.is_empty();
        self.body.outlines.extend(outlines);
        has_racks
    }

    /// Adds the blocks and piston rods.
    fn blocks(&mut self) {
        for slide in self.slides(false) {
            let line = self.scene.model.axis(slide.block);
            if let Some(cylinder) = self.scene.cylinder(slide) {
                let (at, along) = (Point2::from(line.at), Vector2::from(line.direction));
                let ends = cylinder.rod.map(|offset| at + along * offset);
                self.rod(ends, ROD * self.scene.width, self.color);
            } else {
                self.block(line);
            }
        }
    }

    fn block(&mut self, line: &Axis) {
        let (at, along) = (Point2::from(line.at), Vector2::from(line.direction));
        let across = Vector2::new(-along.y, along.x);
        let edge = 0.12;
        for (inset, color) in [(0.0, darker(self.color)), (edge, self.color)] {
            let [length, height] = BLOCK.map(|half| (half - inset) * self.scene.width);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let corners = corners.map(|(x, y)| at + along * (x * length) + across * (y * height));
            self.paint(polygon(&corners), color);
        }
        let half = along * ((BLOCK[0] - BLOCK[1]) * self.scene.width);
        self.body.footprint.add_bar([at - half, at + half], 2.0 * BLOCK[1] * self.scene.width);
    }

    /// The eye of a pin, or the mark of a point; around the pin of a motor a ring.
    fn mount(&mut self, mount: &Mount) {
        let center = mount.place;
        if !mount.is_joint {
            let radius = self.width().times(POINT);
            self.body.top.push((Outline::Circle { center, radius }, INK));
            return;
        }
        if self.scene.is_driven(self.link, mount.at) {
            let [radius, hole] = MOTOR.map(|share| self.width().times(share));
            let ring = Outline::Ring { center, radius, hole };
            self.body.top.push((ring, INK));
        }
        if !self.scene.has_eye(self.link, mount.at) {
            self.body.top.extend(eye(center, self.width()));
        }
    }
}

fn polygon(corners: &[Point2<f64>]) -> Outline {
    Outline::Polygon(corners.iter().map(|corner| fixed([corner.x, corner.y])).collect())
}

/// The corners of a polygon with a round hole, if it has one: a line leads to the hole and back, so that it is one polygon.
fn with_hole(mut corners: Vec<Place>, hole: Option<(Point2<f64>, f64)>) -> Vec<Place> {
    /// So many corners look round.
    const CORNERS: u32 = 72;
    if let Some((center, radius)) = hole {
        let first = corners[0];
        let turned = |number: u32| f64::from(number % CORNERS) * -TAU / f64::from(CORNERS);
        let around = (0..=CORNERS).map(turned).map(|angle| {
            let place = center + Rotation2::new(angle) * Vector2::x() * radius;
            fixed([place.x, place.y])
        });
        corners.push(first);
        corners.extend(around);
    }
    corners
}

/// The shortest lines that join all points: a tree.
fn branches(points: &[Point2<f64>]) -> Vec<[usize; 2]> {
    let length = |a: usize, b: usize| (points[a] - points[b]).norm();
    // For each point that is free yet the nearest of the others, and how far that is.
    let mut free: Vec<(usize, usize, f64)> =
        (1..points.len()).map(|point| (point, 0, length(0, point))).collect();
    let mut lines = Vec::new();
    while let Some(next) = (0..free.len()).min_by(|a, b| free[*a].2.total_cmp(&free[*b].2)) {
        cancel::check();
        let (point, known, _) = free.remove(next);
        lines.push([known, point]);
        for (other, nearest, away) in &mut free {
            let length = length(point, *other);
            if length.total_cmp(away).is_lt() {
                (*nearest, *away) = (point, length);
            }
        }
    }
    lines
}

/// A smaller polygon in the middle of a convex one; none if there is no room.
fn inset(corners: &[Point2<f64>], by: f64) -> Option<Vec<Place>> {
    #[expect(clippy::cast_precision_loss, reason = "a few corners")]
    let share = 1.0 / corners.len() as f64;
    let middle = corners.iter().fold(Vector2::zeros(), |sum, corner| sum + corner.coords * share);
    let middle = Point2::from(middle);
    let room = super::hull::depth(corners, middle);
    let scale = 1.0 - by / room;
    (scale > LEAST_INSET).then(|| {
        let inner = corners.iter().map(|corner| middle + (corner - middle) * scale);
        inner.map(|corner| fixed([corner.x, corner.y])).collect()
    })
}
