//! Repairs as changes of the text: the second reading of what `repair` does to the model.

use crate::text::{Draft, Statement, statements};
use mech_compiler::model::{JointId, JointKind, LinkId, Model, MotorId, NewKind, Ratio};
use mech_compiler::repair::{Declaration, Repair};
use mech_compiler::reporter;
use std::ops::Range;

/// The text of a file after repairs of the mechanism with this body; none if one of them cannot be written as a change of the text. The
/// text has to be read again to see whether it says what the repairs promised.
pub(super) fn rewrite(
    text: &str,
    body: &Range<usize>,
    model: &Model,
    repairs: &[Repair],
) -> Option<String> {
    let mut rewriter = Rewriter::new(text, body, model);
    // What is added stands after something that stays.
    let mut repairs: Vec<&Repair> = repairs.iter().collect();
    repairs.sort_by_key(|repair| !takes_out(repair));
    for repair in repairs {
        rewriter.make(repair)?;
    }
    Some(rewriter.draft.finish())
}

/// The text of a file after clauses were added to the `start` of the mechanism with this body.
pub(super) fn rewrite_start(
    text: &str,
    body: &Range<usize>,
    model: &Model,
    clauses: &str,
) -> Option<String> {
    let mut rewriter = Rewriter::new(text, body, model);
    rewriter.add_to_start(clauses)?;
    Some(rewriter.draft.finish())
}

/// Whether a repair only takes something out.
fn takes_out(repair: &Repair) -> bool {
    matches!(
        repair,
        Repair::RemoveJoint(_) | Repair::RemoveLink(_) | Repair::RemoveMotor(_)
    )
}

/// A text, the mechanism that it declares, and the changes so far.
pub(crate) struct Rewriter<'t> {
    model: &'t Model,
    pub(crate) statements: Vec<Statement<'t>>,
    pub(crate) draft: Draft<'t>,
}

impl<'t> Rewriter<'t> {
    pub(crate) fn new(text: &'t str, body: &Range<usize>, model: &'t Model) -> Self {
        Self {
            model,
            statements: statements(text, body),
            draft: Draft::new(text),
        }
    }

    fn make(&mut self, repair: &Repair) -> Option<()> {
        match repair {
            Repair::Declare(declaration) => self.declare(declaration),
            Repair::RemoveJoint(joint) => self.remove_joint(*joint),
            Repair::RemoveLink(link) => self.remove_link(*link),
            Repair::Replace { joint, by } => self.change_kind(*joint, *by),
            Repair::RemoveMotor(motor) => self.remove_motor(*motor),
            Repair::MoveMotor { motor, to } => self.move_motor(*motor, *to),
            Repair::AddMotors(joints) => self.add_motors(joints),
            Repair::AllowRedundant => self.add("allow redundant;", &["allow", "motor"]),
            Repair::AllowCoupled => self.add("allow coupled;", &["allow", "motor"]),
            Repair::StartAt { motor, value } => self.start_at(*motor, *value),
            Repair::Carry { joint, on } => self.carry(*joint, *on),
            Repair::Resize { joint, sizes } => self.resize(*joint, *sizes),
            // What is not known yet cannot be written either.
            _ => None,
        }
    }

    /// The statement that declares something of this kind and name.
    pub(crate) fn declared(&self, word: &str, name: &str) -> Option<Statement<'t>> {
        let mut all = self.statements.iter();
        all.find(|one| one.declares(word, name)).cloned()
    }

    fn name(&self, joint: JointId) -> &'t str {
        &self.model.joint(joint).name
    }

    /// Adds a statement after the last of the first of these kinds of which there is one, or after the last joint.
    pub(crate) fn add(&mut self, statement: &str, after: &[&str]) -> Option<()> {
        let siblings = after.iter().chain(&["joint", "link"]);
        let siblings: Vec<&str> = siblings.copied().collect();
        self.add_beside(statement, &siblings)
    }

    /// Adds a statement after the last of the first of these kinds of which there is one, or after the first statement of all.
    pub(crate) fn add_beside(&mut self, statement: &str, siblings: &[&str]) -> Option<()> {
        let stays = |one: &&Statement<'_>| !self.draft.is_changed(&one.range());
        let last = |word: &&str| {
            let mut all = self.statements.iter().filter(stays);
            all.rfind(|one| one.is(word))
        };
        let sibling = siblings.iter().find_map(last);
        let range = sibling.or_else(|| self.statements.first())?.range();
        self.draft.insert_after(&range, statement);
        Some(())
    }

    /// Fixes something to a link of this name, or to the ground, which is declared if it is not.
    pub(crate) fn add_item(&mut self, link: &str, item: &str) -> Option<()> {
        let is_ground = link == "ground";
        let is_owner = |one: &&Statement<'_>| {
            let is_declared = ["link", "port"].iter().any(|word| one.declares(word, link));
            if is_ground {
                one.is("ground")
            } else {
                is_declared
            }
        };
        let owner = self.statements.iter().find(is_owner).cloned();
        let Some(owner) = owner else {
            let statement = format!("ground {{ {item} }}");
            let siblings = ["param", "const", "use", "look"];
            return is_ground
                .then(|| self.add_beside(&statement, &siblings))
                .flatten();
        };
        let (last, end) = (owner.len() - 1, owner.place(owner.len() - 1)?);
        if owner.word(last) == ";" {
            self.draft.replace(end, format!(" {{ {item} }}"));
        } else if let Some(sibling) = owner.clauses().last() {
            self.draft.insert_after(&sibling.range(), item);
        } else {
            self.draft.insert(end.start, format!(" {item} "));
        }
        Some(())
    }

    fn add_motors(&mut self, joints: &[JointId]) -> Option<()> {
        for &joint in joints {
            let statement = format!("motor {};", self.name(joint));
            self.add(&statement, &["motor"])?;
        }
        Some(())
    }

    pub(crate) fn remove_motor(&mut self, motor: MotorId) -> Option<()> {
        let name = self.name(self.model.motor(motor).joint);
        let statement = self.declared("motor", name)?;
        self.draft.remove(&statement.range());
        self.forget_start(name);
        Some(())
    }

    fn move_motor(&mut self, motor: MotorId, to: JointId) -> Option<()> {
        let name = self.name(self.model.motor(motor).joint);
        let statement = self.declared("motor", name)?;
        let (_, after) = statement.path(1);
        let path = statement.place(1)?.start..statement.place(after - 1)?.end;
        self.draft.replace(path, self.name(to));
        self.forget_start(name);
        Some(())
    }

    /// Takes the clauses out that say where a joint or a link starts.
    fn forget_start(&mut self, name: &str) {
        self.remove_clauses("start", |clause| clause.path(0).0 == name);
    }

    /// Takes clauses out of a statement that has clauses: all of it, if none is left.
    pub(crate) fn remove_clauses(&mut self, word: &str, is_out: impl Fn(&Statement<'_>) -> bool) {
        for statement in self.statements.iter().filter(|one| one.is(word)) {
            let clauses = statement.clauses();
            let out: Vec<&Statement<'_>> = clauses.iter().filter(|clause| is_out(clause)).collect();
            if !out.is_empty() && out.len() == clauses.len() {
                self.draft.remove(&statement.range());
                continue;
            }
            for clause in out {
                self.draft.remove(&clause.range());
            }
        }
    }

    /// Takes a joint out, and everything that cannot be without it.
    pub(crate) fn remove_joint(&mut self, joint: JointId) -> Option<()> {
        let name = self.name(joint);
        self.remove_statement("joint", name)?;
        self.forget_joint(name);
        Some(())
    }

    pub(crate) fn remove_statement(&mut self, word: &str, name: &str) -> Option<()> {
        let statement = self.declared(word, name)?;
        self.draft.remove(&statement.range());
        Some(())
    }

    fn remove_all(&mut self, is_out: impl Fn(&Statement<'_>) -> bool) {
        for statement in self.statements.iter().filter(|one| is_out(one)) {
            self.draft.remove(&statement.range());
        }
    }

    /// Takes everything out that cannot be without a joint.
    fn forget_joint(&mut self, name: &str) {
        let _ = self.remove_statement("motor", name);
        self.forget_start(name);
        self.remove_from_lists(name);
        let acts = |one: &Statement<'_>| {
            let is_torsional = one.find("torsional").is_some();
            (one.is("spring") || one.is("damper")) && is_torsional && one.mentions(name)
        };
        self.remove_all(acts);
    }

    /// Takes a name out of the lists of what is shown and what is continuous.
    pub(crate) fn remove_from_lists(&mut self, name: &str) {
        for statement in self
            .statements
            .iter()
            .filter(|one| one.is("show") || one.is("continuous"))
        {
            let mut items: Vec<(String, Range<usize>)> = Vec::new();
            let mut at = 1;
            while at + 1 < statement.len() {
                let (path, after) = statement.path(at);
                let ends = statement.place(at).zip(statement.place(after - 1));
                let Some((first, last)) = ends else {
                    break;
                };
                items.push((path, first.start..last.end));
                at = after + 1;
            }
            let is_out = |path: &str| {
                let inside = path.strip_prefix(name);
                inside.is_some_and(|inside| inside.is_empty() || inside.starts_with('.'))
            };
            let kept: Vec<&str> = items
                .iter()
                .filter(|(path, _)| !is_out(path))
                .map(|(path, _)| path.as_str())
                .collect();
            if kept.len() == items.len() {
                continue;
            }
            match (items.first(), items.last()) {
                (Some((_, first)), Some((_, last))) if !kept.is_empty() => {
                    self.draft.replace(first.start..last.end, kept.join(", "));
                }
                _ => self.draft.remove(&statement.range()),
            }
        }
    }

    /// Takes a link out, with its joints, and with what acts on it.
    pub(crate) fn remove_link(&mut self, link: LinkId) -> Option<()> {
        let model = self.model;
        let name = model.link(link).name.as_str();
        self.remove_statement("link", name)?;
        let mut gone: Vec<&str> = Vec::new();
        for joint in model.joint_ids() {
            let (a, b) = model.ends(joint);
            let name = self.name(joint);
            if (a == link || b == link) && !gone.contains(&name) {
                gone.push(name);
            }
        }
        for (cam, shaft, follower, _) in model.cams() {
            let uses = [shaft, follower].map(|joint| gone.contains(&self.name(joint)));
            if uses.contains(&true) && !gone.contains(&self.name(cam)) {
                gone.push(self.name(cam));
            }
        }
        for joint in gone {
            self.remove_statement("joint", joint)?;
            self.forget_joint(joint);
        }
        self.forget_start(name);
        self.remove_from_lists(name);
        self.remove_clauses("effects", |clause| {
            clause.is("trace") && clause.mentions(name)
        });
        let acts = |one: &Statement<'_>| {
            let is_action = one.is("spring") || one.is("damper") || one.is("load");
            is_action && one.find("torsional").is_none() && one.mentions(name)
        };
        self.remove_all(acts);
        Some(())
    }

    /// Makes a weld a revolute joint, or a revolute joint a slot.
    fn change_kind(&mut self, joint: JointId, by: NewKind) -> Option<()> {
        let statement = self.declared("joint", self.name(joint))?;
        match by {
            NewKind::Revolute => {
                let word = statement.find("weld")?;
                self.draft.replace(statement.place(word)?, "revolute");
            }
            NewKind::Slot(along) => {
                let word = statement.find("revolute")?;
                self.draft.replace(statement.place(word)?, "slot");
                self.direct(joint, &statement, along)?;
            }
            _ => return None,
        }
        Some(())
    }

    /// Gives a joint that becomes a slot its line: in the drawing, or fixed to the second link.
    fn direct(
        &mut self,
        joint: JointId,
        statement: &Statement<'_>,
        [x, y]: [f64; 2],
    ) -> Option<()> {
        let JointKind::Revolute(_, second) = self.model.joint(joint).kind else {
            return None;
        };
        if statement.find("at").is_some() {
            let end = statement.place(statement.len() - 1)?.start;
            self.draft.insert(end, format!(" along ({x}, {y})"));
            return Some(());
        }
        let axis = self.model.axis(second);
        let link = self.model.link(axis.link).name.as_str();
        let line = self.new_line(axis.link)?;
        let declaration = format!(
            "line {line} = ({}, {}) -> ({x}, {y});",
            axis.at[0], axis.at[1]
        );
        // The path of the second point: its last word becomes the line's name.
        let open = statement.find("(")?;
        let (_, comma) = statement.path(open + 1);
        let (path, after) = statement.path(comma + 1);
        let point = path.rsplit('.').next()?;
        if statement.word(after - 1) != point || !path.contains('.') {
            return None;
        }
        self.draft.replace(statement.place(after - 1)?, line);
        self.add_item(link, &declaration)
    }

    /// A name that no axis of a link has.
    fn new_line(&self, link: LinkId) -> Option<String> {
        let is_known = |name: &String| {
            let mut axes = self.model.axes.iter();
            axes.any(|axis| axis.link == link && axis.name.as_ref() == Some(name))
        };
        let mut names = (1..).map(|number| match number {
            1 => "way".to_owned(),
            _ => format!("way{number}"),
        });
        names.find(|name| !is_known(name))
    }

    /// Starts a motor at a value.
    fn start_at(&mut self, motor: MotorId, value: f64) -> Option<()> {
        let joint = self.model.motor(motor).joint;
        let turns = matches!(self.model.joint(joint).kind, JointKind::Revolute(..));
        let degrees = (value.to_degrees() * 1e9).round() / 1e9;
        let is_exact = (degrees.to_radians() - value).abs() < 1e-12;
        let value = if turns && is_exact {
            format!("{degrees} deg")
        } else {
            format!("{value}")
        };
        let clause = format!("{} = {value};", self.name(joint));
        let name = self.name(joint);
        let starts = self.statements.iter().filter(|one| one.is("start"));
        let clauses = starts.flat_map(Statement::clauses).collect::<Vec<_>>();
        let is_it = |one: &&Statement<'_>| one.path(0).0 == name && one.find("near").is_none();
        match clauses.iter().find(is_it) {
            Some(known) => self.draft.replace(known.range(), clause),
            None => self.add_to_start(&clause)?,
        }
        Some(())
    }

    /// Adds clauses to the start, which is declared if there is none.
    pub(crate) fn add_to_start(&mut self, clauses: &str) -> Option<()> {
        if self.statements.iter().any(|one| one.is("start")) {
            return self.add_clause("start", clauses);
        }
        self.add(&format!("start {{ {clauses} }}"), &["motor"])
    }

    /// Adds clauses to the statement that begins with this word and has clauses.
    pub(crate) fn add_clause(&mut self, word: &str, clauses: &str) -> Option<()> {
        let statement = self.statements.iter().find(|one| one.is(word))?;
        if let Some(last) = statement.clauses().last() {
            self.draft.insert_after(&last.range(), clauses);
        } else {
            let open = statement.place(statement.find("{")?)?.end;
            self.draft.insert(open, format!(" {clauses} "));
        }
        Some(())
    }

    /// Asks for forces, where nothing does: a load is only declared there.
    pub(crate) fn ask_for_forces(&mut self) -> Option<()> {
        let asks = |one: &Statement<'_>| one.is("force") || one.is("dynamics");
        let Some(effects) = self.statements.iter().find(|one| one.is("effects")) else {
            return self.add("effects { force; }", &["start", "motor"]);
        };
        if effects.clauses().iter().any(asks) {
            return Some(());
        }
        self.add_clause("effects", "force;")
    }

    /// Names the carrier of what rolls, or leaves it to be found.
    fn carry(&mut self, joint: JointId, on: Option<LinkId>) -> Option<()> {
        let statement = self.declared("joint", self.name(joint))?;
        let close = statement.place(statement.rfind(")")?)?.start;
        let clause = on.map(|link| format!("on {}", self.model.link(link).name));
        let known = match statement.find("on") {
            Some(word) => Some(statement.place(word)?.start..close),
            None => None,
        };
        match (known, clause) {
            (Some(range), Some(clause)) => self.draft.replace(range, clause),
            (Some(range), None) => self.draft.remove(&range),
            (None, Some(clause)) => self.draft.insert(close, format!(" {clause}")),
            (None, None) => return None,
        }
        Some(())
    }

    /// Gives two wheels other sizes.
    fn resize(&mut self, joint: JointId, sizes: Ratio) -> Option<()> {
        let statement = self.declared("joint", self.name(joint))?;
        let open = statement.find("(")?;
        let (_, comma) = statement.path(open + 1);
        let (_, comma) = statement.path(comma + 1);
        let end = statement.find("on").or_else(|| statement.rfind(")"))?;
        let range = statement.place(comma + 1)?.start..statement.place(end - 1)?.end;
        self.draft.replace(range, sizes.to_string());
        Some(())
    }

    /// Declares joints and a link, some in place of others.
    fn declare(&mut self, declaration: &Declaration) -> Option<()> {
        let texts = reporter::statements(declaration, self.model);
        let links = usize::from(declaration.link.is_some());
        for text in &texts[..links] {
            self.add(text, &["link"])?;
        }
        let has_heir = |name: &str| declaration.joints.iter().any(|joint| joint.name == name);
        let replaced = declaration.replaced.iter().map(|&id| self.name(id));
        let (heirs, dropped): (Vec<&str>, Vec<&str>) = replaced.partition(|name| has_heir(name));
        for name in dropped {
            self.remove_statement("joint", name)?;
            self.forget_joint(name);
        }
        for (joint, text) in declaration.joints.iter().zip(&texts[links..]) {
            if heirs.contains(&joint.name.as_str()) {
                let statement = self.declared("joint", &joint.name)?;
                self.draft.replace(statement.range(), text.clone());
                self.forget_start(&joint.name);
            } else {
                self.add(text, &["joint"])?;
            }
        }
        Some(())
    }
}
