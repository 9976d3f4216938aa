//! Links before April 2023: plain numbers, a line for each joint, link and force.

use super::linkage::{
    Force, Ids, Joint, Link, Linkage, Speeds, UNITS, Unit, mass_of, name_of, parts_of,
};
use super::query::Field;
use crate::document::Message;
use crate::import::drawing::{LARGEST, Omission};

/// The units of length, as a link writes them, with their numbers.
const WORDS: [(&str, usize); 4] = [("cm", 1), ("m", 2), ("in", 0), ("inch", 0)];
/// The sections that are read.
const READ: [&str; 4] = ["j=", "l=", "f=", "s="];
/// The word for a missing number.
const NONE: &str = "Null";

pub(super) fn is_plain(query: &str) -> bool {
    query.starts_with("j=")
}

/// A joint, the links that it names, and its coefficient of friction.
struct Draft<'q> {
    joint: Joint,
    links: Field<'q>,
    friction: f64,
}

pub(super) fn read(query: &Field<'_>) -> Result<Linkage, Message> {
    let mut omissions = Vec::new();
    let joint_lines = section(query, "j=")?;
    let link_lines = section(query, "&l=")?;
    let force_lines = query.behind("&f=").into_iter().flat_map(lines);
    let mut joint_ids = Ids::of("joint");
    let joints = joint_lines.map(|line| joint(line, &mut joint_ids));
    let joints = joints.collect::<Result<Vec<_>, _>>()?;
    if joints.iter().any(|joint| joint.friction != 0.0) {
        let what = "the language has no friction";
        omissions.push(Omission::new("joints", what));
    }
    let mut link_ids = Ids::of("link");
    let links = link_lines.map(|line| link(line, &joint_ids, &mut link_ids));
    let mut links = links.collect::<Result<Vec<_>, _>>()?;
    add_blocks(&joints, &mut links, &mut link_ids)?;
    let joints: Vec<Joint> = joints.into_iter().map(|draft| draft.joint).collect();
    if links.is_empty() {
        return Err(query.wrong("this link has no link of a mechanism in it"));
    }
    let forces = force_lines.map(|line| force(line, &link_ids));
    let forces = forces.collect::<Result<Vec<_>, _>>()?;
    for other in query.split('&') {
        let text = other.text().trim();
        let is_empty = text.split_once('=').is_none_or(|(_, inside)| inside.is_empty());
        if !is_empty && !READ.iter().any(|mark| text.starts_with(mark)) {
            let mark: String = text.chars().take_while(|letter| *letter != '=').collect();
            let what = "this section of the link is not read";
            omissions.push(Omission::new(format!("`&{mark}=`"), what));
        }
    }
    let settings = query.behind("&s=");
    let settings = settings.filter(|field| !field.text().trim().is_empty());
    let settings = settings.map(|field| settings_of(&field)).transpose()?;
    let (speeds, has_gravity, unit) = settings.unwrap_or_default();
    Ok(Linkage { unit, has_gravity, speeds, joints, links, forces, omissions })
}

/// The lines of a section that has to be there.
fn section<'q>(query: &Field<'q>, mark: &str) -> Result<impl Iterator<Item = Field<'q>>, Message> {
    let found = query.behind(mark);
    let found = found.ok_or_else(|| {
        query.wrong(format!("`{mark}` is missing in this link of a version before April 2023"))
    })?;
    Ok(lines(found))
}

fn lines(field: Field<'_>) -> impl Iterator<Item = Field<'_>> {
    let lines = field.split('\n');
    lines.filter(|line| !line.text().trim().is_empty())
}

/// The fields of a line, which has so many or more, and the others.
fn fields<'q, const COUNT: usize>(
    line: &Field<'q>,
    what: &str,
) -> Result<([Field<'q>; COUNT], Vec<Field<'q>>), Message> {
    let mut fields: Vec<Field<'q>> = line.split(',').collect();
    let count = fields.len();
    let others = fields.split_off(COUNT.min(count));
    let fields = fields.try_into().map_err(|_| {
        line.wrong(format!(
            "a {what} of a version before April 2023 has {COUNT} fields with commas between them; this one has {count}"
        ))
    })?;
    Ok((fields, others))
}

fn number(field: &Field<'_>) -> Result<f64, Message> {
    let text = field.text().trim();
    let value: Option<f64> = text.parse().ok();
    let value = value.filter(|value| value.is_finite());
    let value = value.ok_or_else(|| field.wrong(format!("`{text}` is no finite number")))?;
    if value.abs() > LARGEST {
        return Err(field.wrong(format!("`{text}` is too large")));
    }
    Ok(value)
}

/// A number, or zero where something has none.
fn number_if_any(field: &Field<'_>) -> Result<f64, Message> {
    if field.text().trim() == NONE {
        return Ok(0.0);
    }
    number(field)
}

fn flag(field: &Field<'_>) -> Result<bool, Message> {
    match field.text().trim() {
        "t" | "true" => Ok(true),
        "f" | "false" => Ok(false),
        other => Err(field.wrong(format!("`{other}` is neither `t` nor `f`"))),
    }
}

/// Whether a letter means a joint that slides; none if it is neither `P` nor `R`.
fn is_prismatic(field: &Field<'_>) -> Option<bool> {
    match field.text().trim() {
        "R" => Some(false),
        "P" => Some(true),
        _ => None,
    }
}

/// `[id],[x],[y],[links],[R or P],[grounded],[angle],[input]`; before the input may stand a coefficient of friction, which is given, too.
/// For some days in 2022 the angle stood last.
fn joint<'q>(line: Field<'q>, ids: &mut Ids<'q>) -> Result<Draft<'q>, Message> {
    let ([id, x, y, links, kind, is_grounded, angle, next], others) = fields(&line, "joint")?;
    ids.enter(&id)?;
    let slides = is_prismatic(&kind);
    let slides = slides
        .ok_or_else(|| kind.wrong(format!("`{}` is neither `R` nor `P`", kind.text().trim())))?;
    let (angle, next) = if flag(&angle).is_ok() { (next, angle) } else { (angle, next) };
    let along = slides.then(|| number(&angle)).transpose()?;
    let (is_input, friction) = match others.first() {
        Some(last) if flag(&next).is_err() => (flag(last)?, number_if_any(&next)?),
        _ => (flag(&next)?, 0.0),
    };
    let joint = Joint {
        is_grounded: flag(&is_grounded)?,
        is_input,
        ..Joint::plain(name_of(&id, &id), [number(&x)?, number(&y)?], along)
    };
    Ok(Draft { joint, links, friction })
}

/// Adds the blocks of slides, which joints name, but which did not stand among the links at first.
fn add_blocks<'q>(
    joints: &[Draft<'q>],
    links: &mut Vec<Link>,
    ids: &mut Ids<'q>,
) -> Result<(), Message> {
    let listed = links.len();
    for (number, draft) in joints.iter().enumerate() {
        let named = draft.links.split('|');
        for id in named.filter(|id| !["", NONE].contains(&id.text().trim())) {
            if !ids.has(&id) {
                ids.enter(&id)?;
                links.push(Link {
                    name: name_of(&id, &id),
                    is_root: true,
                    is_block: true,
                    joints: Vec::new(),
                    welded: Vec::new(),
                    mass: None,
                    color: None,
                });
            }
            let link = ids.find(&id)?;
            if link >= listed && !links[link].joints.contains(&number) {
                links[link].joints.push(number);
            }
        }
    }
    for link in &mut links[listed..] {
        let mut own = link.joints.iter();
        link.is_block = own.any(|joint| joints[*joint].joint.along.is_some());
    }
    Ok(())
}

/// `[id],[R or P],[mass],[moment of inertia],[x],[y],[joints]` and what it looks like. At first all links were of one kind, which was not
/// written.
fn link<'q>(line: Field<'q>, joints: &Ids<'q>, ids: &mut Ids<'q>) -> Result<Link, Message> {
    let ([id, kind, mass, inertia, x, y], others) = fields(&line, "link")?;
    ids.enter(&id)?;
    let (is_block, [mass, inertia, x, y], own) = match (is_prismatic(&kind), others.first()) {
        (Some(is_block), Some(own)) => (is_block, [mass, inertia, x, y], *own),
        (None, Some(_)) => (false, [kind, mass, inertia, x], y),
        (_, None) => {
            let text = "a link of a version before April 2023 has 7 fields with commas between them; this one has 6";
            return Err(line.wrong(text));
        }
    };
    let center = [number_if_any(&x)?, number_if_any(&y)?];
    let moment = number_if_any(&inertia)?;
    Ok(Link {
        name: name_of(&id, &id),
        is_root: true,
        is_block,
        joints: joints.find_all(own.split('|'))?,
        welded: Vec::new(),
        mass: mass_of(&mass, number_if_any(&mass)?, moment, center)?,
        color: None,
    })
}

/// `[id],[link],[start x],[start y],[end x],[end y],[in the scene],[outward],[magnitude]`; at first the last were its parts along x and y.
fn force<'q>(line: Field<'q>, links: &Ids<'q>) -> Result<Force, Message> {
    let ([id, link, x, y, end_x, end_y, is_global, is_outward, magnitude], others) =
        fields(&line, "force")?;
    let more = others.first().filter(|one| !one.text().trim().is_empty());
    let more = more.map_or(Ok(0.0), number)?;
    let magnitude = if more == 0.0 { number(&magnitude)? } else { number(&magnitude)?.hypot(more) };
    let at = [number(&x)?, number(&y)?];
    let end = [number(&end_x)?, number(&end_y)?];
    Ok(Force {
        name: name_of(&id, &id),
        link: links.find(&link)?,
        at,
        parts: parts_of([at, end], flag(&is_outward)?, magnitude),
        is_local: !flag(&is_global)?,
    })
}

/// `[speed],[clockwise],[gravity],[unit]`
fn settings_of(field: &Field<'_>) -> Result<(Speeds, bool, Option<Unit>), Message> {
    let ([speed, is_clockwise, has_gravity, unit], _) = fields(field, "list of settings")?;
    let sense = if flag(&is_clockwise)? { -1.0 } else { 1.0 };
    let speeds = Speeds { turning: sense * number(&speed)?, sliding: 0.0 };
    let word = unit.text().trim();
    let known = WORDS.iter().find(|(known, _)| *known == word);
    let known = known.and_then(|(_, number)| UNITS.get(*number));
    let known = known.ok_or_else(|| {
        let known = WORDS.map(|(known, _)| format!("`{known}`")).join(", ");
        unit.wrong(format!("the unit `{word}` is not known; known are {known}"))
    })?;
    Ok((speeds, flag(&has_gravity)?, Some(*known)))
}
