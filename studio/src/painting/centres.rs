//! Instant centres, with the lines on which Kennedy's theorem has them.

use crate::motion::PlaneMotion;
use mech_compiler::model::{JointId, LinkId, Model};
use mech_core::colors::INK;
use mech_runtime::{Canvas, Outline, Pose};

/// The radius of a dot and the width of a line, in pixels.
const DOT: f64 = 3.5;
const LINE: f64 = 1.0;
/// How far a name begins to the right of its dot and below it, in pixels: names of joints stand above theirs.
const BESIDE: f64 = 5.0;
const BELOW: f64 = 13.0;
/// Of more links only the centres on the ground are shown.
const MOST_LINKS: usize = 6;
/// Places that are nearer than this part of their distance from the origin are one.
const SAME: f64 = 1e-9;

/// The instant centres of a mechanism where it is.
pub(crate) struct Centres {
    /// Each with the names of both links.
    dots: Vec<([f64; 2], String)>,
    /// From a centre to the others on its lines.
    lines: Vec<[[f64; 2]; 2]>,
}

impl Centres {
    /// The centres of links that move so, each with its number and its motion. The ground rests.
    pub(crate) fn of(model: &Model, motions: &[(LinkId, PlaneMotion)]) -> Self {
        let ground = (LinkId::GROUND, PlaneMotion::default());
        let links = [ground].into_iter().chain(motions.iter().copied());
        let links: Vec<(LinkId, PlaneMotion)> = links.collect();
        let all = links.len() <= MOST_LINKS;
        let name = |link: LinkId| model.link(link).name.as_str();
        let joined = |a: LinkId, b: LinkId| {
            let has_place = |joint: &JointId| model.joint(*joint).kind.axes().is_some();
            let mut joints = model.declared_joints().filter(has_place);
            joints.any(|joint| [(a, b), (b, a)].contains(&model.ends(joint)))
        };
        let (mut dots, mut lines): (Vec<([f64; 2], String)>, Vec<_>) = (Vec::new(), Vec::new());
        for (number, &(first, motion)) in links.iter().enumerate() {
            for &(second, other) in &links[number + 1..] {
                if !all && first != LinkId::GROUND {
                    continue;
                }
                let Some(at) = motion.centre(other) else {
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
                        let ends = [motion.centre(between), between.centre(other)];
                        lines.extend(ends.into_iter().flatten().map(|end| [at, end]));
                    }
                }
            }
        }
        Self { dots, lines }
    }

    /// All places of centres.
    pub(crate) fn places(&self) -> impl Iterator<Item = [f64; 2]> {
        self.dots.iter().map(|(at, _)| *at)
    }

    pub(crate) fn paint(&self, canvas: &mut impl Canvas<f64>) {
        let pixel = 1.0 / canvas.scale();
        for line in &self.lines {
            canvas.trace(line, LINE * pixel, INK);
        }
        for (at, text) in &self.dots {
            let dot = Outline::Circle {
                center: *at,
                radius: DOT * pixel,
            };
            canvas.fill(dot, Pose::identity(), INK);
            let [x, y] = *at;
            if text.is_empty() {
                continue;
            }
            canvas.text([x + BESIDE * pixel, y - BELOW * pixel], text, INK);
        }
    }
}

fn is_same([a, b]: [f64; 2], [c, d]: [f64; 2]) -> bool {
    (a - c).hypot(b - d) <= SAME * (1.0 + a.hypot(b))
}
