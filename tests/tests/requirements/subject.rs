//! What can be measured from poses.

use mech_compiler::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model};
use mech_compiler::plan::Plan;
use mech_test_support::{Dice, coordinate, with_ground};
use std::f64::consts::TAU;

type Pose = [f64; 4];

/// Something that can be measured from poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Subject {
    Place(AxisId, usize),
    Coordinate(JointId),
    Angle(LinkId),
    AngleBetween([LinkId; 2]),
    Distance([AxisId; 2]),
    /// Of a loop of three pins: the angle at the middle one, less than a right one.
    Transmission([AxisId; 3]),
}

/// A subject, as a text has it.
pub(crate) type Named = (String, Subject);

impl Subject {
    /// The places of all points, and the coordinates of joints without motors.
    pub(crate) fn all(model: &Model) -> Vec<Named> {
        let places = points(model).into_iter().flat_map(|(id, name)| {
            [(0, "x"), (1, "y")]
                .map(|(part, word)| (format!("{name}.{word}"), Self::Place(id, part)))
        });
        let joints = model.declared_joints();
        let joints = joints.filter(|joint| {
            let kind = model.joint(*joint).kind;
            let has_coordinate = matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
            has_coordinate && model.motor_of(*joint).is_none()
        });
        let coordinates = joints.map(|joint| {
            let name = model.joint(joint).name.clone();
            (name, Self::Coordinate(joint))
        });
        places.chain(coordinates).collect()
    }

    /// These, and angles of links, distances and transmission angles: of each kind about as many.
    pub(super) fn of_all_kinds(model: &Model, plan: &Plan, dice: &mut Dice) -> Vec<Named> {
        let links: Vec<LinkId> = model.declared_links().collect();
        let name = |link: LinkId| &model.link(link).name;
        let angles =
            links.iter().map(|link| (format!("angle({})", name(*link)), Self::Angle(*link)));
        let mut all: Vec<Named> = Self::all(model).into_iter().chain(angles).collect();
        let points = points(model);
        for _ in &links {
            let pair = [0; 2].map(|_| *dice.pick(&links));
            if pair[0] != pair[1] {
                let text = format!("angle({}, {})", name(pair[0]), name(pair[1]));
                all.push((text, Self::AngleBetween(pair)));
            }
            if points.len() > 1 {
                let [(from, first), (to, second)] = [0; 2].map(|_| dice.pick(&points));
                if model.axis(*from).link != model.axis(*to).link {
                    let text = format!("distance({first}, {second})");
                    all.push((text, Self::Distance([*from, *to])));
                }
            }
        }
        let rings = plan.loops().filter_map(|ring| {
            let (middle, pins) = pins_of(model, &ring.unknowns())?;
            let text = format!("transmission({})", model.joint(middle).name);
            Some((text, Self::Transmission(pins)))
        });
        all.extend(rings);
        all
    }

    /// Whether it is an angle.
    pub(super) fn is_angle(self, model: &Model) -> bool {
        match self {
            Self::Place(..) | Self::Distance(_) => false,
            Self::Coordinate(joint) => matches!(model.joint(joint).kind, JointKind::Revolute(..)),
            Self::Angle(_) | Self::AngleBetween(_) | Self::Transmission(_) => true,
        }
    }

    /// Its value where declared links have these poses, near to what it was before if it is an angle over whole turns.
    pub(crate) fn of(self, model: &Model, declared: &[Pose], before: Option<f64>) -> f64 {
        self.seen(model, &with_ground(model, declared), before)
    }

    /// The same where all links have these poses.
    pub(super) fn seen(self, model: &Model, poses: &[Pose], before: Option<f64>) -> f64 {
        let place = |axis: AxisId| place(model.axis(axis), poses);
        let angle = |link: LinkId| poses[link.index()][1].atan2(poses[link.index()][0]);
        let near = |angle: f64| {
            before.map_or(angle, |before| angle + TAU * ((before - angle) / TAU).round())
        };
        match self {
            Self::Place(axis, part) => place(axis)[part],
            Self::Coordinate(joint) => match coordinate(model, poses, joint) {
                (angle, true) => near(angle),
                (slide, false) => slide,
            },
            Self::Angle(link) => near(angle(link)),
            Self::AngleBetween([from, to]) => {
                let turn = angle(to) - angle(from);
                near(turn - TAU * (turn / TAU).round())
            }
            Self::Distance(ends) => {
                let [[a, b], [c, d]] = ends.map(place);
                (a - c).hypot(b - d)
            }
            Self::Transmission(pins) => {
                let [[a, b], [x, y], [c, d]] = pins.map(place);
                let (u, v) = ([a - x, b - y], [c - x, d - y]);
                let across = (u[0] * v[1] - u[1] * v[0]).abs();
                across.atan2((u[0] * v[0] + u[1] * v[1]).abs())
            }
        }
    }
}

fn place(axis: &Axis, poses: &[Pose]) -> [f64; 2] {
    let [cos, sin, x, y] = poses[axis.link.index()];
    let [u, v] = axis.at;
    [x + cos * u - sin * v, y + sin * u + cos * v]
}

/// The points of moving links that have names.
fn points(model: &Model) -> Vec<(AxisId, String)> {
    let axes = (0..model.axes.len()).map(AxisId::new);
    let points = axes.filter_map(|id| {
        let axis = model.axis(id);
        let is_moving = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
        let name = axis.name.as_ref().filter(|_| is_moving)?;
        Some((id, format!("{}.{name}", model.owner_of(axis))))
    });
    points.collect()
}

/// The middle one of three pins between two links and what they are pinned to, and one axis of each, in their order.
fn pins_of(model: &Model, unknowns: &[JointId]) -> Option<(JointId, [AxisId; 3])> {
    let [a, b, c] = *unknowns else {
        return None;
    };
    let pin = |joint: JointId| match model.joint(joint).kind {
        JointKind::Revolute(from, to) => Some([from, to]),
        _ => None,
    };
    let are_joined = |one: JointId, other: JointId| {
        let [one, other] = [one, other].map(|joint| {
            pin(joint).map(|ends| ends.map(|axis| model.axis(model.seen_axis(axis)).link))
        });
        one.zip(other).is_some_and(|(one, other)| one.iter().any(|link| other.contains(link)))
    };
    let mut orders = [[a, b, c], [b, a, c], [a, c, b]].into_iter();
    let ends_apart = |[first, middle, last]: &[JointId; 3]| {
        are_joined(*first, *middle) && are_joined(*middle, *last) && !are_joined(*first, *last)
    };
    let order = orders.find(ends_apart)?;
    let [Some([first, _]), Some([middle, _]), Some([last, _])] = order.map(pin) else {
        return None;
    };
    let pins = [first, middle, last].map(|axis| model.seen_axis(axis));
    Some((order[1], pins))
}
