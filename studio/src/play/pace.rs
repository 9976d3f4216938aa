//! Speed and direction of playing.

/// Speeds, relative to the mechanism's own motion.
const SPEEDS: [f64; 8] = [0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];
const USUAL: usize = 4;

/// Speed and direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    speed: usize,
    is_backward: bool,
}

impl Default for Pace {
    fn default() -> Self {
        Self {
            speed: USUAL,
            is_backward: false,
        }
    }
}

impl Pace {
    /// Doubles the speed, up to the fastest.
    pub fn faster(&mut self) {
        self.speed = (self.speed + 1).min(SPEEDS.len() - 1);
    }

    /// Halves the speed, down to the slowest.
    pub const fn slower(&mut self) {
        self.speed = self.speed.saturating_sub(1);
    }

    /// Reverses the direction.
    pub const fn reverse(&mut self) {
        self.is_backward = !self.is_backward;
    }

    /// The speed, relative to the mechanism's own motion.
    #[must_use]
    pub fn speed(self) -> f64 {
        SPEEDS.get(self.speed).copied().unwrap_or(1.0)
    }

    /// The direction: 1, or −1 for backwards.
    #[must_use]
    pub const fn direction(self) -> f64 {
        if self.is_backward { -1.0 } else { 1.0 }
    }
}
