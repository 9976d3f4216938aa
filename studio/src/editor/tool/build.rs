//! The commands that each tool makes from the picked places.

use super::Pick;
use super::attachment::{Builder, End, written};
use crate::edit::{ActionKind, Assembly, Command, JointForm, Kind, Pair};
use crate::editor::drawing::{Hit, distance};
use mech_compiler::model::LinkId;

type Built = Result<(), String>;

/// The number of places that a trace keeps.
const TRACED: &str = "256";

const GROUND: End = End::Link(LinkId::GROUND);

/// A bar: each end is joined to what is there, or is a point.
pub(super) fn bar(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let [first, second] = two(picks)?;
    if distance(first.place, second.place) == 0.0 {
        return Err("a bar has a length; pick another place for its other end".to_owned());
    }
    let bar = builder.link("bar");
    for pick in [first, second] {
        match end_at(builder, pick) {
            Some(other) => builder.join([&other, &bar], pick, JointForm::Revolute, None),
            None => drop(builder.point(&bar, pick.place, "end")),
        }
    }
    Ok(())
}

/// The link at a place, or the ground where a point of it is.
fn end_at(builder: &Builder<'_>, pick: &Pick) -> Option<End> {
    builder.link_at(pick).map(End::Link)
}

pub(super) fn pivot(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let pick = one(picks)?;
    let link = End::Link(builder.moving_link_at(pick)?);
    builder.join([&GROUND, &link], pick, JointForm::Revolute, None);
    Ok(())
}

pub(super) fn pin(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    assemble(builder, picks, JointForm::Revolute)
}

/// Makes two links one: what joined them before goes.
pub(super) fn weld(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    assemble(builder, picks, JointForm::Weld)
}

/// Joins two links. Where the places coincide, the joint is placed there; else the second point jumps to the first.
fn assemble(builder: &mut Builder<'_>, picks: &[Pick], form: JointForm) -> Built {
    let [first, second] = two(picks)?;
    let other = builder.moving_link_at(second)?;
    let ends = [builder.link_beside(first, other).unwrap_or(LinkId::GROUND), other];
    if ends[0] == ends[1] {
        return Err("both places are on the same link; pick one on another".to_owned());
    }
    if form == JointForm::Weld {
        builder.remove_joints_of(ends);
    }
    if distance(first.place, second.place) < 1e-9 || form == JointForm::Weld {
        let [a, b] = ends.map(End::Link);
        builder.join([&a, &b], first, form, None);
        return Ok(());
    }
    let [a, b] =
        [(first, ends[0]), (second, ends[1])].map(|(pick, link)| builder.point_at(pick, link));
    let name = builder.names().joint();
    builder.add(Command::Join(crate::edit::Assembly {
        name,
        kind: form,
        ends: [a, b],
        at: None,
        along: None,
    }));
    Ok(())
}

/// A block that slides on the ground, pinned to what is there.
pub(super) fn slider(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let [first, second] = two(picks)?;
    let along = direction(first, second)?;
    let block = builder.link("block");
    if let Some(link) = builder.link_at(first).filter(|link| *link != LinkId::GROUND) {
        builder.join([&End::Link(link), &block], first, JointForm::Revolute, None);
    }
    builder.join([&GROUND, &block], first, JointForm::Prismatic, Some(along));
    Ok(())
}

/// A pin of one link in a slot of another.
pub(super) fn slot(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let [first, second] = two(picks)?;
    let pin = End::Link(builder.moving_link_at(first)?);
    let slotted = End::Link(builder.link_at(second).unwrap_or(LinkId::GROUND));
    let along = direction(first, second)?;
    builder.join([&pin, &slotted], first, JointForm::Slot, Some(along));
    Ok(())
}

/// A wheel that turns on what is there.
pub(super) fn wheel(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let pick = one(picks)?;
    let carrier = end_at(builder, pick).unwrap_or(GROUND);
    let wheel = builder.link("wheel");
    builder.join([&carrier, &wheel], pick, JointForm::Revolute, None);
    Ok(())
}

/// A motor on a joint, or none any more.
pub(super) fn motor(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let pick = one(picks)?;
    let drawing = builder.drawing()?;
    let Hit::Joint(joint) = pick.hit else {
        return Err("there is no joint; pick one".to_owned());
    };
    let name = drawing.model.joint(joint).name.clone();
    builder.add(if drawing.model.motor_of(joint).is_some() {
        Command::Remove { kind: Kind::Motor, name }
    } else {
        Command::Motor { joint: name, law: None, range: None, step: None }
    });
    Ok(())
}

pub(super) fn point(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let [first, second] = two(picks)?;
    let link = builder.link_at(first).unwrap_or(LinkId::GROUND);
    builder.point(&End::Link(link), second.place, "p");
    Ok(())
}

/// The record of a point's path.
pub(super) fn trace(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let pick = one(picks)?;
    let link = builder.moving_link_at(pick)?;
    let point = builder.point_at(pick, link);
    builder.add(Command::Trace { point, length: TRACED.to_owned() });
    Ok(())
}

pub(super) fn spring(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    between(builder, picks, ActionKind::Spring, "spring", "stiffness 100")
}

pub(super) fn damper(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    between(builder, picks, ActionKind::Damper, "damper", "damping 1")
}

fn between(
    builder: &mut Builder<'_>,
    picks: &[Pick],
    kind: ActionKind,
    word: &str,
    amount: &str,
) -> Built {
    let picks = two(picks)?;
    let [a, b] = picks.map(|pick| {
        let link = builder.link_at(pick).unwrap_or(LinkId::GROUND);
        builder.point_at(pick, link)
    });
    let name = builder.names().numbered(word);
    builder.add(Command::Action { kind, name, body: format!("linear({a}, {b}) {amount}") });
    Ok(())
}

/// A force on a place of a link.
pub(super) fn force(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let pick = one(picks)?;
    let link = builder.moving_link_at(pick)?;
    let point = builder.point_at(pick, link);
    let name = builder.names().numbered("load");
    builder.add(Command::Action { kind: ActionKind::Load, name, body: format!("force({point})") });
    Ok(())
}

/// A coloured disc on a link.
pub(super) fn disc(builder: &mut Builder<'_>, picks: &[Pick]) -> Built {
    let [center, edge] = two(picks)?;
    let drawing = builder.drawing()?;
    let link = builder.link_at(center).unwrap_or(LinkId::GROUND);
    let radius = distance(center.place, edge.place);
    if radius == 0.0 {
        return Err("a disc has a radius; pick its edge elsewhere".to_owned());
    }
    let [x, y] = drawing.in_frame(link, center.place).map(written);
    builder.add(Command::Shape {
        link: drawing.model.link(link).name.clone(),
        shape: format!("circle ({x}, {y}) radius {} color teal", written(radius)),
    });
    Ok(())
}

/// The direction from one place to another, in whole degrees: `30 deg`.
fn direction(from: &Pick, to: &Pick) -> Result<String, String> {
    let [x, y] = [to.place[0] - from.place[0], to.place[1] - from.place[1]];
    if x == 0.0 && y == 0.0 {
        return Err("a direction needs another place; pick it elsewhere".to_owned());
    }
    let degrees = y.atan2(x).to_degrees();
    // A line has two directions; the one to the right is written.
    let degrees = match degrees.round() {
        degrees if degrees > 90.0 => degrees - 180.0,
        degrees if degrees <= -90.0 => degrees + 180.0,
        degrees => degrees,
    };
    Ok(format!("{} deg", written(degrees)))
}

fn one(picks: &[Pick]) -> Result<&Pick, String> {
    picks.first().ok_or_else(|| "pick a place".to_owned())
}

fn two(picks: &[Pick]) -> Result<[&Pick; 2], String> {
    match picks {
        [first, second, ..] => Ok([first, second]),
        _ => Err("pick two places".to_owned()),
    }
}

/// The fewest teeth of a wheel.
const TEETH: u32 = 20;
/// No ratio of two wheels has larger terms.
const MOST: u32 = 12;

/// Two wheels that mesh where it was picked.
pub(super) fn gear(builder: &mut Builder<'_>, picks: &[Pick]) -> Result<(), String> {
    let [first, second, touch] = picks else {
        return Err("pick two wheels, and where they touch".to_owned());
    };
    let [(a, center), (b, other)] = [builder.wheel_at(first)?, builder.wheel_at(second)?];
    let radii = [distance(center, touch.place), distance(other, touch.place)];
    let sizes = teeth(radii)?;
    join(builder, [End::Link(a), End::Link(b)], JointForm::Gear { sizes, on: None })
}

/// A belt over two wheels of the same size.
pub(super) fn belt(builder: &mut Builder<'_>, picks: &[Pick]) -> Result<(), String> {
    let [first, second] = picks else {
        return Err("pick two wheels".to_owned());
    };
    let [(a, _), (b, _)] = [builder.wheel_at(first)?, builder.wheel_at(second)?];
    let sizes = [TEETH, TEETH].map(|teeth| teeth.to_string());
    join(builder, [End::Link(a), End::Link(b)], JointForm::Belt { sizes, on: None })
}

fn join(builder: &mut Builder<'_>, ends: [End; 2], kind: JointForm) -> Result<(), String> {
    let name = builder.names().numbered("mesh");
    let ends = ends.map(|end| builder.name(&end));
    if ends[0] == ends[1] {
        return Err("both places are on the same wheel; pick another".to_owned());
    }
    builder.add(Command::Join(Assembly { name, kind, ends, at: None, along: None }));
    Ok(())
}

/// Numbers of teeth whose ratio comes nearest to that of two radii.
fn teeth([first, second]: [f64; 2]) -> Result<Pair, String> {
    let wanted = first / second;
    if !(wanted.is_finite() && wanted > 0.0) {
        return Err("wheels touch between their centres; pick a place there".to_owned());
    }
    let mut best = [1, 1];
    let error = |[a, b]: [u32; 2]| (f64::from(a) / f64::from(b) / wanted).ln().abs();
    for a in 1..=MOST {
        for b in 1..=MOST {
            if error([a, b]) < error(best) - 1e-12 {
                best = [a, b];
            }
        }
    }
    let unit = TEETH.div_ceil(best[0].min(best[1]));
    Ok(best.map(|size| (unit * size).to_string()))
}
