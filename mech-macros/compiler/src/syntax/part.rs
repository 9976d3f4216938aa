//! Parts, the ports through which they meet the links of whoever uses them, and their uses: as written.

use super::Place;
use super::ast::{Constant, Expr, Item, Name, Pair, Read, Statement};
use proc_macro2::{Ident, Span};

/// `part Leg(size = 1) { ... }`
pub(super) struct Part {
    /// Its name.
    pub name: Ident,
    /// Its numbers, each with the value it has where a use gives none.
    pub parameters: Vec<Constant>,
    /// What stands in its braces.
    pub body: Read<Vec<Statement>>,
}

/// `port frame { ... }`: a link that whoever uses the part lends.
pub(super) struct Port {
    /// Its name.
    pub name: Ident,
    /// What the part fixes to it.
    pub items: Read<Vec<Item>>,
}

/// `use left[6]: Leg(phase = k * 60 deg) mirrored scaled 2 { frame = ground, crank = axle at (1, 0) turned 30 deg };`
pub(super) struct Use {
    /// Its name.
    pub name: Ident,
    /// How many instances there are, in brackets; without them there is one.
    pub count: Option<(Expr, Place)>,
    /// The part.
    pub part: Ident,
    /// The values of its numbers.
    pub arguments: Vec<Constant>,
    /// The word `mirrored`, if left and right change sides.
    pub mirrored: Option<Span>,
    /// The factor of its lengths after the word `scaled`.
    pub scaled: Option<Expr>,
    /// The links that are lent.
    pub ports: Vec<PortBinding>,
}

/// `crank = axle at (1, 0) turned 30 deg`
pub(super) struct PortBinding {
    /// The port.
    pub port: Ident,
    /// The link that is lent.
    pub link: Name,
    /// Where the port's frame is in that of the link.
    pub at: Option<Pair>,
    /// The angle of the port's frame in that of the link.
    pub turned: Option<Expr>,
}

impl Part {
    /// The ports it has, as far as they could be read.
    pub(super) fn ports(&self) -> impl Iterator<Item = &Port> {
        let body = self.body.iter().flatten();
        body.filter_map(|statement| match statement {
            Statement::Port(port) => Some(port),
            _ => None,
        })
    }
}
