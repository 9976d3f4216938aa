//! Links of April to June 2023: as those after them, but nothing has a name, and nothing checks the length.
//!
//! At first links had neither colours nor a mark whether they are welded into others; both came in May.

use super::compact::{colored, is_color};
use super::digits::decimal;
use super::linkage::{Force, Ids, Joint, Link, Linkage, mass_of, name_of, parts_of};
use super::query::Field;
use super::sections::{Draft, Generation, HEADS, JointDraft, Sections, fields, flags_and_id};
use crate::document::Message;
use crate::import::drawing::Omission;

struct Early;

/// Whether a query is one of these: it ends with the end of a section, and its first joint has no name.
pub(super) fn is_early(query: &Field<'_>) -> bool {
    let mut tokens = query.split('.').skip(HEADS);
    let joint = tokens.find(|token| !token.text().is_empty());
    let count = joint.map_or(0, |joint| joint.split(',').count());
    query.text().ends_with('.') && count == 4
}

pub(super) fn read(query: Field<'_>) -> Result<Linkage, Message> {
    Sections::of(query)?.read::<Early>()
}

impl Generation for Early {
    /// `[flags and id],[x],[y],[angle]`
    fn joint<'q>(
        field: Field<'q>,
        ids: &mut Ids<'q>,
        _: &mut Vec<Omission>,
    ) -> Result<JointDraft<'q>, Message> {
        let [head, x, y, angle] = fields(&field, "joint")?;
        let ([is_prismatic, is_input, is_grounded, is_welded, ..], id) =
            flags_and_id(&field, &head, "joint")?;
        ids.enter(&id)?;
        let angle = decimal(&angle)?;
        let at = [decimal(&x)?, decimal(&y)?];
        let joint = Joint {
            is_grounded,
            is_input,
            is_welded,
            ..Joint::plain(name_of(&id, &id), at, is_prismatic.then_some(angle))
        };
        Ok((joint, None))
    }

    /// `[Y or N, or nothing][R or P][id],[mass],[moment of inertia],[x],[y],[colour, or nothing][joints]`, and perhaps `,,[welded links]`
    fn link<'q>(
        field: Field<'q>,
        joints: &Ids<'q>,
        ids: &mut Ids<'q>,
        omissions: &mut Vec<Omission>,
    ) -> Result<Draft<'q>, Message> {
        let all: Vec<Field<'q>> = field.split(',').collect();
        let [head, mass, inertia, x, y, rest @ ..] = &all[..] else {
            return Err(field.wrong(format!(
                "a link of April to June 2023 has more than 5 fields with commas between them; this one has {}",
                all.len()
            )));
        };
        let short = || head.wrong("a link begins with `Y` or `N`, then `R` or `P`, then its id");
        let (first, after) = head.first().ok_or_else(short)?;
        let (is_root, kind, id) = match first.text() {
            mark @ ("Y" | "N") => {
                let (kind, id) = after.first().ok_or_else(short)?;
                (mark == "Y", kind, id)
            }
            _ => (true, first, after),
        };
        let is_block = match kind.text() {
            "R" => false,
            "P" => true,
            _ => return Err(short()),
        };
        ids.enter(&id)?;
        // A colour may come before the joints. Blocks have an empty one.
        let (color, lists) = match rest {
            [first, lists @ ..] if first.text().is_empty() || is_color(first.text()) => {
                (Some(first), lists)
            }
            lists => (None, lists),
        };
        let mut lists = lists.split(|one| one.text().is_empty());
        let own = lists.next().unwrap_or_default();
        let welded = lists.flatten().copied().collect();
        let name = name_of(&id, &id);
        let mass = mass_of(mass, decimal(mass)?, decimal(inertia)?, [decimal(x)?, decimal(y)?])?;
        let color = color.filter(|_| !is_block);
        let link = Link {
            is_root,
            is_block,
            joints: joints.find_all(own.iter().copied())?,
            welded: Vec::new(),
            mass,
            color: color.and_then(|color| colored(color, &name, omissions)),
            name,
        };
        Ok((link, welded))
    }

    /// `[flags and id],[link],[start x],[start y],[end x],[end y],[magnitude]`
    fn force<'q>(field: Field<'q>, links: &Ids<'q>) -> Result<Force, Message> {
        let [head, link, x, y, end_x, end_y, magnitude] = fields(&field, "force")?;
        let ([is_local, is_outward, ..], id) = flags_and_id(&field, &head, "force")?;
        let at = [decimal(&x)?, decimal(&y)?];
        let end = [decimal(&end_x)?, decimal(&end_y)?];
        Ok(Force {
            name: name_of(&id, &id),
            link: links.find(&link)?,
            at,
            parts: parts_of([at, end], is_outward, decimal(&magnitude)?),
            is_local,
        })
    }
}
