//! The coordinates of joints.

use super::items::pose;
use super::params;
use super::scope::number;
use crate::model::{AxisId, JointId, JointKind, Model};
use crate::plan::{Mesh, Plan, Rational, Source, Step, float_of};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Whether a joint turns, and the axes between which its coordinate is measured; a gear has none.
pub(super) fn coordinate_axes(model: &Model, joint: JointId) -> Option<(bool, AxisId, AxisId)> {
    let declared = model.joint(joint);
    let (turns, a, b) = match declared.kind {
        JointKind::Revolute(a, b) => (true, a, b),
        JointKind::Prismatic(a, b) => (false, a, b),
        _ => return None,
    };
    (!declared.hidden).then(|| (turns, model.seen_axis(a), model.seen_axis(b)))
}

/// What a coordinate is measured in, and whether it counts whole turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Scene units.
    Length,
    /// Radians between −π and π.
    Angle,
    /// Radians with whole turns.
    Turns,
}

impl Measure {
    /// What documentation says of it.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Length => "scene units",
            Self::Angle => "radians, between −π and π; `continuous` lets it count whole turns",
            Self::Turns => "radians, whole turns since the start included",
        }
    }
}

/// The measure and the expression of a joint's coordinate.
pub(super) fn coordinate(
    model: &Model,
    plan: &Plan,
    program: &Program,
    joint: JointId,
) -> Option<(Measure, TokenStream)> {
    let (turns, a, b) = coordinate_axes(model, joint)?;
    let (measure, function) = if turns {
        (Measure::Angle, quote!(generated::angle))
    } else {
        (Measure::Length, quote!(generated::slide))
    };
    if let Some(motor) = model.motor_of(joint) {
        let index = Literal::usize_unsuffixed(motor.index());
        let value = quote!(Self::motors(self)[#index]);
        let measure = if turns { Measure::Turns } else { measure };
        return Some((measure, value));
    }
    if let Some(state) = program.angle_state(joint) {
        let state = Literal::usize_unsuffixed(state);
        let value = quote!(self.position.state[#state]);
        return Some((Measure::Turns, value));
    }
    if let Some(value) = whole_angle(model, plan, program, joint) {
        return Some((Measure::Turns, value));
    }
    let axis = |id: AxisId| {
        let at = params::place(model, program, id);
        let direction = params::direction(model, program, id);
        let pose = pose(program, model.axis(id).link);
        quote!((#pose, #at, #direction))
    };
    let (a, b) = (axis(a), axis(b));
    Some((measure, quote!(#function(#a, #b))))
}

/// The angle of a joint that motors turn by way of gears: it goes on over any number of turns, as they do.
fn whole_angle(
    model: &Model,
    plan: &Plan,
    program: &Program,
    joint: JointId,
) -> Option<TokenStream> {
    let JointKind::Revolute(a, b) = model.joint(joint).kind else {
        return None;
    };
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
    let moved = parts
        .iter()
        .map(|(_, source, part)| part * plan.start.sources[*source]);
    let start = start - moved.sum::<f64>();
    let n = |value: f64| number(program.precision, value);
    let start = n(sign * start);
    let shares = parts.iter().map(|(motor, _, part)| {
        let (part, index) = (n(sign * part), Literal::usize_unsuffixed(*motor));
        quote!(+ #part * motors[#index])
    });
    Some(quote!({
        let motors = Self::motors(self);
        #start #(#shares)*
    }))
}

/// For each motor that turns a gear the number of its source and its part; none if something else has a part, too.
fn motor_parts(plan: &Plan, mesh: &Mesh) -> Option<Vec<(usize, usize, f64)>> {
    let part = |(source, part): &(usize, Rational)| match plan.sources[*source] {
        Source::Motor(motor) => Some((motor.index(), *source, float_of(part))),
        _ => None,
    };
    mesh.parts.iter().map(part).collect()
}
