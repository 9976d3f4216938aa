//! What the struct of a mechanism has more if points are traced.

use super::added::Added;
use super::block::scalar;
use super::items::user_ident;
use super::scope::number;
use crate::model::{Model, Trace};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// What traces add to a mechanism.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
) -> Added {
    if model.traces.is_empty() {
        return Added::default();
    }
    let scalar = scalar(program);
    let mut items = Added {
        record: quote!(Traced::record(self);),
        instance_record: quote!(Traced::record(instance)),
        trait_methods: quote! {
            fn draw(&self, canvas: &mut impl Canvas<#scalar>) {
                Self::draw(self, canvas);
            }
        },
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
    let axis = model.axis(trace.point);
    let [x, y] = [0, 1].map(|part| match program.place_state(trace.point, part) {
        None => number(program.precision, axis.at[part]),
        Some(state) => {
            let state = Literal::usize_unsuffixed(state);
            quote!(self.position.state[#state])
        }
    });
    let index = Literal::usize_unsuffixed(program.pose_index(axis.link));
    quote!(self.position.poses[#index].apply([#x, #y]))
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
    let mut painted = 0;
    let paint =
        |shapes: TokenStream| quote!(generated::paint(#shapes, &self.position.poses, canvas););
    for (behind, trace) in traces {
        if behind > painted {
            let [from, to] = [painted, behind].map(Literal::usize_unsuffixed);
            tokens.extend(paint(
                quote!(known::SHAPES.get(#from..#to).unwrap_or_default()),
            ));
            painted = behind;
        }
        let (_, field) = names(places, model, trace);
        let color = Literal::u8_unsuffixed(trace.color);
        tokens.extend(quote!(Trace::draw(&self.#field, canvas, #color);));
    }
    if painted == 0 {
        tokens.extend(paint(quote!(known::SHAPES)));
    } else if painted < shapes.len() {
        let from = Literal::usize_unsuffixed(painted);
        tokens.extend(paint(
            quote!(known::SHAPES.get(#from..).unwrap_or_default()),
        ));
    }
    tokens
}
