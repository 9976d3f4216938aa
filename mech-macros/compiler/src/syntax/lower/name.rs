//! The meaning of names.

use super::scope::{Scope, Scopes};
use super::similarity::Similarity;
use super::unknown::Unknown;
use crate::model::{Axis, AxisId, AxisKind, JointId, LinkId, Model};
use crate::syntax::Noun;
use std::collections::HashMap;

/// A link, and the port by which a part knows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Body {
    pub(super) id: LinkId,
    /// The number of the port, if it is lent to a part: then only what the part fixed to it is meant.
    pub(super) port: Option<usize>,
}

impl From<LinkId> for Body {
    fn from(id: LinkId) -> Self {
        Self { id, port: None }
    }
}

/// The thing that a name of the text stands for.
#[derive(Clone, Copy)]
pub(super) enum Referent {
    /// A link.
    Link(Body),
    /// Instances of a part.
    Use,
    /// A joint; without an id, one that is left out of the model because of an error.
    Joint(Option<JointId>),
    /// Something that is left out of the model because of an error: it has been reported.
    Broken,
}

/// A name that is taken, and its referent.
struct Entry {
    /// With the path to its scope.
    name: String,
    named: Referent,
}

/// A link that is lent to an instance of a part.
pub(super) struct LentLink {
    /// The path of its port.
    pub(super) path: String,
    /// The similarity of the numbers that the part fixes to it.
    pub(super) similarity: Similarity,
}

/// The names of the mechanism and of the instances of parts in it.
pub(super) struct Names {
    entries: Vec<Entry>,
    /// Where each name stands among them. Looked up only, never iterated.
    places: HashMap<String, usize>,
    /// The scopes of the mechanism, and of each instance of a part.
    pub(super) scopes: Scopes,
    /// The links that are lent to parts.
    pub(super) ports: Vec<LentLink>,
    /// The scope of each link, except of the dies of slots.
    pub(super) link_scopes: Vec<usize>,
    /// The names of the cams.
    pub(super) cams: Vec<String>,
}

impl Names {
    /// The names of a mechanism before anything is declared in it.
    pub(super) fn new(scopes: Scopes) -> Self {
        let mut names = Self {
            entries: Vec::new(),
            places: HashMap::new(),
            scopes,
            ports: Vec::new(),
            link_scopes: vec![0],
            cams: Vec::new(),
        };
        names.enter("ground".to_owned(), Referent::Link(LinkId::GROUND.into()));
        names
    }

    /// The scope of this number.
    pub(super) fn scope(&self, scope: usize) -> &Scope {
        self.scopes.get(scope)
    }

    pub(super) fn get(&self, name: &str) -> Option<Referent> {
        Some(self.entry(name)?.named)
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        Some(&self.entries[*self.places.get(name)?])
    }

    fn entry_mut(&mut self, name: &str) -> Option<&mut Entry> {
        Some(&mut self.entries[*self.places.get(name)?])
    }

    /// Enters a name, unless it stands for something already.
    pub(super) fn enter(&mut self, name: String, named: Referent) {
        if let Some(entry) = self.entry_mut(&name) {
            if matches!(entry.named, Referent::Broken) {
                entry.named = named;
            }
            return;
        }
        self.places.insert(name.clone(), self.entries.len());
        self.entries.push(Entry { name, named });
    }

    /// Gives a joint its id, now that it has one.
    pub(super) fn joint_is(&mut self, name: &str, id: JointId) {
        if let Some(entry) = self.entry_mut(name) {
            entry.named = Referent::Joint(Some(id));
        }
    }

    /// The names of the links in the scope of this name.
    pub(super) fn links(&self, beside: &str) -> Vec<&str> {
        self.beside(beside, |named| matches!(named, Referent::Link(_)))
    }

    /// The names of the joints in the scope of this name.
    pub(super) fn joints(&self, beside: &str) -> Vec<&str> {
        self.beside(beside, |named| matches!(named, Referent::Joint(_)))
    }

    /// The names in the scope of this name, as they are written there.
    fn beside(&self, name: &str, is_wanted: fn(Referent) -> bool) -> Vec<&str> {
        let (scope, _) = divide(name);
        let entries = self.entries.iter().filter(|entry| is_wanted(entry.named));
        let names = entries.map(|entry| divide(&entry.name));
        names.filter(|(prefix, _)| *prefix == scope).map(|(_, name)| name).collect()
    }

    /// A link, a use or a joint that is unknown, by its name with the path to its scope.
    pub(super) fn unknown(&self, noun: Noun, key: &str) -> Unknown {
        let (path, name) = divide(key);
        let part = self.scopes.find(path).and_then(|scope| scope.part.clone());
        Unknown::new(noun, part, &name)
    }

    /// A point or line of a link that is unknown; without a name, all of them.
    pub(super) fn unknown_axis(&self, link: &str, name: &str) -> Unknown {
        let link = self.unknown(Noun::Axis, link);
        Unknown { owner: format!("{}.", link.word), word: name.to_owned(), ..link }
    }

    /// The path of a link: that of its port in a part to which it is lent.
    pub(super) fn name_of<'n>(&'n self, model: &'n Model, link: Body) -> &'n str {
        self.port_of(link).unwrap_or(&model.link(link.id).name)
    }

    fn port_of(&self, link: Body) -> Option<&str> {
        link.port.map(|port| self.ports[port].path.as_str())
    }

    /// The axis of this name on a link, without a word.
    pub(super) fn axis_of(&self, model: &Model, link: Body, name: &str) -> Option<AxisId> {
        let is_it =
            |axis: &Axis| self.is_known_by(axis, link) && axis.name.as_deref() == Some(name);
        model.axes.iter().position(is_it).map(AxisId::new)
    }

    /// Whether an axis belongs to a link, and to the port by which the link is known.
    fn is_known_by(&self, axis: &Axis, link: Body) -> bool {
        axis.link == link.id && axis.port.as_deref() == self.port_of(link)
    }

    /// The names of a link's axes, of this kind if one is given.
    pub(super) fn axes_of<'m>(
        &self,
        model: &'m Model,
        link: Body,
        kind: Option<AxisKind>,
    ) -> Vec<&'m str> {
        let axes = model.axes.iter();
        let axes = axes.filter(|axis| self.is_known_by(axis, link));
        let axes = axes.filter(|axis| kind.is_none_or(|kind| axis.kind == kind));
        axes.filter_map(|axis| axis.name.as_deref()).collect()
    }

    /// Returns the similarity of the numbers that are written in the frame of this link.
    pub(super) fn frame_of(&self, body: Body) -> Similarity {
        match body.port {
            Some(port) => self.ports[port].similarity,
            None => self
                .link_scopes
                .get(body.id.index())
                .map_or(Similarity::IDENTITY, |&scope| self.scope(scope).similarity),
        }
    }
}

/// The path to the scope of a name, and the name there.
pub(super) fn divide(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or(("", name))
}

/// Returns the word for an axis in the text.
pub(super) fn word_for(kind: AxisKind) -> &'static str {
    match kind {
        AxisKind::Point => "point",
        AxisKind::Line => "line",
    }
}
