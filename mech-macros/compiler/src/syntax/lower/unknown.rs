//! Names that nothing declares.

use crate::syntax::{ListedName, Listing, Noun, spelling};
use proc_macro2::{TokenStream, TokenTree};

/// A name that nothing declares.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Unknown {
    pub(super) noun: Noun,
    /// The part in whose braces it should be declared.
    pub(super) part: Option<String>,
    /// The link to which it should be fixed, with a dot, if it is a point or a line.
    pub(super) owner: String,
    /// Its own word; none for all that is fixed to a ground that is not declared.
    pub(super) word: String,
}

impl Unknown {
    /// What is fixed to no link.
    pub(super) fn new(noun: Noun, part: Option<String>, name: &impl ToString) -> Self {
        Self { noun, part, owner: String::new(), word: name.to_string() }
    }

    /// What is said instead, if nothing of the ground is declared.
    pub(super) fn without_ground(&self, listing: &Listing) -> Option<String> {
        if (&*self.owner, &*self.word) != ("ground.", "") {
            return None;
        }
        let mut names: Vec<&str> = Vec::new();
        for one in &listing.names {
            let name = one.path.strip_prefix("ground.");
            let name = name.filter(|_| one.noun == Noun::Axis && one.part.is_none());
            names.extend(name.filter(|name| !names.contains(name)));
        }
        Some(format!(
            "there is no `ground {{ ... }}`; declare it, with {} in its braces",
            spelling::list(&names)
        ))
    }

    /// What is said instead of a link that is used by several joints, and is no misspelt one: its declaration was forgotten.
    pub(super) fn undeclared(&self, listing: &Listing) -> Option<String> {
        let is_link = self.noun == Noun::Body && self.owner.is_empty() && !self.word.is_empty();
        let uses = listing.uses(self.noun, self.part.as_deref(), &self.word);
        let uses = uses.filter(|one| one.path == self.word);
        let links = listing.names.iter().filter(|one| {
            let is_like_it = (one.noun, &one.part) == (self.noun, &self.part);
            one.is_declared && is_like_it
        });
        let alike = spelling::alike(&self.word, links.map(|one| &*one.path));
        let is_misspelt = alike.iter().any(|(distance, _)| *distance == 1);
        (is_link && uses.count() > 1 && !is_misspelt)
            .then(|| format!("there is no link `{0}`; declare it with `link {0};`", self.word))
    }

    /// The number of the declaration that is misspelt, if one is, and what is said there: it looks like this name, and is not used.
    pub(super) fn misspelt(
        &self,
        listing: &Listing,
        tokens: &TokenStream,
    ) -> Option<(usize, String)> {
        let (owner, word) = (&self.owner, &self.word);
        let path = format!("{owner}{word}");
        let is_other =
            |one: &ListedName| one.is_declared && one.part == self.part && one.path == path;
        // A name that stands nowhere else may as well be misspelt itself.
        if !stands_again(tokens, word) || listing.names.iter().any(is_other) {
            return None;
        }
        let is_beside = |one: &ListedName| {
            let is_like_it = (one.noun, &one.part) == (self.noun, &self.part);
            one.is_declared && is_like_it && one.path.strip_suffix(one.word()) == Some(owner)
        };
        let all = listing.names.iter();
        let beside: Vec<&str> = all.filter(|one| is_beside(one)).map(ListedName::word).collect();
        let mut unused = spelling::alike(word, beside.into_iter());
        unused.retain(|(_, near)| {
            let path = format!("{owner}{near}");
            let mut uses = listing.uses(self.noun, self.part.as_deref(), &path);
            uses.next().is_none()
        });
        let least = unused.iter().map(|(distance, _)| *distance).min()?;
        unused.retain(|(distance, _)| *distance == least);
        let [(_, near)] = unused[..] else {
            return None;
        };
        let mut all = listing.names.iter();
        let declared = all.position(|one| is_beside(one) && one.word() == near)?;
        let uses = listing.uses(self.noun, self.part.as_deref(), &path);
        let times = match uses.count() {
            0 | 1 => "used".to_owned(),
            count => format!("used {count} times"),
        };
        let text = format!(
            "`{near}` is declared but not used, and `{path}`, which is {times}, is not declared; did you mean `{word}`?"
        );
        Some((declared, text))
    }
}

/// Whether a word stands at two places, be it where nothing could be read.
fn stands_again(tokens: &TokenStream, word: &str) -> bool {
    let mut count = 0;
    let mut waiting = vec![tokens.clone()];
    while let Some(stream) = waiting.pop() {
        for tree in stream {
            match tree {
                TokenTree::Ident(ident) => count += usize::from(ident == word),
                TokenTree::Group(group) => waiting.push(group.stream()),
                _ => {}
            }
        }
    }
    count > 1
}
