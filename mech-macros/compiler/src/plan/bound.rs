//! Bounds on rates.

use crate::model::JointId;

/// An angle whose turns are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Turning {
    /// A source of gears, belts, racks and cams, by its number in the plan.
    Source(usize),
    /// The coordinate of a joint that is carried.
    Joint(JointId),
}

/// The greatest rate of something with each motor and param, while none of the causes in `growth` acts. Each cause multiplies it.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bound {
    /// With each motor and param.
    pub rates: Vec<f64>,
    /// The causes that make it faster. A cause that stands there twice does so twice.
    pub growth: Vec<Growth>,
    /// Whether that is no bound any more but a guess: of what was too wide to be of use.
    pub guessed: bool,
}

/// A cause that makes something faster without end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Growth {
    /// It is faster by the inverse of the sine of this loop, by its number in the plan.
    NearZero(usize),
    /// It is so many times as fast as this motor or param is farther from zero than this number, where it is farther.
    FarOut(usize, f64),
}

/// More causes of growth than this are not listed one by one.
const MOST_GROWTH: usize = 8;

impl Growth {
    /// Whether both are of one loop, motor or param.
    fn is_like(self, other: Self) -> bool {
        match (self, other) {
            (Self::NearZero(a), Self::NearZero(b)) | (Self::FarOut(a, _), Self::FarOut(b, _)) => {
                a == b
            }
            _ => false,
        }
    }
}

impl Bound {
    /// The bound of something that does not change with any of so many inputs.
    #[must_use]
    pub fn still(inputs: usize) -> Self {
        Self { rates: vec![0.0; inputs], growth: Vec::new(), guessed: false }
    }

    /// A motor or param itself.
    #[must_use]
    pub fn of_input(input: usize, inputs: usize) -> Self {
        let mut bound = Self::still(inputs);
        bound.rates[input] = 1.0;
        bound
    }

    /// Adds another bound, times a factor.
    pub fn add(&mut self, factor: f64, other: &Self) {
        if factor == 0.0 || other.rates.iter().all(|rate| *rate == 0.0) {
            return;
        }
        for (rate, more) in self.rates.iter_mut().zip(&other.rates) {
            // A factor without bound does nothing to what stands still.
            if *more != 0.0 {
                *rate += factor * more;
            }
        }
        self.guessed |= other.guessed;
        self.grow_like(&other.growth);
    }

    /// Adds the causes of growth of another bound. A cause stands here as often as in the bound where it stands more often.
    pub fn grow_like(&mut self, growth: &[Growth]) {
        let mut own = self.growth.clone();
        for &other in growth {
            match own.iter().position(|own| own.is_like(other)) {
                Some(place) => {
                    own.swap_remove(place);
                }
                None => self.growth.push(other),
            }
        }
        // Of a long chain the last loops matter most, and a list of all before each would be longer than the whole program.
        let beyond = self.growth.len().saturating_sub(MOST_GROWTH);
        self.guessed |= beyond > 0;
        self.growth.drain(..beyond);
    }
}
