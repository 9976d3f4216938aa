//! Puts diagnoses into words and at their places.

use crate::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model, Origin, Precision};
use crate::structure::Diagnosis;
use crate::syntax::{Message, Places};

/// A diagnosis as the user reads it. Lines after the first begin with `note:` or `help:`.
#[must_use]
pub fn message(diagnosis: &Diagnosis, model: &Model, places: &Places) -> Message {
    let words = Words { model };
    let (origin, text) = words.of(diagnosis);
    Message::new(places.get(origin), text)
}

/// A diagnosis in words, without its place: for the studio, and for tests.
#[must_use]
pub fn text(diagnosis: &Diagnosis, model: &Model) -> String {
    Words { model }.of(diagnosis).1
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
                    "nothing holds link {0}: no joint joins it to anything\nhelp: declare a joint, as \
                     `joint NAME = revolute({1}.AXIS, ground.AXIS);`, or remove the link",
                    self.link(*link),
                    self.model.link(*link).name
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
            Diagnosis::NoCarrier { gear } => {
                (self.model.joint(*gear).origin, self.no_carrier(*gear))
            }
            Diagnosis::SeveralCarriers { gear, carriers } => (
                self.model.joint(*gear).origin,
                format!(
                    "gear {} could be carried by each of {}: both of its wheels turn on each\nnote: saying which one is \
                     meant (`on LINK` after the ratio) is not supported yet",
                    self.joint(*gear),
                    self.links(carriers)
                ),
            ),
            Diagnosis::Blocked { .. }
            | Diagnosis::TooManyMotors { .. }
            | Diagnosis::Rigid { .. } => self.held(diagnosis),
            Diagnosis::Overdetermined { joints, cures } => (
                self.model.joint(joints[0]).origin,
                format!(
                    "joints {} hold each other more than once: they fit together only if all lengths match exactly{}",
                    self.joints(joints),
                    self.cures(cures)
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
            Diagnosis::NotSequential { waiting } => (
                self.model.joint(waiting[0]).origin,
                format!(
                    "the mechanism is not sequential: joints {} wait for each other, and no loop among them has only three \
                     unknowns\nhelp: put the motor on another joint, so that a loop with three unknowns contains it\n\
                     note: solving such joints together (`allow coupled;`) is not supported yet",
                    self.joints(waiting)
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
                cures,
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
                    self.cures(cures)
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
                    "motor {} is one too many: what moves there is already given by {}\nhelp: remove one of the motors {}",
                    self.joint(joint(motor)),
                    self.motors(&others),
                    self.joints(&all)
                );
                (self.model.motor(*motor).origin, text)
            }
            Diagnosis::Rigid { cures } => {
                let text = format!(
                    "nothing can move: the joints hold all links rigidly to `ground` (mobility 0){}",
                    self.cures(cures)
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
        match candidates {
            [] => String::new(),
            [only] => format!("\nhelp: add `motor {};`", self.model.joint(*only).name),
            [first, ..] if freedom == 1 => {
                format!(
                    "\nhelp: add `motor {};`, or a motor on any one of {}",
                    self.model.joint(*first).name,
                    self.joints(candidates)
                )
            }
            all => {
                let lines: Vec<String> = all
                    .iter()
                    .map(|joint| format!("`motor {};`", self.model.joint(*joint).name))
                    .collect();
                format!("\nhelp: add {}", and(&lines))
            }
        }
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
                    "the mechanism cannot close at its start: {} and {} stay {} apart\nnote: joints {} can be turned or slid \
                     freely, and this is as near as they bring them\nhelp: change a length, or start the motors elsewhere",
                    self.axis(axes.0),
                    self.axis(axes.1),
                    brief(*gap),
                    self.joints(unknowns)
                ),
            ),
            Diagnosis::DeadStart { unknowns } => (
                self.model.joint(unknowns[1]).origin,
                format!(
                    "the mechanism starts at a dead point: which way joints {} go from there is not determined\nhelp: start \
                     the motors elsewhere, as `start {{ {} }}`",
                    self.joints(unknowns),
                    self.some_start()
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
                    "link {} cannot stay where it is drawn: the links whose axes are given in their own frames would push \
                     it elsewhere\nhelp: move the axes to where the joints are in the drawing",
                    self.link(*link)
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
        let clause = |angles: &Vec<f64>| {
            let parts = links.iter().zip(angles).map(|(link, angle)| {
                format!(
                    "{} near {} deg;",
                    self.model.link(*link).name,
                    brief(angle.to_degrees())
                )
            });
            format!(
                "\nhelp: `start {{ {} }}`",
                parts.collect::<Vec<_>>().join(" ")
            )
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

    /// A start clause for the first motor.
    fn some_start(&self) -> String {
        self.model.motors.first().map_or_else(String::new, |motor| {
            let name = &self.model.joint(motor.joint).name;
            match self.model.joint(motor.joint).kind {
                JointKind::Prismatic(..) => format!("{name} = 0.1;"),
                _ => format!("{name} = 10 deg;"),
            }
        })
    }

    fn cures(&self, cures: &[JointId]) -> String {
        match cures {
            [] => "\nnote: removing a single joint does not mend it".to_owned(),
            [one] => format!("\nhelp: remove `joint {}`", self.model.joint(*one).name),
            several => format!("\nhelp: remove one of the joints {}", self.joints(several)),
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

fn and(names: &[String]) -> String {
    names.join(", ")
}

/// A number with as many digits as a reader wants.
fn brief(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    if rounded == 0.0 && value != 0.0 {
        format!("{value:.1e}")
    } else {
        format!("{rounded}")
    }
}
