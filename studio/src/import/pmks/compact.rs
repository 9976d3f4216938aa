//! Links since June 2023: everything has a name, and the last letters check the link.

use super::digits::{checked, decimal};
use super::linkage::{Force, Ids, Joint, Link, Linkage, mass_of, name_of, parts_of};
use super::query::Field;
use super::sections::{Draft, Generation, JointDraft, Sections, fields, flags_and_id};
use crate::document::Message;
use crate::import::color::Color;
use crate::import::drawing::Omission;

struct Compact;

/// The first letters of links that are not welded into another, and of those that are. Which one tells whether PMKS+ computes the mass
/// centre and the moment of inertia, whose numbers stand in the link all the same, and whether it draws a disc.
const ROOTS: &str = "YAMG0123";
const PARTS: &str = "Namg4567";
/// The number of fields after the angle of a joint: a slot, a speed and a mass.
const MORE: usize = 5;

pub(super) fn read(query: Field<'_>) -> Result<Linkage, Message> {
    Sections::of(checked(query)?)?.read::<Compact>()
}

impl Generation for Compact {
    /// `[flags and id],[name],[x],[y],[angle]`, and since 2025 perhaps `,[carrier],[end],[end]`, `,[speed]`, `,[mass]`
    fn joint<'q>(
        field: Field<'q>,
        ids: &mut Ids<'q>,
        omissions: &mut Vec<Omission>,
    ) -> Result<JointDraft<'q>, Message> {
        let all: Vec<Field<'q>> = field.split(',').collect();
        let [head, name, x, y, angle, more @ ..] = &all[..] else {
            return Err(field.wrong(format!(
                "a joint has 5 to 10 fields with commas between them; this one has {}",
                all.len()
            )));
        };
        let (flags, id) = flags_and_id(&field, head, "joint")?;
        ids.enter(&id)?;
        let more: [Option<&Field<'q>>; MORE] =
            std::array::from_fn(|at| more.get(at).filter(|one| !one.text().is_empty()));
        let [carrier, first, second, speed, mass] = more;
        let slot = match [carrier, first, second] {
            [None, None, None] => None,
            [Some(carrier), Some(first), Some(second)] => Some([*carrier, *first, *second]),
            _ => {
                let text = "a slot is a link and two of its joints, one of which is missing here";
                return Err(field.wrong(text));
            }
        };
        // A missing number is zero.
        let number = |field: Option<&Field<'q>>| field.map_or(Ok(0.0), decimal);
        let [is_prismatic, is_input, is_grounded, is_welded, is_traced, is_sealed] = flags;
        let along = decimal(angle)?;
        let joint = Joint {
            is_grounded,
            is_input,
            is_welded,
            is_traced,
            is_sealed,
            speed: number(speed)?,
            mass: number(mass)?,
            ..Joint::plain(
                name_of(name, &id),
                [decimal(x)?, decimal(y)?],
                is_prismatic.then_some(along),
            )
        };
        if joint.mass < 0.0 {
            return Err(field.wrong("the mass of a block is not below zero"));
        }
        let mut rest = all.iter().skip(5 + MORE);
        if rest.any(|one| !one.text().is_empty()) {
            let what = "its fields behind the tenth, as friction, are not read";
            omissions.push(Omission::new(format!("joint {}", joint.name), what));
        }
        Ok((joint, slot))
    }

    /// `[letter][R or P][id],[name],[mass],[moment of inertia],[x],[y],[colour],[joints],,[welded links]`
    ///
    /// Gives the link without those that are welded into it, and these.
    fn link<'q>(
        field: Field<'q>,
        joints: &Ids<'q>,
        ids: &mut Ids<'q>,
        omissions: &mut Vec<Omission>,
    ) -> Result<Draft<'q>, Message> {
        let all: Vec<Field<'q>> = field.split(',').collect();
        let [head, name, mass, inertia, x, y, color, lists @ ..] = &all[..] else {
            return Err(field.wrong(format!(
                "a link has more than 8 fields with commas between them; this one has {}",
                all.len()
            )));
        };
        let short = || {
            head.wrong(format!(
                "a link begins with one of `{ROOTS}` and `{PARTS}`, then `R` or `P`, then its id"
            ))
        };
        let (root, rest) = head.first().ok_or_else(short)?;
        let (kind, id) = rest.first().ok_or_else(short)?;
        let is_root = ROOTS.contains(root.text());
        if !is_root && !PARTS.contains(root.text()) {
            return Err(short());
        }
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
            let joint =
                joint.ok_or_else(|| field.wrong("the joints of a link end with two commas"))?;
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
            color: if is_block { None } else { colored(color, &name, omissions) },
            name,
        };
        Ok((link, welded))
    }

    /// `[flags and id],[link],[name],[start x],[start y],[end x],[end y],[magnitude]`
    fn force<'q>(field: Field<'q>, links: &Ids<'q>) -> Result<Force, Message> {
        let [head, link, name, x, y, end_x, end_y, magnitude] = fields(&field, "force")?;
        let ([is_local, is_outward, ..], id) = flags_and_id(&field, &head, "force")?;
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
}

/// Whether a text is a colour: six hexadecimal digits.
pub(super) fn is_color(text: &str) -> bool {
    text.len() == 6 && text.bytes().all(|digit| digit.is_ascii_hexdigit())
}

pub(super) fn colored(
    field: &Field<'_>,
    link: &str,
    omissions: &mut Vec<Omission>,
) -> Option<Color> {
    let text = field.text();
    let value = u32::from_str_radix(text, 16).ok();
    let value = value.filter(|_| is_color(text));
    if value.is_none() {
        let what = format!("its colour `{text}` is none of six hexadecimal digits");
        omissions.push(Omission::new(format!("link {link}"), what));
    }
    value.map(|value| {
        let [_, red, green, blue] = value.to_be_bytes();
        Color([red, green, blue])
    })
}
