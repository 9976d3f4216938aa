//! Targets of the motors: which are driven, and how fast.

use super::{Free, Mechanism, Rates};
use std::f64::consts::TAU;

/// Computes where the motors move next: in the mechanism's own motion, or one motor alone, as far as in that motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    selection: Selection,
    /// The phase of the mechanism's own motion.
    phase: f64,
    /// The duration of 1 of the phase, in seconds.
    seconds: f64,
    /// The reach of each motor in the motion.
    reaches: Vec<f64>,
}

impl Driver {
    /// A driver of this mechanism from its start.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Self {
        Self {
            selection: Selection::Motion,
            phase: 0.0,
            seconds: mechanism.seconds(),
            reaches: reaches(mechanism),
        }
    }

    /// Starts again.
    pub(crate) const fn reset(&mut self) {
        self.phase = 0.0;
    }

    /// Drives the next motor, or after the last one all.
    pub const fn next(&mut self) {
        self.selection = self.selection.next(self.reaches.len());
    }

    /// Drives the one before.
    pub(crate) const fn previous(&mut self) {
        self.selection = self.selection.previous(self.reaches.len());
    }

    /// Returns the driven motors.
    #[must_use]
    pub const fn selection(&self) -> Selection {
        self.selection
    }

    /// The duration of 1 of the phase, in seconds.
    #[must_use]
    pub const fn seconds(&self) -> f64 {
        self.seconds
    }

    /// The motors that may be dragged.
    #[must_use]
    pub fn free(&self) -> Vec<Free> {
        let reaches = self.reaches.iter().enumerate();
        let free = reaches.map(|(motor, &reach)| Free { motor, reach });
        free.filter(|free| match self.selection {
            Selection::Motion => true,
            Selection::Motor(driven) => free.motor == driven,
        })
        .collect()
    }

    /// The motor values after a share of the phase. The differences of the own motion are added to the present values, so it continues
    /// from where somebody has dragged it.
    #[must_use]
    pub fn target(&self, mechanism: &Mechanism, share: f64) -> Vec<f64> {
        let mut motors = mechanism.motors().to_vec();
        match self.selection {
            Selection::Motion => {
                let ahead = mechanism.motion(self.phase + share);
                let here = mechanism.motion(self.phase);
                for (motor, (ahead, here)) in motors.iter_mut().zip(ahead.iter().zip(here)) {
                    *motor += ahead - here;
                }
            }
            Selection::Motor(driven) => {
                if let (Some(motor), Some(reach)) =
                    (motors.get_mut(driven), self.reaches.get(driven))
                {
                    *motor += share * reach;
                }
            }
        }
        motors
    }

    /// The rates of the motors at the usual speed, forwards (1) or backwards (−1).
    #[must_use]
    pub fn rates(&self, mechanism: &Mechanism, direction: f64) -> Rates {
        match self.selection {
            Selection::Motion => {
                let mut rates = mechanism.rates(self.phase);
                rates.first.iter_mut().for_each(|rate| *rate *= direction);
                rates
            }
            Selection::Motor(driven) => {
                let reaches = self.reaches.iter().enumerate();
                let turns = |motor| if motor == driven { direction } else { 0.0 };
                let first = reaches.map(|(motor, reach)| turns(motor) * reach / self.seconds);
                Rates { first: first.collect(), second: Vec::new() }
            }
        }
    }

    /// Notes that the mechanism has moved by a share of the phase.
    pub(crate) fn note_progress(&mut self, share: f64) {
        if self.selection == Selection::Motion {
            self.phase += share;
        }
    }
}

/// The reach of each motor in the whole motion. A motor that stands still has one turn, or one scene unit.
fn reaches(mechanism: &Mechanism) -> Vec<f64> {
    const LOOKS: u32 = 96;
    let mut ends: Vec<[f64; 2]> = mechanism.motors().iter().map(|&value| [value; 2]).collect();
    let mut phase = 0.0;
    while phase <= mechanism.length() {
        for (end, value) in ends.iter_mut().zip(mechanism.motion(phase)) {
            *end = [end[0].min(value), end[1].max(value)];
        }
        phase += 1.0 / f64::from(LOOKS);
    }
    let reach = |(motor, [low, high]): (usize, [f64; 2])| match high - low {
        reach if reach.is_finite() && reach > 0.0 => reach,
        _ if mechanism.slides(motor) => 1.0,
        _ => TAU,
    };
    ends.into_iter().enumerate().map(reach).collect()
}

/// The motors that are driven in playing, and that may be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selection {
    /// All motors, in the mechanism's own motion.
    Motion,
    /// One motor alone, by its number.
    Motor(usize),
}

impl Selection {
    /// The next choice for a mechanism with so many motors. A single motor also has two choices: alone it turns on and on.
    #[must_use]
    pub const fn next(self, motors: usize) -> Self {
        match self {
            Self::Motion => Self::at(0, motors),
            Self::Motor(motor) => Self::at(motor + 1, motors),
        }
    }

    /// The previous choice.
    pub(crate) const fn previous(self, motors: usize) -> Self {
        match self {
            Self::Motion if motors > 0 => Self::Motor(motors - 1),
            Self::Motion | Self::Motor(0) => Self::Motion,
            Self::Motor(motor) => Self::Motor(motor - 1),
        }
    }

    const fn at(motor: usize, motors: usize) -> Self {
        if motor < motors { Self::Motor(motor) } else { Self::Motion }
    }
}

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
        Self { speed: USUAL, is_backward: false }
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
