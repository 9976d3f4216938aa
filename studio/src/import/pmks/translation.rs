//! A linkage of PMKS+ as a drawing.

use super::linkage::{Force, Joint, Link, Linkage};
use crate::import::Imported;
use crate::import::drawing::{
    self, Direction, Drawing, End, Form, Load, Mass, Motor, Omission, Pair, Point, Speed,
};
use crate::text::rounded;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// Links have angles in thousandths of a radian.
const ROUNDING: f64 = 0.000_501;
/// Angles in degrees that people draw at.
const USUAL: f64 = 15.0;

pub(super) fn translate(mut linkage: Linkage) -> Imported {
    fold(&mut linkage);
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
    Imported { drawing: translation.drawing, omissions: translation.omissions }
}

struct Translation<'l> {
    linkage: &'l Linkage,
    /// The end for each link; none if it is welded into another, or carries nothing.
    ends: Vec<Option<End>>,
    drawing: Drawing,
    omissions: Vec<Omission>,
}

/// Moves what belongs to a slide to the slide: pins of its block may be on the ground, or the input, for it.
fn fold(linkage: &mut Linkage) {
    for block in linkage.links.iter().filter(|link| link.is_block) {
        let &[a, b] = &block.joints[..] else {
            continue;
        };
        let slides = |joint: usize| linkage.joints[joint].along.is_some();
        let (slide, pin) = match [slides(a), slides(b)] {
            [true, false] => (a, b),
            [false, true] => (b, a),
            _ => continue,
        };
        let pin = &mut linkage.joints[pin];
        let is_input = std::mem::take(&mut pin.is_input);
        let is_grounded = std::mem::take(&mut pin.is_grounded);
        let speed = std::mem::take(&mut pin.speed);
        let slide = &mut linkage.joints[slide];
        slide.is_input |= is_input;
        slide.is_grounded |= is_grounded && slide.slot.is_none();
        if slide.speed == 0.0 {
            slide.speed = speed;
        }
    }
}

/// Finds the end for each link: links that are welded together are one.
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
        let joints = together.clone().flat_map(|(link, _)| &link.joints);
        if are_fixed(linkage, joints) {
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
    for (number, joint) in joints.filter(|(_, joint)| joint.is_welded) {
        let links = linkage.links.iter().enumerate();
        let links = links.filter(|(_, link)| link.is_root && link.joints.contains(&number));
        // Where a weld made one link of several, others are pinned to it, but for blocks.
        let is_made = |link: &Link| !link.welded.is_empty();
        let is_pinned = |link: &Link| !link.is_block && !is_made(link);
        let has_made = joint.along.is_none() && links.clone().any(|(_, link)| is_made(link));
        let links = links.filter(|(_, link)| !(has_made && is_pinned(link)));
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

/// Whether two pivots hold the link with these joints to the ground.
fn are_fixed<'l>(linkage: &Linkage, joints: impl Iterator<Item = &'l usize>) -> bool {
    let joints = joints.map(|joint| &linkage.joints[*joint]);
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
        let mut mass = link.mass.map(|mass| self.weighed(mass));
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

    /// A mass in the units of the text.
    fn weighed(&self, mass: Mass) -> Mass {
        let factors = self.linkage.unit.map(|unit| [unit.mass, unit.inertia]);
        let [value, inertia] = factors.unwrap_or([1.0, 1.0]);
        Mass { value: mass.value * value, inertia: mass.inertia * inertia, ..mass }
    }

    /// Returns the end for a link, or for the link into which it is welded.
    fn end(&self, link: usize) -> Option<End> {
        let links = self.linkage.links.iter().zip(&self.ends).enumerate();
        let mut holders = links.filter(|(number, (other, _))| {
            *number == link || other.is_root && other.welded.contains(&link)
        });
        holders.find_map(|(_, (_, end))| *end)
    }

    /// The links at a joint that are drawn, in their order, each once.
    fn links_at(&self, number: usize) -> Vec<End> {
        let links = self.linkage.links.iter().zip(&self.ends);
        let links = links.filter(|(link, _)| link.joints.contains(&number));
        let mut all: Vec<End> = links.filter_map(|(_, end)| *end).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Returns the end on which a joint is fixed or slides: the link that has its slot, or the ground.
    fn track(&self, joint: &Joint) -> Option<End> {
        let slot = joint.slot.and_then(|slot| self.end(slot.carrier));
        slot.or_else(|| joint.is_grounded.then_some(End::Ground))
    }

    fn joint(&mut self, number: usize) {
        let joint = &self.linkage.joints[number];
        let of = format!("joint {}", joint.name);
        let links = self.links_at(number);
        let track = self.track(joint);
        let mut blocks = self.linkage.links.iter().filter(|link| link.is_block);
        let has_block = blocks.any(|link| link.joints.contains(&number));
        let mut ends: Vec<End> = track.into_iter().chain(links.iter().copied()).collect();
        ends.sort_unstable();
        ends.dedup();
        let form = match joint.along {
            None => Some(Form::Revolute { at: joint.at }),
            Some(angle) => self.along(&of, joint, angle),
        };
        let has_form = form.is_some();
        let first = match (form, track) {
            (None, _) => None,
            (Some(Form::Prismatic { at, along }), Some(track)) if !has_block => {
                self.slide(joint, (at, along), track, &links)
            }
            (Some(form), _) => self.drawing.join_all(&joint.name, &ends, form),
        };
        if joint.is_input {
            match first {
                Some(first) => {
                    self.drawing.motors.push(Motor {
                        joint: first,
                        stroke: None,
                        speed: self.speed(joint),
                    });
                    if ends.len() > 2 {
                        self.omissions.push(Omission::free_links(&of));
                    }
                }
                None => self.omissions.push(Omission::new(&*of, "its motor has nothing to move")),
            }
        }
        if links.is_empty() && !(joint.along.is_none() && track.is_some()) {
            self.omissions.push(Omission::new(&*of, "no link that moves has it"));
        } else if has_form && first.is_none() && track.is_some() && joint.along.is_some() {
            let what = "what slides there and what it slides on are one";
            self.omissions.push(Omission::new(of, what));
        }
        // The path of a block is that of its pin.
        let is_traced = joint.is_traced && !has_block;
        let is_fixed = joint.along.is_none() && ends.contains(&End::Ground);
        let point =
            Point { name: joint.name.clone(), at: joint.at, is_traced: is_traced && !is_fixed };
        self.drawing.mark(&links, point, first.is_some());
    }

    /// Returns the speed of an input, if known.
    fn speed(&self, joint: &Joint) -> Option<Speed> {
        let own = |other: f64| Some(joint.speed).filter(|own| *own != 0.0).unwrap_or(other);
        let speeds = self.linkage.speeds;
        let speed = if joint.along.is_none() {
            Speed::Turns(own(speeds.turning))
        } else {
            Speed::Way(own(speeds.sliding))
        };
        (!speed.is_rest()).then_some(speed)
    }

    /// A line on which something slides: that of its slot, or at an angle.
    fn along(&mut self, of: &str, joint: &Joint, angle: f64) -> Option<Form> {
        let along = match joint.slot {
            None => self.direction(of, angle),
            Some(slot) => {
                let [from, to] = slot.ends.map(|end| self.linkage.joints[end].at);
                if from == to {
                    let what = "both ends of its slot are at one place, so it has no direction";
                    self.omissions.push(Omission::new(of, what));
                    return None;
                }
                Direction::Vector([to[0] - from[0], to[1] - from[1]])
            }
        };
        let at = joint.at;
        Some(Form::Prismatic { at, along })
    }

    /// A joint that slides, without a block that is a link: what slides turns, too, if it is not welded. Gives the number of the joint
    /// that slides, if there is any.
    fn slide(
        &mut self,
        joint: &Joint,
        (at, along): (Pair, Direction),
        track: End,
        links: &[End],
    ) -> Option<usize> {
        let name = &*joint.name;
        let riders: Vec<End> = links.iter().copied().filter(|end| *end != track).collect();
        let (first, others) = riders.split_first()?;
        let block =
            (joint.mass > 0.0).then(|| self.weighed(Mass { value: joint.mass, at, inertia: 0.0 }));
        let (ends, pinned) = match (joint.is_welded || joint.is_sealed, block) {
            (true, _) => ([track, *first], others),
            (false, None) => ([*first, track], others),
            (false, Some(_)) => {
                let block = End::Link(self.drawing.links.len());
                self.drawing.links.push(drawing::Link {
                    name: format!("{name} block"),
                    ..drawing::Link::default()
                });
                ([track, block], &*riders)
            }
        };
        let turns = ends[1] == track;
        let form = if turns {
            let along = Direction::Vector(along.vector());
            Form::Slot { at, along }
        } else {
            Form::Prismatic { at, along }
        };
        let slide = self.drawing.join(name, form, ends);
        let [slides, _] = if turns { ends } else { [ends[1], ends[0]] };
        for other in pinned {
            let pin = format!("{name} pin");
            self.drawing.join(&pin, Form::Revolute { at }, [slides, *other]);
        }
        if let (Some(mass), End::Link(link)) = (block, slides) {
            let own = &mut self.drawing.links[link].mass;
            *own = Some(own.map_or(mass, |own| together(own, mass)));
        }
        Some(slide)
    }

    /// The direction of a slider. What is a usual angle but for rounding is that angle.
    fn direction(&mut self, of: &str, angle: f64) -> Direction {
        // Whole turns are no matter of a direction. Links have three decimals.
        let angle = if angle.abs() < TAU { angle } else { rounded(angle % TAU, 1e-6) };
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
        let Some(End::Link(link)) = self.end(force.link) else {
            let what = "it acts on no link that moves";
            self.omissions.push(Omission::new(of, what));
            return;
        };
        let points = &mut self.drawing.links[link].points;
        let point = points.len();
        points.push(Point { name: force.name.clone(), at: force.at, is_traced: false });
        let name = force.name.clone();
        self.drawing.loads.push(Load { name, link, point });
        let [x, y] = force.parts.map(|part| crate::text::shortest(part, 1e-3));
        let turns = if force.is_local { "; it turns with its link there" } else { "" };
        let what =
            format!("a load gets its force at run time; it is ({x}, {y}) at the start{turns}");
        self.omissions.push(Omission::new(of, what));
    }

    fn remarks(&mut self) {
        let has_masses = self.drawing.links.iter().any(|link| link.mass.is_some());
        let Some(unit) = self.linkage.unit else {
            if has_masses {
                let what = "the unit of length is not known, so neither are those of masses, and gravity is left out";
                self.omissions.push(Omission::new("settings", what));
            }
            return;
        };
        let remarks = &mut self.drawing.remarks;
        remarks.push(format!("Lengths are in {}.", unit.name));
        if has_masses || !self.drawing.loads.is_empty() {
            remarks.push(unit.remark.to_owned());
        }
        if has_masses && self.linkage.has_gravity {
            self.drawing.gravity = Some(unit.gravity);
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
    Mass { value, at, inertia: inertia(a) + inertia(b) }
}
