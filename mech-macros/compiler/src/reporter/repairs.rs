//! Repairs in words.

use super::Words;
use super::wording::{brief, one_of};
use crate::model::{JointId, JointKind, MotorId};
use crate::repair::{Offers, Repair, Search};

/// A help line is not made longer than this by putting several phrases on it.
const WIDTH: usize = 100;

impl Words<'_> {
    /// The lines that say what would mend it: none if nothing was searched for.
    pub(super) fn help(&self, offers: &Offers) -> String {
        let mut text = lines("help: ", &self.phrases(&offers.single));
        if !offers.elsewhere.is_empty() {
            let or = if text.is_empty() {
                "help: "
            } else {
                "help: or "
            };
            let phrases = self.phrases(&offers.elsewhere).join(", or ");
            let how = self.with_other_start(&offers.elsewhere);
            text += &format!("\n{or}{phrases}, {how}");
        }
        if !offers.coupled.is_empty() {
            let or = if text.is_empty() {
                "help: "
            } else {
                "help: or "
            };
            let phrases = self.phrases(&offers.coupled).join(", or ");
            text += &format!(
                "\n{or}{phrases}, with `allow coupled;`: it settles everything, but the loops then wait for each other"
            );
        }
        if !offers.partial.is_empty() {
            text += &lines(
                "help: against this error alone, ",
                &self.phrases(&offers.partial),
            );
        }
        text
    }

    /// The same, and what is to be said where no single change does.
    pub(super) fn help_or_pairs(&self, offers: &Offers) -> String {
        const SHOWN: usize = 3;
        let help = self.help(offers);
        if !help.is_empty() {
            return help;
        }
        if offers.pairs.is_empty() {
            return match offers.search {
                Search::Singles => String::new(),
                Search::Pairs => {
                    "\nnote: no single change mends it, nor do two together".to_owned()
                }
                Search::Bounded => {
                    "\nnote: of the many changes that were tried, none mends it".to_owned()
                }
            };
        }
        let lines: String = offers
            .pairs
            .iter()
            .take(SHOWN)
            .enumerate()
            .map(|(index, pair)| {
                let word = if index == 0 { "together:" } else { "or" };
                format!("\nhelp: {word} {}", self.together(pair))
            })
            .collect();
        format!("\nnote: no single change mends it{lines}")
    }

    /// Two changes, the second after the first.
    fn together(&self, [first, second]: &[Repair; 2]) -> String {
        let phrase = |repair: &Repair| self.phrases(std::slice::from_ref(repair)).concat();
        let (first, second) = (phrase(first), phrase(second));
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
            "and start it elsewhere: at 0 the mechanism then does not close"
        } else {
            "and start it elsewhere: as it starts now it then does not close"
        }
    }

    /// All these changes, those of a kind together.
    fn phrases(&self, repairs: &[Repair]) -> Vec<String> {
        let mut phrases = Vec::new();
        let mut push = |before: &str, names: &[String], after: &str| {
            if !names.is_empty() {
                phrases.push(format!("{before}{}{after}", one_of(names)));
            }
        };
        for repair in repairs {
            match repair {
                Repair::AllowRedundant => push("add ", &["`allow redundant;`".to_owned()], ""),
                Repair::AllowCoupled => push(
                    "add ",
                    &["`allow coupled;`".to_owned()],
                    " to solve these loops together",
                ),
                _ => {}
            }
        }
        let moved = |repair: &Repair| match repair {
            Repair::MoveMotor { motor, .. } => Some(*motor),
            _ => None,
        };
        let mut motors: Vec<MotorId> = repairs.iter().filter_map(moved).collect();
        motors.dedup();
        for motor in motors {
            let to = self.those(repairs, |repair| match repair {
                Repair::MoveMotor { motor: other, to } if *other == motor => Some(self.joint(*to)),
                _ => None,
            });
            let from = self.joint(self.model.motor(motor).joint);
            push(&format!("move the motor from {from} to "), &to, "");
        }
        let removed = self.those(repairs, |repair| match repair {
            Repair::RemoveMotor(motor) => Some(self.motor_line(*motor)),
            Repair::RemoveLink(link) => Some(format!("`link {}`", self.model.link(*link).name)),
            Repair::RemoveJoint(joint) => {
                Some(format!("`joint {}`", self.model.joint(*joint).name))
            }
            _ => None,
        });
        push("remove ", &removed, "");
        let slots = self.those(repairs, |repair| match repair {
            Repair::MakeSlot { joint, .. } => {
                Some(format!("`joint {}`", self.model.joint(*joint).name))
            }
            _ => None,
        });
        push("replace ", &slots, " by `slot(...)`");
        let welds = self.those(repairs, |repair| match repair {
            Repair::Unweld(joint) => Some(format!("`joint {}`", self.model.joint(*joint).name)),
            _ => None,
        });
        push("replace ", &welds, " by `revolute(...)`");
        for phrase in self.added_motors(repairs) {
            push("", &[phrase], "");
        }
        for repair in repairs {
            match repair {
                Repair::StartAt { motor, value } => push("", &[self.start_at(*motor, *value)], ""),
                Repair::Carry { joint, on: None } => {
                    push(
                        "leave out `on LINK`: what carries ",
                        &[self.joint(*joint)],
                        " is found",
                    );
                }
                _ => {}
            }
        }
        let carriers = self.those(repairs, |repair| match repair {
            Repair::Carry { on: Some(link), .. } => {
                Some(format!("`on {}`", self.model.link(*link).name))
            }
            _ => None,
        });
        push("write ", &carriers, "");
        phrases
    }

    #[expect(
        clippy::unused_self,
        reason = "reads as a question about the repairs of this mechanism"
    )]
    fn those(&self, repairs: &[Repair], name: impl Fn(&Repair) -> Option<String>) -> Vec<String> {
        repairs.iter().filter_map(name).collect()
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

    /// Motors on one joint each, or on several at once.
    fn added_motors(&self, repairs: &[Repair]) -> Vec<String> {
        let line = |joint: JointId| format!("`motor {};`", self.model.joint(joint).name);
        let mut alone = Vec::new();
        let mut phrases = Vec::new();
        for repair in repairs {
            match repair {
                Repair::AddMotors(joints) if joints.len() == 1 => alone.extend(joints),
                Repair::AddMotors(joints) => {
                    let lines: Vec<String> = joints.iter().map(|&joint| line(joint)).collect();
                    phrases.push(format!("add {}", lines.join(" and ")));
                }
                _ => {}
            }
        }
        let sits: Vec<String> = alone.iter().map(|&&joint| self.joint(joint)).collect();
        match (&alone[..], &sits[..]) {
            ([only], _) => phrases.push(format!("add {}", line(**only))),
            ([first, ..], [_, others @ ..]) => phrases.push(format!(
                "add {}, or a motor on {} instead",
                line(**first),
                one_of(others)
            )),
            _ => {}
        }
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

/// Phrases on as few lines as they fit on.
fn lines(before: &str, phrases: &[String]) -> String {
    let mut text = String::new();
    let mut width = 0;
    for phrase in phrases {
        if width > 0 && width + phrase.len() <= WIDTH {
            text += &format!(", or {phrase}");
            width += phrase.len() + 5;
        } else {
            let or = if text.is_empty() { before } else { "help: or " };
            text += &format!("\n{or}{phrase}");
            width = phrase.len();
        }
    }
    text
}
