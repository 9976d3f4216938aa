//! Targets of the motors.

use super::{Free, Mechanism, Rates, Selection};
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
    pub const fn reset(&mut self) {
        self.phase = 0.0;
    }

    /// Drives the next motor, or after the last one all.
    pub const fn next(&mut self) {
        self.selection = self.selection.next(self.reaches.len());
    }

    /// Drives the one before.
    pub const fn previous(&mut self) {
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
                Rates {
                    first: first.collect(),
                    second: Vec::new(),
                }
            }
        }
    }

    /// Notes that the mechanism has moved by a share of the phase.
    pub fn note_progress(&mut self, share: f64) {
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
