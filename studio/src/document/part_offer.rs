//! The parts of the runtime, as they are offered to be used.

use mech_compiler::PartText;
use mech_runtime::parts;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

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
        PartText::all(parts::SOURCE).map(|part| Self::of(&part)).collect()
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
        Self { name: part.name.to_string(), numbers, ports }
    }

    /// The body of a use of it under a name, with a link for each port.
    pub(crate) fn use_as(&self, name: &str, links: &[String]) -> String {
        let missing = ["LINK".to_owned()];
        let links = links.iter().chain(missing.iter().cycle());
        let lent = self.ports.iter().zip(links);
        let lent: Vec<String> = lent.map(|(port, link)| format!("{port} = {link}")).collect();
        format!("{name}: {}{} {{ {} }}", self.name, self.numbers, lent.join(", "))
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
    use super::PartOffer;

    #[test]
    fn a_use_of_a_part_lends_a_link_to_each_port() {
        let offers = PartOffer::all();
        assert_eq!(offers.len(), 11);
        let find = |name: &str| offers.iter().find(|offer| offer.name == name).expect(name);
        let links = ["ground".to_owned(), "boom".to_owned()];
        let cylinder = find("Cylinder").use_as("ram", &links);
        assert_eq!(cylinder, "ram: Cylinder { base = ground, load = boom }");
        let pantograph = find("Pantograph").use_as("copier", &[]);
        assert_eq!(pantograph, "copier: Pantograph(arm = 4, ratio = 2) { frame = LINK }");
    }
}
