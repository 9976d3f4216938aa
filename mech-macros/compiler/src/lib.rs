//! Everything that thinks: from the text of a mechanism to the code that moves it.
//!
//! One stair, and data only ever walks down it:
//! `syntax → model → structure → plan → program → emit | evaluate`. The crate has two users: the macro `mechanism!`, which
//! calls [`expand`], and whoever analyses a [`Model`] made in another way, by [`compile`].

pub mod accuracy;
mod aligned;
mod bug;
pub mod certify;
pub mod cost;
mod digits;
mod emit;
pub mod evaluate;
mod extent;
pub mod graphs;
mod guard;
mod matched;
pub mod model;
pub mod plan;
pub mod program;
mod proof;
pub mod repair;
pub mod report;
pub mod reporter;
pub mod structure;
pub mod symbols;
pub mod syntax;
mod walk;
mod watching;

use accuracy::{Prediction, Solved};
use bug::bug;
use cost::Cost;
use evaluate::{Machine, Stop};
use matched::Matched;
use model::{JointId, JointKind, Model, MotorId, Number, ScaleTrouble};
use plan::Plan;
use proc_macro2::{Span, TokenStream, TokenTree};
use program::{Choice, Forces, Further, Op, Program, Timing};
use quote::quote;
use structure::{Diagnosis, Structure};
use syntax::{Message, Parsed, Place};
use watching::Decided;

/// A mechanism that was found coherent, and all that was found out about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// What is connected, what moves, what is trunk and what is arm.
    pub structure: Structure,
    /// In which order positions become known, and where everything is at the start.
    pub plan: Plan,
    /// The operations that move it.
    pub program: Program,
    /// The operations that move it and go on to velocities, if these were asked for.
    pub moving: Option<Program>,
    /// The operations that go on to forces, if these were asked for.
    pub forced: Forced,
    /// The laws of the motors, if any has one.
    pub timing: Option<Timing>,
    /// The operations that tell how everything follows the params, if that was asked for.
    pub sensitive: Option<Program>,
    /// How each loop is solved, in the order in which they are closed.
    pub loops: Vec<Solved>,
    /// How exact it will be, if an accuracy is declared, or if a loop is solved in a fixed number of steps and the steps of all
    /// motors are declared that move it.
    pub prediction: Option<Prediction>,
    /// What it saves that only what is shown is computed, if something is left out.
    pub saved: Option<Cost>,
    /// All of this in words.
    pub report: String,
}

/// The programs that go on from positions to forces, as far as these were asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forced {
    /// To what it takes to hold it at rest.
    pub holding: Option<Program>,
    /// To what it takes to move in a given way, in every joint; not where joints are redundant.
    pub acting: Option<Program>,
    /// To inertia and forces as the motors feel them.
    pub inertia: Option<Program>,
}

/// Analyses a mechanism and writes its program.
///
/// # Errors
/// Everything that keeps it from moving as its motors say.
pub fn compile(model: &Model) -> Result<Compiled, Vec<Diagnosis>> {
    let Coherent {
        structure,
        plan,
        program,
        choices,
        prediction,
    } = coherent(model, Depth::Whole)?;
    let further = |further: Further<'_>| {
        let written = program::build_further(model, &plan, &choices, &program, further)?;
        Some(Program {
            start: program.start.clone(),
            range: program.range.clone(),
            ..written
        })
    };
    let moving = further(Further::Rates);
    let forced = Forced {
        holding: further(Further::Holding),
        acting: further(Further::Acting(&structure)),
        inertia: further(Further::Inertia),
    };
    let massless = forced.inertia.as_ref().map_or(Vec::new(), massless);
    if !massless.is_empty() {
        return Err(vec![Diagnosis::Massless { motors: massless }]);
    }
    let sensitive = further(Further::Sensitivity);
    let loops = accuracy::solved(&program, prediction.as_ref());
    let saved = saved(model, &plan, &program, &choices);
    let timing = program::build_timing(model);
    let found = report::Found {
        program: &program,
        moving: moving.as_ref(),
        forced: &forced,
        timing: timing.as_ref(),
        sensitive: sensitive.as_ref(),
        loops: &loops,
        prediction: prediction.as_ref(),
        saved,
    };
    let report = report::report(model, &structure, &plan, found);
    Ok(Compiled {
        structure,
        plan,
        program,
        moving,
        forced,
        timing,
        sensitive,
        loops,
        prediction,
        saved,
        report,
    })
}

/// The motors that move nothing that has a mass.
fn massless(inertia: &Program) -> Vec<MotorId> {
    let forces = inertia
        .motion
        .as_ref()
        .and_then(|motion| motion.forces.as_ref());
    let Some(Forces::Inertia(found)) = forces else {
        bug!("a program for the inertia does not find it");
    };
    let nothing = Op::Constant(Number::new(0.0));
    let rows = found.matrix.iter().enumerate();
    rows.filter(|&(motor, row)| inertia.node(row[motor]).op == nothing)
        .map(|(motor, _)| MotorId::new(motor))
        .collect()
}

/// What it saves that only what is shown is computed.
fn saved(model: &Model, plan: &Plan, program: &Program, choices: &[Choice]) -> Option<Cost> {
    model.show.as_ref()?;
    let everything = Model {
        show: None,
        ..model.clone()
    };
    let whole = program::build_as(&everything, plan, choices);
    let saved = cost::of_program(&whole).without(cost::of_program(program));
    let needed = program::needed(model, plan, &program.stored);
    let all = needed.steps.iter().all(|needed| *needed)
        && program.solved_loops().len() == plan.loops().count();
    (!all || saved != Cost::default()).then_some(saved)
}

/// Whether a mechanism compiles, as far as its start tells: declared ranges and accuracies are not looked into.
///
/// # Errors
/// As [`compile`].
pub(crate) fn check(model: &Model) -> Result<(), Vec<Diagnosis>> {
    coherent(model, Depth::Start).map(drop)
}

/// How far a mechanism is looked into.
#[derive(Clone, Copy, PartialEq)]
enum Depth {
    /// To its start.
    Start,
    /// Through its whole motion.
    Whole,
}

fn coherent(model: &Model, depth: Depth) -> Result<Coherent, Vec<Diagnosis>> {
    if !model.fits() {
        return Err(vec![Diagnosis::TooLarge]);
    }
    match model.scale_trouble() {
        Some(ScaleTrouble::TooLarge) => return Err(vec![Diagnosis::TooLarge]),
        Some(ScaleTrouble::TooSmall) => return Err(vec![Diagnosis::TooSmall]),
        None => {}
    }
    let coherent = match structure::analyse(model) {
        Ok(structure) => regular(model, structure, depth)?,
        Err(diagnoses) => special(model, diagnoses, depth)?,
    };
    if coherent.program.fits() {
        Ok(coherent)
    } else {
        Err(vec![Diagnosis::TooLarge])
    }
}

/// A mechanism whose program is written.
struct Coherent {
    structure: Structure,
    plan: Plan,
    program: Program,
    /// How each loop of the plan is solved and watched.
    choices: Vec<Choice>,
    prediction: Option<Prediction>,
}

/// A mechanism that moves whatever its lengths.
fn regular(model: &Model, structure: Structure, depth: Depth) -> Result<Coherent, Vec<Diagnosis>> {
    let plan = match plan::plan(model, &structure) {
        Ok(plan) => plan,
        Err(dead @ Diagnosis::DeadStart { .. }) => {
            return match aligned(model, structure, depth) {
                Some(Ok(coherent)) => Ok(coherent),
                Some(Err(
                    told @ (Diagnosis::TooAccurate { .. }
                    | Diagnosis::EndlessAccuracy { .. }
                    | Diagnosis::Range { .. }),
                )) => Err(vec![told]),
                Some(Err(_)) | None => Err(vec![dead]),
            };
        }
        Err(diagnosis) => return Err(vec![diagnosis]),
    };
    written(model, structure, plan, depth).map_err(|diagnosis| vec![diagnosis])
}

/// A mechanism that starts at a change point: it is assembled beside it and moved there.
fn aligned(
    model: &Model,
    structure: Structure,
    depth: Depth,
) -> Option<Result<Coherent, Diagnosis>> {
    let plan = aligned::beside(model, &structure)?;
    let mut coherent = match written(model, structure, plan, depth) {
        Ok(coherent) => coherent,
        Err(diagnosis) => return Some(Err(diagnosis)),
    };
    let mut machine = Machine::<f64>::new(&coherent.program);
    machine.move_to(&aligned::start(model)).ok()?;
    let start = machine.position().clone();
    coherent.program.start = start;
    Some(Ok(coherent))
}

/// The program of a planned mechanism, at its start.
fn written(
    model: &Model,
    structure: Structure,
    mut plan: Plan,
    depth: Depth,
) -> Result<Coherent, Diagnosis> {
    let method = model.method.unwrap_or_default();
    let predictor = model.predictor;
    let chosen = |_| Choice {
        predictor,
        ..Choice::by(method)
    };
    let choices = plan.loops().map(chosen).collect();
    let (mut choices, prediction) = match depth {
        Depth::Start => (choices, None),
        Depth::Whole => chosen_by_motion(model, &mut plan, choices)?,
    };
    let mut program = program::build_as(model, &plan, &choices);
    if let Err(stop) = evaluate::settle(&mut program) {
        return Err(unsettled(&plan, &program, stop));
    }
    if depth == Depth::Whole {
        (program, choices) = proof::proved(model, &plan, choices, program)?;
    }
    Ok(Coherent {
        structure,
        plan,
        program,
        choices,
        prediction,
    })
}

/// How each loop is solved and watched, from how the mechanism moves.
fn chosen_by_motion(
    model: &Model,
    plan: &mut Plan,
    choices: Vec<Choice>,
) -> Result<(Vec<Choice>, Option<Prediction>), Diagnosis> {
    let Decided { choices, turning } = watching::decide(model, plan, choices);
    plan.turning = turning;
    if let Some(accuracy) = model.accuracy {
        let (choices, prediction) = accuracy::choose(model, plan, choices, accuracy)?;
        return Ok((choices, Some(prediction)));
    }
    let prediction = accuracy::predict(model, plan, &choices);
    Ok((choices, prediction))
}

/// A mechanism that moves, if it does, only because its lengths match.
fn special(
    model: &Model,
    diagnoses: Vec<Diagnosis>,
    depth: Depth,
) -> Result<Coherent, Vec<Diagnosis>> {
    let held = |diagnosis: &Diagnosis| {
        matches!(
            diagnosis,
            Diagnosis::Blocked { .. } | Diagnosis::Overdetermined { .. }
        )
    };
    if let [Diagnosis::Rigid] = diagnoses[..] {
        return Err(unless_matched(model, diagnoses));
    }
    let found = if diagnoses.iter().all(held) {
        matched::matched(model)
    } else {
        None
    };
    match found {
        None => Err(diagnoses),
        Some(Matched {
            mut structure,
            plan,
        }) => {
            if structure.redundant.is_empty() {
                structure.redundant = diagnoses.iter().flat_map(held_joints).collect();
                structure.redundant.sort_unstable();
                structure.redundant.dedup();
            }
            let joints = structure.redundant.clone();
            if let Some(param) = model
                .params
                .ids()
                .find(|&id| model.param_scale(id).is_some())
            {
                return Err(vec![Diagnosis::MatchedOnly { joints, param }]);
            }
            if model.allow.redundant {
                written(model, structure, plan, depth).map_err(|diagnosis| vec![diagnosis])
            } else {
                Err(vec![Diagnosis::Overdetermined {
                    joints,
                    matched: true,
                }])
            }
        }
    }
}

/// So many joints of a mechanism of one joint are tried for a motor where counting leaves no freedom; of a larger one fewer by the
/// square of its size.
const MOST_MOVED: usize = 40_000;

/// What counting finds rigid may only lack a motor, if its lengths match.
fn unless_matched(model: &Model, diagnoses: Vec<Diagnosis>) -> Vec<Diagnosis> {
    let turns = |joint: &JointId| {
        let joint = model.joint(*joint);
        matches!(
            joint.kind,
            JointKind::Revolute(..) | JointKind::Prismatic(..)
        ) && !joint.hidden
    };
    let moves = |joint: &JointId| matched::matched(&model.with_motor(*joint)).is_some();
    // Each of them is assembled and moved: in a large mechanism not all are tried.
    let most = MOST_MOVED.div_ceil(model.joints.len().pow(2).max(1));
    let joints = model.joint_ids().filter(turns).take(most);
    let candidates: Vec<JointId> = joints.filter(moves).collect();
    match candidates[..] {
        [] => diagnoses,
        _ => vec![Diagnosis::NoMotor {
            freedom: 1,
            candidates,
        }],
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

/// A loop that was assembled in closed form but does not close by its program starts where its equations are singular.
fn unsettled(plan: &Plan, program: &Program, stop: Stop) -> Diagnosis {
    let number = match stop {
        Stop::Open(block) | Stop::DeadPoint(block) => {
            program.newton(block).map(|newton| newton.number)
        }
        _ => None,
    };
    match number.and_then(|number| plan.loops().nth(number)) {
        Some(ring) => Diagnosis::DeadStart {
            unknowns: ring.unknowns(),
        },
        None => Diagnosis::TooLarge,
    }
}

/// Expands the body of a `mechanism!`: the path of the runtime crate, a semicolon, and the text of the mechanism.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    let (krate, body) = split(input);
    guard::guarded(
        &body,
        || expanded(&krate, body.clone()),
        || stub(&krate, body.clone()),
    )
}

/// What a mechanism expands to.
fn expanded(krate: &TokenStream, body: TokenStream) -> TokenStream {
    let Parsed {
        header,
        model,
        places,
        errors,
        motors,
        has_laws,
    } = syntax::parse(body);
    let Some(header) = header else {
        return all_errors(&errors);
    };
    let fail = |messages: &[Message]| {
        let (errors, stub) = (
            all_errors(messages),
            emit::stub(krate, &header, &places, &model, (motors, has_laws)),
        );
        quote!(#errors #stub)
    };
    if !errors.is_empty() {
        return fail(&errors);
    }
    match compile(&model) {
        Ok(compiled) => emit::items(krate, &header, &places, &model, &compiled),
        Err(diagnoses) => {
            let offers = repair::offers(&model, &diagnoses);
            fail(&reporter::messages(&diagnoses, &offers, &model, &places))
        }
    }
}

/// The type of a mechanism without what it does; nothing for a text without a header.
fn stub(krate: &TokenStream, body: TokenStream) -> TokenStream {
    let parsed = syntax::parse(body);
    let given = (parsed.motors, parsed.has_laws);
    parsed.header.map_or_else(TokenStream::new, |header| {
        emit::stub(krate, &header, &parsed.places, &parsed.model, given)
    })
}

fn all_errors(errors: &[Message]) -> TokenStream {
    if errors.is_empty() {
        let place = Place::at(Span::call_site());
        return Message::new(place, "this mechanism could not be read").to_compile_error();
    }
    errors.iter().map(Message::to_compile_error).collect()
}

/// The tokens before the first semicolon, and those after it.
fn split(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut trees = input.into_iter();
    let is_end =
        |tree: &TokenTree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ';');
    let krate = trees.by_ref().take_while(|tree| !is_end(tree)).collect();
    (krate, trees.collect())
}
