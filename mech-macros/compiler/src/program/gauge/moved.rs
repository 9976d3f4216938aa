//! The operations that measure how links move, and what that does to the ground.

use super::measures::Measures;
use crate::bug::bug;
use crate::model::{LinkId, LoadKind, Mass, MotorId, ReactionPart};
use crate::plan::{Algebra, Arithmetic};
use crate::program::build::Tangents;
use crate::program::forced::{Circumstances, Motion};
use crate::program::node::Value;

impl Measures<'_> {
    /// The place in the scene at which two links move as one.
    pub(super) fn centre(&mut self, links: [LinkId; 2]) -> [Value; 2] {
        let mut tangents = self.by_time();
        // The angular velocity of each link, and the velocity of that point of it which is at the origin of the scene.
        let [(turning, velocity), (other_turning, other_velocity)] = links.map(|link| {
            let [cos, sin, x, y] = self.pose(link);
            let turning = self.turning([cos, sin], &mut tangents);
            let [along_x, along_y] = [x, y].map(|part| self.rate(part, &mut tangents));
            let (by_y, by_x) = (self.ssa.mul(turning, y), self.ssa.mul(turning, x));
            let velocity = [self.ssa.add(along_x, by_y), self.ssa.sub(along_y, by_x)];
            (turning, velocity)
        });
        let turning = self.ssa.sub(turning, other_turning);
        let [x, y] = self.ssa.minus(velocity, other_velocity);
        let back = self.ssa.neg(y);
        [self.ssa.div(back, turning), self.ssa.div(x, turning)]
    }

    /// A part of what the ground gets: what accelerates the masses is set against it, and, unless only that is asked for, weights and loads.
    pub(super) fn on_ground(
        &mut self,
        part: ReactionPart,
        is_whole: bool,
        circumstances: &Circumstances<'_>,
    ) -> Value {
        let model = self.model;
        let moves = match self.motion {
            Motion::Even { pushed, .. } => pushed.iter().any(|rate| *rate != 0.0),
            Motion::InTime(_) | Motion::Any => true,
        };
        let gravity = model.actions.gravity.filter(|_| is_whole);
        let gravity = gravity.unwrap_or_default();
        let mut tangents = moves.then(|| self.by_time());
        let mut sum = self.ssa.constant(0.0);
        for link in model.declared_links() {
            let Some(mass) = model.link(link).mass else {
                continue;
            };
            let place = self.carried(link, mass.center);
            let mut force = self.ssa.vector(gravity.map(|part| part * mass.mass));
            let mut torque = self.ssa.constant(0.0);
            if let Some(tangents) = &mut tangents {
                let (inertial, turning) = self.inertial(link, mass, place, tangents);
                (force, torque) = (self.ssa.minus(force, inertial), self.ssa.neg(turning));
            }
            let own = self.part_of_force(part, (force, place), torque);
            sum = self.ssa.add(sum, own);
        }
        let loads = model.actions.loads_with(circumstances.loads);
        for (load, numbers) in loads.filter(|_| is_whole) {
            let zero = self.ssa.constant(0.0);
            let own = match (load.kind, numbers) {
                (LoadKind::Force(point), &[x, y]) => {
                    let (force, place) = (self.ssa.vector([x, y]), self.point(point));
                    self.part_of_force(part, (force, place), zero)
                }
                (LoadKind::Torque(_), &[torque]) => {
                    let torque = self.ssa.constant(torque);
                    self.part_of_force(part, ([zero; 2], [zero; 2]), torque)
                }
                _ => bug!("a load has too many numbers"),
            };
            sum = self.ssa.add(sum, own);
        }
        sum
    }

    /// The force and the torque that accelerate a mass, which is at a place.
    fn inertial(
        &mut self,
        link: LinkId,
        mass: Mass,
        place: [Value; 2],
        tangents: &mut Tangents,
    ) -> ([Value; 2], Value) {
        let accelerations = place.map(|part| {
            let velocity = self.rate(part, tangents);
            self.rate(velocity, tangents)
        });
        let [cos, sin, ..] = self.pose(link);
        let turning = self.turning([cos, sin], tangents);
        let turning = self.rate(turning, tangents);
        let [mass, inertia] = [mass.mass, mass.inertia].map(|part| self.ssa.constant(part));
        (self.ssa.scale(mass, accelerations), self.ssa.mul(inertia, turning))
    }

    /// A part of a force at a place, with a torque besides.
    fn part_of_force(
        &mut self,
        part: ReactionPart,
        (force, place): ([Value; 2], [Value; 2]),
        torque: Value,
    ) -> Value {
        match part {
            ReactionPart::X => force[0],
            ReactionPart::Y => force[1],
            ReactionPart::Torque => {
                let moment = self.ssa.cross(place, force);
                self.ssa.add(moment, torque)
            }
        }
    }

    /// One divided by the rate at which a load goes on in its direction while a motor alone moves at a rate of one.
    pub(super) fn advantage(
        &mut self,
        load: usize,
        motor: MotorId,
        circumstances: &Circumstances<'_>,
    ) -> Value {
        let mut tangents = self.by_motor(motor);
        let mut loads = self.model.actions.loads_with(circumstances.loads);
        let Some((load, numbers)) = loads.nth(load) else {
            bug!("an advantage is measured over no load");
        };
        let ratio = match (load.kind, numbers) {
            (LoadKind::Force(point), &[x, y]) => {
                let size = x.hypot(y);
                let along = self.ssa.vector([x / size, y / size]);
                let place = self.point(point);
                let way = self.ssa.dot(along, place);
                self.rate(way, &mut tangents)
            }
            (LoadKind::Torque(link), _) => {
                let [cos, sin, ..] = self.pose(link);
                self.turning([cos, sin], &mut tangents)
            }
            (LoadKind::Force(_), _) => bug!("a force has no two numbers"),
        };
        let one = self.ssa.constant(1.0);
        self.ssa.div(one, ratio)
    }
}
