//! A mechanism as it was drawn in another program: links and joints, placed in the scene.

use super::color::Color;
use super::omission::Omission;

/// The largest number that is read. No drawing comes near it. What is computed of such numbers is finite.
pub(super) const LARGEST: f64 = 1e15;

/// The most connectors, joints and links that are read. No drawing comes near it; noise does.
pub(super) const MOST: usize = 2000;

/// A place in the scene, or a direction.
pub(super) type Pair = [f64; 2];

/// A mechanism as it was drawn in another program. All its places are in the scene, at the start.
#[derive(Clone, Debug, Default)]
pub(super) struct Drawing {
    /// The remarks above the text, a sentence each.
    pub(super) remarks: Vec<String>,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    pub(super) motors: Vec<Motor>,
    pub(super) loads: Vec<Load>,
    /// The acceleration of gravity, where it acts.
    pub(super) gravity: Option<f64>,
    /// The error of lengths that were rounded where they were written.
    pub(super) rounding: f64,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Link {
    /// The name that it should have, if that can be a name.
    pub(super) name: String,
    pub(super) points: Vec<Point>,
    pub(super) mass: Option<Mass>,
    pub(super) color: Option<Color>,
}

/// A named point of a link.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) name: String,
    pub(super) at: Pair,
    /// Whether its path is recorded.
    pub(super) is_traced: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Mass {
    pub(super) value: f64,
    pub(super) at: Pair,
    /// The moment of inertia about it.
    pub(super) inertia: f64,
}

/// An end of a joint: the ground or a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum End {
    Ground,
    /// A link, by its number.
    Link(usize),
}

#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) form: Form,
    pub(super) ends: [End; 2],
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    Revolute {
        at: Pair,
    },
    Prismatic {
        at: Pair,
        along: Direction,
    },
    /// A pin of the first end slides in a slot of the second.
    Slot {
        at: Pair,
        along: Direction,
    },
    Gear(Sizes),
    Belt(Sizes),
}

/// A direction in the scene.
#[derive(Clone, Copy, Debug)]
pub(super) enum Direction {
    Vector(Pair),
    Radians(f64),
    Degrees(f64),
}

impl Direction {
    pub(super) fn vector(self) -> Pair {
        let at = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [cos, sin]
        };
        match self {
            Self::Vector(vector) => vector,
            Self::Radians(angle) => at(angle),
            Self::Degrees(angle) => at(angle.to_radians()),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Sizes {
    /// Numbers of teeth, which fit at any distance.
    Teeth([u64; 2]),
    /// In the unit of length.
    Radii(Pair),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Motor {
    pub(super) joint: usize,
    /// The distance from the start to the end of its range, if known.
    pub(super) stroke: Option<f64>,
    pub(super) speed: Option<Speed>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Speed {
    /// In turns a minute; counter-clockwise above zero.
    Turns(f64),
    /// In cycles a minute: to the end of the stroke and back.
    Cycles(f64),
    /// In units of length a second.
    Way(f64),
}

impl Speed {
    /// Whether it does not move at all.
    pub(super) fn is_rest(self) -> bool {
        let (Self::Turns(speed) | Self::Cycles(speed) | Self::Way(speed)) = self;
        speed == 0.0
    }
}

/// A force at a point of a link.
#[derive(Clone, Debug)]
pub(super) struct Load {
    pub(super) name: String,
    pub(super) link: usize,
    pub(super) point: usize,
}

/// A drawing, and what it could not hold.
#[derive(Clone, Debug, Default)]
pub(crate) struct Imported {
    pub(super) drawing: Drawing,
    pub(crate) omissions: Vec<Omission>,
}

impl Drawing {
    /// Joins all ends at a pin: each one to the first. Gives the number of the first joint, if there is any.
    pub(super) fn pin(&mut self, name: &str, at: Pair, ends: &[End]) -> Option<usize> {
        self.join_all(name, ends, Form::Revolute { at })
    }

    /// Joins each end to the first. Gives the number of the first joint, if there is any.
    pub(super) fn join_all(&mut self, name: &str, ends: &[End], form: Form) -> Option<usize> {
        let (first, others) = ends.split_first()?;
        let start = self.joints.len();
        for other in others {
            self.join(name, form, [*first, *other]);
        }
        (!others.is_empty()).then_some(start)
    }

    /// Adds a joint, and gives its number.
    pub(super) fn join(&mut self, name: &str, form: Form, ends: [End; 2]) -> usize {
        let name = name.to_owned();
        self.joints.push(Joint { name, form, ends });
        self.joints.len() - 1
    }

    /// The places of a link: those of its points and joints, each once.
    pub(super) fn places(&self, link: usize) -> Vec<Pair> {
        let own = self.links[link].points.iter().map(|point| point.at);
        let joints = self
            .joints
            .iter()
            .filter(|joint| joint.ends.contains(&End::Link(link)));
        let mut places = Vec::new();
        for at in joints.filter_map(Joint::at).chain(own) {
            if !places.contains(&at) {
                places.push(at);
            }
        }
        places
    }

    pub(super) fn is_wheel(&self, link: usize) -> bool {
        let mut joints = self.joints.iter();
        joints.any(|joint| joint.at().is_none() && joint.ends.contains(&End::Link(link)))
    }

    /// The diagonal of the box round all places.
    pub(super) fn size(&self) -> f64 {
        let points = self.links.iter().flat_map(|link| &link.points);
        let joints = self.joints.iter().filter_map(Joint::at);
        let places: Vec<Pair> = points.map(|point| point.at).chain(joints).collect();
        let side = |axis: usize| {
            let values = places.iter().map(|place| place[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            (high - low).max(0.0)
        };
        side(0).hypot(side(1))
    }
}

impl Joint {
    /// Where it is placed; nowhere for wheels.
    pub(super) fn at(&self) -> Option<Pair> {
        match self.form {
            Form::Revolute { at } | Form::Prismatic { at, .. } | Form::Slot { at, .. } => Some(at),
            Form::Gear(_) | Form::Belt(_) => None,
        }
    }
}
