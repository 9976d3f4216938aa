//! The sources of gears, belts, racks and cams.

use super::lowering::Lowering;
use super::watching::Watches;
use crate::model::{InputId, LinkId};
use crate::plan::{Plan, Source, Turning};
use crate::program::node::{Op, Value};

/// The sources of a plan, as far as they were read.
pub(super) struct Sources {
    values: Vec<Option<Value>>,
    /// Those of them that are angles, between −π and π.
    principals: Vec<Option<Value>>,
    /// The angles that were made.
    pub(super) angles: Vec<Angle>,
}

/// An angle from one direction to another, between −π and π.
pub(super) struct Angle {
    pub(super) value: Value,
    pub(super) between: [[Value; 2]; 2],
}

impl Sources {
    pub(super) fn new(plan: &Plan) -> Self {
        Self {
            values: vec![None; plan.sources.len()],
            principals: vec![None; plan.sources.len()],
            angles: Vec::new(),
        }
    }

    /// Whether a source was read.
    pub(super) fn has(&self, number: usize) -> bool {
        self.values[number].is_some()
    }

    /// The value of a source; of an angle, over any number of turns.
    pub(super) fn value(
        &mut self,
        lowering: &mut Lowering<'_>,
        watches: &mut Watches,
        number: usize,
    ) -> Value {
        if let Some(known) = self.values[number] {
            return known;
        }
        let (model, plan) = (lowering.model, lowering.plan);
        let value = match plan.sources[number] {
            Source::Motor(motor) => {
                let name = &model.joint(model.motor(motor).joint).name;
                let value = lowering.ssa.make(Op::Input(InputId::of_motor(motor)));
                lowering.ssa.name(value, name)
            }
            Source::Angle { from, to } => {
                let start = plan.start.sources[number];
                let principal = self.principal(lowering, number, [from, to]);
                let what = Turning::Source(number);
                let state = watches.count_turns(lowering, what, principal, start);
                let angle = lowering.ssa.state(state);
                let name = format!("{}_angle", lowering.name_of(to));
                lowering.ssa.name(angle, name)
            }
            Source::Displacement(joint) => {
                lowering.placement.sliding_coordinate(&mut lowering.ssa, joint)
            }
        };
        self.values[number] = Some(value);
        value
    }

    /// The angle between two links that loops have solved, between −π and π: a source, by its number.
    pub(super) fn principal(
        &mut self,
        lowering: &mut Lowering<'_>,
        number: usize,
        links: [LinkId; 2],
    ) -> Value {
        if let Some(known) = self.principals[number] {
            return known;
        }
        let between = links.map(|link| lowering.placement.pose(link).direction);
        let value = lowering.ssa.angle_between(between);
        self.angles.push(Angle { value, between });
        self.principals[number] = Some(value);
        value
    }
}
