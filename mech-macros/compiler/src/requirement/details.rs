//! What a requirement is about: the whole mechanism, or each of its details.

use super::Proof;
use super::proof::{Case, visit};
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
    requirement: &Requirement,
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<Proof, RequirementTrouble> {
    refuse_params(model, requirement)?;
    let of_detail = |detail| Case {
        model,
        compiled,
        requirement,
        detail,
    };
    let mut quantities = requirement
        .measured
        .iter()
        .filter_map(|measured| match measured {
            Measured::Quantity(quantity) => Some(*quantity),
            _ => None,
        });
    let clear = quantities.clone().find_map(|quantity| match quantity {
        Quantity::Clearance(links) => Some(links),
        _ => None,
    });
    if let Some(links) = clear {
        return prove_clear(links, of_detail, bounds);
    }
    let mut details = vec![Detail::Whole];
    if quantities.any(|quantity| quantity == Quantity::Transmission(None)) {
        details = (0..compiled.plan.loops().count())
            .map(Detail::Dyad)
            .collect();
        if details.is_empty() {
            return Err(RequirementTrouble::NoDyad {
                unknowns: Vec::new(),
            });
        }
    }
    let mut effort = 0;
    for detail in details {
        effort += of_detail(detail).prove(bounds)?;
    }
    Ok(Proof { effort })
}

/// Proves that two bodies keep clear: of whatever is nearest, the nearest place is told.
fn prove_clear<'a>(
    links: [LinkId; 2],
    of_detail: impl Fn(Detail) -> Case<'a>,
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<Proof, RequirementTrouble> {
    let [Some(first), Some(second)] =
        links.map(|link| Boundary::of(of_detail(Detail::Whole).model, link))
    else {
        bug!("bodies without shapes are to keep clear");
    };
    let Case {
        model,
        compiled,
        requirement,
        ..
    } = of_detail(Detail::Whole);
    refuse_overlap(model, compiled, requirement, links)?;
    let mut effort = 0;
    let (mut worst, mut open): (Option<Witness>, _) = (None, None);
    for number in 0..corners(&[first, second]).len() {
        match of_detail(Detail::Corner(number)).prove(bounds) {
            Ok(own) => effort += own,
            Err(RequirementTrouble::Fails(own)) => {
                let proved = worst.as_ref().map_or(own.proved, |worst| {
                    worst.proved.zip(own.proved).map(|(a, b)| a.min(b))
                });
                let nearest = match worst {
                    Some(worst) if worst.value <= own.value => worst,
                    _ => own,
                };
                // That it is not negative says nothing.
                let proved = proved.filter(|proved| *proved > 0.0);
                worst = Some(Witness { proved, ..nearest });
            }
            Err(trouble) => open = open.or(Some(trouble)),
        }
    }
    match worst.map(RequirementTrouble::Fails).or(open) {
        Some(trouble) => Err(trouble),
        None => Ok(Proof { effort }),
    }
}

/// Refuses bodies that overlap where their motion begins. Later ones would touch first.
fn refuse_overlap(
    model: &Model,
    compiled: &Compiled,
    requirement: &Requirement,
    links: [LinkId; 2],
) -> Result<(), RequirementTrouble> {
    let program = &compiled.program;
    let mut place = program.start.motors.clone();
    for model::Case { motor, ends, .. } in &requirement.cases {
        place[motor.index()] = place[motor.index()].clamp(ends[0], ends[1]);
    }
    let position = visit(program, &place).ok_or(RequirementTrouble::TooHard)?;
    let pose = |link: LinkId| match program.place_of(link) {
        Some(number) => position.poses[number],
        None => [1.0, 0.0, 0.0, 0.0],
    };
    if clearance(model, links, links.map(pose)) != Some(0.0) {
        return Ok(());
    }
    let motors = model.motor_ids().zip(place);
    Err(RequirementTrouble::Fails(Witness {
        value: 0.0,
        is_upper: false,
        proved: None,
        places: vec![motors.collect()],
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
    let mut axes = requirement
        .measured
        .iter()
        .flat_map(|measured| match *measured {
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
    let is_clear = |measured: &Measured| match measured {
        Measured::Quantity(Quantity::Clearance(links)) => {
            let shapes = links.iter().flat_map(|link| &model.link(*link).shapes);
            shapes.clone().any(Shape::varies)
        }
        _ => false,
    };
    if axes.any(depends) || requirement.measured.iter().any(is_clear) {
        return Err(RequirementTrouble::Varies { param });
    }
    Ok(())
}
