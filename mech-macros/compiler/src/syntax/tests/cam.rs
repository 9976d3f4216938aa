//! Cams.

use super::good;
use crate::model::{JointId, JointKind, LinkId};

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
