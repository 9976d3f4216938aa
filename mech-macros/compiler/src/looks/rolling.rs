//! The bodies of wheels, racks and belts.

use super::outline::{Outline, Toothed, fixed};
use super::scene::Scene;
use super::tooth::{Side, rack_teeth, root_radius, tooth};
use super::wheel::{Rack, Wheel, Wheels, angle, hub_on};
use crate::model::{JointKind, LinkId, Measure};
use crate::structure::RollingEnd;
use mech_core::colors::{INK, darker, lighter};
use nalgebra::{Point2, Vector2, distance};
use std::f64::consts::{PI, TAU};

/// The web of a wheel, in parts of the radius at the bottom of its teeth: its edge and its face.
const WEB: [f64; 2] = [0.86, 0.82];
/// Its hub, in widths of a bar, and as the greatest part of that radius.
const HUB: f64 = 1.0;
const MOST_HUB: f64 = 0.45;
/// A wheel whose web would be narrower, in widths of a bar, has none.
const LEAST_WEB: f64 = 1.8;
/// The thickness of a ring outside its teeth, in modules.
const RIM: f64 = 3.0;
/// The groove of a pulley, as a part of its radius.
const GROOVE: f64 = 0.9;
/// The thickness of a belt, in widths of a bar.
const BELT: f64 = 0.3;
/// The back of a rack below its teeth, in modules.
const BACK: f64 = 2.4;

/// The outlines of a wheel in a colour, from back to front.
pub(super) fn wheel(scene: &Scene<'_>, wheel: &Wheel, color: u8) -> Vec<(Outline, u8)> {
    let center = fixed([wheel.center.x, wheel.center.y]);
    let disc = |radius: f64, color: u8| {
        let radius = Measure::fixed(radius);
        (Outline::Circle { center, radius }, color)
    };
    let Some(teeth) = wheel.teeth else {
        let mut all = vec![disc(wheel.radius, darker(color)), disc(GROOVE * wheel.radius, color)];
        all.extend(web(scene, GROOVE * wheel.radius, color, disc));
        return all;
    };
    let toothed = Toothed {
        center: [wheel.center.x, wheel.center.y],
        tooth: tooth(wheel.radius, teeth, wheel.side, wheel.phase),
        count: teeth,
        rim: (wheel.side == Side::Inside).then_some(rim(wheel)),
    };
    let mut all = vec![(Outline::Polygon(toothed.into()), color)];
    if wheel.side == Side::Outside {
        all.extend(web(scene, root_radius(wheel.radius, teeth), color, disc));
    }
    all
}

/// The radius of a ring that has its teeth inside.
pub(super) fn rim(wheel: &Wheel) -> f64 {
    let module = |teeth: u32| 2.0 * wheel.radius / f64::from(teeth);
    wheel.radius + RIM * wheel.teeth.map_or(0.0, module)
}

/// The web and the hub of a wheel that is large enough.
fn web(
    scene: &Scene<'_>,
    root: f64,
    color: u8,
    disc: impl Fn(f64, u8) -> (Outline, u8),
) -> Vec<(Outline, u8)> {
    let hub = (HUB * scene.width).min(MOST_HUB * root);
    if root * WEB[1] - hub < LEAST_WEB * scene.width * 0.5 {
        return Vec::new();
    }
    let [edge, face] = WEB.map(|part| part * root);
    vec![disc(edge, darker(color)), disc(face, lighter(color)), disc(hub, color)]
}

/// A toothed bar, in the frame of its link.
pub(super) fn rack(
    scene: &Scene<'_>,
    wheels: &Wheels,
    rack: &Rack,
    color: u8,
) -> Option<Vec<(Outline, u8)>> {
    let [(RollingEnd::Wheel(pinion_link), _), (RollingEnd::Bar { link, slide, forwards }, _)] =
        rack.rolling.ends
    else {
        return None;
    };
    let JointKind::Prismatic(a, b) = scene.model.joint(slide).kind else {
        return None;
    };
    let line = if forwards { b } else { a };
    let pinion = &wheels.all[rack.pinion];
    let module = 2.0 * pinion.radius / f64::from(pinion.teeth?);
    let pitch = PI * module;
    let start = scene.survey.start();
    let along = start.direction(scene.model, line)?;
    // The bar goes along its line when the pinion turns counter-clockwise, if the radius is positive.
    let out = Vector2::new(along.y, -along.x) * rack.radius.signum();
    let center = start.frame(pinion_link)? * pinion.center;
    let pitch_point = center + out * pinion.radius;
    // The distance of the pitch point beyond a tooth of the pinion, in teeth: a gap of the rack is there.
    let turned = start.frame(pinion_link)?.rotation.angle() + pinion.phase;
    let beyond = (angle(out) - turned) / TAU * f64::from(pinion.teeth?);
    let forwards = rack.radius.signum();
    let at_pitch_point = start.along(scene.model, line, pitch_point)?;
    let first = at_pitch_point - forwards * (beyond.rem_euclid(1.0) + 0.5) * pitch;
    // Where on the bar the pinion comes to.
    let [low, high] = scene.survey.range(|frames| {
        let carrier = frames.frame(rack.rolling.carrier)?;
        let hub = carrier * hub_on(scene, pinion_link, rack.rolling.carrier)?;
        frames.along(scene.model, line, hub)
    })?;
    let teeth = [low - 2.5 * pitch - first, high + 2.5 * pitch - first].map(|reach| reach / pitch);
    if teeth.iter().any(|reach| reach.abs() > 2000.0) {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a few hundred teeth")]
    let [from, to] = [teeth[0].floor() as i32, teeth[1].ceil() as i32];
    let frame = start.frame(link)?.inverse();
    let origin = frame * (start.place(scene.model, line)? + along * first);
    // The pitch line is as far from the bar's line as the pitch point is.
    let depth = (pitch_point - start.place(scene.model, line)?).dot(&out);
    let (along, inwards) = (frame * along, frame * -out);
    let place = |ahead: f64, height: f64| {
        let place = origin + along * ahead - inwards * depth + inwards * height;
        fixed([place.x, place.y])
    };
    let toothed = rack_teeth(module, from, to);
    let mut corners: Vec<_> = toothed.iter().map(|&[ahead, height]| place(ahead, height)).collect();
    let back = -BACK * module;
    let ends = [toothed.last()?[0], toothed.first()?[0]];
    let strip = |height: [f64; 2]| {
        let corners = [
            (ends[0], height[0]),
            (ends[1], height[0]),
            (ends[1], height[1]),
            (ends[0], height[1]),
        ];
        Outline::Polygon(corners.into_iter().map(|(ahead, height)| place(ahead, height)).collect())
    };
    corners.extend(ends.map(|ahead| place(ahead, back)));
    Some(vec![
        (Outline::Polygon(corners.into()), color),
        (strip([back, 0.7 * back]), darker(color)),
    ])
}

/// A belt over two pulleys, on their carrier; none if one pulley is in the other.
pub(super) fn belt(
    scene: &Scene<'_>,
    wheels: &Wheels,
    carrier: LinkId,
    over: [usize; 2],
) -> Option<Vec<(Outline, u8)>> {
    let pulleys = over.map(|number| &wheels.all[number]);
    let [a, b] = [0, 1].map(|end| hub_on(scene, pulleys[end].link, carrier));
    let centers: [Point2<f64>; 2] = [a?, b?];
    let apart = distance(&centers[0], &centers[1]);
    let lean = (pulleys[0].radius - pulleys[1].radius) / apart;
    let is_apart = lean.abs() < 1.0;
    if !is_apart {
        return None;
    }
    let middle = angle(centers[1] - centers[0]);
    let half = lean.acos();
    let touch = |end: usize, direction: f64| {
        let (sin, cos) = direction.sin_cos();
        let place = centers[end] + Vector2::new(cos, sin) * pulleys[end].radius;
        [place.x, place.y]
    };
    let width = BELT * scene.width;
    let strand = |direction: f64| Outline::Line {
        points: [0, 1].map(|end| fixed(touch(end, direction))).into_iter().collect(),
        width: Measure::fixed(width),
    };
    let arc = |end: usize, from: f64, angle: f64| Outline::Arc {
        center: fixed([centers[end].x, centers[end].y]),
        start: fixed(touch(end, from)),
        angle: Measure::fixed(angle),
        width: Measure::fixed(width),
    };
    let outlines = [
        arc(0, middle + half, TAU - 2.0 * half),
        arc(1, middle - half, 2.0 * half),
        strand(middle + half),
        strand(middle - half),
    ];
    Some(outlines.map(|outline| (outline, INK)).to_vec())
}
