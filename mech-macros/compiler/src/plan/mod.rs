//! The plan: in which order positions become known, and where everything is at the start.

mod algebra;
mod assembly;
mod between;
mod bound;
mod closed_form;
mod cluster;
mod coupled;
mod display;
mod dyad;
mod equation;
mod linear_relations;
mod needed;
mod placement;
mod search;
mod sequence;
mod step;
mod tight;
mod tree;
mod triad;
mod unknown;

pub(crate) use crate::model::Arithmetic;
pub(crate) use algebra::{Algebra, Numbers, Pose, are_equal};
pub use assembly::{Assembly, CamStart};
pub use bound::{Bound, Growth, Turning};
pub use display::PlanText;
pub(crate) use dyad::{CircleAndLine, Dyad, Line, TurningLine, TwoCircles, TwoLines};
pub(crate) use equation::{Equation, Residuals};
pub use linear_relations::Rational;
pub(crate) use linear_relations::{float_of, fraction};
pub use needed::PlanPart;
pub(crate) use placement::Placement;
pub(crate) use search::Halton;
pub use step::{Cam, Connection, ConnectionKind, Drive, Loop, Mesh, Source, Step, Tie, Weld};
pub(crate) use triad::{Leg, Triad};
pub(crate) use unknown::Solution;
pub use unknown::Unknown;

use crate::model::{Axis, JointId, Link, Model};
use crate::structure::{Diagnosis, Structure};

/// The solution of a coherent mechanism, step by step.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plan {
    /// The steps, each of which needs only those before it.
    pub steps: Vec<Step>,
    /// The sources from which gears, belts, racks and cams are solved.
    pub sources: Vec<Source>,
    /// The greatest rates of all angles whose turns are counted; empty until these were examined.
    pub turning: Vec<(Turning, Bound)>,
    /// The assembly at the start.
    pub start: Assembly,
}

impl Plan {
    /// The number of the loop that finds the coordinate of a joint; none if no loop does.
    #[must_use]
    pub fn number_of_loop(&self, joint: JointId) -> Option<usize> {
        let mut loops = self.loops();
        loops.position(|ring| ring.unknowns().contains(&joint))
    }

    /// The loops, in the order in which they are solved.
    pub fn loops(&self) -> impl Iterator<Item = &Loop> {
        self.steps
            .iter()
            .filter_map(|step| if let Step::Close(closing) = step { Some(closing) } else { None })
    }
}

/// Plans a mechanism whose structure was found coherent.
///
/// # Errors
/// It is not sequential, it has no assembly, or it has several.
pub fn plan(model: &Model, structure: &Structure) -> Result<Plan, Diagnosis> {
    let sequence = sequence::sequence(model, structure)?;
    let start = assembly::assemble(model, &sequence.steps, &sequence.sources)?;
    Ok(Plan { steps: sequence.steps, turning: Vec::new(), sources: sequence.sources, start })
}

/// Whether the steps planned for one mechanism are those for another: joints, motors and params are the same, and axes differ only in where
/// they are. A joint in the drawing may bring an axis along or share one that is there already, so moving one may change the axes.
#[must_use]
pub fn have_same_steps(planned: &Model, other: &Model) -> bool {
    let is_same_axis = |(a, b): (&Axis, &Axis)| {
        (a.link, a.kind, a.direction, a.formulas, a.direction_formulas)
            == (b.link, b.kind, b.direction, b.formulas, b.direction_formulas)
    };
    let is_same_link = |(a, b): (&Link, &Link)| (a.drawn, a.die) == (b.drawn, b.die);
    planned.axes.len() == other.axes.len()
        && planned.axes.iter().zip(&other.axes).all(is_same_axis)
        && planned.links.len() == other.links.len()
        && planned.links.iter().zip(&other.links).all(is_same_link)
        && planned.joints == other.joints
        && planned.motors == other.motors
        && planned.laws == other.laws
        && planned.params == other.params
}

/// The start of a mechanism for which the steps of another are planned, as [`have_same_steps`] finds.
///
/// # Errors
/// It has no assembly with its numbers, or several.
pub fn assemble(model: &Model, plan: &Plan) -> Result<Assembly, Diagnosis> {
    assembly::assemble(model, &plan.steps, &plan.sources)
}
