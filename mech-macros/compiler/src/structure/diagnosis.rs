//! Diagnoses of mechanisms, as data: tests match them, the reporter puts them into words.

use crate::model::{AxisId, JointId, LinkId, MotorId, Origin, ParamId, Ratio};

/// An owner of numbers from which forces are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Extreme {
    /// The mass of a link, its moment of inertia or its centre.
    Mass(LinkId),
    /// A spring, by its number.
    Spring(usize),
    /// A damper, by its number.
    Damper(usize),
    /// Gravity.
    Gravity,
    /// The law of a motor.
    Law(MotorId),
}

/// Something that keeps a mechanism from moving as a mechanism should.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Diagnosis {
    /// No joint holds this link.
    Loose {
        /// The link.
        link: LinkId,
    },
    /// These links are joined to each other, but not to the ground.
    Disconnected {
        /// The piece that floats.
        links: Vec<LinkId>,
    },
    /// There is no link in which both parts that roll here keep their place.
    NoCarrier {
        /// The gear, belt or rack.
        joint: JointId,
    },
    /// The link that was named as carrier does not carry both parts that roll here.
    NotCarrier {
        /// The gear, belt or rack.
        joint: JointId,
        /// The link that was named.
        link: LinkId,
    },
    /// Several links could be the carrier here, and each would mean another motion.
    SeveralCarriers {
        /// The gear, belt or rack.
        joint: JointId,
        /// The links in which both parts keep their place.
        carriers: Vec<LinkId>,
    },
    /// These wheels cannot roll on each other.
    NoMesh {
        /// The gear or belt.
        joint: JointId,
        /// The link on which both turn.
        carrier: LinkId,
        /// Their sizes.
        ratio: Ratio,
        /// Why not.
        trouble: MeshTrouble,
    },
    /// This motor's joint cannot move.
    Blocked {
        /// The motor.
        motor: MotorId,
        /// The links that form the rigid part it is in, as far as it takes them to hold it.
        part: Vec<LinkId>,
        /// The joints that hold the part rigid: together just enough. Some may be of links that move.
        joints: Vec<JointId>,
    },
    /// The motors before it already determine this motor's joint.
    TooManyMotors {
        /// The motor that is too many.
        motor: MotorId,
        /// All motors that depend on each other, itself included.
        among: Vec<MotorId>,
    },
    /// Joints that hold a part more than once: it could be assembled only if lengths matched exactly.
    Overdetermined {
        /// The joints that hold each other's part.
        joints: Vec<JointId>,
        /// Whether it can still be assembled and moves, because its lengths match exactly.
        is_mobile: bool,
    },
    /// Joints hold a part more than once, so that it moves only as long as its lengths match; but params may change lengths.
    OverconstrainedWithParam {
        /// The joints among which some are too many.
        joints: Vec<JointId>,
        /// A param that lengths depend on.
        param: ParamId,
    },
    /// There is no motor at all.
    NoMotor {
        /// The number of motors that it takes.
        freedom: usize,
        /// Joints on each of which a motor would do, or, where it takes several, joints that would do together.
        candidates: Vec<JointId>,
    },
    /// Joints stay free with all motors held.
    Undetermined {
        /// The number of missing motors.
        freedom: usize,
        /// The joints that stay free.
        free: Vec<JointId>,
        /// Joints on each of which a motor would do, or, where it takes several, joints that would do together.
        candidates: Vec<JointId>,
    },
    /// All joints of this link are at one place, so that it turns freely there.
    OnOnePin {
        /// The link.
        link: LinkId,
        /// Its joints.
        joints: Vec<JointId>,
    },
    /// Nothing can move: there is no freedom for any motor.
    Rigid,
    /// No further loop of three unknowns exists, though joints remain to be solved: they wait for each other.
    NotSequential {
        /// The joints that wait.
        waiting: Vec<JointId>,
        /// The rings that they form, each by its unknown joints.
        rings: Vec<Vec<JointId>>,
    },
    /// A cam is of no use: its shaft is not known before its follower.
    CamNotDriven {
        /// The cam.
        joint: JointId,
    },
    /// The law of a cam has no value at the start, or one beyond the range of the scalar type.
    CamWithoutValue {
        /// The cam.
        joint: JointId,
        /// The coordinate of its shaft there.
        at: f64,
    },
    /// A loop does not close at the start.
    CannotClose {
        /// The joints of the loop whose coordinates are unknown.
        unknowns: Vec<JointId>,
        /// The distance of the axes at their nearest approach, in scene units.
        gap: f64,
        /// The axes that cannot be made to coincide.
        axes: (AxisId, AxisId),
    },
    /// A loop starts at a dead point, from which it can go either way.
    DeadStart {
        /// The joints of the loop whose coordinates are unknown.
        unknowns: Vec<JointId>,
    },
    /// Several assemblies satisfy the start.
    SeveralAssemblies {
        /// The links whose directions distinguish the assemblies.
        links: Vec<LinkId>,
        /// For each assembly the angle of each of these links, in radians. Of very many, only those in which one loop differs
        /// from the first.
        angles: Vec<Vec<f64>>,
        /// The loops with several assemblies.
        loops: Vec<OpenLoop>,
        /// Whether there are more than are looked at.
        many: bool,
    },
    /// A link of the drawing would have to be elsewhere for the mechanism to close.
    NotAsDrawn {
        /// The link.
        link: LinkId,
    },
    /// A start value for a joint that has neither a motor nor a gear.
    StartNotFree {
        /// The joint.
        joint: JointId,
    },
    /// A motor has a declared range that could not be proved to be free.
    Range {
        /// The motor.
        motor: MotorId,
        /// The joints of unknown coordinate of the loop it is about.
        unknowns: Vec<JointId>,
        /// The trouble with the range.
        trouble: RangeTrouble,
    },
    /// Forces cannot say how these motors move: nothing that they move has a mass.
    Massless {
        /// The motors.
        motors: Vec<MotorId>,
    },
    /// A condition that the mechanism is expected to meet does not hold, or could not be proved.
    Unmet {
        /// The requirement, by its number.
        requirement: usize,
        /// The trouble with it.
        trouble: RequirementTrouble,
    },
    /// The motors that are to follow a point cannot.
    Inverse {
        /// The trouble with them.
        trouble: InverseTrouble,
    },
    /// Forces, rates or laws are computed with numbers that the scalar type does not hold.
    Overflow {
        /// Whose numbers are farthest from one, if any are declared.
        culprit: Option<Extreme>,
    },
    /// A length or a position is beyond the range of the scalar type, or a power of it is that its loops take.
    TooLarge,
    /// The lengths are so small that powers of them are lost which its loops take.
    TooSmall,
    /// An accuracy is declared, and rounding errors grow with the turns of a motor that has no range.
    EndlessAccuracy {
        /// The declared accuracy, in scene units.
        accuracy: f64,
        /// The motor.
        motor: MotorId,
    },
    /// More accuracy is declared than the scalar type has.
    TooAccurate {
        /// The declared accuracy, in scene units.
        accuracy: f64,
        /// The greatest error of a position that is to be expected when everything is solved as exactly as it can be.
        best: f64,
    },
}

impl Diagnosis {
    /// The number of a requirement that does not hold, and a place where it does not; nothing if that is not what it is about.
    #[must_use]
    pub fn witness(&self) -> Option<(usize, &Witness)> {
        match self {
            Self::Unmet { requirement, trouble: RequirementTrouble::Fails(witness) } => {
                Some((*requirement, witness))
            }
            _ => None,
        }
    }
}

/// A loop with several assemblies.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OpenLoop {
    /// The joint by whose coordinate they differ most.
    pub joint: JointId,
    /// The link by whose direction they differ most.
    pub link: LinkId,
    /// Its assemblies, the first of them that of the first assembly of the whole.
    pub assemblies: Vec<LoopAssembly>,
}

/// One assembly of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LoopAssembly {
    /// The angle of the link in the scene, in radians.
    pub angle: f64,
    /// The coordinate of the joint, in radians or scene units.
    pub coordinate: f64,
}

/// Why two wheels cannot roll on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum MeshTrouble {
    /// They turn on one shaft.
    OneShaft,
    /// A ring is not larger than the wheel in it.
    SmallRing,
    /// The pitch radii contradict the places of the axes.
    Distance {
        /// The distance of the axes, in scene units.
        distance: f64,
        /// The distance that the radii ask for: their sum, or for a ring their difference.
        asked: f64,
    },
}

/// Why motors cannot follow a point.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum InverseTrouble {
    /// These motors have no part in where it is.
    Idle {
        /// The motors.
        motors: Vec<MotorId>,
    },
    /// The motors do not move it every way: what they move is not free to be anywhere.
    Bound,
    /// At the start they do not move it every way.
    DeadStart {
        /// The joints of the loop whose coordinates are unknown.
        unknowns: Vec<JointId>,
    },
    /// What is given starts outside of its region.
    StartsOutside {
        /// The number of what is given: x, y, the angle.
        given: usize,
        /// Its value at the start, in scene units or radians.
        start: f64,
    },
    /// It is not proved that the point comes everywhere in its region.
    Region {
        /// The motor whose range it is: of what is given, or one that does not follow.
        motor: MotorId,
        /// The joints of unknown coordinate of the loop it is about.
        unknowns: Vec<JointId>,
        /// The trouble with its range. Motors of what is given stand in place of those that follow.
        trouble: RangeTrouble,
        /// A smaller region for which it was proved: none if none was found.
        proved: Vec<[f64; 2]>,
    },
    /// Loops wait for each other.
    Coupled {
        /// The joints that wait.
        waiting: Vec<JointId>,
    },
    /// The point cannot be led along its path.
    Trajectory {
        /// The time at which it is stopped.
        time: f64,
        /// What its path gives there: x, y, the angle.
        given: Vec<f64>,
        /// Its obstacle.
        stop: TrajectoryStop,
    },
}

/// The obstacle on a path.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TrajectoryStop {
    /// The loop of these joints of unknown coordinate does not close, or is at a dead point.
    Loop(Vec<JointId>),
    /// What is given leaves its region: x, y, the angle.
    Region(usize),
    /// A motor that follows would leave its range.
    Range(MotorId),
    /// The mechanism would have to be assembled otherwise.
    Apart,
    /// A law has no value.
    Law,
    /// A coordinate leaves the range of the numbers.
    TooLarge,
}

/// Why a requirement is not met.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RequirementTrouble {
    /// It does not hold at a place.
    Fails(Witness),
    /// The motor does not turn right round: it is stopped.
    Stops {
        /// The motor.
        motor: MotorId,
        /// Where it is stopped, in radians.
        limit: f64,
        /// The joints of the loop that stops it.
        unknowns: Vec<JointId>,
    },
    /// The motor's declared range is less than a turn.
    Limited {
        /// The motor.
        motor: MotorId,
    },
    /// Neither a proof nor a place where it does not hold was found within the time there is.
    Undecided {
        /// The value of what is measured that came nearest to the limit.
        value: f64,
        /// The place.
        at: WitnessPlace,
        /// By how much more it may change elsewhere, as far as that is known.
        open: f64,
    },
    /// There are too many loops, or too many ways in which they may be assembled.
    TooHard,
    /// What is measured depends on a loop that is solved by iteration, for which there is no proof.
    Iterated {
        /// The joints of the loop.
        unknowns: Vec<JointId>,
    },
    /// What is measured takes effects that are not declared.
    NoEffect {
        /// Their words.
        effects: Vec<String>,
    },
    /// Forces are measured that are not determined: joints are redundant.
    NoForces,
    /// What is measured takes more than three linear equations to be solved together, for which there is no proof.
    Together,
    /// A law decides where this motor is, and the requirement says so, too.
    Follows {
        /// The motor.
        motor: MotorId,
        /// Where its values were declared.
        origin: Origin,
    },
    /// It is not known for which times laws are followed: nothing tells after what time they are back.
    NoTimes {
        /// Whether laws are back, and what is measured is not.
        goes_on: bool,
    },
    /// The law of this motor jumps, or its rate does, as far as intervals tell: then it has no rate or second rate there.
    Jumps {
        /// The motor.
        motor: MotorId,
        /// The time.
        at: f64,
        /// Whether its rate jumps, else its value.
        is_rate: bool,
    },
    /// Laws lead to where the mechanism does not go.
    Astray {
        /// The time at which it stops.
        at: f64,
    },
    /// Rates are measured, and it is not known which of these motors moves.
    NoRate {
        /// The motors.
        motors: Vec<MotorId>,
    },
    /// There is no loop that has a transmission angle, or this one has none.
    NoDyad {
        /// The joints of the loop, if there is one.
        unknowns: Vec<JointId>,
    },
    /// A proof holds for one shape of the mechanism, and this param may change it.
    Varies {
        /// The param.
        param: ParamId,
    },
    /// It is not known how far this motor goes.
    NoRange {
        /// The motor.
        motor: MotorId,
    },
    /// What sums up a way is asked for where several motors may move.
    SeveralMotors {
        /// The motors, but for those that follow laws.
        motors: Vec<MotorId>,
        /// Whether motors follow laws.
        is_in_time: bool,
    },
    /// A time ratio is asked for where this motor does not make whole turns, or what is measured has no one greatest and one least place.
    NotToAndFro {
        /// The motor; none, if motors follow laws.
        motor: Option<MotorId>,
    },
    /// What is measured grows with every turn of this motor.
    Endless {
        /// The motor.
        motor: MotorId,
    },
    /// The motor does not come to the values that the requirement is about.
    Unreachable {
        /// The motor.
        motor: MotorId,
        /// Where it is stopped, in radians or scene units.
        limit: f64,
        /// Where the values were declared.
        origin: Origin,
    },
}

/// A place where a requirement does not hold.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Witness {
    /// The value of what is measured there, in radians or scene units.
    pub value: f64,
    /// Whether it is too great.
    pub is_upper: bool,
    /// A limit that was proved to be kept instead, if one was.
    pub proved: Option<f64>,
    /// The place; of a swing, both of its ends.
    pub places: Vec<WitnessPlace>,
    /// Whether that is proved for times through which motors follow laws, else for all values of the motors.
    pub is_in_time: bool,
    /// The joints of the loop that it is about, if it is about one.
    pub unknowns: Vec<JointId>,
}

/// A place to which a mechanism comes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WitnessPlace {
    /// When it comes there, if motors follow laws.
    pub time: Option<f64>,
    /// The motors that are told, with their values there.
    pub motors: Vec<(MotorId, f64)>,
}

/// Why a declared range cannot stand.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RangeTrouble {
    /// Coming from the start the motor moves up to a dead point.
    Blocked {
        /// The dead point, in radians or scene units.
        limit: f64,
        /// From there it is blocked up to this value.
        until: f64,
        /// The other motors, and where they are.
        others: Vec<(MotorId, f64)>,
    },
    /// The loop is at a change point in the range, and was declared to stop there.
    Stops,
    /// Neither a proof nor a dead point was found within the time there is: this is where it could not be decided.
    Undecided {
        /// For each motor that has a part in the loop its values there.
        between: Vec<(MotorId, (f64, f64))>,
    },
    /// The loop is solved by iteration, for which there is no proof.
    Iterated,
    /// The proof holds for one shape of the mechanism, and this param may change it.
    Varies {
        /// The param.
        param: ParamId,
    },
    /// Another motor has a range, this one slides and has none: it would have to be free everywhere.
    Missing,
    /// The mechanism has this cam, and there is no proof for cams.
    Cam(JointId),
}
