//! Parts from elsewhere: `mechanism_part!` keeps the tokens of a part in a macro, which `use path::Part;` in a mechanism calls back.
//!
//! So a part crosses files and crates without any of them being read by the compiler of mechanisms.

use super::compile_errors;
use crate::syntax::{self, Message, Place};
use proc_macro2::{Delimiter, Ident, Spacing, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// An import in the text of a mechanism, and the remainder of the text.
#[derive(Clone, Debug)]
pub struct Import {
    /// The path of the part, as it is written.
    pub path: TokenStream,
    /// The text without the import.
    pub others: TokenStream,
}

impl Import {
    /// The first `use path::Part;` of a text, if there is one.
    #[must_use]
    pub fn first(text: &TokenStream) -> Option<Self> {
        let trees: Vec<TokenTree> = text.clone().into_iter().collect();
        let mut starts = trees.iter().enumerate().filter(|(index, tree)| {
            let begins = index
                .checked_sub(1)
                .is_none_or(|before| ends(&trees[before]));
            begins && matches!(tree, TokenTree::Ident(word) if word == "use")
        });
        let (start, length) =
            starts.find_map(|(start, _)| Some((start, length_of_path(&trees[start + 1..])?)))?;
        let path = trees[start + 1..=start + length].iter().cloned().collect();
        let mut others = trees;
        others.drain(start..start + length + 2);
        Some(Self {
            path,
            others: others.into_iter().collect(),
        })
    }

    /// A text in which all imported parts are written out. `part` gives the text of each, from its name on.
    ///
    /// # Errors
    /// The first import that `part` does not know.
    pub fn write_out(
        mut text: TokenStream,
        part: impl Fn(&Self) -> Option<TokenStream>,
    ) -> Result<TokenStream, Self> {
        while let Some(import) = Self::first(&text) {
            let Some(part) = part(&import) else {
                return Err(import);
            };
            let others = import.others;
            text = quote!(#others part #part);
        }
        Ok(text)
    }

    /// The name of the part: the last word of the path.
    #[must_use]
    pub fn name(&self) -> Option<Ident> {
        match self.path.clone().into_iter().last()? {
            TokenTree::Ident(name) => Some(name),
            _ => None,
        }
    }

    /// The call of the macro that adds the part.
    pub(super) fn call(&self, krate: &TokenStream) -> TokenStream {
        let Self { path, others } = self;
        quote!(#path! { { #krate } #others })
    }
}

/// Whether a statement ends with this token.
fn ends(tree: &TokenTree) -> bool {
    match tree {
        TokenTree::Punct(mark) => mark.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        _ => false,
    }
}

/// How many tokens the path of Rust has that stands before a `;`. A single word is one, too: a macro in scope.
fn length_of_path(trees: &[TokenTree]) -> Option<usize> {
    let length = trees.iter().position(|tree| match tree {
        TokenTree::Punct(mark) => mark.as_char() != ':' && mark.as_char() != '$',
        TokenTree::Ident(_) => false,
        _ => true,
    })?;
    let is_end = matches!(&trees[length], TokenTree::Punct(mark) if mark.as_char() == ';');
    // One colon alone stands in the use of a part.
    let is_use = trees[..length].iter().enumerate().any(|(index, tree)| {
        let follows = index > 0 && is_joint(&trees[index - 1]);
        matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ':')
            && !is_joint(tree)
            && !follows
    });
    (is_end && length > 0 && !is_use).then_some(length)
}

fn is_joint(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Punct(mark) if mark.spacing() == Spacing::Joint)
}

/// The body of a `mechanism_part!`: attributes, a visibility, and a part without the word `part`.
#[derive(Clone, Debug)]
pub struct PartText {
    /// The name of the part.
    pub name: Ident,
    /// The part as it stands in the text of a mechanism, but for the word `part`.
    pub body: TokenStream,
    attributes: TokenStream,
    visibility: TokenStream,
    is_public: bool,
}

impl PartText {
    /// Reads the body of a `mechanism_part!`.
    ///
    /// # Errors
    /// Everything that is wrong with the text.
    pub fn read(input: &TokenStream) -> Result<Self, Vec<Message>> {
        let mut trees: Vec<TokenTree> = input.clone().into_iter().collect();
        let mut is_public = false;
        let mut visibility = TokenStream::new();
        // Documentation first.
        let mut attributes = TokenStream::new();
        while matches!(trees.first(), Some(TokenTree::Punct(mark)) if mark.as_char() == '#') {
            attributes.extend(trees.drain(..2.min(trees.len())));
        }
        if matches!(trees.first(), Some(TokenTree::Ident(word)) if word == "pub") {
            visibility.extend(trees.drain(..1));
            is_public = true;
            if matches!(trees.first(), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis)
            {
                visibility.extend(trees.drain(..1));
                is_public = false;
            }
        }
        let Some(TokenTree::Ident(name)) = trees.first().cloned() else {
            let text = "expected the name of a part, as `pub Leg(size = 1) { ... }`";
            return Err(vec![Message::new(Place::of(input), text)]);
        };
        let body: TokenStream = trees.into_iter().collect();
        let errors = syntax::parse(quote!(struct Part; part #body)).errors;
        if !errors.is_empty() {
            return Err(errors);
        }
        Ok(Self {
            name,
            body,
            attributes,
            visibility,
            is_public,
        })
    }

    /// The part of this name, if a `mechanism_part!` of this Rust source declares it.
    #[must_use]
    pub fn find(source: &str, name: &Ident) -> Option<Self> {
        Self::all(source).find(|part| part.name == *name)
    }

    /// All parts of a Rust file that can be read.
    pub fn all(source: &str) -> impl Iterator<Item = Self> {
        let calls = source
            .parse()
            .map(|tokens| macro_calls(tokens, "mechanism_part"));
        let calls = calls.unwrap_or_default().into_iter();
        calls.filter_map(|part| Self::read(&part).ok())
    }

    /// The macro that adds the part to the text of a mechanism.
    fn exported_macro(&self) -> TokenStream {
        let Self {
            name,
            body,
            attributes,
            visibility,
            is_public,
        } = self;
        let kept = format_ident!("__part_{name}", span = name.span());
        let export = is_public.then(|| quote!(#[doc(hidden)] #[macro_export]));
        quote! {
            #export
            macro_rules! #kept {
                ({ $($krate:tt)* } $($text:tt)*) => {
                    $($krate)*::expand_mechanism! { $($krate)*; $($text)* part #body }
                };
            }
            #attributes
            #[allow(unused_imports, reason = "nobody has to use a part")]
            #visibility use #kept as #name;
        }
    }
}

/// Expands the body of a `mechanism_part!`.
#[must_use]
pub fn expand_part(input: &TokenStream) -> TokenStream {
    PartText::read(input).map_or_else(
        |errors| compile_errors(&errors),
        |part| part.exported_macro(),
    )
}

/// The tokens in the brackets of each call of a macro in a Rust source, outside of all other brackets.
#[must_use]
pub fn macro_calls(source: TokenStream, name: &str) -> Vec<TokenStream> {
    let trees: Vec<TokenTree> = source.into_iter().collect();
    let call = |trees: &[TokenTree]| match trees {
        [
            TokenTree::Ident(ident),
            TokenTree::Punct(mark),
            TokenTree::Group(group),
        ] if ident == name && mark.as_char() == '!' => Some(group.stream()),
        _ => None,
    };
    trees.windows(3).filter_map(call).collect()
}
