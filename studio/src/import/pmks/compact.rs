//! Links since June 2023: everything has a name, and the last letter checks the length of the link.

use super::digits::decimal;
use super::linkage::{Force, Ids, Joint, Link, Linkage, mass_of, name_of, parts_of};
use super::query::Field;
use super::sections::{Draft, Generation, Sections, fields, flags_and_id};
use crate::document::Message;
use crate::import::color::Color;
use crate::import::omission::Omission;

/// The letters that check a length.
const CHECKS: &[u8; 62] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

/// The form of these links.
struct Compact;

/// Reads a query.
pub(super) fn read(query: Field<'_>) -> Result<Linkage, Message> {
    Sections::of(checked(query)?)?.read::<Compact>()
}

/// The query without its last letter, which has to fit its length.
fn checked(query: Field<'_>) -> Result<Field<'_>, Message> {
    let ends = query.last();
    let (body, check) = ends.ok_or_else(|| query.wrong("the link is empty"))?;
    // As the program counts.
    let length = body.text().encode_utf16().count();
    let right = char::from(CHECKS[length % CHECKS.len()]);
    if check.text().chars().eq([right]) {
        return Ok(body);
    }
    Err(check.wrong(format!(
        "the last letter checks the length of the link: it is `{}`, but would have to be `{right}`; a part of the link may be missing",
        check.text()
    )))
}

impl Generation for Compact {
    /// `[flags and id],[name],[x],[y],[angle]`
    fn joint<'q>(field: Field<'q>, ids: &mut Ids<'q>) -> Result<Joint, Message> {
        let [head, name, x, y, angle] = fields(&field, "joint")?;
        let ([is_prismatic, is_input, is_grounded, is_welded, is_traced, _], id) =
            flags_and_id(&field, &head, "joint")?;
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
            color: if is_block {
                None
            } else {
                colored(color, &name, omissions)
            },
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

/// A colour of six hexadecimal digits.
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
