//! A document as a drawing.

use super::document::{Connector, Document, Link};
use super::sliding::{Guide, guides};
use super::unions::{Member, Unions};
use crate::import::Imported;
use crate::import::drawing::{
    self, Direction, Drawing, End, Form, Motor, Omission, Pair, Point, Speed,
};

/// Documents have six decimals of a pixel.
const ROUNDING: f64 = 0.500_001e-6;

pub(super) fn translate(mut document: Document) -> Imported {
    let mut omissions = std::mem::take(&mut document.omissions);
    let unions = Unions::of(&document, &mut omissions);
    let mut translation = Translation {
        drawing: Drawing {
            remarks: vec![format!("Lengths are in {}.", document.units.name)],
            links: drawn(&document, &unions),
            rounding: ROUNDING * document.units.scale,
            ..Drawing::default()
        },
        document: &document,
        unions: &unions,
        omissions,
    };
    translation.connectors();
    translation.cylinders();
    translation.ratios();
    translation.pictures();
    Imported { drawing: translation.drawing, omissions: translation.omissions }
}

struct Translation<'d> {
    document: &'d Document,
    unions: &'d Unions,
    drawing: Drawing,
    omissions: Vec<Omission>,
}

/// The links with their names and colours.
fn drawn(document: &Document, unions: &Unions) -> Vec<drawing::Link> {
    let mut halves = ["barrel", "rod"].into_iter().cycle();
    let drawn = unions.links.iter().map(|links| {
        let links = links.iter().map(|link| &document.links[*link]);
        // Wheels that are fastened to a link have its name.
        let first = links.clone().find(|link| !link.is_wheel);
        let first = first.or_else(|| links.clone().next());
        let mut name = first.map(name).unwrap_or_default();
        if first.is_some_and(|link| link.cylinder.is_some()) {
            name += "_";
            name += halves.next().unwrap_or_default();
        }
        drawing::Link {
            name,
            color: links.clone().find_map(|link| link.color),
            ..drawing::Link::default()
        }
    });
    drawn.collect()
}

/// The name of a link: its own, or one made of its id.
fn name(link: &Link) -> String {
    let own = link.name.clone();
    own.unwrap_or_else(|| format!("link_{}", link.id))
}

/// The name of a joint or a point at a connector: its own, or one made of its id.
fn name_at(connector: &Connector, kind: &str) -> String {
    let own = connector.name.clone();
    own.unwrap_or_else(|| format!("{kind}_{}", connector.id))
}

impl Translation<'_> {
    fn omit(&mut self, connector: usize, what: impl Into<String>) {
        let of = format!("connector {}", self.document.connectors[connector].id);
        self.omissions.push(Omission::new(of, what));
    }

    /// Pins, slots and guides.
    fn connectors(&mut self) {
        let (guides, faults) = guides(self.document, self.unions);
        self.omissions.extend(faults);
        let limits: Vec<usize> = self.document.connectors.iter().flat_map(limits).collect();
        for number in 0..self.document.connectors.len() {
            let connector = &self.document.connectors[number];
            let ends = self.unions.at(self.document, number);
            let before = self.drawing.joints.len();
            let pin = self.drawing.pin(&name_at(connector, "pin"), connector.at, &ends);
            if let Some(guide) = guides.get(&number) {
                self.slide(connector, guide);
            }
            if connector.is_input {
                self.motor(number, pin, &ends);
            }
            let has_joint = self.drawing.joints.len() > before;
            self.point(number, &ends, has_joint);
            let is_loose = ends.is_empty() && !limits.contains(&number);
            if is_loose && connector.is_of_mechanism {
                self.omit(number, "it is on no link");
            }
        }
    }

    /// A motor on the first joint of a pin.
    fn motor(&mut self, number: usize, pin: Option<usize>, ends: &[End]) {
        let Some(joint) = pin else {
            self.omit(number, "its motor has nothing to turn");
            return;
        };
        // It turns clockwise where its speed is above zero. Linkage turns inputs on the ground only.
        let turns = self.document.connectors[number].turns;
        let turns = turns.filter(|_| ends.contains(&End::Ground));
        self.drawing.motors.push(Motor {
            joint,
            stroke: None,
            speed: turns.map(|turns| Speed::Turns(-turns)),
        });
        if ends.len() > 2 {
            let of = format!("connector {}", self.document.connectors[number].id);
            self.omissions.push(Omission::free_links(&of));
        }
    }

    /// A point with a name, where a path is recorded or nothing else marks the end of a link.
    fn point(&mut self, number: usize, ends: &[End], has_joint: bool) {
        let connector = &self.document.connectors[number];
        let is_fixed = ends.contains(&End::Ground);
        if connector.is_traced && (is_fixed || ends.is_empty()) {
            self.omit(number, "its path is a point, as it does not move");
        }
        let point = Point {
            name: name_at(connector, "point"),
            at: connector.at,
            is_traced: connector.is_traced && !is_fixed,
        };
        self.drawing.mark(ends, point, has_joint);
    }

    /// Makes the joint of a guide.
    fn slide(&mut self, connector: &Connector, guide: &Guide) {
        match *guide {
            Guide::Slot { ends, along } => {
                let (at, along) = (connector.at, Direction::Vector(along));
                let name = name_at(connector, "slot");
                self.drawing.join(&name, Form::Slot { at, along }, ends);
            }
            Guide::Line { ends, along } => {
                let (at, along) = (connector.at, Direction::Vector(along));
                let name = name_at(connector, "guide");
                self.drawing.join(&name, Form::Prismatic { at, along }, ends);
            }
            Guide::Arc { ends, center } => self.arc(connector, ends, center),
        }
    }

    /// An arc: a link that turns about its centre.
    fn arc(&mut self, connector: &Connector, [pin, guide]: [End; 2], center: Pair) {
        let name = name_at(connector, "arc");
        let link = End::Link(self.drawing.links.len());
        self.drawing.links.push(drawing::Link { name: name.clone(), ..drawing::Link::default() });
        let form = |at| Form::Revolute { at };
        let middle = format!("{name} center");
        self.drawing.join(&middle, form(center), [guide, link]);
        let end = format!("{name} end");
        self.drawing.join(&end, form(connector.at), [pin, link]);
        let what = format!(
            "it slides on an arc; the link `{name}`, which turns about the centre of the arc, stands for it"
        );
        let of = format!("connector {}", connector.id);
        self.omissions.push(Omission::new(of, what));
    }

    /// Cylinders: a rod that slides in a barrel, and a motor.
    fn cylinders(&mut self) {
        for (number, link) in self.document.links.iter().enumerate() {
            let cylinder = link.cylinder.zip(self.unions.member(number));
            let Some((cylinder, Member::Cylinder([barrel, rod]))) = cylinder else {
                continue;
            };
            let [from, to] = cylinder.ends.map(|end| self.document.connectors[end].at);
            let along = [to[0] - from[0], to[1] - from[1]];
            let of = format!("link {}", link.id);
            if along == [0.0, 0.0] {
                let what = "its two connectors are at one place, so it has no direction";
                self.omissions.push(Omission::new(of, what));
                continue;
            }
            let form = Form::Prismatic { at: from, along: Direction::Vector(along) };
            let ends = [barrel, rod].map(End::Link);
            let joint = self.drawing.join(&format!("{} stroke", name(link)), form, ends);
            self.drawing.motors.push(Motor {
                joint,
                stroke: cylinder.stroke,
                speed: cylinder.cycles.map(Speed::Cycles),
            });
        }
    }

    fn ratios(&mut self) {
        for ratio in &self.document.ratios {
            let links = ratio.links;
            let ids = links.map(|link| self.document.links[link].id);
            let of = format!("ratio of links {} and {}", ids[0], ids[1]);
            let [Some(a), Some(b)] = links.map(|link| self.unions.rigid(link)) else {
                let what = "one of them is no rigid link of the mechanism";
                self.omissions.push(Omission::new(of, what));
                continue;
            };
            if a == b {
                let what = "both are one link";
                self.omissions.push(Omission::new(of, what));
                continue;
            }
            let (word, form) = if ratio.is_chain {
                ("chain", Form::Belt(ratio.sizes))
            } else {
                ("mesh", Form::Gear(ratio.sizes))
            };
            let name = format!("{word}_{}_{}", ids[0], ids[1]);
            self.drawing.join(&name, form, [a, b]);
        }
    }

    /// Notes the pictures and colours that are lost.
    fn pictures(&mut self) {
        let pictures = self.document.links.iter();
        let pictures = pictures.filter(|link| !link.is_of_mechanism);
        let ids: Vec<String> = pictures.map(|link| link.id.to_string()).collect();
        if !ids.is_empty() {
            let what = "drawings and measures are no parts of a mechanism";
            let of = format!("links {}", ids.join(", "));
            self.omissions.push(Omission::new(of, what));
        }
        let colors = self.drawing.links.iter().enumerate();
        let wheels =
            colors.filter(|(number, link)| link.color.is_some() && self.drawing.is_wheel(*number));
        let wheels = wheels.map(|(_, link)| {
            let what = "its colour is lost, because the compiler draws wheels";
            Omission::new(format!("link `{}`", link.name), what)
        });
        self.omissions.extend(wheels);
    }
}

/// The connectors between which one slides.
fn limits(connector: &Connector) -> impl Iterator<Item = usize> + use<> {
    let slide = connector.slide;
    slide.into_iter().flat_map(|slide| slide.limits)
}
