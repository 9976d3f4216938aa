//! The sections of a link whose numbers are to the base 64: settings, joints, links and forces.

use super::digits::{digit, flags, whole};
use super::linkage::{Force, Ids, Joint, Link, Linkage};
use super::query::Field;
use crate::document::Message;
use crate::import::omission::Omission;

/// The units of length, by their numbers.
const UNITS: [&str; 3] = ["inches", "centimetres", "metres"];
/// How many digits hold the flags of the settings.
const SETTINGS: usize = 2;

/// What stands before the joints: settings with flags, decimals, whole numbers, and choices.
pub(super) const HEADS: usize = 4;

/// The sections of a link.
pub(super) struct Sections<'q> {
    body: Field<'q>,
    unit: Option<&'static str>,
    joints: Vec<Field<'q>>,
    links: Vec<Field<'q>>,
    forces: Vec<Field<'q>>,
    omissions: Vec<Omission>,
}

/// A link, and the ids of those that are welded into it.
pub(super) type Draft<'q> = (Link, Vec<Field<'q>>);

/// How a generation of links writes what stands in its sections.
pub(super) trait Generation {
    fn joint<'q>(field: Field<'q>, ids: &mut Ids<'q>) -> Result<Joint, Message>;
    fn link<'q>(
        field: Field<'q>,
        joints: &Ids<'q>,
        ids: &mut Ids<'q>,
        omissions: &mut Vec<Omission>,
    ) -> Result<Draft<'q>, Message>;
    fn force<'q>(field: Field<'q>, links: &Ids<'q>) -> Result<Force, Message>;
}

/// Whether a text begins as these links do, and has as many sections.
pub(super) fn has_sections(text: &str) -> bool {
    let Some((first, others)) = text.split_once('.') else {
        return false;
    };
    let is_setting =
        first.chars().count() == SETTINGS && first.chars().all(|one| digit(one).is_some());
    is_setting && others.matches('.').count() >= 6
}

impl<'q> Sections<'q> {
    /// The sections of what is checked already.
    pub(super) fn of(body: Field<'q>) -> Result<Self, Message> {
        let mut tokens = body.split('.').peekable();
        let mut omissions = Vec::new();
        let mut heads = [body; HEADS];
        for head in &mut heads {
            let token = tokens.next();
            *head = token.ok_or_else(|| body.wrong("the link ends before its settings"))?;
        }
        let [bits, _, numbers, choices] = heads;
        let is_clockwise = settings(&bits, &mut omissions)?;
        speed(&numbers, is_clockwise, &mut omissions)?;
        let unit = unit(&choices)?;
        // For some weeks a list of names stood here. It was empty where nobody had given any.
        tokens.next_if(|token| token.text().is_empty());
        let mut section = |what: &str| -> Result<Vec<Field<'q>>, Message> {
            let mut all = Vec::new();
            loop {
                let token = tokens.next();
                let token =
                    token.ok_or_else(|| body.wrong(format!("the link ends before {what}")))?;
                if token.text().is_empty() {
                    return Ok(all);
                }
                all.push(token);
            }
        };
        let joints = section("the end of its joints")?;
        let links = section("the end of its links")?;
        // What is selected stands behind the forces, since August 2023.
        let forces: Vec<Field<'q>> = tokens
            .by_ref()
            .take_while(|token| !token.text().is_empty())
            .collect();
        let selected = tokens.next();
        if let Some(more) = selected.and_then(|_| tokens.next()) {
            return Err(more.wrong("nothing stands here in a link of PMKS+"));
        }
        Ok(Self {
            body,
            unit,
            joints,
            links,
            forces,
            omissions,
        })
    }

    /// What stands in them.
    pub(super) fn read<G: Generation>(self) -> Result<Linkage, Message> {
        let mut omissions = self.omissions;
        let mut joint_ids = Ids::of("joint");
        let joints = self.joints.into_iter();
        let joints = joints
            .map(|field| G::joint(field, &mut joint_ids))
            .collect::<Result<Vec<_>, _>>()?;
        let mut link_ids = Ids::of("link");
        let drafts = self.links.into_iter();
        let drafts = drafts
            .map(|field| G::link(field, &joint_ids, &mut link_ids, &mut omissions))
            .collect::<Result<Vec<_>, _>>()?;
        let links = drafts.into_iter().map(|(mut link, welded)| {
            link.welded = link_ids.find_all(welded.into_iter())?;
            Ok(link)
        });
        let links = links.collect::<Result<Vec<_>, Message>>()?;
        if !links.iter().any(|link| link.is_root) {
            let text = "this link has no link of a mechanism in it";
            return Err(self.body.wrong(text));
        }
        let forces = self.forces.into_iter();
        let forces = forces
            .map(|field| G::force(field, &link_ids))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Linkage {
            unit: self.unit,
            joints,
            links,
            forces,
            omissions,
        })
    }
}

/// The fields of something, which has so many.
pub(super) fn fields<'q, const COUNT: usize>(
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

/// The flags and the id with which something begins.
pub(super) fn flags_and_id<'q>(
    field: &Field<'q>,
    head: &Field<'q>,
    what: &str,
) -> Result<([bool; 6], Field<'q>), Message> {
    let (bits, id) = head
        .first()
        .ok_or_else(|| field.wrong(format!("the flags and the id of a {what} are missing here")))?;
    Ok((flags(&bits)?, id))
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
