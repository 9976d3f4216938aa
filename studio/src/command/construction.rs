//! What is constructed over drawings and films, as in a lecture.

use crate::construction::Construction;
use crate::quantity::Load;
use clap::Args;

/// What is constructed over a picture, as a motor moves at a rate of 1: the first in drawings, in films the one that moves.
#[derive(Args, Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is asked for or not, whatever the others")]
pub(super) struct Constructions {
    /// Paints the instant centres of its links, with the lines on which Kennedy has them.
    #[arg(long)]
    centres: bool,
    /// Draws the velocity polygon beside it, as a motor moves at a rate of 1: in drawings the first, in films the one that moves.
    #[arg(long)]
    velocities: bool,
    /// Draws the acceleration polygon beside it, as the same motor moves at a steady rate of 1.
    #[arg(long)]
    accelerations: bool,
    /// Draws the free body of each link beside it, with the forces and torques on it: those at rest, or in a film as laws move it.
    #[arg(long)]
    forces: bool,
    /// Draws the centrodes of a link relative to the ground, in the whole motion: the fixed one, and the moving one that rolls on it.
    #[arg(long, value_name = "LINK")]
    centrodes: Vec<String>,
    /// Draws the inflection circle of a link relative to the ground: its points go straight ahead there.
    #[arg(long, value_name = "LINK")]
    inflection: Vec<String>,
    /// Puts a load on it for `--forces`: the parts of a force, as `--load push=-100,0`, or a torque, as `--load brake=5`.
    #[arg(long, value_name = "NAME=VALUE", allow_negative_numbers = true, requires = "forces")]
    pub(super) load: Vec<Load>,
}

impl Constructions {
    /// All that are asked for.
    pub(super) fn all(&self) -> Vec<Construction> {
        let all = [
            (self.centres, Construction::Centres),
            (self.velocities, Construction::Velocities),
            (self.accelerations, Construction::Accelerations),
            (self.forces, Construction::Forces),
        ];
        let wanted = all.into_iter().filter(|(is_wanted, _)| *is_wanted);
        let wanted = wanted.map(|(_, construction)| construction);
        let centrodes = self.centrodes.iter().cloned().map(Construction::Centrodes);
        let inflection = self.inflection.iter().cloned().map(Construction::Inflection);
        wanted.chain(centrodes).chain(inflection).collect()
    }
}
