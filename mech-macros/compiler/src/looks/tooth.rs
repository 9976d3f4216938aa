//! The outline of a tooth: involute flanks, cut so short that small wheels mesh without undercut.

use std::f64::consts::{PI, TAU};

/// The angle at which flanks press on each other at the pitch circle, in degrees.
const PRESSURE_ANGLE: f64 = 25.0;
/// The height of teeth above the pitch circle, and the depth of gaps below it, in modules.
const ADDENDUM: f64 = 0.7;
const DEDENDUM: f64 = 0.9;
/// The part of a tooth's width that is left free between meshing teeth.
const BACKLASH: f64 = 0.04;
/// Corners of each flank.
const CORNERS: u32 = 5;
/// A tooth is at least this part of its width at the pitch circle wide at its tip.
const TIP: f64 = 0.2;

/// The kind of wheel that a tooth belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// A wheel with its teeth outside.
    Outside,
    /// A ring with its teeth inside: its gaps are the teeth of this outline.
    Inside,
}

/// The corners of a tooth that is symmetric about the direction `phase`, counter-clockwise, as seen from the centre of a wheel with so
/// many teeth and this pitch radius.
pub(super) fn tooth(radius: f64, count: u32, side: Side, phase: f64) -> Vec<[f64; 2]> {
    let module = 2.0 * radius / f64::from(count);
    let [out, deep, play] = match side {
        Side::Outside => [ADDENDUM, DEDENDUM, -BACKLASH],
        // The gap of a ring is as much deeper and wider as the tooth of a wheel is lower and thinner than its gap.
        Side::Inside => [DEDENDUM, ADDENDUM, BACKLASH],
    };
    let pressure = PRESSURE_ANGLE.to_radians();
    let base = radius * pressure.cos();
    let half_pitch = TAU / f64::from(count) / 2.0;
    let at_pitch = 0.5 * half_pitch * (1.0 + play);
    let involute = |angle: f64| angle.tan() - angle;
    let half_width = |at: f64| {
        let flank = (base / at.max(base)).clamp(0.0, 1.0).acos();
        (at_pitch + involute(pressure) - involute(flank)).clamp(0.0, half_pitch)
    };
    let root = (radius - deep * module).max(0.1 * radius);
    // A tooth that would end in a point is cut where it is still blunt.
    let mut tip = radius + out * module;
    while half_width(tip) < TIP * at_pitch && tip > radius {
        tip -= 0.05 * module;
    }
    // Below the base circle there is no involute: the flank goes straight to the root.
    let foot = root.max(base.min(tip));
    let flank = (0..CORNERS).map(|corner| {
        let part = f64::from(corner) / f64::from(CORNERS - 1);
        let at = foot + (tip - foot) * part;
        [at, half_width(at)]
    });
    let straight = (foot > root).then(|| [root, half_width(foot)]);
    let rising: Vec<[f64; 2]> = straight.into_iter().chain(flank).collect();
    let corner = |at: f64, angle: f64| {
        let (sin, cos) = (phase + angle).sin_cos();
        [at * cos, at * sin]
    };
    let up = rising.iter().map(|&[at, angle]| corner(at, -angle));
    let down = rising.iter().rev().map(|&[at, angle]| corner(at, angle));
    up.chain(down).collect()
}

/// The corners of a rack's toothed side, from tooth to tooth: along the rack, and out of its pitch line. A tooth is at the origin.
pub(super) fn rack_teeth(module: f64, first: i32, last: i32) -> Vec<[f64; 2]> {
    let pitch = PI * module;
    let half = 0.25 * pitch * (1.0 - BACKLASH);
    let slope = PRESSURE_ANGLE.to_radians().tan();
    let [out, deep] = [ADDENDUM * module, DEDENDUM * module];
    (first..=last)
        .flat_map(|number| {
            let middle = f64::from(number) * pitch;
            [
                [middle - half - deep * slope, -deep],
                [middle - half + out * slope, out],
                [middle + half - out * slope, out],
                [middle + half + deep * slope, -deep],
            ]
        })
        .collect()
}

/// The radius at the bottom of the gaps.
pub(super) fn root_radius(radius: f64, count: u32) -> f64 {
    radius - DEDENDUM * 2.0 * radius / f64::from(count)
}
