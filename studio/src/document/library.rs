//! The texts of the parts that come with the runtime.

use mech_compiler::PartText;
use mech_runtime::parts;
use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};

/// The text of a part of the library, without the word `part`. All its tokens have the place of the name that was given.
pub(super) fn part(name: &Ident) -> Option<TokenStream> {
    let part = PartText::find(parts::SOURCE, name)?;
    Some(at(part.body, name.span()))
}

fn at(tokens: TokenStream, place: Span) -> TokenStream {
    let moved = tokens.into_iter().map(|tree| {
        let mut tree = match tree {
            TokenTree::Group(group) => {
                Group::new(group.delimiter(), at(group.stream(), place)).into()
            }
            other => other,
        };
        tree.set_span(place);
        tree
    });
    moved.collect()
}

#[cfg(test)]
mod tests {
    use super::part;
    use mech_runtime::parts;
    use proc_macro2::{Ident, Span};

    #[test]
    fn all_parts_of_the_runtime_are_known() {
        let lines = parts::SOURCE.lines().map(str::trim_start);
        let declared = lines.filter_map(|line| {
            let name = line.strip_prefix("pub ")?;
            name.split(|letter: char| !letter.is_alphanumeric()).next()
        });
        let parts: Vec<&str> = declared.filter(|word| *word != "const").collect();
        assert_eq!(parts.len(), 11);
        for name in parts {
            let text = part(&Ident::new(name, Span::call_site()))
                .expect(name)
                .to_string();
            assert!(text.starts_with(name), "{text}");
        }
    }
}
