//! The steps of a plan, lowered one after the other.

use super::pass::PositionPass;
use crate::model::InputId;
use crate::plan::{
    Algebra, Arithmetic, ConnectionKind, Drive, Mesh, Rational, Solution, Source, Step, Weld,
    float_of,
};
use crate::program::node::Op;

impl PositionPass<'_> {
    /// Lowers a joint that never turns.
    pub(super) fn weld(&mut self, weld: &Weld) {
        let direction = self.lowering.ssa.vector(weld.direction);
        self.lowering.connect(weld.connection, Solution::Direction(direction));
    }

    /// A joint whose coordinate a motor gives.
    pub(super) fn drive(&mut self, drive: &Drive) {
        let name = &self.lowering.model.joint(drive.connection.joint).name;
        let ssa = &mut self.lowering.ssa;
        ssa.block(format!("drive_{name}"), format!("Motor `{name}`."));
        let motor = ssa.make(Op::Input(InputId::of_motor(drive.motor)));
        ssa.name(motor, name);
        self.lowering.place(drive.connection, motor, name);
    }

    /// A joint whose coordinate follows from sources by rolling, and is `start` at the start.
    pub(super) fn mesh(&mut self, mesh: &Mesh, start: f64) {
        let (model, plan) = (self.lowering.model, self.lowering.plan);
        let name = &model.joint(mesh.by).name;
        let ssa = &mut self.lowering.ssa;
        ssa.block(format!("mesh_{name}"), format!("Moved by `{name}`."));
        let mut moved = ssa.constant(0.0);
        let turns = mesh.connection.kind == ConnectionKind::Revolute;
        let at_start =
            |(number, part): &(usize, Rational)| float_of(part) * plan.start.sources[*number];
        let unit = if turns { 1.0 } else { model.size() };
        let offset = difference(start, mesh.parts.iter().map(at_start), unit);
        for (number, part) in &mesh.parts {
            let share = self.share(*number, part, turns);
            moved = self.lowering.ssa.add(moved, share);
        }
        let offset = self.lowering.ssa.constant(offset);
        let value = self.lowering.ssa.add(offset, moved);
        if self.continuous.contains(mesh.connection) {
            let mut whole = offset;
            for (number, part) in &mesh.parts {
                let share = self.share(*number, part, false);
                whole = self.lowering.ssa.add(whole, share);
            }
            self.continuous.note(mesh.connection, whole);
        }
        let moved = &model.joint(mesh.connection.joint).name;
        self.lowering.ssa.name(value, moved);
        self.lowering.place(mesh.connection, value, moved);
    }

    /// Passes over a step that nothing needs. A source that it would have been the first to read is read here, if a later step needs it:
    /// so every program computes it in the same way, bit by bit.
    pub(super) fn read_sources(&mut self, step: &Step, needed: &[bool]) {
        for (number, _) in step.sources() {
            let source = self.lowering.plan.sources[*number];
            let is_motor = matches!(source, Source::Motor(_));
            if needed[*number] && !is_motor && !self.sources.has(*number) {
                let title = "What gears are solved from.".to_owned();
                self.lowering.ssa.block("source".to_owned(), title);
                match (step, source) {
                    // It may be that nothing needs its whole turns.
                    (Step::Cam(_), Source::Angle { from, to }) => {
                        self.sources.principal(&mut self.lowering, *number, [from, to]);
                    }
                    _ => {
                        self.sources.value(&mut self.lowering, &mut self.watches, *number);
                    }
                }
            }
        }
    }
}

/// A number less others; zero if the difference is no more than rounding.
fn difference(number: f64, others: impl Iterator<Item = f64>, unit: f64) -> f64 {
    /// So many roundings are in a source that an assembly gives.
    const ROUNDINGS: f64 = 16.0;
    let (mut difference, mut size) = (number, unit + number.abs());
    for other in others {
        difference -= other;
        size += other.abs();
    }
    if difference.abs() <= ROUNDINGS * f64::EPSILON * size { 0.0 } else { difference }
}
