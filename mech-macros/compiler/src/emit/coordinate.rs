//! The coordinates of joints.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::model::{AxisId, JointId, JointKind, Model};
use crate::plan::{Mesh, Plan, Rational, Source, Step, float_of};
use mech_core::Coordinate as Measure;
use proc_macro2::TokenStream;
use quote::quote;

/// The axes between which a coordinate is measured.
#[derive(Clone, Copy)]
pub(super) struct CoordinateAxes {
    /// Whether the coordinate is an angle.
    pub(super) turns: bool,
    pub(super) from: AxisId,
    pub(super) to: AxisId,
}

impl CoordinateAxes {
    /// The axes of a declared joint; none if it has no coordinate, as a gear.
    pub(super) fn new(model: &Model, joint: JointId) -> Option<Self> {
        let declared = model.joint(joint);
        let (turns, a, b) = match declared.kind {
            JointKind::Revolute(a, b) => (true, a, b),
            JointKind::Prismatic(a, b) => (false, a, b),
            _ => return None,
        };
        (!declared.hidden).then(|| Self { turns, from: model.seen_axis(a), to: model.seen_axis(b) })
    }
}

/// The unit of a coordinate, as the documentation of an accessor names it.
pub(super) fn unit(measure: Measure) -> &'static str {
    match measure {
        Measure::Length => "scene units",
        Measure::Angle => "radians, between −π and π; `continuous` lets it count whole turns",
        _ => "radians, whole turns since the start included",
    }
}

/// The coordinate of a joint, as an expression in a method.
pub(super) struct Coordinate {
    pub(super) measure: Measure,
    pub(super) value: TokenStream,
}

/// The coordinate of a joint; none if it has none.
pub(super) fn coordinate(emitter: &Emitter<'_>, joint: JointId) -> Option<Coordinate> {
    let CoordinateAxes { turns, from, to } = CoordinateAxes::new(emitter.model, joint)?;
    let (measure, value) = if let Some(motor) = emitter.model.motor_of(joint) {
        let index = integer(motor.index());
        let measure = if turns { Measure::Turns } else { Measure::Length };
        (measure, quote!(Self::motors(self)[#index]))
    } else if let Some(state) = emitter.program.angle_state(joint) {
        (Measure::Turns, emitter.state(state))
    } else if let Some(value) = whole_angle(emitter, joint) {
        (Measure::Turns, value)
    } else {
        let [from, to] = [from, to].map(|axis| emitter.axis(axis));
        if turns {
            (Measure::Angle, quote!(generated::angle(#from, #to)))
        } else {
            (Measure::Length, quote!(generated::slide(#from, #to)))
        }
    };
    Some(Coordinate { measure, value })
}

/// The angle of a joint that motors turn by gears: like theirs, it counts any number of turns.
fn whole_angle(emitter: &Emitter<'_>, joint: JointId) -> Option<TokenStream> {
    let JointKind::Revolute(a, b) = emitter.model.joint(joint).kind else {
        return None;
    };
    let plan = &emitter.compiled.plan;
    let meshes = plan.steps.iter().filter_map(|step| match step {
        Step::Mesh(mesh) => Some(mesh),
        _ => None,
    });
    let (mesh, start, forwards) = meshes.zip(&plan.start.meshes).find_map(|(mesh, start)| {
        let forwards = mesh.connection.turns_between([a, b])?;
        Some((mesh, *start, forwards))
    })?;
    let sign = if forwards { 1.0 } else { -1.0 };
    let parts = motor_parts(plan, mesh)?;
    let moved = parts.iter().map(|part| part.factor * part.start);
    let start = emitter.number(sign * (start - moved.sum::<f64>()));
    let terms = parts.iter().map(|part| {
        let (factor, index) = (emitter.number(sign * part.factor), integer(part.motor));
        quote!(+ #factor * motors[#index])
    });
    Some(quote!({
        let motors = Self::motors(self);
        #start #(#terms)*
    }))
}

/// The part of a motor in the angle of a gear.
struct MotorPart {
    motor: usize,
    factor: f64,
    /// The motor's value at the start.
    start: f64,
}

/// The part of each motor that turns a gear; none if anything but motors turns it.
fn motor_parts(plan: &Plan, mesh: &Mesh) -> Option<Vec<MotorPart>> {
    let part = |(source, part): &(usize, Rational)| match plan.sources[*source] {
        Source::Motor(motor) => Some(MotorPart {
            motor: motor.index(),
            factor: float_of(part),
            start: plan.start.sources[*source],
        }),
        _ => None,
    };
    mesh.parts.iter().map(part).collect()
}
