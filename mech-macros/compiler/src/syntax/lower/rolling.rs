//! Gears, belts and racks: what rolls on something else.

use super::draft::Draft;
use super::ends::{Joining, whole_link};
use super::find;
use super::reader::Reader;
use crate::model::{JointId, JointKind, LinkId, Model, Ratio};
use crate::syntax::ast::{Expr, ExprKind, JointWord, Name, Size};

/// Returns the word for a joint without a coordinate, one that rolls or a cam; none for other joints.
pub(super) fn word_for(kind: JointKind) -> Option<&'static str> {
    match kind {
        JointKind::Gear { .. } => Some("gear"),
        JointKind::Belt { .. } => Some("belt"),
        JointKind::Rack { .. } => Some("rack"),
        JointKind::Cam { .. } => Some("cam"),
        JointKind::Revolute(..) | JointKind::Prismatic(..) | JointKind::Weld(..) => None,
    }
}

/// A gear, belt or rack.
pub(super) fn rolling(reader: &mut Reader, draft: &Draft, joining: &Joining) -> Option<JointKind> {
    let body = joining.body;
    let rolling = body.rolling.as_ref()?;
    let why = format!("`{}` joins links", body.word);
    let mut whole = |end| Some(whole_link(reader, draft, end, &why, "")?.id);
    let links = body.ends.each_ref().map(&mut whole);
    let size = rolling_size(reader, body.kind, &rolling.size);
    let on = rolling.carrier.as_ref();
    let on = on.and_then(|name| find_carrier(reader, draft, body.kind, name, links));
    let why = match body.kind {
        JointWord::Rack => "pinion turns and its bar slides where their other joints hold them",
        _ => "wheels turn where their other joints hold them",
    };
    joining.refuse_place(reader, why);
    let [a, b] = [links[0]?, links[1]?];
    joining.check_apart(reader, [a, b])?;
    Some(match size? {
        RollingSize::Rack(radius) => JointKind::Rack { pinion: a, bar: b, radius, on },
        RollingSize::Belt(ratio) => JointKind::Belt { a, b, ratio, on },
        RollingSize::Gear(ratio) => JointKind::Gear { a, b, ratio, on },
    })
}

/// The link that carries both parts: neither of them.
fn find_carrier(
    reader: &mut Reader,
    draft: &Draft,
    kind: JointWord,
    name: &Name,
    parts: [Option<LinkId>; 2],
) -> Option<LinkId> {
    let carrier = find::link(reader, draft, name)?;
    if !parts.contains(&Some(carrier)) {
        return Some(carrier);
    }
    let carried = match kind {
        JointWord::Rack => "the pinion and the bar",
        _ => "both wheels",
    };
    let text = format!(
        "`{name}` cannot carry itself; name the link that carries {carried}, or leave `on {name}` out"
    );
    reader.report.refuse(name.place(), text)
}

fn rolling_size(reader: &mut Reader, kind: JointWord, size: &Size) -> Option<RollingSize> {
    let why = "what rolls keeps its ratio, so that it counts whole turns exactly (a `cam` may have a ratio in its law)";
    size_of(&mut reader.fixed(why), kind, size)
}

fn size_of(reader: &mut Reader, kind: JointWord, size: &Size) -> Option<RollingSize> {
    match (kind, size) {
        (_, Size::Radius(radius)) => pinion_radius(reader, radius).map(RollingSize::Rack),
        (JointWord::Belt, Size::Ratio(parts)) => belt_ratio(reader, parts).map(RollingSize::Belt),
        (_, Size::Ratio(parts)) => gear_ratio(reader, parts).map(RollingSize::Gear),
    }
}

fn pinion_radius(reader: &mut Reader, part: &Expr) -> Option<f64> {
    let radius = reader.value(part)?;
    if reader.frame.scale.formula.is_some() {
        let text = "a param scales this part, but what rolls keeps its ratio, so that it counts whole turns exactly; use a `const` as its scale";
        return reader.report.refuse(part.place, text);
    }
    let radius = reader.frame.sense() * reader.frame.start_scale() * radius;
    if radius == 0.0 {
        let text = "a pinion cannot be of size zero; give its pitch radius, negative if the bar is on its other side";
        return reader.report.refuse(part.place, text);
    }
    Some(radius)
}

fn belt_ratio(reader: &mut Reader, parts: &[Expr; 2]) -> Option<Ratio> {
    let sizes = parts.each_ref().map(|part| {
        let size = reader.value(part)?;
        if size <= 0.0 {
            let text = "a belt turns both wheels in the same sense; make both sizes positive";
            return reader.report.refuse(part.place, text);
        }
        wheel_size(reader, part, size)
    });
    ratio(reader, parts, [sizes[0]?, sizes[1]?])
}

fn gear_ratio(reader: &mut Reader, parts: &[Expr; 2]) -> Option<Ratio> {
    let sizes = parts.each_ref().map(|part| {
        let size = reader.value(part)?;
        if size == 0.0 {
            let text = "a wheel cannot be of size zero; give its teeth or its pitch radius";
            return reader.report.refuse(part.place, text);
        }
        wheel_size(reader, part, size)
    });
    let sizes = [sizes[0]?, sizes[1]?];
    if sizes.iter().all(|size| *size < 0.0) {
        let [first, second] = parts;
        let text = "only one wheel of a gear can be a ring; make one of the two positive";
        return reader.report.refuse(first.place.to(second.place), text);
    }
    ratio(reader, parts, sizes)
}

/// Numbers of teeth if both are integers, pitch radii if none is.
fn ratio(reader: &mut Reader, parts: &[Expr; 2], sizes: [f64; 2]) -> Option<Ratio> {
    let [first, second] = parts;
    let (teeth, radius) = match parts.each_ref().map(|part| reader.integer(part)) {
        [Some(a), Some(b)] => return Some(Ratio::Teeth(a, b)),
        [None, None] => return Some(Ratio::Radii(sizes[0], sizes[1])),
        [Some(_), None] => (first, second),
        [None, Some(_)] => (second, first),
    };
    let radii = sizes.map(|size| format!("{size:?}")).join(" : ");
    let text = format!(
        "`{teeth}` is a number of teeth, as it is whole, but `{radius}` a pitch radius; write `{radii}` for two radii, or two whole numbers"
    );
    reader.report.refuse(first.place.to(second.place), text)
}

/// The size of a wheel, unless it has more teeth than can be counted.
fn wheel_size(reader: &mut Reader, part: &Expr, size: f64) -> Option<f64> {
    if let Some(text) = digits(part)
        && text.parse::<i64>().is_err()
    {
        return reader.report.refuse(
            part.place,
            "no wheel has that many teeth; a pitch radius has a decimal point",
        );
    }
    Some(size)
}

/// Where the motor of a joint that rolls should be: on the joint by which one of its parts moves.
pub(super) fn motor_remedy(model: &Model, rolling: JointId) -> String {
    if let JointKind::Cam { shaft, .. } = model.joint(rolling).kind {
        return format!("put it on `{}`, its shaft", model.joint(shaft).name);
    }
    let (a, b) = model.ends(rolling);
    let rack = matches!(model.joint(rolling).kind, JointKind::Rack { .. });
    let found = [(a, false), (b, rack)].into_iter().find_map(|(link, bar)| {
        let drives = |&joint: &JointId| drives(model, joint, link, bar);
        Some((model.joint_ids().find(drives)?, link, bar))
    });
    let Some((joint, link, bar)) = found else {
        let place = if rack {
            "the revolute of its pinion or the prismatic of its bar"
        } else {
            "the revolute of one of its wheels"
        };
        return format!("put it on {place}");
    };
    let (joint, link) = (model.joint(joint), model.link(link));
    let word = if bar { "prismatic" } else { "revolute" };
    format!("put it on `{}`, the {word} of `{}`", joint.name, link.name)
}

/// Whether a joint turns this link, or slides it if it is a bar.
fn drives(model: &Model, joint: JointId, link: LinkId, bar: bool) -> bool {
    let (a, b) = model.ends(joint);
    let on_die = [a, b].iter().any(|&end| model.link(end).die.is_some());
    let fits = match model.joint(joint).kind {
        JointKind::Revolute(..) => !bar,
        JointKind::Prismatic(..) => bar,
        _ => false,
    };
    fits && !on_die && (a == link || b == link)
}

/// The size of a rolling pair, in each kind of joint.
enum RollingSize {
    Gear(Ratio),
    Belt(Ratio),
    /// The radius of the pinion.
    Rack(f64),
}

/// The digits of an integer, with a sign or none.
fn digits(part: &Expr) -> Option<&str> {
    match &part.kind {
        ExprKind::Integer(text) => Some(text),
        ExprKind::Negative(inner) => digits(inner),
        _ => None,
    }
}
