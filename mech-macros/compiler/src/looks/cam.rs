//! Cam discs, from the laws of their followers.

use super::outline::{Outline, fixed};
use super::scene::Scene;
use crate::model::{AxisId, JointId, JointKind, Law, LinkId, Measure, Place};
use mech_core::colors::{EYE, INK, darker, lighter};
use nalgebra::{Isometry2, Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

/// Corners of a disc.
const CORNERS: u32 = 120;
/// The radius of a follower's roller, in widths of a bar.
const ROLLER: f64 = 0.6;
/// A disc that is thinner somewhere, in widths of a bar, is not drawn.
const THINNEST: f64 = 0.7;

/// The body of a cam: the disc, and the roller that runs on it, each on its link.
pub(super) struct CamBody {
    pub(super) disc: (LinkId, Vec<Place>),
    pub(super) roller: (LinkId, Point2<f64>, f64),
}

/// The cams that turn about a shaft and whose laws come back to where they began.
pub(super) fn cams(scene: &Scene<'_>) -> Vec<CamBody> {
    let cams = scene.model.cams();
    cams.filter_map(|(id, shaft, follower, law)| cam(scene, id, [shaft, follower], law)).collect()
}

fn cam(
    scene: &Scene<'_>,
    id: JointId,
    [shaft, follower]: [JointId; 2],
    law: &Law,
) -> Option<CamBody> {
    let model = scene.model;
    let roller = model.roller_of(id);
    let carrier = model.carrier_of_cam(shaft, follower)?;
    if law.winding() != Some(0.0) {
        return None;
    }
    let JointKind::Revolute(a, b) = model.joint(shaft).kind else {
        return None;
    };
    let (own, forwards) = model.beside(shaft, carrier)?;
    let cam_link = model.axis(own).link;
    let start = scene.survey.start();
    let center = start.place(model, own)?;
    let declared = roller.map(|roller| roller.point);
    let (link, point, motion) = follower_motion(scene, follower, carrier, (center, declared))?;
    let first = start_value(scene, [a, b])?;
    let at_start = model.at_start(law, first);
    // Seen from the cam, the follower goes round it the other way.
    let pitch = |turned: f64| {
        let value = model.at_start(law, first + turned);
        let offset = motion(value - at_start) * point - center;
        Rotation2::new(-forwards * turned) * offset
    };
    let radius = roller.map_or(ROLLER * scene.width, |roller| roller.radius);
    let frame: Isometry2<f64> = start.frame(cam_link)?.inverse();
    let step = TAU / f64::from(CORNERS);
    let mut corners = Vec::new();
    for number in 0..CORNERS {
        let turned = f64::from(number) * step;
        let (here, ahead) = (pitch(turned), pitch(turned + 1e-4) - pitch(turned - 1e-4));
        // The curve goes clockwise about the cam if the shaft turns forwards: the cam is inside of it.
        let normal = Vector2::new(-ahead.y, ahead.x).normalize();
        let inwards = if normal.dot(&here) > 0.0 { -normal } else { normal };
        let edge = here + inwards * radius;
        let is_thick = edge.norm() > THINNEST * scene.width;
        if !is_thick {
            return None;
        }
        let place = frame * (center + edge);
        corners.push(fixed([place.x, place.y]));
    }
    let roller = start.frame(link)?.inverse() * point;
    Some(CamBody { disc: (cam_link, corners), roller: (link, roller, radius) })
}

/// The angle from one axis to another at the start.
fn start_value(scene: &Scene<'_>, axes: [AxisId; 2]) -> Option<f64> {
    let start = scene.survey.start();
    let [a, b] = axes.map(|axis| start.direction(scene.model, axis));
    let (a, b) = (a?, b?);
    Some(a.perp(&b).atan2(a.dot(&b)))
}

/// A follower: its link, the middle of its roller in the scene at the start, and how it moves by its coordinate. A roller that was not
/// declared is at the point that is nearest to the cam.
type Follower = (LinkId, Point2<f64>, Box<dyn Fn(f64) -> Isometry2<f64>>);

fn follower_motion(
    scene: &Scene<'_>,
    joint: JointId,
    carrier: LinkId,
    (center, declared): (Point2<f64>, Option<AxisId>),
) -> Option<Follower> {
    let model = scene.model;
    let start = scene.survey.start();
    let [from, _] = model.joint(joint).kind.axes()?;
    let (own, forwards) = model.beside(joint, carrier)?;
    let link = model.axis(own).link;
    let frame = start.frame(link)?;
    let pivot = start.place(model, own)?;
    let slides = matches!(model.joint(joint).kind, JointKind::Prismatic(..));
    let points = scene.mounts(link).iter().map(|mount| frame * mount.at);
    let points = points.filter(|point| slides || (point - pivot).norm() > 1e-6 * scene.width);
    let points = points.chain(slides.then_some(pivot));
    let nearest = points.min_by(|a, b| (a - center).norm().total_cmp(&(b - center).norm()));
    let roller = match declared {
        Some(point) => start.place(model, point)?,
        None => nearest?,
    };
    let along = start.direction(model, from)? * forwards;
    let motion = move |value: f64| {
        if slides {
            Isometry2::translation(along.x * value, along.y * value)
        } else {
            let turn = Isometry2::rotation(forwards * value);
            let shift = pivot - turn * pivot;
            Isometry2::translation(shift.x, shift.y) * turn
        }
    };
    Some((link, roller, Box::new(motion)))
}

impl CamBody {
    /// The outlines of the disc in a colour.
    pub(super) fn disc_outlines(&self, scene: &Scene<'_>, color: u8) -> Vec<(Outline, u8)> {
        let corners = self.disc.1.clone();
        let mut edge = corners.clone();
        edge.extend(corners.first().copied());
        let line = Outline::Line { points: edge.into(), width: Measure::fixed(0.16 * scene.width) };
        vec![(Outline::Polygon(corners.into()), color), (line, darker(color))]
    }

    /// The middle of the disc, and the radius of a circle within it.
    pub(super) fn extent(&self) -> (Point2<f64>, f64) {
        let corners = self.disc.1.iter().map(|place| Point2::from(place.map(Measure::at_start)));
        let corners: Vec<Point2<f64>> = corners.collect();
        let sum = corners.iter().fold(Vector2::zeros(), |sum, corner| sum + corner.coords);
        let middle = Point2::from(sum / f64::from(CORNERS));
        let away = corners.iter().map(|corner| (corner - middle).norm());
        (middle, away.fold(f64::INFINITY, f64::min))
    }

    /// The outlines of the roller in a colour.
    pub(super) fn roller_outlines(&self, color: u8) -> Vec<(Outline, u8)> {
        let (_, center, radius) = self.roller;
        let disc = |share: f64, color: u8| {
            let center = fixed([center.x, center.y]);
            let radius = Measure::fixed(share * radius);
            (Outline::Circle { center, radius }, color)
        };
        vec![disc(1.0, darker(color)), disc(0.8, lighter(color)), disc(0.36, INK), disc(0.16, EYE)]
    }
}
