//! From the plan to the program.

mod cam;
mod closing;
mod continuous;
mod dyad;
mod equilibrium;
mod idle;
mod inverse_dynamics;
mod iteration;
mod last;
mod linear;
mod lowering;
mod max_step;
mod pass;
mod predictor;
mod rates;
mod reaction;
mod sensitivity;
mod size;
mod sources;
mod steps;
mod tangent;
mod tied;
mod ties;
mod triad;
mod turning;
mod virtual_work;
mod watching;
mod wrench;

pub(super) use tangent::{Seed, Tangents};

use super::builder::SsaBuilder;
use super::calibrate::calibrate;
use super::live::live;
use super::node::{BlockId, Value};
use super::{Block, BlockKind, Choice, Derived, Forces, LinearEquations, Program, Results, Rounds};
use crate::model::{Joint, JointKind, LinkId, Model};
use crate::plan::{Equation, Loop, Plan, PlanPart, Rational, Solution, Step};
use crate::structure::Structure;
use lowering::Lowering;
use num_traits::Signed;
use pass::{Follower, PositionPass};
use sources::Angle;
use tied::Tied;

/// Builds the program of a planned mechanism, with every loop solved by the method that the model says.
#[must_use]
pub fn build(model: &Model, plan: &Plan) -> Program {
    build_as(model, plan, &[])
}

/// Builds the program of a planned mechanism, with a choice for each loop. A loop without a choice is solved by the method that the model
/// says. The program leaves out what nothing that is shown depends on.
#[must_use]
pub fn build_as(model: &Model, plan: &Plan, choices: &[Choice]) -> Program {
    let mut links = model.asked_links();
    loop {
        let lower = |idle: &[usize]| {
            let target = Target { links: &links, idle, output: None };
            target.lower(model, plan, choices)
        };
        let mut program = lower(&[]);
        let idle = program.idle_loops(model, plan);
        if !idle.is_empty() {
            program = lower(&idle);
        }
        // The links with which an iteration begins have to be known too.
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

/// Builds the program that computes this output from positions, of the same links and loops as the program to positions; none if no
/// effect asks for it.
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
    let target = Target { links: &positions.stored, idle: &idle, output: Some(output) };
    let mut program = target.lower(model, plan, choices);
    program.number_stored();
    // Where joints hold links more than once, equilibrium does not determine what they do.
    program.derived.is_some().then_some(program)
}

/// A result of a program besides positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Output<'s> {
    /// The rates of everything.
    Rates,
    /// The torques and forces of motors that hold it at rest.
    Holding,
    /// The torques and forces of motors that a given motion takes, and the reactions in all joints of this structure, of which none is
    /// redundant.
    InverseDynamics(&'s Structure),
    /// The inertia and forces that its motors feel.
    Inertia,
    /// The rates of everything with each param.
    Sensitivity,
}

/// The steps that something that is shown depends on.
#[must_use]
pub(crate) fn find_needed(model: &Model, plan: &Plan, stored: &[LinkId]) -> PlanPart {
    match model.show {
        None => plan.whole(),
        Some(_) => plan.find_needed(model, stored),
    }
}

/// The results that a program is built for.
#[derive(Clone, Copy)]
struct Target<'t> {
    /// The links whose poses it finds.
    links: &'t [LinkId],
    /// The loops, by number, whose solution nothing needs: it does not solve them.
    idle: &'t [usize],
    output: Option<Output<'t>>,
}

impl Target<'_> {
    /// Lowers a plan to a program; poses are numbered among those of all links.
    fn lower(self, model: &Model, plan: &Plan, choices: &[Choice]) -> Program {
        let needed = find_needed(model, plan, self.links);
        let mut pass = PositionPass::new(model, plan);
        let (mut meshes, mut loops) = (0, 0);
        for (step, is_needed) in plan.steps.iter().zip(&needed.steps) {
            match step {
                step if !is_needed => pass.read_sources(step, &needed.sources),
                Step::Weld(weld) => pass.weld(weld),
                Step::Drive(drive) => pass.drive(drive),
                Step::Mesh(mesh) => pass.mesh(mesh, plan.start.meshes[meshes]),
                Step::Cam(cam) => pass.cam(cam),
                Step::Close(closing) => {
                    pass.close(closing, loops, self.choice(model, choices, loops));
                }
            }
            meshes += usize::from(matches!(step, Step::Mesh(_)));
            loops += usize::from(matches!(step, Step::Close(_)));
        }
        self.finish(pass)
    }

    /// The program of a plan whose steps are lowered.
    fn finish(self, pass: PositionPass<'_>) -> Program {
        let PositionPass {
            mut lowering,
            mut watches,
            sources,
            continuous,
            followers,
            mut loops,
            ..
        } = pass;
        continuous.carry(&mut lowering, &mut watches);
        lowering.carry_motion_signs(&watches);
        lowering.carry_places();
        let (model, plan) = (lowering.model, lowering.plan);
        let winds = loops.iter().any(SolvedLoop::counts_turns);
        let wanders = followers.iter().any(|follower| follower.wanders);
        loops.retain(|solved| !self.idle.contains(&solved.number));
        let found = |solved: &SolvedLoop| (solved.number, solved.solution.clone());
        let solutions = loops.iter().map(found).collect();
        let positions = Positions { loops, followers, angles: sources.angles };
        let pose = |&link: &LinkId| lowering.placement.pose(link).numbers();
        let mut poses: Vec<[Value; 4]> = self.links.iter().map(pose).collect();
        let derived = self.derive(&mut lowering, &positions, &poses);
        let Lowering { ssa, layout, .. } = lowering;
        let SsaBuilder { ssa, start, mut state, .. } = ssa;
        if matches!(self.output, Some(Output::Sensitivity)) {
            // It computes nothing else.
            state.clear();
            poses.clear();
        }
        let leaps = |block: &Block| {
            matches!(&block.kind, BlockKind::Newton(newton)
                if newton.step.is_some() && matches!(newton.rounds, Rounds::UntilClosed(_)))
        };
        let has_loops = ssa.blocks.iter().any(|block| block.loop_number().is_some());
        let varies = (wanders || !model.params.is_empty()) && has_loops;
        let is_coupled = ssa.blocks.iter().any(leaps);
        let max_steps =
            (winds || varies || is_coupled).then(|| max_step::max_steps(model, plan, is_coupled));
        let motors = model.motors.iter();
        let params = model.params.all().iter();
        let stored = self.links.iter();
        let mut program = Program {
            name: model.name.clone(),
            precision: model.precision,
            ssa,
            layout,
            solutions,
            watches: watches.loops,
            follows: watches.follows,
            followed: watches.angles,
            max_steps,
            reduced: reduced_inputs(model, plan),
            overflows: overflows(model, plan),
            curved: model.cams().next().is_some(),
            motors: motors.map(|motor| model.joint(motor.joint).name.clone()).collect(),
            params: params.map(|param| param.name.clone()).collect(),
            stored: self.links.to_vec(),
            links: stored.map(|&link| model.link(link).name.clone()).collect(),
            poses,
            state,
            derived,
            start,
            ..Program::default()
        };
        program.forget_loops(self.idle);
        program.live = live(&program);
        program.cut_chains();
        calibrate(&mut program);
        program
    }

    /// Derives the output from positions: none if there is none, or if it is not determined.
    fn derive(
        self,
        lowering: &mut Lowering<'_>,
        positions: &Positions,
        poses: &[[Value; 4]],
    ) -> Option<Derived> {
        let mut equations = LinearEquations::default();
        let forces = |forces, lowering: &Lowering<'_>| Results::Forces {
            forces,
            loads: lowering.model.actions.load_names(),
        };
        let results = match self.output? {
            Output::Sensitivity => {
                Results::Sensitivity(lowering.derive_sensitivity(positions, poses, &mut equations))
            }
            Output::Rates => {
                Results::Rates(lowering.derive_rates(positions, poses, &mut equations))
            }
            Output::Holding => {
                let torques = lowering.derive_holding(positions, &mut equations);
                forces(Forces::Holding(torques), lowering)
            }
            Output::InverseDynamics(structure) => {
                let found =
                    lowering.derive_inverse_dynamics(positions, structure, &mut equations)?;
                forces(Forces::InverseDynamics(found), lowering)
            }
            Output::Inertia => {
                let inertia = lowering.derive_inertia(positions, &mut equations);
                forces(Forces::Inertia(inertia), lowering)
            }
        };
        Some(Derived { equations, results })
    }

    /// The choice of a loop's solver and watch.
    fn choice(self, model: &Model, choices: &[Choice], number: usize) -> Choice {
        let otherwise = || Choice::declared(model);
        let choice = choices.get(number).cloned().unwrap_or_else(otherwise);
        if !self.idle.contains(&number) {
            return choice;
        }
        // It only says how its links hang together.
        Choice { watching: None, predictor: 0, ..choice }
    }
}

/// Everything that positions were found with: rates, forces and sensitivities are derived from it.
struct Positions {
    /// The loops that were solved, but for those whose solution nothing needs.
    loops: Vec<SolvedLoop>,
    /// The followers of cams.
    followers: Vec<Follower>,
    /// The angles between two links that gears and cams are solved from.
    angles: Vec<Angle>,
}

/// For each motor and param, whether its value is read less whole turns, and the turns apart from it. It is so where gears turn by a part
/// of it, and the model asks for an accuracy.
fn reduced_inputs(model: &Model, plan: &Plan) -> Vec<bool> {
    let asked = model.accuracy.is_some() || model.motors.iter().any(|motor| motor.step.is_some());
    let meshes = plan
        .steps
        .iter()
        .any(|step| matches!(step, Step::Mesh(_) | Step::Cam(_)) || ties_sources(step));
    let turning = model.motors.iter().map(|motor| {
        let turns = model.turns(motor.joint);
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

/// A loop that is being lowered.
struct LoopSite<'c> {
    /// Its number in the plan.
    number: usize,
    block: BlockId,
    choice: Choice,
    /// Whether it is solved by iteration.
    iterated: bool,
    closing: &'c Loop,
    equation: Equation<Value>,
    /// The base of its first cluster, from which its unknowns are seen.
    base: LinkId,
    /// The joints whose coordinates are unknown, for messages.
    place: String,
}

/// A loop that is solved.
struct SolvedLoop {
    /// The number of its loop in the plan.
    number: usize,
    /// The name of its block.
    name: String,
    /// The joints of the loop whose coordinates are unknown, for messages.
    place: String,
    equation: Equation<Value>,
    /// Its directions and displacements, in the order of the equation's unknowns.
    solution: Vec<Solution<Value>>,
    /// The relations of its directions and displacements to fewer unknowns, if rolling ties them.
    tied: Option<Tied>,
}

impl SolvedLoop {
    /// Whether an angle is among its unknowns that is counted over whole turns.
    fn counts_turns(&self) -> bool {
        self.tied.as_ref().is_some_and(Tied::counts_turns)
    }
}
