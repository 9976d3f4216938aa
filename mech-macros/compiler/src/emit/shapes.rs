//! What is seen, in painting order.

use super::block::scalar;
use super::params;
use super::scope::number;
use crate::model::{FormulaId, LinkId, Model, Shape, ShapeKind};
use crate::plan::Plan;
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// One thing that is painted.
pub(super) struct Painted {
    /// Its link: 0 is the ground.
    pub(super) link: usize,
    pub(super) plane: i32,
    /// Its outline at the start.
    outline: TokenStream,
    /// Its outline now, an expression inside a method, if params change it.
    changed: Option<TokenStream>,
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
    let at_start = |share: f64, value: f64, _| number(program.precision, share * value);
    let now = |share: f64, value: f64, formula: Option<FormulaId>| match formula {
        None => at_start(share, value, None),
        Some(_) => {
            let (share, value) = (
                number(program.precision, share),
                params::present(program, value, formula),
            );
            quote!(#share * #value)
        }
    };
    let changed: Vec<_> = if shape.varies() {
        parts(shape, now)
    } else {
        Vec::new()
    };
    let changed = changed.into_iter().map(|(outline, _)| Some(outline));
    let parts = parts(shape, at_start).into_iter();
    let parts = parts.zip(changed.chain(std::iter::repeat(None)));
    let painted = parts.map(|((outline, color), changed)| Painted {
        link,
        plane: shape.plane,
        outline,
        changed,
        color,
    });
    painted.collect()
}

/// Outlines and colours. `scaled` writes so many times a number of the shape, and how that is computed if it depends on params.
fn parts(
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
            let lines = [
                (line(1.0), quote!(Palette::darker(#color))),
                (line(0.76), quote!(#color)),
            ];
            let eyes = (0..count).flat_map(|pin| {
                [
                    (circle(pin, 0.28), quote!(Palette::INK)),
                    (circle(pin, 0.14), quote!(Palette::EYE)),
                ]
            });
            return lines.into_iter().chain(eyes).collect();
        }
    };
    vec![(outline, quote!(#color))]
}

/// The painting of a part that params change: nothing of one that they do not.
pub(super) fn fill(painted: &Painted) -> Option<TokenStream> {
    let Painted {
        link,
        changed,
        color,
        ..
    } = painted;
    let outline = changed.as_ref()?;
    let pose = match link.checked_sub(1) {
        None => quote!(Pose::identity()),
        Some(place) => {
            let place = Literal::usize_unsuffixed(place);
            quote!(self.position.poses[#place])
        }
    };
    Some(quote!(Canvas::fill(canvas, #outline, #pose, #color);))
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
