//! Texts, and what is understood of them or told about them.

mod expression;
mod law;
mod link;
mod messages;
mod model;
mod offer;
mod param;
mod part;
mod rolling;
mod setting;
mod slot;

use super::{Message, Parsed, parse};
use proc_macro2::TokenStream;

/// Line and column, both from 1.
type Spot = (usize, usize);

/// Reads a text.
fn parsed(text: &str) -> Parsed {
    parse(text.parse::<TokenStream>().expect("the text is made of tokens"))
}

/// Reads a text in which nothing is wrong.
fn good(text: &str) -> Parsed {
    let parsed = parsed(text);
    let errors: Vec<_> = parsed.errors.iter().map(|error| &error.text).collect();
    assert!(errors.is_empty(), "{errors:#?}");
    parsed
}

/// Takes the marks `«` and `»` out of a text: the text, and the places that they enclosed.
fn places_of(marked: &str) -> (String, Vec<(Spot, Spot)>) {
    let (mut text, mut places, mut start) = (String::new(), Vec::new(), None);
    let (mut line, mut column) = (1, 1);
    for character in marked.chars() {
        match character {
            '«' => start = Some((line, column)),
            '»' => places.push((start.take().expect("a mark was opened"), (line, column))),
            _ => {
                text.push(character);
                (line, column) = if character == '\n' { (line + 1, 1) } else { (line, column + 1) };
            }
        }
    }
    (text, places)
}

/// Returns the first offer of a message: the text to be written, or else the text that it quotes.
fn first_offer(message: &str) -> Option<&str> {
    let quoted = || message.split('`').nth(1);
    Message::offer(message).or_else(quoted)
}

/// A text with something else in the place of its first mark.
fn with_offer(marked: &str, offer: &str) -> Option<String> {
    let (before, rest) = marked.split_once('«')?;
    let (_, after) = rest.split_once('»')?;
    Some(format!("{before}{offer}{after}"))
}

/// Where a message stands.
fn place(message: &Message) -> (Spot, Spot) {
    let spot = |spot: proc_macro2::LineColumn| (spot.line, spot.column + 1);
    let place = &message.place;
    (spot(place.start.start()), spot(place.end.end()))
}
