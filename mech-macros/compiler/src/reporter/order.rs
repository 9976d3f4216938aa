//! Loops that wait for each other.

use super::Words;
use crate::model::{JointId, Origin};
use crate::repair::Offers;

impl Words<'_> {
    /// One message for each loop, at the first of its joints that no loop before it has; the first says what helps.
    pub(super) fn cycle(
        &self,
        waiting: &[JointId],
        rings: &[Vec<JointId>],
        offers: &Offers,
    ) -> Vec<(Origin, String)> {
        let origin = |joint: Option<&JointId>| {
            joint.map_or(self.model.origin, |&joint| self.model.joint(joint).origin)
        };
        let help = self.help(offers);
        if rings.len() < 2 {
            let text = format!(
                "the mechanism is not sequential: {} wait for each other, and no loop among them has only three \
                 unknowns{help}",
                self.the_joints(waiting, ["has to", ""]).trim_end()
            );
            return vec![(origin(waiting.first()), text)];
        }
        let named: Vec<String> = rings
            .iter()
            .map(|ring| format!("loop `{}`", self.joint_names(ring).join(" ")))
            .collect();
        let message = |(index, ring): (usize, &Vec<JointId>)| {
            let earlier = &rings[..index];
            let own = |joint: &&JointId| !earlier.iter().any(|ring| ring.contains(joint));
            let at = origin(ring.iter().find(own).or(ring.first()));
            let (before, after) = named.split_at(index);
            let round = [after, before, &after[..1]].concat().join(" → ");
            let help = if index == 0 { &help[..] } else { "" };
            let text = format!(
                "the mechanism is not sequential: {} cannot be solved alone\nnote: each of these loops has more than three \
                 unknowns, and they wait for each other: {round}{help}",
                named[index]
            );
            (at, text)
        };
        rings.iter().enumerate().map(message).collect()
    }
}
