//! The state of lowering, shared by all passes over a plan: the operations so far, and where they put the links.

use crate::model::{AxisId, Between, JointKind, LinkId, Look, Model};
use crate::plan::{Connection, ConnectionKind, Placement, Plan, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use crate::program::{Place, Position, StateLayout};

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

impl Lowering<'_> {
    /// Carries the numbers of axes and shapes that depend on params and that something outside of the program reads.
    pub(super) fn carry_places(&mut self) {
        let model = self.model;
        let axes = self.exposed_axes().into_iter();
        let of_axes = axes.flat_map(|id| model.axis(id).all_formulas());
        let shapes = model.links.iter().flat_map(|link| &link.shapes);
        let of_shapes = shapes.flat_map(|shape| shape.formulas.iter().flatten().copied());
        for formula in of_axes.chain(of_shapes) {
            let places = &mut self.layout.places;
            if places.iter().all(|place| place.formula != formula) {
                let value = self.ssa.formulas[formula.index()];
                let state = self.ssa.record(value).index;
                places.push(Place { formula, state });
            }
        }
    }

    /// The axes that depend on params and are read outside of the program: for points, coordinates, springs and the overlay. Each stands
    /// once.
    fn exposed_axes(&self) -> Vec<AxisId> {
        let model = self.model;
        let joints = model.joint_ids().filter(|&id| model.shows_joint(id));
        let of_joints = joints.filter_map(|id| match model.joint(id).kind {
            JointKind::Prismatic(a, b) => Some([a, b].map(|axis| model.seen_axis(axis))),
            _ => None,
        });
        // The forces of springs are computed from their ends.
        let springs = model.actions.springs.iter();
        let sprung = springs.filter_map(|spring| match spring.between {
            Between::Points(a, b) if model.effects.needs_actions() => Some([a, b]),
            _ => None,
        });
        // Bodies and diagrams are drawn from whatever there is.
        let all = if model.effects.overlay || model.look() != Look::Shapes {
            model.axes.len()
        } else {
            0
        };
        let drawn = (0..all).map(AxisId::new);
        let mut exposed: Vec<AxisId> = model
            .shown_points()
            .chain(of_joints.flatten())
            .chain(sprung.flatten())
            .chain(drawn)
            .filter(|&id| model.axis(id).varies())
            .collect();
        exposed.sort_unstable();
        exposed.dedup();
        exposed
    }
}
