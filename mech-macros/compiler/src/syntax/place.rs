//! Places in the text, and messages that point at them.

use crate::model::{Origin, in_32_bits};
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote_spanned};

/// A stretch of the text: from the start of one token to the end of another.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The first token.
    pub start: Span,
    /// The last token.
    pub end: Span,
}

impl Place {
    /// The place of these tokens; the macro's own call site if there are none.
    #[must_use]
    pub fn of(tokens: &impl ToTokens) -> Self {
        let mut spans = tokens.to_token_stream().into_iter().map(|tree| tree.span());
        let start = spans.next().unwrap_or_else(Span::call_site);
        Self { start, end: spans.last().unwrap_or(start) }
    }

    /// The place of one token.
    #[must_use]
    pub fn at(span: Span) -> Self {
        Self { start: span, end: span }
    }

    /// From the start of this place to the end of another.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self { start: self.start, end: other.end }
    }
}

/// Where everything was declared, by [`Origin`].
#[derive(Debug, Default)]
pub struct Places(Vec<Place>);

impl Places {
    /// Notes a place down and names it.
    pub fn note(&mut self, place: Place) -> Origin {
        self.0.push(place);
        // `Origin(0)` is the default of things that no text declared, such as the ground.
        Origin(in_32_bits(self.0.len()))
    }

    /// All places, in the order of their origins, the first of which is `Origin(1)`.
    pub fn all(&self) -> impl Iterator<Item = Place> + '_ {
        self.0.iter().copied()
    }

    /// The place of this origin; the macro's own call site if no text declared it.
    #[must_use]
    pub fn get(&self, origin: Origin) -> Place {
        let index = (origin.0 as usize).checked_sub(1);
        index
            .and_then(|index| self.0.get(index))
            .copied()
            .unwrap_or_else(|| Place::at(Span::call_site()))
    }
}

/// A message to the user about a place: lower-case, without a final period, notes and helps on lines of their own.
#[derive(Clone, Debug)]
pub struct Message {
    /// Where.
    pub place: Place,
    /// The text.
    pub text: String,
}

impl Message {
    /// So many things are told of a text at once.
    pub const MOST: usize = 50;

    /// A message about a place.
    #[must_use]
    pub fn new(place: Place, text: impl Into<String>) -> Self {
        Self { place, text: text.into() }
    }

    /// The text that stands in the place of a message after what its words offer: what they say to write, or ask for.
    #[must_use]
    pub fn offer(words: &str) -> Option<&str> {
        let first = words.split("\n\n").next()?;
        let offer = first.split_once("write `").or(first.split_once("did you mean `"));
        let (offer, _) = offer?.1.split_once('`')?;
        Some(offer)
    }

    /// The text that should be left out by these words, which stands in the place of the message.
    #[must_use]
    pub fn left_out(words: &str) -> Option<&str> {
        let first = words.split("\n\n").next()?;
        let (_, rest) = first.split_once("leave `")?;
        rest.split_once("` out").map(|(left_out, _)| left_out)
    }

    /// The first of these messages. If there are many, one more tells the number of those left out, and of `others` that are not made.
    #[must_use]
    pub fn first(mut messages: Vec<Self>, others: usize) -> Vec<Self> {
        let left_out = messages.len().saturating_sub(Self::MOST) + others;
        messages.truncate(Self::MOST);
        if let Some(last) = messages.last().filter(|_| left_out > 0) {
            let are = if left_out == 1 { "is 1" } else { &format!("are {left_out}") };
            let text =
                format!("there {are} more like these, or of other kinds; mend the first ones");
            messages.push(Self::new(last.place, text));
        }
        messages
    }

    /// The item that makes the compiler show the message at its place.
    #[must_use]
    pub fn to_compile_error(&self) -> TokenStream {
        let text = &self.text;
        // The compiler underlines from the first token of an invocation to its last.
        let path = quote_spanned!(self.place.start=> ::core::compile_error!);
        let body = quote_spanned!(self.place.end=> { #text });
        quote::quote!(#path #body)
    }
}
