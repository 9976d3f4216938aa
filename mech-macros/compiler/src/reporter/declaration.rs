//! Links and joints that could be declared, as they would be written.

use super::Words;
use super::wording::{and, brief};
use crate::bug::bug;
use crate::model::LinkId;
use crate::repair::{Declaration, NewKind, Purpose};

impl Words<'_> {
    /// Returns the purpose of a declaration, and its text.
    pub(super) fn declaration(&self, declared: &Declaration) -> String {
        let text = declared.statements(self.model);
        let verb = if declared.replaced.is_empty() { "add" } else { "write" };
        let dropped = declared.dropped_names(self.model).into_iter();
        let dropped: Vec<String> = dropped.map(|name| format!("`joint {name}`")).collect();
        let without =
            if dropped.is_empty() { String::new() } else { format!(" without {}", and(&dropped)) };
        let purpose = self.purpose(declared);
        format!("{purpose}: {verb} `{}`{without}", text.join(" "))
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
            Purpose::Twin => {
                format!("join {} and {} like their twins, for example here", name(0), name(1))
            }
            Purpose::Connect => format!("connect {} and {}", name(0), name(1)),
            Purpose::Stiffen => format!("make one bent link of {} and {}", name(0), name(1)),
            Purpose::Turn => format!("let {} turn", name(0)),
            Purpose::Guide => format!("keep {} from turning", name(1)),
            Purpose::Slide => format!("let {moving} slide on the ground"),
            Purpose::Guess => {
                let is_slot = matches!(declared.joints[0].kind, NewKind::Slot(_));
                let (what, on) = if is_slot { ("a pin of ", (0, 1)) } else { ("", (1, 0)) };
                let (moving, rail) = (name(on.0), name(on.1));
                format!("let {what}{moving} slide on {rail}, for example here")
            }
            Purpose::Free => "join these links to each other, not to the ground".to_owned(),
            Purpose::Split => format!("make two links of {}", name(0)),
            Purpose::Fix => format!("make {moving} a part of the ground"),
        }
    }
}
