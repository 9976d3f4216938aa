//! Repairs as changes of the text: what a user would do by hand.

use super::declaration::{Declaration, NewKind, turns_freely};
use super::motor::{NewMotor, slides, value_text};
use super::{NewNumbers, Repair, drivable};
use crate::model::{JointId, JointKind, LinkId, Model, MotorId, Ratio};
use crate::syntax::{Edits, Rewriter, StatementText, Tokens};

/// The changes of the text of a mechanism that make these repairs together; none if one of them cannot be made so. Whether the text is
/// right after them shows only when it is read again.
#[must_use]
pub fn edits(repairs: &[Repair], model: &Model, tokens: &Tokens) -> Option<Edits> {
    let rewriter = Rewriter::new(tokens);
    let mut writing = Writing { model, rewriter };
    // An added statement stands after one that stays.
    let mut repairs: Vec<&Repair> = repairs.iter().collect();
    repairs.sort_by_key(|repair| !takes_out(repair));
    for repair in repairs {
        writing.make(repair)?;
    }
    Some(writing.rewriter.edits)
}

/// Whether a repair only takes something out.
fn takes_out(repair: &Repair) -> bool {
    matches!(repair, Repair::RemoveJoint(_) | Repair::RemoveLink(_) | Repair::RemoveMotor(_))
}

/// The text of a mechanism that is being changed.
struct Writing<'m> {
    model: &'m Model,
    rewriter: Rewriter<'m>,
}

impl<'m> Writing<'m> {
    fn make(&mut self, repair: &Repair) -> Option<()> {
        let Self { model, rewriter } = self;
        match repair {
            Repair::Declare(declaration) => self.declare(declaration),
            Repair::RemoveJoint(joint) => rewriter.remove_joint(&model.joint(*joint).name),
            Repair::RemoveLink(link) => rewriter.remove_link(model, *link),
            Repair::Replace { joint, by } => self.change_kind(*joint, *by),
            Repair::RemoveMotor(motor) => rewriter.remove_motor(name_of_motor(model, *motor)),
            Repair::MoveMotor { motor, to } => self.move_motor(*motor, to),
            Repair::AddMotors(motors) => motors.iter().try_for_each(|motor| self.add_motor(motor)),
            Repair::AllowRedundant if model.allow.redundant => None,
            Repair::AllowRedundant => rewriter.add("allow redundant;", &["allow", "motor"]),
            Repair::AllowCoupled if model.allow.coupled => None,
            Repair::AllowCoupled => rewriter.add("allow coupled;", &["allow", "motor"]),
            Repair::AddEffects(words) => rewriter.ask_for(&words.join("; ")),
            Repair::StartAt { motor, value } => self.start_at(*motor, *value),
            Repair::Follow(motors) => self.follow(motors),
            Repair::Carry { joint, on } => self.carry(*joint, *on),
            Repair::Attach { joint, from, to } => self.attach(*joint, *from, *to),
            Repair::Numbers(numbers) => self.renumber(numbers),
            Repair::Resize { joint, sizes } => self.resize(*joint, *sizes),
        }
    }

    fn name(&self, joint: JointId) -> &'m str {
        &self.model.joint(joint).name
    }

    fn joint(&self, joint: JointId) -> Option<StatementText<'m>> {
        self.rewriter.declared("joint", self.name(joint))
    }

    fn add_motor(&mut self, motor: &NewMotor) -> Option<()> {
        let joint = motor.joint;
        // A joint that becomes another is driven otherwise.
        let is_kept = |joint: &StatementText<'_>| !self.rewriter.edits.is_changed(&joint.range());
        let is_drivable =
            drivable(self.model, joint) && self.joint(joint).is_none_or(|one| is_kept(&one));
        let statement = motor.statement(self.model);
        is_drivable.then(|| self.rewriter.add(&statement, &["motor"]))?
    }

    fn move_motor(&mut self, motor: MotorId, to: &NewMotor) -> Option<()> {
        let name = name_of_motor(self.model, motor);
        let statement = self.rewriter.declared("motor", name)?;
        let (_, after) = statement.path(1);
        let path = statement.token(1)..statement.token(after);
        self.rewriter.edits.replace(path, self.name(to.joint));
        if let Some(range) = to.range_text(self.model) {
            let end = statement.len() - 1;
            // A step in other units goes.
            let from = self.model.motor(motor).joint;
            let is_alike = slides(self.model, from) == slides(self.model, to.joint);
            let end = statement.find("by").filter(|_| is_alike).unwrap_or(end);
            let old = statement.token(statement.find("in")? + 1)..statement.token(end);
            self.rewriter.edits.replace(old, range);
        }
        self.rewriter.forget_start(name);
        drivable(self.model, to.joint).then_some(())
    }

    /// Makes a weld a revolute joint, or a revolute joint a slot.
    fn change_kind(&mut self, joint: JointId, by: NewKind) -> Option<()> {
        let statement = self.joint(joint)?;
        let (known, word) = match by {
            NewKind::Revolute => ("weld", "revolute"),
            NewKind::Slot(_) if turns_freely(self.model, joint) => ("revolute", "slot"),
            _ => return None,
        };
        let token = statement.token(statement.find(known)?);
        self.rewriter.edits.replace(token..token + 1, word);
        match by {
            NewKind::Slot(along) => self.direct(joint, &statement, along),
            _ => Some(()),
        }
    }

    /// Gives a joint that becomes a slot its line: in the drawing, or fixed to the second link.
    fn direct(
        &mut self,
        joint: JointId,
        statement: &StatementText<'_>,
        [x, y]: [f64; 2],
    ) -> Option<()> {
        let JointKind::Revolute(_, second) = self.model.joint(joint).kind else {
            return None;
        };
        let edits = &mut self.rewriter.edits;
        if statement.find("at").is_some() {
            let end = statement.token(statement.len() - 1);
            edits.insert_before(end, format!(" along ({x}, {y})"));
            return Some(());
        }
        let axis = self.model.axis(second);
        let link = self.model.link(axis.link).name.as_str();
        let line = self.new_line(axis.link)?;
        let [at_x, at_y] = axis.at;
        let declaration = format!("line {line} = ({at_x}, {at_y}) -> ({x}, {y});");
        // The path of the second point: its last word becomes the line's name.
        let open = statement.find("(")?;
        let (_, comma) = statement.path(open + 1);
        let (path, after) = statement.path(comma + 1);
        let point = path.rsplit('.').next()?;
        if statement.word(after - 1) != point || !path.contains('.') {
            return None;
        }
        let token = statement.token(after - 1);
        self.rewriter.edits.replace(token..token + 1, line);
        self.rewriter.add_item(link, &declaration)
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

    /// Starts a motor at a value. What is drawn would have to be drawn anew.
    fn start_at(&mut self, motor: MotorId, value: f64) -> Option<()> {
        if self.model.links.iter().any(|link| link.drawn) {
            return None;
        }
        let joint = self.model.motor(motor).joint;
        let value = value_text(self.model, joint, value);
        let name = self.name(joint);
        let clause = format!("{name} = {value};");
        let clauses = self.rewriter.clauses("start");
        let is_it = |one: &&StatementText<'_>| one.path(0).0 == name && one.find("near").is_none();
        match clauses.iter().find(is_it) {
            Some(known) => self.rewriter.edits.replace(known.range(), clause),
            None => self.rewriter.add_to_start(&clause)?,
        }
        Some(())
    }

    /// Lets these motors follow the point, instead of those that are written.
    fn follow(&mut self, motors: &[MotorId]) -> Option<()> {
        let statement = self.rewriter.all("follow").next()?;
        let first = statement.token(statement.find("by")? + 1);
        let last = statement.token(statement.len() - 1);
        let names = motors.iter().map(|motor| name_of_motor(self.model, *motor));
        let names: Vec<&str> = names.collect();
        self.rewriter.edits.replace(first..last, names.join(", "));
        Some(())
    }

    /// Names the carrier of what rolls, or leaves it to be found.
    fn carry(&mut self, joint: JointId, on: Option<LinkId>) -> Option<()> {
        let statement = self.joint(joint)?;
        let close = statement.token(statement.rfind(")")?);
        let clause = on.map(|link| format!("on {}", self.model.link(link).name));
        let known = statement.find("on").map(|word| statement.token(word)..close);
        let edits = &mut self.rewriter.edits;
        match (known, clause) {
            (Some(range), Some(clause)) => edits.replace(range, clause),
            (Some(range), None) => edits.remove(range),
            (None, Some(clause)) => edits.insert_before(close, format!(" {clause}")),
            (None, None) => return None,
        }
        self.model.joint(joint).kind.rolls().then_some(())
    }

    /// Writes another link at one end of a joint.
    fn attach(&mut self, joint: JointId, from: LinkId, to: LinkId) -> Option<()> {
        let statement = self.joint(joint)?;
        let first = statement.find("(")? + 1;
        let (_, comma) = statement.path(first);
        let [from, to] = [from, to].map(|link| &*self.model.link(link).name);
        let mut ends = [first, comma + 1].into_iter();
        let end = statement.token(ends.find(|&end| statement.word(end) == from)?);
        self.rewriter.edits.replace(end..end + 1, to);
        Some(())
    }

    /// Writes other numbers, if the old ones still stand there.
    fn renumber(&mut self, numbers: &NewNumbers) -> Option<()> {
        let NewNumbers { tokens, old, new, .. } = numbers;
        let mut statements = self.rewriter.statements.iter();
        let statement = statements.find(|one| one.range().contains(&tokens.start))?;
        let first = statement.token(0);
        let words = tokens.clone().map(|token| statement.word(token - first));
        let is_there = words.collect::<String>() == old.replace(' ', "");
        is_there.then(|| self.rewriter.edits.replace(tokens.clone(), new))
    }

    /// Gives two wheels other sizes.
    fn resize(&mut self, joint: JointId, sizes: Ratio) -> Option<()> {
        let statement = self.joint(joint)?;
        let open = statement.find("(")?;
        let (_, comma) = statement.path(open + 1);
        let (_, comma) = statement.path(comma + 1);
        let end = statement.find("on").or_else(|| statement.rfind(")"))?;
        let range = statement.token(comma + 1)..statement.token(end);
        self.rewriter.edits.replace(range, sizes.to_string());
        let is_gear = matches!(self.model.joint(joint).kind, JointKind::Gear { .. });
        is_gear.then_some(())
    }

    /// Declares joints and a link, some in place of others.
    fn declare(&mut self, declaration: &Declaration) -> Option<()> {
        if !declaration.can_replace(self.model) {
            return None;
        }
        if let Some(link) = &declaration.link {
            self.rewriter.add(&format!("link {link};"), &["link"])?;
        }
        for dropped in declaration.dropped_names(self.model) {
            self.rewriter.remove_joint(dropped)?;
        }
        for joint in &declaration.joints {
            let text = declaration.joint_text(joint, self.model);
            let mut replaced = declaration.replaced.iter();
            if replaced.any(|&id| self.name(id) == joint.name) {
                let statement = self.rewriter.declared("joint", &joint.name)?;
                self.rewriter.edits.replace(statement.range(), text);
                self.rewriter.forget_start(&joint.name);
            } else {
                self.rewriter.add(&text, &["joint"])?;
            }
        }
        Some(())
    }
}

fn name_of_motor(model: &Model, motor: MotorId) -> &str {
    &model.joint(model.motor(motor).joint).name
}
