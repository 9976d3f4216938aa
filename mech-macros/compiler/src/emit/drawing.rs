//! The methods that return and paint what is seen.

use super::Parts;
use super::emitter::Emitter;
use super::overlay;
use super::shapes::fill;
use super::tokens::integer;
use super::traces::trace_ident;
use crate::looks::Symbols;
use crate::model::{Model, Quality, Trace};
use proc_macro2::TokenStream;
use quote::quote;
use std::ops::Range;

/// `EXTENT`, `picture`, `poses` and `draw`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, model, .. } = emitter;
    let links = integer(emitter.program.poses.len());
    let (picture, doc) = (picture(model), picture_doc(model));
    let painting = painting(emitter);
    let methods = quote! {
                /// The smallest upright box around all that is seen, wherever its motors move it: lower left and upper right
                /// corner, in scene units.
                #visibility const EXTENT: [[#scalar; 2]; 2] = known::EXTENT;

                #doc
                #[must_use]
                #visibility fn picture<const W: usize, const H: usize>() -> #picture<{ W }, { H }> {
                    let mut picture = #picture::new();
                    #picture::look_at(&mut picture, <Self as Mechanism>::view(W, H));
                    picture
                }

                /// The poses of the moving links in the scene, in the order of their declaration.
                #[must_use]
                #visibility const fn poses(&self) -> &[Pose<#scalar>; #links] {
                    &self.position.poses
                }

                /// Paints every shape, from the plane farthest from the eye to the nearest.
                #visibility fn draw(&self, canvas: &mut impl Canvas<#scalar>) {
                    #painting
                }
    };
    let mut parts = Parts { known: symbols_table(emitter), ..Parts::methods(methods) };
    // The trait's own method paints what is at the start.
    if model.paints_more() {
        parts.trait_items = trait_draw(emitter);
    }
    parts
}

/// The trait's `draw` of a mechanism whose own paints more than the shapes at the start.
fn trait_draw(emitter: &Emitter<'_>) -> TokenStream {
    let scalar = &emitter.scalar;
    quote! {
        fn draw(&self, canvas: &mut impl Canvas<#scalar>) {
            Self::draw(self, canvas);
        }
    }
}

/// The type of the pictures that a mechanism makes.
pub(super) fn picture(model: &Model) -> TokenStream {
    match model.quality {
        Quality::Hard => quote!(Frame),
        Quality::Smooth => quote!(Smooth),
    }
}

/// The documentation of `picture`.
fn picture_doc(model: &Model) -> TokenStream {
    match model.quality {
        Quality::Hard => quote! {
            /// An empty picture that looks at all of it, wherever its motors move it.
            ///
            /// It takes `W` × `H` bytes on the stack, and 768 for its palette. For a large picture, which would overflow
            /// the stack, `mech_runtime::HeapFrame::of` makes the same on the heap, with feature `std`.
        },
        Quality::Smooth => quote! {
            /// An empty picture with soft edges that looks at all of it, wherever its motors move it.
            ///
            /// It takes 4 × `W` × (`H` + 16) bytes on the stack, and 2 KiB besides. For a large picture, which would overflow
            /// the stack, `mech_runtime::HeapSmooth::of` makes the same on the heap, with feature `std`.
        },
    }
}

/// The statements that paint all shapes and traces, from the plane farthest from the eye to the nearest.
fn painting(emitter: &Emitter<'_>) -> TokenStream {
    let shapes = &emitter.looks.painted;
    let traces = emitter.model.traces.iter();
    let mut traces: Vec<(usize, &Trace)> =
        traces.map(|trace| (emitter.looks.behind(trace.plane), trace)).collect();
    traces.sort_by_key(|(behind, _)| *behind);
    let mut traces = traces.into_iter().peekable();
    let mut tokens = TokenStream::new();
    // From this shape on nothing is painted yet: as many as possible are painted at once.
    let mut first = 0;
    for number in 0..=shapes.len() {
        let fill = shapes.get(number).and_then(|painted| fill(emitter, painted));
        let is_next = |(behind, _): &(usize, &Trace)| *behind == number;
        let ends = number == shapes.len() || fill.is_some() || traces.peek().is_some_and(is_next);
        if ends && first < number {
            tokens.extend(paint(first..number, shapes.len()));
            first = number;
        }
        while let Some((_, trace)) = traces.next_if(is_next) {
            let field = trace_ident(emitter, trace);
            let color = proc_macro2::Literal::u8_unsuffixed(trace.color);
            tokens.extend(quote!(Trace::draw(&self.#field, canvas, #color);));
        }
        if let Some(fill) = fill {
            tokens.extend(fill);
            first = number + 1;
        }
    }
    tokens.extend(symbols(emitter));
    if tokens.is_empty() {
        tokens.extend(paint(0..0, 0));
    }
    tokens
}

/// The table of the symbols that are painted over the shapes, unless the overlay has it; nothing if there are none.
fn symbols_table(emitter: &Emitter<'_>) -> TokenStream {
    match &emitter.looks.symbols {
        Some(Symbols::Elastic { symbols, .. }) => {
            overlay::elastic_table(emitter, symbols).constant(emitter)
        }
        Some(Symbols::Diagram) if !emitter.model.effects.overlay => {
            overlay::symbols_table(emitter).constant(emitter)
        }
        _ => TokenStream::new(),
    }
}

/// The statement that paints symbols over all shapes; nothing if there are none.
fn symbols(emitter: &Emitter<'_>) -> TokenStream {
    match &emitter.looks.symbols {
        None => TokenStream::new(),
        Some(Symbols::Diagram) => {
            let table = overlay::symbols_table(emitter).path(emitter);
            quote!(Overlay::draw(&Overlay::new().links(true), #table, &self.position.poses, canvas);)
        }
        Some(Symbols::Elastic { symbols, unit }) => {
            let table = overlay::elastic_table(emitter, symbols).path(emitter);
            let unit = emitter.number(*unit);
            quote!(generated::paint_symbols(#table, &self.position.poses, #unit, canvas);)
        }
    }
}

/// The statement that paints some of all shapes as they are at the start.
fn paint(some: Range<usize>, all: usize) -> TokenStream {
    let [from, to] = [some.start, some.end].map(integer);
    let shapes = match (some.start == 0, some.end == all) {
        (true, true) => quote!(known::SHAPES),
        (false, true) => quote!(const { known::SHAPES.split_at(#from).1 }),
        (true, false) => quote!(const { known::SHAPES.split_at(#to).0 }),
        (false, false) => quote!(const { known::SHAPES.split_at(#to).0.split_at(#from).1 }),
    };
    quote!(generated::paint(#shapes, &self.position.poses, canvas);)
}
