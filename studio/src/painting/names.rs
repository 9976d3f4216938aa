//! The names of joints and links, written where they are.

use super::number_of;
use mech_compiler::Compiled;
use mech_compiler::model::{LinkId, Model};
use mech_core::colors::INK;
use mech_runtime::{Canvas, Pose};

/// How far a name begins from its place, in pixels: of a joint, of a link that has one place, and of any other link.
const ABOVE: [f64; 2] = [7.0, 7.0];
const BELOW: [f64; 2] = [7.0, -13.0];
const THERE: [f64; 2] = [0.0, 0.0];

/// A name that goes with a link.
pub(super) struct Label {
    /// The number of the link in a table of poses.
    link: usize,
    /// Where it is in the link.
    at: [f64; 2],
    /// How far from there it begins, in pixels.
    away: [f64; 2],
    text: String,
}

impl Label {
    /// The names of all joints that have a place, and of all links in the midst of their axes.
    pub(super) fn of_all(model: &Model, compiled: &Compiled) -> Vec<Self> {
        let mut labels: Vec<Self> = Vec::new();
        let joints = model.declared_joints().filter_map(|joint| {
            let [_, axis] = model.joint(joint).kind.axes()?;
            let axis = model.axis(model.seen_axis(axis));
            let link = number_of(compiled, axis.link)?;
            Some((link, axis.at, &model.joint(joint).name))
        });
        for (link, at, name) in joints {
            // Of several joints in one place each is named.
            let known = labels.iter_mut().find(|label| label.link == link && label.at == at);
            match known {
                Some(label) => label.text += &format!(", {name}"),
                None => labels.push(Self { link, at, away: ABOVE, text: name.clone() }),
            }
        }
        labels.extend(model.declared_links().filter_map(|link| {
            let (at, away) = midst(model, link)?;
            Some(Self {
                link: number_of(compiled, link)?,
                at,
                away,
                text: model.link(link).name.clone(),
            })
        }));
        labels
    }

    pub(super) fn paint(&self, poses: &[Pose<f64>], canvas: &mut impl Canvas<f64>) {
        let Some(pose) = Pose::of_link(self.link, poses) else {
            return;
        };
        let ([x, y], [right, up]) = (pose.apply(self.at), self.away);
        let scale = canvas.scale();
        canvas.text([x + right / scale, y + up / scale], &self.text, INK);
    }
}

/// The midst of the places at which a link has something, and how far from there its name begins; none if it has nothing.
fn midst(model: &Model, link: LinkId) -> Option<([f64; 2], [f64; 2])> {
    let axes = model.axes.iter().filter(|axis| axis.link == link);
    let mut places: Vec<[f64; 2]> = Vec::new();
    for axis in axes {
        if !places.contains(&axis.at) {
            places.push(axis.at);
        }
    }
    let count = u32::try_from(places.len()).ok().filter(|count| *count > 0)?;
    let sum = places.iter().fold([0.0; 2], |[x, y], [dx, dy]| [x + dx, y + dy]);
    let away = if count == 1 { BELOW } else { THERE };
    Some((sum.map(|part| part / f64::from(count)), away))
}
