//! Statements that are copied: links, and what is between them.

use super::Lexed;
use crate::document::Document;
use crate::editor::index;
use crate::failure::Failure;
use crate::text::shortest;
use mech_compiler::model::{AxisId, AxisKind, Between, LinkId, LoadKind, Model};
use mech_compiler::syntax::StatementText;
use std::collections::BTreeSet;

/// The statements of some links, with what is between them: joints, motors and their starts, springs, dampers and loads. What is between them
/// and the ground comes along if there are several links. Where links were joined to others they get free ends.
pub(super) fn copied(
    document: &Document,
    index: usize,
    links: &BTreeSet<String>,
) -> Result<Option<String>, Failure> {
    let Some(declaration) = document.declarations().get(index) else {
        return Ok(None);
    };
    let (Some(model), Some(tree)) = (document.model(declaration)?, document.tree(declaration)?)
    else {
        return Ok(None);
    };
    let text = document.source().text();
    let text_of = |one: &StatementText<'_>| &text[tree.bytes(&one.range())];
    let rewriter = tree.rewriter();
    let all = &rewriter.statements;
    let source = Copy { text_of: &text_of, model: &model, links };
    let mut found: Vec<String> = all.iter().filter_map(|one| source.copy(one)).collect();
    let has = |words: &[&str]| any_within(&found, |one| words.contains(&one.word(0)));
    if !has(&["link"]) {
        return Ok(None);
    }
    if has(&["spring", "damper", "load"]) && model.effects.needs_actions() {
        found.push("effects { force; }".to_owned());
    }
    let grounds = rewriter.clauses("ground");
    let items = grounds.iter();
    let items: Vec<&str> = items
        .filter(|item| is_mentioned(&found, &format!("ground.{}", item.word(1))))
        .map(text_of)
        .collect();
    if !items.is_empty() {
        found.insert(0, format!("ground {{ {} }}", items.join(" ")));
    }
    // Numbers stand before what uses them, which may be another number.
    for statement in all.iter().rev() {
        let is_number = statement.is("const") || statement.is("param");
        if is_number && is_mentioned(&found, statement.word(1)) {
            found.insert(0, text_of(statement).to_owned());
        }
    }
    Ok(Some(found.join("\n")))
}

fn any_within(texts: &[String], is_it: impl Fn(&StatementText<'_>) -> bool) -> bool {
    let mut texts = texts.iter().filter_map(|text| Lexed::read(text));
    texts.any(|text| text.statements().iter().any(&is_it))
}

fn is_mentioned(texts: &[String], name: &str) -> bool {
    any_within(texts, |one| one.mentions(name))
}

/// The selection of statements to copy from a text.
struct Copy<'c> {
    text_of: &'c dyn Fn(&StatementText<'_>) -> &'c str,
    model: &'c Model,
    links: &'c BTreeSet<String>,
}

impl Copy<'_> {
    /// A statement as it is copied, if it is.
    fn copy(&self, statement: &StatementText<'_>) -> Option<String> {
        let name = statement.word(1);
        let whole = || (self.text_of)(statement).to_owned();
        match statement.word(0) {
            "link" if self.links.contains(name) => Some(self.link(statement)),
            "joint" | "motor" => self.has_joint(name).then(whole),
            "spring" | "damper" | "load" => self.has_action(name).then(whole),
            "start" => {
                let clauses = statement.clauses();
                let kept = clauses.iter().filter(|clause| match clause.word(1) {
                    "near" => self.links.contains(clause.word(0)),
                    _ => self.has_joint(clause.word(0)),
                });
                let kept: Vec<&str> = kept.map(|clause| (self.text_of)(clause)).collect();
                (!kept.is_empty()).then(|| format!("start {{ {} }}", kept.join(" ")))
            }
            _ => None,
        }
    }

    fn is_copied(&self, link: LinkId) -> bool {
        self.links.contains(&self.model.link(link).name)
    }

    /// Whether a link is copied, or is the ground and several links are.
    fn comes(&self, link: LinkId) -> bool {
        self.is_copied(link) || link == LinkId::GROUND && self.links.len() > 1
    }

    /// Whether a joint is copied: if both links are, or one and the ground.
    fn has_joint(&self, name: &str) -> bool {
        let mut joints = self.model.declared_joints();
        let joint = joints.find(|joint| self.model.joint(*joint).name == name);
        joint.is_some_and(|joint| {
            let (a, b) = self.model.ends(joint);
            self.comes(a) && self.comes(b)
        })
    }

    /// Whether a spring, a damper or a load is copied: if all that it acts on is.
    fn has_action(&self, name: &str) -> bool {
        let actions = &self.model.actions;
        let link = |axis: AxisId| self.model.axis(axis).link;
        let springs = actions.springs.iter().map(|one| (&one.name, one.between));
        let dampers = actions.dampers.iter().map(|one| (&one.name, one.between));
        let mut loads = actions.loads.iter();
        match springs.chain(dampers).find(|(known, _)| *known == name) {
            Some((_, Between::Points(a, b))) => self.comes(link(a)) && self.comes(link(b)),
            Some((_, Between::Joint(joint))) => self.has_joint(&self.model.joint(joint).name),
            None => loads.any(|load| {
                load.name == name
                    && self.is_copied(match load.kind {
                        LoadKind::Force(point) => link(point),
                        LoadKind::Torque(link) => link,
                    })
            }),
        }
    }

    /// A link with free ends where it was joined to what is not copied.
    fn link(&self, statement: &StatementText<'_>) -> String {
        let name = statement.word(1);
        let copy = (self.text_of)(statement).to_owned();
        let mut links = self.model.declared_links();
        let link = links.find(|link| self.model.link(*link).name == name);
        let ends = link.filter(|link| self.model.link(*link).drawn);
        let ends = ends.map(|link| self.ends(link, name)).unwrap_or_default();
        if ends.is_empty() {
            return copy;
        }
        match (copy.strip_suffix(';'), copy.rfind('}')) {
            (Some(before), _) => format!("{} {{ {ends}}}", before.trim_end()),
            (None, Some(end)) => format!("{} {ends}}}", copy[..end].trim_end()),
            (None, None) => copy,
        }
    }

    fn ends(&self, link: LinkId, name: &str) -> String {
        let tolerance = 1e-9 * self.model.size();
        let mut kept: BTreeSet<AxisId> = BTreeSet::new();
        let mut left: Vec<AxisId> = Vec::new();
        for joint in self.model.joint_ids() {
            let (a, b) = self.model.ends(joint);
            let axes = self.model.joint(joint).kind.axes().into_iter().flatten();
            for axis in axes.filter(|axis| self.model.axis(*axis).link == link) {
                if self.comes(a) && self.comes(b) {
                    kept.insert(axis);
                } else if index::path(self.model, axis).is_none() {
                    left.push(axis);
                }
            }
        }
        let mut places: Vec<[f64; 2]> = kept.iter().map(|axis| self.model.axis(*axis).at).collect();
        let mut numbers = (1_u32..).filter(|number| {
            let path = format!("{name}.end{number}");
            let mut axes = (0..self.model.axes.len()).map(AxisId::new);
            !axes.any(|axis| index::path(self.model, axis).is_some_and(|known| known == path))
        });
        let mut ends = String::new();
        for axis in left.into_iter().map(|axis| self.model.axis(axis)) {
            if axis.kind != AxisKind::Point || places.contains(&axis.at) {
                continue;
            }
            places.push(axis.at);
            let [x, y] = axis.at.map(|part| shortest(part, tolerance));
            let number = numbers.next().unwrap_or_default();
            ends += &format!("point end{number} = ({x}, {y}); ");
        }
        ends
    }
}
