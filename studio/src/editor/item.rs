//! Items: things that can be seen and taken hold of.

use crate::edit::{Command, Kind};
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

    pub(super) const fn word(&self) -> &'static str {
        match self {
            Self::Link(_) => "link",
            Self::Joint(_) => "joint",
            Self::Axis(_) => "point",
            Self::Action(_) => "action",
        }
    }

    /// The command that takes it out of the text.
    pub(super) fn removal(&self) -> Command {
        Command::Remove {
            kind: match self {
                Self::Link(_) => Kind::Link,
                Self::Joint(_) => Kind::Joint,
                Self::Axis(_) => Kind::Axis,
                Self::Action(_) => Kind::Action,
            },
            name: self.name().to_owned(),
        }
    }
}

impl Display for Item {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.word(), self.name())
    }
}
