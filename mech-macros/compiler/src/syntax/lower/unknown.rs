//! Names that nothing declares.

use super::name::{Names, divide};
use super::scope::Scope;
use crate::syntax::{ListedName, Listing, Noun, spelling};
use proc_macro2::Ident;

/// A name that nothing declares.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Unknown {
    noun: Noun,
    /// The part in whose braces it should be declared.
    part: Option<String>,
    /// Its path there: `crank`, or `crank.pin`. Of all that is fixed to a ground that is not declared, `ground.`.
    path: String,
}

impl Unknown {
    /// A link, a use or a joint of this name, which the path to its scope precedes.
    pub(super) fn named(noun: Noun, names: &Names, key: &str) -> Self {
        let (path, name) = divide(key);
        Self {
            noun,
            part: names.scopes.find(path).and_then(|scope| scope.part.clone()),
            path: name.to_owned(),
        }
    }

    /// A point or line of a link.
    pub(super) fn axis(names: &Names, link: &str, name: &str) -> Self {
        let link = Self::named(Noun::Axis, names, link);
        Self {
            path: format!("{}.{name}", link.path),
            ..link
        }
    }

    /// A constant, a param, or a number of a part.
    pub(super) fn number(scope: &Scope, name: &Ident) -> Self {
        let part = scope.part.clone();
        Self::of_part(Noun::Number, part, name)
    }

    /// A number or a port of this part; without one, a part.
    pub(super) fn of_part(noun: Noun, part: Option<String>, name: &Ident) -> Self {
        Self {
            noun,
            part,
            path: name.to_string(),
        }
    }

    /// What is said instead, if nothing of the ground is declared.
    pub(super) fn without_ground(&self, listing: &Listing) -> Option<String> {
        if divide(&self.path) != ("ground", "") {
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

    /// The number of the declaration that is misspelt, if one is, and what is said there: it looks like this name, and is not used.
    pub(super) fn misspelt(&self, listing: &Listing) -> Option<(usize, String)> {
        let (owner, word) = divide(&self.path);
        // A name that stands nowhere else may as well be misspelt itself.
        let same = listing.names.iter().filter(|one| one.word() == word);
        if same.count() < 2 {
            return None;
        }
        let is_beside = |one: &ListedName| {
            let is_like_it = (one.noun, &one.part) == (self.noun, &self.part);
            one.is_declared && is_like_it && divide(&one.path).0 == owner
        };
        let all = listing.names.iter();
        let beside: Vec<&str> = all
            .filter(|one| is_beside(one))
            .map(ListedName::word)
            .collect();
        let mut unused = spelling::alike(word, beside.into_iter());
        unused.retain(|(_, near)| {
            let path = match owner {
                "" => (*near).to_owned(),
                owner => format!("{owner}.{near}"),
            };
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
        let uses = listing.uses(self.noun, self.part.as_deref(), &self.path);
        let times = match uses.count() {
            0 | 1 => "used".to_owned(),
            count => format!("used {count} times"),
        };
        let text = format!(
            "`{near}` is declared but not used, and `{}`, which is {times}, is not declared; did you mean `{word}`?",
            self.path
        );
        Some((declared, text))
    }
}
