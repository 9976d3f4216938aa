//! Instant centres, with the lines on which Kennedy's theorem has them.

use super::Place;
use super::mark::Mark;
use super::spot::{is_near, is_same};
use crate::motion::PlaneMotion;
use crate::quantity::{Position, Surveyed};
use mech_compiler::model::{JointId, LinkId};
use mech_core::colors::INK;

/// Of more links only the centres on the ground are shown.
const MOST_LINKS: usize = 6;
/// Where a name begins, to the right of its dot and below it: names of joints stand above theirs.
const BELOW: Place = [5.0, -13.0];

/// The instant centres of a mechanism where it is, each with the names of both links; none where its velocities are not determined.
pub(super) fn centres(survey: Surveyed<'_>, at: &Position) -> Option<Vec<Mark>> {
    let Surveyed { model, compiled, .. } = survey;
    at.rates.as_ref()?;
    let links = [LinkId::GROUND].into_iter().chain(model.declared_links());
    let links = links.filter_map(|link| Some((link, at.motion(compiled, link)?)));
    let links: Vec<_> = links.collect();
    let all = links.len() <= MOST_LINKS;
    let name = |link: LinkId| model.link(link).name.as_str();
    let joined = |a: LinkId, b: LinkId| {
        let has_place = |joint: &JointId| model.joint(*joint).kind.axes().is_some();
        let mut joints = model.declared_joints().filter(has_place);
        joints.any(|joint| [(a, b), (b, a)].contains(&model.ends(joint)))
    };
    let centre = |one: PlaneMotion, other| {
        let found = one.centre(other);
        found.filter(|place| is_near(model, *place))
    };
    let (mut dots, mut marks): (Vec<(Place, String)>, Vec<Mark>) = (Vec::new(), Vec::new());
    for (number, &(first, motion)) in links.iter().enumerate() {
        for &(second, other) in &links[number + 1..] {
            if !all && first != LinkId::GROUND {
                continue;
            }
            let Some(at) = centre(motion, other) else {
                continue;
            };
            // A pin is the centre of the links that it joins, and has a name of its own.
            let text = if joined(first, second) {
                String::new()
            } else {
                format!("{} {}", name(first), name(second))
            };
            match dots.iter_mut().find(|(known, _)| is_same(*known, at)) {
                Some((_, names)) if names.is_empty() => *names = text,
                Some((_, names)) if !text.is_empty() => *names += &format!(", {text}"),
                Some(_) => {}
                None => dots.push((at, text)),
            }
            if joined(first, second) {
                continue;
            }
            // With a third link that both are joined to, three centres lie in one line.
            for &(third, between) in &links {
                if joined(first, third) && joined(third, second) {
                    let ends = [centre(motion, between), centre(between, other)];
                    marks.extend(
                        ends.into_iter()
                            .flatten()
                            .map(|end| Mark::Line { ends: [at, end], color: INK }),
                    );
                }
            }
        }
    }
    for (at, text) in dots {
        marks.push(Mark::Dot(at));
        if !text.is_empty() {
            marks.push(Mark::Text { at, away: BELOW, text });
        }
    }
    Some(marks)
}
