//! What is seen, in painting order.

use super::block::scalar;
use super::scope::number;
use crate::model::{LinkId, Model, Shape, ShapeKind};
use crate::plan::Plan;
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// One thing that is painted.
pub(super) struct Painted {
    /// Its link: 0 is the ground.
    pub(super) link: usize,
    pub(super) plane: i32,
    outline: TokenStream,
    color: TokenStream,
}

/// What is painted of the ground and of all links whose poses are kept, from the plane farthest from the eye to the nearest; within a
/// plane as declared, the ground's first.
pub(super) fn in_order(model: &Model, program: &Program) -> Vec<Painted> {
    let stored = program.stored.iter().copied();
    let seen = std::iter::once(LinkId::GROUND).chain(stored);
    let all = seen.enumerate().flat_map(|(link, id)| {
        let shapes = model.link(id).shapes.iter();
        shapes.flat_map(move |shape| painted(link, shape, program))
    });
    let mut all: Vec<_> = all.collect();
    all.sort_by_key(|painted| painted.plane);
    all
}

/// What a shape is painted with, from back to front.
fn painted(link: usize, shape: &Shape, program: &Program) -> Vec<Painted> {
    let n = |value| number(program.precision, value);
    let point = |[x, y]: [f64; 2]| {
        let (x, y) = (n(x), n(y));
        quote!([#x, #y])
    };
    let points = |points: &[[f64; 2]]| {
        let points = points.iter().map(|&place| point(place));
        quote!(&[#(#points),*])
    };
    let circle = |center: [f64; 2], radius: f64| {
        let (center, radius) = (point(center), n(radius));
        quote!(Outline::Circle { center: #center, radius: #radius })
    };
    let color = Literal::u8_unsuffixed(shape.color);
    let one = |outline: TokenStream, color: TokenStream| Painted {
        link,
        plane: shape.plane,
        outline,
        color,
    };
    let outline = match &shape.kind {
        ShapeKind::Circle { center, radius } => circle(*center, *radius),
        ShapeKind::Ring {
            center,
            radius,
            hole,
        } => {
            let (center, radius, hole) = (point(*center), n(*radius), n(*hole));
            quote!(Outline::Ring { center: #center, radius: #radius, hole: #hole })
        }
        ShapeKind::Polygon(corners) => {
            let corners = points(corners);
            quote!(Outline::Polygon(#corners))
        }
        ShapeKind::Bar { pins, width } => {
            let line = |share: f64| {
                let (points, width) = (points(pins), n(share * width));
                quote!(Outline::Line { points: #points, width: #width })
            };
            // As `mech_runtime::raster::bar` draws it.
            let mut parts = vec![
                one(line(1.0), quote!(Palette::darker(#color))),
                one(line(0.76), quote!(#color)),
            ];
            for &pin in pins {
                parts.push(one(circle(pin, 0.28 * width), quote!(Palette::INK)));
                parts.push(one(circle(pin, 0.14 * width), quote!(Palette::EYE)));
            }
            return parts;
        }
    };
    vec![one(outline, quote!(#color))]
}

/// All of them as tokens, and the box around them wherever they are moved to.
pub(super) fn shapes(model: &Model, plan: &Plan, program: &Program) -> TokenStream {
    let entries = in_order(model, program).into_iter().map(|painted| {
        let Painted {
            link,
            outline,
            color,
            ..
        } = painted;
        let link = Literal::usize_unsuffixed(link);
        quote!(Shape { link: #link, outline: #outline, color: #color })
    });
    let scalar = scalar(program);
    let corners = crate::motion::extent::extent(model, plan, program).map(|corner| {
        let [x, y] = corner.map(|value| number(program.precision, value));
        quote!([#x, #y])
    });
    quote! {
        pub(super) const SHAPES: &[Shape<#scalar>] = &[#(#entries),*];

        pub(super) const EXTENT: [[#scalar; 2]; 2] = [#(#corners),*];
    }
}
