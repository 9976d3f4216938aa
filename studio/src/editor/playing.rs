//! The mechanism that plays, and its motors that were moved by hand.

use super::path::Path;
use super::range::MotorRange;
use super::snapshot::Snapshot;
use crate::play::Player;
use std::sync::Arc;

/// The link or the motor that a user moves by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hand {
    /// A link, which is dragged.
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
}

impl Playing {
    /// Plays no more.
    pub(super) fn stop(&mut self) {
        *self = Self::default();
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
