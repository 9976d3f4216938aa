//! The methods of a mechanism as tokens. There may be thousands, and of most nothing but the name and the body is asked for.

use super::merge::is_word;
use crate::bug::bug;
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::ImplItemFn;

/// An item of an implementation.
pub(super) enum Item {
    /// A method.
    Method(Method),
    /// A constant.
    Other(TokenStream),
}

/// A method, in pieces.
#[derive(Clone)]
pub(super) struct Method {
    pub(super) name: Ident,
    attributes: TokenStream,
    visibility: TokenStream,
    signature: TokenStream,
    body: Group,
}

impl Method {
    /// Keeps it from being called elsewhere.
    pub(super) fn hide(&mut self) {
        self.visibility = TokenStream::new();
    }

    /// The tokens between its braces.
    pub(super) fn body(&self) -> TokenStream {
        self.body.stream()
    }

    /// Reads all of it.
    pub(super) fn read(&self) -> ImplItemFn {
        match syn::parse2(self.to_token_stream()) {
            Ok(method) => method,
            Err(error) => bug!("method `{}` cannot be read: {error}", self.name),
        }
    }
}

impl ToTokens for Method {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        for part in [&self.attributes, &self.visibility, &self.signature] {
            tokens.extend(part.clone());
        }
        self.body.to_tokens(tokens);
    }
}

impl ToTokens for Item {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Method(method) => method.to_tokens(tokens),
            Self::Other(other) => tokens.extend(other.clone()),
        }
    }
}

/// Splits an implementation into its items.
pub(super) fn items(all: TokenStream) -> Vec<Item> {
    let mut trees = all.into_iter().peekable();
    let mut items = Vec::new();
    while trees.peek().is_some() {
        items.push(item(&mut trees));
    }
    items
}

fn item(trees: &mut std::iter::Peekable<impl Iterator<Item = TokenTree>>) -> Item {
    let is_mark = |tree: &TokenTree, mark: char| matches!(tree, TokenTree::Punct(one) if one.as_char() == mark);
    let mut attributes = TokenStream::new();
    while let Some(sign) = trees.next_if(|tree| is_mark(tree, '#')) {
        attributes.extend([sign].into_iter().chain(trees.next()));
    }
    let mut visibility = TokenStream::new();
    if let Some(word) = trees.next_if(|tree| is_word(tree, "pub")) {
        let within = trees.next_if(|tree| is_group(tree, Delimiter::Parenthesis));
        visibility.extend([word].into_iter().chain(within));
    }
    let mut signature = TokenStream::new();
    let mut name = None;
    while let Some(tree) = trees.next() {
        match (tree, &name) {
            (TokenTree::Group(body), Some(name)) if body.delimiter() == Delimiter::Brace => {
                return Item::Method(Method {
                    name: Ident::clone(name),
                    attributes,
                    visibility,
                    signature,
                    body,
                });
            }
            (end, None) if is_mark(&end, ';') => {
                return Item::Other(quote!(#attributes #visibility #signature #end));
            }
            (tree, _) => {
                if is_word(&tree, "fn")
                    && let Some(TokenTree::Ident(next)) = trees.peek()
                {
                    name = Some(next.clone());
                }
                signature.extend([tree]);
            }
        }
    }
    bug!("a method has no end")
}

fn is_group(tree: &TokenTree, delimiter: Delimiter) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == delimiter)
}
