//! The outlines that are painted, in the order in which they are painted.

use super::MANY;
use super::emitter::Emitter;
use super::expression::{Expression, expressions};
use super::tokens::integer;
use crate::bug::bug;
use crate::looks::{self, Painted, Points, Toothed};
use crate::model::Measure;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// An outline whose parts are expressions.
type Outline = mech_core::Outline<TokenStream, TokenStream>;

expressions! {
    Outline:
    Circle { center, radius },
    Ring { center, radius, hole },
    Polygon(corners),
    Winding(corners),
    Line { points, width },
    Arc { center, start, angle, width }
}

/// The statement that paints an outline as params have it; none if they do not change it.
pub(super) fn fill(emitter: &Emitter<'_>, painted: &Painted) -> Option<TokenStream> {
    if !painted.varies() {
        return None;
    }
    let now = |measure: Measure| {
        if measure.formula.is_none() {
            return emitter.number(measure.at_start());
        }
        let share = emitter.number(measure.share);
        let value = emitter.present(measure.value, measure.formula);
        quote!(#share * #value)
    };
    // No wheel depends on a param.
    let outline = outline(emitter, &[], painted, now);
    let (pose, color) = (emitter.pose(painted.link), color(painted));
    Some(quote!(Canvas::fill(canvas, #outline, #pose, #color);))
}

fn color(painted: &Painted) -> Literal {
    Literal::u8_unsuffixed(painted.color)
}

/// An outline, whose numbers `measure` writes. Wheels have constants.
fn outline(
    emitter: &Emitter<'_>,
    wheels: &[&Toothed],
    painted: &Painted,
    measure: impl Fn(Measure) -> TokenStream,
) -> TokenStream {
    let points = |points: &Points| {
        if let Some(wheel) = &points.wheel {
            let name = wheel_name(wheels, wheel);
            return quote!(&#name);
        }
        let points = points.iter().map(|place| place.map(&measure).expression(emitter));
        quote!(&[#(#points),*])
    };
    painted.outline.map(&measure, points).expression(emitter)
}

/// The wheels with teeth, each once.
fn wheels<'a>(emitter: &'a Emitter<'_>) -> Vec<&'a Toothed> {
    let mut all: Vec<&Toothed> = Vec::new();
    for painted in &emitter.looks.painted {
        let points = painted.outline.points();
        if let Some(wheel) = points.and_then(|points| points.wheel.as_ref())
            && !all.contains(&wheel)
        {
            all.push(wheel);
        }
    }
    all
}

/// The name of the constant with the corners of a wheel.
fn wheel_name(wheels: &[&Toothed], wheel: &Toothed) -> Ident {
    format_ident!("WHEEL_{}", wheel_number(wheels, wheel))
}

fn wheel_number(wheels: &[&Toothed], wheel: &Toothed) -> usize {
    let mut known = wheels.iter();
    let Some(number) = known.position(|known| *known == wheel) else {
        bug!("a wheel that is painted has no constant");
    };
    number
}

/// The constant with the corners of a wheel: its first tooth, repeated.
fn wheel_constant(emitter: &Emitter<'_>, name: &Ident, wheel: &Toothed) -> TokenStream {
    let scalar = &emitter.scalar;
    let pair = |[x, y]: [f64; 2]| {
        let [x, y] = [x, y].map(Literal::f64_unsuffixed);
        quote!([#x, #y])
    };
    let (center, tooth) = (pair(wheel.center), wheel.tooth.iter().copied().map(pair));
    let turn = pair(wheel.turn());
    let corners = match wheel.rim {
        None => quote!(wheel(#center, [#(#tooth),*], #turn)),
        Some(rim) => {
            let rim = Literal::f64_unsuffixed(rim);
            quote!(ring(#center, [#(#tooth),*], #turn, #rim))
        }
    };
    let count = integer(wheel.corners().len());
    let rounded = format_ident!("rounded_{}", scalar.to_string());
    quote!(const #name: [[#scalar; 2]; #count] = #rounded(#corners);)
}

/// The constants `SHAPES` and `EXTENT`, the box around all of them wherever they move.
pub(super) fn shapes(emitter: &Emitter<'_>) -> TokenStream {
    let wheels = wheels(emitter);
    let constants =
        wheels.iter().map(|wheel| wheel_constant(emitter, &wheel_name(&wheels, wheel), wheel));
    let shapes = if emitter.looks.painted.len() < MANY {
        shape_list(emitter, &wheels)
    } else {
        shape_table(emitter, &wheels)
    };
    let scalar = &emitter.scalar;
    let corners = emitter.looks.extent(emitter.model, emitter.compiled);
    let corners = corners.map(|corner| emitter.pair(corner));
    quote! {
        #(#constants)*

        #shapes

        pub(super) const EXTENT: [[#scalar; 2]; 2] = [#(#corners),*];
    }
}

/// The number of a painted link in tables.
fn link_number(emitter: &Emitter<'_>, painted: &Painted) -> Literal {
    let Some(link) = emitter.link_number(painted.link) else {
        bug!("a link that is painted has no pose");
    };
    integer(link)
}

/// The constant `SHAPES`, one by one as a reader likes it.
fn shape_list(emitter: &Emitter<'_>, wheels: &[&Toothed]) -> TokenStream {
    let scalar = &emitter.scalar;
    let entries = emitter.looks.painted.iter().map(|painted| {
        let at_start = |measure: Measure| emitter.number(measure.at_start());
        let (link, color) = (link_number(emitter, painted), color(painted));
        let outline = outline(emitter, wheels, painted, at_start);
        quote!(Shape { link: #link, outline: #outline, color: #color })
    });
    quote!(pub(super) const SHAPES: &[Shape<#scalar>] = &[#(#entries),*];)
}

/// The constant `SHAPES` as a table, which the Rust compiler reads sooner: `generated::shapes` has the meaning of its rows.
fn shape_table(emitter: &Emitter<'_>, wheels: &[&Toothed]) -> TokenStream {
    let (mut rows, mut numbers, mut points) = (Vec::new(), Vec::new(), Vec::new());
    let number = |measure: Measure| emitter.number(measure.at_start());
    for painted in &emitter.looks.painted {
        numbers.extend(painted.outline.numbers().map(number));
        let list = painted.outline.points();
        let wheel = list.and_then(|list| list.wheel.as_ref());
        let places = list.filter(|_| wheel.is_none()).into_iter();
        let places = places.flat_map(|places| places.iter());
        let before = points.len();
        points.extend(places.map(|place| place.map(number).expression(emitter)));
        let count = points.len() - before;
        let (kind, count) = match (&painted.outline, wheel) {
            (_, Some(wheel)) => (5, wheel_number(wheels, wheel)),
            (looks::Outline::Circle { .. }, _) => (0, 0),
            (looks::Outline::Ring { .. }, _) => (1, 0),
            (looks::Outline::Polygon(_) | looks::Outline::Winding(_), _) => (2, count),
            (looks::Outline::Line { .. }, _) => (3, count),
            (looks::Outline::Arc { .. }, _) => (4, 0),
        };
        let (link, color) = (link_number(emitter, painted), color(painted));
        let [kind, count] = [kind, count].map(integer);
        rows.push(quote!([#link, #color, #kind, #count]));
    }
    let scalar = &emitter.scalar;
    let wheels = wheels.iter().map(|wheel| wheel_name(wheels, wheel));
    quote! {
        const POINTS: &[[#scalar; 2]] = &[#(#points),*];

        pub(super) const SHAPES: &[Shape<#scalar>] = &shapes([#(#rows),*], &[#(#numbers),*], POINTS, &[#(&#wheels),*]);
    }
}
