//! The names and numbers of a text with their places, for programs that change texts.

mod query;
mod requirement;
mod shape;

use super::ast::{
    AxisValue, BetweenEnds, Clause, Color, Constant, Direction, Effect, Elastic, End, Expr,
    ExprKind, Ground, Index, Item, Joint, JointWord, Link, LoadOn, Matter, MatterKind, Motor, Name,
    Pair, Part, Port, Shape, Size, Start, Statement, Text, Trace, Use,
};
use super::{Place, color};
use crate::model::Inverse;
use proc_macro2::{Ident, Span};
use shape::shape_numbers;

/// The names and numbers of a text, in the order in which they are read. Places are spans, or what a reader of files makes of them.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Listing<P = Place> {
    /// Each name, where it is declared and where it is used.
    pub names: Vec<ListedName<P>>,
    /// Each number, and each pair of numbers.
    pub numbers: Vec<ListedNumber<P>>,
}

/// A name at one place.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ListedName<P = Place> {
    /// The kind of thing that it names.
    pub noun: Noun,
    /// The words that lead to it, itself included, without indices: `left.foot.tip`.
    pub path: String,
    /// The part in whose braces it stands.
    pub part: Option<String>,
    /// Whether it is declared here.
    pub is_declared: bool,
    /// The place of its own word.
    pub place: P,
}

/// The kind of thing that a name stands for, as far as the grammar knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Noun {
    /// A link, a port, or the use of a part.
    Body,
    /// A joint.
    Joint,
    /// A link, a use or a joint.
    BodyOrJoint,
    /// A point or a line; in a path with a use also a link.
    Axis,
    /// A constant, a param, or a number of a part.
    Number,
    /// A spring, a damper or a load.
    Action,
    /// A part.
    Part,
}

/// A number, or a pair of them, at its place.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ListedNumber<P = Place> {
    /// Its owner: `crank.pin`, or the word of a statement without a name.
    pub owner: String,
    /// Its role in the owner: `x`, `shape 2 radius`.
    pub role: String,
    /// The part in whose braces it stands.
    pub part: Option<String>,
    /// From its first token to its last.
    pub place: P,
    /// Whether it is a pair.
    pub is_pair: bool,
    /// The literals in it.
    pub literals: Vec<P>,
}

impl Listing {
    /// Lists what a text consists of.
    pub(super) fn of(text: &Text) -> Self {
        Self::by_statements(text).0
    }

    /// The same, and how many names there are up to the end of each statement.
    pub(super) fn by_statements(text: &Text) -> (Self, Vec<usize>) {
        let mut reader = Reader { listing: Self::default(), part: None };
        let mut ends = Vec::new();
        for statement in &text.statements {
            reader.statement(statement);
            ends.push(reader.listing.names.len());
        }
        (reader.listing, ends)
    }
}

struct Reader {
    listing: Listing,
    part: Option<String>,
}

impl Reader {
    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Constant(constant) | Statement::Param(constant) => self.constant(constant),
            Statement::Ground(Ground { items, .. }) => {
                self.items("ground", items.iter().flatten());
            }
            Statement::Link(Link { name, items }) | Statement::Port(Port { name, items }) => {
                self.declare(Noun::Body, name);
                self.items(&name.to_string(), items.iter().flatten());
            }
            Statement::Joint(joint) => self.joint(joint),
            Statement::Motor(motor) => self.motor(motor),
            Statement::Start(start) => self.start(start),
            Statement::Method(method) => {
                let steps = method.steps.iter().filter_map(|(steps, _)| steps.as_ref());
                steps.for_each(|steps| self.number("method", "steps", steps));
                let predictor = method.predictor.iter();
                predictor.for_each(|(_, order)| self.number("method", "predictor", order));
            }
            Statement::Accuracy { value, .. } => self.number("accuracy", "value", value),
            Statement::Gravity { value, .. } => self.pair("gravity", "value", "", value),
            Statement::Effects { effects, .. } => {
                for effect in effects.iter().flatten() {
                    if let Effect::Trace(trace) = effect {
                        self.trace(trace);
                    }
                }
            }
            Statement::Spring(elastic) => self.elastic(elastic, "stiffness"),
            Statement::Damper(elastic) => self.elastic(elastic, "damping"),
            Statement::Load(load) => {
                self.declare(Noun::Action, &load.name);
                match &load.on {
                    Ok(LoadOn::Force(end)) => self.end(end, Noun::Body),
                    Ok(LoadOn::Torque(link)) => self.name(link, Noun::Body),
                    Err(_) => {}
                }
            }
            Statement::Show { what, .. } => {
                for end in what {
                    self.end(end, Noun::BodyOrJoint);
                }
            }
            Statement::Continuous { joints, .. } => {
                for name in joints {
                    self.name(name, Noun::Joint);
                }
            }
            Statement::Follow(follow) => {
                self.end(&follow.what, Noun::Body);
                for (name, [low, high]) in Inverse::GIVEN.iter().zip(&follow.region) {
                    self.number("follow", &format!("{name} from"), low);
                    self.number("follow", &format!("{name} to"), high);
                }
                for name in &follow.motors {
                    self.name(name, Noun::Joint);
                }
            }
            Statement::Path(path) => {
                self.end(&path.what, Noun::Body);
                for (name, law) in Inverse::GIVEN.iter().zip(&path.laws) {
                    self.number("path", name, law);
                }
            }
            Statement::Part(part) => self.part(part),
            Statement::Use(used) => self.used(used),
            Statement::Expect(expect) => self.expect(expect),
            Statement::Cost { .. }
            | Statement::Quality { .. }
            | Statement::Look { .. }
            | Statement::ChangePoints { .. }
            | Statement::Allow(_)
            | Statement::Broken(_) => {}
        }
    }

    fn constant(&mut self, constant: &Constant) {
        self.declare(Noun::Number, &constant.name);
        let value = constant.value.iter();
        value.for_each(|value| self.number(&constant.name.to_string(), "value", value));
    }

    fn items<'a>(&mut self, link: &str, items: impl Iterator<Item = &'a Item>) {
        let mut shapes = 0;
        for item in items {
            match item {
                Item::Axis(axis) => {
                    let path = format!("{link}.{}", axis.name);
                    self.mention(Noun::Axis, path.clone(), true, axis.name.span());
                    let value = axis.value.iter();
                    value.for_each(|value| self.axis(&path, value));
                }
                Item::Shape(shape) => {
                    shapes += 1;
                    self.shape(link, &format!("shape {shapes} "), shape);
                }
                Item::Matter(matter) => self.matter(link, matter),
                Item::Broken(_) => {}
            }
        }
    }

    fn axis(&mut self, path: &str, value: &AxisValue) {
        self.pair(path, "at", "", &value.at);
        let direction = value.direction.iter();
        direction.for_each(|direction| self.direction(path, "direction", "d", direction));
        let turned = value.turned.iter();
        turned.for_each(|angle| self.number(path, "turned", angle));
    }

    fn direction(&mut self, owner: &str, role: &str, prefix: &str, direction: &Direction) {
        match direction {
            Direction::Parts(pair) => self.pair(owner, role, prefix, pair),
            Direction::Angle(angle) => self.number(owner, role, angle),
        }
    }

    fn shape(&mut self, link: &str, prefix: &str, shape: &Shape) {
        let role = |word: &str| format!("{prefix}{word}");
        let (points, lengths) = shape_numbers(&shape.outline);
        let is_single = points.len() == 1;
        for (number, point) in (1..).zip(points) {
            let corner =
                if is_single { prefix.to_owned() } else { format!("{prefix}corner {number} ") };
            self.pair(link, &format!("{corner}at"), &corner, point);
        }
        for (word, length) in lengths {
            self.number(link, &role(word), length);
        }
        let plane = shape.plane.iter();
        plane.for_each(|plane| self.number(link, &role("plane"), plane));
        let color = shape.color.iter();
        color.for_each(|color| self.color(link, &role("color"), color));
    }

    fn color(&mut self, owner: &str, role: &str, color: &Color) {
        let place = match color.shade {
            Some((_, shade)) => color.value.place.to(Place::at(shade)),
            None => color.value.place,
        };
        // A color that has a name is no constant.
        if let ExprKind::Constant(name) = &color.value.kind
            && !color::is_name(&name.to_string())
        {
            self.leaves(&color.value, &mut Vec::new());
        }
        self.quantity(owner, role, place, false, Vec::new());
    }

    fn matter(&mut self, link: &str, matter: &Matter) {
        match &matter.kind {
            MatterKind::Mass { mass, at, inertia } => {
                self.number(link, "mass", mass);
                let at = at.iter();
                at.for_each(|at| self.pair(link, "mass at", "mass ", at));
                let inertia = inertia.iter();
                inertia.for_each(|inertia| self.number(link, "inertia", inertia));
            }
            MatterKind::Density(density) => self.number(link, "density", density),
        }
    }

    fn joint(&mut self, joint: &Joint) {
        self.declare(Noun::Joint, &joint.name);
        let Ok(body) = &joint.body else {
            return;
        };
        let owner = &joint.name.to_string();
        let noun = match body.kind {
            JointWord::Cam => Noun::Joint,
            _ => Noun::Body,
        };
        body.ends.iter().for_each(|end| self.end(end, noun));
        if let Some(rolling) = &body.rolling {
            match &rolling.size {
                Size::Ratio([first, second]) => {
                    self.number(owner, "first", first);
                    self.number(owner, "second", second);
                }
                Size::Radius(radius) => self.number(owner, "radius", radius),
            }
            let carrier = rolling.carrier.iter();
            carrier.for_each(|carrier| self.name(carrier, Noun::Body));
        }
        let law = body.law.iter();
        law.for_each(|law| self.number(owner, "law", law));
        if let Some(roller) = &body.roller {
            self.end(&roller.point, Noun::Body);
            self.number(owner, "roller radius", &roller.radius);
        }
        if let Some(Clause { value, .. }) = &body.at {
            self.pair(owner, "at", "", value);
        }
        if let Some(Clause { value, .. }) = &body.along {
            self.direction(owner, "along", "d", value);
        }
    }

    fn motor(&mut self, motor: &Motor) {
        self.name(&motor.joint, Noun::Joint);
        let owner = &in_words(&motor.joint);
        let law = motor.law.iter();
        law.for_each(|law| self.number(owner, "motor law", law));
        if let Some([low, high]) = &motor.range {
            self.number(owner, "low", low);
            self.number(owner, "high", high);
        }
        let step = motor.step.iter();
        step.for_each(|step| self.number(owner, "step", step));
    }

    fn start(&mut self, start: &Start) {
        for clause in start.clauses.iter().flatten() {
            let (noun, role) =
                if clause.near { (Noun::Body, "near") } else { (Noun::Joint, "start") };
            self.name(&clause.name, noun);
            self.number(&in_words(&clause.name), role, &clause.value);
        }
    }

    fn trace(&mut self, trace: &Trace) {
        self.end(&trace.point, Noun::Body);
        let owner = &trace.point.to_string();
        self.number(owner, "trace length", &trace.length);
        let plane = trace.plane.iter();
        plane.for_each(|plane| self.number(owner, "trace plane", plane));
        let color = trace.color.iter();
        color.for_each(|color| self.color(owner, "trace color", color));
    }

    fn elastic(&mut self, elastic: &Elastic, strength: &str) {
        self.declare(Noun::Action, &elastic.name);
        let Ok(body) = &elastic.body else {
            return;
        };
        match &body.between {
            BetweenEnds::Points(ends) => ends.iter().for_each(|end| self.end(end, Noun::Body)),
            BetweenEnds::Joint(joint) => self.name(joint, Noun::Joint),
        }
        let owner = &elastic.name.to_string();
        self.number(owner, strength, &body.strength);
        let rest = body.rest.iter();
        rest.for_each(|rest| self.number(owner, "rest", rest));
    }

    fn part(&mut self, part: &Part) {
        self.declare(Noun::Part, &part.name);
        let outer = self.part.replace(part.name.to_string());
        part.parameters.iter().for_each(|number| self.constant(number));
        for statement in part.body.iter().flatten() {
            self.statement(statement);
        }
        self.part = outer;
    }

    fn used(&mut self, used: &Use) {
        self.declare(Noun::Body, &used.name);
        let owner = &used.name.to_string();
        if let Some((count, _)) = &used.count {
            self.number(owner, "count", count);
        }
        self.mention(Noun::Part, used.part.to_string(), false, used.part.span());
        // The names of numbers and ports are those of the part.
        let outer = self.part.clone();
        for argument in &used.arguments {
            self.part = Some(used.part.to_string());
            self.mention(Noun::Number, argument.name.to_string(), false, argument.name.span());
            self.part.clone_from(&outer);
            let value = argument.value.iter();
            value.for_each(|value| self.number(owner, &argument.name.to_string(), value));
        }
        let scaled = used.scaled.iter();
        scaled.for_each(|factor| self.number(owner, "scaled", factor));
        for binding in &used.ports {
            self.part = Some(used.part.to_string());
            self.mention(Noun::Body, binding.port.to_string(), false, binding.port.span());
            self.part.clone_from(&outer);
            self.name(&binding.link, Noun::Body);
            let at = binding.at.iter();
            at.for_each(|at| {
                self.pair(
                    owner,
                    &format!("{} at", binding.port),
                    &format!("{} ", binding.port),
                    at,
                );
            });
            let turned = binding.turned.iter();
            turned.for_each(|angle| self.number(owner, &format!("{} turned", binding.port), angle));
        }
    }

    /// A link with what is fixed to it, or a joint.
    fn end(&mut self, end: &End, noun: Noun) {
        self.name(&end.link, noun);
        if let Some(axis) = &end.axis {
            let path = format!("{}.{axis}", in_words(&end.link));
            self.mention(Noun::Axis, path, false, axis.span());
        }
    }

    /// A path through uses, and its last word.
    fn name(&mut self, name: &Name, noun: Noun) {
        let mut path = String::new();
        for segment in &name.uses {
            path += &segment.name.to_string();
            self.mention(Noun::Body, path.clone(), false, segment.name.span());
            if let Some(Index::At(index)) = &segment.index {
                self.number(&path, "index", index);
            }
            path += ".";
        }
        path += &name.name.to_string();
        self.mention(noun, path, false, name.span());
    }

    fn pair(&mut self, owner: &str, role: &str, prefix: &str, pair: &Pair) {
        self.quantity(owner, role, pair.place, true, Vec::new());
        self.number(owner, &format!("{prefix}x"), &pair.x);
        self.number(owner, &format!("{prefix}y"), &pair.y);
    }

    fn number(&mut self, owner: &str, role: &str, number: &Expr) {
        let mut literals = Vec::new();
        self.leaves(number, &mut literals);
        self.quantity(owner, role, number.place, false, literals);
    }

    /// The literals of a number, and the names in it.
    fn leaves(&mut self, number: &Expr, literals: &mut Vec<Place>) {
        match &number.kind {
            ExprKind::Integer(_) | ExprKind::Decimal(_) => {
                // A row of signs that cancel belongs to the literal, which is its last token.
                literals.push(Place::at(number.place.end));
            }
            ExprKind::Pi => {}
            ExprKind::Constant(name) => {
                self.mention(Noun::Number, name.to_string(), false, name.span());
            }
            ExprKind::Negative(inner)
            | ExprKind::Degrees(inner)
            | ExprKind::Rpm(inner)
            | ExprKind::Call(_, inner) => self.leaves(inner, literals),
            ExprKind::Sum(parts) | ExprKind::Product(parts) => {
                for (_, part) in parts {
                    self.leaves(part, literals);
                }
            }
            ExprKind::CallBoth(_, parts) => {
                parts.iter().for_each(|part| self.leaves(part, literals));
            }
            ExprKind::Measured(measured) => self.measured(measured, literals),
            ExprKind::Motion(motion) => {
                for number in motion.numbers() {
                    self.leaves(number, literals);
                }
            }
        }
    }

    fn quantity(
        &mut self,
        owner: &str,
        role: &str,
        place: Place,
        is_pair: bool,
        literals: Vec<Place>,
    ) {
        self.listing.numbers.push(ListedNumber {
            owner: owner.to_owned(),
            role: role.to_owned(),
            part: self.part.clone(),
            place,
            is_pair,
            literals,
        });
    }

    fn declare(&mut self, noun: Noun, name: &Ident) {
        self.mention(noun, name.to_string(), true, name.span());
    }

    fn mention(&mut self, noun: Noun, path: String, is_declared: bool, span: Span) {
        self.listing.names.push(ListedName {
            noun,
            path,
            part: self.part.clone(),
            is_declared,
            place: Place::at(span),
        });
    }
}

/// A path without indices.
fn in_words(name: &Name) -> String {
    let uses = name.uses.iter().map(|segment| format!("{}.", segment.name));
    uses.collect::<String>() + &name.name.to_string()
}
