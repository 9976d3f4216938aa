//! Items: things that can be seen and taken hold of.

use serde::{Deserialize, Serialize};
use std::fmt::{self, Display, Formatter};

/// Something that can be seen and taken hold of, by its name in the text.
#[derive(Clone, Debug, Hash, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Item {
    /// A link.
    Link(String),
    /// A joint.
    Joint(String),
    /// A point or a line that is fixed to a link, by its path.
    Axis(String),
    /// A spring, a damper or a load.
    Action(String),
}

impl Item {
    /// Its name or path.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Link(name) | Self::Joint(name) | Self::Axis(name) | Self::Action(name) => name,
        }
    }
}

impl Display for Item {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let word = match self {
            Self::Link(_) => "link",
            Self::Joint(_) => "joint",
            Self::Axis(_) => "point",
            Self::Action(_) => "action",
        };
        write!(f, "{word} {}", self.name())
    }
}
