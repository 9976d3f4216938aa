//! Changes of a text, statement by statement, with what follows from them.

use super::statement::begins_with;
use super::{Edits, StatementText, Tokens};
use crate::model::{JointId, LinkId, Model};
use std::collections::BTreeSet;

/// The statements of a text, and the changes of it so far.
#[derive(Clone, Debug)]
pub struct Rewriter<'s> {
    /// The statements as they stand there before all changes, the `struct` line among them.
    pub statements: Vec<StatementText<'s>>,
    /// The changes.
    pub edits: Edits,
}

impl<'s> Rewriter<'s> {
    /// No change yet.
    #[must_use]
    pub fn new(tokens: &'s Tokens) -> Self {
        Self { statements: tokens.statements(), edits: Edits::default() }
    }

    /// The statement that declares something of this kind and name.
    #[must_use]
    pub fn declared(&self, word: &str, name: &str) -> Option<StatementText<'s>> {
        let mut all = self.statements.iter();
        all.find(|one| one.declares(word, name)).cloned()
    }

    /// The statement that declares what is fixed to a link of this name, or to the ground.
    #[must_use]
    pub fn owner(&self, link: &str) -> Option<StatementText<'s>> {
        let is_it = |one: &&StatementText<'_>| {
            if link == "ground" {
                one.is("ground")
            } else {
                one.declares("link", link) || one.declares("port", link)
            }
        };
        self.statements.iter().find(is_it).cloned()
    }

    /// All statements that begin with this word.
    pub fn all(&self, word: &'static str) -> impl Iterator<Item = &StatementText<'s>> {
        self.statements.iter().filter(move |one| one.is(word))
    }

    /// The clauses of all statements that begin with this word.
    #[must_use]
    pub fn clauses(&self, word: &'static str) -> Vec<StatementText<'s>> {
        self.all(word).flat_map(StatementText::clauses).collect()
    }

    /// Adds a statement after the last of the first of these kinds of which there is one, or after the last joint.
    ///
    /// Like all methods that return an option: none if it cannot be done.
    pub fn add(&mut self, statement: &str, after: &[&str]) -> Option<()> {
        let siblings: Vec<&str> = after.iter().chain(&["joint", "link"]).copied().collect();
        self.add_beside(statement, &siblings)
    }

    /// Adds a statement after the last of the first of these kinds of which there is one, or after the first statement of all.
    pub fn add_beside(&mut self, statement: &str, siblings: &[&str]) -> Option<()> {
        let last = |word: &&str| {
            let mut all = self.statements.iter().rev();
            all.find(|one| one.is(word) && !self.edits.is_removed(&one.range()))
        };
        let sibling = siblings.iter().find_map(last);
        let after = sibling.or_else(|| self.statements.first())?.range();
        self.edits.add(after, statement);
        Some(())
    }

    /// Fixes something to a link of this name, or to the ground, which is declared if it is not.
    pub fn add_item(&mut self, link: &str, item: &str) -> Option<()> {
        let Some(owner) = self.owner(link) else {
            let statement = format!("ground {{ {item} }}");
            let siblings = ["param", "const", "use", "look"];
            let is_ground = link == "ground";
            return is_ground.then(|| self.add_beside(&statement, &siblings)).flatten();
        };
        let end = owner.len() - 1;
        if owner.word(end) == ";" {
            let end = owner.token(end);
            self.edits.replace(end..end + 1, format!(" {{ {item} }}"));
        } else if let Some(sibling) = owner.clauses().last() {
            self.edits.add(sibling.range(), item);
        } else {
            self.edits.insert_before(owner.token(end), format!(" {item} "));
        }
        Some(())
    }

    /// Adds clauses to the start, which is declared if there is none.
    pub fn add_to_start(&mut self, clauses: &str) -> Option<()> {
        if self.all("start").next().is_some() {
            return self.add_clause("start", clauses);
        }
        self.add(&format!("start {{ {clauses} }}"), &["motor"])
    }

    /// Adds clauses to the statement that begins with this word and has clauses.
    pub fn add_clause(&mut self, word: &'static str, clauses: &str) -> Option<()> {
        let statement = self.all(word).next()?.clone();
        if let Some(last) = statement.clauses().last() {
            self.edits.add(last.range(), clauses);
        } else {
            let open = statement.token(statement.find("{")?);
            self.edits.insert_after(open, format!(" {clauses} "));
        }
        Some(())
    }

    /// Asks for forces, where nothing does: a load is only declared there.
    pub fn ask_for_forces(&mut self) -> Option<()> {
        let asks = |one: &StatementText<'_>| one.is("force") || one.is("dynamics");
        let is_asked = |effects: &StatementText<'_>| effects.clauses().iter().any(asks);
        if self.all("effects").any(is_asked) {
            return Some(());
        }
        self.ask_for("force")
    }

    /// Asks for effects.
    pub fn ask_for(&mut self, words: &str) -> Option<()> {
        if self.all("effects").next().is_some() {
            return self.add_clause("effects", &format!("{words};"));
        }
        let statement = format!("effects {{ {words}; }}");
        self.add(&statement, &["start", "motor"])
    }

    /// Removes the statement that declares something of this kind and name.
    pub fn remove_statement(&mut self, word: &str, name: &str) -> Option<()> {
        let statement = self.declared(word, name)?;
        self.edits.remove(statement.range());
        Some(())
    }

    fn remove_all(&mut self, is_out: impl Fn(&StatementText<'_>) -> bool) {
        for statement in self.statements.iter().filter(|one| is_out(one)) {
            self.edits.remove(statement.range());
        }
    }

    /// Removes clauses of the statements that begin with this word: all of a statement, if none is left in it.
    pub fn remove_clauses(&mut self, word: &str, is_out: impl Fn(&StatementText<'_>) -> bool) {
        for statement in self.statements.iter().filter(|one| one.is(word)) {
            let clauses = statement.clauses();
            let out: Vec<_> = clauses.iter().filter(|clause| is_out(clause)).collect();
            if !out.is_empty() && out.len() == clauses.len() {
                self.edits.remove(statement.range());
                continue;
            }
            for clause in out {
                self.edits.remove(clause.range());
            }
        }
    }

    /// Removes the clauses that say where a joint or a link starts.
    pub fn forget_start(&mut self, name: &str) {
        self.remove_clauses("start", |clause| clause.path(0).0 == name);
    }

    /// Removes the motor of a joint, with its start.
    pub fn remove_motor(&mut self, joint: &str) -> Option<()> {
        self.remove_statement("motor", joint)?;
        self.forget_start(joint);
        self.remove_follow(joint);
        Some(())
    }

    /// Removes what motors follow, and its path, if it mentions this link or joint.
    fn remove_follow(&mut self, name: &str) {
        if self.all("follow").any(|one| one.mentions(name)) {
            self.remove_all(|one| one.is("follow") || one.is("path"));
        }
    }

    /// Removes a joint, and everything that cannot be without it.
    pub fn remove_joint(&mut self, joint: &str) -> Option<()> {
        self.remove_statement("joint", joint)?;
        let _ = self.remove_statement("motor", joint);
        self.forget_start(joint);
        self.remove_from_lists(joint);
        self.remove_all(|one| one.is("expect") && one.mentions(joint));
        self.remove_follow(joint);
        self.remove_all(|one| {
            let is_torsional = one.find("torsional").is_some();
            (one.is("spring") || one.is("damper")) && is_torsional && one.mentions(joint)
        });
        Some(())
    }

    /// Removes a link of a mechanism, with its joints, and with what acts on it.
    pub fn remove_link(&mut self, model: &Model, link: LinkId) -> Option<()> {
        let name = model.link(link).name.as_str();
        self.remove_statement("link", name)?;
        for joint in joints_with(model, link) {
            self.remove_joint(joint)?;
        }
        self.forget_start(name);
        self.remove_from_lists(name);
        self.remove_clauses("effects", |clause| clause.is("trace") && clause.mentions(name));
        self.remove_all(|one| {
            let is_action = one.is("spring") || one.is("damper") || one.is("load");
            is_action && one.find("torsional").is_none() && one.mentions(name)
                || one.is("expect") && one.mentions(name)
        });
        self.remove_follow(name);
        Some(())
    }

    /// Removes a name from the lists of what is shown and what is continuous.
    pub fn remove_from_lists(&mut self, name: &str) {
        let is_list = |one: &&StatementText<'_>| one.is("show") || one.is("continuous");
        for statement in self.statements.iter().filter(is_list) {
            let mut paths = Vec::new();
            let mut at = 1;
            while at + 1 < statement.len() {
                let (path, after) = statement.path(at);
                paths.push(path);
                at = after + 1;
            }
            let is_kept = |path: &&String| !begins_with(path, name);
            let kept: Vec<&str> = paths.iter().filter(is_kept).map(String::as_str).collect();
            if kept.len() == paths.len() {
                continue;
            }
            if kept.is_empty() {
                self.edits.remove(statement.range());
            } else {
                let inside = statement.token(1)..statement.token(statement.len() - 1);
                self.edits.replace(inside, kept.join(", "));
            }
        }
    }
}

/// The names of the joints that cannot be without a link: its own, and the cams that these make.
fn joints_with(model: &Model, link: LinkId) -> BTreeSet<&str> {
    let name = |joint| model.joint(joint).name.as_str();
    let is_own = |joint: &JointId| {
        let (a, b) = model.ends(*joint);
        a == link || b == link
    };
    let mut gone: BTreeSet<&str> = model.joint_ids().filter(is_own).map(name).collect();
    for (cam, shaft, follower, _) in model.cams() {
        if [shaft, follower].iter().any(|&joint| gone.contains(name(joint))) {
            gone.insert(name(cam));
        }
    }
    gone
}
