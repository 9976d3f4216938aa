//! The text of a mechanism: the only room that knows `syn` and spans.

mod ast;
mod color;
mod expr;
mod grammar;
pub mod lexer;
pub mod limits;
mod listing;
mod lower;
mod place;
mod shape;
mod source;
pub mod spelling;
#[cfg(test)]
mod tests;
mod written;

pub use grammar::STATEMENTS;
pub use listing::{ListedName, ListedNumber, Listing, Noun};
pub use place::{Message, Place, Places};
pub use source::{Edit, Edits, Rewriter, Source, StatementText, Tokens};

use crate::api::Asked;
use crate::model::{Measurand, Model};
use proc_macro2::{Ident, Span, TokenStream};

/// A parsed text.
pub struct Parsed {
    /// The `struct` line, if it could be read.
    pub header: Option<Header>,
    /// The mechanism; where there are errors, as much of it as could be understood. Also then, no two of its
    /// declared links, shown joints and points would be the same method, and all names are fit for one.
    pub model: Model,
    /// The number of motors in the text, with those that an error keeps out of the model.
    pub motors: usize,
    /// Its statements from which methods are made, right or wrong.
    pub asked: Asked,
    /// Where everything in the model was declared.
    pub places: Places,
    /// Everything that is wrong with the text, in the order of the text.
    pub errors: Vec<Message>,
    /// The text itself.
    pub source: Source,
}

/// The `struct` line.
#[derive(Clone)]
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
pub fn parse(input: TokenStream) -> Parsed {
    let source = Source::read(input);
    let lowered = source.lower();
    let text = source.tree();
    let (motors, asked) = (text.motors, text.asked);
    let header = text.header.as_ref().map(|(header, _)| header.clone());
    drop(text);
    Parsed {
        motors,
        asked,
        header,
        model: lowered.model,
        places: lowered.places,
        errors: lowered.errors,
        source,
    }
}

/// Reads what a table measures of a mechanism: `velocity:coupler.tip` gives both its parts, `transmission` that of no dyad in particular.
///
/// # Errors
/// What is wrong with the text.
pub fn measurands(model: &Model, text: &str) -> Result<Vec<Measurand>, Message> {
    let tokens = text.parse().map_err(|_| {
        let place = Place::at(Span::call_site());
        Message::new(place, "a quote or a bracket has no partner")
    })?;
    let expr = grammar::read_measurand(tokens)?;
    lower::measurands(model, &expr, text.trim())
}

/// Lists the names and numbers of the body of a `mechanism!`, as far as it can be read.
#[must_use]
pub fn listing(input: TokenStream) -> Listing {
    Listing::of(&grammar::read(input))
}
