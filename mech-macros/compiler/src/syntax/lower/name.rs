//! What the names mean.

use super::Lowering;
use crate::api::{self, Owner, is_reserved};
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId};
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

/// What a name of the text stands for.
#[derive(Clone, Copy)]
pub(super) enum Referent {
    /// A link.
    Link(LinkId),
    /// A joint; without an id, one that is left out of the model because of an error.
    Joint(Option<JointId>),
    /// Something that is left out of the model because of an error: it has been reported.
    Broken,
}

/// What has taken a name.
struct Entry {
    name: String,
    named: Referent,
    /// Whether a link and a joint claim it: whoever means the second is not to blame.
    shared: bool,
}

/// The names of links and joints, and the methods that the generated struct will have.
#[derive(Default)]
pub(super) struct Names {
    entries: Vec<Entry>,
    /// Each with what it is made for.
    methods: Vec<(String, String)>,
    /// Names of points and lines that are left out of the model because of an error; of all, if there is no name.
    lost: Vec<(LinkId, Option<String>)>,
}

impl Names {
    fn get(&self, name: &str) -> Option<Referent> {
        self.entries
            .iter()
            .find(|entry| entry.name == name)
            .map(|entry| entry.named)
    }

    /// Notes that something else claims the name of a link or a joint, too.
    pub(super) fn share(&mut self, name: &Ident) {
        let mut entries = self.entries.iter_mut();
        if let Some(entry) = entries.find(|entry| name == &entry.name) {
            entry.shared = true;
        }
    }

    /// Whether both a link and a joint claim this name.
    pub(super) fn is_shared(&self, name: &Ident) -> bool {
        let mut entries = self.entries.iter();
        entries.any(|entry| entry.shared && name == &entry.name)
    }

    /// What this name stands for, if anything.
    pub(super) fn look_up(&self, name: &Ident) -> Option<Referent> {
        self.get(&name.to_string())
    }

    /// Enters a name, unless it stands for something already.
    pub(super) fn enter(&mut self, name: &Ident, named: Referent) {
        match self.entries.iter_mut().find(|entry| name == &entry.name) {
            Some(entry) if matches!(entry.named, Referent::Broken) => entry.named = named,
            Some(_) => {}
            None => self.entries.push(Entry {
                name: name.to_string(),
                named,
                shared: false,
            }),
        }
    }

    /// Gives a joint its id, now that it has one.
    pub(super) fn joint_is(&mut self, name: &Ident, id: JointId) {
        let mut entries = self.entries.iter_mut();
        if let Some(entry) = entries.find(|entry| name == &entry.name) {
            entry.named = Referent::Joint(Some(id));
        }
    }

    /// Notes that a link should have an axis of this name, or any, had there not been an error.
    pub(super) fn lose_axis(&mut self, link: LinkId, name: Option<&Ident>) {
        self.lost.push((link, name.map(ToString::to_string)));
    }

    fn is_lost(&self, link: LinkId, name: &str) -> bool {
        let lost = |entry: &Option<String>| entry.as_deref().is_none_or(|entry| entry == name);
        self.lost
            .iter()
            .any(|(owner, entry)| *owner == link && lost(entry))
    }

    fn links(&self) -> Vec<&str> {
        let links = self
            .entries
            .iter()
            .filter(|entry| matches!(entry.named, Referent::Link(_)));
        links.map(|entry| entry.name.as_str()).collect()
    }

    fn joints(&self) -> Vec<&str> {
        let joints = self
            .entries
            .iter()
            .filter(|entry| matches!(entry.named, Referent::Joint(_)));
        joints.map(|entry| entry.name.as_str()).collect()
    }
}

impl Lowering {
    /// Takes the name of a link or a joint (`what`): whether it can have it.
    pub(super) fn claim(&mut self, name: &Ident, what: &str) -> bool {
        let text = name.to_string();
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
        let earlier = match self.names.get(&text) {
            Some(Referent::Link(_)) => "link",
            Some(Referent::Joint(_)) => "joint",
            Some(Referent::Broken) | None => {
                return self.claim_method(text.clone(), format!("{what} `{text}`"), place);
            }
        };
        let message =
            format!("there is a {earlier} `{text}` already; choose another name for this {what}");
        self.report.error(place, message);
        if earlier != what {
            self.names.share(name);
        }
        false
    }

    /// Takes the method of a point: whether it can have it.
    pub(super) fn claim_point(&mut self, link: LinkId, name: &Ident) -> bool {
        let link = &self.model.link(link).name;
        let method = format!("{link}_{name}");
        let owner = format!("point `{link}.{name}`");
        self.claim_method(method, owner, Place::at(name.span()))
    }

    /// Whether a method was taken for this.
    pub(super) fn owns_method(&self, method: &str, owner: &str) -> bool {
        let mut methods = self.names.methods.iter();
        methods.any(|(taken, by)| taken == method && by == owner)
    }

    pub(super) fn claim_method(&mut self, method: String, owner: String, place: Place) -> bool {
        if let Some((_, earlier)) = self
            .names
            .methods
            .iter()
            .find(|(taken, _)| *taken == method)
        {
            let text = format!(
                "{owner} and {earlier} would both be the method `{method}`; rename one of them"
            );
            self.report.error(place, text);
            return false;
        }
        self.names.methods.push((method, owner));
        true
    }

    /// Takes all methods of this owner, and reports each that something else has.
    pub(super) fn claim_methods(&mut self, owner: Owner, place: Place) {
        for method in api::names_of(owner) {
            self.claim_method(method.to_owned(), owner.to_string(), place);
        }
    }

    /// The link of this name.
    pub(super) fn find_link(&mut self, name: &Ident) -> Option<LinkId> {
        let text = name.to_string();
        let trouble = match self.names.get(&text) {
            Some(Referent::Link(id)) => return Some(id),
            Some(Referent::Broken) => return None,
            Some(Referent::Joint(_)) if self.names.is_shared(name) => return None,
            Some(Referent::Joint(_)) => {
                let links = self.names.links();
                format!(
                    "`{text}` is a joint; this must be a link, one of {}",
                    spelling::list(&links)
                )
            }
            None => format!(
                "unknown link `{text}`{}",
                spelling::remedy(&text, &self.names.links())
            ),
        };
        self.report.error(Place::at(name.span()), trouble);
        None
    }

    /// The joint of this name.
    pub(super) fn find_joint(&mut self, name: &Ident) -> Option<JointId> {
        let text = name.to_string();
        let trouble = match self.names.get(&text) {
            Some(Referent::Joint(id)) => return id,
            Some(Referent::Broken) => return None,
            Some(Referent::Link(_)) if self.names.is_shared(name) => return None,
            Some(Referent::Link(id)) => self.not_a_joint(id),
            None => match self.point_called(&text) {
                Some(link) => format!(
                    "`{text}` is a point of link `{}`, not a joint: a joint joins two links{}",
                    self.model.link(link).name,
                    spelling::remedy(&text, &self.names.joints())
                ),
                None => format!(
                    "unknown joint `{text}`{}",
                    spelling::remedy(&text, &self.names.joints())
                ),
            },
        };
        self.report.error(Place::at(name.span()), trouble);
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
    pub(super) fn refuse_unknown(&mut self, name: &Ident) {
        let text = name.to_string();
        let candidates: Vec<_> = [self.names.links(), self.names.joints()].concat();
        let remedy = spelling::remedy(&text, &candidates);
        self.report.error(
            Place::at(name.span()),
            format!("unknown link or joint `{text}`{remedy}"),
        );
    }

    /// The axis of this name on a link; of this kind, if one is given.
    pub(super) fn find_axis(
        &mut self,
        link: LinkId,
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
        let link_name = self.model.link(link).name.clone();
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
    pub(super) fn axis_of(&self, link: LinkId, name: &str) -> Option<AxisId> {
        let mut axes = self.model.axes.iter();
        let axis = axes.position(|axis| axis.link == link && axis.name.as_deref() == Some(name));
        axis.map(AxisId::new)
    }

    /// The names of a link's axes, of this kind if one is given.
    pub(super) fn axes_of(&self, link: LinkId, kind: Option<AxisKind>) -> Vec<&str> {
        let axes = self.model.axes.iter().filter(|axis| axis.link == link);
        let axes = axes.filter(|axis| kind.is_none_or(|kind| axis.kind == kind));
        axes.filter_map(|axis| axis.name.as_deref()).collect()
    }
}

/// What an axis is called in the text.
pub(super) fn word_for(kind: AxisKind) -> &'static str {
    match kind {
        AxisKind::Point => "point",
        AxisKind::Line => "line",
    }
}
