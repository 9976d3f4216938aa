//! What a mechanism without shapes looks like: teeth mesh, no link crosses a pin of others, and every colour is seen on its ground.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, LinkId, Measure, Model};
use mech_compiler::structure::Pin;
use mech_compiler::{Compiled, Looks, Outline, Painted, compile, looks};
use mech_runtime::Palette;
use mech_test_support::{Sample, for_all, model, painted_outside, samples};
use nalgebra::{Complex, Isometry2, Point2, Translation2, UnitComplex};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

/// The colours of eyes and belts.
const MARKS: [u8; 2] = [Palette::INK, Palette::EYE];

pub(crate) fn compiled(text: &str) -> (Model, Compiled, Looks) {
    let model = model(text);
    let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    let looks = looks(&model, &compiled);
    (model, compiled, looks)
}

/// The frame of a link where a machine is; none if it is not known.
pub(crate) fn frame(
    compiled: &Compiled,
    poses: &[[f64; 4]],
    link: LinkId,
) -> Option<Isometry2<f64>> {
    if link == LinkId::GROUND {
        return Some(Isometry2::identity());
    }
    let [cos, sin, x, y] = poses[compiled.program.place_of(link)?];
    let rotation = UnitComplex::new_normalize(Complex::new(cos, sin));
    Some(Isometry2::from_parts(Translation2::new(x, y), rotation))
}

/// The corners of everything toothed, in the scene: of a rack, its polygon with the most corners.
fn toothed(looks: &Looks, compiled: &Compiled, poses: &[[f64; 4]]) -> Vec<Vec<[f64; 2]>> {
    let outlines = looks.painted.iter().filter_map(|painted| {
        let corners = match &painted.outline {
            Outline::Polygon(corners)
                if corners.wheel.is_some()
                    || (corners.len() > 40 && painted.link != LinkId::GROUND) =>
            {
                corners.at_start()
            }
            _ => return None,
        };
        let frame = frame(compiled, poses, painted.link)?;
        let corners = corners.into_iter().map(|[x, y]| {
            let place = frame * Point2::new(x, y);
            [place.x, place.y]
        });
        Some(corners.collect())
    });
    outlines.collect()
}

/// The area of what two polygons have in common.
fn common_area(one: &[[f64; 2]], other: &[[f64; 2]]) -> f64 {
    let common = one.overlay(&other, OverlayRule::Intersect, FillRule::EvenOdd);
    let area = |ring: &Vec<[f64; 2]>| {
        let next = ring.iter().cycle().skip(1);
        let twice: f64 = ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
        0.5 * twice
    };
    common.iter().flatten().map(area).sum::<f64>().abs()
}

/// Turns the only motor, and looks at what meshing teeth have in common: not more than rounding, beside the area of a tooth.
fn do_not_overlap(text: &str, turns: &[f64]) {
    let (_, compiled, looks) = compiled(text);
    let module = module(&looks);
    let mut machine = Machine::<f64>::new(&compiled.program);
    for turn in turns {
        machine.move_to(&[*turn]).expect("gears turn");
        let all = toothed(&looks, &compiled, &machine.position().poses);
        assert_eq!(all.len(), 2, "{text}");
        let small = usize::from(reach(&all[0]) > reach(&all[1]));
        let area = common_area(&all[0], &all[1]);
        assert!(
            area < 1e-6 * module * module,
            "teeth overlap by {area} at {turn}: {}\n{text}",
            area / module / module
        );
        // They do touch: a little larger, they overlap.
        let nearer = larger(&all[small], 1.0 + 0.35 * module / reach(&all[small]));
        assert!(common_area(&nearer, &all[1 - small]) > 0.0, "teeth do not mesh\n{text}");
    }
}

/// The module of the teeth: the pitch diameter by their number. A tooth reaches seven tenths of it beyond the pitch circle.
fn module(looks: &Looks) -> f64 {
    let outlines = looks.painted.iter().map(|painted| &painted.outline);
    let points = outlines.filter_map(|outline| outline.points());
    let wheels = points.filter_map(|points| points.wheel.as_ref());
    let wheels = wheels.filter(|wheel| wheel.rim.is_none());
    let modules = wheels.map(|wheel| {
        let reach = wheel.tooth.iter().map(|corner| corner[0].hypot(corner[1]));
        2.0 * reach.fold(0.0, f64::max) / (f64::from(wheel.count) + 1.4)
    });
    modules.fold(f64::INFINITY, f64::min)
}

fn middle(corners: &[[f64; 2]]) -> [f64; 2] {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand corners")]
    let share = 1.0 / corners.len() as f64;
    corners
        .iter()
        .fold([0.0; 2], |sum, corner| [sum[0] + share * corner[0], sum[1] + share * corner[1]])
}

fn reach(corners: &[[f64; 2]]) -> f64 {
    let [x, y] = middle(corners);
    let away = corners.iter().map(|corner| (corner[0] - x).hypot(corner[1] - y));
    away.fold(0.0, f64::max)
}

fn larger(corners: &[[f64; 2]], times: f64) -> Vec<[f64; 2]> {
    let [x, y] = middle(corners);
    let moved =
        corners.iter().map(|corner| [x + times * (corner[0] - x), y + times * (corner[1] - y)]);
    moved.collect()
}

/// Two wheels, a wheel in a ring, or a pinion and its rack; and how far they are turned.
fn meshing() -> impl Strategy<Value = (String, f64)> {
    let wheels = |names: &str, [x, y]: [f64; 2], sizes: String, start: f64| {
        format!(
            "struct {names}; ground {{ point a = (0, 0); point b = ({x}, {y}); }} link one {{ point o = (0, 0); }} link two {{ point o = (0, 0); }} \
             joint a = revolute(ground.a, one.o); joint b = revolute(ground.b, two.o); joint g = gear(one, two, {sizes}); \
             motor a; start {{ a = {start}; b = 0.3; }}"
        )
    };
    let apart = [-5.0..5.0, -5.0..5.0].prop_filter("apart", |[x, y]| f64::hypot(*x, *y) > 0.01);
    let outside = ([9..90_i32, 9..90_i32], apart, -3.0..3.0)
        .prop_map(move |([a, b], at, start)| wheels("Gears", at, format!("{a} : {b}"), start));
    let inside = (12..40_i32, 12..60_i32, -3.0..3.0).prop_map(move |(teeth, more, start)| {
        let ring = teeth + more;
        wheels("Ring", [-1.0, 0.0], format!("{teeth} : -{ring}"), start)
    });
    let radius = prop_oneof![0.5..3.0, -3.0..-0.5];
    let rack = (radius, [-3.0..3.0, -1.0..1.0], -3.0..3.0).prop_map(
        |(radius, [along, offset], start)| {
            let (sin, cos) = f64::sin_cos(along);
            format!(
                "struct Rack; ground {{ point o = (0, 0); line l = ({}, {}) -> ({cos}, {sin}); }} link pinion {{ point o = (0, 0); }} \
                 link bar {{ line l = ({offset}, 0.7) -> (1, 0); }} \
                 joint a = revolute(ground.o, pinion.o); joint s = prismatic(ground.l, bar.l); joint r = rack(pinion, bar, radius {radius}); \
                 motor a in -3.5 ..= 3.5; start {{ a = {start}; }}",
                sin * 2.0,
                -cos * 2.0
            )
        },
    );
    let wheels = prop_oneof![outside, inside].prop_map(|text| (text, 9.0));
    prop_oneof![2 => wheels, 1 => rack.prop_map(|text| (text, 3.0))]
}

#[test]
fn meshing_teeth_do_not_overlap() {
    let turns = prop::collection::vec(-1.0..1.0_f64, 4);
    for_all(180, &(meshing(), turns), |((text, far), turns)| {
        let turns: Vec<f64> = turns.into_iter().map(|turn| far * turn).collect();
        do_not_overlap(&text, &turns);
    });
}

/// Whether an outline of a link's body covers a place on the link.
pub(crate) fn covers(painted: &Painted, place: Point2<f64>) -> bool {
    match &painted.outline {
        Outline::Line { points, width } => {
            let points = points.at_start().into_iter().map(Point2::from);
            let points: Vec<Point2<f64>> = points.collect();
            points.windows(2).any(|ends| {
                let along = ends[1] - ends[0];
                let part = (place - ends[0]).dot(&along) / along.norm_squared();
                let foot = ends[0] + along * part.clamp(0.0, 1.0);
                (place - foot).norm() < 0.5 * width.at_start()
            })
        }
        Outline::Polygon(corners) => {
            if let Some(wheel) = &corners.wheel {
                let root = wheel.tooth.iter().map(|corner| corner[0].hypot(corner[1]));
                let away = (place - Point2::from(wheel.center)).norm();
                return wheel.rim.is_none() && away < root.fold(f64::INFINITY, f64::min);
            }
            let corners = corners.at_start();
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            let crossed = edges.filter(|([x, y], [u, v])| {
                let spans = (*y > place.y) != (*v > place.y);
                spans && place.x < x + (place.y - y) / (v - y) * (u - x)
            });
            crossed.count() % 2 == 1
        }
        Outline::Circle { center, radius } => {
            let center = Point2::from(center.map(Measure::at_start));
            (place - center).norm() < radius.at_start()
        }
        _ => false,
    }
}

/// For each position, and each link that covers a pin that it does not carry there: the link, and the links on the pin.
fn crossings(
    model: &Model,
    compiled: &Compiled,
    looks: &Looks,
    positions: &[Vec<[f64; 4]>],
) -> BTreeSet<(LinkId, usize)> {
    let mut found = BTreeSet::new();
    for poses in positions {
        for (number, pin) in compiled.structure.pins.iter().enumerate() {
            let place = pin.members.iter().find_map(|&(link, axis)| {
                Some(frame(compiled, poses, link)? * Point2::from(model.axis(axis).at))
            });
            let Some(place) = place else { continue };
            for painted in &looks.painted {
                let is_on = |member: LinkId| {
                    let die = model.link(member).die;
                    let slot = die.map(|(_, line)| model.axis(line).link);
                    member == painted.link || slot == Some(painted.link)
                };
                let is_other = !pin.members.iter().any(|member| is_on(member.0))
                    && painted.link != LinkId::GROUND;
                let Some(frame) = frame(compiled, poses, painted.link) else {
                    continue;
                };
                if is_other && covers(painted, frame.inverse() * place) {
                    found.insert((painted.link, number));
                }
            }
        }
    }
    found
}

/// Whether a link in such an order is between the links of a pin that it crosses.
fn is_between(model: &Model, link: LinkId, pin: &Pin, plane: impl Fn(LinkId) -> usize) -> bool {
    let planes = || {
        let members = pin.members.iter().map(|member| member.0);
        members
            .filter(|member| *member != LinkId::GROUND && model.link(*member).die.is_none())
            .map(&plane)
    };
    let back = if pin.axis_of(LinkId::GROUND).is_some() { Some(0) } else { planes().min() };
    let own = plane(link);
    back.zip(planes().max()).is_some_and(|(back, front)| own > back && own < front)
}

/// All orders of some things.
fn orders(count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for next in 0..count {
        all = all
            .into_iter()
            .flat_map(|order: Vec<usize>| {
                (0..=order.len()).map(move |place| {
                    let mut order = order.clone();
                    order.insert(place, next);
                    order
                })
            })
            .collect();
    }
    all
}

/// Where there is an order of planes in which no bar crosses a pin that it does not carry, the bodies have such an order: every order of
/// a small mechanism is tried.
#[test]
fn no_bar_crosses_a_pin_that_it_does_not_carry() {
    let (mut crossed, mut solvable, mut missed) = (0, 0, 0);
    for_all(100, &samples(1..=3), |Sample { mut grown, .. }| {
        for link in &mut grown.model.links {
            link.shapes.clear();
        }
        let model = grown.model;
        let Ok(compiled) = compile(&model) else {
            return;
        };
        let links: Vec<LinkId> = model.declared_links().collect();
        if links.len() > 7 {
            return;
        }
        let looks = looks(&model, &compiled);
        let mut machine = Machine::<f64>::new(&compiled.program);
        let here = machine.position().clone();
        let mut positions = vec![here.poses.clone()];
        for sense in [1.0, -1.0] {
            machine.put_back(here.clone());
            let mut steps = (1..=36).map(|step| sense * TAU * f64::from(step) / 36.0);
            let came = steps.all(|by| {
                let turned: Vec<f64> = here.motors.iter().map(|value| value + by).collect();
                let came = matches!(machine.move_toward(&turned), Ok(None));
                positions.push(machine.position().poses.clone());
                came
            });
            // What slides is elsewhere in the other sense.
            let joints = model.motors.iter().map(|motor| model.joint(motor.joint).kind);
            let mut slides = joints.filter(|kind| matches!(kind, JointKind::Prismatic(..)));
            if came && slides.next().is_none() {
                break;
            }
        }
        let crossings = crossings(&model, &compiled, &looks, &positions);
        let is_free = |plane: &dyn Fn(LinkId) -> usize| {
            let pins = &compiled.structure.pins;
            crossings.iter().all(|&(link, pin)| !is_between(&model, link, &pins[pin], plane))
        };
        let has_order = orders(links.len()).iter().any(|order| {
            is_free(&|link| {
                let place = order.iter().position(|&number| links[number] == link);
                place.map_or(usize::MAX, |place| place + 1)
            })
        });
        let plane = |link: LinkId| {
            let mut own = looks
                .painted
                .iter()
                .filter(|painted| painted.link == link && !MARKS.contains(&painted.color));
            own.next().map_or(0, |painted| {
                usize::try_from(painted.plane).expect("planes are in front of the ground")
            })
        };
        if !crossings.is_empty() {
            crossed += 1;
        }
        if has_order {
            solvable += 1;
            if !is_free(&plane) {
                missed += 1;
                println!("a bar crosses a pin\n{}", mech_test_support::text(&model));
            }
        }
    });
    assert!(crossed > 5 && solvable > 20, "{crossed} {solvable}");
    // The planes are found from 144 positions at most, of all turns until gears are as they were: fewer than 36 in each turn, as here.
    assert!(30 * missed <= solvable, "{missed} of {solvable}");
}

/// The difference of two colours, as the eye weighs it, of 255.
fn contrast(one: [u8; 3], other: [u8; 3]) -> f64 {
    let parts = [0, 1, 2].map(|part| (f64::from(one[part]) - f64::from(other[part])).powi(2));
    (0.30 * parts[0] + 0.59 * parts[1] + 0.11 * parts[2]).sqrt()
}

/// Forty links, each with a body: no colour is that of the background, of ink or of an eye, by day and at night.
#[test]
fn every_color_is_seen() {
    let mut text = String::from("struct Many; ");
    for number in 0..40 {
        let end = number + 1;
        text += &format!(
            "link l{number}; joint j{number} = revolute(ground, l{number}) at ({number}, 0); "
        );
        text += &format!(
            "motor j{number}; link k{number} {{ point tip = (0, {end}); }} joint i{number} = weld(l{number}, k{number}) at ({number}, {end}); "
        );
    }
    let (_, _, looks) = compiled(&text);
    let colors: BTreeSet<u8> = looks.painted.iter().map(|painted| painted.color).collect();
    assert!(colors.len() > 36, "{colors:?}");
    for palette in [Palette::TEXTBOOK, Palette::NIGHT] {
        for &color in colors.iter().filter(|color| !MARKS.contains(color)) {
            for background in [Palette::PAPER, Palette::EYE] {
                let difference = contrast(palette.rgb(color), palette.rgb(background));
                assert!(difference > 24.0, "{color} on {background}: {difference}");
            }
        }
    }
}

/// A disc on the pivot is the link's body, with a pin; one beside the pins comes to the body. Stands stay. Where everything has shapes, these
/// are all.
#[test]
fn a_link_with_shapes_keeps_them() {
    let text = "struct Two; look machine; link a { point p = (0, 0); circle (0, 0) radius 1.5 color red; } link b { point p = (1, 0); } \
                joint j = revolute(ground, a) at (0, 0); joint k = revolute(a, b) at (1, 0); motor j; motor k;";
    let (model, _, looks) = compiled(text);
    let [a, b]: [LinkId; 2] = model.declared_links().collect::<Vec<_>>().try_into().expect("two");
    let of = |link| looks.painted.iter().filter(move |painted| painted.link == link);
    let shape = |painted: &&Painted| painted.color == Palette::RED && painted.plane == 0;
    assert_eq!(of(a).filter(shape).count(), 1);
    let marks = of(a).filter(|painted| MARKS.contains(&painted.color));
    assert_eq!((of(a).count(), marks.count()), (6, 5), "two eyes, and the ring of the motor");
    assert!(of(b).count() > 1 && of(LinkId::GROUND).count() > 1);
    let (_, _, beside) =
        compiled(&text.replace("circle (0, 0) radius 1.5", "circle (3, 3) radius 1.5"));
    assert_eq!(beside.painted.len(), looks.painted.len() + 2, "and a bar");
    let ground = "ground { circle (0, 0) radius 2; } link a";
    let drawn = text.replace("look machine; link a", ground);
    let (_, _, drawn) = compiled(
        &drawn.replace("point p = (1, 0); }", "point p = (1, 0); circle (1, 0) radius 1; }"),
    );
    assert_eq!(drawn.painted.len(), 3);
}

/// Mechanisms whose moves go in so small pieces that their boxes took half a minute of an optimised build.
#[test]
fn a_box_costs_little_however_small_the_pieces_of_a_move_are() {
    let texts = [
        "struct Rack; link l1; link l2; link l3;
        joint j0 = revolute(ground, l1) at (-0.5, 2.0);
        joint j1 = prismatic(l1, l2) at (2.3836808125343194, 2.0) along (0.0, -1.0);
        joint j2 = rack(ground, l2, radius 2.8836808125343194 on l1);
        joint j3 = revolute(ground, l3) at (2.5, -3.0);
        joint j4 = slot(l2, l3) at (1.0, 1.0) along (1.0, -1.0);
        motor j0;",
        "struct Belt; link l1; link l2; link l3; link l4; link l5; link l6; link l7;
        joint j0 = revolute(ground, l1) at (2.4, -1.84);
        joint j1 = revolute(l1, l2) at (0.16, 1.99);
        joint j2 = revolute(l1, l3) at (-0.99, 0.34);
        joint j3 = prismatic(l3, l4) at (-0.99, 0.34) along (0.255, -1.386);
        joint j4 = revolute(l4, l2) at (-0.735, -1.046);
        joint j5 = revolute(l3, l5) at (-0.27, 1.23);
        joint j6 = belt(l1, l5, 3 : 2 on l3);
        joint j7 = prismatic(l6, l5) at (-3.48, -3.89) along (0.206, 0.979);
        joint j8 = revolute(l6, l7) at (-3.16, 2.05);
        joint j9 = revolute(ground, l7) at (-2.73, -3.84);
        motor j0; motor j3;",
    ];
    for text in texts {
        let (model, compiled, looks) = compiled(text);
        let begin = Instant::now();
        let _ = looks.extent(&model, &compiled);
        // Without a budget it takes minutes here.
        assert!(begin.elapsed() < Duration::from_secs(10), "{:?}", begin.elapsed());
    }
}

/// What motors reach is painted within the box, however large: where one moves loops, always. Where several do, a box is no proof. What
/// flies away is held as far as the documentation of `EXTENT` says.
#[test]
fn nothing_is_painted_outside_of_the_box() {
    let (mut several, mut beyond) = (0, 0);
    for_all(100, &samples(1..8), |Sample { grown, mut dice }: Sample| {
        let (mut model, times) = (grown.model, 10_f64.powf(dice.between(-3.0, 6.0)));
        for axis in &mut model.axes {
            axis.at = axis.at.map(|part| part * times);
        }
        let Ok(compiled) = compile(&model) else {
            return;
        };
        let outside = painted_outside(&model, &compiled, &mut dice, 120);
        if model.motors.len() > 1 {
            several += 1;
            beyond += usize::from(outside > 1e-6);
        } else {
            assert!(outside <= 1e-6, "{outside:e} of the box");
        }
    });
    println!("several motors: something beyond {beyond} of {several} boxes");
    assert!(50 * beyond <= several, "{beyond} of {several}");
}
