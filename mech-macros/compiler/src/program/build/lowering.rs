//! The state of lowering, shared by all passes over a plan: the operations so far, and where they put the links.

use crate::model::{AxisId, LinkId, Model};
use crate::plan::{Connection, ConnectionKind, Placement, Plan, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use crate::program::{Position, StateLayout};

/// A plan that is being lowered to operations.
pub(super) struct Lowering<'m> {
    pub(super) model: &'m Model,
    pub(super) plan: &'m Plan,
    pub(super) ssa: SsaBuilder,
    pub(super) placement: Placement<'m, Value>,
    pub(super) layout: StateLayout,
}

impl<'m> Lowering<'m> {
    pub(super) fn new(model: &'m Model, plan: &'m Plan) -> Self {
        let all = model.declared_links();
        let motors = plan.start.motors.iter().copied();
        let start = Position {
            motors: motors.chain(model.params.values()).collect(),
            turns: vec![0; model.inputs()],
            poses: all.map(|link| plan.start.poses[link.index()]).collect(),
            state: Vec::new(),
        };
        let mut ssa = SsaBuilder::new(start, model.precision);
        ssa.block("start".to_owned(), String::new());
        ssa.evaluate_formulas(model);
        let placement = Placement::new(&mut ssa, model);
        Self { model, plan, ssa, placement, layout: StateLayout::default() }
    }

    pub(super) fn link_of(&self, axis: AxisId) -> LinkId {
        self.model.axis(axis).link
    }

    pub(super) fn name_of(&self, link: LinkId) -> &'m str {
        &self.model.link(link).name
    }

    /// Places a link by the coordinate of its connection, an angle or a length.
    pub(super) fn place(&mut self, connection: Connection, value: Value, name: &str) {
        let coordinate = match connection.kind {
            ConnectionKind::Revolute => {
                self.ssa.note_gains(value);
                let (sin, cos) = (self.ssa.make(Op::Sin(value)), self.ssa.make(Op::Cos(value)));
                Solution::Direction(self.ssa.name_direction([cos, sin], name))
            }
            ConnectionKind::Prismatic => Solution::Slide(value),
        };
        self.connect(connection, coordinate);
    }

    /// Brings two clusters together over a connection of known coordinate.
    pub(super) fn connect(&mut self, connection: Connection, coordinate: Solution<Value>) {
        self.placement.connect(&mut self.ssa, connection, coordinate);
        self.name_moved();
    }

    /// Names the poses of the links that a step has moved; those of others have their names already.
    pub(super) fn name_moved(&mut self) {
        for link in self.placement.take_moved() {
            let pose = self.placement.pose(link);
            let name = &self.model.link(link).name;
            self.ssa.name_direction(pose.direction, name);
            self.ssa.name_vector(pose.origin, name);
        }
    }

    /// The point of an axis in the scene.
    pub(super) fn point(&mut self, axis: AxisId) -> [Value; 2] {
        self.placement.spot(&mut self.ssa, axis)
    }
}
