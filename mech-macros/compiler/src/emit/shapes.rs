//! The shapes, in the order in which they are painted.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::model::{LinkId, Shape, ShapeKind};
use crate::motion::extent::extent;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// One outline of a shape.
pub(super) struct Painted {
    /// The number of its link: 0 is the ground.
    pub(super) link: usize,
    pub(super) plane: i32,
    outline: TokenStream,
    color: TokenStream,
}

/// The outlines of the ground and of all links whose poses are known, from the plane farthest from the eye to the nearest; within a
/// plane as declared, the ground's first.
pub(super) fn in_order(emitter: &Emitter<'_>) -> Vec<Painted> {
    let stored = emitter.program.stored.iter().copied();
    let links = std::iter::once(LinkId::GROUND).chain(stored);
    let all = links.enumerate().flat_map(|(link, id)| {
        let shapes = emitter.model.link(id).shapes.iter();
        shapes.flat_map(move |shape| outlines(emitter, link, shape))
    });
    let mut all: Vec<Painted> = all.collect();
    all.sort_by_key(|painted| painted.plane);
    all
}

/// The outlines of a shape, from back to front.
fn outlines(emitter: &Emitter<'_>, link: usize, shape: &Shape) -> Vec<Painted> {
    let n = |value| emitter.number(value);
    let point = |point| emitter.pair(point);
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

/// The constants `SHAPES` and `EXTENT`, the box around all of them wherever they move.
pub(super) fn shapes(emitter: &Emitter<'_>) -> TokenStream {
    let entries = in_order(emitter).into_iter().map(|painted| {
        let Painted {
            link,
            outline,
            color,
            ..
        } = painted;
        let link = integer(link);
        quote!(Shape { link: #link, outline: #outline, color: #color })
    });
    let (scalar, program) = (&emitter.scalar, emitter.program);
    let corners = extent(emitter.model, &emitter.compiled.plan, program);
    let corners = corners.map(|corner| emitter.pair(corner));
    quote! {
        pub(super) const SHAPES: &[Shape<#scalar>] = &[#(#entries),*];

        pub(super) const EXTENT: [[#scalar; 2]; 2] = [#(#corners),*];
    }
}
