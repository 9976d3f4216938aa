//! The kinds of numbers that a requirement compares: angles, lengths, and others.

use crate::model::{
    Arithmetic, BinaryFunction, Dimension, Formula, FormulaArithmetic, Formulas, Function,
    JointKind, Measured, Model, MotorId, Number, ParamId, Summary,
};
use mech_core::Staircase;

/// The kind of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A number, which may stand for an angle or a length.
    Plain,
    Angle,
    Length,
    /// An angle times a number, which may make it a length.
    ScaledAngle,
    /// A length times a number, which may make it an angle.
    ScaledLength,
    /// The sum of an angle and a length.
    Mixed,
}

impl Kind {
    pub(super) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Plain, kind) | (kind, Self::Plain) => kind,
            (one, other) if one == other => one,
            (Self::ScaledAngle | Self::ScaledLength, kind @ (Self::Angle | Self::Length))
            | (kind @ (Self::Angle | Self::Length), Self::ScaledAngle | Self::ScaledLength) => kind,
            (Self::ScaledAngle, Self::ScaledLength) | (Self::ScaledLength, Self::ScaledAngle) => {
                Self::ScaledLength
            }
            _ => Self::Mixed,
        }
    }

    /// This kind times a number.
    fn scaled(self) -> Self {
        match self {
            Self::Angle => Self::ScaledAngle,
            Self::Length => Self::ScaledLength,
            kind => kind,
        }
    }

    /// That of a motor's values.
    fn of_motor(model: &Model, motor: MotorId) -> Self {
        match model.joint(model.motor(motor).joint).kind {
            JointKind::Revolute(..) => Self::Angle,
            _ => Self::Length,
        }
    }

    /// That of the values of whichever motor moves.
    fn of_motors(model: &Model) -> Self {
        let mut all = model.motor_ids().map(|motor| Self::of_motor(model, motor));
        let first = all.next().unwrap_or(Self::Plain);
        if all.all(|kind| kind == first) { first } else { Self::Plain }
    }

    /// That of its derivative.
    fn by(self, other: Self) -> Self {
        match (self, other) {
            (Self::Mixed, _) => Self::Mixed,
            (Self::Length, Self::Angle) => Self::Length,
            _ => Self::Plain,
        }
    }

    /// Whether it is told in degrees.
    pub(super) fn is_angle(self) -> bool {
        matches!(self, Self::Angle | Self::ScaledAngle)
    }
}

/// The kinds of all formulas, by their numbers.
pub(super) fn kinds(model: &Model, formulas: &Formulas, measured: &[Measured]) -> Vec<Kind> {
    let mut arithmetic = Kinds { variables: Vec::new() };
    for one in measured {
        let kind = match one {
            Measured::Quantity(quantity) => match quantity.dimension(model) {
                Dimension::Angle => Kind::Angle,
                Dimension::Length => Kind::Length,
                Dimension::Other => Kind::Plain,
            },
            // Its formula is made from variables before it.
            Measured::Summary(Summary::TimeRatio, _) | Measured::Rate(..) => Kind::Plain,
            Measured::Summary(Summary::Dwell(_), _) => Kind::of_motors(model),
            Measured::Summary(summary, of) => {
                let of = match (summary, formulas.all()[of.index()]) {
                    // Its formula is the square.
                    (Summary::Rms, Formula::Mul(of, _)) => of,
                    _ => *of,
                };
                formulas.evaluate_one(of, &mut arithmetic)
            }
            Measured::Influence(of, motor) => {
                let kind = formulas.evaluate_one(*of, &mut arithmetic);
                kind.by(Kind::of_motor(model, *motor))
            }
        };
        arithmetic.variables.push(kind);
    }
    formulas.evaluate(&mut arithmetic)
}

struct Kinds {
    variables: Vec<Kind>,
}

impl Arithmetic for Kinds {
    type Scalar = Kind;

    fn constant(&mut self, _: f64) -> Kind {
        Kind::Plain
    }

    fn neg(&mut self, a: Kind) -> Kind {
        a
    }

    fn add(&mut self, a: Kind, b: Kind) -> Kind {
        a.and(b)
    }

    fn sub(&mut self, a: Kind, b: Kind) -> Kind {
        a.and(b)
    }

    fn mul(&mut self, a: Kind, b: Kind) -> Kind {
        match (a, b) {
            (Kind::Mixed, _) | (_, Kind::Mixed) => Kind::Mixed,
            (Kind::Plain, kind) | (kind, Kind::Plain) => kind.scaled(),
            _ => Kind::Plain,
        }
    }

    fn div(&mut self, a: Kind, b: Kind) -> Kind {
        match (a, b) {
            (Kind::Mixed, _) | (_, Kind::Mixed) => Kind::Mixed,
            (kind, Kind::Plain) => kind.scaled(),
            _ => Kind::Plain,
        }
    }
}

impl FormulaArithmetic for Kinds {
    fn variable(&mut self, number: usize) -> Kind {
        self.variables.get(number).copied().unwrap_or(Kind::Plain)
    }

    fn param(&mut self, _: ParamId) -> Kind {
        Kind::Plain
    }

    fn of(&mut self, function: Function, a: Kind) -> Kind {
        match function {
            _ if a == Kind::Mixed => a,
            Function::Abs | Function::Floor => a,
            Function::Asin | Function::Acos | Function::Atan => Kind::Angle,
            _ => Kind::Plain,
        }
    }

    fn of_both(&mut self, function: BinaryFunction, a: Kind, b: Kind) -> Kind {
        match function {
            BinaryFunction::Atan2 if a.and(b) != Kind::Mixed => Kind::Angle,
            _ => a.and(b),
        }
    }

    fn stairs(&mut self, _: Staircase, _: Kind, _: Number) -> Kind {
        Kind::Plain
    }
}
