//! The mechanism that plays, and its motors that were moved by hand.

use super::range::{MotorRange, Path};
use super::snapshot::Snapshot;
use super::worker::{Task, Use};
use crate::play::{Derived, Player};
use mech_compiler::Compiled;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The link or the motor that a user moves by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hand {
    Link,
    /// A motor, by its number.
    Motor(usize),
}

/// The played mechanism, if the drawn text moves.
#[derive(Default)]
pub(super) struct Playing {
    pub(super) snapshot: Option<Arc<Snapshot>>,
    pub(super) player: Option<Player>,
    pub(super) ranges: Vec<MotorRange>,
    /// The whole paths of its traced points.
    pub(super) paths: Vec<Path>,
    /// The values that the motors had before each motion by hand, since the text changed last.
    by_hand: Vec<(Hand, Vec<f64>)>,
    /// What the mechanism was asked to compute besides positions, each with the number of its task.
    pub(super) asked: BTreeMap<Derived, u64>,
}

impl Playing {
    pub(super) fn stop(&mut self) {
        *self = Self::default();
    }

    /// Asks for what arrows need, if nobody has yet. What was stopped is asked for again when they were hidden in between.
    pub(super) fn ask_for(
        &mut self,
        needs: &BTreeSet<Derived>,
        mut number: impl FnMut() -> u64,
    ) -> Vec<Task> {
        self.asked.retain(|what, _| needs.contains(what));
        let (Some(player), Some(snapshot)) = (&self.player, &self.snapshot) else {
            return Vec::new();
        };
        let is_unknown = |what: &&Derived| !player.mechanism().knows(**what);
        let mut tasks = Vec::new();
        for &what in needs.iter().filter(is_unknown) {
            if let Entry::Vacant(asked) = self.asked.entry(what) {
                let (number, snapshot) = (*asked.insert(number()), snapshot.clone());
                tasks.push(Task::Of(snapshot, Use::Derive(number, what)));
            }
        }
        tasks
    }

    /// Takes over what arrows need, by the number of its task, if that is still wanted.
    pub(super) fn take(&mut self, number: u64, what: Derived, found: Option<Box<Compiled>>) {
        if self.asked.get(&what) == Some(&number)
            && let Some(player) = &mut self.player
        {
            player.take(what, found);
        }
    }

    /// The values of motors, by their numbers, as they are read: `a = 30°`.
    pub(super) fn words_of(&self, place: &[(usize, f64)]) -> String {
        let values = place.iter().filter_map(|&(motor, value)| {
            let range = self.ranges.get(motor)?;
            let (name, unit) = (&range.name, range.unit());
            Some(format!("{name} = {:.2}{unit}", range.shown(value)))
        });
        values.collect::<Vec<String>>().join(", ")
    }

    /// Whether it is the mechanism of this text.
    pub(super) fn is_of(&self, snapshot: &Arc<Snapshot>) -> bool {
        let own = self.snapshot.as_ref();
        own.is_some_and(|own| Arc::ptr_eq(own, snapshot))
    }

    /// Notes where the motors are before a motion by hand. A motor that is moved on makes the same motion.
    pub(super) fn note(&mut self, hand: Hand) {
        let last = self.by_hand.last().map(|(hand, _)| *hand);
        if let Some(player) = &self.player
            && (hand == Hand::Link || last != Some(hand))
        {
            self.by_hand.push((hand, player.motors().to_vec()));
        }
    }

    /// Takes back the last motion by hand since the text changed. Returns whether there was one.
    pub(super) fn take_back(&mut self) -> bool {
        while let (Some((_, before)), Some(player)) = (self.by_hand.pop(), &mut self.player) {
            if before != player.motors() {
                for (motor, value) in before.into_iter().enumerate() {
                    player.drive(motor, value);
                }
                return true;
            }
        }
        false
    }

    /// Whether something was moved by hand since the text changed.
    pub(super) fn is_moved_by_hand(&self) -> bool {
        !self.by_hand.is_empty()
    }

    /// Forgets what was moved by hand.
    pub(super) fn settle(&mut self) {
        self.by_hand.clear();
    }

    /// The values of motors at which the mechanism is seen, in degrees or scene units; none at the start.
    pub(super) fn seen_at(&self) -> Option<Vec<(String, f64)>> {
        let mechanism = self.player.as_ref()?.mechanism();
        (!mechanism.is_at_start()).then(|| mechanism.shown_motors())
    }
}
