//! Gears, belts, racks and cams.

use super::slot::LINKS;
use super::{good, model};
use crate::model::{JointId, JointKind, LinkId, Ratio};

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
        JointKind::Rack { pinion, bar, radius, on } => {
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

const PARTS: &str = "ground { point o = (0, 0); point p = (3, 0); line rail = (0, 0) -> (1, 0); }
    link disk { point o = (0, 0); point e = (1, 0); } link lever { point p = (0, 0); }
    link far { point e = (0, 0); point i = (1, 0); } link own; link last;
    joint s = revolute(ground.o, disk.o); joint f = revolute(ground.p, lever.p);
    joint g = revolute(disk.e, far.e); joint k = slot(far.i, ground.rail);
    joint w = weld(lever, own); joint z = revolute(lever, last) at (0, 0);";

#[test]
fn a_cam_is_a_law_between_two_joints() {
    for text in [
        format!("struct M; {PARTS} joint c = cam(s, f, 0.1 * sin(q)); motor s;"),
        format!("struct M; joint c = cam(s, f, 0.1 * sin(q),); {PARTS} motor s;"),
    ] {
        let model = good(&text).model;
        let (cam, shaft, follower, law) = model.cams().next().expect("a cam");
        assert_eq!((shaft, follower), (JointId::new(0), JointId::new(1)));
        assert_eq!(model.ends(cam), (LinkId::new(1), LinkId::new(2)));
        assert_eq!(law.written, "0.1 * sin(q)");
        assert_eq!(law.at(1.0, &[]), 0.1 * 1.0_f64.sin());
        assert!(matches!(model.joint(cam).kind, JointKind::Cam { .. }));
    }
}

#[test]
fn a_law_goes_on_by_whole_turns_or_not() {
    for (law, winding) in [
        ("sin(q) + 2 * cos(3 * q - 1)", Some(0.0)),
        ("q + 0.1 * sin(q)", Some(1.0)),
        ("2 * q / 3 - q / 6", Some(0.5)),
        ("exp(cos(-q)) / (2 + tan(2 * q))", Some(0.0)),
        ("max(sin(q), 0) * abs(cos(q))", Some(0.0)),
        ("min(q, q + sin(q))", Some(1.0)),
        ("0.3", Some(0.0)),
        ("sin(q / 2)", None),
        ("q * q", None),
        ("q * sin(q)", None),
        ("1 / (q + 5)", None),
        ("abs(q)", None),
        ("max(q, 0)", None),
        ("mod(q, 2 * PI) + mod(q, PI)", Some(0.0)),
        ("atan2(sin(q), 2 + cos(q)) * floor(sin(q))", Some(0.0)),
        ("mod(q, 2)", None),
        ("hypot(q, 1)", None),
    ] {
        let text = format!("struct M; {PARTS} joint c = cam(s, f, {law}); motor s;");
        let model = good(&text).model;
        let (.., found) = model.cams().next().expect("a cam");
        assert_eq!(found.winding(), winding, "{law}");
        // That is what it does.
        for (q, turns) in [(0.3, 1.0), (-1.7, 3.0), (2.0, -2.0)] {
            let on = found.at(q + turns * std::f64::consts::TAU, &[]) - found.at(q, &[]);
            let steady =
                winding.is_some_and(|by| (on - turns * by * std::f64::consts::TAU).abs() < 1e-9);
            assert_eq!(steady, winding.is_some(), "{law}");
        }
    }
}
