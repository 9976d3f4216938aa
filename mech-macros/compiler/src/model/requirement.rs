//! Requirements: conditions on quantities, which are proved for every value of the motors.

use super::{FormulaId, Formulas, Model, MotorId, Origin, Quantity, Rate};

/// A condition that the mechanism has to meet wherever its motors move.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Requirement {
    /// Where it was declared.
    pub origin: Origin,
    /// The condition as it was written: `transmission > 40 deg`.
    pub written: String,
    /// The numbers that it is made from; its variables are what is measured.
    pub formulas: Formulas,
    /// What each variable stands for.
    pub measured: Vec<Measured>,
    /// What has to hold.
    pub condition: Condition,
    /// The values of motors for which it has to hold; for others all that they can have.
    pub cases: Vec<Case>,
    /// The times for which it has to hold while motors follow their laws; if there are none, laws decide only how fast motors are.
    pub times: Option<[f64; 2]>,
    /// The numbers of all loads, in their order: those that nobody gives are zero.
    pub loads: Vec<f64>,
    /// The reason that the user gives.
    pub why: Option<String>,
}

/// The values of a motor for which a requirement has to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Case {
    /// The motor.
    pub motor: MotorId,
    /// Its least and its greatest value, in radians or scene units.
    pub ends: [f64; 2],
    /// Where they were declared.
    pub origin: Origin,
}

/// What has to hold.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Condition {
    /// Each of these bounds.
    Bounds {
        /// What is bounded.
        subject: FormulaId,
        /// Whether that is an angle, in radians.
        is_angle: bool,
        /// The bounds.
        bounds: Vec<RequiredBound>,
    },
    /// The motor turns right round.
    Turns(MotorId),
}

/// A bound that something keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RequiredBound {
    /// By how much it is kept: not negative.
    pub margin: FormulaId,
    /// The number of the other side.
    pub limit: FormulaId,
    /// Whether that is an upper bound of the subject.
    pub is_upper: bool,
    /// Whether the subject must not be equal to it.
    pub is_strict: bool,
}

/// What a variable of a requirement stands for.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Measured {
    /// A number that the position gives.
    Quantity(Quantity),
    /// A number that the whole motion gives.
    Summary(Summary, FormulaId),
    /// The derivative of something by a motor, while all others stand: an influence coefficient.
    Influence(FormulaId, MotorId),
    /// The derivative of something by the time, while the motors move.
    Rate(Rate, FormulaId),
}

impl Measured {
    /// The quantity, if it is one.
    #[must_use]
    pub fn quantity(&self) -> Option<Quantity> {
        match self {
            Self::Quantity(quantity) => Some(*quantity),
            _ => None,
        }
    }
}

impl Requirement {
    /// The quantities that it measures.
    pub fn quantities(&self) -> impl Iterator<Item = Quantity> + Clone + '_ {
        self.measured.iter().filter_map(Measured::quantity)
    }

    /// Whether it measures a force or a torque.
    #[must_use]
    pub fn is_about_forces(&self) -> bool {
        self.quantities().any(Quantity::is_force)
    }

    /// Whether it measures a velocity or an acceleration, or something that only a motion has.
    #[must_use]
    pub fn is_about_rates(&self) -> bool {
        let mut all = self.measured.iter();
        self.quantities().any(Quantity::needs_motion)
            || all.any(|measured| matches!(measured, Measured::Rate(..)))
    }

    /// The motor that moves where rates are measured and no motor has a law: the only one that does not stand at one value. If there is not
    /// one such motor, all of them.
    ///
    /// # Errors
    /// The motors that may be meant.
    pub fn moving_motor(&self, model: &Model) -> Result<MotorId, Vec<MotorId>> {
        let stands = |motor: MotorId| {
            let mut cases = self.cases.iter();
            cases.any(|case| case.motor == motor && case.ends[0] == case.ends[1])
        };
        let all: Vec<MotorId> = model.motor_ids().collect();
        let free: Vec<MotorId> = all.iter().copied().filter(|one| !stands(*one)).collect();
        match (&all[..], &free[..]) {
            ([only], _) | (_, [only]) => Ok(*only),
            (_, []) => Err(all),
            _ => Err(free),
        }
    }

    /// The words of the effects that compute what it measures.
    #[must_use]
    pub fn effects(&self) -> Vec<&'static str> {
        let mut all = self.measured.iter();
        // Accelerations are made from velocities.
        let rate = if all.any(|one| matches!(one, Measured::Rate(Rate::Acceleration, _))) {
            Some(Rate::Acceleration)
        } else {
            self.is_about_rates().then_some(Rate::Velocity)
        };
        let force = self.is_about_forces().then_some("force");
        rate.map(Rate::word).into_iter().chain(force).collect()
    }
}

/// A number that the whole motion gives.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Summary {
    /// The least value.
    Min,
    /// The greatest value.
    Max,
    /// The difference of the two.
    Swing,
    /// The mean over equal steps of the motor.
    Mean,
    /// The root of the mean square, over the same.
    Rms,
    /// The time of the slower way between least and greatest, divided by that of the quicker one, if the motor turns evenly.
    TimeRatio,
    /// The longest way of the motor on which the value stays within this width.
    Dwell(f64),
}
