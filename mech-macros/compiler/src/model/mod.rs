//! The mechanism as data: links, the axes rigidly fixed to them, the joints between axes, the motors on joints.
//!
//! A model knows no spans. Whatever a message may have to point at carries an [`Origin`], which `syntax` (or the studio)
//! maps back to where it was declared.

mod action;
mod boundary;
mod drawing;
mod effects;
mod figure;
mod formula;
mod function;
mod id;
mod inverse;
mod joint;
mod jump;
mod law;
mod link;
mod look;
mod mass;
mod measurand;
mod param;
mod period;
mod polygon;
mod quantity;
mod requirement;
mod roller;
mod scale;
mod shape;
mod show;
mod start;

pub use action::{Actions, Between, Damper, Load, LoadKind, Spring};
pub(crate) use boundary::{Boundary, Corner, Curve};
pub(crate) use drawing::{DrawnAxis, FORWARD};
pub use effects::Effects;
pub use effects::Trace;
pub use figure::Figure;
pub use formula::Number;
pub use formula::{Arithmetic, Formula, FormulaArithmetic, Formulas, Now};
pub(crate) use function::function_names;
pub use function::{BinaryFunction, Function};
pub(crate) use id::in_32_bits;
pub use id::{AxisId, FormulaId, InputId, JointId, LawId, LinkId, MotorId, Origin, ParamId};
pub use inverse::Inverse;
pub use joint::{Joint, JointKind, Motor, Range, Ratio};
pub use jump::Jump;
pub use law::Law;
pub use link::Instance;
pub use link::{Axis, AxisKind, Link};
pub use look::Look;
pub(crate) use look::color_of;
pub use mass::Mass;
pub use measurand::Measurand;
pub use param::{Param, Params};
pub use quantity::{Dimension, Quantity, Rate, ReactionPart, Spot};
pub use requirement::{Case, Condition, Measured, RequiredBound, Requirement, Summary};
pub use roller::Roller;
pub use scale::ScaleTrouble;
pub use shape::{Measure, Place};
pub use shape::{Quality, Shape, ShapeKind};
pub use show::Shown;
pub use start::{Near, Start, StartValue};

/// The scalar type of the generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// Single precision.
    F32,
    /// Double precision.
    #[default]
    F64,
}

impl Precision {
    /// Whether a number is finite in this type.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::F32 => value.abs() <= f64::from(f32::MAX),
            Self::F64 => value.is_finite(),
        }
    }

    /// The least number that it holds with all its digits.
    #[must_use]
    pub fn least(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::MIN_POSITIVE),
            Self::F64 => f64::MIN_POSITIVE,
        }
    }

    /// The distance from one to the next greater number.
    #[must_use]
    pub fn epsilon(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::EPSILON),
            Self::F64 => f64::EPSILON,
        }
    }
}

/// The method by which the loops are solved at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Method {
    /// Each dyad in closed form; what has none (coupled and tied loops) by Newton's iteration until it closes to rounding.
    #[default]
    Exact,
    /// One linear step of the loop's system from the last position: the paper's frame-to-frame step.
    Linear,
    /// Newton steps until the loop closes to rounding; the motor step is subdivided when that fails.
    Newton,
    /// Exactly this many Newton steps (at least one), then the closure is checked.
    NewtonSteps(u32),
}

/// The machine whose cost model weighs operations when a method is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Target {
    /// A desktop machine.
    #[default]
    X86_64,
    /// An ARM Cortex-M4 with a single-precision unit; double precision is done in software.
    CortexM4f,
}

/// The behaviour of a mechanism at its change points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AtChangePoints {
    /// It goes on as it came: velocities are continuous.
    #[default]
    GoOn,
    /// It keeps its branch: the sense in which each dyad is folded.
    KeepBranch,
    /// It is blocked there.
    Stop,
}

/// A planar mechanism: the ground, the moving links, and what joins them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Model {
    /// The name of the generated struct.
    pub name: String,
    /// Where the name was declared.
    pub origin: Origin,
    /// The scalar type of the generated code.
    pub precision: Precision,
    /// All links; [`LinkId::GROUND`] is the first.
    pub links: Vec<Link>,
    /// All axes of all links.
    pub axes: Vec<Axis>,
    /// All joints.
    pub joints: Vec<Joint>,
    /// All motors, in the order in which `move_to` takes their values.
    pub motors: Vec<Motor>,
    /// The laws of motors and cams.
    pub laws: Vec<Law>,
    /// The rollers of followers that are declared.
    pub rollers: Vec<Roller>,
    /// The numbers that may be changed while it runs.
    pub params: Params,
    /// The start values, and the choice of an assembly.
    pub start: Start,
    /// The method by which loops are solved, if one was declared. Without it a declared `accuracy` decides; without both the method is
    /// exact.
    pub method: Option<Method>,
    /// From how many differences of the motion iterations are started, 0 to 3.
    pub predictor: u8,
    /// The greatest error of any position that is allowed, in scene units, if one was declared.
    pub accuracy: Option<f64>,
    /// Whose operations are counted when a method is chosen.
    pub target: Target,
    /// The behaviour at change points.
    pub change_points: AtChangePoints,
    /// The quality of the pictures that it makes for itself.
    pub quality: Quality,
    /// The look, if one was declared.
    pub look: Option<Look>,
    /// The links, points and joints to be shown. Steps on which none depends are left out. Without a `show`, everything is shown.
    pub show: Option<Vec<Shown>>,
    /// The revolute joints whose coordinates are to go on over whole turns.
    pub continuous: Vec<JointId>,
    /// The allowances.
    pub allow: Allowances,
    /// The results that are computed beyond positions.
    pub effects: Effects,
    /// The actions on links.
    pub actions: Actions,
    /// The points whose paths are recorded.
    pub traces: Vec<Trace>,
    /// The conditions that it has to meet.
    pub requirements: Vec<Requirement>,
    /// The point that is given, if motors follow one.
    pub inverse: Option<Inverse>,
    /// The instances of parts, each after the one that it is in.
    pub instances: Vec<Instance>,
    /// The constants and params of the mechanism itself, with their values at the start: whoever measures may name them.
    pub constants: Vec<(String, f64)>,
}

/// The allowances: each lets something pass that is otherwise an error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Allowances {
    /// Joints that hold a part more than once, where lengths match exactly.
    pub redundant: bool,
    /// Loops that wait for each other: they are solved together.
    pub coupled: bool,
}

impl Model {
    /// A mechanism of nothing but the ground.
    #[must_use]
    pub fn new(name: &str, origin: Origin) -> Self {
        Self {
            name: name.to_owned(),
            origin,
            precision: Precision::default(),
            links: vec![Link::new("ground", Origin::default())],
            axes: Vec::new(),
            joints: Vec::new(),
            motors: Vec::new(),
            laws: Vec::new(),
            rollers: Vec::new(),
            params: Params::default(),
            start: Start::default(),
            method: None,
            predictor: 0,
            accuracy: None,
            target: Target::default(),
            change_points: AtChangePoints::default(),
            quality: Quality::default(),
            look: None,
            show: None,
            continuous: Vec::new(),
            allow: Allowances::default(),
            effects: Effects::default(),
            actions: Actions::default(),
            traces: Vec::new(),
            requirements: Vec::new(),
            inverse: None,
            instances: Vec::new(),
            constants: Vec::new(),
        }
    }

    /// Whether every number in it is within the range of the scalar type.
    #[must_use]
    pub fn fits(&self) -> bool {
        let mut shapes = self.links.iter().flat_map(Link::shape_points);
        let in_shape = |([x, y], reach): ([f64; 2], f64)| {
            [x, y, reach].iter().all(|n| self.precision.holds(2.0 * n))
        };
        // Links reach as far as all of them together.
        #[expect(clippy::cast_precision_loss, reason = "no mechanism has 2⁵² links")]
        let together = 16.0 * self.links.len() as f64;
        let in_axis = |axis: &Axis| {
            let mut parts = axis.at.iter();
            parts.all(|&n| self.precision.holds(together * n))
        };
        let in_start = |value: &StartValue| self.precision.holds(value.value);
        // Bodies are painted from squares.
        let squared = |n: f64| self.precision.holds(16.0 * n * n);
        let in_range = |range: &Range| squared(range.low) && squared(range.high);
        let in_joint = |joint: &Joint| match joint.kind {
            JointKind::Rack { radius, .. } => squared(radius),
            JointKind::Gear { ratio: Ratio::Radii(a, b), .. }
            | JointKind::Belt { ratio: Ratio::Radii(a, b), .. } => squared(a) && squared(b),
            _ => true,
        };
        let mut ranges = self.motors.iter().flat_map(|motor| &motor.range);
        self.joints.iter().all(in_joint)
            && ranges.all(in_range)
            && shapes.all(in_shape)
            && self.axes.iter().all(in_axis)
            && self.start.values.iter().all(in_start)
            && self.params.values().all(|value| self.precision.holds(value))
    }

    /// The places of a link's axes in its frame.
    pub(crate) fn axis_places(&self, link: LinkId) -> impl Iterator<Item = [f64; 2]> {
        let axes = self.axes.iter().filter(move |axis| axis.link == link);
        axes.map(|axis| axis.at)
    }

    /// Returns its size: the greatest distance of an axis from the origin of its link.
    #[must_use]
    pub fn size(&self) -> f64 {
        let reach = |axis: &Axis| axis.at[0].hypot(axis.at[1]);
        self.axes.iter().map(reach).fold(0.0, f64::max)
    }

    /// The link with this id.
    #[must_use]
    pub fn link(&self, id: LinkId) -> &Link {
        &self.links[id.index()]
    }

    /// The axis with this id.
    #[must_use]
    pub fn axis(&self, id: AxisId) -> &Axis {
        &self.axes[id.index()]
    }

    /// The name under which an axis belongs to a link: that of the port, if a part fixed it to a link that it was lent.
    #[must_use]
    pub fn owner_of<'m>(&'m self, axis: &'m Axis) -> &'m str {
        let port = axis.port.as_deref();
        port.unwrap_or_else(|| &self.link(axis.link).name)
    }

    /// The joint with this id.
    #[must_use]
    pub fn joint(&self, id: JointId) -> &Joint {
        &self.joints[id.index()]
    }

    /// The motor with this id.
    #[must_use]
    pub fn motor(&self, id: MotorId) -> &Motor {
        &self.motors[id.index()]
    }

    /// The law with this id.
    #[must_use]
    pub fn law(&self, id: LawId) -> &Law {
        &self.laws[id.index()]
    }

    /// Whether the coordinate of a joint is an angle.
    #[must_use]
    pub fn turns(&self, joint: JointId) -> bool {
        matches!(self.joint(joint).kind, JointKind::Revolute(..))
    }

    /// A displacement of a motor that compares with those of others: a radian, or the size of the mechanism if it slides and has a size.
    #[must_use]
    pub fn unit_of(&self, motor: MotorId) -> f64 {
        let size = self.size();
        if self.turns(self.motor(motor).joint) || size == 0.0 { 1.0 } else { size }
    }

    /// Whether anything moves by laws of the time: motors, or a point on its path.
    #[must_use]
    pub fn has_laws(&self) -> bool {
        let mut paths = self.inverse.iter().map(|inverse| &inverse.trajectory);
        self.lawful_motors().next().is_some() || paths.any(|path| !path.is_empty())
    }

    /// The motors that follow laws, in the order of their declaration.
    pub fn lawful_motors(&self) -> impl Iterator<Item = (MotorId, &Law)> {
        self.motor_ids().filter_map(|id| Some((id, self.law(self.motor(id).law?))))
    }

    /// The motor that drives this joint, if one does.
    #[must_use]
    pub fn motor_of(&self, joint: JointId) -> Option<MotorId> {
        self.motors.iter().position(|motor| motor.joint == joint).map(MotorId::new)
    }

    /// The two links of this joint, in the order in which they were declared: the coordinate is that of the second
    /// relative to the first.
    #[must_use]
    pub fn ends(&self, id: JointId) -> (LinkId, LinkId) {
        match self.joint(id).kind {
            JointKind::Revolute(..) | JointKind::Prismatic(..) | JointKind::Weld(..) => {
                self.axes_of(id)
            }
            JointKind::Gear { a, b, .. } | JointKind::Belt { a, b, .. } => (a, b),
            JointKind::Rack { pinion, bar, .. } => (pinion, bar),
            JointKind::Cam { shaft, follower, .. } => {
                let (shaft, follower) = (self.axes_of(shaft), self.axes_of(follower));
                // If they share none, that is an error: either link will do here.
                let carrier = common(shaft, follower).unwrap_or(shaft.0);
                (beside(shaft, carrier), beside(follower, carrier))
            }
        }
    }

    /// The link that carries both the shaft and the follower of a cam: the one that both of these joints join to something.
    #[must_use]
    pub fn carrier_of_cam(&self, shaft: JointId, follower: JointId) -> Option<LinkId> {
        common(self.axes_of(shaft), self.axes_of(follower))
    }

    /// The line of the guide and that of the block of a prismatic joint; none of other joints. The ground has the guide, whichever link is
    /// declared first.
    #[must_use]
    pub fn guide_and_block(&self, id: JointId) -> Option<[AxisId; 2]> {
        let JointKind::Prismatic(a, b) = self.joint(id).kind else {
            return None;
        };
        let is_turned = self.axis(b).link == LinkId::GROUND;
        Some(if is_turned { [b, a] } else { [a, b] })
    }

    /// The links of the axes that a joint makes coincide; what has none joins the ground to itself.
    fn axes_of(&self, id: JointId) -> (LinkId, LinkId) {
        self.joint(id).kind.axes().map_or((LinkId::GROUND, LinkId::GROUND), |[a, b]| {
            (self.axis(a).link, self.axis(b).link)
        })
    }

    /// The cams: the joint, its shaft, its follower and its law.
    pub fn cams(&self) -> impl Iterator<Item = (JointId, JointId, JointId, &Law)> {
        self.joint_ids().filter_map(|id| match self.joint(id).kind {
            JointKind::Cam { shaft, follower, law } => Some((id, shaft, follower, self.law(law))),
            _ => None,
        })
    }

    /// Joins a point of one link to a line of another: the pin turns and slides in the slot. This adds a die, which must come
    /// after all links that are declared.
    pub fn add_slot(&mut self, name: &str, origin: Origin, point: AxisId, line: AxisId) -> JointId {
        let die = LinkId::new(self.links.len());
        let mut link = Link::new(name, origin);
        link.die = Some((point, line));
        self.links.push(link);
        let mut axis = |kind| {
            let (at, direction) = ([0.0, 0.0], [1.0, 0.0]);
            self.axes.push(Axis {
                link: die,
                name: None,
                port: None,
                origin,
                kind,
                at,
                formulas: [None; 2],
                direction,
                direction_formulas: [None; 2],
            });
            AxisId::new(self.axes.len() - 1)
        };
        let (pivot, guide) = (axis(AxisKind::Point), axis(AxisKind::Line));
        let joint = |kind, hidden| Joint { name: name.to_owned(), origin, kind, hidden };
        self.joints.push(joint(JointKind::Revolute(point, pivot), true));
        self.joints.push(joint(JointKind::Prismatic(line, guide), false));
        JointId::new(self.joints.len() - 1)
    }

    /// The ids of the links that were declared and can move: all but the ground and the dies of slots.
    #[must_use]
    pub fn declared_links(&self) -> impl DoubleEndedIterator<Item = LinkId> + '_ {
        self.moving_links().filter(|&link| self.link(link).die.is_none())
    }

    /// The ids of all links, the ground first.
    pub fn link_ids(&self) -> impl DoubleEndedIterator<Item = LinkId> + ExactSizeIterator + use<> {
        (0..self.links.len()).map(LinkId::new)
    }

    /// The ids of the links that can move: all but the ground.
    pub fn moving_links(&self) -> impl DoubleEndedIterator<Item = LinkId> + use<> {
        (1..self.links.len()).map(LinkId::new)
    }

    /// The ids of all joints.
    pub fn joint_ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = JointId> + ExactSizeIterator + use<> {
        (0..self.joints.len()).map(JointId::new)
    }

    /// The ids of the joints that were declared: all but the pivots of slots.
    pub fn declared_joints(&self) -> impl Iterator<Item = JointId> + '_ {
        self.joint_ids().filter(|&joint| !self.joint(joint).hidden)
    }

    /// The ids of all motors.
    pub fn motor_ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = MotorId> + ExactSizeIterator + use<> {
        (0..self.motors.len()).map(MotorId::new)
    }
}

/// A link that two joints both join, by their ends.
fn common(first: (LinkId, LinkId), second: (LinkId, LinkId)) -> Option<LinkId> {
    [first.0, first.1].into_iter().find(|&link| link == second.0 || link == second.1)
}

/// The other end of a joint.
fn beside((a, b): (LinkId, LinkId), link: LinkId) -> LinkId {
    if a == link { b } else { a }
}
