//! The table of joints, and the method that returns all their coordinates.

use super::coordinate::{Coordinate, coordinate as coordinate_of};
use super::emitter::Emitter;
use super::parts::Parts;
use super::tokens::{integer, option};
use crate::model::{AxisId, JointId, JointKind, Model};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// `JOINTS` and `joints`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter {
        visibility,
        scalar,
        model,
        ..
    } = emitter;
    let (mut infos, mut values) = (Vec::new(), Vec::new());
    for joint in model.declared_joints() {
        let coordinate = Some(joint).filter(|&joint| model.shows_joint(joint));
        let coordinate = coordinate.and_then(|joint| coordinate_of(emitter, joint));
        infos.push(info(emitter, joint, coordinate.as_ref()));
        values.push(option(coordinate.map(|coordinate| coordinate.value)));
    }
    let count = integer(infos.len());
    Parts {
        known: quote! {
            pub(super) const JOINTS: [JointInfo<#scalar>; #count] = [#(#infos),*];
        },
        methods: quote! {
            /// The joints, in the order of their declaration.
            #visibility const JOINTS: [JointInfo<#scalar>; #count] = known::JOINTS;

            /// The coordinates of all joints, in the order of `JOINTS`, in radians or scene units: none of joints that have none or
            /// are not shown.
            #[must_use]
            #visibility fn joints(&self) -> [Option<#scalar>; #count] {
                [#(#values),*]
            }
        },
        trait_items: quote! {
            type Joints = [Option<#scalar>; #count];
            const JOINTS: &'static [JointInfo<#scalar>] = &known::JOINTS;

            fn joints(&self) -> [Option<#scalar>; #count] {
                Self::joints(self)
            }
        },
        ..Parts::default()
    }
}

/// The entry of a joint in the table.
fn info(emitter: &Emitter<'_>, id: JointId, coordinate: Option<&Coordinate>) -> TokenStream {
    let model = emitter.model;
    let (joint, kind) = (model.joint(id), kind(model, id));
    let name = &joint.name;
    let axes = joint.kind.axes();
    let axes = axes.map(|axes| axes.map(|axis| model.seen_axis(axis)));
    let links = match axes {
        Some(axes) => axes.map(|axis| model.axis(axis).link),
        None => model.ends(id).into(),
    };
    let [first, second] = links.map(|link| &model.link(link).name);
    let anchors = option(axes.map(|axes| {
        let [first, second] = axes.map(|axis| anchor(emitter, axis));
        quote!([#first, #second])
    }));
    let motor = option(model.motor_of(id).map(|motor| {
        let motor = integer(motor.index());
        quote!(#motor)
    }));
    let coordinate = option(coordinate.map(|Coordinate { measure, .. }| {
        let measure = format_ident!("{measure:?}");
        quote!(Coordinate::#measure)
    }));
    quote!(JointInfo::new(#name, JointKind::#kind, [#first, #second], #anchors, #motor, #coordinate))
}

/// The variant of the runtime's `JointKind`.
fn kind(model: &Model, joint: JointId) -> TokenStream {
    match model.joint(joint).kind {
        JointKind::Revolute(..) => quote!(Revolute),
        JointKind::Prismatic(_, b) if model.seen_axis(b) != b => quote!(Slot),
        JointKind::Prismatic(..) => quote!(Prismatic),
        JointKind::Weld(..) => quote!(Weld),
        JointKind::Gear { .. } => quote!(Gear),
        JointKind::Belt { .. } => quote!(Belt),
        JointKind::Rack { .. } => quote!(Rack),
        JointKind::Cam { .. } => quote!(Cam),
    }
}

/// The anchor of a joint on one of its links.
fn anchor(emitter: &Emitter<'_>, axis: AxisId) -> TokenStream {
    let axis = emitter.model.axis(axis);
    let (at, along) = (emitter.pair(axis.at), emitter.pair(axis.direction));
    let link = option(emitter.link_number(axis.link).map(|link| {
        let link = integer(link);
        quote!(#link)
    }));
    quote!(Anchor::new(#link, #at, #along))
}
