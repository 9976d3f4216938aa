//! What a requirement is about: the whole mechanism, or each of its details.

use super::case::Case;
use super::circumstances::Setting;
use super::sides::Ways;
use super::{Proof, Verdicts};
use crate::bug::bug;
use crate::compiled::Compiled;
use crate::model::{
    self, AxisId, Boundary, FormulaId, LinkId, Measured, Model, Quantity, RequiredBound,
    Requirement, Shape, Spot,
};
use crate::program::{Detail, clearance, corners};
use crate::structure::{RequirementTrouble, Witness};

/// Proves that bounds are kept wherever the motors may be.
pub(super) fn prove(
    model: &Model,
    compiled: &Compiled,
    verdicts: &Verdicts<'_>,
    ways: &Ways<'_>,
    requirement: &Requirement,
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<Proof, RequirementTrouble> {
    refuse_params(model, requirement)?;
    let setting = Setting::of(model, compiled, requirement)?;
    let timed = setting.timed();
    let in_time = timed.map(|timed| Verdicts::new(&timed.laws.program));
    let case = Case {
        model,
        compiled,
        ways,
        verdicts: in_time.as_ref().unwrap_or(verdicts),
        requirement,
        setting: &setting,
        detail: Detail::Whole,
    };
    let details = details(model, compiled, requirement);
    if let Some(links) = clear_links(requirement) {
        return prove_clear(case, (links, details), bounds);
    }
    if details.is_empty() {
        return Err(RequirementTrouble::NoDyad { unknowns: Vec::new() });
    }
    let effort = prove_each(case, details, bounds)?;
    Ok(Proof { effort })
}

/// Proves each detail; of those that fail, the worst place is told.
fn prove_each(
    case: Case<'_, '_>,
    details: Vec<Detail>,
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<usize, RequirementTrouble> {
    let mut answers = Answers::default();
    for detail in details {
        answers.add(Case { detail, ..case }.prove(bounds));
    }
    answers.of_all()
}

/// The two bodies that a requirement wants to keep clear, if it is about any.
fn clear_links(requirement: &Requirement) -> Option<[LinkId; 2]> {
    requirement.measured.iter().find_map(|measured| match measured {
        Measured::Quantity(Quantity::Clearance(links)) => Some(*links),
        _ => None,
    })
}

/// Each detail that a requirement is about.
pub(super) fn details(
    model: &Model,
    compiled: &Compiled,
    requirement: &Requirement,
) -> Vec<Detail> {
    if let Some(links) = clear_links(requirement) {
        let Some(boundaries) = Boundary::of_both(model, links) else {
            bug!("bodies without shapes are to keep clear");
        };
        let corners = 0..corners(&boundaries).len();
        return corners.map(Detail::Corner).collect();
    }
    let every = Measured::Quantity(Quantity::Transmission(None));
    if requirement.measured.contains(&every) {
        let dyads = 0..compiled.plan.loops().count();
        return dyads.map(Detail::Dyad).collect();
    }
    vec![Detail::Whole]
}

/// Proves that two bodies keep clear: of whatever is nearest, the nearest place is told.
fn prove_clear(
    case: Case<'_, '_>,
    (links, details): ([LinkId; 2], Vec<Detail>),
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<Proof, RequirementTrouble> {
    refuse_overlap(case, links)?;
    match prove_each(case, details, bounds) {
        Ok(effort) => Ok(Proof { effort }),
        // That it is not negative says nothing.
        Err(RequirementTrouble::Fails(worst)) => {
            let proved = worst.proved.filter(|proved| *proved > 0.0);
            Err(RequirementTrouble::Fails(Witness { proved, ..worst }))
        }
        Err(trouble) => Err(trouble),
    }
}

/// Refuses bodies that overlap where their motion begins. Later ones would touch first.
fn refuse_overlap(case: Case<'_, '_>, links: [LinkId; 2]) -> Result<(), RequirementTrouble> {
    let Case { model, compiled, requirement, setting, .. } = case;
    let program = &compiled.program;
    let mut place = setting.positions(compiled).start.motors.clone();
    for model::Case { motor, ends, .. } in &requirement.cases {
        place[motor.index()] = place[motor.index()].clamp(ends[0], ends[1]);
    }
    if let (Some(timed), Some([low, high])) = (setting.timed(), requirement.times) {
        let time = &mut place[timed.input()];
        *time = time.clamp(low, high);
    }
    let position = case.visit(&place).ok_or(RequirementTrouble::TooHard)?;
    let pose = |link: LinkId| match program.place_of(link) {
        Some(number) => position.poses[number],
        None => [1.0, 0.0, 0.0, 0.0],
    };
    if clearance(model, links, links.map(pose)) != Some(0.0) {
        return Ok(());
    }
    let at = case.place(&place, |_| true);
    Err(RequirementTrouble::Fails(Witness {
        value: 0.0,
        is_upper: false,
        proved: None,
        places: vec![at],
        is_in_time: setting.timed().is_some(),
        unknowns: Vec::new(),
    }))
}

/// Refuses what params place.
fn refuse_params(model: &Model, requirement: &Requirement) -> Result<(), RequirementTrouble> {
    let Some(param) = model.params.ids().next() else {
        return Ok(());
    };
    let depends = |axis: AxisId| {
        let axis = model.axis(axis);
        let mut formulas = axis.formulas.iter().chain(&axis.direction_formulas);
        formulas.any(Option::is_some)
    };
    let mut axes = requirement.measured.iter().flat_map(|measured| match *measured {
        Measured::Quantity(Quantity::X(axis) | Quantity::Y(axis)) => vec![axis],
        Measured::Quantity(Quantity::Distance(spots)) => {
            let axes = spots.iter().filter_map(|spot| match spot {
                Spot::Axis(axis) => Some(*axis),
                Spot::At(_) => None,
            });
            axes.collect()
        }
        Measured::Quantity(Quantity::Pressure(cam) | Quantity::Curvature(cam)) => {
            model.axes_of_contact(cam)
        }
        _ => Vec::new(),
    });
    let has_varying_shapes = |measured: &Measured| match measured {
        Measured::Quantity(Quantity::Clearance(links)) => {
            let mut shapes = links.iter().flat_map(|link| &model.link(*link).shapes);
            shapes.any(Shape::varies)
        }
        _ => false,
    };
    if axes.any(depends) || requirement.measured.iter().any(has_varying_shapes) {
        return Err(RequirementTrouble::Varies { param });
    }
    Ok(())
}

/// Answers for parts, all of which have to keep a requirement.
#[derive(Default)]
pub(super) struct Answers {
    effort: usize,
    worst: Option<Witness>,
    open: Option<RequirementTrouble>,
}

impl Answers {
    /// Takes the answer for a part: the intervals that were computed, or what is wrong there.
    pub(super) fn add(&mut self, answer: Result<usize, RequirementTrouble>) {
        match answer {
            Ok(effort) => self.effort += effort,
            Err(RequirementTrouble::Fails(witness)) => {
                self.worst = Some(match self.worst.take() {
                    Some(worst) => worse(worst, witness),
                    None => witness,
                });
            }
            Err(trouble) => {
                self.open.get_or_insert(trouble);
            }
        }
    }

    /// The answer for all parts: a place that breaks it is enough. Where parts are left open, no other limit is proved.
    pub(super) fn of_all(self) -> Result<usize, RequirementTrouble> {
        match (self.worst, self.open) {
            (Some(worst), open) => {
                let proved = worst.proved.filter(|_| open.is_none());
                Err(RequirementTrouble::Fails(Witness { proved, ..worst }))
            }
            (None, Some(trouble)) => Err(trouble),
            (None, None) => Ok(self.effort),
        }
    }
}

/// The worse of two places, with a limit that both parts keep. Where one is too great and the other too small, none is known.
fn worse(first: Witness, second: Witness) -> Witness {
    let is_upper = first.is_upper;
    let further = |a: f64, b: f64| if is_upper { a.max(b) } else { a.min(b) };
    let proved = first.proved.zip(second.proved);
    let proved = proved.filter(|_| second.is_upper == is_upper);
    let proved = proved.map(|(a, b)| further(a, b));
    let is_second =
        second.is_upper == is_upper && further(first.value, second.value) != first.value;
    let worst = if is_second { second } else { first };
    Witness { proved, ..worst }
}
