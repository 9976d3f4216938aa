//! What is seen, in painting order.

use super::block::scalar;
use super::scope::number;
use crate::model::{LinkId, Model, Shape, ShapeKind};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The shapes of the ground and of all links whose poses are kept, from the plane farthest from the eye to the nearest; within a plane
/// as declared, the ground's first. Each with its link: 0 is the ground.
pub(super) fn in_order<'m>(model: &'m Model, program: &Program) -> Vec<(usize, &'m Shape)> {
    let stored = program.stored.iter().copied();
    let seen = std::iter::once(LinkId::GROUND).chain(stored);
    let all = seen.enumerate().flat_map(|(place, link)| {
        let shapes = model.link(link).shapes.iter();
        shapes.map(move |shape| (place, shape))
    });
    let mut all: Vec<_> = all.collect();
    all.sort_by_key(|(_, shape)| shape.plane);
    all
}

/// All of them as tokens.
pub(super) fn shapes(model: &Model, program: &Program) -> TokenStream {
    let n = |value| number(program.precision, value);
    let point = |[x, y]: [f64; 2]| {
        let (x, y) = (n(x), n(y));
        quote!([#x, #y])
    };
    let entries = in_order(model, program).into_iter().map(|(place, shape)| {
        let link = Literal::usize_unsuffixed(place);
        let color = Literal::u8_unsuffixed(shape.color);
        let outline = match &shape.kind {
            ShapeKind::Circle { center, radius } => {
                let (center, radius) = (point(*center), n(*radius));
                quote!(Outline::Circle { center: #center, radius: #radius })
            }
            ShapeKind::Polygon(corners) => {
                let corners = corners.iter().map(|&corner| point(corner));
                quote!(Outline::Polygon(&[#(#corners),*]))
            }
        };
        quote!(Shape { link: #link, outline: #outline, color: #color })
    });
    let scalar = scalar(program);
    quote!(const SHAPES: &[Shape<#scalar>] = &[#(#entries),*];)
}
