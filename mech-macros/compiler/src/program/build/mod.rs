//! From the plan to the program.

mod closing;

use super::builder::Builder;
use super::calibrate::calibrate;
use super::live::live;
use super::node::{Op, Slot, Value};
use super::{Position, Program};
use crate::model::{AxisId, LinkId, Model};
use crate::plan::{
    Algebra, Angles, Connection, ConnectionKind, Coordinate, Drive, Mesh, Placement, Plan, Pose,
    Step,
};

/// More rounds than this never help: Newton's iteration doubles its digits in each.
const MOST_ROUNDS: u32 = 24;

/// Writes the program of a planned mechanism.
#[must_use]
pub fn build(model: &Model, plan: &Plan) -> Program {
    let mut builder = Builder::default();
    builder.block("start".to_owned(), String::new());
    let placement = Placement::new(&mut builder, model);
    let angles = Angles::new(&mut builder, model.links.len());
    let mut writer = Writer {
        model,
        plan,
        builder,
        placement,
        angles,
        kept: Vec::new(),
        meshes: 0,
        loops: 0,
    };
    for step in &plan.steps {
        match step {
            Step::Drive(drive) => writer.drive(drive),
            Step::Mesh(mesh) => writer.mesh(mesh),
            Step::Close(ring) => writer.close(ring),
        }
    }
    writer.finish()
}

struct Writer<'m> {
    model: &'m Model,
    plan: &'m Plan,
    builder: Builder,
    placement: Placement<'m, Value>,
    angles: Angles<Value>,
    /// The new values of the angles that are kept unwrapped, and what they are at the start.
    kept: Vec<(Value, f64)>,
    meshes: usize,
    loops: usize,
}

impl Writer<'_> {
    fn link_of(&self, axis: AxisId) -> LinkId {
        self.model.axis(axis).link
    }

    fn name_of(&self, link: LinkId) -> &str {
        &self.model.link(link).name
    }

    fn drive(&mut self, drive: &Drive) {
        let name = self.model.joint(drive.connection.joint).name.clone();
        self.builder
            .block(format!("drive_{name}"), format!("Motor `{name}`."));
        let motor = self.builder.make(Op::Motor(drive.motor.index()));
        self.builder.name(motor, &name);
        match drive.connection.kind {
            ConnectionKind::Revolute => {
                let turn = self.unit(motor, &name);
                self.connect(drive.connection, Coordinate::Turn(turn), Some(motor));
            }
            ConnectionKind::Prismatic => {
                self.connect(drive.connection, Coordinate::Slide(motor), None);
            }
        }
    }

    /// The cosine and sine of an angle.
    fn unit(&mut self, angle: Value, name: &str) -> [Value; 2] {
        let (sin, cos) = (
            self.builder.make(Op::Sin(angle)),
            self.builder.make(Op::Cos(angle)),
        );
        self.builder.name_direction([cos, sin], name)
    }

    fn connect(
        &mut self,
        connection: Connection,
        coordinate: Coordinate<Value>,
        turn: Option<Value>,
    ) {
        let fixed = self.builder.constant(connection.frame_angle(self.model));
        let angle = match turn {
            Some(turn) => self.builder.add(fixed, turn),
            None => fixed,
        };
        let (from, to) = (self.link_of(connection.from), self.link_of(connection.to));
        self.angles.join(&mut self.builder, from, to, angle);
        self.placement
            .connect(&mut self.builder, connection, coordinate);
        self.name_cluster(to);
    }

    fn mesh(&mut self, mesh: &Mesh) {
        let name = self.model.joint(mesh.gear).name.clone();
        self.builder
            .block(format!("mesh_{name}"), format!("Gear `{name}`."));
        let (carrier, wheel) = (self.link_of(mesh.input.from), self.link_of(mesh.input.to));
        let (input_start, output_start) = self
            .plan
            .start
            .meshes
            .get(self.meshes)
            .copied()
            .unwrap_or_default();
        self.meshes += 1;
        let input = match self.angles.between(&mut self.builder, carrier, wheel) {
            Some(angle) => angle,
            None => self.unwrapped(carrier, wheel, input_start),
        };
        let speed = self.builder.constant(mesh.speed);
        let turned = self.builder.mul(speed, input);
        let offset = self
            .builder
            .constant(output_start - mesh.speed * input_start);
        let output = self.builder.add(offset, turned);
        let driven = self.link_of(mesh.output.to);
        let driven_name = self.name_of(driven).to_owned();
        self.builder.name(output, format!("{driven_name}_angle"));
        let unit = self.unit(output, &driven_name);
        self.angles.join(&mut self.builder, carrier, driven, output);
        let carried = self.placement.pose(carrier).direction;
        let direction = self.builder.turned(carried, unit);
        self.placement
            .turn_link(&mut self.builder, mesh.output, direction);
        self.name_cluster(driven);
    }

    /// The angle between two links that loops have solved, followed over any number of turns.
    fn unwrapped(&mut self, from: LinkId, to: LinkId, start: f64) -> Value {
        let (base, end) = (
            self.placement.pose(from).direction,
            self.placement.pose(to).direction,
        );
        let (sin, cos) = (self.builder.cross(base, end), self.builder.dot(base, end));
        let principal = self.builder.make(Op::Atan2(sin, cos));
        let last = self.builder.make(Op::Last(Slot::Angle(self.kept.len())));
        let behind = self.builder.sub(last, principal);
        let turn = self.builder.constant(std::f64::consts::TAU);
        let turns = self.builder.div(behind, turn);
        let turns = self.builder.make(Op::Round(turns));
        let whole = self.builder.mul(turn, turns);
        let angle = self.builder.add(principal, whole);
        let name = format!("{}_angle", self.name_of(to));
        self.builder.name(angle, name);
        self.kept.push((angle, start));
        self.angles.join(&mut self.builder, from, to, angle);
        angle
    }

    /// Names the poses of the links that were just placed.
    fn name_cluster(&mut self, link: LinkId) {
        let base = self.placement.clusters.base(link);
        let links: Vec<LinkId> = self.placement.clusters.links(base).collect();
        for link in links {
            let pose = self.placement.pose(link);
            let name = self.name_of(link).to_owned();
            self.builder.name_direction(pose.direction, &name);
            self.builder.name_vector(pose.origin, &name);
        }
    }

    fn finish(self) -> Program {
        let Self {
            model,
            plan,
            builder,
            placement,
            kept,
            ..
        } = self;
        let poses = model.moving_links().map(|link| {
            let Pose {
                direction: [cos, sin],
                origin: [x, y],
            } = placement.pose(link);
            [cos, sin, x, y]
        });
        let start = Position {
            motors: plan.start.motors.clone(),
            poses: plan.start.poses[1..].to_vec(),
            angles: kept.iter().map(|&(_, start)| start).collect(),
        };
        let mut program = Program {
            name: model.name.clone(),
            precision: model.precision,
            nodes: builder.nodes,
            blocks: builder.blocks,
            motors: model
                .motors
                .iter()
                .map(|motor| model.joint(motor.joint).name.clone())
                .collect(),
            links: model
                .moving_links()
                .map(|link| model.link(link).name.clone())
                .collect(),
            poses: poses.collect(),
            angles: kept.into_iter().map(|(angle, _)| angle).collect(),
            live: Vec::new(),
            start,
        };
        program.live = live(&program);
        calibrate(&mut program);
        program
    }
}
