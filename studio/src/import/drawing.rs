//! A mechanism as it was drawn in another program: links and joints, placed in the scene; and what cannot be carried over.

use super::color::Color;
use std::fmt::{self, Display, Formatter};

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
        let joints = self.joints.iter().filter(|joint| joint.ends.contains(&End::Link(link)));
        let mut places = Vec::new();
        for at in joints.filter_map(Joint::at).chain(own) {
            if !places.contains(&at) {
                places.push(at);
            }
        }
        places
    }

    /// Names a place of the first of these ends that moves, where its path is recorded or no joint marks it.
    pub(super) fn mark(&mut self, ends: &[End], point: Point, has_joint: bool) {
        let moving = ends.iter().find_map(|end| match end {
            End::Link(link) => Some(*link),
            End::Ground => None,
        });
        if let Some(link) = moving.filter(|_| point.is_traced || !has_joint) {
            self.links[link].points.push(point);
        }
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

/// Something that could not be carried over, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Omission {
    /// The name of its subject: `connector 3`.
    pub(super) of: String,
    /// The loss, in a sentence.
    pub(super) what: String,
}

impl Omission {
    pub(super) fn new(of: impl Into<String>, what: impl Into<String>) -> Self {
        let (of, what) = (of.into(), what.into());
        Self { of, what }
    }

    /// A motor is on one joint.
    pub(super) fn free_links(of: &str) -> Self {
        let what = "its motor moves the first of several links on it; the others are free";
        Self::new(of, what)
    }
}

impl Display for Omission {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.of, self.what)
    }
}

/// All of it, a line each; nothing if nothing is lost.
pub(crate) fn listed(omissions: &[Omission]) -> String {
    if omissions.is_empty() {
        return String::new();
    }
    let lines = omissions.iter().map(|one| format!("  {one}\n"));
    format!("not carried over:\n{}", lines.collect::<String>())
}

/// For how many turns of the fastest input laws are tried, if not all are back sooner.
const TURNS: f64 = 64.0;
/// The number of steps in which a turn of the fastest input is tried.
const STEPS: f64 = 90.0;
/// Speeds are compared in thousandths.
const THOUSANDTHS: f64 = 1000.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Times {
    /// After which all of them are back where they started, if that is soon.
    pub(super) back: Option<f64>,
    /// For how long laws are tried, and in what steps.
    pub(super) tried: f64,
    pub(super) step: f64,
}

impl Times {
    /// The times of these motors, if several have laws.
    pub(super) fn of(motors: &[Motor]) -> Option<Self> {
        let rates: Vec<f64> = motors.iter().filter_map(Motor::rounds).collect();
        if rates.len() < 2 {
            return None;
        }
        let fastest = rates.iter().copied().fold(0.0, f64::max);
        let longest = 60.0 * TURNS / fastest;
        let common = rates.iter().try_fold(0.0, |common, rate| {
            let thousandths = rate * THOUSANDTHS;
            let whole = thousandths.round();
            ((thousandths - whole).abs() < 1e-6).then(|| divisor(whole, common))
        });
        let back = common.map(|common| 60.0 * THOUSANDTHS / common);
        let back = back.filter(|back| *back <= longest);
        Some(Self { back, tried: back.unwrap_or(longest), step: 60.0 / fastest / STEPS })
    }
}

impl Motor {
    /// Counts the times a minute at which it is back at its start, if a law can say how it moves.
    pub(super) fn rounds(&self) -> Option<f64> {
        match (self.speed?, self.stroke) {
            (Speed::Turns(turns), _) => Some(turns.abs()),
            (Speed::Cycles(cycles), Some(_)) => Some(cycles),
            (Speed::Cycles(_), None) | (Speed::Way(_), _) => None,
        }
    }
}

/// The greatest common divisor of whole numbers.
fn divisor(a: f64, b: f64) -> f64 {
    if b == 0.0 { a } else { divisor(b, a % b) }
}
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_back_after_their_common_period() {
        let back = |rates: &[f64]| {
            let motor =
                |turns: &f64| Motor { joint: 0, stroke: None, speed: Some(Speed::Turns(*turns)) };
            let motors: Vec<Motor> = rates.iter().map(motor).collect();
            Times::of(&motors).and_then(|times| times.back)
        };
        assert_eq!(back(&[15.0, -15.0, 15.0, 18.0]), Some(20.0));
        assert_eq!(back(&[0.5, 0.75]), Some(240.0));
        assert_eq!(back(&[15.0]), None);
        assert_eq!(back(&[15.0, 15.001]), None);
        assert_eq!(back(&[15.0, std::f64::consts::PI]), None);
    }
}
