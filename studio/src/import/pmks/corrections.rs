//! Numbers with more than three decimals, which stand in the last section of a link: `P[J, L or F][id]~[field]~[number]`.

use super::linkage::{Ids, Joint, Link, Speeds};
use super::query::Field;
use crate::document::Message;
use crate::import::drawing::{LARGEST, Mass};

/// A number that is meant in place of one with three decimals.
pub(super) struct Correction<'q> {
    /// `J`, `L`, `F`, and `D` and `I` of settings.
    kind: char,
    whole: Field<'q>,
    id: Field<'q>,
    field: usize,
    value: f64,
}

impl<'q> Correction<'q> {
    /// Reads an entry behind its `P`.
    pub(super) fn read(entry: Field<'q>) -> Result<Self, Message> {
        let wrong =
            || entry.wrong("a number of more decimals has a kind, an id, a field and a value");
        let parts: Vec<Field<'q>> = entry.split('~').collect();
        let &[head, field, value] = &parts[..] else {
            return Err(wrong());
        };
        let (_, head) = head.first().ok_or_else(wrong)?;
        let (kind, id) = head.first().ok_or_else(wrong)?;
        let number: Option<f64> = value.text().parse().ok();
        let number = number.filter(|number| number.abs() <= LARGEST);
        Ok(Self {
            kind: kind.text().chars().next().ok_or_else(wrong)?,
            whole: entry,
            id,
            field: field.text().parse().map_err(|_| wrong())?,
            value: number.ok_or_else(|| value.wrong("this is no number, or too large"))?,
        })
    }

    /// Puts the number where it belongs. Gives whether there is such a place.
    pub(super) fn apply(
        &self,
        (joints, joint_ids): (&mut [Joint], &Ids<'q>),
        (links, link_ids): (&mut [Link], &Ids<'q>),
        speeds: &mut Speeds,
    ) -> Result<bool, Message> {
        let value = self.value;
        match (self.kind, self.field) {
            ('J', field) => {
                let joint = &mut joints[joint_ids.find(&self.id)?];
                match field {
                    0 | 1 => joint.at[field] = value,
                    2 => joint.along = joint.along.map(|_| value),
                    3 => joint.speed = value,
                    4 if value >= 0.0 => joint.mass = value,
                    _ => return Ok(false),
                }
            }
            ('L', field) => {
                let mass = &mut links[link_ids.find(&self.id)?].mass;
                let mass = mass.get_or_insert(Mass { value: 0.0, at: [0.0, 0.0], inertia: 0.0 });
                match field {
                    0 if value >= 0.0 => mass.value = value,
                    1 if value >= 0.0 => mass.inertia = value,
                    2 | 3 => mass.at[field - 2] = value,
                    _ => return Ok(false),
                }
            }
            // The sense is a switch of its own.
            ('I', 0) => speeds.turning = value.abs().copysign(speeds.turning),
            ('D', 1) => speeds.sliding = value,
            // The scale of pictures, and when the film stands.
            ('D' | 'I', _) => {}
            _ => return Ok(false),
        }
        Ok(true)
    }

    pub(super) fn text(&self) -> &'q str {
        self.whole.text()
    }
}
