//! The text of a mechanism: the only room that knows `syn` and spans.

mod place;

pub use place::{Message, Place, Places};

use crate::model::Model;
use proc_macro2::{Ident, TokenStream};

/// What the text says.
pub struct Parsed {
    /// The `struct` line, if it could be read.
    pub header: Option<Header>,
    /// The mechanism; where there are errors, as much of it as could be understood.
    pub model: Model,
    /// Where everything in the model was declared.
    pub places: Places,
    /// Everything that is wrong with the text, in the order of the text.
    pub errors: Vec<Message>,
}

/// The `struct` line.
pub struct Header {
    /// Its attributes, documentation among them.
    pub attributes: Vec<syn::Attribute>,
    /// Its visibility.
    pub visibility: syn::Visibility,
    /// The name of the struct.
    pub name: Ident,
}

/// Reads the body of a `mechanism!`.
#[must_use]
pub fn parse(_input: TokenStream) -> Parsed {
    todo!()
}
