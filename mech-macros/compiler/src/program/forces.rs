//! The results of programs that compute forces.

/// The result of a program that computes forces.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Forces<V> {
    /// The torques of the motors, or their forces, that hold everything at rest.
    Holding(Vec<V>),
    /// The torques, forces and reactions that a given motion takes.
    InverseDynamics(InverseDynamics<V>),
    /// The motion under the torques of the motors.
    Inertia(Inertia<V>),
}

/// The torques, forces and reactions that a given motion takes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InverseDynamics<V> {
    /// The torques of the motors, or their forces.
    pub torques: Vec<V>,
    /// For each joint what its first link does to its second: a force in the directions of the scene, and a torque about the
    /// joint.
    pub reactions: Vec<[V; 3]>,
    /// For each motor how fast each number of the loads is followed, if it alone moves at a rate of one.
    pub velocity_ratios: Vec<Vec<V>>,
    /// The transmission angles of the dyads, in the order in which they are closed.
    pub transmission: Vec<V>,
}

/// Inertia and forces as the motors feel them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inertia<V> {
    /// The reduced inertia: row by row, one for each motor.
    pub matrix: Vec<Vec<V>>,
    /// For each motor what accelerates it besides its own torque.
    pub drive: Vec<V>,
    /// The kinetic and the potential energy.
    pub energy: [V; 2],
}

impl<V: Copy> Forces<V> {
    /// All values that it consists of.
    pub fn roots(&self) -> Vec<V> {
        let mut roots = Vec::new();
        self.map(|value| roots.push(value));
        roots
    }

    /// The same with other transmission angles.
    #[must_use]
    pub fn with_transmission(&self, each: impl Fn(V) -> V) -> Self {
        let mut forces = self.map(|value| value);
        if let Self::InverseDynamics(found) = &mut forces {
            for angle in &mut found.transmission {
                *angle = each(*angle);
            }
        }
        forces
    }

    /// The same results, each number replaced by what `each` makes of it.
    pub fn map<W>(&self, mut each: impl FnMut(V) -> W) -> Forces<W> {
        let mut row =
            |values: &Vec<V>| -> Vec<W> { values.iter().map(|&value| each(value)).collect() };
        match self {
            Self::Holding(torques) => Forces::Holding(row(torques)),
            Self::InverseDynamics(inverse_dynamics) => Forces::InverseDynamics(InverseDynamics {
                torques: row(&inverse_dynamics.torques),
                velocity_ratios: inverse_dynamics.velocity_ratios.iter().map(&mut row).collect(),
                transmission: row(&inverse_dynamics.transmission),
                reactions: inverse_dynamics
                    .reactions
                    .iter()
                    .map(|reaction| reaction.map(&mut each))
                    .collect(),
            }),
            Self::Inertia(inertia) => Forces::Inertia(Inertia {
                matrix: inertia.matrix.iter().map(&mut row).collect(),
                drive: row(&inertia.drive),
                energy: inertia.energy.map(each),
            }),
        }
    }
}
