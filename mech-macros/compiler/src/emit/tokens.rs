//! Literals, types and identifiers that all files of this room write.

use crate::bug::bug;
use crate::cancel;
use crate::model::{Origin, Precision};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

/// The literal of a count or an index.
pub(super) fn integer(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// A literal of this precision, in the shortest form that gives exactly this number.
pub(super) fn number(precision: Precision, value: f64) -> TokenStream {
    #[expect(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
    let text = match precision {
        Precision::F32 => format!("{:?}", (value as f32).abs()),
        Precision::F64 => format!("{:?}", value.abs()),
    };
    let literal = text.parse::<Literal>().unwrap_or_else(|_| bug!("{value} is to be a constant"));
    if value < 0.0 { quote!(-#literal) } else { quote!(#literal) }
}

/// The scalar type of a precision.
pub(super) fn scalar(precision: Precision) -> TokenStream {
    match precision {
        Precision::F32 => quote!(f32),
        Precision::F64 => quote!(f64),
    }
}

/// The type of a position of the mechanism that a program moves.
pub(super) fn position(program: &Program) -> TokenStream {
    let (scalar, start) = (scalar(program.precision), &program.start);
    let sizes = [program.inputs(), start.poses.len(), start.state.len()].map(integer);
    quote!(Position<#scalar, #(#sizes),*>)
}

/// An expression of type `Option`.
pub(super) fn option(value: Option<TokenStream>) -> TokenStream {
    match value {
        None => quote!(Option::None),
        Some(value) => quote!(Option::Some(#value)),
    }
}

/// An identifier with the span of the user's declaration. What belongs to an instance of a part has a hidden one.
pub(super) fn user_ident(name: &str, places: &Places, origin: Origin) -> Ident {
    cancel::check();
    if name.contains('.') {
        let mut ident = format_ident!("{}", hidden_method(name));
        // Lints are not to judge it: it is not the user's.
        ident.set_span(Span::mixed_site().located_at(places.get(origin).start));
        return ident;
    }
    let mut ident = format_ident!("{name}");
    ident.set_span(places.get(origin).start);
    ident
}

/// The name of the method for a path: `left[2].foot_tip` becomes `__left_2__foot_tip`. No name in a path has two underscores in a row or
/// one at its end, so no two paths become the same.
pub(super) fn hidden_method(path: &str) -> String {
    cancel::check();
    format!("__{}", path.replace('[', "_").replace(']', "").replace('.', "__"))
}

/// The name of the method that sets something, which may be in an instance of a part.
pub(super) fn setter(name: &str) -> String {
    match name.rsplit_once('.') {
        Some((instance, name)) => format!("{instance}.set_{name}"),
        None => format!("set_{name}"),
    }
}

/// A name with a path as a name for people: `left[2].foot` becomes `left_2_foot`.
pub(super) fn without_path(name: &str) -> String {
    name.replace(['[', '.'], "_").replace(']', "")
}

/// An identifier of the generated code that the user's code cannot see.
pub(super) fn hidden_ident(name: &str) -> Ident {
    // Names come from the user's own identifiers, so they are identifiers too; a keyword becomes one by an underscore.
    let parsed =
        syn::parse_str::<Ident>(name).or_else(|_| syn::parse_str::<Ident>(&format!("{name}_")));
    let mut ident = parsed.unwrap_or_else(|_| bug!("`{name}` is to be a name"));
    ident.set_span(Span::mixed_site());
    ident
}
