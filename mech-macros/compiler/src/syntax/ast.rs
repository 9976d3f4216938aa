//! The text of a mechanism as a tree: everything that was written, with its place, before any name has a meaning.
//!
//! Where a part of a statement could not be read, the [`Message`] that says so stands in its stead: so the rest of
//! the statement (above all its name) is still known, and messages stay in the order of the text.

use super::{Header, Message, Place};
use crate::api::Asked;
use crate::model::{AtChangePoints, Precision};
use proc_macro2::{Ident, Span};

pub(super) use super::expr::{
    End, Expr, ExprKind, Index, MeasuredExpr, MotionExpr, MovingExpr, Name, Pair, ReactionExpr,
    Read, Segment, SegmentExpr, SpotExpr, VectorPart, Way,
};
pub(super) use super::shape::{Color, Outline, Shade, Shape};

/// The body of a `mechanism!`.
#[derive(Default)]
pub(super) struct Text {
    /// The `struct` line, with the type after its colon.
    pub header: Option<(Header, Precision)>,
    /// Everything after it.
    pub statements: Vec<Statement>,
    /// Where each statement begins, attributes included, with its number among them. Some that report mistakes begin nowhere.
    pub beginnings: Vec<(usize, Span)>,
    /// The number of them that begin with `motor`, readable or not.
    pub motors: usize,
    /// Its statements from which methods are made, readable or not.
    pub asked: Asked,
    /// Whether it is beyond a limit, so that only its `struct` line was read.
    pub is_beyond: bool,
}

/// A statement.
pub(super) enum Statement {
    /// `const NAME = value;`
    Constant(Constant),
    /// `param name = value;`
    Param(Constant),
    /// `ground { ... }`
    Ground(Ground),
    /// `link name { ... }` or `link name;`
    Link(Link),
    /// `joint name = ...;`
    Joint(Box<Joint>),
    /// `motor name in low ..= high by step;`
    Motor(Motor),
    /// `start { ... }`
    Start(Start),
    /// `method newton(2);`
    Method(Method),
    /// `accuracy 1e-9;`
    Accuracy { keyword: Span, value: Expr },
    /// `cost x86_64;`
    Cost { keyword: Span, word: Ident },
    /// `quality smooth;`
    Quality { keyword: Span, word: Ident },
    /// `look diagram;`
    Look { keyword: Span, word: Ident },
    /// `at change points stop;`
    ChangePoints { keyword: Span, what: AtChangePoints },
    /// `effects { ... }`
    Effects { keyword: Span, effects: Vec<Read<Effect>> },
    /// `gravity (0, -9.81);`
    Gravity { keyword: Span, value: Pair },
    /// `spring ...;`
    Spring(Box<Elastic>),
    /// `damper ...;`
    Damper(Box<Elastic>),
    /// `load ...;`
    Load(Box<Load>),
    /// `show a, b.c;`
    Show { keyword: Span, what: Vec<End> },
    /// `continuous a, b;`
    Continuous { keyword: Span, joints: Vec<Name> },
    /// `part Leg(size = 1) { ... }`
    Part(Box<Part>),
    /// `port frame { ... }`
    Port(Port),
    /// `use left[6]: Leg(size = 2) { frame = ground };`
    Use(Box<Use>),
    /// `follow pen.tip in (1 ..= 3, 0 ..= 2) by left, right;`
    Follow(Follow),
    /// `path pen.tip = (2 + cos(t), 1 + sin(t));`
    Path(Trajectory),
    /// `expect transmission > 40 deg for a in 0 deg ..= 90 deg;`
    Expect(Box<Expect>),
    /// `allow redundant;`
    Allow(Ident),
    /// Something that could not be read.
    Broken(Broken),
}

/// `follow pen.tip in (1 ..= 3, 0 ..= 2) by left, right;`
pub(super) struct Follow {
    /// The word `follow`.
    pub keyword: Span,
    /// The point, or the link.
    pub what: End,
    /// The ends of the ranges of what is given, if a region is.
    pub region: Vec<[Expr; 2]>,
    /// The joints of the motors.
    pub motors: Vec<Name>,
    /// The word `least`, if it stands there.
    pub least: Option<Span>,
}

/// `path pen.tip = (2 + cos(t), 1 + sin(t));`
pub(super) struct Trajectory {
    /// The word `path`.
    pub keyword: Span,
    /// The point, or the link.
    pub what: End,
    /// The laws of what is given.
    pub laws: Vec<Expr>,
}

/// A statement or an item that could not be read.
pub(super) struct Broken {
    /// The message about it.
    pub error: Message,
    /// The names that it seems to declare: whoever refers to them is not to blame.
    pub names: Vec<Ident>,
}

/// `const NAME = value;` or `param name = value;`
pub(super) struct Constant {
    /// Its name.
    pub name: Ident,
    /// Its value.
    pub value: Read<Expr>,
}

/// `ground { ... }`
pub(super) struct Ground {
    /// The word `ground`.
    pub keyword: Span,
    /// The items that are fixed to it.
    pub items: Read<Vec<Item>>,
}

/// `link name { ... }`
pub(super) struct Link {
    /// Its name.
    pub name: Ident,
    /// The items that are fixed to it.
    pub items: Read<Vec<Item>>,
}

/// Something fixed to a link.
pub(super) enum Item {
    /// `point name = (x, y) -> (dx, dy);` or `line name = (x, y) -> 30 deg;`
    Axis(Axis),
    /// `circle ...;` or `polygon ...;`
    Shape(Shape),
    /// `mass ...;` or `density ...;`
    Matter(Box<Matter>),
    /// Something that could not be read.
    Broken(Broken),
}

/// A point or a line.
pub(super) struct Axis {
    /// Which of the two.
    pub kind: crate::model::AxisKind,
    /// Its name.
    pub name: Ident,
    /// Where it is.
    pub value: Read<AxisValue>,
}

/// `(x, y) -> (dx, dy) turned a`
pub(super) struct AxisValue {
    /// Its origin.
    pub at: Pair,
    /// Its direction, if one is given.
    pub direction: Option<Direction>,
    /// The angle by which both are turned about the link's origin, if they are.
    pub turned: Option<Expr>,
}

/// A direction.
pub(super) enum Direction {
    /// `(dx, dy)`
    Parts(Pair),
    /// `30 deg`, counter-clockwise from the x axis.
    Angle(Expr),
}

/// The mass of a link.
pub(super) struct Matter {
    /// The word it begins with.
    pub keyword: Span,
    /// The mass, or the density.
    pub kind: MatterKind,
}

/// The mass of a link, or its density.
pub(super) enum MatterKind {
    /// `mass 0.4 at (0.1, 0) inertia 2e-3`
    Mass { mass: Expr, at: Option<Pair>, inertia: Option<Expr> },
    /// `density 7.8`
    Density(Expr),
}

/// `spring coil = linear(rocker.d, ground.c) stiffness 4530 rest 0.08;`, or a damper.
pub(super) struct Elastic {
    /// Its name.
    pub name: Ident,
    /// Its ends, and its strength.
    pub body: Read<ElasticBody>,
}

/// The ends of a spring or damper, and its strength.
pub(super) struct ElasticBody {
    /// Its ends.
    pub between: BetweenEnds,
    /// Its stiffness or damping.
    pub strength: Expr,
    /// The length or coordinate at which a spring is at rest.
    pub rest: Option<Expr>,
}

/// The ends of a spring or damper.
pub(super) enum BetweenEnds {
    /// `linear(a.p, b.q)`
    Points([End; 2]),
    /// `torsional(joint)`
    Joint(Name),
}

/// `load push = force(rod.small_end);`
pub(super) struct Load {
    /// Its name.
    pub name: Ident,
    /// The point or link on which it acts.
    pub on: Read<LoadOn>,
}

/// The point or link on which a load acts.
pub(super) enum LoadOn {
    /// `force(link.point)`
    Force(End),
    /// `torque(link)`
    Torque(Name),
}

/// `joint name = ...;`
pub(super) struct Joint {
    /// Its name.
    pub name: Ident,
    /// Its kind, and the parts that it joins.
    pub body: Read<JointBody>,
}

/// The body of a joint: `kind(first, second, size) at (x, y) along (dx, dy)`.
pub(super) struct JointBody {
    /// The word for its kind.
    pub word: Ident,
    /// The kind.
    pub kind: JointWord,
    /// The two parts that it joins.
    pub ends: [End; 2],
    /// The sizes and the carrier of its rolling parts, if it has any.
    pub rolling: Option<Rolling>,
    /// The law of a cam, a function of the coordinate `q`.
    pub law: Option<Expr>,
    /// The roller of its follower, if it is named.
    pub roller: Option<RollerExpr>,
    /// Where it is in the drawing.
    pub at: Option<Clause<Pair>>,
    /// Its direction in the drawing.
    pub along: Option<Clause<Direction>>,
}

/// `roller valve.foot radius 5`
pub(super) struct RollerExpr {
    /// The middle of the roller.
    pub point: End,
    /// Its radius.
    pub radius: Expr,
}

impl JointBody {
    /// The words `at` and `along`, as far as they stand there.
    pub(super) fn clauses(&self) -> impl Iterator<Item = Span> {
        let at = self.at.iter().map(|clause| clause.keyword);
        at.chain(self.along.iter().map(|clause| clause.keyword))
    }
}

/// The kinds of joint that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JointWord {
    Revolute,
    Prismatic,
    Gear,
    Slot,
    Rack,
    Belt,
    Weld,
    Cam,
}

/// `at (x, y)`, `along (dx, dy)` or `along 30 deg`
pub(super) struct Clause<T> {
    /// The word it begins with.
    pub keyword: Span,
    /// The value after it.
    pub value: T,
}

/// The sizes and the carrier of a gear, belt or rack: `20 : 40 on arm`.
pub(super) struct Rolling {
    /// Its sizes.
    pub size: Size,
    /// The link after `on`, which carries both parts.
    pub carrier: Option<Name>,
}

/// The sizes of what rolls.
pub(super) enum Size {
    /// `20 : 40`
    Ratio([Expr; 2]),
    /// `radius 0.5`
    Radius(Expr),
}

/// `motor joint = law in low ..= high by step;`
pub(super) struct Motor {
    /// The joint it drives.
    pub joint: Name,
    /// The law after `=`, a function of the time `t`.
    pub law: Option<Expr>,
    /// The range after `in`.
    pub range: Option<[Expr; 2]>,
    /// The step after `by`.
    pub step: Option<Expr>,
}

/// `start { ... }`
pub(super) struct Start {
    /// The word `start`.
    pub keyword: Span,
    /// The clauses that assemble the mechanism.
    pub clauses: Vec<Read<StartClause>>,
}

/// `joint = value;` or `link near angle;`
pub(super) struct StartClause {
    /// The joint or link.
    pub name: Name,
    /// Whether the word `near` stands in the middle.
    pub near: bool,
    /// The coordinate or angle.
    pub value: Expr,
}

/// The words for effects.
pub(super) const EFFECTS: [&str; 7] =
    ["velocity", "acceleration", "force", "dynamics", "trace", "overlay", "sensitivity"];

/// One of the effects.
pub(super) enum Effect {
    /// `velocity;`
    Plain(Ident),
    /// `trace a.b 256;`
    Trace(Box<Trace>),
}

/// `trace link.point length on plane n color c;`
pub(super) struct Trace {
    /// The point.
    pub point: End,
    /// The number of places that are kept.
    pub length: Expr,
    /// Its plane, if given.
    pub plane: Option<Expr>,
    /// Its colour, if given.
    pub color: Option<Color>,
}

/// `method newton(2);`
pub(super) struct Method {
    /// The word `method`.
    pub keyword: Span,
    /// The method.
    pub word: Ident,
    /// The brackets after it, and the number of steps in them.
    pub steps: Option<(Option<Expr>, Place)>,
    /// The word `predictor` after them, and its order.
    pub predictor: Option<(Span, Expr)>,
}

/// `expect transmission > 40 deg for a in 0 deg ..= 90 deg, "why";`
pub(super) struct Expect {
    /// The word `expect`.
    pub keyword: Span,
    /// The condition.
    pub condition: ConditionExpr,
    /// The motors after `for` and `at`, with their values.
    pub cases: Vec<CaseExpr>,
    /// The loads after `for`, with what they are.
    pub loads: Vec<LoadCase>,
    /// The words in quotes.
    pub why: Option<String>,
}

/// What has to hold.
pub(super) enum ConditionExpr {
    /// `a < b`
    Compare { sides: [Expr; 2], is_upper: bool, is_strict: bool },
    /// `a in low ..= high`
    Within(Expr, [Expr; 2]),
    /// `turns(a)`
    Turns(Name, Place),
}

/// `a in 0 deg ..= 90 deg` after `for`, or `a = 30 deg` after `at`.
pub(super) struct CaseExpr {
    /// The motor.
    pub motor: Name,
    /// Its values: both ends, or only one.
    pub values: Vec<Expr>,
}

/// `push = (-100, 0)` or `brake = 5` after `for`.
pub(super) struct LoadCase {
    /// The name of the load.
    pub name: Name,
    /// The parts of a force, or a torque.
    pub numbers: Vec<Expr>,
    /// From the first number to the last.
    pub place: Place,
}

/// `part Leg(size = 1) { ... }`
pub(super) struct Part {
    /// Its name.
    pub name: Ident,
    /// Its numbers, each with the value it has where a use gives none.
    pub parameters: Vec<Constant>,
    /// The statements in its braces.
    pub body: Read<Vec<Statement>>,
}

/// `port frame { ... }`: a link that whoever uses the part lends.
pub(super) struct Port {
    /// Its name.
    pub name: Ident,
    /// The items that the part fixes to it.
    pub items: Read<Vec<Item>>,
}

/// `use left[6]: Leg(phase = k * 60 deg) mirrored scaled 2 { frame = ground, crank = axle at (1, 0) turned 30 deg };`
pub(super) struct Use {
    /// Its name.
    pub name: Ident,
    /// The number of instances, in brackets; without them there is one.
    pub count: Option<(Expr, Place)>,
    /// The part.
    pub part: Ident,
    /// The values of its numbers.
    pub arguments: Vec<Constant>,
    /// The word `mirrored`, if left and right change sides.
    pub mirrored: Option<Span>,
    /// The factor of its lengths after the word `scaled`.
    pub scaled: Option<Expr>,
    /// The links that are lent.
    pub ports: Vec<PortBinding>,
}

/// `crank = axle at (1, 0) turned 30 deg`
pub(super) struct PortBinding {
    /// The port.
    pub port: Ident,
    /// The link that is lent.
    pub link: Name,
    /// Where the port's frame is in that of the link.
    pub at: Option<Pair>,
    /// The angle of the port's frame in that of the link.
    pub turned: Option<Expr>,
}

impl Part {
    /// Whether a statement that could not be read may declare this name in it.
    pub(super) fn seems_to_declare(&self, name: &Ident) -> bool {
        match &self.body {
            Ok(body) => body.iter().any(|statement| match statement {
                Statement::Broken(broken) => broken.names.contains(name),
                _ => false,
            }),
            Err(_) => true,
        }
    }

    /// The ports it has, as far as they could be read.
    pub(super) fn ports(&self) -> impl Iterator<Item = &Port> {
        let body = self.body.iter().flatten();
        body.filter_map(|statement| match statement {
            Statement::Port(port) => Some(port),
            _ => None,
        })
    }
}
