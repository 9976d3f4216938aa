//! What the struct of a mechanism has more if points are traced.

use super::added::Added;
use super::block::scalar;
use super::items::user_ident;
use super::params;
use crate::model::{Model, Shape, Trace};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use std::ops::Range;

/// What traces, and shapes that params change, add to a mechanism.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
) -> Added {
    let scalar = scalar(program);
    let draw = quote! {
        fn draw(&self, canvas: &mut impl Canvas<#scalar>) {
            Self::draw(self, canvas);
        }
    };
    if model.traces.is_empty() {
        let mut shapes = model.links.iter().flat_map(|link| &link.shapes);
        let changes = shapes.any(Shape::varies);
        return Added {
            trait_methods: if changes { draw } else { TokenStream::new() },
            ..Added::default()
        };
    }
    let mut items = Added {
        record: quote!(Traced::record(self);),
        instance_record: quote!(Traced::record(instance)),
        trait_methods: draw,
        ..Added::default()
    };
    let (mut pushes, mut clears) = (TokenStream::new(), TokenStream::new());
    for trace in &model.traces {
        let (name, field) = names(places, model, trace);
        let length = Literal::usize_unsuffixed(trace.length);
        let place = place(model, program, trace);
        let doc = format!(
            " The last places of point `{name}` in the scene, {} at most: one for each move.",
            trace.length
        );
        items.fields.extend(quote! {
            #field: #krate::Trace<#krate::generated::#scalar, #length>,
        });
        items.at_rest.extend(quote!(#field: Trace::new(),));
        pushes.extend(quote!(Trace::push(&mut self.#field, #place);));
        clears.extend(quote!(Trace::clear(&mut self.#field);));
        items.methods.extend(quote! {
            #[doc = #doc]
            #[must_use]
            #visibility const fn #field(&self) -> &Trace<#scalar, #length> {
                &self.#field
            }
        });
    }
    items.methods.extend(quote! {
        /// Forgets where the traced points have been.
        #visibility const fn clear_traces(&mut self) {
            #clears
        }
    });
    items.records = pushes;
    items
}

/// What a trace is of, and what it is called.
fn names(places: &Places, model: &Model, trace: &Trace) -> (String, Ident) {
    let axis = model.axis(trace.point);
    let (link, point) = (&model.link(axis.link).name, axis.own_name());
    let field = user_ident(&format!("{link}_{point}_trace"), places, axis.origin);
    (format!("{link}.{point}"), field)
}

/// Where a traced point is.
fn place(model: &Model, program: &Program, trace: &Trace) -> TokenStream {
    let at = params::place(model, program, trace.point);
    let link = model.axis(trace.point).link;
    let index = Literal::usize_unsuffixed(program.kept_pose(link));
    quote!(self.position.poses[#index].apply(#at))
}

/// The painting of all shapes and traces, from the plane farthest from the eye to the nearest.
pub(super) fn painting(places: &Places, model: &Model, program: &Program) -> TokenStream {
    let shapes = super::shapes::in_order(model, program);
    let behind = |trace: &Trace| -> usize {
        let before = |(place, plane): (usize, i32)| match trace.plane {
            Some(own) => plane < own || (plane == own && place == 0),
            // Behind all links: the first of their shapes is the limit.
            None => place == 0,
        };
        let all = shapes.iter().map(|painted| (painted.link, painted.plane));
        all.take_while(|shape| before(*shape)).count()
    };
    let mut traces: Vec<(usize, &Trace)> = model
        .traces
        .iter()
        .map(|trace| (behind(trace), trace))
        .collect();
    traces.sort_by_key(|(behind, _)| *behind);
    let mut tokens = TokenStream::new();
    let mut traces = traces.into_iter().peekable();
    // From which shape on nothing is painted yet: as many as possible are painted at once.
    let mut first = 0;
    for place in 0..=shapes.len() {
        let fill = shapes.get(place).and_then(super::shapes::fill);
        let is_next = |(behind, _): &(usize, &Trace)| *behind == place;
        let interrupts = fill.is_some() || traces.peek().is_some_and(is_next);
        if (interrupts || place == shapes.len()) && first < place {
            tokens.extend(paint(first..place, shapes.len()));
            first = place;
        }
        while let Some((_, trace)) = traces.next_if(is_next) {
            let (_, field) = names(places, model, trace);
            let color = Literal::u8_unsuffixed(trace.color);
            tokens.extend(quote!(Trace::draw(&self.#field, canvas, #color);));
        }
        if let Some(fill) = fill {
            tokens.extend(fill);
            first = place + 1;
        }
    }
    if shapes.is_empty() {
        tokens.extend(paint(0..0, 0));
    }
    tokens
}

/// The painting of some of all shapes.
fn paint(some: Range<usize>, all: usize) -> TokenStream {
    let [from, to] = [some.start, some.end].map(Literal::usize_unsuffixed);
    let shapes = match (some.start == 0, some.end == all) {
        (true, true) => quote!(known::SHAPES),
        (false, true) => quote!(known::SHAPES.get(#from..).unwrap_or_default()),
        (_, false) => quote!(known::SHAPES.get(#from..#to).unwrap_or_default()),
    };
    quote!(generated::paint(#shapes, &self.position.poses, canvas);)
}
