//! Repairs in words.

use super::Words;
use super::wording::{brief, one_of};
use crate::bug::bug;
use crate::model::{JointId, JointKind, MotorId};
use crate::repair::{NewKind, NewMotor, NewNumbers, Offers, Repair, Search};

/// A line is not made longer than this by putting several phrases on it.
const WIDTH: usize = 100;

impl Words<'_> {
    /// The lines that say what would mend it, each after a line break: none if nothing was found.
    pub(super) fn help(&self, offers: &Offers) -> String {
        const LINES: usize = 4;
        const PAIRS: usize = 2;
        let mut lines = in_lines(&self.phrases(&offers.single));
        if !offers.elsewhere.is_empty() {
            let phrases = self.phrases(&offers.elsewhere).join(", or ");
            let how = self.with_other_start(&offers.elsewhere);
            lines.push(format!("{phrases}, {how}"));
        }
        if !offers.coupled.is_empty() {
            let phrases = self.phrases(&offers.coupled).join(", or ");
            lines.push(format!(
                "{phrases}, with `allow coupled;`: then everything is determined, but loops are solved together"
            ));
        }
        if !lines.is_empty() {
            let pairs = offers.pairs.iter().take(PAIRS);
            lines.extend(pairs.map(|pair| self.together(pair)));
        }
        lines.truncate(LINES);
        let alone = in_lines(&self.phrases(&offers.partial));
        let alone = alone.first().map(|line| format!("\nhelp: for this alone, {line}"));
        let some = !lines.is_empty() || alone.is_some();
        let cut = some && offers.search == Search::Bounded;
        let cut = cut.then(|| "\nnote: not all possible changes were tried".to_owned());
        lines
            .iter()
            .enumerate()
            .map(|(index, line)| ["\nhelp: ", if index == 0 { "" } else { "or " }, line].concat())
            .chain(alone)
            .chain(cut)
            .collect()
    }

    /// The same, and what is to be said where no single change does.
    pub(super) fn help_or_pairs(&self, offers: &Offers) -> String {
        const SHOWN: usize = 3;
        let help = self.help(offers);
        if !help.is_empty() {
            return help;
        }
        if offers.pairs.is_empty() {
            let note = match offers.search {
                Search::Singles => "",
                Search::Pairs => "\nnote: no single change mends it, nor were two found that do",
                Search::Bounded => {
                    "\nnote: not all changes were tried; of those that were, none mends it"
                }
            };
            return note.to_owned();
        }
        let lines = offers.pairs.iter().take(SHOWN).enumerate();
        let lines = lines.map(|(index, pair)| {
            let word = if index == 0 { "together: " } else { "or " };
            ["\nhelp: ", word, &self.together(pair)].concat()
        });
        let note = "\nnote: no single change mends it".to_owned();
        [note].into_iter().chain(lines).collect()
    }

    /// Changes that are made one after the other.
    pub(super) fn all_together(&self, repairs: &[Repair]) -> String {
        match repairs {
            [first, second] => self.together(&[first.clone(), second.clone()]),
            _ => repairs.iter().map(|one| self.phrase(one)).collect::<Vec<_>>().join(" and "),
        }
    }

    /// One change.
    fn phrase(&self, repair: &Repair) -> String {
        self.phrases(std::slice::from_ref(repair)).concat()
    }

    /// Two changes, the second after the first.
    fn together(&self, [first, second]: &[Repair; 2]) -> String {
        let (first, second) = (self.phrase(first), self.phrase(second));
        match second.strip_prefix("remove ") {
            Some(other) if first.starts_with("remove ") => format!("{first} and {other}"),
            _ => format!("{first} and {second}"),
        }
    }

    fn with_other_start(&self, repairs: &[Repair]) -> &'static str {
        let moves =
            |repair: &Repair| matches!(repair, Repair::AddMotors(_) | Repair::MoveMotor { .. });
        if repairs.iter().all(moves) {
            "with its coordinate in `start`: at 0 the mechanism does not close"
        } else if self.model.start.values.is_empty() {
            "and start it elsewhere: at 0 it does not close then"
        } else {
            "and start it elsewhere: as it starts now it does not close then"
        }
    }

    /// All these changes, those of a kind together where the first of them is.
    fn phrases(&self, repairs: &[Repair]) -> Vec<String> {
        let alone = |(place, repair): (usize, &Repair)| {
            let phrase = match repair {
                Repair::Declare(declaration) => self.declaration(declaration),
                Repair::AllowRedundant => "add `allow redundant;`".to_owned(),
                Repair::AddEffects(words) => {
                    format!("add `effects {{ {}; }}`", words.join("; "))
                }
                Repair::AllowCoupled => {
                    "add `allow coupled;` to solve these loops together".to_owned()
                }
                Repair::StartAt { motor, value } => self.start_at(*motor, *value),
                Repair::Follow(motors) => self.follow_line(motors),
                Repair::Attach { joint, from, to } => {
                    let [from, to] = [*from, *to].map(|link| self.link(link));
                    format!("write {to} for {from} in {}", self.joint_line(*joint))
                }
                Repair::Numbers(NewNumbers { old, new, statement, .. }) => {
                    format!("write `{new}` for `{old}` in `{statement}`")
                }
                _ => return None,
            };
            Some((place, phrase))
        };
        let mut phrases: Vec<(usize, String)> =
            repairs.iter().enumerate().filter_map(alone).collect();
        phrases.extend(self.moved_motors(repairs));
        let listed = |before: &str, after: &str, name: &dyn Fn(&Repair) -> Option<String>| {
            let names = collect_names(repairs, name);
            let place = repairs.iter().position(|repair| name(repair).is_some());
            place.map(|place| (place, [before, &one_of(&names), after].concat()))
        };
        let lists = [
            listed("write ", "", &|repair| match repair {
                Repair::Resize { sizes, .. } => Some(format!("`{sizes}`")),
                _ => None,
            }),
            listed("remove ", "", &|repair| match repair {
                Repair::RemoveMotor(motor) => Some(self.motor_line(*motor)),
                Repair::RemoveLink(link) => Some(format!("`link {}`", self.model.link(*link).name)),
                Repair::RemoveJoint(joint) => Some(self.joint_line(*joint)),
                _ => None,
            }),
            listed("replace ", " by `slot(...)`", &|repair| match repair {
                Repair::Replace { joint, by: NewKind::Slot(_) } => Some(self.joint_line(*joint)),
                _ => None,
            }),
            listed("replace ", " by `revolute(...)`", &|repair| match repair {
                Repair::Replace { joint, by: NewKind::Revolute } => Some(self.joint_line(*joint)),
                _ => None,
            }),
            listed("leave ", " out", &|repair| match repair {
                Repair::Carry { joint, on: None } => Some(self.carrier_clause(*joint)),
                _ => None,
            }),
            listed("write ", "", &|repair| match repair {
                Repair::Carry { on: Some(link), .. } => {
                    Some(format!("`on {}`", self.model.link(*link).name))
                }
                _ => None,
            }),
        ];
        phrases.extend(lists.into_iter().flatten());
        phrases.extend(self.added_motors(repairs));
        phrases.sort_by_key(|(place, _)| *place);
        phrases.into_iter().map(|(_, phrase)| phrase).collect()
    }

    fn joint_line(&self, joint: JointId) -> String {
        format!("`joint {}`", self.model.joint(joint).name)
    }

    /// A motor, with the start that goes with it.
    fn motor_line(&self, motor: MotorId) -> String {
        let joint = self.model.motor(motor).joint;
        let name = &self.model.joint(joint).name;
        let mut starts = self.model.start.values.iter();
        if starts.any(|value| value.joint == joint) {
            format!("`motor {name};` with its start")
        } else {
            format!("`motor {name};`")
        }
    }

    /// The clause by which the carrier of what rolls is named.
    fn carrier_clause(&self, joint: JointId) -> String {
        match self.model.joint(joint).kind {
            JointKind::Gear { on: Some(on), .. }
            | JointKind::Belt { on: Some(on), .. }
            | JointKind::Rack { on: Some(on), .. } => format!("`on {}`", self.model.link(on).name),
            _ => "`on LINK`".to_owned(),
        }
    }

    /// For each motor that could be moved, where to; each with its place in the list.
    fn moved_motors(&self, repairs: &[Repair]) -> Vec<(usize, String)> {
        let moved = |repair: &Repair| match repair {
            Repair::MoveMotor { motor, .. } => Some(*motor),
            _ => None,
        };
        let mut motors: Vec<MotorId> = repairs.iter().filter_map(moved).collect();
        motors.dedup();
        let phrase = |motor| {
            let to = collect_names(repairs, |repair| match repair {
                Repair::MoveMotor { motor: other, to } if *other == motor => {
                    let range = to.range_text(self.model);
                    let range = range.map(|range| format!(" with the range `{range}`"));
                    Some(self.joint(to.joint) + &range.unwrap_or_default())
                }
                _ => None,
            });
            let from = self.joint(self.model.motor(motor).joint);
            let mut all = repairs.iter();
            let Some(place) = all.position(|repair| moved(repair) == Some(motor)) else {
                bug!("a motor is moved by no repair");
            };
            let phrase = format!("move the motor from {from} to {}", one_of(&to));
            (place, phrase)
        };
        motors.into_iter().map(phrase).collect()
    }

    /// Motors on one joint each, or on several at once; each with its place in the list.
    fn added_motors(&self, repairs: &[Repair]) -> Vec<(usize, String)> {
        let line = |motor: &NewMotor| format!("`{}`", motor.statement(self.model));
        let mut alone: Vec<(usize, &NewMotor)> = Vec::new();
        let mut phrases = Vec::new();
        for (number, repair) in repairs.iter().enumerate() {
            match repair {
                Repair::AddMotors(motors) if motors.len() == 1 => {
                    alone.extend(motors.iter().map(|motor| (number, motor)));
                }
                Repair::AddMotors(motors) => {
                    let lines: Vec<String> = motors.iter().map(line).collect();
                    phrases.push((number, format!("add {}", lines.join(" and "))));
                }
                _ => {}
            }
        }
        let Some((&(place, first), others)) = alone.split_first() else {
            return phrases;
        };
        let mut phrase = format!("add {}", line(first));
        if let [(next, _), ..] = others {
            let sits = others.iter().map(|(_, motor)| self.joint(motor.joint));
            let is_ranged = others.iter().any(|(_, motor)| motor.range.is_some());
            let ranges = if is_ranged { " with a range" } else { "" };
            let elsewhere = one_of(&sits.collect::<Vec<_>>());
            let elsewhere = format!("a motor{ranges} on {elsewhere}");
            if *next == place + 1 {
                phrase += &format!(", or {elsewhere} instead");
            } else {
                phrases.push((*next, format!("add {elsewhere}")));
            }
        }
        phrases.push((place, phrase));
        phrases
    }

    fn start_at(&self, motor: MotorId, value: f64) -> String {
        let joint = self.model.motor(motor).joint;
        let text = if let JointKind::Prismatic(..) = self.model.joint(joint).kind {
            brief(value)
        } else {
            format!("{} deg", brief(value.to_degrees()))
        };
        if self.is_drawn(joint) {
            format!("draw it as it is when {} is at {text}", self.joint(joint))
        } else {
            let name = &self.model.joint(joint).name;
            format!("start elsewhere, as `start {{ {name} = {text}; }}`")
        }
    }
}

fn collect_names(repairs: &[Repair], name: impl Fn(&Repair) -> Option<String>) -> Vec<String> {
    repairs.iter().filter_map(name).collect()
}

/// Phrases on as few lines as they fit on. What is to be written out has a line of its own.
fn in_lines(phrases: &[String]) -> Vec<String> {
    let written_out = |phrase: &str| phrase.contains(": add `") || phrase.contains(": write `");
    let mut lines: Vec<String> = Vec::new();
    for phrase in phrases {
        let alone = |line: &str| written_out(line) || written_out(phrase);
        match lines.last_mut() {
            Some(line) if !alone(line) && line.len() + phrase.len() <= WIDTH => {
                line.push_str(", or ");
                line.push_str(phrase);
            }
            _ => lines.push(phrase.clone()),
        }
    }
    lines
}
