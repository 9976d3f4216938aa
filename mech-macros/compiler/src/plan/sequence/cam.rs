//! The part of the search for cams: joints whose coordinates are functions of others.

use super::Knowledge;
use super::Search;
use super::rolling::coordinate;
use crate::model::{JointId, JointKind};
use crate::plan::step::{Cam, Connection, ConnectionKind, Source, Step};

impl Search<'_> {
    /// Finds one follower that a cam moves whose shaft is known.
    pub(super) fn cam(&mut self) -> bool {
        if !self.keeps_ledger {
            return false;
        }
        // Of several the name decides which comes first, which no reordering changes.
        let name = |cam: &Cam| self.model.joint(cam.by).name.clone();
        let cams = self.model.cams();
        let found = cams.filter_map(|(by, shaft, follower, _)| self.find_cam(by, shaft, follower));
        let Some(cam) = found.min_by_key(name) else {
            return false;
        };
        let how = Knowledge::of(cam.parts.iter().map(|(source, _)| &self.behind[*source]));
        let (from, to) = self.link_of(cam.connection);
        let source = match cam.connection.kind {
            ConnectionKind::Revolute => Source::Angle { from, to },
            ConnectionKind::Prismatic => Source::Displacement(cam.connection.joint),
        };
        self.source(source, &coordinate(cam.connection, (from, to)), how.clone());
        self.turned_slide(cam.connection.joint, &how);
        self.merge(&[from, to], &how);
        self.steps.push(Step::Cam(cam));
        true
    }

    /// The step in which a cam moves its follower, if its shaft is known and the follower is not.
    fn find_cam(&self, by: JointId, shaft: JointId, follower: JointId) -> Option<Cam> {
        let (shaft, follower) =
            (self.declared_connection(shaft)?, self.declared_connection(follower)?);
        let parts = self.relations.value(&coordinate(shaft, self.link_of(shaft)))?;
        let (from, to) = self.link_of(follower);
        let turns = follower.kind == ConnectionKind::Revolute;
        let held = turns && self.aligned.equiv(from.index(), to.index());
        if held || self.clusters.are_joined(from, to) {
            return None;
        }
        Some(Cam { by, connection: follower, parts })
    }

    /// A joint with a coordinate, as it is declared.
    pub(super) fn declared_connection(&self, joint: JointId) -> Option<Connection> {
        let (kind, from, to) = match self.model.joint(joint).kind {
            JointKind::Revolute(from, to) => (ConnectionKind::Revolute, from, to),
            JointKind::Prismatic(from, to) => (ConnectionKind::Prismatic, from, to),
            _ => return None,
        };
        Some(Connection { kind, from, to, joint })
    }

    /// A cam whose follower is never moved by it, unless loops that wait for each other are the reason.
    pub(super) fn idle_cam(&mut self) -> Option<JointId> {
        let used = |cam: JointId| {
            let mut steps = self.steps.iter();
            steps.any(|step| matches!(step, Step::Cam(step) if step.by == cam))
        };
        let idle = self.model.cams().map(|(cam, ..)| cam).find(|&cam| !used(cam))?;
        let connections = self.connections();
        let blocks = self.blocks(&connections).into_iter();
        let waits = blocks.map(|block| self.describe(block)).any(|found| self.is_square(&found));
        (!waits).then_some(idle)
    }
}
