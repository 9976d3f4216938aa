//! Expressions of generated code for outlines and symbols.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::bug::bug;
use crate::model::{LinkId, Measure};
use crate::symbols::Spot;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Data that can be written as an expression of generated code.
pub(super) trait Expression {
    fn expression(&self, emitter: &Emitter<'_>) -> TokenStream;
}

/// A number that is no share of another.
impl Expression for Measure {
    fn expression(&self, emitter: &Emitter<'_>) -> TokenStream {
        emitter.present(self.value, self.formula)
    }
}

/// A number of pixels.
impl Expression for f32 {
    fn expression(&self, _: &Emitter<'_>) -> TokenStream {
        let pixels = Literal::f32_unsuffixed(*self);
        quote!(#pixels)
    }
}

/// The number of a link in a table.
impl Expression for LinkId {
    fn expression(&self, emitter: &Emitter<'_>) -> TokenStream {
        let number = emitter.link_number(*self);
        let number = integer(number.unwrap_or_else(|| bug!("link {} has no pose", self.index())));
        quote!(#number)
    }
}

impl Expression for TokenStream {
    fn expression(&self, _: &Emitter<'_>) -> TokenStream {
        self.clone()
    }
}

impl Expression for Spot {
    fn expression(&self, emitter: &Emitter<'_>) -> TokenStream {
        let (link, at) = (self.link.expression(emitter), self.at.expression(emitter));
        quote!(Spot { link: #link, at: #at })
    }
}

impl<E: Expression> Expression for [E; 2] {
    fn expression(&self, emitter: &Emitter<'_>) -> TokenStream {
        let [a, b] = self.each_ref().map(|part| part.expression(emitter));
        quote!([#a, #b])
    }
}

/// The variants of an enum with the names of their parts, each of which is an expression.
macro_rules! expressions {
    ($enum:ident: $($variant:ident $(($part:ident))? $({ $($field:ident),* })?),*) => {
        impl Expression for $enum {
            fn expression(&self, emitter: &Emitter<'_>) -> TokenStream {
                match self {
                    $($enum::$variant $(($part))? $({ $($field),* })? => {
                        $(let $part = $part.expression(emitter);)?
                        $($(let $field = $field.expression(emitter);)*)?
                        quote!($enum::$variant $((#$part))? $({ $($field: #$field),* })?)
                    })*
                }
            }
        }
    };
}
pub(super) use expressions;
