//! The colours of bodies.

use crate::model::{self, LinkId, Model};
use std::collections::HashMap;

/// The colours of all links' bodies. What is the same link in several instances of a part has the same colour.
pub(super) struct Colors(Vec<u8>);

impl Colors {
    pub(super) fn new(model: &Model) -> Self {
        let parts = model.instances.iter();
        let parts: HashMap<&str, &str> = parts
            .map(|instance| (&instance.path[..], &instance.part[..]))
            .collect();
        let mut numbers: HashMap<(Option<&str>, &str), usize> = HashMap::new();
        let colors = model.link_ids().map(|link| {
            if link == LinkId::GROUND {
                return model::color_of(link);
            }
            let name = &model.link(link).name[..];
            let kind = match name.rsplit_once('.') {
                None => (None, name),
                Some((path, own)) => (parts.get(path).copied(), own),
            };
            let next = numbers.len() + 1;
            model::color_of(LinkId::new(*numbers.entry(kind).or_insert(next)))
        });
        Self(colors.collect())
    }

    /// The colour of a link.
    pub(super) fn of(&self, link: LinkId) -> u8 {
        self.0[link.index()]
    }
}
