//! Links and joints that could be declared, as they would be written.

use super::Words;
use super::wording::{and, brief};
use crate::bug::bug;
use crate::model::{Ends, LinkId, NewJoint, NewKind};
use crate::repair::{Declaration, Purpose};

impl Words<'_> {
    /// What a declaration is for, and its text.
    pub(super) fn declaration(&self, declared: &Declaration) -> String {
        let text = self.statements(declared);
        let verb = if declared.replaced.is_empty() {
            "add"
        } else {
            "write"
        };
        let dropped = declared.dropped_names(self.model).into_iter();
        let dropped: Vec<String> = dropped.map(|name| format!("`joint {name}`")).collect();
        let without = if dropped.is_empty() {
            String::new()
        } else {
            format!(" without {}", and(&dropped))
        };
        let purpose = self.purpose(declared);
        format!("{purpose}: {verb} `{}`{without}", text.join(" "))
    }

    /// The statements that are added, as they are written.
    pub(super) fn statements(&self, declared: &Declaration) -> Vec<String> {
        let new = declared.link.iter().map(|name| format!("link {name};"));
        let joints = declared.joints.iter();
        let joints = joints.map(|joint| self.new_joint(joint, declared.link.as_deref()));
        new.chain(joints).collect()
    }

    fn purpose(&self, declared: &Declaration) -> String {
        let links: Vec<LinkId> = declared
            .joints
            .iter()
            .flat_map(|joint| joint.ends.links(self.model))
            .filter(|link| link.index() < self.model.links.len())
            .collect();
        let name = |number: usize| {
            let Some(&link) = links.get(number) else {
                bug!("a declaration joins nothing that is there");
            };
            self.link(link)
        };
        let moving = links.iter().find(|link| **link != LinkId::GROUND);
        let moving = moving.map_or(String::new(), |&link| self.link(link));
        match declared.purpose {
            Purpose::Ground => format!("pin {moving} to the ground"),
            Purpose::Join { apart } if apart > 0.0 => format!(
                "join {} and {}, which are drawn {} apart there",
                name(0),
                name(1),
                brief(apart)
            ),
            Purpose::Join { .. } => format!("join {} and {}", name(0), name(1)),
            Purpose::Meet => format!("join {} and {}, for example here", name(0), name(1)),
            Purpose::Connect => format!("connect {} and {}", name(0), name(1)),
            Purpose::Stiffen => format!("make one bent link of {} and {}", name(0), name(1)),
            Purpose::Turn => format!("let {} turn", name(0)),
            Purpose::Guide => format!("keep {} from turning", name(1)),
            Purpose::Slide => format!("let {moving} slide on the ground"),
            Purpose::Free => "join these links to each other, not to the ground".to_owned(),
            Purpose::Fix => format!("make {moving} a part of the ground"),
        }
    }

    /// A joint as it is written, with its semicolon.
    fn new_joint(&self, joint: &NewJoint, new: Option<&str>) -> String {
        let link = |id: LinkId| match self.model.links.get(id.index()) {
            Some(link) => link.name.as_str(),
            None => new.unwrap_or_else(|| bug!("a joint joins a link that is not declared")),
        };
        let (word, along) = match joint.kind {
            NewKind::Revolute => ("revolute", None),
            NewKind::Weld => ("weld", None),
            NewKind::Prismatic(along) => ("prismatic", Some(along)),
            NewKind::Slot(along) => ("slot", Some(along)),
        };
        let name = &joint.name;
        match joint.ends {
            Ends::Drawn { links: [a, b], at } => {
                let along = along.map(|along| {
                    let [x, y] = in_small_numbers(along);
                    format!(" along ({x}, {y})")
                });
                format!(
                    "joint {name} = {word}({}, {}) at ({}, {}){};",
                    link(a),
                    link(b),
                    at[0],
                    at[1],
                    along.unwrap_or_default()
                )
            }
            Ends::Points(points) => {
                let [a, b] = points.map(|id| {
                    let axis = self.model.axis(id);
                    format!("{}.{}", link(axis.link), axis.own_name())
                });
                format!("joint {name} = {word}({a}, {b});")
            }
        }
    }
}

/// The same direction in whole numbers, if small ones give it.
fn in_small_numbers(direction: [f64; 2]) -> [f64; 2] {
    const LARGEST: u8 = 20;
    const EXACT: f64 = 1e-12;
    let most = direction[0].abs().max(direction[1].abs());
    let scaled = |largest: u8| direction.map(|part| part / most * f64::from(largest));
    let is_whole = |numbers: &[f64; 2]| {
        let off = |number: &f64| (number - number.round()).abs();
        numbers.iter().all(|number| off(number) < EXACT)
    };
    let found = (1..=LARGEST).map(scaled).find(is_whole);
    found.map_or(direction, |whole| whole.map(|part| part.round() + 0.0))
}
