//! The texts of the parts that come with the runtime.

use proc_macro2::{Group, Span, TokenStream, TokenTree};

/// Stands in for the runtime: a part that is asked to add itself to a mechanism is written down instead.
mod text {
    macro_rules! expand_mechanism {
        ($($krate:ident)::+; part $($part:tt)*) => {
            stringify!($($part)*)
        };
    }
    pub(super) use expand_mechanism;
}

macro_rules! parts {
    ($($name:ident)*) => {
        /// The names and the texts of all parts.
        const PARTS: &[(&str, &str)] = &[
            $((stringify!($name), mech_runtime::parts::$name! { { crate::document::library::text } }),)*
        ];
    };
}

parts! {
    Cylinder Pantograph ScissorStage Peaucellier JansenLeg KlannLeg EpicyclicStage Geneva Oldham Toggle EngineBank
}

/// The part of this name as it stands in a mechanism, but for the word `part`. All of it is said to stand at one place.
pub(super) fn part(name: &str, place: Span) -> Option<TokenStream> {
    let (_, text) = PARTS.iter().find(|(known, _)| *known == name)?;
    let tokens: TokenStream = text.parse().ok()?;
    Some(at(tokens, place))
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
    use super::PARTS;
    use std::{fs, path::Path};

    #[test]
    fn all_parts_of_the_runtime_are_known() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mech-runtime/src/parts.rs");
        let text = fs::read_to_string(path).expect("the runtime's parts");
        let declared = text.lines().filter_map(|line| {
            let name = line.trim_start().strip_prefix("pub ")?;
            name.split(|letter: char| !letter.is_alphanumeric()).next()
        });
        let known: Vec<&str> = PARTS.iter().map(|(name, _)| *name).collect();
        assert_eq!(known, declared.collect::<Vec<_>>());
    }

    #[test]
    fn parts_can_be_read() {
        for (name, text) in PARTS {
            assert!(text.starts_with(name), "{text}");
            assert!(text.parse::<proc_macro2::TokenStream>().is_ok(), "{text}");
        }
    }
}
