//! The completion of a line.

use super::line::beginnings;
use super::pattern::{Element, What, fit, read};
use super::table::ROWS;
use super::words::words;
use crate::document::Listing;
use mech_compiler::syntax::Noun;

/// Where the last word of a line begins, and what it may become.
pub(crate) fn complete(line: &str, listing: &Listing) -> (usize, Vec<String>) {
    let start = line.rfind(char::is_whitespace).map_or(0, |at| at + 1);
    let begun = &line[start..];
    let Ok(before) = words(&line[..start]) else {
        return (start, Vec::new());
    };
    let mut all: Vec<String> = Vec::new();
    if before.is_empty() {
        all.extend(beginnings().into_iter().map(ToOwned::to_owned));
    } else {
        for row in ROWS {
            let elements = read(row.pattern);
            let Err(misfit) = fit(&elements, &line[..start], &before) else {
                // It could end here, or go on with what was left out.
                all.extend(optional_words(&elements));
                continue;
            };
            if misfit.at == before.len() {
                all.extend(misfit.wants.iter().flat_map(|want| words_for(want, listing)));
            }
        }
    }
    all.retain(|word| word.starts_with(begun) && word != begun);
    all.sort();
    all.dedup();
    (start, all)
}

fn optional_words(elements: &[Element]) -> Vec<String> {
    let optional = elements.iter().filter_map(|element| match element {
        Element::Optional(inner) => match inner.first() {
            Some(Element::Word(word)) => Some((*word).to_owned()),
            _ => None,
        },
        _ => None,
    });
    optional.collect()
}

fn words_for(element: &Element, listing: &Listing) -> Vec<String> {
    let names = |is_it: fn(Noun) -> bool| {
        let declared = listing.names.iter();
        let declared = declared.filter(|one| one.is_declared && one.part.is_none());
        let names = declared.filter(|one| is_it(one.noun)).map(|one| one.path.clone());
        names.collect::<Vec<_>>()
    };
    let with_ground = |mut all: Vec<String>| {
        all.push("ground".to_owned());
        all
    };
    match element {
        Element::Word(word) => vec![(*word).to_owned()],
        Element::Optional(inner) => {
            inner.first().map(|first| words_for(first, listing)).unwrap_or_default()
        }
        Element::Slot { what, .. } => match what {
            What::Link => with_ground(names(|noun| noun == Noun::Body)),
            What::Joint => names(|noun| noun == Noun::Joint),
            What::End => with_ground(names(|noun| matches!(noun, Noun::Body | Noun::Axis))),
            What::Any => names(|_| true),
            What::One(words) => words.iter().map(|&word| word.to_owned()).collect(),
            What::New | What::Value | What::Number | What::Place | What::Rest => Vec::new(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::complete;
    use crate::document::{Document, Listing, Source};

    fn listing() -> Listing {
        let text = "struct A; link crank { point pin = (1, 0); } joint a = revolute(ground, crank) at (0, 0);";
        let document = Document::of(Source::new("a.mech", text));
        let listing = document.listing(&document.declarations()[0]);
        listing.expect("the compiler works").expect("it can be read")
    }

    #[track_caller]
    fn goes_on(line: &str, with: &[&str]) {
        assert_eq!(complete(line, &listing()).1, with, "{line}");
    }

    #[test]
    fn lines_go_on_by_the_table_with_names_of_the_mechanism() {
        goes_on("ren", &["rename"]);
        goes_on("motor ", &["a"]);
        goes_on("join b = rev", &["revolute"]);
        goes_on("join b = revolute cr", &["crank", "crank.pin"]);
        goes_on("move crank.pin ", &["to"]);
        goes_on("motor a ", &["=", "by", "in"]);
        goes_on("point crank.pin at (", &[]);
        goes_on("nonsense ", &[]);
    }
}
