//! Links since June 2023: numbers to the base 64, sections with points between them, and a last letter that checks their length.

use super::digits::{decimal, digit, flags, whole};
use super::linkage::{Force, Ids, Joint, Link, Linkage, mass_of, name_of, parts_of};
use super::query::Field;
use crate::document::Message;
use crate::import::color::Color;
use crate::import::omission::Omission;

/// The letters that check a length.
const CHECKS: &[u8; 62] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
/// The units of length, by their numbers.
const UNITS: [&str; 3] = ["inches", "centimetres", "metres"];
/// How many digits hold the flags of the settings.
const SETTINGS: usize = 2;

/// Whether a text has the form of these links, as far as can be seen from its beginning.
pub(super) fn is_compact(text: &str) -> bool {
    let Some((first, others)) = text.split_once('.') else {
        return false;
    };
    let is_setting =
        first.chars().count() == SETTINGS && first.chars().all(|one| digit(one).is_some());
    is_setting && others.matches('.').count() >= 6
}

/// Reads a query.
pub(super) fn read(whole_query: Field<'_>) -> Result<Linkage, Message> {
    let body = checked(whole_query)?;
    let mut tokens = body.split('.');
    let mut next = |what: &str| {
        let token = tokens.next();
        token.ok_or_else(|| body.wrong(format!("the link ends before {what}")))
    };
    let mut omissions = Vec::new();
    let is_clockwise = settings(&next("its settings")?, &mut omissions)?;
    // How large it is drawn.
    next("its settings")?;
    let numbers = next("its settings")?;
    speed(&numbers, is_clockwise, &mut omissions)?;
    let unit = unit(&next("its settings")?)?;
    let mut section = |what: &str| -> Result<Vec<Field<'_>>, Message> {
        let mut all = Vec::new();
        loop {
            let token = next(what)?;
            if token.text().is_empty() {
                return Ok(all);
            }
            all.push(token);
        }
    };
    let joints = section("the end of its joints")?;
    let links = section("the end of its links")?;
    // The section of what is selected is younger than these links.
    let forces: Vec<Field<'_>> = tokens
        .by_ref()
        .take_while(|token| !token.text().is_empty())
        .collect();
    let selected = tokens.next();
    if let Some(more) = selected.and_then(|_| tokens.next()) {
        return Err(more.wrong("nothing stands here in a link of PMKS+"));
    }
    linkage(unit, [joints, links, forces], omissions, &body)
}

/// The query without its last letter, which has to fit its length.
fn checked(whole_query: Field<'_>) -> Result<Field<'_>, Message> {
    let ends = whole_query.last();
    let (body, check) = ends.ok_or_else(|| whole_query.wrong("the link is empty"))?;
    // As the program counts.
    let length = body.text().encode_utf16().count();
    let right = char::from(CHECKS[length % CHECKS.len()]);
    if check.text().chars().eq([right]) {
        return Ok(body);
    }
    let is_early = body
        .split('.')
        .skip(4)
        .take(2)
        .any(|token| token.split(',').count() == 4);
    Err(check.wrong(if is_early {
        "this looks like a link of April to June 2023, from before links had names and a letter that checks their length; such links are not \
         read; open it in PMKS+ and copy the link anew"
            .to_owned()
    } else {
        format!(
            "the last letter checks the length of the link: it is `{}`, but would have to be `{right}`; a part of the link may be missing",
            check.text()
        )
    }))
}

/// Whether the input turns clockwise.
fn settings(field: &Field<'_>, omissions: &mut Vec<Omission>) -> Result<bool, Message> {
    let is_right = field.text().chars().count() == SETTINGS;
    let digits = field.last().filter(|_| is_right);
    let (high, low) = digits.ok_or_else(|| {
        let text = field.text();
        field.wrong(format!("the settings are {SETTINGS} digits, not `{text}`"))
    })?;
    flags(&high)?;
    let [is_clockwise, has_gravity, ..] = flags(&low)?;
    if has_gravity {
        omissions.push(Omission::gravity());
    }
    Ok(is_clockwise)
}

/// Notes the speed of the input.
fn speed(
    numbers: &Field<'_>,
    is_clockwise: bool,
    omissions: &mut Vec<Omission>,
) -> Result<(), Message> {
    let mut numbers = numbers.split(',');
    if let Some(speed) = numbers.next() {
        let turns = whole(&speed)?;
        omissions.push(Omission::speed(turns, is_clockwise));
    }
    numbers.try_for_each(|number| whole(&number).map(drop))
}

fn unit(field: &Field<'_>) -> Result<Option<&'static str>, Message> {
    let Some((length, mut others)) = field.first() else {
        return Ok(None);
    };
    while let Some((one, rest)) = others.first() {
        flags(&one)?;
        others = rest;
    }
    let number = length.text().chars().next().and_then(digit);
    let number = number.ok_or_else(|| length.wrong("the unit of length is no digit"))?;
    Ok(UNITS.get(number as usize).copied())
}

fn linkage<'q>(
    unit: Option<&'static str>,
    [joint_fields, link_fields, force_fields]: [Vec<Field<'q>>; 3],
    mut omissions: Vec<Omission>,
    body: &Field<'q>,
) -> Result<Linkage, Message> {
    let mut joint_ids = Ids::of("joint");
    let joints = joint_fields
        .into_iter()
        .map(|field| joint(field, &mut joint_ids))
        .collect::<Result<Vec<_>, _>>()?;
    let mut link_ids = Ids::of("link");
    let mut drafts = Vec::new();
    for field in link_fields {
        drafts.push(draft(field, &joint_ids, &mut link_ids, &mut omissions)?);
    }
    let links = drafts.into_iter().map(|(mut link, welded)| {
        link.welded = link_ids.find_all(welded.into_iter())?;
        Ok(link)
    });
    let links = links.collect::<Result<Vec<_>, Message>>()?;
    if !links.iter().any(|link| link.is_root) {
        return Err(body.wrong("this link has no link of a mechanism in it"));
    }
    let forces = force_fields
        .into_iter()
        .map(|field| force(field, &link_ids))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(Linkage {
        unit,
        joints,
        links,
        forces,
        omissions,
    })
}

/// The fields of something, which has so many.
fn fields<'q, const COUNT: usize>(
    field: &Field<'q>,
    what: &str,
) -> Result<[Field<'q>; COUNT], Message> {
    let fields: Vec<Field<'q>> = field.split(',').collect();
    let count = fields.len();
    fields.try_into().map_err(|_| {
        field.wrong(format!(
            "a {what} has {COUNT} fields with commas between them; this one has {count}"
        ))
    })
}

/// `[flags and id],[name],[x],[y],[angle]`
fn joint<'q>(field: Field<'q>, ids: &mut Ids<'q>) -> Result<Joint, Message> {
    let [head, name, x, y, angle] = fields(&field, "joint")?;
    let (bits, id) = head
        .first()
        .ok_or_else(|| field.wrong("the flags and the id of a joint are missing here"))?;
    let [is_prismatic, is_input, is_grounded, is_welded, is_traced, _] = flags(&bits)?;
    ids.enter(&id)?;
    let angle = decimal(&angle)?;
    Ok(Joint {
        name: name_of(&name, &id),
        at: [decimal(&x)?, decimal(&y)?],
        along: is_prismatic.then_some(angle),
        is_grounded,
        is_input,
        is_welded,
        is_traced,
    })
}

/// `[Y or N][R or P][id],[name],[mass],[moment of inertia],[x],[y],[colour],[joints],,[welded links]`
///
/// Gives the link without those that are welded into it, and these.
fn draft<'q>(
    field: Field<'q>,
    joints: &Ids<'q>,
    ids: &mut Ids<'q>,
    omissions: &mut Vec<Omission>,
) -> Result<(Link, Vec<Field<'q>>), Message> {
    let all: Vec<Field<'q>> = field.split(',').collect();
    let [head, name, mass, inertia, x, y, color, lists @ ..] = &all[..] else {
        return Err(field.wrong(format!(
            "a link has more than 8 fields with commas between them; this one has {}",
            all.len()
        )));
    };
    let short = || head.wrong("a link begins with `Y` or `N`, then `R` or `P`, then its id");
    let (root, rest) = head.first().ok_or_else(short)?;
    let (kind, id) = rest.first().ok_or_else(short)?;
    let is_root = match root.text() {
        "Y" => true,
        "N" => false,
        _ => return Err(short()),
    };
    let is_block = match kind.text() {
        "R" => false,
        "P" => true,
        _ => return Err(short()),
    };
    ids.enter(&id)?;
    let mut lists = lists.iter().copied();
    let mut own = Vec::new();
    loop {
        let joint = lists.next();
        let joint = joint.ok_or_else(|| field.wrong("the joints of a link end with two commas"))?;
        if joint.text().is_empty() {
            break;
        }
        own.push(joint);
    }
    let welded = lists.filter(|link| !link.text().is_empty()).collect();
    let center = [decimal(x)?, decimal(y)?];
    let name = name_of(name, &id);
    let inertia = decimal(inertia)?;
    let mass = mass_of(mass, decimal(mass)?, inertia, center)?;
    let link = Link {
        is_root,
        is_block,
        joints: joints.find_all(own.into_iter())?,
        welded: Vec::new(),
        mass,
        color: if is_block {
            None
        } else {
            colored(color, &name, omissions)
        },
        name,
    };
    Ok((link, welded))
}

/// A colour of six hexadecimal digits.
fn colored(field: &Field<'_>, link: &str, omissions: &mut Vec<Omission>) -> Option<Color> {
    let text = field.text();
    let is_right = text.len() == 6 && text.bytes().all(|digit| digit.is_ascii_hexdigit());
    let value = u32::from_str_radix(text, 16).ok().filter(|_| is_right);
    if value.is_none() {
        let what = format!("its colour `{text}` is none of six hexadecimal digits");
        omissions.push(Omission::new(format!("link {link}"), what));
    }
    value.map(|value| {
        let [_, red, green, blue] = value.to_be_bytes();
        Color([red, green, blue])
    })
}

/// `[flags and id],[link],[name],[start x],[start y],[end x],[end y],[magnitude]`
fn force<'q>(field: Field<'q>, links: &Ids<'q>) -> Result<Force, Message> {
    let [head, link, name, x, y, end_x, end_y, magnitude] = fields(&field, "force")?;
    let (bits, id) = head
        .first()
        .ok_or_else(|| field.wrong("the flags and the id of a force are missing here"))?;
    let [is_local, is_outward, ..] = flags(&bits)?;
    let at = [decimal(&x)?, decimal(&y)?];
    let end = [decimal(&end_x)?, decimal(&end_y)?];
    Ok(Force {
        name: name_of(&name, &id),
        link: links.find(&link)?,
        at,
        parts: parts_of([at, end], is_outward, decimal(&magnitude)?),
        is_local,
    })
}
