//! Parts from elsewhere: `mechanism_part!` keeps the tokens of a part in a macro, which `use path::Part;` in a mechanism calls back.
//!
//! So a part crosses files and crates without any of them being read by the compiler of mechanisms.

use super::compile_errors;
use crate::syntax::{self, Message, Place, limits};
use proc_macro2::{Delimiter, Ident, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Visibility};

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
            let begins = index.checked_sub(1).is_none_or(|before| ends(&trees[before]));
            begins && matches!(tree, TokenTree::Ident(word) if word == "use")
        });
        let (start, length) =
            starts.find_map(|(start, _)| Some((start, length_of_path(&trees[start + 1..])?)))?;
        let path = trees[start + 1..=start + length].iter().cloned().collect();
        let mut others = trees;
        others.drain(start..start + length + 2);
        Some(Self { path, others: others.into_iter().collect() })
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

    /// Returns the fault of the path; none if it is a path.
    #[must_use]
    pub fn fault(&self) -> Option<Message> {
        const ROOTS: [&str; 4] = ["crate", "$crate", "self", "super"];
        let expected = |found: &TokenTree, what: &str| {
            let text = format!("expected {what}, found `{found}`; write `use path::Part;`");
            Some(Message::new(Place::of(&found.to_token_stream()), text))
        };
        let trees: Vec<TokenTree> = self.path.clone().into_iter().collect();
        let mut rest = &trees[..];
        // A path may begin at the root of all crates.
        let mut is_separated = true;
        if let [first, second, others @ ..] = rest
            && is_separator(first, second)
        {
            rest = others;
        }
        let mut may_be_root = true;
        while let [tree, others @ ..] = rest {
            if !is_separated {
                let [second, others @ ..] = others else {
                    return expected(tree, "`::` or `;`");
                };
                if !is_separator(tree, second) {
                    return expected(tree, "`::` or `;`");
                }
                (is_separated, rest) = (true, others);
                continue;
            }
            let text = tree.to_string();
            let is_root = may_be_root && !others.is_empty() && ROOTS.contains(&text.as_str());
            if !is_root && syn::parse_str::<Ident>(&text).is_err() {
                return expected(tree, "the name of a module or a part");
            }
            may_be_root = is_root && text != "crate" && text != "$crate";
            (is_separated, rest) = (false, others);
        }
        let last = trees.last()?;
        if is_separated {
            let text = "the name of a part is missing here; write `use path::Part;`";
            return Some(Message::new(Place::of(&last.to_token_stream()), text));
        }
        None
    }

    /// The call of the part's macro, which adds the part to the text.
    pub(super) fn call(&self, krate: &TokenStream) -> TokenStream {
        let Self { path, others } = self;
        quote!(#path! { { #krate } #others })
    }
}

/// Whether a statement, or an attribute before it, ends with this token.
fn ends(tree: &TokenTree) -> bool {
    match tree {
        TokenTree::Punct(mark) => mark.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() != Delimiter::Parenthesis,
        _ => false,
    }
}

/// Returns the number of tokens of the Rust path before a `;`. A single word is one, too: a macro in scope.
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

/// Whether two tokens are `::`.
fn is_separator(first: &TokenTree, second: &TokenTree) -> bool {
    let is_colon =
        |tree: &TokenTree| matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ':');
    is_colon(first) && is_joint(first) && is_colon(second)
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
        limits::of_tokens(input).map_err(|excess| vec![excess.message()])?;
        let head = |input: ParseStream| {
            let attributes = input.call(Attribute::parse_outer)?;
            let visibility: Visibility = input.parse()?;
            Ok((attributes, visibility, input.parse::<TokenStream>()?))
        };
        let (attributes, visibility, body) = head.parse2(input.clone()).map_err(|error| {
            let place = Place::at(error.span());
            vec![Message::new(place, error.to_string())]
        })?;
        let Some(TokenTree::Ident(name)) = body.clone().into_iter().next() else {
            let text = "expected the name of a part, as `pub Leg(size = 1) { ... }`";
            return Err(vec![Message::new(Place::of(input), text)]);
        };
        let errors = syntax::parse(quote!(struct Part; part #body)).errors;
        if !errors.is_empty() {
            return Err(Message::first(errors, 0));
        }
        Ok(Self {
            name,
            body,
            is_public: matches!(visibility, Visibility::Public(_)),
            attributes: quote!(#(#attributes)*),
            visibility: visibility.into_token_stream(),
        })
    }

    /// The part of this name, if a `mechanism_part!` of this Rust source declares it.
    #[must_use]
    pub fn find(source: &str, name: &Ident) -> Option<Self> {
        Self::all(source).find(|part| part.name == *name)
    }

    /// All parts of a Rust file that can be read.
    pub fn all(source: &str) -> impl Iterator<Item = Self> {
        let calls = source.parse().map(|tokens| macro_calls(tokens, "mechanism_part"));
        let calls = calls.unwrap_or_default().into_iter();
        calls.filter_map(|part| Self::read(&part).ok())
    }

    /// The macro that adds the part to the text of a mechanism.
    fn exported_macro(&self) -> TokenStream {
        let Self { name, body, attributes, visibility, is_public } = self;
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
    PartText::read(input)
        .map_or_else(|errors| compile_errors(&errors), |part| part.exported_macro())
}

/// The tokens in the brackets of each call of a macro in a Rust source, outside of all other brackets.
#[must_use]
pub fn macro_calls(source: TokenStream, name: &str) -> Vec<TokenStream> {
    let trees: Vec<TokenTree> = source.into_iter().collect();
    let call = |trees: &[TokenTree]| match trees {
        [TokenTree::Ident(ident), TokenTree::Punct(mark), TokenTree::Group(group)]
            if ident == name && mark.as_char() == '!' =>
        {
            Some(group.stream())
        }
        _ => None,
    };
    trees.windows(3).filter_map(call).collect()
}
