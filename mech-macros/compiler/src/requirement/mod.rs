//! Requirements: each is proved for every value of the motors, or refused with a place where it does not hold.
//!
//! What a requirement measures is added to the program of positions, and run on boxes of motor values. Boxes are cut where bounds are not
//! sharp enough, the least bound first, until all of them keep the condition or a place breaks it. That place is then visited as at run
//! time, from the start.

mod bound;
mod case;
mod circumstances;
mod course;
mod details;
mod domain;
mod proof;
mod search;
mod sides;
mod spread;
mod summing;
mod times;
mod turn;
mod waiting;

pub use spread::failing;

use crate::certify::cone::Cuts;
use crate::certify::{Interval, Verdict, certify};
use crate::compile::compile;
use crate::compiled::Compiled;
use crate::model::{
    Actions, Condition, Effects, Method, Model, MotorId, Precision, Quantity, Requirement,
};
use crate::motion::watching::Domain;
use crate::program::{Program, Value};
use crate::structure::{Diagnosis, RequirementTrouble};
use sides::Ways;
use std::cell::RefCell;

/// The proof of a requirement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// The intervals that were computed for it.
    pub effort: usize,
}

/// The requirements of a coherent mechanism that do not hold, or could not be proved.
#[must_use]
pub(crate) fn unmet(model: &Model, compiled: &Compiled) -> Vec<Diagnosis> {
    let judged = judge(model, compiled).into_iter();
    judged.filter_map(Result::err).collect()
}

/// For each requirement of a coherent mechanism its proof, or what is wrong with it.
#[must_use]
pub fn judge(model: &Model, compiled: &Compiled) -> Vec<Result<Proof, Diagnosis>> {
    if model.requirements.is_empty() {
        return Vec::new();
    }
    with_plain(model, compiled, |plain, compiled| {
        let verdicts = Verdicts::new(&compiled.program);
        let ways = Ways::new(&compiled.program);
        let requirements = model.requirements.iter().enumerate();
        let judged = requirements.map(|(requirement, one)| {
            let proof = match missing_effects(model.effects, one) {
                effects if effects.is_empty() => prove_one(plain, compiled, &verdicts, &ways, one),
                effects => Err(RequirementTrouble::NoEffect { effects }),
            };
            proof.map_err(|trouble| Diagnosis::Unmet { requirement, trouble })
        });
        judged.collect()
    })
}

/// Does something with a mechanism of which all links are found in closed form, if they can be.
fn with_plain<T>(
    model: &Model,
    compiled: &Compiled,
    act: impl FnOnce(&Model, &Compiled) -> T,
) -> T {
    let plain = plain(model);
    // In closed form it may be refused where it is not otherwise, as for a range that only that could prove.
    let plainly = (!is_plain(model)).then(|| compile(&plain).ok()).flatten();
    act(&plain, plainly.as_ref().unwrap_or(compiled))
}

/// The words of the effects that a requirement measures, and that are not declared.
fn missing_effects(effects: Effects, requirement: &Requirement) -> Vec<String> {
    let is_missing = |word: &&str| match *word {
        "velocity" => !effects.velocity,
        "acceleration" => !effects.acceleration,
        _ => !effects.force,
    };
    let words = requirement.effects().into_iter();
    words.filter(is_missing).map(str::to_owned).collect()
}

fn prove_one(
    model: &Model,
    compiled: &Compiled,
    verdicts: &Verdicts<'_>,
    ways: &Ways<'_>,
    requirement: &Requirement,
) -> Result<Proof, RequirementTrouble> {
    match &requirement.condition {
        Condition::Turns(motor) => turn::prove(model, compiled, verdicts, *motor),
        Condition::Bounds { subject, bounds, .. } => {
            details::prove(model, compiled, verdicts, ways, requirement, (*subject, bounds))
        }
    }
}

/// Whether the program of a mechanism finds all links in closed form, as well as it can.
fn is_plain(model: &Model) -> bool {
    model.show.is_none()
        && matches!(model.method, None | Some(Method::Exact))
        && model.accuracy.is_none()
        && model.precision == Precision::F64
}

/// The same mechanism, of which all links are found in closed form, and nothing else is computed but forces that are measured.
fn plain(model: &Model) -> Model {
    let measures = |is_wanted: fn(Quantity) -> bool| {
        let mut all = model.requirements.iter().flat_map(Requirement::quantities);
        all.any(is_wanted)
    };
    let force = model.effects.force && measures(Quantity::is_force);
    let actions = if force || measures(Quantity::takes_loads) {
        model.actions.clone()
    } else {
        Actions::default()
    };
    Model {
        show: None,
        method: None,
        accuracy: None,
        precision: Precision::F64,
        effects: Effects { force, ..Effects::default() },
        actions,
        traces: Vec::new(),
        requirements: Vec::new(),
        ..model.clone()
    }
}

/// A motor that has to make more turns than this until everything has turned as a whole needs a range.
const MOST_TURNS: f64 = 64.0 * std::f64::consts::TAU;

/// The turn of a motor after which some values are what they were; none if it slides, or if there is none that could be looked through.
fn round_of(
    model: &Model,
    program: &Program,
    (loops, motor): (usize, usize),
    found: &[Value],
) -> Option<f64> {
    if !model.turns(model.motor(MotorId::new(motor)).joint) {
        return None;
    }
    let domain = Domain::new(model, program, loops);
    // An angle that a law makes turns with all that the law is made from.
    let whole = Cuts { through: &|_| true, own: None, into: &|_| true };
    let read = domain.read(found, &whole);
    let period = domain.period(motor, &read);
    period.filter(|period| *period < MOST_TURNS)
}

/// Verdicts on whether a mechanism moves through values of its motors: each is found once for all requirements and their details.
struct Verdicts<'a> {
    program: &'a Program,
    known: RefCell<Vec<(Vec<Interval>, Verdict)>>,
}

impl<'a> Verdicts<'a> {
    fn new(program: &'a Program) -> Self {
        Self { program, known: RefCell::default() }
    }

    fn on(&self, values: &[Interval]) -> Verdict {
        let mut known = self.known.borrow_mut();
        if let Some((_, verdict)) = known.iter().find(|(on, _)| on == values) {
            return verdict.clone();
        }
        let verdict = certify(self.program, values);
        known.push((values.to_vec(), verdict.clone()));
        verdict
    }
}
