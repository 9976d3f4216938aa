//! Parts, and their uses.

use super::good;
use crate::model::{JointKind, LinkId};

/// A crank that a port carries, and a point on the port.
const ARM: &str = "part Arm(reach = 1) {
    port frame { point o = (2, 0); }
    link bar { point o = (0, 0); point tip = (reach, 1); }
    joint pin = revolute(frame.o, bar.o);
    start { pin = 30 deg; bar near 10 deg; }
}";

/// A mechanism that uses it, before what follows.
fn arms(uses: &str) -> String {
    format!("struct M;\n{ARM}\n{uses}")
}

#[test]
fn instances_have_paths() {
    let parsed = good(&arms(
        "use left[2]: Arm { frame = ground }; use right: Arm(reach = 3) { frame = left[1].bar };",
    ));
    let model = parsed.model;
    let links: Vec<&str> = model.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links, ["ground", "left[0].bar", "left[1].bar", "right.bar"]);
    let joints: Vec<&str> = model.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(joints, ["left[0].pin", "left[1].pin", "right.pin"]);
    let JointKind::Revolute(frame, bar) = model.joints[2].kind else {
        panic!("it is a revolute");
    };
    // A port is the link that is lent.
    assert_eq!(model.axis(frame).link, LinkId::new(2));
    assert_eq!(model.axis(frame).port.as_deref(), Some("right.frame"));
    assert_eq!(model.axis(bar).link, LinkId::new(3));
    let tips: Vec<f64> = model
        .axes
        .iter()
        .filter(|axis| axis.name.as_deref() == Some("tip"))
        .map(|axis| axis.at[0])
        .collect();
    assert_eq!(tips, [1.0, 1.0, 3.0]);
}

#[test]
fn each_instance_has_its_number() {
    let parsed = good(&arms("use a[3]: Arm(reach = 10 + k) { frame = ground at (k, 0) };"));
    let places = |name: &str| -> Vec<f64> {
        let axes = parsed.model.axes.iter();
        let axes = axes.filter(|axis| axis.name.as_deref() == Some(name));
        axes.filter(|axis| axis.link == LinkId::GROUND || name == "tip")
            .map(|axis| axis.at[0])
            .collect()
    };
    assert_eq!(places("tip"), [10.0, 11.0, 12.0]);
    assert_eq!(places("o"), [2.0, 3.0, 4.0]);
}

#[test]
fn what_is_lent_stands_where_it_is_said() {
    let parsed =
        good(&arms("use a: Arm mirrored scaled 2 { frame = ground at (10, 1) turned 90 deg };"));
    let model = parsed.model;
    // (2, 0) becomes (-4, 0), turns to (0, -4), and moves.
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-15;
    assert!(near(model.axes[0].at, [10.0, -3.0]), "{:?}", model.axes[0].at);
    // The numbers of the part are in frames of its own: only mirrored and scaled.
    assert_eq!(model.axes[2].at, [-2.0, 2.0]);
    assert_eq!(model.start.values[0].value, -30.0_f64.to_radians());
    let angle = model.start.near[0].angle;
    assert!((angle - 80.0_f64.to_radians()).abs() < 1e-15, "{angle}");
}

#[test]
fn a_drawing_is_placed_as_a_whole() {
    let parsed = good(
        "struct M;
        part Rocker { port frame; link bar; joint pin = revolute(frame, bar) at (1, 0); link end { circle (2, 0) radius 1; }
            joint tip = revolute(bar, end) at (2, 0); }
        use a: Rocker scaled 3 { frame = ground at (0, 1) };",
    );
    let at: Vec<[f64; 2]> = parsed.model.axes.iter().map(|axis| axis.at).collect();
    assert_eq!(at, [[3.0, 1.0], [3.0, 1.0], [6.0, 1.0], [6.0, 1.0]]);
    assert_eq!(parsed.model.links[2].shapes[0].kind.numbers(), [6.0, 1.0, 3.0]);
    assert!(parsed.model.links[1].drawn && parsed.model.links[2].drawn);
}

#[test]
fn parts_have_parts() {
    let parsed = good(&arms(
        "part Pair(reach) { port base; use arm[2]: Arm(reach = reach * (k + 1)) { frame = base }; }
        use pair[2]: Pair(reach = k + 1) mirrored { base = ground };
        effects { trace pair[*].arm[*].bar.tip 8; trace pair[1].arm[0].bar.o 4; }
        show pair[0].arm[1].bar, pair[1].arm[0].pin;"
            .replace("Pair(reach)", "Pair(reach = 1)")
            .as_str(),
    ));
    let model = parsed.model;
    assert_eq!(model.links[4].name, "pair[1].arm[1].bar");
    assert_eq!(model.traces.len(), 5);
    let tip = model.axis(model.traces[3].point);
    assert_eq!(tip.at, [-4.0, 1.0]);
    let paths: Vec<&str> = model.instances.iter().map(|one| one.path.as_str()).collect();
    assert_eq!(
        paths,
        [
            "pair[0]",
            "pair[1]",
            "pair[0].arm[0]",
            "pair[0].arm[1]",
            "pair[1].arm[0]",
            "pair[1].arm[1]"
        ]
    );
}

#[test]
fn lengths_scale_and_senses_turn() {
    let parsed = good(
        "struct M;
        part P {
            port frame { point o = (0, 0); line rail = (0, 0) -> (1, 0); line up = (0, 0) -> (0, 1); }
            link wheel { point o = (0, 0); } link bar { line axis = (0, 0) -> (1, 0); point end = (1, 0); } link lift { line axis = (0, 0) -> (0, 1); }
            joint turn = revolute(frame.o, wheel.o);
            joint push = prismatic(frame.rail, bar.axis);
            joint rise = prismatic(frame.up, lift.axis);
            joint mesh = rack(wheel, bar, radius 0.5);
            joint law = cam(turn, rise, 2 * q);
            spring coil = torsional(turn) stiffness 1 rest 0.25;
            spring pull = linear(frame.o, bar.end) stiffness 1 rest 2;
            start { push = 3; }
        }
        use p: P mirrored scaled 4 { frame = ground };"
,
    );
    let model = parsed.model;
    let radius = model.joints.iter().find_map(|joint| match joint.kind {
        JointKind::Rack { radius, .. } => Some(radius),
        _ => None,
    });
    assert_eq!(radius, Some(-2.0));
    assert_eq!(model.start.values[0].value, 12.0);
    let rests: Vec<f64> = model.actions.springs.iter().map(|spring| spring.rest).collect();
    assert_eq!(rests, [-0.25, 8.0]);
    // Twice the angle in the part: its sense is reversed, and its lengths are four times as long.
    assert_eq!(model.at_start(&model.laws[0], 0.5), -4.0);
}
