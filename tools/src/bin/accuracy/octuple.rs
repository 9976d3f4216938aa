//! Numbers of seventy digits, in which the reference is computed.

use ::f256::{consts::TAU, f256};
use mech_runtime::{Phase, Real};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A float of 256 bits.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) struct Octuple(f256);

impl From<f64> for Octuple {
    fn from(value: f64) -> Self {
        Self(value.into())
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {
        $(impl $operator for Octuple {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}

operators!(Add add Sub sub Mul mul Div div);

impl Neg for Octuple {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Octuple {
    // Thirty digits are enough for a reference: loops are solved as far as that.
    const EPSILON: f64 = 16.0 * f64::EPSILON * f64::EPSILON;
    const ZERO: Self = Self(f256::ZERO);
    const ONE: Self = Self(f256::ONE);
    const HALF: Self = Self(f256::from_bits((0x3FFF_E000 << 96, 0)));
    const TURN: Self = Self(TAU);

    fn from_f64(value: f64) -> Self {
        value.into()
    }

    fn from_i32(value: i32) -> Self {
        Self(value.into())
    }

    fn from_i64(value: i64) -> Self {
        Self(value.into())
    }

    fn of_phase(phase: Phase) -> (i64, Self) {
        let fraction = Self(phase.fraction().into()) / Self((1_u128 << 64).into());
        let (turns, remainder) = if fraction >= Self::HALF {
            (phase.turns().saturating_add(1), fraction - Self::ONE)
        } else {
            (phase.turns(), fraction)
        };
        (turns, remainder * Self::TURN)
    }

    fn whole_turns(self) -> Option<(i32, Self)> {
        let turns = (self / Self::TURN).round();
        let whole = i32::try_from(&turns.0).ok()?;
        Some((whole, self - turns * Self::TURN))
    }

    /// The first bits of both formats have the same meaning, but for the exponent, which is longer here.
    fn to_f64(self) -> f64 {
        const BIAS: i32 = 0x3_FFFF;
        if self.0.is_nan() {
            return f64::NAN;
        }
        let bits = self.0.abs().to_bits().0;
        let bits = (bits >> 56) + (bits >> 55 & 1);
        let part = |bits: u128| u64::try_from(bits).unwrap_or_default();
        let fraction = part(bits & ((1 << 52) - 1)) | 1.0_f64.to_bits();
        let exponent = i32::try_from(bits >> 52).unwrap_or(i32::MAX) - BIAS;
        let size = f64::from_bits(fraction) * 2.0_f64.powi(exponent);
        if self.0.is_sign_negative() { -size } else { size }
    }

    #[expect(clippy::cast_possible_truncation, reason = "that is what is asked for")]
    fn to_i32(self) -> i32 {
        Self(self.0.trunc()).to_f64() as i32
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }

    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(&x.0))
    }

    fn exp(self) -> Self {
        Self(self.0.exp())
    }

    fn round(self) -> Self {
        Self(self.0.round())
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn to_floats() {
        for value in [0.0, -0.5, 1.0 / 3.0, -1e300, 1e-300, 12.5, f64::INFINITY] {
            assert_eq!(Octuple::from(value).to_f64(), value);
        }
        assert!(Octuple::from(f64::NAN).to_f64().is_nan());
        let third = Octuple::ONE / Octuple::from_i32(3);
        assert_eq!(third.to_f64(), 1.0 / 3.0);
        assert_eq!(Octuple::TURN.to_f64(), std::f64::consts::TAU);
        assert_eq!(Octuple::HALF, 0.5.into());
    }

    #[test]
    fn phases() {
        let phase = Phase::new(-3, 3 << 62);
        let quarter = Octuple::TURN / Octuple::from_i32(4);
        assert_eq!(Octuple::of_phase(phase), (-2, -quarter));
        assert_eq!(quarter.whole_turns(), Some((0, quarter)));
    }
}
