//! The actions on links: gravity, springs, dampers and loads.

use super::{AxisId, JointId, LinkId, Origin};

/// Everything that acts on links.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Actions {
    /// The acceleration of free fall, if there is gravity.
    pub gravity: Option<[f64; 2]>,
    /// All springs.
    pub springs: Vec<Spring>,
    /// All dampers.
    pub dampers: Vec<Damper>,
    /// All loads, in the order of their declaration.
    pub loads: Vec<Load>,
}

/// The ends of a spring or a damper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Between {
    /// Two points of different links: it pulls and pushes along the line between them.
    Points(AxisId, AxisId),
    /// The two links of a revolute joint: it turns them against each other.
    Joint(JointId),
}

/// A linear spring.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its ends.
    pub between: Between,
    /// Force a unit of length, or torque a radian; not negative.
    pub stiffness: f64,
    /// The length or the coordinate at which it is at rest.
    pub rest: f64,
}

/// A linear damper.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Damper {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its ends.
    pub between: Between,
    /// Force a unit of the rate of its length, or torque a unit of angular velocity; not negative.
    pub damping: f64,
}

/// A load that is set at run time.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Load {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its kind, with the point or link on which it acts.
    pub kind: LoadKind,
}

/// The kind of a load, with the point or link on which it acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LoadKind {
    /// A force at a point, in the directions of the scene.
    Force(AxisId),
    /// A torque on a link.
    Torque(LinkId),
}

impl LoadKind {
    /// Returns the number of its components.
    #[must_use]
    pub fn numbers(self) -> usize {
        match self {
            Self::Force(_) => 2,
            Self::Torque(_) => 1,
        }
    }
}

impl Actions {
    /// Returns the names of the components of all loads.
    #[must_use]
    pub fn load_names(&self) -> Vec<String> {
        let names = |load: &Load| match load.kind {
            LoadKind::Force(_) => vec![format!("{}_x", load.name), format!("{}_y", load.name)],
            LoadKind::Torque(_) => vec![load.name.clone()],
        };
        self.loads.iter().flat_map(names).collect()
    }

    /// The loads, each with its own of the numbers of all.
    pub fn loads_with<'a>(
        &'a self,
        numbers: &'a [f64],
    ) -> impl Iterator<Item = (&'a Load, &'a [f64])> {
        let loads = self.numbered_loads();
        loads.map(move |(first, load)| (load, &numbers[first..first + load.kind.numbers()]))
    }

    /// The loads, each with the position of its first number among those of all.
    pub fn numbered_loads(&self) -> impl Iterator<Item = (usize, &Load)> {
        self.loads.iter().scan(0, |next, load| {
            let first = *next;
            *next += load.kind.numbers();
            Some((first, load))
        })
    }
}
