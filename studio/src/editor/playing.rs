//! Motions by hand, which are taken back before a step of the text is.

/// What somebody moves the motors by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hand {
    /// A link, which is dragged.
    Link,
    /// A motor, by its number.
    Motor(usize),
}

/// The values that the motors had before each motion by hand, since the text changed last.
#[derive(Default)]
pub(super) struct ByHand {
    before: Vec<(Hand, Vec<f64>)>,
}

impl ByHand {
    /// Notes the values before a motion. A motor that is moved on makes the same motion.
    pub(super) fn note(&mut self, hand: Hand, motors: &[f64]) {
        let last = self.before.last().map(|(hand, _)| *hand);
        if hand == Hand::Link || last != Some(hand) {
            self.before.push((hand, motors.to_vec()));
        }
    }

    /// The values before the last motion, which is forgotten.
    pub(super) fn pop(&mut self) -> Option<Vec<f64>> {
        self.before.pop().map(|(_, motors)| motors)
    }

    /// Whether there was a motion.
    pub(super) fn is_empty(&self) -> bool {
        self.before.is_empty()
    }

    /// Forgets all motions.
    pub(super) fn clear(&mut self) {
        self.before.clear();
    }
}
