//! The sections of a link whose numbers are to the base 64: settings, joints, links and forces.

use super::corrections::Correction;
use super::digits::{decimal, digit, flags, whole};
use super::linkage::{Force, Ids, Joint, Link, Linkage, Slot, Speeds, UNITS, Unit};
use super::query::Field;
use crate::document::Message;
use crate::import::drawing::Omission;

/// The first letters of entries in the last section that only the editor of drawings needs: locks of joints, links and forces, references
/// of mass centres, goals of a synthesis, and lengths that are held.
const OF_EDITOR: [char; 6] = ['J', 'L', 'F', 'C', 'S', 'H'];
/// The number of digits that hold the flags of the settings.
const SETTINGS: usize = 2;

/// The number of sections before the joints: settings with flags, decimals, whole numbers, and choices.
pub(super) const HEADS: usize = 4;

pub(super) struct Sections<'q> {
    body: Field<'q>,
    unit: Option<Unit>,
    has_gravity: bool,
    speeds: Speeds,
    joints: Vec<Field<'q>>,
    links: Vec<Field<'q>>,
    forces: Vec<Field<'q>>,
    corrections: Vec<Correction<'q>>,
    omissions: Vec<Omission>,
}

/// A link, and the ids of those that are welded into it.
pub(super) type Draft<'q> = (Link, Vec<Field<'q>>);

/// A joint, and the ids of a link and two joints of it if it slides between these.
pub(super) type JointDraft<'q> = (Joint, Option<[Field<'q>; 3]>);

/// The way in which a generation of links writes its sections.
pub(super) trait Generation {
    fn joint<'q>(
        field: Field<'q>,
        ids: &mut Ids<'q>,
        omissions: &mut Vec<Omission>,
    ) -> Result<JointDraft<'q>, Message>;
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
    /// The sections of a link whose checksum was tested already.
    pub(super) fn of(body: Field<'q>) -> Result<Self, Message> {
        let mut tokens = body.split('.').peekable();
        let mut omissions = Vec::new();
        let mut heads = [body; HEADS];
        for head in &mut heads {
            let token = tokens.next();
            *head = token.ok_or_else(|| body.wrong("the link ends before its settings"))?;
        }
        let [bits, decimals, numbers, choices] = heads;
        let (is_clockwise, has_gravity) = settings(&bits)?;
        let speeds = speeds(&decimals, &numbers, is_clockwise)?;
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
        // Since August 2023, the selection stands behind the forces.
        let forces: Vec<Field<'q>> =
            tokens.by_ref().take_while(|token| !token.text().is_empty()).collect();
        tokens.next();
        // Since 2025, entries of the editor follow. They may have points in them.
        let extras = tokens.next().map(|first| first.through(body));
        let corrections = extras.map(|extras| read_extras(extras, &mut omissions));
        let corrections = corrections.transpose()?.unwrap_or_default();
        Ok(Self { body, unit, has_gravity, speeds, joints, links, forces, corrections, omissions })
    }

    pub(super) fn read<G: Generation>(self) -> Result<Linkage, Message> {
        let mut omissions = self.omissions;
        let mut joint_ids = Ids::of("joint");
        let joints = self.joints.into_iter();
        let joints = joints
            .map(|field| G::joint(field, &mut joint_ids, &mut omissions))
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
        let mut links = links.collect::<Result<Vec<_>, Message>>()?;
        if !links.iter().any(|link| link.is_root) {
            let text = "this link has no link of a mechanism in it";
            return Err(self.body.wrong(text));
        }
        let joints = joints.into_iter().map(|(mut joint, slot)| {
            if let Some(slot) = slot {
                joint.slot = Some(slot_of(&joint, slot, (&joint_ids, &link_ids), &links)?);
            }
            Ok(joint)
        });
        let mut joints = joints.collect::<Result<Vec<_>, Message>>()?;
        let mut speeds = self.speeds;
        for correction in &self.corrections {
            let (all, every) = (&mut joints[..], &mut links[..]);
            if !correction.apply((all, &joint_ids), (every, &link_ids), &mut speeds)? {
                let what = "a number with more than three decimals is read with three";
                omissions.push(Omission::new(format!("`{}`", short(correction.text())), what));
            }
        }
        for link in &mut links {
            link.mass = link.mass.filter(|mass| mass.value > 0.0);
        }
        let forces = self.forces.into_iter();
        let forces =
            forces.map(|field| G::force(field, &link_ids)).collect::<Result<Vec<_>, _>>()?;
        Ok(Linkage {
            unit: self.unit,
            has_gravity: self.has_gravity,
            speeds,
            joints,
            links,
            forces,
            omissions,
        })
    }
}

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

fn slot_of<'q>(
    joint: &Joint,
    [carrier, first, second]: [Field<'q>; 3],
    (joints, links): (&Ids<'q>, &Ids<'q>),
    all: &[Link],
) -> Result<Slot, Message> {
    if joint.along.is_none() || joint.is_grounded {
        let text = "only a joint that slides, and not on the ground, slides on a link";
        return Err(carrier.wrong(text));
    }
    let link = links.find(&carrier)?;
    let ends = [joints.find(&first)?, joints.find(&second)?];
    if ends[0] == ends[1] {
        return Err(second.wrong("a slot goes from one joint of a link to another"));
    }
    for (end, field) in ends.into_iter().zip([first, second]) {
        if !all[link].joints.contains(&end) {
            let text = format!("link `{}` has no joint `{}`", carrier.text(), field.text());
            return Err(field.wrong(text));
        }
    }
    Ok(Slot { carrier: link, ends })
}

/// Reads whether the input turns clockwise, and whether gravity acts: links of before its switch mean that it does.
fn settings(field: &Field<'_>) -> Result<(bool, bool), Message> {
    let is_right = field.text().chars().count() == SETTINGS;
    let digits = field.last().filter(|_| is_right);
    let (high, low) = digits.ok_or_else(|| {
        let text = field.text();
        field.wrong(format!("the settings are {SETTINGS} digits, not `{text}`"))
    })?;
    let [is_clockwise, ..] = flags(&low)?;
    let [_, _, is_gravity_off, ..] = flags(&high)?;
    Ok((is_clockwise, !is_gravity_off))
}

/// Reads the speeds of inputs: the first whole number, and the second decimal, which came in 2025.
fn speeds(
    decimals: &Field<'_>,
    numbers: &Field<'_>,
    is_clockwise: bool,
) -> Result<Speeds, Message> {
    let sense = if is_clockwise { -1.0 } else { 1.0 };
    let all: Result<Vec<f64>, _> = numbers.split(',').map(|number| whole(&number)).collect();
    let turning = all?.first().map_or(0.0, |turns| sense * turns);
    let sliding = decimals.split(',').nth(1);
    let sliding = sliding.map_or(Ok(0.0), |speed| decimal(&speed))?;
    Ok(Speeds { turning, sliding })
}

/// Reads the last section: numbers with more decimals. Notes what of the others is no matter of the editor.
fn read_extras<'q>(
    section: Field<'q>,
    omissions: &mut Vec<Omission>,
) -> Result<Vec<Correction<'q>>, Message> {
    let mut corrections = Vec::new();
    for entry in section.split(',') {
        let text = entry.text();
        let what = match text.chars().next() {
            None => continue,
            Some('P') => {
                corrections.push(Correction::read(entry)?);
                continue;
            }
            Some(_) if text.starts_with("G1~") => "its gears are not read",
            Some(letter) if OF_EDITOR.contains(&letter) => continue,
            Some(_) => "this entry of the last section is not known",
        };
        omissions.push(Omission::new(format!("`{}`", short(text)), what));
    }
    Ok(corrections)
}

fn short(text: &str) -> String {
    text.chars().take(20).collect()
}

fn unit(field: &Field<'_>) -> Result<Option<Unit>, Message> {
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
