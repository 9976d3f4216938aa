//! Mechanisms as links and joints in the scene, written as text in any order, with the ends of joints either way round, any link as
//! ground and any joint as motor.

use crate::{Dice, shuffle};
use mech_compiler::model::{JointKind, LinkId, Model, Ratio};
use std::fmt::Write as _;

type Point = [f64; 2];

/// What joins two links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bond {
    /// A pin.
    Pin(Point),
    /// A slide through a point along a direction.
    Slide(Point, Point),
    /// A pin of the first in a slot of the second.
    Slot(Point, Point),
    /// They are one.
    Weld(Point),
    /// Two wheels that roll on each other, and the link that carries them, if that is to be said.
    Gear(Ratio, Option<usize>),
    /// The same with a belt.
    Belt(Ratio, Option<usize>),
}

/// A mechanism as drawn. Links are numbers.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    /// How many links there are.
    pub links: usize,
    /// What joins which.
    pub joints: Vec<(usize, usize, Bond)>,
    /// The joints that are driven.
    pub motors: Vec<usize>,
    /// The link that does not move.
    pub ground: usize,
    /// Words that are allowed.
    pub allow: Vec<&'static str>,
    /// Whether it is of single precision.
    pub single: bool,
}

impl Sketch {
    /// A mechanism as it was drawn: every link's frame is the scene's.
    ///
    /// # Panics
    /// If it has a rack or a cam.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let declared = model.declared_links().count() + 1;
        let mut sketch = Self { links: declared, ..Self::default() };
        for joint in model.joints.iter().filter(|joint| !joint.hidden) {
            let on = |on: Option<LinkId>| on.map(LinkId::index);
            let axes = |a, b| {
                let [a, b] = [a, b].map(|axis| model.axis(axis));
                (a.link.index(), b.link.index(), a.at, a.direction)
            };
            let (a, b, bond) = match joint.kind {
                JointKind::Revolute(a, b) => {
                    let (a, b, at, _) = axes(a, b);
                    (a, b, Bond::Pin(at))
                }
                JointKind::Weld(a, b) => {
                    let (a, b, at, _) = axes(a, b);
                    (a, b, Bond::Weld(at))
                }
                JointKind::Prismatic(a, b) => {
                    if let Some((point, line)) = model.link(model.axis(b).link).die {
                        let (a, b, at, _) = axes(point, line);
                        (a, b, Bond::Slot(at, model.axis(line).direction))
                    } else {
                        let (a, b, at, along) = axes(a, b);
                        (a, b, Bond::Slide(at, along))
                    }
                }
                JointKind::Gear { a, b, ratio, on: carrier } => {
                    (a.index(), b.index(), Bond::Gear(ratio, on(carrier)))
                }
                JointKind::Belt { a, b, ratio, on: carrier } => {
                    (a.index(), b.index(), Bond::Belt(ratio, on(carrier)))
                }
                JointKind::Rack { .. } | JointKind::Cam { .. } => {
                    panic!("a sketch has none of these")
                }
            };
            sketch.join(a, b, bond);
        }
        sketch.allow.extend(model.allow.coupled.then_some("coupled"));
        sketch
    }

    /// Any of the joints that can be driven.
    pub fn any_motor(&self, dice: &mut Dice) -> usize {
        let drivable =
            |joint: &usize| matches!(self.joints[*joint].2, Bond::Pin(_) | Bond::Slide(..));
        let all: Vec<usize> = (0..self.joints.len()).filter(drivable).collect();
        *dice.pick(&all)
    }

    /// A new link.
    pub fn link(&mut self) -> usize {
        self.links += 1;
        self.links - 1
    }

    /// A new joint.
    pub fn join(&mut self, a: usize, b: usize, bond: Bond) -> usize {
        self.joints.push((a, b, bond));
        self.joints.len() - 1
    }

    /// Maps every place and every direction.
    pub fn map(&mut self, place: impl Fn(Point) -> Point, direction: impl Fn(Point) -> Point) {
        for (_, _, bond) in &mut self.joints {
            *bond = match *bond {
                Bond::Pin(at) => Bond::Pin(place(at)),
                Bond::Slide(at, along) => Bond::Slide(place(at), direction(along)),
                Bond::Slot(at, along) => Bond::Slot(place(at), direction(along)),
                Bond::Weld(at) => Bond::Weld(place(at)),
                wheels => wheels,
            };
        }
    }

    /// Turns, mirrors, scales and shifts it: so that whole numbers stay whole, or by any angle, so that equal lengths are equal but for
    /// rounding.
    pub fn place(&mut self, dice: &mut Dice, exact: bool) {
        let (turn, size) = if exact {
            (
                *dice.pick(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]),
                *dice.pick(&[1.0, 1.0, 2.0, 0.25, 3.0]),
            )
        } else {
            let (sin, cos) = dice.between(-3.1, 3.1).sin_cos();
            ([cos, sin], dice.between(-1.5, 1.5).exp())
        };
        let shift = if exact {
            [0, 1].map(|_| 0.5 * f64::from(u32::try_from(dice.below(17)).unwrap_or(0)) - 4.0)
        } else {
            [dice.between(-5.0, 5.0), dice.between(-5.0, 5.0)]
        };
        let mirror = if dice.once_in(2) { -1.0 } else { 1.0 };
        let turned = move |[x, y]: Point| {
            let y = mirror * y;
            [turn[0] * x - turn[1] * y, turn[1] * x + turn[0] * y]
        };
        self.map(
            |at| {
                let [x, y] = turned(at);
                [size * x + shift[0], size * y + shift[1]]
            },
            turned,
        );
    }

    /// As text, in any order and with the ends of joints either way round.
    #[must_use]
    pub fn text(&self, dice: &mut Dice) -> String {
        let mut names: Vec<String> = (0..self.links).map(|number| format!("l{number}")).collect();
        "ground".clone_into(&mut names[self.ground]);
        let mut links: Vec<String> = (0..self.links)
            .filter(|link| *link != self.ground)
            .map(|link| format!("link {};\n", names[link]))
            .collect();
        let joints = self.joints.iter().enumerate().map(|(number, &(mut a, mut b, bond))| {
            let flip = dice.once_in(2);
            if flip && !matches!(bond, Bond::Slot(..)) {
                (a, b) = (b, a);
            }
            let ends = format!("({}, {})", names[a], names[b]);
            let rolling = |word: &str, ratio: Ratio, on: Option<usize>| {
                let ratio = match (flip, ratio) {
                    (false, ratio) => ratio,
                    (true, Ratio::Teeth(a, b)) => Ratio::Teeth(b, a),
                    (true, Ratio::Radii(a, b)) => Ratio::Radii(b, a),
                };
                let on = on.map_or(String::new(), |on| format!(" on {}", names[on]));
                format!("{word}({}, {}, {ratio}{on})", names[a], names[b])
            };
            let what = match bond {
                Bond::Pin([x, y]) => format!("revolute{ends} at ({x:?}, {y:?})"),
                Bond::Slide([x, y], [u, v]) => {
                    let sign = if dice.once_in(2) { -1.0 } else { 1.0 };
                    format!(
                        "prismatic{ends} at ({x:?}, {y:?}) along ({:?}, {:?})",
                        sign * u,
                        sign * v
                    )
                }
                Bond::Slot([x, y], [u, v]) => {
                    format!("slot{ends} at ({x:?}, {y:?}) along ({u:?}, {v:?})")
                }
                Bond::Weld([x, y]) => format!("weld{ends} at ({x:?}, {y:?})"),
                Bond::Gear(ratio, on) => rolling("gear", ratio, on),
                Bond::Belt(ratio, on) => rolling("belt", ratio, on),
            };
            format!("joint j{number} = {what};\n")
        });
        let mut joints: Vec<String> = joints.collect();
        shuffle(&mut links, dice);
        shuffle(&mut joints, dice);
        let precision = if self.single { ": f32" } else { "" };
        let mut text = format!("struct Random{precision};\n{}{}", links.concat(), joints.concat());
        for motor in &self.motors {
            writeln!(text, "motor j{motor};").expect("a string");
        }
        for word in &self.allow {
            writeln!(text, "allow {word};").expect("a string");
        }
        text
    }
}
