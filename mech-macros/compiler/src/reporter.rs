//! Puts diagnoses into words and at their places.

mod trial;
mod wording;

use crate::model::{
    AxisId, AxisKind, JointId, JointKind, LinkId, Model, Motor, Origin, Precision, Start,
    StartValue,
};
use crate::structure::Diagnosis;
use crate::syntax::{Message, Places};
use trial::{Trial, sorted, trial};
use wording::{and, brief, or, places_enough, rounded};

/// A diagnosis as the user reads it. Lines after the first begin with `note:` or `help:`.
#[must_use]
pub fn message(diagnosis: &Diagnosis, model: &Model, places: &Places) -> Message {
    let words = Words { model };
    let (origin, text) = words.of(diagnosis);
    Message::new(places.get(origin), spaced(&text))
}

/// A diagnosis in words, without its place: for the studio, and for tests.
#[must_use]
pub fn text(diagnosis: &Diagnosis, model: &Model) -> String {
    spaced(&Words { model }.of(diagnosis).1)
}

/// Sets the notes off from the sentence.
fn spaced(text: &str) -> String {
    text.replacen('\n', "\n\n", 1)
}

struct Words<'m> {
    model: &'m Model,
}

impl Words<'_> {
    fn of(&self, diagnosis: &Diagnosis) -> (Origin, String) {
        match diagnosis {
            Diagnosis::Loose { link } => (
                self.model.link(*link).origin,
                format!(
                    "nothing holds link {}: no joint joins it to anything\nhelp: declare a joint, as `joint NAME = {};`, \
                     or remove the link",
                    self.link(*link),
                    self.some_joint(*link)
                ),
            ),
            Diagnosis::Disconnected { links } => (
                self.model.link(links[0]).origin,
                format!(
                    "{} {} not connected to the ground\nhelp: declare a joint between one of them and the ground or a link \
                     that is connected to it",
                    self.links(links),
                    if links.len() == 1 { "is" } else { "are" }
                ),
            ),
            Diagnosis::NotCarrier { joint, link } => (
                self.model.joint(*joint).origin,
                format!(
                    "link {} does not carry {}: both parts that roll must keep their place in it",
                    self.link(*link),
                    self.joint(*joint)
                ),
            ),
            Diagnosis::NoCarrier { joint: gear } => {
                (self.model.joint(*gear).origin, self.no_carrier(*gear))
            }
            Diagnosis::SeveralCarriers {
                joint: gear,
                carriers,
            } => (
                self.model.joint(*gear).origin,
                format!(
                    "several links could carry gear {}: both of its wheels turn on {}\nhelp: leave out the joints of its \
                     wheels with all of these but one\nnote: saying which is meant (`on LINK` after the ratio) is not \
                     supported yet",
                    self.joint(*gear),
                    carriers
                        .iter()
                        .map(|&link| self.link(link))
                        .collect::<Vec<_>>()
                        .join(" and on ")
                ),
            ),
            Diagnosis::Blocked { .. } | Diagnosis::TooManyMotors { .. } | Diagnosis::Rigid => {
                self.held(diagnosis)
            }
            Diagnosis::Overdetermined { joints, .. } => (
                self.model.joint(joints[0]).origin,
                format!(
                    "joints {} hold the same parts more than once: they fit together only if all lengths match exactly{}",
                    self.joints(joints),
                    self.bolted(joints).unwrap_or_else(|| self.cures(&[]))
                ),
            ),
            Diagnosis::TooLarge => (
                self.model.origin,
                format!(
                    "a length or a position of this mechanism is beyond the range of `{}`",
                    match self.model.precision {
                        Precision::F32 => "f32",
                        Precision::F64 => "f64",
                    }
                ),
            ),
            Diagnosis::NoMotor { .. } | Diagnosis::Undetermined { .. } => self.free(diagnosis),
            Diagnosis::NotSequential { waiting, .. } => (
                self.model.joint(waiting[0]).origin,
                format!(
                    "the mechanism is not sequential: joints {} wait for each other, and no loop among them has only three \
                     unknowns{}\nnote: solving such joints together (`allow coupled;`) is not supported yet",
                    self.joints(waiting),
                    self.motor_elsewhere()
                ),
            ),
            Diagnosis::CannotClose { .. }
            | Diagnosis::DeadStart { .. }
            | Diagnosis::SeveralAssemblies { .. }
            | Diagnosis::NotAsDrawn { .. }
            | Diagnosis::StartNotFree { .. } => self.assembly(diagnosis),
        }
    }

    fn no_carrier(&self, gear: JointId) -> String {
        let (a, b) = self.model.ends(gear);
        format!(
            "nothing carries gear {}: no link has a revolute joint with both {} and {}\nhelp: let both wheels turn on the \
             ground or on one common link",
            self.joint(gear),
            self.link(a),
            self.link(b)
        )
    }

    /// There is less freedom than there are motors.
    fn held(&self, diagnosis: &Diagnosis) -> (Origin, String) {
        match diagnosis {
            Diagnosis::Blocked {
                motor,
                part,
                joints,
            } => {
                let motor = self.model.motor(*motor);
                let links: Vec<LinkId> = part
                    .iter()
                    .copied()
                    .filter(|link| *link != LinkId::GROUND)
                    .collect();
                let rigid = if links.len() == part.len() {
                    "each other"
                } else {
                    "`ground`"
                };
                let text = format!(
                    "motor {} is blocked: {} {} a part that cannot move (mobility 0)\nnote: joints {} hold {} rigidly to \
                     {rigid}{}",
                    self.joint(motor.joint),
                    self.links(&links),
                    if links.len() == 1 { "is" } else { "form" },
                    self.joints(joints),
                    if links.len() == 1 { "it" } else { "them" },
                    self.cures(&[])
                );
                (motor.origin, text)
            }
            Diagnosis::TooManyMotors { motor, among } => {
                let joint = |id: &crate::model::MotorId| self.model.motor(*id).joint;
                let all: Vec<JointId> = among.iter().map(joint).collect();
                let others: Vec<JointId> = all
                    .iter()
                    .copied()
                    .filter(|id| *id != joint(motor))
                    .collect();
                let text = format!(
                    "motor {} is one too many: what moves there is already given by {}\nhelp: remove {}",
                    self.joint(joint(motor)),
                    self.motors(&others),
                    or(&self.motor_lines(&all))
                );
                (self.model.motor(*motor).origin, text)
            }
            Diagnosis::Rigid => {
                let text = format!(
                    "nothing can move: the joints hold all links rigidly to `ground` (mobility 0){}",
                    self.cures(&[])
                );
                (self.model.origin, text)
            }
            _ => (self.model.origin, String::new()),
        }
    }

    /// There is more freedom than there are motors.
    fn free(&self, diagnosis: &Diagnosis) -> (Origin, String) {
        match diagnosis {
            Diagnosis::NoMotor {
                freedom,
                candidates,
            } => {
                let needs = if *freedom == 1 {
                    "one motor".to_owned()
                } else {
                    format!("{freedom} motors")
                };
                let text = format!(
                    "there is no motor: the mechanism needs {needs}{}",
                    self.motor_help(*freedom, candidates)
                );
                (self.model.origin, text)
            }
            Diagnosis::Undetermined {
                freedom,
                free,
                candidates,
            } => {
                let joints = if free.len() == 1 {
                    format!("joint {} stays free", self.joints(free))
                } else {
                    format!("joints {} stay free", self.joints(free))
                };
                let missing = if *freedom == 1 {
                    "one motor is".to_owned()
                } else {
                    format!("{freedom} motors are")
                };
                let text = format!(
                    "{joints} when all motors are held: {missing} missing{}",
                    self.motor_help(*freedom, candidates)
                );
                let origin = free
                    .first()
                    .map_or(self.model.origin, |joint| self.model.joint(*joint).origin);
                (origin, text)
            }
            _ => (self.model.origin, String::new()),
        }
    }

    fn motor_help(&self, freedom: usize, candidates: &[JointId]) -> String {
        if freedom > 1 {
            let lines = self.motor_lines(candidates);
            return if lines.is_empty() {
                String::new()
            } else {
                format!("\nhelp: add {}", lines.join(" and "))
            };
        }
        let added = |joint: JointId| {
            let mut model = self.model.clone();
            let origin = model.joint(joint).origin;
            model.motors.push(Motor { joint, origin });
            model
        };
        let (at_once, elsewhere) = sorted(candidates.iter().map(|&joint| (joint, added(joint))));
        let sits = |joint: &JointId| self.joint(*joint);
        let line = match at_once.split_first() {
            Some((first, [])) => format!("\nhelp: add `motor {};`", self.model.joint(*first).name),
            Some((first, others)) => format!(
                "\nhelp: add `motor {};`, or a motor on {} instead",
                self.model.joint(*first).name,
                or(&others.iter().map(sits).collect::<Vec<_>>())
            ),
            None => String::new(),
        };
        if elsewhere.is_empty() {
            return line;
        }
        format!(
            "{line}\nhelp: {} a motor on {}, with its coordinate in `start`: at 0 the mechanism does not close",
            if line.is_empty() { "add" } else { "or add" },
            or(&elsewhere.iter().map(sits).collect::<Vec<_>>())
        )
    }

    /// On which other joint a motor would do.
    fn motor_elsewhere(&self) -> String {
        for motor in self.model.motor_ids() {
            let from = self.model.motor(motor).joint;
            let moved = |joint: JointId| {
                let mut model = self.model.clone();
                model.motors[motor.index()].joint = joint;
                model.start.values.retain(|value| value.joint != from);
                model
            };
            let free = |joint: &JointId| self.model.motor_of(*joint).is_none();
            let (at_once, elsewhere) = sorted(
                self.model
                    .joint_ids()
                    .filter(free)
                    .map(|joint| (joint, moved(joint))),
            );
            let all = [at_once, elsewhere].concat();
            if !all.is_empty() {
                let all: Vec<String> = all.iter().map(|&joint| self.joint(joint)).collect();
                return format!(
                    "\nhelp: move the motor from {} to {}",
                    self.joint(from),
                    or(&all)
                );
            }
        }
        String::new()
    }

    fn motor_lines(&self, joints: &[JointId]) -> Vec<String> {
        let line = |&joint: &JointId| format!("`motor {};`", self.model.joint(joint).name);
        joints.iter().map(line).collect()
    }

    fn assembly(&self, diagnosis: &Diagnosis) -> (Origin, String) {
        match diagnosis {
            Diagnosis::CannotClose {
                unknowns,
                gap,
                axes,
            } => (
                self.model.joint(unknowns[1]).origin,
                format!(
                    "the mechanism cannot close at its start: {} and {} stay {} apart\nnote: joints {} turn or slide freely, and \
                     this is as near as they bring them\nhelp: change a length, or start the motors elsewhere",
                    self.axis(axes.0),
                    self.axis(axes.1),
                    brief(*gap),
                    self.joints(unknowns)
                ),
            ),
            Diagnosis::DeadStart { unknowns } => (
                self.model.joint(unknowns[1]).origin,
                format!(
                    "the mechanism starts at a dead point: which way joints {} go from there is not determined{}",
                    self.joints(unknowns),
                    self.other_start()
                ),
            ),
            Diagnosis::SeveralAssemblies { links, angles } => {
                let origin = links
                    .first()
                    .map_or(self.model.origin, |link| self.model.link(*link).origin);
                (origin, self.several(links, angles))
            }
            Diagnosis::NotAsDrawn { link } => (
                self.model.link(*link).origin,
                format!(
                    "link {} cannot stay where it is drawn{}\nhelp: draw it where those lengths lead, or change them to fit \
                     the drawing",
                    self.link(*link),
                    self.not_drawn()
                ),
            ),
            Diagnosis::StartNotFree { joint } => {
                let value = self
                    .model
                    .start
                    .values
                    .iter()
                    .find(|value| value.joint == *joint);
                let (_, end) = self.model.ends(*joint);
                let text = format!(
                    "joint {} has no motor and no gear drives it: where it starts follows from the others\nhelp: to pick one \
                     of several assemblies, write `{} near ANGLE;`",
                    self.joint(*joint),
                    self.model.link(end).name
                );
                (value.map_or(self.model.origin, |value| value.origin), text)
            }
            _ => (self.model.origin, String::new()),
        }
    }

    fn several(&self, links: &[LinkId], angles: &[Vec<f64>]) -> String {
        let places = places_enough(links.len(), angles);
        let (before, after) = if self.model.start == Start::default() {
            ("`start { ", " }`")
        } else {
            ("`", "` to `start`")
        };
        let clause = |angles: &Vec<f64>| {
            let parts = links.iter().zip(angles).map(|(link, angle)| {
                let angle = rounded(angle.to_degrees(), places);
                format!("{} near {angle} deg;", self.model.link(*link).name)
            });
            let parts = parts.collect::<Vec<_>>().join(" ");
            format!("\nhelp: add {before}{parts}{after}")
        };
        let shown: String = angles.iter().take(8).map(clause).collect();
        let more = if angles.len() > 8 {
            "\nnote: there are more"
        } else {
            ""
        };
        let count = if angles.len() > 64 {
            "more than 64".to_owned()
        } else {
            angles.len().to_string()
        };
        format!(
            "the mechanism can be assembled in {count} ways; `near` says which one is meant{shown}{more}"
        )
    }

    /// How else to start than at a dead point: one motor a little further or less far, if that was found to do.
    fn other_start(&self) -> String {
        for motor in &self.model.motors {
            let joint = self.model.joint(motor.joint);
            let given = self.model.start.values.iter();
            let value = given
                .clone()
                .find(|value| value.joint == motor.joint)
                .map_or(0.0, |value| value.value);
            for share in [0.1, -0.1] {
                let (value, text) = if let JointKind::Prismatic(..) = joint.kind {
                    let value = value + share * if value == 0.0 { 1.0 } else { value.abs() };
                    (value, brief(value))
                } else {
                    let degrees = value.to_degrees() + 100.0 * share;
                    (degrees.to_radians(), format!("{} deg", brief(degrees)))
                };
                let mut model = self.model.clone();
                model.links.iter_mut().for_each(|link| link.drawn = false);
                model
                    .start
                    .values
                    .retain(|value| value.joint != motor.joint);
                model.start.values.push(StartValue {
                    joint: motor.joint,
                    value,
                    origin: motor.origin,
                });
                if trial(&model) != Trial::Closes {
                    continue;
                }
                return if self.is_drawn(motor.joint) {
                    format!(
                        "\nhelp: draw it as it is when {} is at {text}",
                        self.joint(motor.joint)
                    )
                } else {
                    format!(
                        "\nhelp: start elsewhere, as `start {{ {} = {text}; }}`",
                        joint.name
                    )
                };
            }
        }
        "\nhelp: start the motors elsewhere".to_owned()
    }

    fn is_drawn(&self, joint: JointId) -> bool {
        match self.model.joint(joint).kind {
            JointKind::Revolute(axis, _) | JointKind::Prismatic(axis, _) => {
                self.model.axis(axis).name.is_none()
            }
            _ => false,
        }
    }

    /// The links that are not in the drawing, as the reason why one that is cannot stay.
    fn not_drawn(&self) -> String {
        let links: Vec<LinkId> = self
            .model
            .declared_links()
            .filter(|&link| !self.model.link(link).drawn)
            .collect();
        match links[..] {
            [] => String::new(),
            [_] => format!(
                ": {}, which has lengths of its own, does not fit",
                self.links(&links)
            ),
            _ => format!(
                ": {}, which have lengths of their own, do not fit",
                self.links(&links)
            ),
        }
    }

    /// A joint that would hold this link, in the words of the language.
    fn some_joint(&self, link: LinkId) -> String {
        let named = |owner: LinkId| {
            let mut axes = self.model.axes.iter();
            axes.find(|axis| {
                axis.link == owner && axis.kind == AxisKind::Point && axis.name.is_some()
            })
            .and_then(|axis| axis.name.as_ref())
            .map(|name| format!("{}.{name}", self.model.link(owner).name))
        };
        let mut others = self.model.link_ids().filter(|&other| other != link);
        match (named(link), others.find_map(named)) {
            (Some(point), Some(other)) => format!("revolute({other}, {point})"),
            _ => format!("revolute(ground, {}) at (X, Y)", self.model.link(link).name),
        }
    }

    /// If joints that hold each other are all between the same two links: that these should be one.
    fn bolted(&self, joints: &[JointId]) -> Option<String> {
        let pair = |joint: JointId| {
            let (a, b) = self.model.ends(joint);
            (a.min(b), a.max(b))
        };
        let (a, b) = pair(*joints.first()?);
        joints.iter().all(|&joint| pair(joint) == (a, b)).then(|| {
            format!(
                "\nnote: they hold {} still on {}\nhelp: make one link of the two",
                self.link(b),
                self.link(a)
            )
        })
    }

    fn cures(&self, cures: &[JointId]) -> String {
        match cures {
            [] => "\nnote: removing a single joint does not mend it".to_owned(),
            [one] => format!("\nhelp: remove `joint {}`", self.model.joint(*one).name),
            several => {
                let lines: Vec<String> = several
                    .iter()
                    .map(|&joint| format!("`joint {}`", self.model.joint(joint).name))
                    .collect();
                format!("\nhelp: remove {}", or(&lines))
            }
        }
    }

    fn axis(&self, id: AxisId) -> String {
        let axis = self.model.axis(id);
        let link = &self.model.link(axis.link).name;
        match (&axis.name, axis.kind) {
            (Some(name), _) => format!("`{link}.{name}`"),
            (None, AxisKind::Point) => format!(
                "the point ({}, {}) of `{link}`",
                brief(axis.at[0]),
                brief(axis.at[1])
            ),
            (None, AxisKind::Line) => format!(
                "the line through ({}, {}) of `{link}`",
                brief(axis.at[0]),
                brief(axis.at[1])
            ),
        }
    }

    fn link(&self, id: LinkId) -> String {
        format!("`{}`", self.model.link(id).name)
    }

    fn joint(&self, id: JointId) -> String {
        format!("`{}`", self.model.joint(id).name)
    }

    fn links(&self, ids: &[LinkId]) -> String {
        let names: Vec<String> = ids.iter().map(|&id| self.link(id)).collect();
        format!(
            "{} {}",
            if ids.len() == 1 { "link" } else { "links" },
            and(&names)
        )
    }

    fn joints(&self, ids: &[JointId]) -> String {
        and(&ids.iter().map(|&id| self.joint(id)).collect::<Vec<_>>())
    }

    fn motors(&self, ids: &[JointId]) -> String {
        format!(
            "{} {}",
            if ids.len() == 1 { "motor" } else { "motors" },
            self.joints(ids)
        )
    }
}
