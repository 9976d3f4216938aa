//! Queries of a listing.

use super::{ListedName, ListedNumber, Listing, Noun};

impl<P> Default for Listing<P> {
    fn default() -> Self {
        Self { names: Vec::new(), numbers: Vec::new() }
    }
}

impl<P> ListedName<P> {
    /// Its own word: the last of its path.
    #[must_use]
    pub fn word(&self) -> &str {
        own_word(&self.path)
    }
}

fn own_word(path: &str) -> &str {
    path.rsplit_once('.').map_or(path, |(_, word)| word)
}

impl<P> ListedNumber<P> {
    /// Returns the path of its owner, with the part in which that is declared: `Leg.foot.tip`.
    #[must_use]
    pub fn path(&self) -> String {
        match &self.part {
            Some(part) => format!("{part}.{}", self.owner),
            None => self.owner.clone(),
        }
    }

    fn is_of(&self, part: Option<&str>, owner: &str) -> bool {
        self.part.as_deref() == part && self.owner == owner
    }
}

impl<P> Listing<P> {
    /// The same with other places.
    pub fn map_places<Q>(self, place: impl Fn(P) -> Q) -> Listing<Q> {
        let names = self.names.into_iter().map(|name| ListedName {
            noun: name.noun,
            path: name.path,
            part: name.part,
            is_declared: name.is_declared,
            place: place(name.place),
        });
        let numbers = self.numbers.into_iter().map(|number| ListedNumber {
            owner: number.owner,
            role: number.role,
            part: number.part,
            place: place(number.place),
            is_pair: number.is_pair,
            literals: number.literals.into_iter().map(&place).collect(),
        });
        Listing { names: names.collect(), numbers: numbers.collect() }
    }

    /// The number of this owner and role. What is declared in a part is called by the part's name first: `Leg.foot.tip`.
    #[must_use]
    pub fn number(&self, owner: &str, role: &str) -> Option<&ListedNumber<P>> {
        let (part, owner) = self.within_part(owner);
        let mut numbers = self.numbers.iter();
        numbers.find(|one| one.is_of(part, owner) && one.role == role)
    }

    /// All numbers of this owner.
    pub fn numbers_of<'a>(&'a self, owner: &'a str) -> impl Iterator<Item = &'a ListedNumber<P>> {
        let (part, owner) = self.within_part(owner);
        let numbers = self.numbers.iter();
        numbers.filter(move |one| one.is_of(part, owner))
    }

    /// The part that a path names first, and the words after it.
    fn within_part<'a>(&self, path: &'a str) -> (Option<&'a str>, &'a str) {
        match path.split_once('.') {
            Some((first, inner)) if self.is_part(first) => (Some(first), inner),
            _ => (None, path),
        }
    }

    /// The names of all constants and params, outside of parts.
    pub fn constants(&self) -> impl Iterator<Item = &str> {
        let is_it = |one: &&ListedName<P>| {
            one.is_declared && one.noun == Noun::Number && one.part.is_none()
        };
        self.names.iter().filter(is_it).map(|one| one.path.as_str())
    }

    /// The part of which a use makes instances, if it is a use.
    fn part_of(&self, used: &str, part: Option<&str>) -> Option<&str> {
        let is_it = |one: &ListedName<P>| {
            one.is_declared
                && one.noun == Noun::Body
                && one.path == used
                && one.part.as_deref() == part
        };
        let index = self.names.iter().position(is_it)?;
        // The name of the part follows that of the use.
        let mut after = self.names[index + 1..].iter();
        let next = after.find(|one| one.noun != Noun::Number)?;
        (next.noun == Noun::Part && !next.is_declared).then_some(next.path.as_str())
    }

    /// Resolves a path: returns the part in which the named thing is declared, and its path there.
    #[must_use]
    pub fn resolve<'a>(
        &'a self,
        path: &'a str,
        part: Option<&'a str>,
    ) -> (Option<&'a str>, &'a str) {
        let (mut part, mut path) = (part, path);
        while let Some((first, inner)) = path.split_once('.') {
            let Some(used) = self.part_of(first, part) else {
                break;
            };
            (part, path) = (Some(used), inner);
        }
        (part, path)
    }

    /// Where a name is used that is declared in this part, or in the mechanism, under this path.
    pub fn uses<'a>(
        &'a self,
        noun: Noun,
        part: Option<&'a str>,
        path: &'a str,
    ) -> impl Iterator<Item = &'a ListedName<P>> {
        let word = own_word(path);
        self.names.iter().filter(move |one| {
            let is_like_it = match one.noun {
                Noun::BodyOrJoint => matches!(noun, Noun::Body | Noun::Joint),
                other => other == noun,
            };
            let is_it = || self.resolve(&one.path, one.part.as_deref()) == (part, path);
            !one.is_declared && is_like_it && one.word() == word && is_it()
        })
    }

    /// The declarations that a path may mean: of a link, a joint, an axis, a number and so on.
    pub fn declared<'a>(&'a self, path: &'a str) -> impl Iterator<Item = &'a ListedName<P>> {
        let (part, path) = match self.within_part(path) {
            (None, path) => self.resolve(path, None),
            found => found,
        };
        let names = self.names.iter();
        names.filter(move |one| one.is_declared && one.part.as_deref() == part && one.path == path)
    }

    fn is_part(&self, name: &str) -> bool {
        let mut names = self.names.iter();
        names.any(|one| one.is_declared && one.noun == Noun::Part && one.path == name)
    }
}
