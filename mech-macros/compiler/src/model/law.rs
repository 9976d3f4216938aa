//! Laws: functions of one variable, which a motor follows in time, or the follower of a cam.

use super::Origin;
use super::id::in_32_bits;

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
        TermId(in_32_bits(self.terms.len() - 1))
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
            let get = |id: TermId| values[id.index()];
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
        // Without a term it is zero.
        values.pop().unwrap_or(0.0)
    }
}

/// How a term goes on when the variable has gone on by a whole turn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Winding {
    /// It is a number.
    Fixed(f64),
    /// It has gone on by so many whole turns.
    By(f64),
    /// Otherwise.
    Else,
}

impl Winding {
    fn by(self) -> Option<f64> {
        match self {
            Self::Fixed(_) => Some(0.0),
            Self::By(turns) => Some(turns),
            Self::Else => None,
        }
    }

    /// What comes of two, if they go on by these.
    fn joined(self, other: Self, turns: impl FnOnce(f64, f64) -> Option<f64>) -> Self {
        let both = self.by().zip(other.by());
        both.and_then(|(a, b)| turns(a, b))
            .map_or(Self::Else, Self::By)
    }
}

impl Law {
    /// By how many whole turns its value goes on when the variable does by one: zero, if it is periodic. Nothing, if that depends
    /// on where it is, or nobody can tell.
    #[must_use]
    pub fn winding(&self) -> Option<f64> {
        let mut windings: Vec<Winding> = Vec::with_capacity(self.terms.len());
        let still = |a: f64, b: f64| (a == 0.0 && b == 0.0).then_some(0.0);
        for term in &self.terms {
            let get = |id: TermId| windings[id.index()];
            let winding = match *term {
                Term::Variable => Winding::By(1.0),
                Term::Number(number) => Winding::Fixed(number),
                Term::Negative(a) => get(a).joined(Winding::By(0.0), |a, _| Some(-a)),
                Term::Sum(a, b) => get(a).joined(get(b), |a, b| Some(a + b)),
                Term::Difference(a, b) => get(a).joined(get(b), |a, b| Some(a - b)),
                Term::Product(a, b) => match (get(a), get(b)) {
                    (Winding::Fixed(factor), Winding::By(turns))
                    | (Winding::By(turns), Winding::Fixed(factor)) => Winding::By(factor * turns),
                    (a, b) => a.joined(b, still),
                },
                Term::Quotient(a, b) => match (get(a), get(b)) {
                    (Winding::By(turns), Winding::Fixed(divisor)) => Winding::By(turns / divisor),
                    (a, b) => a.joined(b, still),
                },
                Term::Of(function, a) => {
                    let waves = matches!(function, Function::Sin | Function::Cos | Function::Tan);
                    let periodic = |turns: f64| turns == 0.0 || waves && turns.fract() == 0.0;
                    get(a).joined(Winding::By(0.0), |a, _| periodic(a).then_some(0.0))
                }
                Term::Extreme(_, a, b) => get(a).joined(get(b), |a, b| (a == b).then_some(a)),
            };
            windings.push(winding);
        }
        // Without a term it is zero.
        windings.pop().unwrap_or(Winding::Fixed(0.0)).by()
    }

    /// Whether its variable is in it.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.terms.contains(&Term::Variable)
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
