//! The statement `expect`: a condition that the mechanism has to meet.

use super::angle::{is_degrees_perhaps, is_in_degrees};
use super::case::{WHY_FIXED, lower_cases};
use super::draft::Draft;
use super::find;
use super::kind::{Kind, kinds};
use super::measured::Required;
use super::quantity::Quantity;
use super::reader::{LawReading, Reader};
use crate::bug::bug;
use crate::model::{
    self, Condition, Formula, FormulaId, Formulas, JointKind, LoadKind, Measured, MotorId,
    RequiredBound, Requirement,
};
use crate::syntax::Place;
use crate::syntax::ast::{ConditionExpr, Expect, Expr, LoadCase, Name};

/// More numbers and operations than this make no condition that anybody could read.
const MOST_FORMULAS: usize = 200;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, expect: &Expect) {
    if reader.scope != 0 {
        let text = "`expect` says what the whole mechanism is for; move it out of the part";
        return reader.report.error(Place::at(expect.keyword), text);
    }
    let loads = lower_loads(reader, draft, &expect.loads);
    let read = loads
        .as_ref()
        .and_then(|loads| condition(reader, &Required { draft, loads }, &expect.condition));
    let cases = lower_cases(reader, draft, &expect.cases);
    let (Some(read), Some((cases, times)), Some(loads)) = (read, cases, loads) else {
        return;
    };
    if let (Condition::Turns(_), Some(times)) = (&read.condition, &times) {
        let text = "whether a motor turns right round does not depend on the time; leave `t` out";
        return reader.report.error(times.place, text);
    }
    let mut quantities = read.measured.iter().filter_map(Measured::quantity);
    if let Some(load) = expect.loads.first()
        && !quantities.any(model::Quantity::takes_loads)
    {
        let text = format!("load `{}` has no part in what is measured; leave it out", load.name);
        return reader.report.error(load.name.place(), text);
    }
    let origin = draft.places.note(read.place);
    draft.model.requirements.push(Requirement {
        origin,
        written: read.written,
        formulas: read.formulas,
        measured: read.measured,
        condition: read.condition,
        cases,
        times: times.map(|times| times.ends),
        loads,
        why: expect.why.clone(),
    });
}

/// A condition that was read.
struct ReadCondition {
    place: Place,
    written: String,
    formulas: Formulas,
    measured: Vec<Measured>,
    condition: Condition,
}

fn condition(
    reader: &mut Reader,
    required: &Required,
    condition: &ConditionExpr,
) -> Option<ReadCondition> {
    match condition {
        ConditionExpr::Turns(motor, place) => {
            let draft = required.draft;
            let motor = turning_motor(reader, draft, motor)?;
            Some(ReadCondition {
                place: *place,
                written: format!(
                    "turns({})",
                    draft.model.joint(draft.model.motor(motor).joint).name
                ),
                formulas: Formulas::default(),
                measured: Vec::new(),
                condition: Condition::Turns(motor),
            })
        }
        ConditionExpr::Compare { sides: [first, second], is_upper, is_strict } => {
            let sign = match (is_upper, is_strict) {
                (true, true) => "<",
                (true, false) => "<=",
                (false, true) => ">",
                (false, false) => ">=",
            };
            let written = format!("{first} {sign} {second}");
            bounds(reader, required, first, &[(second, *is_upper)], *is_strict, written)
        }
        ConditionExpr::Within(of, [low, high]) => {
            let written = format!("{of} in {low} ..= {high}");
            bounds(reader, required, of, &[(low, false), (high, true)], false, written)
        }
    }
}

/// The motor of this name, which turns.
fn turning_motor(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<MotorId> {
    let motor = find::motor(reader, draft, name)?;
    let kind = draft.model.joint(draft.model.motor(motor).joint).kind;
    if let JointKind::Revolute(..) = kind {
        return Some(motor);
    }
    let text = format!("`{name}` slides: it cannot turn right round");
    reader.report.refuse(name.place(), text)
}

/// Bounds of the first number: each with whether it is an upper one.
fn bounds(
    reader: &mut Reader,
    required: &Required,
    subject: &Expr,
    limits: &[(&Expr, bool)],
    is_strict: bool,
    written: String,
) -> Option<ReadCondition> {
    let mut inner = Reader {
        law: Some(LawReading::of_measured()),
        measuring: Some(required),
        ..reader.fixed(WHY_FIXED)
    };
    let first = inner.quantity(subject);
    let others: Vec<Option<Quantity>> =
        limits.iter().map(|(expr, _)| inner.quantity(expr)).collect();
    let (mut first, mut others) = (first?, others.into_iter().collect::<Option<Vec<_>>>()?);
    let Some(LawReading { mut formulas, measured, .. }) = inner.law.take() else {
        bug!("a requirement has lost its formulas");
    };
    let last = limits.last().map_or(subject, |(last, _)| last);
    let place = subject.place.to(last.place);
    // What is measured is the subject, on whichever side it stands.
    let turned = match limits {
        [(other, is_upper)] if first.formula.is_none() => {
            std::mem::swap(&mut first, &mut others[0]);
            Some((*other, [(subject, !is_upper)]))
        }
        _ => None,
    };
    let (subject, limits) = match &turned {
        Some((subject, limits)) => (*subject, &limits[..]),
        None => (subject, limits),
    };
    let fixed_limits = others.iter().map(|limit| limit.value);
    let fixed_limits: Vec<Option<f64>> = fixed_limits.collect();
    let subject_formula = first.as_formula(&mut formulas);
    let mut bounds = Vec::new();
    for (quantity, (_, is_upper)) in others.into_iter().zip(limits) {
        let limit = quantity.as_formula(&mut formulas);
        let margin = formulas.add(if *is_upper {
            Formula::Sub(limit, subject_formula)
        } else {
            Formula::Sub(subject_formula, limit)
        });
        bounds.push(RequiredBound { margin, limit, is_upper: *is_upper, is_strict });
    }
    check_formulas(reader, &formulas, place, &written)?;
    check_clearance(reader, &formulas, &measured, (subject_formula, &bounds), place)?;
    let kinds = kinds(&required.draft.model, &formulas, &measured);
    let kind = kinds[subject_formula.index()];
    for (number, ((limit, _), bound)) in limits.iter().zip(&bounds).enumerate() {
        check_kinds(reader, [subject, limit], [kind, kinds[bound.limit.index()]])?;
        if is_force(&measured) && is_in_degrees(limit) {
            let text = format!("`{subject}` is a force or a torque, and `{limit}` is an angle");
            return reader.report.refuse(limit.place, text);
        }
        if kind.is_angle()
            && let Some(value) = fixed_limits[number]
            && is_degrees_perhaps(reader.report, limit, value)
        {
            return None;
        }
    }
    let angles = [kind, kinds[bounds[0].limit.index()]];
    Some(ReadCondition {
        place,
        written,
        formulas,
        measured,
        condition: Condition::Bounds {
            subject: subject_formula,
            is_angle: angles.iter().any(|kind| kind.is_angle()),
            bounds,
        },
    })
}

/// Complains about a clearance that is not just bounded from below.
fn check_clearance(
    reader: &mut Reader,
    formulas: &Formulas,
    measured: &[Measured],
    (subject, bounds): (FormulaId, &[RequiredBound]),
    place: Place,
) -> Option<()> {
    let is_clearance =
        |measured: &Measured| matches!(measured, Measured::Quantity(model::Quantity::Clearance(_)));
    if !measured.iter().any(is_clearance) {
        return Some(());
    }
    let is_alone = measured.len() == 1
        && matches!(formulas.all()[subject.index()], Formula::Variable(_))
        && bounds.iter().all(|bound| !bound.is_upper);
    let limit = |bound: &RequiredBound| match formulas.all()[bound.limit.index()] {
        Formula::Constant(limit) => Some((limit.get(), bound.is_strict)),
        _ => None,
    };
    let always = |(limit, is_strict): (f64, bool)| limit < 0.0 || limit == 0.0 && !is_strict;
    if is_alone && bounds.iter().filter_map(limit).any(always) {
        let text = "a clearance is never less than zero: this always holds; write `> 0`";
        return reader.report.refuse(place, text);
    }
    if is_alone {
        return Some(());
    }
    let text = "a clearance has a least value, and nothing else is proved of it; write `clear(LINK, LINK) > LENGTH`";
    reader.report.refuse(place, text)
}

/// Complains about params, about more numbers than anybody could read, and where nothing is measured.
fn check_formulas(
    reader: &mut Reader,
    formulas: &Formulas,
    place: Place,
    written: &str,
) -> Option<()> {
    if formulas.all().iter().any(|formula| matches!(formula, Formula::Param(_))) {
        let text = format!(
            "a param may change while the mechanism runs, and {WHY_FIXED}; use a `const` here"
        );
        return reader.report.refuse(place, text);
    }
    check_size(reader, formulas, place)?;
    if !formulas.all().iter().any(|formula| matches!(formula, Formula::Variable(_))) {
        let text = format!("nothing is measured in `{written}`: it never changes");
        return reader.report.refuse(place, text);
    }
    Some(())
}

/// Complains about more numbers than anybody could read.
pub(super) fn check_size(reader: &mut Reader, formulas: &Formulas, place: Place) -> Option<()> {
    if formulas.all().len() <= MOST_FORMULAS {
        return Some(());
    }
    let text = format!(
        "a condition has {MOST_FORMULAS} numbers and operations at most; this one has more"
    );
    reader.report.refuse(place, text)
}

/// Whether only forces and torques are measured.
fn is_force(measured: &[Measured]) -> bool {
    let mut quantities = measured.iter().filter_map(Measured::quantity).peekable();
    quantities.peek().is_some() && quantities.all(model::Quantity::is_force)
}

/// Complains about two sides of different kinds.
fn check_kinds(reader: &mut Reader, sides: [&Expr; 2], kinds: [Kind; 2]) -> Option<()> {
    let place = sides[0].place.to(sides[1].place);
    if kinds[0].and(kinds[1]) == Kind::Mixed {
        let word = |kind| match kind {
            Kind::Angle | Kind::ScaledAngle => "an angle",
            Kind::Length | Kind::ScaledLength => "a length",
            Kind::Plain => "a number",
            Kind::Mixed => "made from both an angle and a length",
        };
        let text = format!(
            "`{}` is {}, and `{}` is {}",
            sides[0],
            word(kinds[0]),
            sides[1],
            word(kinds[1])
        );
        return reader.report.refuse(place, text);
    }
    if kinds[0] == Kind::Length && is_in_degrees(sides[1]) {
        let text = format!("`{}` is a length, and `{}` is an angle", sides[0], sides[1]);
        return reader.report.refuse(place, text);
    }
    Some(())
}

/// The numbers of all loads, in their order: those that nobody gives are zero.
fn lower_loads(reader: &mut Reader, draft: &Draft, given: &[LoadCase]) -> Option<Vec<f64>> {
    let actions = &draft.model.actions;
    let mut numbers = vec![0.0; actions.load_names().len()];
    let mut known: Vec<usize> = Vec::new();
    for case in given {
        let LoadCase { name, place, .. } = case;
        if reader.is_motor(draft, name) {
            let text = format!(
                "`{name}` is a motor; write `at {name} = VALUE`, or `for {name} in LOW ..= HIGH`"
            );
            return reader.report.refuse(name.place(), text);
        }
        let number = reader.load(draft, name)?;
        let Some((first, load)) = actions.numbered_loads().nth(number) else {
            bug!("a load has no number");
        };
        if known.contains(&first) {
            let text = format!("load `{name}` is given twice; remove one of the two");
            return reader.report.refuse(name.place(), text);
        }
        known.push(first);
        let how = match (load.kind, case.numbers.len()) {
            (LoadKind::Force(_), 1) => format!("a force; write `{name} = (x, y)`"),
            (LoadKind::Torque(_), 2) => format!("a torque; write `{name} = VALUE`"),
            _ => {
                let mut fixed = reader.fixed(WHY_FIXED);
                let values = case.numbers.iter().map(|number| fixed.value(number));
                let values: Option<Vec<f64>> = values.collect();
                numbers[first..first + load.kind.numbers()].copy_from_slice(&values?);
                continue;
            }
        };
        return reader.report.refuse(*place, format!("load `{name}` is {how}"));
    }
    Some(numbers)
}
