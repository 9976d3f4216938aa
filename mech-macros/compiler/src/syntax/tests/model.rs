//! Good texts.

use super::good;
use crate::model::{
    Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Method, Model, Precision, Ratio, ShapeKind,
};

/// Figure 1 of the paper.
const GEARED_PISTON: &str = "
/// A piston driven through a pair of gears: figure 1 of the paper.
pub struct GearedPiston: f64;

const THROW = 1.0;

ground {
    point pinion_shaft = (-3.0, 0.0);
    point wheel_shaft = (0.0, 0.0);
    line bore = (0.0, 0.0) -> (1.0, 0.0);
    polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8), (4.0, 0.8)] on plane 0 color 1;
}
link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0 on plane 2 color 3; }
link wheel  { point shaft = (0.0, 0.0); point pin = (THROW, 0.0); }
link rod    { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

joint d = revolute(ground.pinion_shaft, pinion.shaft);
joint e = revolute(ground.wheel_shaft, wheel.shaft);
joint mesh = gear(pinion, wheel, 20 : 40);
joint f = revolute(wheel.pin, rod.big_end);
joint g = revolute(rod.small_end, piston.pin);
joint h = prismatic(ground.bore, piston.axis);

motor d;
start { d = 30 deg; rod near 0 deg; }
method newton(2);
";

pub(super) fn named<'a>(model: &'a Model, link: &str, axis: &str) -> (AxisId, &'a Axis) {
    let link = model.links.iter().position(|entry| entry.name == link).expect("a link");
    let owned = |entry: &Axis| entry.link.index() == link && entry.name.as_deref() == Some(axis);
    let index = model.axes.iter().position(owned).expect("an axis");
    (AxisId::new(index), &model.axes[index])
}

pub(super) fn joint(model: &Model, name: &str) -> JointKind {
    model.joints.iter().find(|joint| joint.name == name).expect("a joint").kind
}

#[test]
fn the_geared_piston_is_understood() {
    let parsed = good(GEARED_PISTON);
    let header = parsed.header.expect("a header");
    assert_eq!(header.name, "GearedPiston");
    assert_eq!(header.attributes.len(), 1);
    assert!(matches!(header.visibility, syn::Visibility::Public(_)));

    let model = &parsed.model;
    assert_eq!((model.name.as_str(), model.precision), ("GearedPiston", Precision::F64));
    let links: Vec<_> = model.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links, ["ground", "pinion", "wheel", "rod", "piston"]);
    assert!(model.links.iter().all(|link| !link.drawn));
    assert_eq!(model.axes.len(), 10);

    let (pin, axis) = named(model, "wheel", "pin");
    assert_eq!((axis.kind, axis.at, axis.direction), (AxisKind::Point, [1.0, 0.0], [1.0, 0.0]));
    let (big_end, _) = named(model, "rod", "big_end");
    assert_eq!(joint(model, "f"), JointKind::Revolute(pin, big_end));
    let (bore, axis) = named(model, "ground", "bore");
    assert_eq!(axis.kind, AxisKind::Line);
    assert_eq!(joint(model, "h"), JointKind::Prismatic(bore, named(model, "piston", "axis").0));
    let gear = JointKind::Gear {
        a: LinkId::new(1),
        b: LinkId::new(2),
        ratio: Ratio::Teeth(20, 40),
        on: None,
    };
    assert_eq!(joint(model, "mesh"), gear);

    assert_eq!((model.motors.len(), parsed.motors), (1, 1));
    assert_eq!(model.motors[0].joint, JointId::new(0));
    assert_eq!(model.start.values[0].joint, JointId::new(0));
    assert_eq!(model.start.values[0].value, 30_f64.to_radians());
    assert_eq!((model.start.near[0].link, model.start.near[0].angle), (LinkId::new(3), 0.0));
    assert_eq!(model.method, Some(Method::NewtonSteps(2)));
}

#[test]
fn everything_knows_where_it_was_declared() {
    let parsed = good(
        "struct M;\nlink a { point p = (0, 0); circle (0, 0) radius 1; }\nlink b;\n\
        joint d = revolute(ground, b) at (1, 2);\nground { point q = (0, 0); }\n\
        joint e = revolute(ground.q, a.p);\nmotor d in -1 ..= 2 * 3 by 1;\nstart { e = 1 + 2; a near 0; }",
    );
    let model = &parsed.model;
    let spot = |origin| {
        let place = parsed.places.get(origin);
        let (start, end) = (place.start.start(), place.end.end());
        (start.line, start.column, end.column)
    };
    assert_eq!(spot(model.origin), (1, 7, 8));
    assert_eq!(spot(model.link(LinkId::GROUND).origin), (5, 0, 6));
    assert_eq!(spot(model.links[1].origin), (2, 5, 6));
    assert_eq!(spot(model.links[1].shapes[0].origin), (2, 27, 33));
    assert_eq!(spot(model.axes[0].origin), (2, 15, 16));
    assert_eq!(spot(model.joints[0].origin), (4, 6, 7));
    let drawn = model.axes.iter().find(|axis| axis.name.is_none()).expect("a drawn axis");
    assert_eq!(spot(drawn.origin), (4, 6, 7));
    assert_eq!(spot(model.motors[0].origin), (7, 6, 7));
    let range = model.motors[0].range.expect("a range");
    assert_eq!(spot(range.origin), (7, 11, 23));
    assert_eq!(spot(model.start.values[0].origin), (8, 8, 17));
    assert_eq!(spot(model.start.near[0].origin), (8, 19, 27));
}

#[test]
fn a_drawn_four_bar_is_understood() {
    let parsed = good(
        "struct FourBar: f32;
        link crank; link coupler { point tip = (2, 3); } link rocker;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3, 2);
        joint d = revolute(ground, rocker) at (3, 0);
        motor a;
        start { a = 0; }",
    );
    let model = &parsed.model;
    assert_eq!(model.precision, Precision::F32);
    let drawn: Vec<_> = model.links.iter().map(|link| link.drawn).collect();
    assert_eq!(drawn, [false, true, true, true]);
    assert_eq!(model.axes.len(), 9);
    let JointKind::Revolute(first, second) = joint(model, "b") else {
        panic!("a revolute");
    };
    for (axis, link) in [(first, 1), (second, 2)] {
        let axis = model.axis(axis);
        assert_eq!((axis.link, &axis.name), (LinkId::new(link), &None));
        assert_eq!((axis.at, axis.direction), ([0.5, 0.8], [1.0, 0.0]));
    }
}

#[test]
fn joints_drawn_on_one_spot_share_an_axis() {
    let parsed = good(
        "struct M;
        link a; link b; link c;
        joint p = revolute(a, b) at (1, 1);
        joint q = revolute(a, c) at (1, 2 / 2);
        joint r = prismatic(ground, a) at (1, 1) along (1, 0);
        joint s = prismatic(b, a) at (1, 1) along (0, 2);
        joint t = prismatic(c, a) at (1, 1) along (3, 0);",
    );
    let ends = |name| match joint(&parsed.model, name) {
        JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) => (a, b),
        _ => panic!("no gear"),
    };
    assert_eq!(ends("p").0, ends("q").0);
    assert_eq!(ends("r").1, ends("t").1);
    assert_ne!(ends("p").0, ends("r").1);
    assert_ne!(ends("r").1, ends("s").1);
    assert_eq!(parsed.model.axis(ends("s").1).direction, [0.0, 1.0]);
    assert!(!parsed.model.link(LinkId::GROUND).drawn);
}

#[test]
fn a_drawn_link_may_also_be_joined_by_its_points() {
    let parsed = good(
        "struct M; ground { point p = (0, 0); } link crank { point q = (0, 0); } link rod;
        joint a = revolute(ground.p, crank.q); joint b = revolute(crank, rod) at (1, 0);",
    );
    assert!(parsed.model.links[1].drawn);
}

#[test]
fn shapes_have_planes_and_colors() {
    let links = (1..=256).map(|n| format!("link l{n} {{ circle (0, 0) radius 1; }}"));
    let links = links.collect::<Vec<_>>().concat();
    let parsed = good(&format!(
        "struct M; {links} ground {{ circle (0, 0) radius 1; circle (1, 2) radius 3 on plane -1 - 1;
        polygon [(0, 0), (1, 0), (0, 1),] color 200 + 55; }}"
    ));
    let links = &parsed.model.links;
    let looks: Vec<_> = links[0].shapes.iter().map(|shape| (shape.plane, shape.color)).collect();
    assert_eq!(looks, [(0, 1), (-2, 1), (0, 255)]);
    assert_eq!(links[0].shapes[1].kind, ShapeKind::Circle { center: [1.0, 2.0], radius: 3.0 });
    let corners = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(links[0].shapes[2].kind, ShapeKind::Polygon(corners));
    let colors = [1, 12, 13, 24, 25, 36, 37].map(|n: usize| links[n].shapes[0].color);
    assert_eq!(colors, [2, 13, 34, 45, 18, 29, 2]);
    let of_links = |color: u8| matches!(color, 2..=13 | 18..=29 | 34..=45);
    assert!(links[1..].iter().all(|link| of_links(link.shapes[0].color)));
}

#[test]
fn directions_have_length_one() {
    for (given, expected) in [
        ("(3, 4)", [0.6, 0.8]),
        ("(3e300, 4e300)", [0.6, 0.8]),
        ("(3e-310, 4e-310)", [0.6, 0.8]),
        ("(0, -1e-320)", [0.0, -1.0]),
        ("(1e308, 0)", [1.0, 0.0]),
    ] {
        let parsed = good(&format!("struct M; ground {{ point p = (0, 0) -> {given}; }}"));
        let [x, y] = parsed.model.axes[0].direction;
        let error = (x - expected[0]).abs().max((y - expected[1]).abs());
        assert!(error < 1e-12, "{given}: {x} {y}");
    }
}

#[test]
fn statements_may_come_in_any_order() {
    let parsed = good(
        "pub(crate) struct M;
        start { d = 1; }
        motor d;
        joint d = revolute(ground.p, a.q);
        link a { point q = (0, 0); }
        ground { point p = (0, 0); }",
    );
    assert_eq!((parsed.model.joints.len(), parsed.model.motors.len()), (1, 1));
    assert_eq!(parsed.model.method, None);
}
