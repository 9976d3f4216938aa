//! What the names mean.

use super::Lowering;
use crate::api::{self, Owner, is_reserved};
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId};
use crate::syntax::ast::Name;
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;
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

/// What a name of the text stands for.
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

/// What has taken a name.
struct Entry {
    /// With the path to its scope.
    name: String,
    named: Referent,
    /// Whether a link and a joint claim it: whoever means the second is not to blame.
    shared: bool,
}

/// The names of links and joints, and the methods that the generated struct will have.
#[derive(Default)]
pub(super) struct Names {
    entries: Vec<Entry>,
    /// Where each name stands among them. Looked up only, never iterated.
    places: HashMap<String, usize>,
    /// Each with what it is made for. Looked up only, too.
    methods: HashMap<String, String>,
    /// Names of points and lines that are left out of the model because of an error; of all, if there is no name.
    lost: Vec<(Body, Option<String>)>,
}

impl Names {
    pub(super) fn get(&self, name: &str) -> Option<Referent> {
        Some(self.entry(name)?.named)
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        Some(&self.entries[*self.places.get(name)?])
    }

    fn entry_mut(&mut self, name: &str) -> Option<&mut Entry> {
        Some(&mut self.entries[*self.places.get(name)?])
    }

    /// Notes that something else claims the name of a link or a joint, too.
    pub(super) fn share(&mut self, name: &str) {
        if let Some(entry) = self.entry_mut(name) {
            entry.shared = true;
        }
    }

    /// Whether both a link and a joint claim this name.
    fn is_shared(&self, name: &str) -> bool {
        self.entry(name).is_some_and(|entry| entry.shared)
    }

    /// Whether this name is that of something that is left out because of an error.
    pub(super) fn is_broken(&self, name: &str) -> bool {
        matches!(self.get(name), Some(Referent::Broken))
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
        self.entries.push(Entry {
            name,
            named,
            shared: false,
        });
    }

    /// Gives a joint its id, now that it has one.
    pub(super) fn joint_is(&mut self, name: &str, id: JointId) {
        if let Some(entry) = self.entry_mut(name) {
            entry.named = Referent::Joint(Some(id));
        }
    }

    /// Notes that a link should have an axis of this name, or any, had there not been an error.
    pub(super) fn lose_axis(&mut self, link: Body, name: Option<&Ident>) {
        self.lost.push((link, name.map(ToString::to_string)));
    }

    fn is_lost(&self, link: Body, name: &str) -> bool {
        let lost = |entry: &Option<String>| entry.as_deref().is_none_or(|entry| entry == name);
        self.lost
            .iter()
            .any(|(owner, entry)| *owner == link && lost(entry))
    }

    /// The names of the links in the scope of this name.
    fn links(&self, beside: &str) -> Vec<&str> {
        self.beside(beside, |named| matches!(named, Referent::Link(_)))
    }

    /// The names of the joints in the scope of this name.
    fn joints(&self, beside: &str) -> Vec<&str> {
        self.beside(beside, |named| matches!(named, Referent::Joint(_)))
    }

    /// The names in the scope of this name, as they are written there.
    fn beside(&self, name: &str, is_wanted: fn(Referent) -> bool) -> Vec<&str> {
        let (scope, _) = divide(name);
        let entries = self.entries.iter().filter(|entry| is_wanted(entry.named));
        let names = entries.map(|entry| divide(&entry.name));
        names
            .filter(|(prefix, _)| *prefix == scope)
            .map(|(_, name)| name)
            .collect()
    }
}

/// The path to the scope of a name, and the name there.
fn divide(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or(("", name))
}

impl Lowering {
    /// The name of something that is declared in the scope that is read, with the path to it.
    pub(super) fn key_of(&self, name: &Ident) -> String {
        format!("{}{name}", self.scopes.here().prefix)
    }

    /// What this name stands for, if anything.
    pub(super) fn look_up(&mut self, name: &Name) -> Option<Referent> {
        match self.key(name) {
            Some(key) => self.names.get(&key),
            // Reported.
            None => Some(Referent::Broken),
        }
    }

    /// Whether both a link and a joint claim this name.
    pub(super) fn is_shared(&mut self, name: &Name) -> bool {
        self.key(name).is_some_and(|key| self.names.is_shared(&key))
    }

    /// Takes the name of a link or a joint (`what`): whether it can have it.
    pub(super) fn claim(&mut self, name: &Ident, what: &str) -> bool {
        let text = name.to_string();
        let key = self.key_of(name);
        let place = Place::at(name.span());
        if text == "ground" {
            let message =
                format!("`ground` is the link that is fixed; choose another name for this {what}");
            self.report.error(place, message);
            return false;
        }
        if is_reserved(&text) {
            let message = format!(
                "`{text}` is a method of every mechanism; choose another name for this {what}"
            );
            self.report.error(place, message);
            return false;
        }
        let in_path = what == "use" || self.scopes.here().part.is_some();
        if in_path && (text.contains("__") || text.starts_with('_') || text.ends_with('_')) {
            let message = format!(
                "`{text}` stands in paths, where underscores are only between letters; choose another name for this {what}"
            );
            self.report.error(place, message);
            return false;
        }
        let earlier = match self.names.get(&key) {
            Some(Referent::Link(_)) => "link",
            Some(Referent::Joint(_)) => "joint",
            Some(Referent::Use) => "use",
            Some(Referent::Broken) | None => {
                return self.claim_method(key, format!("{what} `{text}`"), place);
            }
        };
        let message =
            format!("there is a {earlier} `{text}` already; choose another name for this {what}");
        self.report.error(place, message);
        if earlier != what {
            self.names.share(&key);
        }
        false
    }

    /// Takes the method of a point: whether it can have it.
    pub(super) fn claim_point(&mut self, link: Body, name: &Ident) -> bool {
        let link = self.name_of(link);
        let method = format!("{link}_{name}");
        let owner = format!("point `{link}.{name}`");
        self.claim_method(method, owner, Place::at(name.span()))
    }

    /// Whether a method was taken for this.
    pub(super) fn owns_method(&self, method: &str, owner: &str) -> bool {
        let by = self.names.methods.get(method);
        by.is_some_and(|by| by == owner)
    }

    pub(super) fn claim_method(&mut self, method: String, owner: String, place: Place) -> bool {
        if let Some(earlier) = self.names.methods.get(&method) {
            let text = format!(
                "{owner} and {earlier} would both be the method `{method}`; rename one of them"
            );
            self.report.error(place, text);
            return false;
        }
        self.names.methods.insert(method, owner);
        true
    }

    /// Takes all methods of this owner, and reports each that something else has.
    pub(super) fn claim_methods(&mut self, owner: Owner, place: Place) {
        for method in api::names_of(owner) {
            self.claim_method(method.to_owned(), owner.to_string(), place);
        }
    }

    /// The path of a link: that of its port in a part to which it is lent.
    pub(super) fn name_of(&self, link: Body) -> &str {
        match link.port {
            Some(port) => &self.ports[port].path,
            None => &self.model.link(link.id).name,
        }
    }

    /// The link of this name.
    pub(super) fn find_link(&mut self, name: &Name) -> Option<LinkId> {
        self.find_body(name).map(|body| body.id)
    }

    /// The link of this name, and how it is known there.
    pub(super) fn find_body(&mut self, name: &Name) -> Option<Body> {
        let (text, key) = (name.to_string(), self.key(name)?);
        let trouble = match self.names.get(&key) {
            Some(Referent::Link(body)) => return Some(body),
            Some(Referent::Broken) => return None,
            Some(Referent::Joint(_)) if self.names.is_shared(&key) => return None,
            Some(Referent::Use) => used_as(&text, "link"),
            Some(Referent::Joint(_)) => {
                let links = self.names.links(&key);
                format!(
                    "`{text}` is a joint; this must be a link, one of {}",
                    spelling::list(&links)
                )
            }
            None if name.name == "ground" => format!(
                "a part has no ground of its own; declare `port {};`, and lend it `ground` where the part is used",
                "frame"
            ),
            None => format!(
                "unknown link `{text}`{}",
                spelling::remedy(divide(&key).1, &self.names.links(&key))
            ),
        };
        self.report.error(name.place(), trouble);
        None
    }

    /// The joint of this name.
    pub(super) fn find_joint(&mut self, name: &Name) -> Option<JointId> {
        let (text, key) = (name.to_string(), self.key(name)?);
        let trouble = match self.names.get(&key) {
            Some(Referent::Joint(id)) => return id,
            Some(Referent::Broken) => return None,
            Some(Referent::Link(_)) if self.names.is_shared(&key) => return None,
            Some(Referent::Link(body)) => self.not_a_joint(body.id),
            Some(Referent::Use) => used_as(&text, "joint"),
            None => match self.point_called(&text) {
                Some(link) => format!(
                    "`{text}` is a point of link `{}`, not a joint: a joint joins two links{}",
                    self.model.link(link).name,
                    spelling::remedy(&text, &self.names.joints(&key))
                ),
                None => format!(
                    "unknown joint `{text}`{}",
                    spelling::remedy(divide(&key).1, &self.names.joints(&key))
                ),
            },
        };
        self.report.error(name.place(), trouble);
        None
    }

    /// The first link that has a point of this name.
    fn point_called(&self, name: &str) -> Option<LinkId> {
        let mut axes = self.model.axes.iter();
        let called = |axis: &&Axis| axis.name.as_deref() == Some(name);
        axes.find(called).map(|axis| axis.link)
    }

    fn not_a_joint(&self, link: LinkId) -> String {
        let name = &self.model.link(link).name;
        let joints = self.model.joint_ids().filter(|&joint| {
            let (a, b) = self.model.ends(joint);
            let kind = self.model.joint(joint).kind;
            let moves = matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
            moves && (a == link || b == link)
        });
        let joints: Vec<_> = joints
            .map(|joint| self.model.joint(joint).name.as_str())
            .collect();
        match joints.as_slice() {
            [] => format!("`{name}` is a link; this must be a joint"),
            joints => format!(
                "`{name}` is a link; name one of its joints: {}",
                spelling::list(joints)
            ),
        }
    }

    /// Complains about a name that is neither a link's nor a joint's.
    pub(super) fn refuse_unknown(&mut self, name: &Name) {
        let Some(key) = self.key(name) else {
            return;
        };
        let text = name.to_string();
        let candidates: Vec<_> = [self.names.links(&key), self.names.joints(&key)].concat();
        let remedy = spelling::remedy(divide(&key).1, &candidates);
        self.report.error(
            name.place(),
            format!("unknown link or joint `{text}`{remedy}"),
        );
    }

    /// The axis of this name on a link; of this kind, if one is given.
    pub(super) fn find_axis(
        &mut self,
        link: Body,
        name: &Ident,
        kind: Option<AxisKind>,
    ) -> Option<AxisId> {
        let text = name.to_string();
        if let Some(id) = self.axis_of(link, &text) {
            return Some(id);
        }
        if self.names.is_lost(link, &text) {
            return None;
        }
        let link_name = self.name_of(link).to_owned();
        let what = kind.map_or("point or line", word_for);
        let candidates = self.axes_of(link, kind);
        let remedy = if candidates.is_empty() {
            format!("; declare it in `{link_name}`")
        } else {
            spelling::remedy(&text, &candidates)
        };
        let message = format!("`{link_name}` has no {what} `{text}`{remedy}");
        self.report.error(Place::at(name.span()), message);
        None
    }

    /// The axis of this name on a link, without a word.
    pub(super) fn axis_of(&self, link: Body, name: &str) -> Option<AxisId> {
        let mut axes = self.model.axes.iter();
        let axis = axes
            .position(|axis| axis.name.as_deref() == Some(name) && self.is_known_by(axis, link));
        axis.map(AxisId::new)
    }

    /// Whether an axis belongs to a link, and to the port by which the link is known.
    fn is_known_by(&self, axis: &Axis, link: Body) -> bool {
        let port = link.port.map(|port| self.ports[port].path.as_str());
        axis.link == link.id && axis.port.as_deref() == port
    }

    /// The names of a link's axes, of this kind if one is given.
    pub(super) fn axes_of(&self, link: Body, kind: Option<AxisKind>) -> Vec<&str> {
        let axes = self.model.axes.iter();
        let axes = axes.filter(|axis| self.is_known_by(axis, link));
        let axes = axes.filter(|axis| kind.is_none_or(|kind| axis.kind == kind));
        axes.filter_map(|axis| axis.name.as_deref()).collect()
    }
}

/// What to say about a use of a part where one of its links or joints should be.
fn used_as(name: &str, what: &str) -> String {
    format!("`{name}` is a use of a part; name one of its {what}s, as `{name}.{what}`")
}

/// What an axis is called in the text.
pub(super) fn word_for(kind: AxisKind) -> &'static str {
    match kind {
        AxisKind::Point => "point",
        AxisKind::Line => "line",
    }
}
