//! Which motors have a part in whether a loop closes.
//!
//! A loop closes or not by how the links of its clusters lie to each other. Where its clusters are carried about as a whole, as the bucket
//! of an excavator is by its boom, what carries them has no part in it.

use crate::model::{AxisId, LinkId, Model};
use crate::plan::{Connection, Loop, Plan, Source, Step};
use std::collections::BTreeSet;

/// The numbers of motors, or none if any motor may have a part.
pub(super) type Motors = Option<BTreeSet<usize>>;

/// For each loop of a plan the motors that have a part in whether it closes. Params are not looked at.
pub(super) fn motors_of_loops(model: &Model, plan: &Plan) -> Vec<Motors> {
    let mut joined = Joined { model, of_link: vec![Vec::new(); model.links.len()] };
    let mut of_loops = Vec::new();
    for step in &plan.steps {
        match step {
            Step::Weld(weld) => joined.add(weld.connection, &Some(BTreeSet::new())),
            Step::Drive(drive) => {
                joined.add(drive.connection, &Some(BTreeSet::from([drive.motor.index()])));
            }
            Step::Mesh(mesh) => joined.add(mesh.connection, &of_parts(plan, &mesh.parts)),
            Step::Cam(cam) => joined.add(cam.connection, &of_parts(plan, &cam.parts)),
            Step::Close(closing) => {
                let motors = joined.of_loop(closing);
                for connection in &closing.tree {
                    joined.add(*connection, &motors);
                }
                of_loops.push(motors);
            }
        }
    }
    of_loops
}

/// The links that steps have joined so far: each step adds branches to a forest, so between two links there is one path at most.
struct Joined<'m> {
    model: &'m Model,
    /// For each link those it was joined with, and the motors that determine how the two lie to each other.
    of_link: Vec<Vec<(LinkId, Motors)>>,
}

impl Joined<'_> {
    fn link(&self, axis: AxisId) -> LinkId {
        self.model.axis(axis).link
    }

    fn add(&mut self, connection: Connection, motors: &Motors) {
        let (from, to) = (self.link(connection.from), self.link(connection.to));
        self.of_link[from.index()].push((to, motors.clone()));
        self.of_link[to.index()].push((from, motors.clone()));
    }

    /// The motors that have a part in how the links lie to each other that a loop joins, cluster by cluster.
    fn of_loop(&self, closing: &Loop) -> Motors {
        if !closing.ties.is_empty() {
            return None;
        }
        let mut all = BTreeSet::new();
        for ring in &closing.rings {
            let before = ring.iter().cycle().skip(ring.len().saturating_sub(1));
            for (before, connection) in before.zip(ring) {
                let (from, to) = (self.link(before.to), self.link(connection.from));
                all.extend(self.between(from, to)?);
            }
        }
        Some(all)
    }

    /// The motors that determine how two links lie to each other. Any motor may, if nothing joins the links.
    fn between(&self, from: LinkId, to: LinkId) -> Motors {
        let mut waiting = vec![(from, from, BTreeSet::new())];
        while let Some((link, before, motors)) = waiting.pop() {
            if link == to {
                return Some(motors);
            }
            for (next, own) in &self.of_link[link.index()] {
                // A connection in which any motor may have a part leads nowhere.
                if let (true, Some(own)) = (*next != before, own) {
                    waiting.push((*next, link, &motors | own));
                }
            }
        }
        None
    }
}

/// The motors among the sources of a mesh or cam; none, which stands for any motor, if a loop gives one of the sources.
fn of_parts<Part>(plan: &Plan, parts: &[(usize, Part)]) -> Motors {
    let sources = parts.iter().map(|(source, _)| plan.sources[*source]);
    sources
        .map(|source| match source {
            Source::Motor(motor) => Some(motor.index()),
            Source::Angle { .. } | Source::Displacement(_) => None,
        })
        .collect()
}
