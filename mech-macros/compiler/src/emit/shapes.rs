//! The outlines that are painted, in the order in which they are painted.

use super::MANY;
use super::emitter::Emitter;
use super::tokens::integer;
use crate::bug::bug;
use crate::looks::{Outline, Painted, Toothed};
use crate::model::Measure;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The statement that paints an outline as params have it; none if they do not change it.
pub(super) fn fill(emitter: &Emitter<'_>, painted: &Painted) -> Option<TokenStream> {
    if !painted.outline.varies() {
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
    let outline = outline(emitter, &[], &painted.outline, now);
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
    outline: &Outline,
    measure: impl Fn(Measure) -> TokenStream,
) -> TokenStream {
    let point = |place: &[Measure; 2]| {
        let [x, y] = place.map(&measure);
        quote!([#x, #y])
    };
    let points = |places: &[[Measure; 2]]| {
        let points = places.iter().map(point);
        quote!(&[#(#points),*])
    };
    match outline {
        Outline::Circle { center, radius } => {
            let (center, radius) = (point(center), measure(*radius));
            quote!(Outline::Circle { center: #center, radius: #radius })
        }
        Outline::Ring {
            center,
            radius,
            hole,
        } => {
            let (center, radius, hole) = (point(center), measure(*radius), measure(*hole));
            quote!(Outline::Ring { center: #center, radius: #radius, hole: #hole })
        }
        Outline::Polygon(corners) => {
            let corners = points(corners);
            quote!(Outline::Polygon(#corners))
        }
        Outline::Line {
            points: places,
            width,
        } => {
            let (points, width) = (points(places), measure(*width));
            quote!(Outline::Line { points: #points, width: #width })
        }
        Outline::Arc {
            center,
            start,
            angle,
            width,
        } => {
            let [center, start] = [*center, *start].map(|pair| emitter.pair(pair));
            let [angle, width] = [*angle, *width].map(|value| emitter.number(value));
            quote!(Outline::Arc { center: #center, start: #start, angle: #angle, width: #width })
        }
        Outline::Toothed(wheel) => {
            let name = wheel_name(wheels, wheel);
            quote!(Outline::Polygon(&#name))
        }
    }
}

/// The wheels with teeth, each once.
fn wheels<'a>(emitter: &'a Emitter<'_>) -> Vec<&'a Toothed> {
    let mut all: Vec<&Toothed> = Vec::new();
    for painted in &emitter.looks.painted {
        if let Outline::Toothed(wheel) = &painted.outline
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
    let constants = wheels
        .iter()
        .map(|wheel| wheel_constant(emitter, &wheel_name(&wheels, wheel), wheel));
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
        let outline = outline(emitter, wheels, &painted.outline, at_start);
        quote!(Shape { link: #link, outline: #outline, color: #color })
    });
    quote!(pub(super) const SHAPES: &[Shape<#scalar>] = &[#(#entries),*];)
}

/// The constant `SHAPES` as a table, which the Rust compiler reads sooner: `generated::shapes` has the meaning of its rows.
fn shape_table(emitter: &Emitter<'_>, wheels: &[&Toothed]) -> TokenStream {
    let (mut rows, mut numbers, mut points) = (Vec::new(), Vec::new(), Vec::new());
    let n = |measure: &Measure| emitter.number(measure.at_start());
    let point = |place: &[Measure; 2]| {
        let [x, y] = place.each_ref().map(n);
        quote!([#x, #y])
    };
    for painted in &emitter.looks.painted {
        let (kind, count) = match &painted.outline {
            Outline::Circle { center, radius } => {
                numbers.extend(center.iter().chain([radius]).map(n));
                (0, 0)
            }
            Outline::Ring {
                center,
                radius,
                hole,
            } => {
                numbers.extend(center.iter().chain([radius, hole]).map(n));
                (1, 0)
            }
            Outline::Polygon(corners) => {
                points.extend(corners.iter().map(point));
                (2, corners.len())
            }
            Outline::Line {
                points: places,
                width,
            } => {
                numbers.push(n(width));
                points.extend(places.iter().map(point));
                (3, places.len())
            }
            Outline::Arc {
                center,
                start,
                angle,
                width,
            } => {
                let all = center.iter().chain(start).chain([angle, width]);
                numbers.extend(all.map(|number| emitter.number(*number)));
                (4, 0)
            }
            Outline::Toothed(wheel) => (5, wheel_number(wheels, wheel)),
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
