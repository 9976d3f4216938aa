//! The driver: it builds a program, watches it move, and builds it again with what it learnt.
//!
//! ```text
//! structure → plan → program ──────────────→ closure ─────→ Compiled
//!                     │    ↑ choices: solver and watching of each loop
//!                     └→ motion: watching, accuracy, proof of ranges
//! ```

mod change_point_start;
mod closure;
mod inverse;
mod lead;
mod least;
mod overconstrained;
mod overflow;
mod surplus;
mod trajectory;

use crate::bug::bug;
use crate::compiled::{Compiled, ForcePrograms};
use crate::cost::{self, Cost};
use crate::evaluate::{self, Machine, Stop};
use crate::model::{JointId, JointKind, Model, Motor, MotorId, Number, ScaleTrouble};
use crate::motion::accuracy::{self, Prediction};
use crate::motion::near_miss::near_misses;
use crate::motion::proof;
use crate::motion::watching::{self, Decisions};
use crate::plan::{self, Plan};
use crate::program::{self, BlockId, Choice, Forces, Newton, Op, Output, Program};
use crate::report;
use crate::structure::{self, Diagnosis, Structure};
pub use inverse::Unreachable;
pub use lead::{lead, led_place};
use overconstrained::Overconstrained;

/// Analyses a mechanism and builds its programs.
///
/// # Errors
/// Everything that keeps the mechanism from moving as its motors say.
pub fn compile(model: &Model) -> Result<Compiled, Vec<Diagnosis>> {
    let Coherent { structure, plan, program, choices, prediction } =
        analyse(model, Depth::WholeMotion)?;
    closure::check(model, &structure, &program);
    let derive = |output: Output<'_>| derive(model, &plan, &choices, &program, output);
    let moving = derive(Output::Rates);
    let forced = ForcePrograms {
        holding: derive(Output::Holding),
        inverse_dynamics: derive(Output::InverseDynamics(&structure)),
        inertia: derive(Output::Inertia),
    };
    let sensitive = derive(Output::Sensitivity);
    let inverse =
        inverse::invert(model, &program, moving.as_ref()).map_err(|diagnosis| vec![diagnosis])?;
    let loops = accuracy::solved_loops(&program, prediction.as_ref());
    let saved = saved_cost(model, &plan, &program, &choices);
    let mut compiled = Compiled {
        near_misses: near_misses(model, &plan, &program),
        notes: Vec::new(),
        structure,
        plan,
        program,
        moving,
        forced,
        timing: program::build_timing(model),
        sensitive,
        inverse,
        loops,
        prediction,
        saved,
        report: String::new(),
    };
    trajectory::check(model, &compiled).map_err(|diagnosis| vec![diagnosis])?;
    if let Some(overflow) = overflow::overflow(model, &compiled) {
        return Err(vec![overflow]);
    }
    let inertia = compiled.forced.inertia.as_ref();
    let massless = inertia.map_or(Vec::new(), massless_motors);
    if !massless.is_empty() {
        return Err(vec![Diagnosis::Massless { motors: massless }]);
    }
    compiled.notes = report::notes(model, &compiled);
    compiled.report = report::report(model, &compiled);
    Ok(compiled)
}

/// The program of something besides positions, if it is asked for.
fn derive(
    model: &Model,
    plan: &Plan,
    choices: &[Choice],
    program: &Program,
    output: Output<'_>,
) -> Option<Program> {
    let derived = program::derive(model, plan, choices, program, output)?;
    Some(Program { start: program.start.clone(), range: program.range.clone(), ..derived })
}

/// Checks whether a mechanism compiles, as far as its start shows: declared ranges and accuracies are not examined.
///
/// # Errors
/// As [`compile`].
pub(crate) fn check(model: &Model) -> Result<(), Vec<Diagnosis>> {
    let coherent = analyse(model, Depth::Start)?;
    let moving = || {
        let (plan, choices) = (&coherent.plan, &coherent.choices);
        derive(model, plan, choices, &coherent.program, Output::Rates)
    };
    inverse::check(model, &coherent.program, moving).map_err(|diagnosis| vec![diagnosis])
}

/// The motors that move nothing that has a mass.
fn massless_motors(inertia: &Program) -> Vec<MotorId> {
    let Some(Forces::Inertia(found)) = inertia.forces() else {
        bug!("a program for the inertia does not compute it");
    };
    let zero = Op::Constant(Number::new(0.0));
    let rows = found.matrix.iter().enumerate();
    rows.filter(|&(motor, row)| inertia.node(row[motor]).op == zero)
        .map(|(motor, _)| MotorId::new(motor))
        .collect()
}

/// The operations that are saved where `show` leaves something out; none if nothing is left out.
fn saved_cost(model: &Model, plan: &Plan, program: &Program, choices: &[Choice]) -> Option<Cost> {
    model.show.as_ref()?;
    let everything = Model { show: None, ..model.clone() };
    let whole = program::build_as(&everything, plan, choices);
    let saved = cost::of_program(&whole).without(cost::of_program(program));
    let needed = program::find_needed(model, plan, &program.stored);
    let all_needed = needed.steps.iter().all(|needed| *needed)
        && program.solved_loops().len() == plan.loops().count();
    (!all_needed || saved != Cost::default()).then_some(saved)
}

/// The depth to which a mechanism is examined.
#[derive(Clone, Copy, PartialEq)]
enum Depth {
    /// At its start.
    Start,
    /// Through its whole motion.
    WholeMotion,
}

/// A mechanism that was found coherent, with the program that moves it.
struct Coherent {
    structure: Structure,
    plan: Plan,
    program: Program,
    /// The choice for each loop of the plan.
    choices: Vec<Choice>,
    prediction: Option<Prediction>,
}

fn analyse(model: &Model, depth: Depth) -> Result<Coherent, Vec<Diagnosis>> {
    if !model.fits() {
        return Err(vec![Diagnosis::TooLarge]);
    }
    match model.scale_trouble() {
        Some(ScaleTrouble::TooLarge) => return Err(vec![Diagnosis::TooLarge]),
        Some(ScaleTrouble::TooSmall) => return Err(vec![Diagnosis::TooSmall]),
        None => {}
    }
    let coherent = match structure::analyse(model) {
        Ok(structure) => analyse_generic(model, structure, depth)?,
        Err(diagnoses) => analyse_overconstrained(model, diagnoses, depth)?,
    };
    if coherent.program.fits() { Ok(coherent) } else { Err(vec![Diagnosis::TooLarge]) }
}

/// Analyses a mechanism that moves whatever its lengths.
fn analyse_generic(
    model: &Model,
    structure: Structure,
    depth: Depth,
) -> Result<Coherent, Vec<Diagnosis>> {
    let plan = match plan::plan(model, &structure) {
        Ok(plan) => plan,
        Err(dead @ Diagnosis::DeadStart { .. }) => {
            return match analyse_change_point_start(model, structure, depth) {
                Some(Ok(coherent)) => Ok(coherent),
                Some(Err(
                    cause @ (Diagnosis::TooAccurate { .. }
                    | Diagnosis::EndlessAccuracy { .. }
                    | Diagnosis::Range { .. }),
                )) => Err(vec![cause]),
                Some(Err(_)) | None => Err(vec![dead]),
            };
        }
        Err(diagnosis) => return Err(vec![diagnosis]),
    };
    build(model, structure, plan, depth).map_err(|diagnosis| vec![diagnosis])
}

/// Analyses a mechanism that starts at a change point: it is assembled beside it and moved there.
fn analyse_change_point_start(
    model: &Model,
    structure: Structure,
    depth: Depth,
) -> Option<Result<Coherent, Diagnosis>> {
    let plan = change_point_start::plan_beside(model, &structure)?;
    let mut coherent = match build(model, structure, plan, depth) {
        Ok(coherent) => coherent,
        Err(diagnosis) => return Some(Err(diagnosis)),
    };
    let mut machine = Machine::<f64>::new(&coherent.program);
    machine.move_to(&change_point_start::motors(model)).ok()?;
    let start = machine.position().clone();
    coherent.program.start = start;
    Some(Ok(coherent))
}

/// Builds the program of a planned mechanism, at its start.
fn build(
    model: &Model,
    structure: Structure,
    mut plan: Plan,
    depth: Depth,
) -> Result<Coherent, Diagnosis> {
    let choices = plan.loops().map(|_| Choice::declared(model)).collect();
    let (mut choices, prediction) = match depth {
        Depth::Start => (choices, None),
        Depth::WholeMotion => choose_by_motion(model, &mut plan, choices)?,
    };
    let mut program = program::build_as(model, &plan, &choices);
    let mut blocks = program.block_ids();
    let dead = |block: &BlockId| program.newton(*block).is_some_and(Newton::starts_dead);
    if let Some(block) = blocks.find(dead) {
        return Err(diagnose_start(&plan, &program, Stop::DeadPoint(block)));
    }
    if let Err(stop) = evaluate::settle(&mut program) {
        return Err(diagnose_start(&plan, &program, stop));
    }
    if depth == Depth::WholeMotion {
        (program, choices) = proof::prove_ranges(model, &plan, choices, program)?;
    }
    Ok(Coherent { structure, plan, program, choices, prediction })
}

/// Chooses how each loop is solved and watched, from how the mechanism moves.
fn choose_by_motion(
    model: &Model,
    plan: &mut Plan,
    choices: Vec<Choice>,
) -> Result<(Vec<Choice>, Option<Prediction>), Diagnosis> {
    let Decisions { choices, turning } = watching::decide(model, plan, choices);
    plan.turning = turning;
    if let Some(accuracy) = model.accuracy {
        let (choices, prediction) = accuracy::choose(model, plan, choices, accuracy)?;
        return Ok((choices, Some(prediction)));
    }
    let prediction = accuracy::predict(model, plan, &choices);
    Ok((choices, prediction))
}

/// Analyses a mechanism that moves, if it does, only because its lengths match.
fn analyse_overconstrained(
    model: &Model,
    diagnoses: Vec<Diagnosis>,
    depth: Depth,
) -> Result<Coherent, Vec<Diagnosis>> {
    let is_held = |diagnosis: &Diagnosis| {
        matches!(
            diagnosis,
            Diagnosis::Blocked { .. }
                | Diagnosis::Overdetermined { .. }
                | Diagnosis::TooManyMotors { .. }
        )
    };
    if let [Diagnosis::Rigid] = diagnoses[..] {
        return Err(missing_motor(model).map_or(diagnoses, |missing| vec![missing]));
    }
    let found = if diagnoses.iter().all(is_held) { overconstrained::assemble(model) } else { None };
    let Some(Overconstrained { mut structure, plan, waits }) = found else {
        return Err(diagnoses);
    };
    structure.redundant = too_many(&structure.redundant, &diagnoses);
    let joints = structure.redundant.clone();
    let mut params = model.params.ids();
    if let Some(param) = params.find(|&id| model.param_scale(id).is_some()) {
        return Err(vec![Diagnosis::OverconstrainedWithParam { joints, param }]);
    }
    match waits {
        _ if !model.allow.redundant => {
            Err(vec![Diagnosis::Overdetermined { joints, is_mobile: true }])
        }
        Some(waits) => Err(vec![waits]),
        None => build(model, structure, plan, depth).map_err(|diagnosis| vec![diagnosis]),
    }
}

/// So many joints, over the square of their number, are tried for a motor where counting leaves no freedom. Each trial costs more in a
/// larger mechanism.
const MOST_MOVED: usize = 40_000;

/// A mechanism that counting finds rigid may only lack a motor, if its lengths match: the joints that could have it.
fn missing_motor(model: &Model) -> Option<Diagnosis> {
    let can_have_motor = |joint: &JointId| {
        let joint = model.joint(*joint);
        matches!(joint.kind, JointKind::Revolute(..) | JointKind::Prismatic(..)) && !joint.hidden
    };
    let driven = |joint| {
        let mut driven = model.clone();
        let motor = Motor::new(joint, model.joint(joint).origin);
        driven.motors.push(motor);
        driven
    };
    let moves = |joint: JointId| {
        let found = overconstrained::assemble(&driven(joint))?;
        Some((joint, found.waits.is_some()))
    };
    // Each of them is assembled and moved: in a large mechanism not all are tried.
    let most = MOST_MOVED.div_ceil(model.joints.len().pow(2).max(1));
    let joints = model.joint_ids().filter(can_have_motor).take(most);
    let found: Vec<(JointId, bool)> = joints.filter_map(moves).collect();
    // Motors that leave nothing to be solved together come before those that do.
    let all_wait = found.iter().all(|(_, waits)| *waits);
    let wanted = found.iter().filter(|(_, waits)| *waits == all_wait);
    let candidates: Vec<JointId> = wanted.map(|(joint, _)| *joint).collect();
    (!candidates.is_empty()).then_some(Diagnosis::NoMotor { freedom: 1, candidates })
}

/// The joints that hold too much: those that were not needed and stand in the diagnoses. If none is both, those that were not needed, or
/// else those of the diagnoses.
fn too_many(idle: &[JointId], diagnoses: &[Diagnosis]) -> Vec<JointId> {
    let mut held: Vec<JointId> = diagnoses.iter().flat_map(held_joints).collect();
    held.sort_unstable();
    held.dedup();
    let both = idle.iter().copied().filter(|joint| held.contains(joint));
    let both: Vec<JointId> = both.collect();
    match (both.is_empty(), idle.is_empty()) {
        (false, _) => both,
        (true, false) => idle.to_vec(),
        (true, true) => held,
    }
}

fn held_joints(diagnosis: &Diagnosis) -> Vec<JointId> {
    match diagnosis {
        Diagnosis::Overdetermined { joints, .. } | Diagnosis::Blocked { joints, .. } => {
            joints.clone()
        }
        _ => Vec::new(),
    }
}

/// Diagnoses a mechanism that its plan assembles but its program does not: a loop starts where its equations are singular.
fn diagnose_start(plan: &Plan, program: &Program, stop: Stop) -> Diagnosis {
    let number = match stop {
        Stop::Open(block) | Stop::DeadPoint(block) => program.loop_of(block),
        _ => None,
    };
    match number.and_then(|number| plan.loops().nth(number)) {
        Some(ring) => Diagnosis::DeadStart { unknowns: ring.unknowns() },
        None => Diagnosis::TooLarge,
    }
}
