//! The functions of the language: their names, their values now, and their slopes.

/// The functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Function {
    /// The square root.
    Sqrt,
    /// The sine of an angle in radians.
    Sin,
    /// The cosine of an angle in radians.
    Cos,
    /// The tangent of an angle in radians.
    Tan,
    /// The angle in radians, between −π/2 and π/2, that has this sine.
    Asin,
    /// The angle in radians, between 0 and π, that has this cosine.
    Acos,
    /// The angle in radians, between −π/2 and π/2, that has this tangent.
    Atan,
    /// e to a power.
    Exp,
    /// The absolute value.
    Abs,
    /// The greatest whole number that is not greater.
    Floor,
    /// 1 if it is positive, −1 if it is negative, 0 if it is zero.
    Sign,
}

/// The functions of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BinaryFunction {
    /// The angle in radians, between −π and π, of the vector that has the first as its y and the second as its x.
    Atan2,
    /// The length of the vector of these two.
    Hypot,
    /// The lesser of the two.
    Min,
    /// The greater of the two.
    Max,
    /// The remainder of the first after whole times the second, on the second's side of zero.
    Mod,
}

impl Function {
    /// Whether it is a function of an angle in radians.
    #[must_use]
    pub fn is_of_angle(self) -> bool {
        matches!(self, Self::Sin | Self::Cos | Self::Tan)
    }

    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Sqrt,
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Exp,
        Self::Abs,
        Self::Floor,
        Self::Sign,
    ];

    /// Returns its name in the text.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sqrt => "sqrt",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan => "atan",
            Self::Exp => "exp",
            Self::Abs => "abs",
            Self::Floor => "floor",
            Self::Sign => "sign",
        }
    }

    /// Its value: not finite where it has none. The same bits on every machine.
    #[must_use]
    pub fn at(self, a: f64) -> f64 {
        match self {
            Self::Sqrt => libm::sqrt(a),
            Self::Sin => libm::sin(a),
            Self::Cos => libm::cos(a),
            Self::Tan => libm::tan(a),
            Self::Asin => libm::asin(a),
            Self::Acos => libm::acos(a),
            Self::Atan => libm::atan(a),
            Self::Exp => libm::exp(a),
            Self::Abs => a.abs(),
            Self::Floor => libm::floor(a),
            Self::Sign if a == 0.0 => 0.0,
            Self::Sign => a / a.abs(),
        }
    }

    /// Its slope: not finite where it has none. Where it jumps or has a corner, that of the side it is on.
    #[must_use]
    pub fn slope_at(self, a: f64) -> f64 {
        let tan = || libm::tan(a);
        match self {
            Self::Sqrt => 0.5 / libm::sqrt(a),
            Self::Sin => libm::cos(a),
            Self::Cos => -libm::sin(a),
            Self::Tan => 1.0 + tan() * tan(),
            Self::Asin => 1.0 / libm::sqrt((1.0 - a) * (1.0 + a)),
            Self::Acos => -1.0 / libm::sqrt((1.0 - a) * (1.0 + a)),
            Self::Atan => 1.0 / (1.0 + a * a),
            Self::Exp => libm::exp(a),
            Self::Abs => 1.0_f64.copysign(a),
            Self::Floor | Self::Sign => 0.0,
        }
    }

    /// Why it has no value for a number, if it has none.
    #[must_use]
    pub fn trouble_at(self, a: f64) -> Option<&'static str> {
        match self {
            Self::Sqrt if a < 0.0 => Some("has no square root; it is negative"),
            Self::Asin if a.abs() > 1.0 => Some("is the sine of no angle; sines are from -1 to 1"),
            Self::Acos if a.abs() > 1.0 => {
                Some("is the cosine of no angle; cosines are from -1 to 1")
            }
            _ => None,
        }
    }

    /// Whether it is the same again after a whole turn.
    #[must_use]
    pub fn is_periodic(self) -> bool {
        matches!(self, Self::Sin | Self::Cos | Self::Tan)
    }
}

impl BinaryFunction {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Atan2, Self::Hypot, Self::Min, Self::Max, Self::Mod];

    /// Returns its name in the text.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Atan2 => "atan2",
            Self::Hypot => "hypot",
            Self::Min => "min",
            Self::Max => "max",
            Self::Mod => "mod",
        }
    }

    /// Its value: not finite where it has none. The same bits on every machine.
    #[must_use]
    pub fn at(self, a: f64, b: f64) -> f64 {
        match self {
            _ if a.is_nan() || b.is_nan() => f64::NAN,
            Self::Atan2 if a == 0.0 && b == 0.0 => f64::NAN,
            Self::Atan2 => libm::atan2(a, b),
            Self::Hypot => libm::hypot(a, b),
            Self::Min => a.min(b),
            Self::Max => a.max(b),
            Self::Mod => a - b * libm::floor(a / b),
        }
    }

    /// Its slopes by both numbers: not finite where it has none. Where it jumps or has a corner, those of the side it is on.
    #[must_use]
    pub fn slopes_at(self, a: f64, b: f64) -> [f64; 2] {
        let first = |is_first: bool| if is_first { [1.0, 0.0] } else { [0.0, 1.0] };
        match self {
            Self::Atan2 => {
                let square = a * a + b * b;
                [b / square, -a / square]
            }
            Self::Hypot => [a, b].map(|side| side / libm::hypot(a, b)),
            Self::Min => first(a < b),
            Self::Max => first(a > b),
            Self::Mod => [1.0, -libm::floor(a / b)],
        }
    }

    /// Why it has no value for two numbers, if it has none.
    #[must_use]
    pub fn trouble_at(self, a: f64, b: f64) -> Option<&'static str> {
        match self {
            Self::Atan2 if a == 0.0 && b == 0.0 => {
                Some("`atan2(0, 0)` has no value; a vector without length has no direction")
            }
            Self::Mod if b == 0.0 => Some("division by zero"),
            _ => None,
        }
    }
}

/// Returns the names of all functions.
pub(crate) fn function_names() -> impl Iterator<Item = &'static str> {
    let of_one = Function::ALL.into_iter().map(Function::name);
    of_one.chain(BinaryFunction::ALL.into_iter().map(BinaryFunction::name))
}
