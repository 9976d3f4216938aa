//! One body for the methods of alike instances: where their bodies differ in numbers only, those become a table.

use crate::cancel;
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::quote;
use std::collections::HashSet;

/// A piece of a body.
enum Piece {
    /// A literal, with its sign.
    Number(TokenStream),
    Group(Group),
    Other(TokenTree),
}

/// One body for several, in which `self` is `this`, and a number that they do not share is chosen by `index`. None, if they differ in more
/// than numbers, or say `Self`.
pub(super) fn merged(
    bodies: &[TokenStream],
    this: &TokenStream,
    index: &TokenStream,
) -> Option<TokenStream> {
    let mut all: Vec<_> = bodies.iter().map(|body| pieces(body).into_iter()).collect();
    let mut merged = TokenStream::new();
    loop {
        let next: Vec<Piece> = all.iter_mut().filter_map(Iterator::next).collect();
        if next.is_empty() {
            return Some(merged);
        }
        if next.len() < bodies.len() {
            return None;
        }
        merged.extend(merged_piece(&next, this, index)?);
    }
}

fn merged_piece(pieces: &[Piece], this: &TokenStream, index: &TokenStream) -> Option<TokenStream> {
    match pieces.first()? {
        Piece::Number(first) => {
            let numbers = pieces.iter().map(|piece| match piece {
                Piece::Number(number) => Some(number),
                _ => None,
            });
            let numbers: Vec<&TokenStream> = numbers.collect::<Option<_>>()?;
            let first_text = first.to_string();
            if numbers.iter().all(|number| number.to_string() == first_text) {
                return Some(first.clone());
            }
            Some(quote!([#(#numbers),*][#index]))
        }
        Piece::Group(first) => {
            let insides = pieces.iter().map(|piece| match piece {
                Piece::Group(group) if group.delimiter() == first.delimiter() => {
                    Some(group.stream())
                }
                _ => None,
            });
            let insides: Vec<TokenStream> = insides.collect::<Option<_>>()?;
            let inside = merged(&insides, this, index)?;
            let group = TokenTree::Group(Group::new(first.delimiter(), inside));
            Some(group.into())
        }
        Piece::Other(first) => {
            let is_same =
                |piece: &Piece| matches!(piece, Piece::Other(other) if is_alike(first, other));
            if is_word(first, "Self") || !pieces.iter().all(is_same) {
                return None;
            }
            Some(if is_word(first, "self") { this.clone() } else { first.clone().into() })
        }
    }
}

/// Compares two words or marks.
fn is_alike(one: &TokenTree, other: &TokenTree) -> bool {
    match (one, other) {
        (TokenTree::Ident(one), TokenTree::Ident(other)) => one == other,
        (TokenTree::Punct(one), TokenTree::Punct(other)) => one.as_char() == other.as_char(),
        _ => false,
    }
}

pub(super) fn is_word(tree: &TokenTree, word: &str) -> bool {
    matches!(tree, TokenTree::Ident(ident) if ident == word)
}

/// The pieces of a body. A minus is the sign of a literal behind it, unless it stands between two values.
fn pieces(body: &TokenStream) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut is_behind_value = false;
    let mut trees = body.clone().into_iter().peekable();
    while let Some(tree) = trees.next() {
        let is_minus = matches!(&tree, TokenTree::Punct(mark) if mark.as_char() == '-');
        let literal = trees
            .next_if(|next| is_minus && !is_behind_value && matches!(next, TokenTree::Literal(_)));
        // A method is called on the literal before its sign counts.
        let is_called =
            matches!(trees.peek(), Some(TokenTree::Punct(mark)) if mark.as_char() == '.');
        is_behind_value = literal.is_some() || !matches!(tree, TokenTree::Punct(_));
        match (tree, literal) {
            (sign, Some(literal)) if is_called => {
                pieces.extend([Piece::Other(sign), Piece::Number(quote!(#literal))]);
            }
            (sign, Some(literal)) => pieces.push(Piece::Number(quote!(#sign #literal))),
            (TokenTree::Literal(literal), None) => pieces.push(Piece::Number(quote!(#literal))),
            (TokenTree::Group(group), None) => pieces.push(Piece::Group(group)),
            (tree, None) => pieces.push(Piece::Other(tree)),
        }
    }
    pieces
}

/// The names in a text, with those that it has in brackets of any kind.
pub(super) fn names(text: &TokenStream, found: &mut HashSet<String>) {
    cancel::check();
    for tree in text.clone() {
        match tree {
            TokenTree::Ident(name) => {
                found.insert(Ident::to_string(&name));
            }
            TokenTree::Group(group) => names(&group.stream(), found),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::merged;
    use proc_macro2::TokenStream;
    use quote::quote;

    fn merge(bodies: &[&str]) -> Option<String> {
        let bodies = bodies.iter().map(|body| body.parse().expect("tokens"));
        let bodies: Vec<TokenStream> = bodies.collect();
        let merged = merged(&bodies, &quote!(self.whole), &quote!(self.number));
        merged.map(|merged| merged.to_string().replace(' ', ""))
    }

    #[test]
    fn numbers_become_a_table() {
        let merged =
            merge(&["self.poses[3].apply([1.0, -2.0])", "self.poses[9].apply([1.0, 4.5])"]);
        let expected = "self.whole.poses[[3,9][self.number]].apply([1.0,[-2.0,4.5][self.number]])";
        assert_eq!(merged.as_deref(), Some(expected));
    }

    #[test]
    fn a_difference_is_none_of_a_number_and_its_sign() {
        let merged = merge(&["a - 1.0", "a - 2.0"]);
        assert_eq!(merged.as_deref(), Some("a-[1.0,2.0][self.number]"));
        assert_eq!(merge(&["a - 1.0", "a + 1.0"]), None);
        assert_eq!(merge(&["-a", "a"]), None);
        let merged = merge(&["-1.0.f()", "-2.0.f()"]);
        assert_eq!(merged.as_deref(), Some("-[1.0,2.0][self.number].f()"));
    }

    #[test]
    fn what_differs_in_more_than_numbers_is_not_merged() {
        assert_eq!(merge(&["self.a(1)", "self.b(1)"]), None);
        assert_eq!(merge(&["f(1)", "f[1]"]), None);
        assert_eq!(merge(&["f(1, 2)", "f(1)"]), None);
        assert_eq!(merge(&["Self::f(1)", "Self::f(2)"]), None);
        assert_eq!(merge(&["1", "x"]), None);
    }
}
