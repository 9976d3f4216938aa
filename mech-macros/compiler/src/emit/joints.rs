//! The table of joints, and the method that tells all their coordinates.

use super::added::Added;
use super::block::scalar;
use super::coordinate::{Measure, coordinate};
use super::scope::number;
use crate::model::{AxisId, JointId, JointKind, LinkId, Model};
use crate::plan::Plan;
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// What every mechanism has of its joints.
pub(super) fn added(
    model: &Model,
    plan: &Plan,
    program: &Program,
    visibility: &syn::Visibility,
) -> Added {
    let scalar = scalar(program);
    let table: Vec<Entry<'_>> = model
        .declared_joints()
        .map(|joint| Entry {
            model,
            program,
            joint,
            coordinate: coordinate(model, plan, program, joint)
                .filter(|_| model.shows_joint(joint)),
        })
        .collect();
    let count = Literal::usize_unsuffixed(table.len());
    let infos = table.iter().map(Entry::info);
    let values = table.iter().map(Entry::value);
    Added {
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
        trait_methods: quote! {
            type Joints = [Option<#scalar>; #count];
            const JOINTS: &'static [JointInfo<#scalar>] = &known::JOINTS;

            fn joints(&self) -> [Option<#scalar>; #count] {
                Self::joints(self)
            }
        },
        ..Added::default()
    }
}

/// A joint with what its entry has.
struct Entry<'m> {
    model: &'m Model,
    program: &'m Program,
    joint: JointId,
    /// What its coordinate is measured in, and the expression of it.
    coordinate: Option<(Measure, TokenStream)>,
}

impl Entry<'_> {
    /// Its entry in the table.
    fn info(&self) -> TokenStream {
        let joint = self.model.joint(self.joint);
        let (name, kind) = (&joint.name, self.kind());
        let [first, second] = self.links().map(|link| &self.model.link(link).name);
        let anchors = option(self.axes().map(|axes| {
            let [first, second] = axes.map(|axis| self.anchor(axis));
            quote!([#first, #second])
        }));
        let motor = option(self.model.motor_of(self.joint).map(|motor| {
            let motor = Literal::usize_unsuffixed(motor.index());
            quote!(#motor)
        }));
        let coordinate = option(self.coordinate.as_ref().map(|(measure, _)| {
            let measure = format_ident!("{measure:?}");
            quote!(Coordinate::#measure)
        }));
        quote!(JointInfo::new(#name, JointKind::#kind, [#first, #second], #anchors, #motor, #coordinate))
    }

    /// Its coordinate, inside a method.
    fn value(&self) -> TokenStream {
        option(self.coordinate.as_ref().map(|(_, value)| value.clone()))
    }

    fn kind(&self) -> TokenStream {
        match self.model.joint(self.joint).kind {
            JointKind::Revolute(..) => quote!(Revolute),
            JointKind::Prismatic(_, b) if self.model.seen_axis(b) != b => quote!(Slot),
            JointKind::Prismatic(..) => quote!(Prismatic),
            JointKind::Weld(..) => quote!(Weld),
            JointKind::Gear { .. } => quote!(Gear),
            JointKind::Belt { .. } => quote!(Belt),
            JointKind::Rack { .. } => quote!(Rack),
            JointKind::Cam { .. } => quote!(Cam),
        }
    }

    /// The axes that it makes coincide, as they are seen; none of what rolls and of cams.
    fn axes(&self) -> Option<[AxisId; 2]> {
        let axes = self.model.joint(self.joint).kind.axes()?;
        Some(axes.map(|axis| self.model.seen_axis(axis)))
    }

    fn links(&self) -> [LinkId; 2] {
        match self.axes() {
            Some(axes) => axes.map(|axis| self.model.axis(axis).link),
            None => self.model.ends(self.joint).into(),
        }
    }

    fn anchor(&self, axis: AxisId) -> TokenStream {
        let axis = self.model.axis(axis);
        let pair = |pair: [f64; 2]| {
            let [x, y] = pair.map(|part| number(self.program.precision, part));
            quote!([#x, #y])
        };
        let (at, along) = (pair(axis.at), pair(axis.direction));
        let kept = self.program.place_of(axis.link).map(|place| place + 1);
        let link = kept.or((axis.link == LinkId::GROUND).then_some(0));
        let link = option(link.map(|link| {
            let link = Literal::usize_unsuffixed(link);
            quote!(#link)
        }));
        quote!(Anchor::new(#link, #at, #along))
    }
}

/// An expression that there may be.
fn option(value: Option<TokenStream>) -> TokenStream {
    match value {
        None => quote!(Option::None),
        Some(value) => quote!(Option::Some(#value)),
    }
}
