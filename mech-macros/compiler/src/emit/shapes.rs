//! The shapes, in the order in which they are painted.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::model::{FormulaId, LinkId, Shape, ShapeKind};
use crate::motion::extent::extent;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// One outline of a shape.
pub(super) struct Painted {
    /// The number of its link: 0 is the ground.
    pub(super) link: usize,
    pub(super) plane: i32,
    /// At the start.
    outline: TokenStream,
    /// Now, an expression in a method, if params change it.
    changed: Option<TokenStream>,
    color: TokenStream,
}

impl Painted {
    /// The statement that paints it as params have it; none if they do not change it.
    pub(super) fn fill(&self) -> Option<TokenStream> {
        let (outline, color) = (self.changed.as_ref()?, &self.color);
        let pose = match self.link.checked_sub(1) {
            None => quote!(Pose::identity()),
            Some(index) => {
                let index = integer(index);
                quote!(self.position.poses[#index])
            }
        };
        Some(quote!(Canvas::fill(canvas, #outline, #pose, #color);))
    }
}

/// The outlines of the ground and of all links whose poses are known, from the plane farthest from the eye to the nearest; within a
/// plane as declared, the ground's first.
pub(super) fn painting_order(emitter: &Emitter<'_>) -> Vec<Painted> {
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
    let at_start = |share: f64, value: f64, _| emitter.number(share * value);
    let now = |share: f64, value: f64, formula: Option<FormulaId>| {
        if formula.is_none() {
            return at_start(share, value, None);
        }
        let (share, value) = (emitter.number(share), emitter.present(value, formula));
        quote!(#share * #value)
    };
    let changed = shape.varies().then(|| colored_outlines(shape, now));
    let mut changed = changed.into_iter().flatten();
    let outlines = colored_outlines(shape, at_start).into_iter();
    let painted = outlines.map(|(outline, color)| Painted {
        link,
        plane: shape.plane,
        outline,
        changed: changed.next().map(|(outline, _)| outline),
        color,
    });
    painted.collect()
}

/// Outlines and their colours. `scaled` gives so many times a number of the shape, of which it also takes the formula.
fn colored_outlines(
    shape: &Shape,
    scaled: impl Fn(f64, f64, Option<FormulaId>) -> TokenStream,
) -> Vec<(TokenStream, TokenStream)> {
    let (values, count) = (shape.kind.numbers(), shape.kind.reach().0.len());
    let n = |index: usize, share: f64| scaled(share, values[index], shape.formulas[index]);
    let point = |index: usize| {
        let [x, y] = [0, 1].map(|part| n(2 * index + part, 1.0));
        quote!([#x, #y])
    };
    let points = || {
        let points = (0..count).map(point);
        quote!(&[#(#points),*])
    };
    let length = |index: usize, share: f64| n(2 * count + index, share);
    let circle = |center: usize, share: f64| {
        let (center, radius) = (point(center), length(0, share));
        quote!(Outline::Circle { center: #center, radius: #radius })
    };
    let color = Literal::u8_unsuffixed(shape.color);
    let outline = match shape.kind {
        ShapeKind::Circle { .. } => circle(0, 1.0),
        ShapeKind::Ring { .. } => {
            let (center, radius, hole) = (point(0), length(0, 1.0), length(1, 1.0));
            quote!(Outline::Ring { center: #center, radius: #radius, hole: #hole })
        }
        ShapeKind::Polygon(_) => {
            let corners = points();
            quote!(Outline::Polygon(#corners))
        }
        ShapeKind::Bar { .. } => {
            let line = |share: f64| {
                let (points, width) = (points(), length(0, share));
                quote!(Outline::Line { points: #points, width: #width })
            };
            // As `mech_runtime::raster::bar` draws it.
            let mut all = vec![
                (line(1.0), quote!(Palette::darker(#color))),
                (line(0.76), quote!(#color)),
            ];
            for pin in 0..count {
                all.push((circle(pin, 0.28), quote!(Palette::INK)));
                all.push((circle(pin, 0.14), quote!(Palette::EYE)));
            }
            return all;
        }
    };
    vec![(outline, quote!(#color))]
}

/// The constants `SHAPES` and `EXTENT`, the box around all of them wherever they move.
pub(super) fn shapes(emitter: &Emitter<'_>) -> TokenStream {
    let entries = painting_order(emitter).into_iter().map(|painted| {
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
