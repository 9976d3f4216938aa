//! The point that motors follow.

use super::angle::{is_angle, is_half_in_degrees};
use super::constant::TIME;
use super::draft::Draft;
use super::motor::ordered_range;
use super::name::{Body, Referent};
use super::quantity::Quantity;
use super::reader::{Argument, Nature, Reader};
use super::report::Report;
use super::trace::one_of_its_points;
use super::{find, law};
use crate::api::Owner;
use crate::model::{AxisId, AxisKind, Inverse, LawId, LinkId, MotorId, Range};
use crate::syntax::Place;
use crate::syntax::ast::{End, Follow, Name, Trajectory};
use crate::syntax::spelling;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, follow: &Follow) {
    let led = find_led(reader, draft, &follow.what);
    // Each is looked at, so that the errors of all are reported.
    let mut motors: Vec<MotorId> = Vec::new();
    for name in &follow.motors {
        let motor = find_motor(reader, draft, name, &motors, !follow.region.is_empty());
        motors.extend(motor);
    }
    let Some((body, point)) = led else {
        return;
    };
    if motors.len() < follow.motors.len() || draft.model.inverse.is_some() {
        return;
    }
    if let Some((place, text)) = wrong_least(draft, follow) {
        return reader.report.error(place, text);
    }
    let Some(region) = find_region(reader, draft, follow) else {
        return;
    };
    if let Some(text) = wrong_count(reader, draft, follow, (body, point)) {
        return reader.report.error(follow.what.place(), text);
    }
    let named = follow.motors.iter();
    let named = named.map(|name| draft.places.note(name.place())).collect();
    draft.model.inverse = Some(Inverse {
        link: body.id,
        point,
        motors,
        is_least: follow.least.is_some(),
        region,
        trajectory: Vec::new(),
        origin: draft.places.note(follow.what.place()),
        named,
    });
}

/// Lowers the path of the point that motors follow.
pub(super) fn trajectory(reader: &mut Reader, draft: &mut Draft, path: &Trajectory) {
    let nature = |is_angle| Nature { of: Argument::Time, is_angle };
    // Each is looked at, so that the errors of all are reported.
    let factors = [Quantity::fixed(1.0); 2];
    let laws = path.laws.iter().zip([false, false, true]);
    let laws = laws.map(|(law, is_angle)| {
        if !is_angle && self::is_angle(reader.report, law, "a length") {
            return None;
        }
        law::read(reader, draft, law, TIME, factors, Some(nature(is_angle)))
    });
    let laws: Vec<Option<LawId>> = laws.collect();
    let led = find_led(reader, draft, &path.what);
    let (Some((body, point)), Some(laws)) = (led, laws.into_iter().collect::<Option<Vec<_>>>())
    else {
        return;
    };
    if let Some((place, text)) = wrong_trajectory(reader, draft, path, (body, point), &laws) {
        return reader.report.error(place, text);
    }
    if let Some(inverse) = &mut draft.model.inverse {
        inverse.trajectory = laws;
    }
}

/// The message about a path that cannot be followed.
fn wrong_trajectory(
    reader: &Reader,
    draft: &Draft,
    path: &Trajectory,
    (body, point): (Body, Option<AxisId>),
    laws: &[LawId],
) -> Option<(Place, String)> {
    let (what, model) = (&path.what, &draft.model);
    let Some(inverse) = &model.inverse else {
        let motors = model.motors.iter().take(Inverse::GIVEN.len() - 1);
        let motors: Vec<&str> =
            motors.map(|motor| model.joint(motor.joint).name.as_str()).collect();
        let text = format!(
            "no motors follow `{what}` on its path; write `follow {what} by {};`",
            motors.join(", ")
        );
        // With an error elsewhere, they may.
        return reader.report.is_empty().then(|| (what.place(), text));
    };
    if (inverse.link, inverse.point) != (body.id, point) {
        let led = inverse.name(model);
        let text = format!("motors follow `{led}`, not `{what}`; write `path {led} = ...;`");
        return Some((what.place(), text));
    }
    let all = path.laws.first()?.place.to(path.laws.last()?.place);
    let (given, expected) = (path.laws.len(), inverse.given().len());
    if given != expected {
        let text = format!(
            "each of {} has a law: there are {expected}, and {given} stand here",
            inverse.given().join(", ")
        );
        return Some((all, text));
    }
    if !laws.iter().any(|law| model.law(*law).varies()) {
        let text = format!("by these laws `{what}` never moves; write them with `t`, the time");
        return Some((all, text));
    }
    if inverse.is_least {
        let text = format!(
            "there is no path for motors that go as little as they can: they need not come back; leave out `least`, or lead `{what}` by `reach`"
        );
        return Some((what.place(), text));
    }
    let (motor, _) = model.lawful_motors().next()?;
    let name = &model.joint(model.motor(motor).joint).name;
    let text = format!(
        "motor `{name}` has a law beside this path, and there is one time for both; leave out its law, or the path"
    );
    Some((what.place(), text))
}

/// The ranges of what is given, if they can be read: none where no region is given.
fn find_region(reader: &mut Reader, draft: &mut Draft, follow: &Follow) -> Option<Vec<Range>> {
    let ranges = follow.region.iter().zip(Inverse::GIVEN);
    let ranges = ranges.map(|(ends, name)| {
        let is_told = match name {
            "angle" => is_half_in_degrees(reader.report, &ends.iter().collect::<Vec<_>>()),
            _ => ends.iter().any(|end| is_angle(reader.report, end, "a length")),
        };
        if is_told {
            return None;
        }
        ordered_range(reader, draft, ends, name)
    });
    // Each is looked at, so that the errors of all are reported.
    let ranges: Vec<Option<Range>> = ranges.collect();
    let ranges: Vec<Range> = ranges.into_iter().collect::<Option<_>>()?;
    let (given, expected) = (follow.region.len(), follow.motors.len());
    if given > 0 && given != expected {
        let text = format!(
            "each of {} has a range: there are {expected}, and {given} stand here",
            Inverse::GIVEN[..expected.min(Inverse::GIVEN.len())].join(", ")
        );
        return reader.report.refuse(follow.what.place(), text);
    }
    Some(ranges)
}

/// The link that is led, and its point, if one is named.
fn find_led(reader: &mut Reader, draft: &Draft, end: &End) -> Option<(Body, Option<AxisId>)> {
    if let (Some(Referent::Joint(_)), None) = (find::look_up(reader, &end.link), &end.axis) {
        let text = format!("`{end}` is a joint; motors follow a point, as `link.point`");
        return reader.report.refuse(end.place(), text);
    }
    let body = find::body(reader, draft, &end.link)?;
    let point = match &end.axis {
        None => None,
        Some(name) => {
            let point = find::axis(reader, draft, body, name, Some(AxisKind::Point))?;
            if draft.model.axis(point).kind == AxisKind::Line {
                let text = format!("`{end}` is a line; motors follow a point, as `link.point`");
                return reader.report.refuse(Place::at(name.span()), text);
            }
            Some(point)
        }
    };
    if body.id == LinkId::GROUND {
        let text = format!("`{end}` does not move; name a point of a moving link");
        return reader.report.refuse(end.place(), text);
    }
    Some((body, point))
}

/// The motor of this name, if it can follow.
fn find_motor(
    reader: &mut Reader,
    draft: &Draft,
    name: &Name,
    others: &[MotorId],
    has_region: bool,
) -> Option<MotorId> {
    let model = &draft.model;
    let joint = find::joint(reader, draft, name)?;
    let Some(motor) = model.motor_of(joint) else {
        // With an error elsewhere, that may be its motor.
        if !reader.report.is_empty() {
            return None;
        }
        let motors = model.motors.iter();
        let motors = motors.map(|motor| model.joint(motor.joint).name.as_str());
        let motors: Vec<&str> = motors.collect();
        let remedy = if motors.is_empty() {
            format!("write `motor {name};`")
        } else {
            format!("name one that has: {}", spelling::list(&motors))
        };
        let text = format!("joint `{name}` has no motor that could follow; {remedy}");
        return reader.report.refuse(name.place(), text);
    };
    let text = if others.contains(&motor) {
        format!("`{name}` is listed already; remove one of the two")
    } else if model.motor(motor).law.is_some() {
        format!("motor `{name}` follows a law of the time; leave out its law, or this motor here")
    } else if has_region && model.motor(motor).range.is_some() {
        format!(
            "motor `{name}` has a range, and it is not proved that it stays within it where `in` says; leave out its range, or `in`"
        )
    } else {
        return Some(motor);
    };
    reader.report.refuse(name.place(), text)
}

/// The message about a number of motors that does not fit what is given.
fn wrong_count(
    reader: &Reader,
    draft: &Draft,
    follow: &Follow,
    (body, point): (Body, Option<AxisId>),
) -> Option<String> {
    let what = &follow.what;
    let count = follow.motors.len();
    if follow.least.is_some() {
        let (given, what_is) = match point {
            None => (3, "the place and the angle of a link take"),
            Some(_) => (2, "the place of a point takes"),
        };
        return (count <= given).then(|| {
            format!("`least` is for more motors than needed: {what_is} {given}, and {count} stand here; leave out `least`")
        });
    }
    match (count, point) {
        (3, _) | (2, Some(_)) => None,
        (2, None) => Some(format!(
            "`{what}` is a link, which takes three motors: for its place and its angle; two follow a point{}",
            one_of_its_points(reader, draft, body)
        )),
        (1, _) => Some(format!(
            "one motor cannot bring `{what}` to any place: two follow a point, three a point and the angle of its link"
        )),
        _ => Some(format!(
            "{count} motors are too many for `{what}`: two follow a point, three a point and the angle of its link; \
             write `least` after them, and they go as little as they can"
        )),
    }
}

/// The message about a statement with `least` that asks for more, and its place.
fn wrong_least(draft: &Draft, follow: &Follow) -> Option<(Place, String)> {
    let place = Place::at(follow.least?);
    if !follow.region.is_empty() {
        let text = "there is no proof of a region where motors go as little as they can; leave out `in`, or `least`";
        return Some((place, text.to_owned()));
    }
    let text =
        "what each motor has to do is told by rates; write `effects { velocity; }` for `least`";
    (!draft.model.effects.velocity).then(|| (place, text.to_owned()))
}

/// Complains about a path that has no place where it begins, once all params are known.
pub(super) fn check(draft: &Draft, report: &mut Report) {
    let trajectory = draft.model.inverse.iter().flat_map(|one| &one.trajectory);
    let mut laws = trajectory.map(|law| draft.model.law(*law));
    if let Some(law) = laws.find(|law| !draft.model.at_start(law, 0.0).is_finite()) {
        let text = format!(
            "the path begins at time 0, but `{}` has no value there; change it so that it has one",
            law.written
        );
        report.error(draft.places.get(law.origin), text);
    }
}

/// Claims the name of the method that leads the point.
pub(super) fn take_method(draft: &mut Draft, report: &mut Report) {
    if let Some(inverse) = &draft.model.inverse {
        let place = draft.places.get(inverse.origin);
        draft.claims.take_all(Owner::Inverse, place, report);
        if !inverse.trajectory.is_empty() {
            draft.claims.take_all(Owner::Laws, place, report);
        }
    }
}
