//! Messages about the carriers of gears, belts and racks, and about wheels that cannot roll on each other.

use super::Words;
use super::wording::{brief, one_of};
use crate::model::{JointId, JointKind, LinkId, Ratio};
use crate::repair::{Offers, Repair};
use crate::structure::MeshTrouble;

impl Words<'_> {
    pub(super) fn no_carrier(&self, id: JointId, offers: &Offers) -> String {
        let (a, b) = self.model.ends(id);
        let (first, second) = (self.link(a), self.link(b));
        let (holds, help) = match self.model.joint(id).kind {
            JointKind::Rack { .. } => (
                format!("{first} turns on no link on which {second} slides"),
                "let the pinion turn on the link on which the bar slides, or on its shaft",
            ),
            _ => (
                format!("there is no link on which both {first} and {second} turn"),
                "let both wheels turn on the ground or on one common link",
            ),
        };
        let attaches = |repair: &Repair| matches!(repair, Repair::Attach { .. });
        let help = if offers.single.iter().all(attaches) && offers.pairs.is_empty() {
            // What these have in common is told before them.
            format!("\nhelp: {help}") + &self.help(offers).replacen("help: ", "help: or ", 1)
        } else {
            self.help(offers)
        };
        format!("nothing carries {} {}: {holds}{help}", self.rolling(id), self.joint(id))
    }

    pub(super) fn not_carrier(&self, id: JointId, named: LinkId, offers: &Offers) -> String {
        let (a, b) = self.model.ends(id);
        let (first, second, named) = (self.link(a), self.link(b), self.link(named));
        let should = match self.model.joint(id).kind {
            JointKind::Rack { .. } => {
                format!("{first} does not turn on it, or {second} does not slide on it")
            }
            _ => format!("{first} and {second} do not both turn on it"),
        };
        format!(
            "{named} does not carry {} {}: {should}{}",
            self.rolling(id),
            self.joint(id),
            self.help(offers)
        )
    }

    pub(super) fn several_carriers(&self, id: JointId, carriers: &[LinkId]) -> String {
        let links: Vec<String> = carriers.iter().map(|&link| self.link(link)).collect();
        let clauses: Vec<String> =
            carriers.iter().map(|&link| format!("`on {}`", self.model.link(link).name)).collect();
        let (moves, after) = match self.model.joint(id).kind {
            JointKind::Rack { .. } => ("its pinion turns and its bar slides on", "radius"),
            _ => ("both of its wheels turn on", "ratio"),
        };
        format!(
            "several links could carry {} {}: {moves} {}\nhelp: say which is meant: write {} after the {after}",
            self.rolling(id),
            self.joint(id),
            links.join(" and on "),
            one_of(&clauses)
        )
    }

    pub(super) fn no_mesh(
        &self,
        joint: JointId,
        carrier: LinkId,
        ratio: Ratio,
        trouble: MeshTrouble,
    ) -> String {
        let (a, b) = self.model.ends(joint);
        let (first, second) = (self.link(a), self.link(b));
        let what = format!("{} {}", self.rolling(joint), self.joint(joint));
        let [one, other] = ratio.sizes().map(|size| brief(size.abs()));
        match trouble {
            MeshTrouble::OneShaft => format!(
                "{what} joins two wheels on one shaft: {first} and {second} turn about the same point of {}\nnote: \
                 wheels that mesh turn on two shafts; those that turn together are joined by `weld`",
                self.link(carrier)
            ),
            MeshTrouble::SmallRing => {
                let unit = match ratio {
                    Ratio::Teeth(..) => "teeth",
                    Ratio::Radii(..) => "radii",
                };
                format!(
                    "the ring of {what} is not larger than its wheel: {unit} of {first} and {second} are {one} and \
                     {other}; the negative size is the ring's"
                )
            }
            MeshTrouble::Distance { distance, asked } => {
                let how = if ratio.is_internal() { "differ by" } else { "add up to" };
                format!(
                    "the radii of {what} do not fit: the axes of {first} and {second} are {} apart on {}, but radii {one} \
                     and {other} {how} {}",
                    brief(distance),
                    self.link(carrier),
                    brief(asked)
                ) + "\nnote: whole numbers are teeth, which give the ratio alone and fit at any distance"
            }
        }
    }
}
