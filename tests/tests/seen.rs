//! What is declared is seen: at the start every pin, slot, wheel and rack has places at which nothing lies over it.

use crate::looks::{compiled, covers, frame};
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{
    Axis, AxisId, JointId, JointKind, LinkId, Measure, Model, Place, Shape, ShapeKind,
};
use mech_compiler::structure::{Pin, Rolling};
use mech_compiler::{Compiled, Looks, Outline, Painted, compile, looks};
use mech_runtime::Palette;
use mech_test_support::{Sample, folder, for_all, model, samples};
use nalgebra::Point2;
use std::f64::consts::TAU;

/// What is painted of a mechanism at its start.
struct Picture<'m> {
    model: &'m Model,
    compiled: &'m Compiled,
    looks: &'m Looks,
}

impl Picture<'_> {
    /// A place of a link in the scene.
    fn place(&self, link: LinkId, [x, y]: [f64; 2]) -> Option<Point2<f64>> {
        let poses = &self.compiled.program.start.poses;
        Some(frame(self.compiled, poses, link)? * Point2::new(x, y))
    }

    /// Whether an outline covers a place of the scene.
    fn is_over(&self, painted: &Painted, place: Point2<f64>) -> bool {
        let poses = &self.compiled.program.start.poses;
        let Some(frame) = frame(self.compiled, poses, painted.link) else {
            return false;
        };
        let own = frame.inverse() * place;
        match &painted.outline {
            Outline::Polygon(corners) if corners.wheel.is_some() => {
                let outline = Outline::Polygon(corners.to_vec().into());
                covers(&Painted { outline, ..painted.clone() }, own)
            }
            Outline::Ring { center, radius, hole } => {
                let away = (own - Point2::from(center.map(Measure::at_start))).norm();
                away < radius.at_start() && away > hole.at_start()
            }
            _ => covers(painted, own),
        }
    }

    /// Whether one of these outlines is in front of all others at one of these places.
    fn is_seen(&self, numbers: &[usize], places: &[Point2<f64>]) -> bool {
        places.iter().any(|place| {
            let mut all = self.looks.painted.iter().enumerate().rev();
            let front = all.find(|(_, painted)| self.is_over(painted, *place));
            front.is_some_and(|(number, _)| numbers.contains(&number))
        })
    }

    /// The numbers of outlines of a kind.
    fn numbers(&self, is: impl Fn(&Painted) -> bool) -> Vec<usize> {
        let all = self.looks.painted.iter().enumerate();
        all.filter(|(_, painted)| is(painted)).map(|(number, _)| number).collect()
    }
}

/// Places in a disc.
fn disc(center: Point2<f64>, radius: f64) -> Vec<Point2<f64>> {
    let around = (0..32).map(|number| {
        let (sin, cos) = (f64::from(number) * TAU / 16.0).sin_cos();
        let part = if number < 16 { 0.45 } else { 0.95 };
        center + part * radius * nalgebra::Vector2::new(cos, sin)
    });
    around.chain([center]).collect()
}

/// What is declared and not seen, in words.
fn hidden(model: &Model, compiled: &Compiled, looks: &Looks) -> Vec<String> {
    let picture = Picture { model, compiled, looks };
    let pins = compiled.structure.pins.iter().enumerate();
    let pins = pins.filter(|(_, pin)| !picture.shows_pin(pin));
    let pins = pins.map(|(number, _)| format!("pin {number}"));
    let joints = model.joint_ids().filter(|&joint| !picture.shows_joint(joint));
    pins.chain(joints.map(|joint| format!("joint {}", model.joint(joint).name))).collect()
}

impl Picture<'_> {
    /// Whether the eye of a pin is seen.
    fn shows_pin(&self, pin: &Pin) -> bool {
        let seen = pin.members.iter().filter(|member| self.model.link(member.0).die.is_none());
        let place =
            seen.clone().find_map(|&(link, axis)| self.place(link, self.model.axis(axis).at));
        let Some(place) = place else { return true };
        let eye = |painted: &Painted| match &painted.outline {
            Outline::Circle { center, radius }
                if [Palette::INK, Palette::EYE].contains(&painted.color) =>
            {
                let center = self.place(painted.link, center.map(Measure::at_start));
                center.filter(|center| (center - place).norm() < 1e-3 * radius.at_start())?;
                Some(radius.at_start())
            }
            _ => None,
        };
        let numbers = self.numbers(|painted| eye(painted).is_some());
        let radius = self.looks.painted.iter().filter_map(eye).fold(0.0, f64::max);
        self.is_seen(&numbers, &disc(place, radius))
    }

    /// Whether a slot, and the wheels or the bar of a gear, belt or rack, are seen.
    fn shows_joint(&self, joint: JointId) -> bool {
        match self.model.joint(joint).kind {
            JointKind::Prismatic(..) => {
                let Some([guide, block]) = self.model.guide_and_block(joint) else {
                    return true;
                };
                let [guide, block] = [guide, block].map(|axis| self.model.axis(axis));
                if self.model.link(block.link).die.is_none() {
                    self.hides_rod(guide, block.link)
                } else {
                    self.shows_slot(guide.link)
                }
            }
            JointKind::Gear { .. } | JointKind::Rack { .. } => {
                let own = |rolling: &&Rolling| rolling.joint == joint;
                let rolling = self.compiled.structure.rollings.iter().find(own);
                rolling.is_none_or(|rolling| {
                    rolling.ends.iter().all(|(end, _)| self.shows_teeth(end.link()))
                })
            }
            _ => true,
        }
    }

    /// Whether a piston rod is not seen where it is in its barrel: a rectangle with the line of its guide in the middle.
    fn hides_rod(&self, guide: &Axis, block: LinkId) -> bool {
        let [u, v] = guide.direction;
        let aside = |place: &Place| {
            let [x, y] = place.map(Measure::at_start);
            (x - guide.at[0]) * v - (y - guide.at[1]) * u
        };
        let barrels = self.numbers(|painted| match &painted.outline {
            Outline::Polygon(corners) if painted.link == guide.link && corners.len() == 4 => {
                let [a, b, c, d] = [0, 1, 2, 3].map(|corner| aside(&corners[corner]));
                (a + b).abs().max((c + d).abs()) < 1e-2 * (a - b).abs()
            }
            _ => false,
        });
        let rods = self.numbers(|painted| {
            painted.link == block && matches!(painted.outline, Outline::Line { .. })
        });
        rods.iter().all(|&rod| {
            let places = self.places(rod).into_iter();
            let within = |place: &Point2<f64>| {
                let mut barrels = barrels.iter();
                barrels.any(|&barrel| self.is_over(&self.looks.painted[barrel], *place))
            };
            !self.is_seen(&rods, &places.filter(within).collect::<Vec<_>>())
        })
    }

    /// Whether all openings of slots of a link are seen, or its rails.
    fn shows_slot(&self, link: LinkId) -> bool {
        let open = self.numbers(|painted| {
            let is_opening =
                matches!(painted.outline, Outline::Line { .. }) && painted.color == Palette::PAPER;
            painted.link == link && (is_opening || link == LinkId::GROUND)
        });
        !open.is_empty() && open.iter().all(|&number| self.shows(number))
    }

    /// Whether something toothed of a link is seen.
    fn shows_teeth(&self, link: LinkId) -> bool {
        let teeth = self.numbers(|painted| {
            let corners = match &painted.outline {
                Outline::Polygon(corners) if corners.wheel.is_some() => usize::MAX,
                Outline::Polygon(corners) => corners.len(),
                // Without teeth: the edge of a pulley.
                Outline::Circle { .. } => 20,
                _ => 0,
            };
            painted.link == link && corners >= 20
        });
        teeth.iter().any(|&number| self.shows(number))
    }

    /// Whether an outline is in front of all others somewhere.
    fn shows(&self, number: usize) -> bool {
        let places = self.places(number);
        places.is_empty() || self.is_seen(&[number], &places)
    }

    /// Places of an outline in the scene; none of a ring.
    fn places(&self, number: usize) -> Vec<Point2<f64>> {
        let painted = &self.looks.painted[number];
        let corners: Vec<[f64; 2]> = match &painted.outline {
            Outline::Polygon(points) | Outline::Line { points, .. } => points.at_start(),
            Outline::Circle { center, radius } => {
                let [x, y] = center.map(Measure::at_start);
                disc(Point2::new(x, y), radius.at_start()).into_iter().map(Into::into).collect()
            }
            _ => return Vec::new(),
        };
        // Between each corner and one a few farther on is mostly a place that is within.
        let pairs = (1..6).flat_map(|ahead| corners.iter().zip(corners.iter().cycle().skip(ahead)));
        let within = pairs.flat_map(|(a, b)| {
            (0..=8).map(move |part| {
                let part = f64::from(part) / 8.0;
                [0, 1].map(|axis| a[axis] + part * (b[axis] - a[axis]))
            })
        });
        within.filter_map(|place| self.place(painted.link, place)).collect()
    }
}

/// A rail beside a line of the ground: from where to where what slides on it goes, as it is drawn, and the width of bars.
struct Rail {
    way: [f64; 2],
    width: f64,
}

fn rails(looks: &Looks, line: &Axis) -> Vec<Rail> {
    let from_line = |place: &Place| {
        let [x, y] = place.map(Measure::at_start);
        let ([u, v], [x, y]) = (line.direction, [x - line.at[0], y - line.at[1]]);
        [x * u + y * v, x * v - y * u]
    };
    let rail = |painted: &Painted| match &painted.outline {
        Outline::Polygon(corners)
            if painted.link == LinkId::GROUND && corners.len() > 7 && corners.wheel.is_none() =>
        {
            // Its upper edge, and its thickness.
            let [from, to, below] = [0, 1, 2].map(|corner| from_line(&corners[corner]));
            let width = (to[1] - below[1]).abs() / 0.24;
            let is_along = (from[1] - to[1]).abs() < 1e-4 * width;
            let way = [from[0].min(to[0]) + 1.7 * width, from[0].max(to[0]) - 1.7 * width];
            let is_beside = to[1].abs() < width;
            (is_along && is_beside).then_some(Rail { way, width })
        }
        _ => None,
    };
    looks.painted.iter().filter_map(rail).collect()
}

/// A rail is as long as what slides on it goes, no more and no less, wherever motors take it within their ranges: all together, too.
#[test]
fn rails_are_as_long_as_their_slides_go() {
    let mut tried = 0;
    for case in folder("seen") {
        for way in case.marks("way") {
            let words: Vec<&str> = way.split_whitespace().collect();
            let [joint, low, high] = words[..] else {
                panic!("no way: {way}");
            };
            let way = [low, high].map(|end| end.parse::<f64>().expect("a number"));
            let (model, _, looks) = compiled(&case.text);
            let slide = model.joint_ids().find(|id| model.joint(*id).name == joint);
            let [guide, _] =
                slide.and_then(|slide| model.guide_and_block(slide)).expect("it slides");
            let rails = rails(&looks, model.axis(guide));
            let is_right = |rail: &Rail| {
                let mut pairs = rail.way.iter().zip(&way);
                pairs.all(|(is, should)| (is - should).abs() < 0.1 * rail.width)
            };
            let found: Vec<_> = rails.iter().map(|rail| rail.way).collect();
            assert!(rails.iter().any(is_right), "{found:?} in {}", case.name);
            tried += 1;
        }
    }
    assert!(tried >= 7);
}

/// From where to where along a line of the ground an axis goes where each motor moves alone, through its range or so many turns.
fn travel(model: &Model, compiled: &Compiled, [line, axis]: [AxisId; 2], turns: f64) -> [f64; 2] {
    let (line, axis) = (model.axis(line), model.axis(axis));
    let mut machine = Machine::<f64>::new(&compiled.program);
    let start = machine.position().clone();
    let mut way = [f64::INFINITY, f64::NEG_INFINITY];
    for (number, motor) in model.motors.iter().enumerate() {
        let at = start.motors[number];
        let far = match model.joint(motor.joint).kind {
            JointKind::Revolute(..) => turns * TAU,
            _ => 4.0 * model.size(),
        };
        let range = motor.range.as_ref();
        let ends = range.map_or([at - far, at + far], |range| [range.low, range.high]);
        for end in ends {
            machine.put_back(start.clone());
            for step in 0..=400 {
                let mut target = start.motors.clone();
                target[number] += (end - at) * f64::from(step) / 400.0;
                let came = machine.move_toward(&target);
                if let Some(frame) = frame(compiled, &machine.position().poses, axis.link) {
                    let [x, y] = (frame * Point2::from(axis.at)).into();
                    let ([u, v], [x, y]) = (line.direction, [x - line.at[0], y - line.at[1]]);
                    let along = x * u + y * v;
                    way = [way[0].min(along), way[1].max(along)];
                }
                if came != Ok(None) {
                    break;
                }
            }
        }
    }
    way
}

/// The slides on the ground whose rail is not as long as single motors move them, and how many there are. A rail is longer where several
/// motors may move it, or one in several turns. What flies away where slides become parallel has no rail that is as long.
fn wrong_rails(model: &Model) -> (Vec<String>, usize) {
    let Ok(compiled) = compile(model) else {
        return (Vec::new(), 0);
    };
    let looks = looks(model, &compiled);
    let slides = model.joint_ids().filter_map(|joint| {
        let [guide, block] = model.guide_and_block(joint)?;
        let die = model.link(model.axis(block).link).die;
        let on_ground = model.axis(guide).link == LinkId::GROUND;
        on_ground.then_some((joint, [guide, die.map_or(block, |die| die.0)]))
    });
    let slides: Vec<(JointId, [AxisId; 2])> = slides.collect();
    let wrong = slides.iter().filter_map(|&(joint, ends)| {
        let [least, most] = [1.0, 4.0].map(|turns| travel(model, &compiled, ends, turns));
        if most[1] - most[0] > 32.0 * model.size() {
            return None;
        }
        let one = model.motors.len() == 1;
        let is_right = |rail: &Rail| {
            // A block is 0.4 widths of a bar shorter than its rail, at either end.
            let spare = 0.4 * rail.width;
            let [low, high] = rail.way;
            let covers = low < least[0] + spare && high > least[1] - spare;
            covers && (!one || low > most[0] - spare && high < most[1] + spare)
        };
        let rails = rails(&looks, model.axis(ends[0]));
        let found: Vec<_> = rails.iter().map(|rail| rail.way).collect();
        let name = &model.joint(joint).name;
        (!rails.iter().any(is_right)).then(|| format!("{name}: {found:?} for {least:?}, {most:?}"))
    });
    (wrong.collect(), slides.len())
}

/// Wherever a caller moves a slide on the ground by one motor, its rail is below; it is no longer than that.
#[test]
fn rails_are_as_long_as_single_motors_move() {
    let cases = folder("seen");
    let gripper = cases.iter().find(|case| case.name == "gripper");
    let gripper = model(&gripper.expect("it stands there").text);
    assert_eq!(wrong_rails(&gripper), (Vec::new(), 4));
    let (mut all, mut wrong) = (0, 0);
    for_all(150, &samples(1..6), |Sample { grown, .. }: Sample| {
        let mut model = grown.model;
        model.look = None;
        for link in &mut model.links {
            link.shapes.clear();
        }
        let (found, slides) = wrong_rails(&model);
        if !found.is_empty() {
            println!("{found:?}\n{}", mech_test_support::text(&model));
        }
        (all, wrong) = (all + slides, wrong + found.len());
    });
    println!("{wrong} of {all} rails are wrong");
    assert!(all > 50 && 50 * wrong <= all, "{wrong} of {all}");
}

#[test]
fn what_is_declared_is_seen() {
    let mut cases = folder("seen");
    cases.retain(|case| case.marks("everything is seen").next().is_some());
    assert!(cases.len() >= 9);
    for case in cases {
        let (model, compiled, looks) = compiled(&case.text);
        let hidden = hidden(&model, &compiled, &looks);
        assert!(hidden.is_empty(), "{hidden:?} in {}", case.name);
    }
}

/// Bodies may lie over each other however they are ordered. A shape that comes to a link hides nothing that was seen, unless it lies over it.
#[test]
fn shapes_hide_nothing_else() {
    let (mut seen, mut all) = (0, 0);
    for_all(60, &samples(1..6), |Sample { grown, mut dice }: Sample| {
        let mut model = grown.model;
        let Ok(compiled) = compile(&model) else {
            return;
        };
        model.look = None;
        let before = hidden(&model, &compiled, &looks(&model, &compiled));
        let links: Vec<LinkId> = model.declared_links().collect();
        let link = links[dice.below(links.len())];
        let center = [0, 1].map(|_| 40.0 * model.size() * dice.between(1.0, 2.0));
        let radius = 0.1 * model.size();
        let shape = Shape {
            origin: model.link(link).origin,
            kind: ShapeKind::Circle { center, radius },
            plane: 0,
            color: Palette::RED,
            formulas: vec![None; 3],
        };
        let mut shaped = model.clone();
        shaped.links[link.index()].shapes.push(shape);
        let after = hidden(&shaped, &compiled, &looks(&shaped, &compiled));
        assert_eq!(before, after);
        (seen, all) = (seen + usize::from(before.is_empty()), all + 1);
    });
    println!("everything is seen in {seen} of {all}");
    assert!(all > 20 && 10 * seen >= 9 * all, "{seen} of {all}");
}
