//! The table of joints, and the method that returns all their coordinates.

use super::MANY;
use super::Parts;
use super::coordinate::coordinate as coordinate_of;
use super::emitter::Emitter;
use super::tokens::{integer, option};
use crate::model::{AxisId, FORWARD, JointId, JointKind};
use mech_core::Coordinate as Measure;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// `JOINTS` and `joints`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, model, .. } = emitter;
    let (mut joints, mut values) = (Vec::new(), Vec::new());
    for joint in model.declared_joints() {
        let coordinate = Some(joint).filter(|&joint| model.shows_joint(joint));
        let coordinate = coordinate.and_then(|joint| coordinate_of(emitter, joint));
        joints.push((joint, coordinate.as_ref().map(|found| found.measure)));
        values.push(option(coordinate.map(|coordinate| {
            let joint = model.joint(joint);
            if joint.name.contains('.') {
                // Views have the methods of joints in instances.
                return coordinate.value;
            }
            let name = emitter.ident(&joint.name, joint.origin);
            quote!(Self::#name(self))
        })));
    }
    let count = integer(joints.len());
    let table = if joints.len() < MANY {
        let infos = joints.iter();
        let infos = infos.map(|(joint, measure)| info(emitter, *joint, *measure));
        quote!([#(#infos),*])
    } else {
        table(emitter, &joints)
    };
    Parts {
        known: quote! {
            pub(super) const JOINTS: [JointInfo<#scalar>; #count] = #table;
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

/// The entries of all joints: rows of those that are pins as most are, which the Rust compiler reads sooner, and the others one by one.
fn table(emitter: &Emitter<'_>, joints: &[(JointId, Option<Measure>)]) -> TokenStream {
    let zero = emitter.number(0.0);
    let (mut rows, mut others) = (Vec::new(), Vec::new());
    for (number, (joint, measure)) in joints.iter().enumerate() {
        if let Some(row) = pin(emitter, *joint, *measure) {
            rows.push(row);
        } else {
            let (number, info) = (integer(number), info(emitter, *joint, *measure));
            rows.push(quote!(("", [0, 0], [[#zero; 2]; 2])));
            others.push(quote!(joints[#number] = #info;));
        }
    }
    let links = emitter.program.links.iter();
    let along = emitter.pair(FORWARD);
    quote!({
        #[allow(unused_mut, reason = "all of them may be pins")]
        let mut joints = pins([#(#rows),*], &["ground", #(#links),*], #along);
        #(#others)*
        joints
    })
}

/// The row of a pin whose angle no motor gives; none of any other joint.
fn pin(emitter: &Emitter<'_>, id: JointId, measure: Option<Measure>) -> Option<TokenStream> {
    let model = emitter.model;
    let JointKind::Revolute(a, b) = model.joint(id).kind else {
        return None;
    };
    if measure != Some(Measure::Angle) || model.motor_of(id).is_some() {
        return None;
    }
    let axes = [a, b].map(|axis| model.axis(model.seen_axis(axis)));
    if axes.iter().any(|axis| axis.direction != FORWARD) {
        return None;
    }
    let numbers = axes.map(|axis| emitter.link_number(axis.link));
    let [a, b] = [integer(numbers[0]?), integer(numbers[1]?)];
    let [at, other] = axes.map(|axis| emitter.pair(axis.at));
    let name = &model.joint(id).name;
    Some(quote!((#name, [#a, #b], [#at, #other])))
}

/// The entry of a joint in the table.
fn info(emitter: &Emitter<'_>, id: JointId, measure: Option<Measure>) -> TokenStream {
    let model = emitter.model;
    let joint = model.joint(id);
    let kind = match joint.kind {
        JointKind::Prismatic(_, b) if model.seen_axis(b) != b => mech_core::JointKind::Slot,
        kind => kind.plain(),
    };
    let kind = format_ident!("{kind:?}");
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
    let coordinate = option(measure.map(|measure| {
        let measure = format_ident!("{measure:?}");
        quote!(Coordinate::#measure)
    }));
    quote!(JointInfo::new(#name, JointKind::#kind, [#first, #second], #anchors, #motor, #coordinate))
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
