//! Names of links and joints, and paths to those within uses of parts.

use super::Place;
use super::expr::Expr;
use proc_macro2::{Ident, Span};
use std::fmt;

/// The name of a link or joint, or the path to one: `left[2].foot`.
pub(super) struct Name {
    /// The uses of parts that lead to it, from the outermost inwards.
    pub uses: Vec<Segment>,
    /// Its own name.
    pub name: Ident,
}

/// A use of a part in a path: `left[2]`.
pub(super) struct Segment {
    /// The name of the use.
    pub name: Ident,
    /// Which of its instances is meant, if it has several.
    pub index: Option<Index>,
}

/// The index in the brackets of a path.
pub(super) enum Index {
    /// `[2]`
    At(Expr),
    /// `[*]`: every instance.
    Every(Place),
}

impl Name {
    /// The place of its own name.
    pub(super) fn span(&self) -> Span {
        self.name.span()
    }

    /// From its first word to its last.
    pub(super) fn place(&self) -> Place {
        let first = self.uses.first().map_or(&self.name, |first| &first.name);
        Place {
            start: first.span(),
            end: self.name.span(),
        }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        for segment in &self.uses {
            write!(formatter, "{segment}.")?;
        }
        write!(formatter, "{}", self.name)
    }
}

impl fmt::Display for Segment {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}", self.name)?;
        match &self.index {
            None => Ok(()),
            Some(Index::At(index)) => write!(formatter, "[{index}]"),
            Some(Index::Every(_)) => write!(formatter, "[*]"),
        }
    }
}
