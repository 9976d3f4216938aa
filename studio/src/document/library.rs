//! The texts of the parts that come with the runtime.

use mech_compiler::PartText;
use mech_runtime::parts;
use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};

/// The part of this name as it stands in a mechanism, but for the word `part`. All of it is said to stand where the name does.
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

/// A part of the runtime, as it is offered to be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PartOffer {
    pub(crate) name: String,
    /// Its numbers with their values, as in a use of it: `(arm = 4, ratio = 2)`; empty if it has none.
    numbers: String,
    pub(crate) ports: Vec<String>,
}

impl PartOffer {
    /// All parts of the runtime.
    pub(crate) fn all() -> Vec<Self> {
        PartText::all(parts::SOURCE)
            .map(|part| Self::of(&part))
            .collect()
    }

    fn of(part: &PartText) -> Self {
        let mut numbers = String::new();
        let mut ports = Vec::new();
        for tree in part.body.clone() {
            match tree {
                TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => {
                    numbers = group.to_string().replace(" ,", ",");
                }
                TokenTree::Group(group) => ports = ports_of(group.stream()),
                _ => {}
            }
        }
        Self {
            name: part.name.to_string(),
            numbers,
            ports,
        }
    }

    /// The body of a use of it under a name, with a link for each port.
    pub(crate) fn use_as(&self, name: &str, links: &[String]) -> String {
        let missing = ["LINK".to_owned()];
        let links = links.iter().chain(missing.iter().cycle());
        let lent = self.ports.iter().zip(links);
        let lent: Vec<String> = lent
            .map(|(port, link)| format!("{port} = {link}"))
            .collect();
        format!(
            "{name}: {}{} {{ {} }}",
            self.name,
            self.numbers,
            lent.join(", ")
        )
    }
}

/// The names of the ports in the inside of a part.
fn ports_of(body: TokenStream) -> Vec<String> {
    let trees: Vec<TokenTree> = body.into_iter().collect();
    let pairs = trees.windows(2).filter_map(|pair| match pair {
        [TokenTree::Ident(word), TokenTree::Ident(name)] if word == "port" => {
            Some(name.to_string())
        }
        _ => None,
    });
    pairs.collect()
}

#[cfg(test)]
mod tests {
    use super::{PartOffer, part};
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

    #[test]
    fn a_use_of_a_part_lends_a_link_to_each_port() {
        let offers = PartOffer::all();
        assert_eq!(offers.len(), 11);
        let find = |name: &str| offers.iter().find(|offer| offer.name == name).expect(name);
        let links = ["ground".to_owned(), "boom".to_owned()];
        let cylinder = find("Cylinder").use_as("ram", &links);
        assert_eq!(cylinder, "ram: Cylinder { base = ground, load = boom }");
        let pantograph = find("Pantograph").use_as("copier", &[]);
        assert_eq!(
            pantograph,
            "copier: Pantograph(arm = 4, ratio = 2) { frame = LINK }"
        );
    }
}
