//! What is seen, in painting order.

use super::block::scalar;
use super::scope::number;
use crate::model::{Model, ShapeKind};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The shapes of all links, from the plane farthest from the eye to the nearest; within a plane as declared.
pub(super) fn shapes(model: &Model, program: &Program) -> TokenStream {
    let all = model.link_ids().flat_map(|link| {
        model
            .link(link)
            .shapes
            .iter()
            .map(move |shape| (link, shape))
    });
    let mut all: Vec<_> = all.collect();
    all.sort_by_key(|(_, shape)| shape.plane);
    let n = |value| number(program.precision, value);
    let point = |[x, y]: [f64; 2]| {
        let (x, y) = (n(x), n(y));
        quote!([#x, #y])
    };
    let entries = all.into_iter().map(|(link, shape)| {
        let link = Literal::usize_unsuffixed(link.index());
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
