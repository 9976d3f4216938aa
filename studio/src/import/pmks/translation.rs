//! A linkage of PMKS+ as a drawing.

use super::linkage::{Force, Joint, Link, Linkage};
use crate::import::Imported;
use crate::import::drawing::{self, Direction, Drawing, End, Form, Load, Mass, Motor, Point};
use crate::import::omission::Omission;
use std::collections::{BTreeMap, BTreeSet};

/// Links have angles in thousandths of a radian.
const ROUNDING: f64 = 0.000_501;
/// Angles in degrees that people draw at.
const USUAL: f64 = 15.0;

/// The drawing of a linkage.
pub(super) fn translate(mut linkage: Linkage) -> Imported {
    let omissions = std::mem::take(&mut linkage.omissions);
    let mut translation = Translation {
        ends: ends(&linkage),
        linkage: &linkage,
        drawing: Drawing::default(),
        omissions,
    };
    translation.links();
    for joint in 0..linkage.joints.len() {
        translation.joint(joint);
    }
    for force in &linkage.forces {
        translation.force(force);
    }
    translation.remarks();
    Imported {
        drawing: translation.drawing,
        omissions: translation.omissions,
    }
}

struct Translation<'l> {
    linkage: &'l Linkage,
    /// What each link is; nothing if it is welded into another, or carries nothing.
    ends: Vec<Option<End>>,
    drawing: Drawing,
    omissions: Vec<Omission>,
}

/// What each link is: links that are welded together are one.
fn ends(linkage: &Linkage) -> Vec<Option<End>> {
    let firsts = firsts(linkage);
    let mut numbers = BTreeMap::new();
    let links = linkage.links.iter().zip(&firsts);
    let ends = links.map(|(link, first)| {
        if !link.is_root {
            return None;
        }
        let all = linkage.links.iter().zip(&firsts);
        let mut together = all.filter(|(link, other)| link.is_root && *other == first);
        if together.clone().any(|(link, _)| is_fixed(linkage, link)) {
            return Some(End::Ground);
        }
        if together.all(|(link, _)| link.joints.len() < 2) {
            return None;
        }
        let count = numbers.len();
        Some(End::Link(*numbers.entry(*first).or_insert(count)))
    });
    ends.collect()
}

/// For each link the first of those that it is welded to, itself included.
fn firsts(linkage: &Linkage) -> Vec<usize> {
    let mut firsts: Vec<usize> = (0..linkage.links.len()).collect();
    let joints = linkage.joints.iter().enumerate();
    for (joint, _) in joints.filter(|(_, joint)| joint.is_welded) {
        let links = linkage.links.iter().enumerate();
        let links = links.filter(|(_, link)| link.is_root && link.joints.contains(&joint));
        let groups: BTreeSet<usize> = links.map(|(link, _)| firsts[link]).collect();
        let Some(least) = groups.first() else {
            continue;
        };
        for first in &mut firsts {
            if groups.contains(first) {
                *first = *least;
            }
        }
    }
    firsts
}

/// Whether a link cannot move, as two pivots hold it to the ground.
fn is_fixed(linkage: &Linkage, link: &Link) -> bool {
    let joints = link.joints.iter().map(|joint| &linkage.joints[*joint]);
    let mut pivots = joints.filter(|joint| joint.is_grounded && joint.along.is_none());
    match pivots.next() {
        Some(first) => pivots.any(|other| other.at != first.at),
        None => false,
    }
}

impl Translation<'_> {
    fn links(&mut self) {
        for (number, link) in self.linkage.links.iter().enumerate() {
            let of = format!("link {}", link.name);
            match self.ends[number] {
                None if link.is_root => {
                    let what = "it has one joint, so it carries nothing";
                    self.omissions.push(Omission::new(of, what));
                }
                None if link.mass.is_some() => {
                    let what = "it is welded into another link, whose mass counts alone";
                    self.omissions.push(Omission::new(of, what));
                }
                None => {}
                Some(End::Ground) => {
                    let what = "two pivots hold it to the ground, so it is a part of the ground";
                    self.omissions.push(Omission::new(of, what));
                }
                Some(End::Link(drawn)) => self.link(drawn, link),
            }
        }
    }

    /// Adds a link, or what else is welded to it.
    fn link(&mut self, number: usize, link: &Link) {
        let mut mass = link.mass;
        if let (true, Some(mass), Some(joint)) = (link.is_block, &mut mass, link.joints.first()) {
            mass.at = self.linkage.joints[*joint].at;
        }
        let Some(known) = self.drawing.links.get_mut(number) else {
            self.drawing.links.push(drawing::Link {
                name: link.name.clone(),
                mass,
                color: link.color,
                points: Vec::new(),
            });
            return;
        };
        known.mass = match (known.mass, mass) {
            (Some(a), Some(b)) => Some(together(a, b)),
            (a, b) => a.or(b),
        };
    }

    /// What carries a joint: the ground first, then links, each once.
    fn at(&self, number: usize) -> Vec<End> {
        let joint = &self.linkage.joints[number];
        let mut all: Vec<End> = joint
            .is_grounded
            .then_some(End::Ground)
            .into_iter()
            .collect();
        let links = self.linkage.links.iter().zip(&self.ends);
        let links = links.filter(|(link, _)| link.joints.contains(&number));
        for end in links.filter_map(|(_, end)| *end) {
            if !all.contains(&end) {
                all.push(end);
            }
        }
        all.sort_unstable();
        all
    }

    fn joint(&mut self, number: usize) {
        let joint = &self.linkage.joints[number];
        let of = format!("joint {}", joint.name);
        let ends = self.at(number);
        let at = joint.at;
        let form = match joint.along {
            None => Form::Revolute { at },
            Some(angle) => Form::Prismatic {
                at,
                along: self.direction(&of, angle),
            },
        };
        let first = self.drawing.join_all(&joint.name, &ends, form);
        if joint.is_input {
            let stroke = None;
            match first {
                Some(joint) => {
                    self.drawing.motors.push(Motor { joint, stroke });
                    if ends.len() > 2 {
                        self.omissions.push(Omission::free_links(&of));
                    }
                }
                None => self
                    .omissions
                    .push(Omission::new(&*of, "its motor has nothing to move")),
            }
        }
        if ends.is_empty() {
            self.omissions
                .push(Omission::new(of, "no link that moves has it"));
        }
        self.point(joint, &ends, first.is_some());
    }

    /// A point with a name, where a path is recorded or nothing else marks the end of a link.
    fn point(&mut self, joint: &Joint, ends: &[End], has_joint: bool) {
        let is_fixed = ends.contains(&End::Ground) && joint.along.is_none();
        let moving = ends.iter().find_map(|end| match end {
            End::Link(link) => Some(*link),
            End::Ground => None,
        });
        // The path of a slider is that of its pin.
        let is_traced = joint.is_traced && !is_fixed && joint.along.is_none();
        if let Some(link) = moving.filter(|_| is_traced || !has_joint) {
            self.drawing.links[link].points.push(Point {
                name: joint.name.clone(),
                at: joint.at,
                is_traced,
            });
        }
    }

    /// The direction of a slider. What is a usual angle but for rounding is that angle.
    fn direction(&mut self, of: &str, angle: f64) -> Direction {
        if angle == 0.0 {
            return Direction::Vector([1.0, 0.0]);
        }
        let usual = (angle.to_degrees() / USUAL).round() * USUAL;
        if (usual.to_radians() - angle).abs() > ROUNDING {
            return Direction::Radians(angle);
        }
        let what = format!(
            "its angle of {angle} radians is read as {usual} degrees, as links have three decimals"
        );
        self.omissions.push(Omission::new(of, what));
        Direction::Degrees(usual)
    }

    fn force(&mut self, force: &Force) {
        let of = format!("force {}", force.name);
        let links = self.linkage.links.iter().enumerate();
        let holder = |(number, link): (usize, &Link)| {
            let is_it = number == force.link || link.is_root && link.welded.contains(&force.link);
            self.ends[number].filter(|_| is_it)
        };
        let Some(End::Link(link)) = links.into_iter().find_map(holder) else {
            let what = "it acts on no link that moves";
            self.omissions.push(Omission::new(of, what));
            return;
        };
        let points = &mut self.drawing.links[link].points;
        let point = points.len();
        points.push(Point {
            name: force.name.clone(),
            at: force.at,
            is_traced: false,
        });
        let name = force.name.clone();
        self.drawing.loads.push(Load { name, link, point });
        let [x, y] = force.parts.map(|part| crate::text::shortest(part, 1e-3));
        let turns = if force.is_local {
            "; it turns with its link there"
        } else {
            ""
        };
        let what =
            format!("a load gets its force at run time; it is ({x}, {y}) at the start{turns}");
        self.omissions.push(Omission::new(of, what));
    }

    fn remarks(&mut self) {
        if let Some(unit) = self.linkage.unit {
            self.drawing.remarks.push(format!("Lengths are in {unit}."));
        }
        if self.drawing.links.iter().any(|link| link.mass.is_some()) {
            let remark = "Masses and moments of inertia are those of PMKS+.";
            self.drawing.remarks.push(remark.to_owned());
        }
    }
}

/// Two masses as one.
fn together(a: Mass, b: Mass) -> Mass {
    let value = a.value + b.value;
    let at = [0, 1].map(|axis| (a.at[axis] * a.value + b.at[axis] * b.value) / value);
    let inertia = |one: Mass| {
        let [x, y] = [one.at[0] - at[0], one.at[1] - at[1]];
        one.inertia + one.value * (x * x + y * y)
    };
    Mass {
        value,
        at,
        inertia: inertia(a) + inertia(b),
    }
}
