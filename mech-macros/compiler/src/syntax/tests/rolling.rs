//! Gears, belts and racks.

use super::good;
use super::model;
use super::slot::LINKS;
use crate::model::{JointKind, LinkId, Ratio};

/// The joint of this text, between `crank` and `rod`.
fn rolling(text: &str) -> JointKind {
    let parsed = good(&format!("struct M; const A = 2; joint d = {text}; {LINKS}"));
    model::joint(&parsed.model, "d")
}

const CRANK: usize = 1;
const ROD: usize = 2;

#[test]
fn a_gear_has_teeth_or_radii() {
    let ratio = |text: &str| match rolling(&format!("gear(crank, rod, {text})")) {
        JointKind::Gear { a, b, ratio, on } => {
            assert_eq!((a.index(), b.index(), on), (CRANK, ROD, None));
            ratio
        }
        _ => panic!("a gear"),
    };
    assert_eq!(ratio("20 : 40"), Ratio::Teeth(20, 40));
    assert_eq!(ratio("20 : -60"), Ratio::Teeth(20, -60));
    assert_eq!(ratio("-1_000:0x10"), Ratio::Teeth(-1000, 16));
    assert_eq!(ratio("1.5 : 3.0"), Ratio::Radii(1.5, 3.0));
    assert_eq!(ratio("1 : A * 2"), Ratio::Teeth(1, 4));
    assert_eq!(ratio("1.0 : A / 2"), Ratio::Radii(1.0, 1.0));
}

#[test]
fn a_belt_has_teeth_or_radii() {
    let ratio = |text: &str| match rolling(&format!("belt(crank, rod, {text})")) {
        JointKind::Belt { a, b, ratio, on } => {
            assert_eq!((a.index(), b.index(), on), (CRANK, ROD, None));
            ratio
        }
        _ => panic!("a belt"),
    };
    assert_eq!(ratio("20 : 40"), Ratio::Teeth(20, 40));
    assert_eq!(ratio("1.0 : 3.0"), Ratio::Radii(1.0, 3.0));
    assert_eq!(ratio("1 : A,"), Ratio::Teeth(1, 2));
    assert_eq!(ratio("A - 1 : --3"), Ratio::Teeth(1, 3));
}

#[test]
fn a_rack_has_a_radius() {
    let rack = |text: &str| match rolling(&format!("rack(crank, rod, radius {text})")) {
        JointKind::Rack {
            pinion,
            bar,
            radius,
            on,
        } => {
            assert_eq!((pinion.index(), bar.index(), on), (CRANK, ROD, None));
            radius
        }
        _ => panic!("a rack"),
    };
    assert_eq!(rack("0.5"), 0.5);
    assert_eq!(rack("-A / 4"), -0.5);
    assert_eq!(rack("2,"), 2.0);
}

#[test]
fn the_carrier_may_be_named() {
    let carrier = |text: &str| match rolling(text) {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => on,
        _ => panic!("something that rolls"),
    };
    let bare = Some(LinkId::new(3));
    assert_eq!(carrier("gear(crank, rod, 20 : 40 on bare)"), bare);
    assert_eq!(carrier("belt(crank, rod, 1.0 : 1.0 * A on bare,)"), bare);
    assert_eq!(carrier("rack(crank, rod, radius 2 * A on bare)"), bare);
    let ground = Some(LinkId::GROUND);
    assert_eq!(carrier("rack(crank, rod, radius A on ground,)"), ground);
}
