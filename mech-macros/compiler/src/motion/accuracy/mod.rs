//! The accuracy of a mechanism, found by trying it; and, where an accuracy is declared, the cheapest way to solve each loop that keeps it.

mod growth;
mod influence;
mod trial;

use crate::cost::{self, Cost};
use crate::evaluate;
use crate::model::{Method, Model, Precision, Shown};
use crate::plan::Plan;
use crate::program::{
    AtZero, BlockKind, Choice, Newton, Program, Rounds, Solver, Watching, build_as,
};
use crate::structure::Diagnosis;
use influence::Influence;
use std::borrow::Cow;
use trial::{Exact, Rival, compare};

/// Between samples an error may be greater than any that was seen; more so where several motors move, because not every
/// combination is tried.
const SAFETY: [f64; 2] = [2.0, 4.0];
/// The same for rounding errors. These scatter from one position to the next and grow without bound towards dead points. Where several
/// motors move, most positions near dead points are never seen.
const ROUNDING_SAFETY: [f64; 2] = [8.0, 12.0];
/// The least error of rounding, in units of the last place of the greatest number that is computed with.
const LEAST_ROUNDING: f64 = 16.0;
/// More rounds than this are not promised: an iteration that needs more is better left to run until its loop closes.
const MOST_ROUNDS: u32 = 4;
/// The number of combinations of solvers that are tried. Each solver was good enough by itself.
const COMBINATIONS: usize = 6;

/// The accuracy of a mechanism: the greatest error of a place on its links, in scene units. An estimate from samples, with a
/// reserve; no bound.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Prediction {
    /// Of anything.
    pub error: f64,
    /// For each loop, of the links that wait for it and for no later one; infinite if it may stop where the mechanism could move
    /// on. None if it is exact to rounding, and so is everything before it.
    pub loops: Vec<Option<f64>>,
}

/// The method by which a loop is solved, and its accuracy.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SolvedLoop {
    /// Its number among the loops of the plan: some may be left out.
    pub number: usize,
    /// By which method, in words.
    pub method: String,
    /// The greatest error of links that wait for this loop and for no later one, in scene units, if it was estimated. Infinite if the
    /// loop may stop where the mechanism could move on.
    pub error: Option<f64>,
    /// Its operations.
    pub cost: Cost,
}

/// Lists the loops of a program, with their methods.
pub(crate) fn solved_loops(program: &Program, prediction: Option<&Prediction>) -> Vec<SolvedLoop> {
    let blocks = program.ssa.blocks.iter().filter_map(|block| match &block.kind {
        BlockKind::Straight => None,
        BlockKind::ClosedForm(closed) => Some((closed.number, "exact".to_owned())),
        BlockKind::Newton(newton) => Some((newton.number, method(newton))),
    });
    let of_loop = |((number, method), cost): ((usize, String), Cost)| SolvedLoop {
        number,
        method,
        error: prediction.and_then(|prediction| *prediction.loops.get(number)?),
        cost,
    };
    blocks.zip(cost::of_loops(program)).map(of_loop).collect()
}

fn method(newton: &Newton) -> String {
    match newton.rounds {
        Rounds::UntilClosed(_) => "Newton, until closed".to_owned(),
        Rounds::Exactly(_) if newton.linear => "linear".to_owned(),
        Rounds::Exactly(1) => "Newton, one round".to_owned(),
        Rounds::Exactly(rounds) => format!("Newton, {rounds} rounds"),
    }
}

/// Chooses for each loop the cheapest solver that keeps an accuracy. What is given is how the loops are solved at their most
/// exact, and how they are watched.
pub(crate) fn choose(
    model: &Model,
    plan: &Plan,
    exact: Vec<Choice>,
    accuracy: f64,
) -> Result<(Vec<Choice>, Prediction), Diagnosis> {
    let judge = Judge::new(model, plan, exact);
    if let Some(motor) = growth::growing(model, &judge.reference) {
        return Err(Diagnosis::EndlessAccuracy { accuracy, motor });
    }
    let mut candidates = judge.candidates();
    let mut rivals: Vec<Rival> = candidates
        .iter()
        .flatten()
        .map(|candidate| Rival::new(candidate.program.clone()))
        .collect();
    let mut exact_program = judge.reference.clone();
    // A mechanism that does not start is reported elsewhere.
    let starts = evaluate::settle(&mut exact_program).is_ok();
    let found = compare(&judge.model, plan, &exact_program, &mut rivals);
    let rounding = judge.rounding(&found);
    let least = greatest(&rounding);
    if starts && least > accuracy {
        return Err(Diagnosis::TooAccurate { accuracy, best: least });
    }
    for (candidate, rival) in candidates.iter_mut().flatten().zip(&rivals) {
        candidate.error = judge.safety() * rival.error();
    }
    for candidates in &mut candidates {
        candidates.retain(|candidate| candidate.error + least <= accuracy);
    }
    for _ in 0..COMBINATIONS {
        let choices = judge.with(&candidates);
        let prediction = judge.predict(&choices, Some(&rounding));
        if prediction.error <= accuracy {
            return Ok((choices, prediction));
        }
        tighten(&mut candidates);
    }
    let choices = judge.exact.clone();
    let prediction = Prediction { error: least, loops: vec![None; choices.len()] };
    Ok((choices, prediction))
}

/// Predicts the accuracy of a mechanism with these choices. None unless the steps are declared of all motors that move a loop with a fixed
/// number of rounds.
pub(crate) fn predict(model: &Model, plan: &Plan, choices: &[Choice]) -> Option<Prediction> {
    let counted = |choice: &Choice| {
        matches!(choice.solver, Solver::Linear | Solver::Newton(Rounds::Exactly(_)))
    };
    if !choices.iter().any(counted) || model.motors.iter().all(|motor| motor.step.is_none()) {
        return None;
    }
    let exact =
        choices.iter().map(|choice| Choice { solver: Solver::ClosedForm, ..choice.clone() });
    let judge = Judge::new(model, plan, exact.collect());
    if growth::growing(model, &judge.reference).is_some() {
        return None;
    }
    let mut loops = choices.iter().enumerate();
    let known = loops.all(|(number, choice)| !counted(choice) || judge.is_stepped(number));
    known.then(|| judge.predict(choices, None))
}

/// A way to solve a loop that costs less than the most exact one.
struct Candidate {
    solver: Solver,
    program: Program,
    weight: f64,
    error: f64,
}

/// Drops the cheapest candidate of the loop that is farthest off.
fn tighten(candidates: &mut [Vec<Candidate>]) {
    let worst = candidates
        .iter_mut()
        .filter(|candidates| !candidates.is_empty())
        .max_by(|a, b| a[0].error.total_cmp(&b[0].error));
    if let Some(candidates) = worst {
        let error = candidates[0].error;
        candidates.retain(|candidate| candidate.error < error);
    }
}

fn greatest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// Knows the most exact program of a mechanism, and compares others with it.
struct Judge<'m> {
    /// The mechanism, with everything shown that any solver begins with: the programs take over each other's positions.
    model: Cow<'m, Model>,
    plan: &'m Plan,
    exact: Vec<Choice>,
    /// The most exact program, without watching what is only watched for dead points: then others carry the same numbers from
    /// position to position as this one does.
    reference: Program,
    on_loops: Vec<Influence>,
    on_links: Vec<Influence>,
}

impl<'m> Judge<'m> {
    fn new(model: &'m Model, plan: &'m Plan, exact: Vec<Choice>) -> Self {
        let model = with_all_kept(model, plan, &exact);
        let reference = build_as(&model, plan, &without_watching(&exact));
        Self {
            on_loops: Influence::on_loops(&reference, exact.len()),
            on_links: Influence::on_links(&reference, exact.len()),
            model,
            plan,
            exact,
            reference,
        }
    }

    /// Whether the steps of all motors are declared that move a loop.
    fn is_stepped(&self, number: usize) -> bool {
        let moved = self.model.motors.iter().zip(&self.on_loops[number].motors);
        moved.filter(|(_, moves)| **moves).all(|(motor, _)| motor.step.is_some())
    }

    fn safety(&self) -> f64 {
        SAFETY[self.several()]
    }

    /// One if several motors move, else zero.
    fn several(&self) -> usize {
        usize::from(self.model.motors.len() > 1)
    }

    /// For each loop the solvers that cost less than the most exact one, the cheapest first.
    fn candidates(&self) -> Vec<Vec<Candidate>> {
        let weigh = |program: &Program| {
            cost::weight(cost::of_program(program), self.model.target, self.model.precision)
        };
        let most = weigh(&self.reference);
        let of_loop = |number: usize| {
            let choice = &self.exact[number];
            // A dyad passes change points in closed form or not at all, and only of a closed form it is proved that it moves through
            // a range.
            let ranged = self.model.motors.iter().any(|motor| motor.range.is_some());
            let mut loops = self.plan.loops();
            let is_coupled = loops.nth(number).is_some_and(|one| one.rings.len() > 1);
            if changes(choice) && !is_coupled || ranged {
                return Vec::new();
            }
            let until_closed = Choice::by(Method::Newton).solver;
            let counted = (1..=MOST_ROUNDS).map(|rounds| Solver::Newton(Rounds::Exactly(rounds)));
            let counted = std::iter::once(Solver::Linear).chain(counted);
            let solvers = counted.filter(|_| self.is_stepped(number)).chain([until_closed]);
            let candidate = |solver: Solver| {
                let mut choices = without_watching(&self.exact);
                choices[number].solver = solver;
                let program = build_as(&self.model, self.plan, &choices);
                Candidate { weight: weigh(&program), error: f64::INFINITY, solver, program }
            };
            let mut candidates: Vec<Candidate> =
                solvers.map(candidate).filter(|candidate| candidate.weight < most).collect();
            candidates.sort_by(|a, b| a.weight.total_cmp(&b.weight));
            candidates
        };
        (0..self.exact.len()).map(of_loop).collect()
    }

    /// The cheapest candidate of each loop, or what is most exact.
    fn with(&self, candidates: &[Vec<Candidate>]) -> Vec<Choice> {
        let choices = self.exact.iter().zip(candidates);
        let choice = |(exact, candidates): (&Choice, &Vec<Candidate>)| {
            let solver = candidates.first().map(|candidate| candidate.solver);
            Choice { solver: solver.unwrap_or(exact.solver), ..exact.clone() }
        };
        choices.map(choice).collect()
    }

    /// Tries a program.
    fn predict(&self, choices: &[Choice], rounding: Option<&[f64]>) -> Prediction {
        let is_exact: Vec<bool> =
            choices.iter().map(|choice| choice.solver == Solver::ClosedForm).collect();
        let all = is_exact.iter().all(|exact| *exact);
        let mut rivals = Vec::new();
        if !all {
            let program = build_as(&self.model, self.plan, &without_watching(choices));
            rivals.push(Rival::new(program));
        }
        let rounding = match rounding {
            Some(rounding) if all => rounding.to_vec(),
            _ => self.rounding(&compare(&self.model, self.plan, &self.reference, &mut rivals)),
        };
        let mut errors = rounding;
        for rival in &rivals {
            for (error, worst) in errors.iter_mut().zip(&rival.worst) {
                *error += self.safety() * worst;
                if rival.stopped {
                    *error = f64::INFINITY;
                }
            }
        }
        let of_loop = |number: usize| {
            let before = self.on_loops[number].loops.iter().zip(&is_exact);
            if before.filter(|(needed, _)| **needed).all(|(_, exact)| *exact) {
                return None;
            }
            let links = self.on_links.iter().zip(&errors);
            let own = links
                .filter(|(link, _)| link.loops.iter().rposition(|needed| *needed) == Some(number));
            Some(own.map(|(_, error)| *error).fold(0.0, f64::max))
        };
        Prediction { loops: (0..choices.len()).map(of_loop).collect(), error: greatest(&errors) }
    }

    /// For each link the error that rounding makes, from what it is in single precision.
    fn rounding(&self, found: &Exact) -> Vec<f64> {
        let epsilon = self.model.precision.epsilon();
        let least = LEAST_ROUNDING * epsilon * found.reach;
        let part = ROUNDING_SAFETY[self.several()] * epsilon / Precision::F32.epsilon();
        let of_link = |single: &f64| {
            if found.seen { least + part * single } else { 4.0 * least }
        };
        found.single.iter().map(of_link).collect()
    }
}

/// The mechanism with everything shown that its loops begin with, however they are solved.
fn with_all_kept<'m>(model: &'m Model, plan: &Plan, exact: &[Choice]) -> Cow<'m, Model> {
    if model.show.is_none() {
        return Cow::Borrowed(model);
    }
    let iterated: Vec<Choice> = exact.iter().map(|_| Choice::by(Method::Newton)).collect();
    let iterated = build_as(model, plan, &iterated);
    let shown = iterated.stored.iter().map(|&link| Shown::Link(link));
    let mut state = model.clone();
    state.show = Some(shown.collect());
    Cow::Owned(state)
}

/// Whether a loop does more at change points than keep its branch.
fn changes(choice: &Choice) -> bool {
    matches!(&choice.watching, Some(watching) if watching.at_zero != AtZero::Stay)
}

/// The same, but nothing is watched except for change points, and nothing is predicted from steps before: that helps only as long
/// as the steps are equal.
fn without_watching(choices: &[Choice]) -> Vec<Choice> {
    let unwatched = |choice: &Choice| {
        let watching: Option<Watching> = choice.watching.clone().filter(|_| changes(choice));
        Choice { watching, predictor: 0, ..choice.clone() }
    };
    choices.iter().map(unwatched).collect()
}

#[cfg(test)]
mod tests;
