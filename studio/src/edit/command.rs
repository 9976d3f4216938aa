//! The commands on a mechanism: data between the words of a user and the replacements in the text.

/// A number as it is to be written: `1.2`, `30 deg`, `2 * THROW`.
pub type Expression = String;

/// A place as it is to be written.
pub type Pair = [Expression; 2];

/// A command on a mechanism.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum Command {
    /// Declares a mechanism, in a text that has none.
    Mechanism {
        /// The name of its type.
        name: String,
    },
    /// Declares a number.
    Constant {
        /// Its name.
        name: String,
        /// Its value.
        value: Expression,
        /// Whether it can be changed while the mechanism runs.
        is_param: bool,
    },
    /// Declares a link.
    Link {
        /// Its name.
        name: String,
    },
    /// Fixes a point or a line to a link, or to the ground.
    Axis {
        /// The link and the name: `crank.pin`.
        path: String,
        /// Where it is, in the frame of the link.
        at: Pair,
        /// Its direction: an angle, or two parts in brackets. What has one is a line.
        along: Option<Expression>,
    },
    /// Fixes a shape to a link: `circle (0, 0) radius 0.2 color teal`.
    Shape {
        /// The link.
        link: String,
        /// The shape.
        shape: String,
    },
    /// Gives a link a mass, in place of the one that it has.
    Mass {
        /// The link.
        link: String,
        /// Its mass.
        mass: Expression,
        /// The centre of mass.
        at: Option<Pair>,
        /// The moment of inertia about it.
        inertia: Option<Expression>,
    },
    /// Assembles two links by a joint.
    Join(Assembly),
    /// Puts a motor on a joint, or says more of the one that is there.
    Motor {
        /// The joint.
        joint: String,
        /// Its value as a law of time.
        law: Option<Expression>,
        /// Between which values it moves.
        range: Option<[Expression; 2]>,
        /// By how much it moves at most from position to position.
        step: Option<Expression>,
    },
    /// Says where a joint starts, or near which angle a link does.
    Start {
        /// The joint or the link.
        name: String,
        /// Whether it is a link.
        is_near: bool,
        /// Its coordinate or angle.
        value: Expression,
    },
    /// Declares a spring, a damper or a load: `coil = linear(a.p, b.q) stiffness 4530`.
    Action {
        /// Which of these.
        kind: ActionKind,
        /// Its name.
        name: String,
        /// The text after its name and `=`.
        body: String,
    },
    /// Uses a part: `left[6]: Leg(phase = k * 60 deg) { frame = ground }`.
    Use {
        /// The text between `use` and the semicolon.
        body: String,
    },
    /// Records the path of a point.
    Trace {
        /// The point.
        point: String,
        /// The number of places that it keeps.
        length: Expression,
    },
    /// Says something of the whole mechanism, in place of what was said: `gravity (0, -9.81)`, `look diagram`.
    Setting {
        /// The statement, without its end.
        statement: String,
    },
    /// Moves a point, the origin of a line, or a joint that is placed in the drawing.
    Move {
        /// The path of the joint, point or link that moves.
        path: String,
        /// Where to: in the frame of its link; at a pose, in the scene.
        to: [f64; 2],
        /// The motors' values at which it is seen, in degrees or scene units. Motors that are not listed stand as at the start.
        pose: Option<Vec<(String, f64)>>,
    },
    /// Sets a number by its role: `x` of `crank.pin`, `shape 2 radius` of `crank`.
    Set {
        /// The owner of the number.
        owner: String,
        /// Its role.
        role: String,
        /// The number.
        value: Expression,
    },
    /// Puts a shape of a link on a plane.
    Layer {
        /// The link.
        link: String,
        /// The number of the shape, from 1.
        shape: usize,
        /// The plane.
        plane: Expression,
    },
    /// Gives a shape of a link another colour.
    Recolor {
        /// The link.
        link: String,
        /// The number of the shape, from 1.
        shape: usize,
        /// The colour: `teal light`.
        color: String,
    },
    /// Gives a shape of a link another outline; plane and colour stay.
    Reshape {
        /// The link.
        link: String,
        /// The number of the shape, from 1.
        shape: usize,
        /// The outline: `circle (0, 0) radius 0.2`.
        outline: String,
    },
    /// Gives something another name, wherever it is used.
    Rename {
        /// Its present path: `rod`, `crank.pin`, `Leg.foot`.
        path: String,
        /// Its new name.
        name: String,
    },
    /// Takes something out, with what cannot be without it.
    Remove {
        /// Its kind.
        kind: Kind,
        /// Its name or path.
        name: String,
    },
    /// Takes a shape of a link out.
    RemoveShape {
        /// The link.
        link: String,
        /// The number of the shape, from 1.
        shape: usize,
    },
    /// Mirrors what is fixed to a link about the x axis of its frame; or a use of a part.
    Mirror {
        /// The link or the use.
        name: String,
    },
    /// Declares a link or a use once more, under another name.
    Duplicate {
        /// The link or the use.
        name: String,
        /// The name of the copy.
        copy: String,
    },
    /// Makes a repair, by its number among those that are offered, from 1.
    Repair {
        /// The number.
        number: usize,
    },
}

/// A joint that is to be declared.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Assembly {
    /// Its name.
    pub name: String,
    /// The form of the joint.
    pub kind: JointForm,
    /// The points, lines or links that it joins; a cam joins joints.
    pub ends: [String; 2],
    /// Where it is in the drawing.
    pub at: Option<Pair>,
    /// Its direction in the drawing: an angle, or two parts in brackets.
    pub along: Option<Expression>,
}

/// The kinds of joint, with the numbers that they have.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum JointForm {
    /// Two points coincide.
    Revolute,
    /// Two lines coincide.
    Prismatic,
    /// A point slides on a line.
    Slot,
    /// Two points and their directions coincide.
    Weld,
    /// Two wheels roll on each other.
    Gear {
        /// Their sizes.
        sizes: Pair,
        /// The link that carries both.
        on: Option<String>,
    },
    /// A belt runs over two wheels.
    Belt {
        /// Their sizes.
        sizes: Pair,
        /// The link that carries both.
        on: Option<String>,
    },
    /// A wheel rolls on a toothed bar.
    Rack {
        /// The radius of the wheel.
        radius: Expression,
        /// The link that carries both.
        on: Option<String>,
    },
    /// The coordinate of one joint is a function of that of another.
    Cam {
        /// The function, of `q`.
        law: Expression,
    },
}

/// The kind of an action on links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum ActionKind {
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// A load.
    Load,
}

/// A kind of what can be taken out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum Kind {
    /// A link, with its joints and what acts on it.
    Link,
    /// A joint, with its motor: the links are disassembled.
    Joint,
    /// A motor.
    Motor,
    /// A point or a line.
    Axis,
    /// A constant or a param.
    Constant,
    /// A spring, a damper or a load.
    Action,
    /// A use of a part.
    Use,
    /// The clause on where a joint or a link starts.
    Start,
    /// The mass of a link.
    Mass,
    /// The record of a point's path.
    Trace,
}

impl ActionKind {
    /// The word of its statement.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::Damper => "damper",
            Self::Load => "load",
        }
    }
}

impl JointForm {
    /// Its word in the language.
    pub(super) const fn word(&self) -> &'static str {
        match self {
            Self::Revolute => "revolute",
            Self::Prismatic => "prismatic",
            Self::Slot => "slot",
            Self::Weld => "weld",
            Self::Gear { .. } => "gear",
            Self::Belt { .. } => "belt",
            Self::Rack { .. } => "rack",
            Self::Cam { .. } => "cam",
        }
    }
}

impl Command {
    /// Returns a short description, for the list of steps.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::Mechanism { name } => format!("mechanism {name}"),
            Self::Constant { name, .. } => format!("number {name}"),
            Self::Link { name } => format!("link {name}"),
            Self::Axis { path, along, .. } => {
                let word = if along.is_some() { "line" } else { "point" };
                format!("{word} {path}")
            }
            Self::Shape { link, .. } => format!("shape of {link}"),
            Self::Mass { link, .. } => format!("mass of {link}"),
            Self::Join(assembly) => format!("joint {}", assembly.name),
            Self::Motor { joint, .. } => format!("motor {joint}"),
            Self::Start { name, .. } => format!("start of {name}"),
            Self::Action { kind, name, .. } => format!("{} {name}", kind.word()),
            Self::Use { body } => {
                let name = body.split([':', '[']).next().unwrap_or_default();
                format!("use {}", name.trim())
            }
            Self::Trace { point, .. } => format!("trace of {point}"),
            Self::Setting { statement } => statement.clone(),
            Self::Move { path, .. } => format!("move {path}"),
            Self::Set { owner, role, value } => format!("{role} of {owner} is {value}"),
            Self::Layer { link, shape, .. } => format!("plane of shape {shape} of {link}"),
            Self::Recolor { link, shape, .. } => format!("color of shape {shape} of {link}"),
            Self::Reshape { link, shape, .. } => format!("outline of shape {shape} of {link}"),
            Self::Rename { path, name } => format!("rename {path} to {name}"),
            Self::Remove { kind, name } => format!("remove {} {name}", kind.word()),
            Self::RemoveShape { link, shape } => format!("remove shape {shape} of {link}"),
            Self::Mirror { name } => format!("mirror {name}"),
            Self::Duplicate { name, copy } => format!("duplicate {name} as {copy}"),
            Self::Repair { number } => format!("repair {number}"),
        }
    }
}

impl Kind {
    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Link => "link",
            Self::Joint => "joint",
            Self::Motor => "motor",
            Self::Axis => "axis",
            Self::Constant => "number",
            Self::Action => "action",
            Self::Use => "use",
            Self::Start => "start",
            Self::Mass => "mass",
            Self::Trace => "trace",
        }
    }
}
