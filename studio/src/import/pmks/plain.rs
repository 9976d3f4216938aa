//! Links before April 2023: plain numbers, a line for each joint, link and force.

use super::linkage::{Force, Ids, Joint, Link, Linkage, mass_of, name_of, parts_of};
use super::query::Field;
use crate::document::Message;
use crate::import::drawing::LARGEST;
use crate::import::omission::Omission;

/// The units of length, as a link writes them and as the text does.
const UNITS: [(&str, &str); 4] = [
    ("cm", "centimetres"),
    ("m", "metres"),
    ("in", "inches"),
    ("inch", "inches"),
];
/// What stands for a number that something has not.
const NONE: &str = "Null";

/// Whether a query is one of these.
pub(super) fn is_plain(query: &str) -> bool {
    query.starts_with("j=")
}

/// Reads a query.
pub(super) fn read(query: &Field<'_>) -> Result<Linkage, Message> {
    let mut omissions = Vec::new();
    let joint_lines = section(query, "j=", &["&l=", "&f=", "&s="])?;
    let link_lines = section(query, "&l=", &["&f=", "&s="])?;
    let force_lines = query.between("&f=", &["&s="]).into_iter().flat_map(lines);
    let mut joint_ids = Ids::of("joint");
    let joints = joint_lines.map(|line| joint(line, &mut joint_ids));
    let joints = joints.collect::<Result<Vec<_>, _>>()?;
    let mut link_ids = Ids::of("link");
    let links = link_lines.map(|line| link(line, &joint_ids, &mut link_ids));
    let links = links.collect::<Result<Vec<_>, _>>()?;
    if links.is_empty() {
        return Err(query.wrong("this link has no link of a mechanism in it"));
    }
    let forces = force_lines.map(|line| force(line, &link_ids));
    let forces = forces.collect::<Result<Vec<_>, _>>()?;
    let settings = query.between("&s=", &[]);
    let settings = settings.filter(|field| !field.text().trim().is_empty());
    let unit = settings
        .map(|field| unit(&field, &mut omissions))
        .transpose()?;
    Ok(Linkage {
        unit,
        joints,
        links,
        forces,
        omissions,
    })
}

/// The lines of a section that has to be there.
fn section<'q>(
    query: &Field<'q>,
    mark: &str,
    next: &[&str],
) -> Result<impl Iterator<Item = Field<'q>>, Message> {
    let found = query.between(mark, next);
    let found = found.ok_or_else(|| {
        query.wrong(format!(
            "`{mark}` is missing in this link of a version before April 2023"
        ))
    })?;
    Ok(lines(found))
}

/// The lines with something in them.
fn lines(field: Field<'_>) -> impl Iterator<Item = Field<'_>> {
    let lines = field.split('\n');
    lines.filter(|line| !line.text().trim().is_empty())
}

/// The fields of a line, which has so many or more.
fn fields<'q, const COUNT: usize>(
    line: &Field<'q>,
    what: &str,
) -> Result<[Field<'q>; COUNT], Message> {
    let mut fields: Vec<Field<'q>> = line.split(',').collect();
    let count = fields.len();
    fields.truncate(COUNT);
    fields.try_into().map_err(|_| {
        line.wrong(format!(
            "a {what} of a version before April 2023 has {COUNT} fields with commas between them; this one has {count}"
        ))
    })
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

fn is_prismatic(field: &Field<'_>) -> Result<bool, Message> {
    match field.text().trim() {
        "R" => Ok(false),
        "P" => Ok(true),
        other => Err(field.wrong(format!("`{other}` is neither `R` nor `P`"))),
    }
}

/// `[id],[x],[y],[links],[R or P],[grounded],[angle],[input]`
fn joint<'q>(line: Field<'q>, ids: &mut Ids<'q>) -> Result<Joint, Message> {
    let [id, x, y, _, kind, is_grounded, angle, is_input] = fields(&line, "joint")?;
    ids.enter(&id)?;
    let along = is_prismatic(&kind)?.then(|| number(&angle)).transpose()?;
    Ok(Joint {
        name: name_of(&id, &id),
        at: [number(&x)?, number(&y)?],
        along,
        is_grounded: flag(&is_grounded)?,
        is_input: flag(&is_input)?,
        is_welded: false,
        is_traced: false,
    })
}

/// `[id],[R or P],[mass],[moment of inertia],[x],[y],[joints]` and what it looks like.
fn link<'q>(line: Field<'q>, joints: &Ids<'q>, ids: &mut Ids<'q>) -> Result<Link, Message> {
    let [id, kind, mass, inertia, x, y, own] = fields(&line, "link")?;
    ids.enter(&id)?;
    let center = [number_if_any(&x)?, number_if_any(&y)?];
    let inertia = number_if_any(&inertia)?;
    Ok(Link {
        name: name_of(&id, &id),
        is_root: true,
        is_block: is_prismatic(&kind)?,
        joints: joints.find_all(own.split('|'))?,
        welded: Vec::new(),
        mass: mass_of(&mass, number_if_any(&mass)?, inertia, center)?,
        color: None,
    })
}

/// `[id],[link],[start x],[start y],[end x],[end y],[in the scene],[outward],[magnitude]`
fn force<'q>(line: Field<'q>, links: &Ids<'q>) -> Result<Force, Message> {
    let [
        id,
        link,
        x,
        y,
        end_x,
        end_y,
        is_global,
        is_outward,
        magnitude,
    ] = fields(&line, "force")?;
    let at = [number(&x)?, number(&y)?];
    let end = [number(&end_x)?, number(&end_y)?];
    Ok(Force {
        name: name_of(&id, &id),
        link: links.find(&link)?,
        at,
        parts: parts_of([at, end], flag(&is_outward)?, number(&magnitude)?),
        is_local: !flag(&is_global)?,
    })
}

/// `[speed],[clockwise],[gravity],[unit]`
fn unit(field: &Field<'_>, omissions: &mut Vec<Omission>) -> Result<&'static str, Message> {
    let [speed, is_clockwise, has_gravity, unit] = fields(field, "list of settings")?;
    omissions.push(Omission::speed(number(&speed)?, flag(&is_clockwise)?));
    if flag(&has_gravity)? {
        omissions.push(Omission::gravity());
    }
    let word = unit.text().trim();
    let known = UNITS.iter().find(|(known, _)| *known == word);
    let (_, name) = known.ok_or_else(|| {
        let known = UNITS.map(|(known, _)| format!("`{known}`")).join(", ");
        unit.wrong(format!("the unit `{word}` is not known; known are {known}"))
    })?;
    Ok(name)
}
