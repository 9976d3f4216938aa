//! From the plan to the program.

mod cam;
mod closing;
mod continuous;
mod dyad;
mod equilibrium;
mod idle;
mod inverse_dynamics;
mod left_out;
mod linear;
mod max_step;
mod places;
mod predictor;
mod rates;
mod reaction;
mod sensitivity;
mod size;
mod tangent;
mod tied;
mod triad;
mod turning;
mod virtual_work;
mod watching;
mod wrench;

pub(super) use tangent::{Seed, Tangents};

use super::builder::Builder;
use super::calibrate::calibrate;
use super::live::live;
use super::node::{Op, Value};
use super::{
    Block, BlockKind, Choice, Follow, JointAngle, Place, Position, Program, Rounds, Watch,
};
use crate::model::{AxisId, Joint, JointKind, LinkId, Model};
use crate::plan::{
    Algebra, Connection, ConnectionKind, Coordinate, Drive, Mesh, Needed, Placement, Plan, Pose,
    Rational, Source, Step, Turning, float_of,
};
use crate::structure::Structure;
use mech_core::journey::AtZero;
use num_traits::{Signed, ToPrimitive};

/// Writes the program of a planned mechanism, with every loop solved by the method that the model says.
#[must_use]
pub fn build(model: &Model, plan: &Plan) -> Program {
    build_as(model, plan, &[])
}

/// Writes the program of a planned mechanism, with something decided for each loop; what is missing is solved by the method
/// that the model says. What nothing that is shown depends on is left out.
#[must_use]
pub fn build_as(model: &Model, plan: &Plan, choices: &[Choice]) -> Program {
    let mut links = model.asked_links();
    loop {
        let written = |idle: &[usize]| write(model, plan, choices, (&links, idle), None);
        let mut program = written(&[]);
        let idle = program.idle_loops(model, plan);
        if !idle.is_empty() {
            program = written(&idle);
        }
        // What an iteration begins with has to be known too.
        let read = program.read_back();
        let before = links.len();
        links.extend(read);
        links.sort_unstable();
        links.dedup();
        if links.len() == before {
            program.number_stored();
            return program;
        }
    }
}

/// Writes the program that goes on from positions, as far as effects ask for it: of the same links and loops as the program to
/// positions.
#[must_use]
pub fn derive(
    model: &Model,
    plan: &Plan,
    choices: &[Choice],
    positions: &Program,
    output: Output<'_>,
) -> Option<Program> {
    let wanted = match output {
        Output::Rates => model.effects.velocity,
        Output::Holding => model.effects.force,
        Output::InverseDynamics(structure) => model.effects.force && structure.redundant.is_empty(),
        Output::Inertia => model.effects.dynamics,
        Output::Sensitivity => model.effects.sensitivity,
    };
    if !wanted {
        return None;
    }
    let solved = positions.solved_loops();
    let idle = (0..plan.loops().count()).filter(|number| !solved.contains(number));
    let idle: Vec<usize> = idle.collect();
    let parts = (&positions.stored[..], &idle[..]);
    let mut program = write(model, plan, choices, parts, Some(output));
    program.number_stored();
    // Where joints hold links more than once, equilibrium does not determine what they do.
    let undetermined = matches!(output, Output::InverseDynamics(_))
        && program
            .motion
            .as_ref()
            .is_none_or(|motion| motion.forces.is_none());
    (!undetermined).then_some(program)
}

/// What a program goes on to from positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Output<'s> {
    /// The rates of everything.
    Rates,
    /// What it takes to hold it at rest.
    Holding,
    /// What it takes to move in a given way, in every joint: that of this structure, of which none is redundant.
    InverseDynamics(&'s Structure),
    /// How it moves under the torques of its motors.
    Inertia,
    /// How everything follows the params.
    Sensitivity,
}

/// The steps that something that is shown depends on.
#[must_use]
pub(crate) fn needed(model: &Model, plan: &Plan, stored: &[LinkId]) -> Needed {
    match model.show {
        None => plan.whole(),
        Some(_) => plan.needed(model, stored),
    }
}

/// Writes the program that tells where these links are, without solving these idle loops; poses are numbered among those of all
/// links.
fn write(
    model: &Model,
    plan: &Plan,
    choices: &[Choice],
    (links, idle): (&[LinkId], &[usize]),
    output: Option<Output<'_>>,
) -> Program {
    let needed = needed(model, plan, links);
    let all = model.declared_links();
    let motors = plan.start.motors.iter().copied();
    let mut builder = Builder::new(Position {
        motors: motors.chain(model.params.values()).collect(),
        turns: vec![0; model.inputs()],
        poses: all.map(|link| plan.start.poses[link.index()]).collect(),
        state: Vec::new(),
    });
    builder.block("start".to_owned(), String::new());
    builder.write_formulas(model);
    let placement = Placement::new(&mut builder, model);
    let mut writer = Writer {
        model,
        plan,
        choices,
        idle,
        builder,
        placement,
        state: Vec::new(),
        watches: Vec::new(),
        motion_signs: None,
        places: Vec::new(),
        steady: None,
        follows: Vec::new(),
        followed_angles: Vec::new(),
        winds: false,
        wanders: false,
        histories: Vec::new(),
        closings: Vec::new(),
        followed: Vec::new(),
        angles: Vec::new(),
        continuous: continuous::continuous_joints(model),
        whole_angles: Vec::new(),
        joint_angles: Vec::new(),
        sources: vec![None; plan.sources.len()],
        principals: vec![None; plan.sources.len()],
        meshes: 0,
        loops: 0,
    };
    for (step, is_needed) in plan.steps.iter().zip(&needed.steps) {
        match step {
            step if !is_needed => writer.leave_out(step, &needed.sources),
            Step::Weld(connection) => writer.weld(*connection),
            Step::Drive(drive) => writer.drive(drive),
            Step::Mesh(mesh) => writer.mesh(mesh),
            Step::Cam(cam) => writer.cam(cam),
            Step::Close(ring) => writer.close(ring),
        }
    }
    writer.carry_continuous();
    writer.keep_motion_signs();
    writer.keep_places();
    writer.finish(links, output)
}

/// For each motor and param whether only the rest of its value is read, and its whole turns apart from it: where gears turn by a part
/// of it, and somebody asks how exact that is.
fn reduced(model: &Model, plan: &Plan) -> Vec<bool> {
    let asked = model.accuracy.is_some() || model.motors.iter().any(|motor| motor.step.is_some());
    let meshes = plan
        .steps
        .iter()
        .any(|step| matches!(step, Step::Mesh(_) | Step::Cam(_)) || ties_sources(step));
    let turning = model.motors.iter().map(|motor| {
        let turns = matches!(model.joint(motor.joint).kind, JointKind::Revolute(..));
        asked && meshes && turns
    });
    let fixed = model.params.ids().map(|_| false);
    turning.chain(fixed).collect()
}

/// Whether a step closes a loop whose directions follow motors by rolling.
fn ties_sources(step: &Step) -> bool {
    matches!(step, Step::Close(closing) if closing.ties.iter().any(|tie| !tie.sources.is_empty()))
}

/// Whether something may move beyond the range of the numbers: what slides may, if a motor or a rack drives it; what a law drives
/// that may have no value; what is as long as a param; and what turns farther than what drives it, or by several things.
fn overflows(model: &Model, plan: &Plan) -> bool {
    let multiplies = |step: &Step| {
        let Step::Mesh(mesh) = step else {
            return false;
        };
        let one = Rational::from_integer(1.into());
        mesh.parts.len() > 1 || mesh.parts.iter().any(|(_, part)| part.abs() > one)
    };
    let slides = |joint: &Joint| {
        matches!(
            joint.kind,
            JointKind::Prismatic(..) | JointKind::Rack { .. } | JointKind::Cam { .. }
        )
    };
    model.joints.iter().any(slides) || !model.params.is_empty() || plan.steps.iter().any(multiplies)
}

struct Writer<'m> {
    model: &'m Model,
    plan: &'m Plan,
    choices: &'m [Choice],
    /// The loops, by number, whose solution nothing needs.
    idle: &'m [usize],
    builder: Builder,
    placement: Placement<'m, Value>,
    /// The new values of what is carried from position to position.
    state: Vec<Value>,
    watches: Vec<Watch>,
    motion_signs: Option<usize>,
    places: Vec<Place>,
    /// The sources of gears, belts and racks that were needed so far.
    sources: Vec<Option<Value>>,
    /// Those of them that are angles, between −π and π.
    principals: Vec<Option<Value>>,
    meshes: usize,
    loops: usize,
    /// Whether the motors move by equal steps, once something asked.
    steady: Option<predictor::Steady>,
    /// The angles that are followed over whole turns, and what they are.
    follows: Vec<Follow>,
    followed_angles: Vec<(Turning, Value)>,
    /// Whether an angle that is iterated is followed over whole turns.
    winds: bool,
    /// Whether something follows a law that is not the same in every turn: nobody has looked at all of its ways.
    wanders: bool,
    /// The loops that were closed.
    closings: Vec<rates::Closing>,
    /// The followers of cams.
    followed: Vec<cam::Followed>,
    /// Angles between two directions that are followed over any number of turns.
    angles: Vec<(Value, [[Value; 2]; 2])>,
    /// The joints whose coordinates are carried.
    continuous: Vec<continuous::Continuous>,
    /// Their angles, whole turns included, as far as gears and cams give them.
    whole_angles: Vec<continuous::WholeAngle>,
    /// Where these angles are carried from position to position.
    joint_angles: Vec<JointAngle>,
    /// The histories of the present loop's unknowns, if its start is predicted.
    histories: Vec<predictor::History>,
}

impl Writer<'_> {
    /// A number that is carried from position to position: what it is at the start and, unless something else is put into its
    /// place, for ever.
    fn keep(&mut self, start: f64) -> Value {
        let last = self.builder.keep(start);
        self.state.push(last);
        last
    }

    fn link_of(&self, axis: AxisId) -> LinkId {
        self.model.axis(axis).link
    }

    fn name_of(&self, link: LinkId) -> &str {
        &self.model.link(link).name
    }

    fn weld(&mut self, connection: Connection) {
        let zero = self.builder.vector([1.0, 0.0]);
        self.connect(connection, Coordinate::Turn(zero));
    }

    fn drive(&mut self, drive: &Drive) {
        let name = self.model.joint(drive.connection.joint).name.clone();
        self.builder
            .block(format!("drive_{name}"), format!("Motor `{name}`."));
        let motor = self.builder.make(Op::Motor(drive.motor.index()));
        self.builder.name(motor, &name);
        self.put(drive.connection, motor, &name);
    }

    /// Gives a connection its coordinate.
    fn put(&mut self, connection: Connection, value: Value, name: &str) {
        let coordinate = match connection.kind {
            ConnectionKind::Revolute => {
                let (sin, cos) = (
                    self.builder.make(Op::Sin(value)),
                    self.builder.make(Op::Cos(value)),
                );
                Coordinate::Turn(self.builder.name_direction([cos, sin], name))
            }
            ConnectionKind::Prismatic => Coordinate::Slide(value),
        };
        self.connect(connection, coordinate);
    }

    fn connect(&mut self, connection: Connection, coordinate: Coordinate<Value>) {
        self.placement
            .connect(&mut self.builder, connection, coordinate);
        self.name_cluster(self.link_of(connection.to));
    }

    fn mesh(&mut self, mesh: &Mesh) {
        let name = self.model.joint(mesh.by).name.clone();
        self.builder
            .block(format!("mesh_{name}"), format!("Moved by `{name}`."));
        let mut offset = self.plan.start.meshes[self.meshes];
        self.meshes += 1;
        let mut moved = self.builder.constant(0.0);
        for (number, exact) in &mesh.parts {
            offset -= float_of(exact) * self.plan.start.sources[*number];
            let turns = mesh.connection.kind == ConnectionKind::Revolute;
            let share = self.share(*number, exact, turns);
            moved = self.builder.add(moved, share);
        }
        let offset = self.builder.constant(offset);
        let value = self.builder.add(offset, moved);
        self.note_mesh(mesh, offset);
        let moved = self.model.joint(mesh.connection.joint).name.clone();
        self.builder.name(value, &moved);
        self.put(mesh.connection, value, &moved);
    }

    /// A part of what a source gives. Of a motor's whole turns, an angle needs only what they come to less whole turns.
    fn share(&mut self, number: usize, part: &Rational, is_angle: bool) -> Value {
        let source = self.source(number);
        let factor = self.builder.constant(float_of(part));
        let share = self.builder.mul(factor, source);
        let Source::Motor(motor) = self.plan.sources[number] else {
            return share;
        };
        let joint = self.model.joint(self.model.motor(motor).joint);
        if !matches!(joint.kind, JointKind::Revolute(..)) {
            return share;
        }
        let name = format!("{}_turns", joint.name);
        let turns = match (is_angle, part.numer().to_i64(), part.denom().to_i64()) {
            (true, Some(_), Some(1)) => return share,
            (true, Some(numerator), Some(denominator)) => {
                let turned = Op::Turned(motor.index(), numerator, denominator);
                let turned = self.builder.make(turned);
                self.builder.name(turned, name)
            }
            _ => {
                let turns = self.builder.make(Op::Turns(motor.index()));
                let turns = self.builder.name(turns, name);
                let turn = self.builder.constant(std::f64::consts::TAU);
                let turns = self.builder.mul(turn, turns);
                self.builder.mul(factor, turns)
            }
        };
        self.builder.add(share, turns)
    }

    /// What a gear, belt or rack is solved from.
    fn source(&mut self, number: usize) -> Value {
        if let Some(known) = self.sources[number] {
            return known;
        }
        let value = match self.plan.sources[number] {
            Source::Motor(motor) => {
                let name = self.model.joint(self.model.motor(motor).joint).name.clone();
                let value = self.builder.make(Op::Motor(motor.index()));
                self.builder.name(value, name)
            }
            Source::Angle { from, to } => {
                let start = self.plan.start.sources[number];
                let principal = self.principal(number, [from, to]);
                let name = format!("{}_angle", self.name_of(to));
                self.unwrapped(Turning::Source(number), principal, start, name)
            }
            Source::Displacement(joint) => {
                self.placement.sliding_coordinate(&mut self.builder, joint)
            }
        };
        self.sources[number] = Some(value);
        value
    }

    /// An angle between −π and π, followed over any number of turns from where it starts.
    fn unwrapped(&mut self, what: Turning, principal: Value, start: f64, name: String) -> Value {
        self.follow(what, principal);
        let state = self.state.len();
        let last = self.keep(start);
        let behind = self.builder.sub(last, principal);
        let turn = self.builder.constant(std::f64::consts::TAU);
        let turns = self.builder.div(behind, turn);
        let turns = self.builder.make(Op::Round(turns));
        let whole = self.builder.mul(turn, turns);
        let angle = self.builder.add(principal, whole);
        self.builder.name(angle, name);
        self.state[state] = angle;
        angle
    }

    /// The angle between two links that loops have solved, between −π and π: a source, by its number.
    fn principal(&mut self, number: usize, [from, to]: [LinkId; 2]) -> Value {
        if let Some(known) = self.principals[number] {
            return known;
        }
        let (base, end) = (
            self.placement.pose(from).direction,
            self.placement.pose(to).direction,
        );
        let (sin, cos) = (self.builder.cross(base, end), self.builder.dot(base, end));
        let principal = self.builder.make(Op::Atan2(sin, cos));
        self.angles.push((principal, [base, end]));
        self.principals[number] = Some(principal);
        principal
    }

    /// Names the poses of the links that were just placed.
    fn name_cluster(&mut self, link: LinkId) {
        let base = self.placement.clusters.base(link);
        let links: Vec<LinkId> = self.placement.clusters.links(base).collect();
        for link in links {
            let pose = self.placement.pose(link);
            let name = self.name_of(link).to_owned();
            self.builder.name_direction(pose.direction, &name);
            self.builder.name_vector(pose.origin, &name);
        }
    }

    /// Where a loop passes change points, the sense in which it came there tells on which side it leaves.
    fn keep_motion_signs(&mut self) {
        if self
            .watches
            .iter()
            .all(|watch| watch.at_zero == AtZero::Stay)
        {
            return;
        }
        self.motion_signs = Some(self.state.len());
        for _ in 0..self.model.inputs() {
            self.keep(1.0);
        }
    }

    fn finish(mut self, stored: &[LinkId], output: Option<Output<'_>>) -> Program {
        let pose = |&link: &LinkId| {
            let Pose {
                direction: [cos, sin],
                origin: [x, y],
            } = self.placement.pose(link);
            [cos, sin, x, y]
        };
        let poses: Vec<[Value; 4]> = stored.iter().map(pose).collect();
        let solved = |closing: &rates::Closing| (closing.number, closing.solution.clone());
        let solutions = self.closings.iter().map(solved).collect();
        let mut sensitivity = None;
        let motion = output.map(|output| match output {
            Output::Rates => self.motion(&poses),
            Output::Holding => self.holding(),
            Output::InverseDynamics(structure) => self.inverse_dynamics(structure),
            Output::Inertia => self.inertia(),
            Output::Sensitivity => {
                let (motion, found) = self.sensitivity(&poses);
                sensitivity = Some(found);
                // It tells nothing else.
                self.state.clear();
                motion
            }
        });
        let poses = if sensitivity.is_some() {
            Vec::new()
        } else {
            poses
        };
        let Self {
            model,
            plan,
            builder,
            state,
            watches,
            motion_signs,
            places,
            joint_angles,
            follows,
            followed_angles,
            winds,
            wanders,
            idle,
            ..
        } = self;
        let start = builder.start().clone();
        let leaps = |block: &Block| {
            matches!(&block.kind, BlockKind::Newton(newton)
                if newton.step.is_some() && matches!(newton.rounds, Rounds::UntilClosed(_)))
        };
        let straight = |block: &Block| matches!(block.kind, BlockKind::Straight);
        let loops = !builder.blocks.iter().all(straight);
        let varies = (wanders || !model.params.is_empty()) && loops;
        let is_coupled = builder.blocks.iter().any(leaps);
        let max_steps =
            (winds || varies || is_coupled).then(|| max_step::max_steps(model, plan, is_coupled));
        let mut program = Program {
            name: model.name.clone(),
            precision: model.precision,
            nodes: builder.nodes,
            blocks: builder.blocks,
            places,
            solutions,
            joint_angles,
            watches,
            follows,
            followed: followed_angles,
            motion_signs,
            range: None,
            max_steps,
            reduced: reduced(model, plan),
            overflows: overflows(model, plan),
            curved: model.cams().next().is_some(),
            motors: model
                .motors
                .iter()
                .map(|motor| model.joint(motor.joint).name.clone())
                .collect(),
            params: model
                .params
                .all()
                .iter()
                .map(|param| param.name.clone())
                .collect(),
            stored: stored.to_vec(),
            links: stored
                .iter()
                .map(|&link| model.link(link).name.clone())
                .collect(),
            poses,
            state,
            motion,
            sensitivity,
            live: Vec::new(),
            start,
        };
        program.forget_loops(idle);
        program.live = live(&program);
        program.cut_chains();
        calibrate(&mut program);
        program
    }
}
