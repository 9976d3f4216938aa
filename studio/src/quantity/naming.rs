//! The names of quantities: `coupler.tip.x`, `velocity:b`, `reaction:d`, `transmission`.

use super::kind::{Influenced, Order, Part, Quantity, Reaction, Spot, Subject};
use crate::failure::Failure;
use crate::motion::{motor_of, read_value};
use crate::text::quoted;
use mech_compiler::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model};
use mech_compiler::plan::Plan;
use mech_compiler::program::clearance;

/// The words before a colon.
const KINDS: [&str; 6] = [
    "velocity",
    "acceleration",
    "torque",
    "power",
    "reaction",
    "shaking",
];
const TRANSMISSION: &str = "transmission";
/// The words before the brackets about a cam.
pub(super) const PRESSURE: &str = "pressure";
pub(super) const CURVATURE: &str = "curvature";
const TIME: &str = "t";

/// The quantities of this name: of a point without a part both parts, of `transmission` the angles of all dyads.
pub(crate) fn quantities(
    model: &Model,
    dyads: &[String],
    name: &str,
) -> Result<Vec<Quantity>, Failure> {
    let one = |subject| {
        let name = name.to_owned();
        Ok(vec![Quantity { name, subject }])
    };
    if name == TRANSMISSION {
        return transmission(model, dyads);
    }
    if let Some(found) = centre(model, name) {
        return found;
    }
    if let Some(("d", [of, motor])) = two_ends(name) {
        let motor = motor_of(model, motor)?;
        let [of] = &moving(model, of, of, Order::Place)?[..] else {
            return Err(Failure::usage(format!(
                "`{of}` is a place; an influence is that on a number, as `d({of}.x, ...)`"
            )));
        };
        return one(Subject::Influence(influenced(of.subject)?, motor));
    }
    if let Some(("advantage", [load, motor])) = two_ends(name) {
        let load = load_of(model, load)?;
        return one(Subject::Advantage(load, motor_of(model, motor)?));
    }
    if let Some((kind, ends)) = two_ends(name) {
        return one(match kind {
            "distance" => Subject::Distance([spot(model, ends[0])?, spot(model, ends[1])?]),
            "clear" => Subject::Clearance(bodies(model, ends)?),
            _ => Subject::Between([body_of(model, ends[0])?, body_of(model, ends[1])?]),
        });
    }
    if let Some((kind, cam)) = of_cam(name) {
        let cam = cam_of(model, cam)?;
        return one(match kind {
            PRESSURE => Subject::Pressure(cam),
            _ => Subject::Curvature(cam),
        });
    }
    match name.split_once(':') {
        None => match moving(model, name, name, Order::Place) {
            // Only where nothing else is called so.
            Err(_) if name == TIME => one(Subject::Time),
            found => found,
        },
        Some(("velocity", of)) => moving(model, name, of, Order::Velocity),
        Some(("acceleration", of)) => moving(model, name, of, Order::Acceleration),
        Some(("torque", of)) => one(Subject::Torque(motor_of(model, of)?)),
        Some(("power", of)) => one(Subject::Power(motor_of(model, of)?)),
        Some(("reaction", of)) => reaction(model, name, of),
        Some(("shaking", of)) => shaking(name, of),
        Some((other, _)) => Err(Failure::usage(format!(
            "`{other}` cannot be measured; before a colon stands one of `{}`",
            KINDS.join("`, `")
        ))),
    }
}

/// The word and both ends of `distance(p, q)` or `angle(l, m)`.
fn two_ends(name: &str) -> Option<(&str, [&str; 2])> {
    let (kind, rest) = name.split_once('(')?;
    let inside = rest.strip_suffix(')')?;
    let mut depth = 0;
    let comma = inside.char_indices().find(|(_, letter)| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        *letter == ',' && depth == 0
    });
    let (first, second) = inside.split_at(comma?.0);
    let is_known =
        ["distance", "clear", "angle", "centre", "d", "advantage"].contains(&kind.trim());
    is_known.then(|| (kind.trim(), [first.trim(), second[1..].trim()]))
}

/// The instant centre of `centre(l, m)`, or a part of it; none if the name is none of one.
fn centre(model: &Model, name: &str) -> Option<Result<Vec<Quantity>, Failure>> {
    let (stem, part) = split_part(name);
    let ("centre", ends) = two_ends(stem)? else {
        return None;
    };
    let parts = match part {
        Some(part) => vec![("", part)],
        None => vec![(".x", Part::X), (".y", Part::Y)],
    };
    let links = body_of(model, ends[0]).and_then(|first| Ok([first, body_of(model, ends[1])?]));
    Some(links.map(|links| {
        let quantity = |(ending, part): (&str, Part)| Quantity {
            name: format!("{name}{ending}"),
            subject: Subject::Centre(links, part),
        };
        parts.into_iter().map(quantity).collect()
    }))
}

/// What a motor may move.
fn influenced(subject: Subject) -> Result<Influenced, Failure> {
    match subject {
        Subject::Point(point, _, part) => Ok(Influenced::Point(point, part)),
        Subject::Angle(link, _) => Ok(Influenced::Angle(link)),
        Subject::Coordinate(joint, _) => Ok(Influenced::Coordinate(joint)),
        _ => Err(Failure::internal("a thing that moves is none")),
    }
}

/// The word and the cam of `pressure(c)` or `curvature(c)`.
fn of_cam(name: &str) -> Option<(&str, &str)> {
    let (kind, rest) = name.split_once('(')?;
    let (kind, cam) = (kind.trim(), rest.strip_suffix(')')?.trim());
    [PRESSURE, CURVATURE].contains(&kind).then_some((kind, cam))
}

/// A cam whose roller is declared.
fn cam_of(model: &Model, name: &str) -> Result<JointId, Failure> {
    let joint = joint_of(model, name).ok_or_else(|| unknown(model, name))?;
    match model.joint(joint).kind {
        JointKind::Cam { shaft, .. } if !model.turns(shaft) => Err(Failure::usage(format!(
            "the shaft of cam `{name}` slides; this is measured of a cam that turns"
        ))),
        JointKind::Cam { .. } if model.roller_of(joint).is_some() => Ok(joint),
        JointKind::Cam { .. } => Err(Failure::usage(format!(
            "nobody knows where cam `{name}` is followed; add `roller LINK.POINT radius 1` to it, after its brackets"
        ))),
        _ => Err(Failure::usage(format!("`{name}` is no cam"))),
    }
}

/// A point of a link or of the ground, or a place in the scene: `(1, 2)`.
fn spot(model: &Model, name: &str) -> Result<Spot, Failure> {
    let place = name
        .strip_prefix('(')
        .and_then(|name| name.strip_suffix(')'));
    if let Some((x, y)) = place.and_then(|place| place.split_once(',')) {
        let [x, y] = [x, y].map(|number| read_value(number).map_err(Failure::usage));
        return Ok(Spot::At([x?, y?]));
    }
    let mut all = (0..model.axes.len()).map(AxisId::new);
    let found = all.find(|&id| {
        model.axis(id).kind == AxisKind::Point && point_name(model, id).as_deref() == Some(name)
    });
    found.map(Spot::Point).ok_or_else(|| unknown(model, name))
}

/// Two links whose shapes have a distance.
fn bodies(model: &Model, ends: [&str; 2]) -> Result<[LinkId; 2], Failure> {
    let links = [body_of(model, ends[0])?, body_of(model, ends[1])?];
    match clearance(model, links, [[1.0, 0.0, 0.0, 0.0]; 2]) {
        Some(_) => Ok(links),
        None => Err(Failure::usage(format!(
            "a clearance is that of circles, rings, bars and polygons; one of {} has none, or a figure",
            quoted(ends.iter())
        ))),
    }
}

/// A link, or the ground.
pub(crate) fn body_of(model: &Model, name: &str) -> Result<LinkId, Failure> {
    let is_ground = name == "ground";
    let found = is_ground
        .then_some(LinkId::GROUND)
        .or_else(|| link_of(model, name));
    found.ok_or_else(|| {
        let links = model.declared_links().map(|link| &model.link(link).name);
        Failure::usage(format!(
            "`{}` has no link `{name}`; it has `ground`, {}",
            model.name,
            quoted(links)
        ))
    })
}

/// The quantity of this name, if it is one number.
pub(crate) fn only_quantity(
    model: &Model,
    dyads: &[String],
    name: &str,
) -> Result<Quantity, Failure> {
    let found = quantities(model, dyads, name)?;
    <[Quantity; 1]>::try_from(found)
        .map(|[only]| only)
        .map_err(|found| {
            let names = quoted(found.iter().map(|one| &one.name));
            Failure::usage(format!(
                "`{name}` is several numbers, {names}; name one of them"
            ))
        })
}

/// The coordinates of all joints that have one.
pub(crate) fn usual(model: &Model) -> Vec<Quantity> {
    let joints = model
        .declared_joints()
        .filter(|&joint| has_coordinate(model, joint));
    let quantity = |joint: JointId| Quantity {
        name: model.joint(joint).name.clone(),
        subject: Subject::Coordinate(joint, Order::Place),
    };
    joints.map(quantity).collect()
}

/// The names of the dyads whose transmission angles are known, in their order: the joints of their unknowns.
pub(crate) fn dyads(model: &Model, plan: &Plan) -> Vec<String> {
    let names = plan.loops().map(|ring| {
        let mut names: Vec<&str> = Vec::new();
        for joint in ring.unknowns() {
            let name = model.joint(joint).name.as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names.join(" ")
    });
    names.collect()
}

fn transmission(model: &Model, dyads: &[String]) -> Result<Vec<Quantity>, Failure> {
    if dyads.is_empty() {
        return Err(Failure::usage(format!(
            "`{}` has no loop, so it has no transmission angle",
            model.name
        )));
    }
    let quantity = |(number, dyad): (usize, &String)| Quantity {
        name: format!("{TRANSMISSION} of {dyad}"),
        subject: Subject::Transmission(number),
    };
    Ok(dyads.iter().enumerate().map(quantity).collect())
}

/// Finds the quantities of a moving thing: a point, a link or a joint.
fn moving(model: &Model, name: &str, of: &str, order: Order) -> Result<Vec<Quantity>, Failure> {
    let named = |name: &str, subject| Quantity {
        name: name.to_owned(),
        subject,
    };
    let (stem, part) = split_part(of);
    if let Some(joint) = joint_of(model, of).filter(|&joint| has_coordinate(model, joint)) {
        return Ok(vec![named(name, Subject::Coordinate(joint, order))]);
    }
    if let Some(link) = link_of(model, of) {
        return Ok(vec![named(name, Subject::Angle(link, order))]);
    }
    if let Some(point) = point_of(model, of) {
        let parts = [("x", Part::X), ("y", Part::Y)];
        let quantity = |(word, part)| {
            named(
                &format!("{name}.{word}"),
                Subject::Point(point, order, part),
            )
        };
        return Ok(parts.into_iter().map(quantity).collect());
    }
    if let (Some(part), Some(point)) = (part, point_of(model, stem)) {
        return Ok(vec![named(name, Subject::Point(point, order, part))]);
    }
    Err(unknown(model, of))
}

fn reaction(model: &Model, name: &str, of: &str) -> Result<Vec<Quantity>, Failure> {
    let (stem, part) = match (joint_of(model, of), of.strip_suffix(".torque")) {
        (None, Some(stem)) => (stem, Some(Reaction::Torque)),
        (None, None) => {
            let (stem, part) = split_part(of);
            (stem, part.map(Reaction::Force))
        }
        (Some(_), _) => (of, None),
    };
    let joint = match joint_of(model, stem) {
        None if stem == "ground" => None,
        joint => Some(joint.ok_or_else(|| unknown_joint(model, stem))?),
    };
    Ok(of_reaction(name, part, |part| match joint {
        Some(joint) => Subject::Reaction(joint, part),
        None => Subject::Ground(part),
    }))
}

/// What shakes the ground: `force`, with a part or without, or `moment`.
fn shaking(name: &str, of: &str) -> Result<Vec<Quantity>, Failure> {
    let part = match split_part(of) {
        ("force", part) => part.map(Reaction::Force),
        ("moment", None) => Some(Reaction::Torque),
        _ => {
            let text = format!("`{of}` shakes nothing; write `shaking:force` or `shaking:moment`");
            return Err(Failure::usage(text));
        }
    };
    Ok(of_reaction(name, part, Subject::Shaking))
}

/// A part of what somebody gets; without one, both parts of the force.
fn of_reaction(
    name: &str,
    part: Option<Reaction>,
    subject: impl Fn(Reaction) -> Subject,
) -> Vec<Quantity> {
    let quantity = |ending: &str, part| Quantity {
        name: format!("{name}{ending}"),
        subject: subject(part),
    };
    match part {
        Some(part) => vec![quantity("", part)],
        None => vec![
            quantity(".x", Reaction::Force(Part::X)),
            quantity(".y", Reaction::Force(Part::Y)),
        ],
    }
}

/// The number of a load.
fn load_of(model: &Model, name: &str) -> Result<usize, Failure> {
    let mut loads = model.actions.loads.iter();
    let found = loads.position(|load| load.name == name);
    found.ok_or_else(|| {
        Failure::usage(format!(
            "`{}` has no load `{name}`; it has {}",
            model.name,
            quoted(model.actions.loads.iter().map(|load| &load.name))
        ))
    })
}

/// A name without its part: `tip.x` is `tip` and x.
fn split_part(name: &str) -> (&str, Option<Part>) {
    let parts = [(".x", Part::X), (".y", Part::Y), (".norm", Part::Norm)];
    let found = parts.into_iter().find_map(|(ending, part)| {
        let stem = name.strip_suffix(ending)?;
        Some((stem, Some(part)))
    });
    found.unwrap_or((name, None))
}

fn joint_of(model: &Model, name: &str) -> Option<JointId> {
    model
        .declared_joints()
        .find(|&joint| model.joint(joint).name == name)
}

fn link_of(model: &Model, name: &str) -> Option<LinkId> {
    model
        .declared_links()
        .find(|&link| model.link(link).name == name)
}

fn point_of(model: &Model, name: &str) -> Option<AxisId> {
    points(model).find(|&id| point_name(model, id).as_deref() == Some(name))
}

pub(super) fn points(model: &Model) -> impl Iterator<Item = AxisId> + '_ {
    let all = (0..model.axes.len()).map(AxisId::new);
    all.filter(|&id| {
        let axis = model.axis(id);
        axis.kind == AxisKind::Point && axis.link != LinkId::GROUND
    })
}

pub(super) fn point_name(model: &Model, id: AxisId) -> Option<String> {
    let axis = model.axis(id);
    let name = axis.name.as_ref()?;
    Some(format!("{}.{name}", model.owner_of(axis)))
}

pub(super) fn has_coordinate(model: &Model, joint: JointId) -> bool {
    matches!(
        model.joint(joint).kind,
        JointKind::Revolute(..) | JointKind::Prismatic(..)
    )
}

fn unknown(model: &Model, name: &str) -> Failure {
    let points = points(model).filter_map(|id| point_name(model, id));
    let joints = model
        .declared_joints()
        .map(|joint| &model.joint(joint).name);
    let links = model.declared_links().map(|link| &model.link(link).name);
    Failure::usage(format!(
        "`{}` has no joint, link or point `{name}`; it has joints {}; links {}; points {}",
        model.name,
        quoted(joints),
        quoted(links),
        quoted(points)
    ))
}

fn unknown_joint(model: &Model, name: &str) -> Failure {
    let joints = model.declared_joints();
    let joints = joints.map(|joint| &model.joint(joint).name);
    Failure::usage(format!(
        "`{}` has no joint `{name}`; it has {}",
        model.name,
        quoted(joints)
    ))
}
