//! Wheels that cannot roll on each other.

use super::Words;
use super::wording::brief;
use crate::model::{JointId, LinkId, Ratio};
use crate::structure::MeshTrouble;

impl Words<'_> {
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
                let how = if ratio.is_internal() {
                    "differ by"
                } else {
                    "add up to"
                };
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
