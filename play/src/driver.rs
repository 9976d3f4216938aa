//! Targets of the motors.

use crate::{Drive, Free};
use mech_gallery::{Playable, Rates};
use std::f64::consts::TAU;

/// Computes where the motors move next: in the exhibit's own motion, or one motor alone, as far as in that motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    drive: Drive,
    /// The phase of the exhibit's own motion, from 0 to 1.
    phase: f64,
    /// The duration of a whole motion, in seconds.
    seconds: f64,
    /// The reach of each motor in it.
    reaches: Vec<f64>,
}

impl Driver {
    /// A driver of this mechanism from its start. Its whole motion takes this time in seconds.
    #[must_use]
    pub fn new(mechanism: &dyn Playable, seconds: f64) -> Self {
        Self {
            drive: Drive::Motion,
            phase: 0.0,
            seconds,
            reaches: reaches(mechanism),
        }
    }

    /// Starts again.
    pub const fn reset(&mut self) {
        self.phase = 0.0;
    }

    /// Drives the next motor, or after the last one all.
    pub const fn next(&mut self) {
        self.drive = self.drive.next(self.reaches.len());
    }

    /// Drives the one before.
    pub const fn previous(&mut self) {
        self.drive = self.drive.previous(self.reaches.len());
    }

    /// What is driven.
    #[must_use]
    pub const fn drive(&self) -> Drive {
        self.drive
    }

    /// The duration of a whole motion, in seconds.
    #[must_use]
    pub const fn seconds(&self) -> f64 {
        self.seconds
    }

    /// The motors that may be dragged.
    #[must_use]
    pub fn free(&self) -> Vec<Free> {
        let reaches = self.reaches.iter().enumerate();
        let free = reaches.map(|(motor, &reach)| Free { motor, reach });
        free.filter(|free| match self.drive {
            Drive::Motion => true,
            Drive::Motor(driven) => free.motor == driven,
        })
        .collect()
    }

    /// The motor values after a share of a whole motion. The differences of the own motion are added to the present values, so it continues
    /// from where somebody has dragged it.
    #[must_use]
    pub fn target(&self, mechanism: &dyn Playable, share: f64) -> Vec<f64> {
        let mut motors = mechanism.motors();
        match self.drive {
            Drive::Motion => {
                let ahead = mechanism.motion(self.phase + share);
                let here = mechanism.motion(self.phase);
                for (motor, (ahead, here)) in motors.iter_mut().zip(ahead.iter().zip(here)) {
                    *motor += ahead - here;
                }
            }
            Drive::Motor(driven) => {
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
    pub fn rates(&self, mechanism: &dyn Playable, direction: f64) -> Rates {
        const APART: f64 = 1e-4;
        match self.drive {
            Drive::Motion => {
                let at = |share: f64| mechanism.motion(self.phase + share);
                let (before, here, after) = (at(-APART), at(0.0), at(APART));
                let pace = self.seconds * APART;
                let all = before.iter().zip(here).zip(after);
                let all = all.map(|((before, here), after)| {
                    let first = (after - before) / (2.0 * pace);
                    let second = (after - 2.0 * here + before) / (pace * pace);
                    (direction * first, second)
                });
                let (first, second) = all.unzip();
                Rates { first, second }
            }
            Drive::Motor(driven) => {
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

    /// Notes that the mechanism has moved by a share of a whole motion.
    pub fn note_progress(&mut self, share: f64) {
        if self.drive == Drive::Motion {
            self.phase = (self.phase + share).rem_euclid(1.0);
        }
    }
}

/// The reach of each motor in a whole motion. A motor that stands still has one turn, or one scene unit.
fn reaches(mechanism: &dyn Playable) -> Vec<f64> {
    const LOOKS: u32 = 96;
    let phases = (0..=LOOKS).map(|look| f64::from(look) / f64::from(LOOKS));
    let seen: Vec<Vec<f64>> = phases.map(|phase| mechanism.motion(phase)).collect();
    let reach = |(motor, name): (usize, &&str)| {
        let values = seen.iter().filter_map(|values| values.get(motor).copied());
        let most = values.clone().fold(f64::NEG_INFINITY, f64::max);
        let least = values.fold(f64::INFINITY, f64::min);
        let reach = most - least;
        match reach.is_finite() && reach > 0.0 {
            true => reach,
            false if mechanism.slides(name) => 1.0,
            false => TAU,
        }
    };
    mechanism
        .motor_names()
        .iter()
        .enumerate()
        .map(reach)
        .collect()
}
