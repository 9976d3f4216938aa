//! Laws: functions of one variable, which a motor follows in time.

use super::Origin;

/// A function of one variable: terms, each made from those before it, the last of which is its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    terms: Vec<Term>,
    /// As it was written.
    pub written: String,
    /// Where it was declared.
    pub origin: Origin,
}

/// A term of a law, by its position among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TermId(u32);

impl TermId {
    /// The position in the list of terms.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation of a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Term {
    /// The variable.
    Variable,
    /// A number: finite.
    Number(f64),
    /// −a.
    Negative(TermId),
    /// a + b.
    Sum(TermId, TermId),
    /// a − b.
    Difference(TermId, TermId),
    /// a · b.
    Product(TermId, TermId),
    /// a / b.
    Quotient(TermId, TermId),
    /// A function of a.
    Of(Function, TermId),
    /// The lesser or the greater of two.
    Extreme(Extreme, TermId, TermId),
}

/// One of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The lesser.
    Least,
    /// The greater.
    Greatest,
}

impl Extreme {
    /// Which of the two it is: not a number, if one of them is not.
    #[must_use]
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            _ if a.is_nan() || b.is_nan() => f64::NAN,
            Self::Least => a.min(b),
            Self::Greatest => a.max(b),
        }
    }
}

/// The functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// The square root.
    Sqrt,
    /// The sine of an angle in radians.
    Sin,
    /// The cosine of an angle in radians.
    Cos,
    /// The tangent of an angle in radians.
    Tan,
    /// The angle in radians, between −π/2 and π/2, that has this tangent.
    Atan,
    /// e to a power.
    Exp,
    /// The absolute value.
    Abs,
}

impl Law {
    /// A law without a term yet, which is to have one at least before it is used: until then it is zero.
    #[must_use]
    pub fn new(written: String, origin: Origin) -> Self {
        Self {
            terms: Vec::new(),
            written,
            origin,
        }
    }

    /// Goes on by a term, which is made from earlier ones.
    pub fn push(&mut self, term: Term) -> TermId {
        self.terms.push(term);
        TermId(u32::try_from(self.terms.len() - 1).unwrap_or(u32::MAX))
    }

    /// All terms, each after those from which it is made.
    #[must_use]
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Its value for a value of the variable: not finite where it has none.
    #[must_use]
    pub fn at(&self, variable: f64) -> f64 {
        let mut values: Vec<f64> = Vec::with_capacity(self.terms.len());
        for term in &self.terms {
            let get = |id: TermId| values.get(id.index()).copied().unwrap_or(f64::NAN);
            let value = match *term {
                Term::Variable => variable,
                Term::Number(number) => number,
                Term::Negative(a) => -get(a),
                Term::Sum(a, b) => get(a) + get(b),
                Term::Difference(a, b) => get(a) - get(b),
                Term::Product(a, b) => get(a) * get(b),
                Term::Quotient(a, b) => get(a) / get(b),
                Term::Of(function, a) => function.at(get(a)),
                Term::Extreme(extreme, a, b) => extreme.of(get(a), get(b)),
            };
            values.push(value);
        }
        values.pop().unwrap_or_default()
    }
}

impl Function {
    /// Its value: not finite where it has none. The same bits on every machine.
    #[must_use]
    pub fn at(self, argument: f64) -> f64 {
        match self {
            Self::Sqrt => libm::sqrt(argument),
            Self::Sin => libm::sin(argument),
            Self::Cos => libm::cos(argument),
            Self::Tan => libm::tan(argument),
            Self::Atan => libm::atan(argument),
            Self::Exp => libm::exp(argument),
            Self::Abs => argument.abs(),
        }
    }
}
