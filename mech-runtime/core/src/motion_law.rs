//! Standard motion laws: how a follower goes from one place to the next.
//!
//! Sources: H. A. Rothbart, *Cam Design Handbook* (2004), chapters 2 and 3; C. N. Neklutin, *Mechanisms and Cams for Automatic
//! Machines* (1969), for the two modified laws. Both the way and its time are from 0 to 1 here.

use crate::Real;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// A standard motion law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum MotionLaw {
    /// A constant velocity, which jumps at both ends.
    Linear,
    /// A constant acceleration, and after the middle its opposite.
    Parabolic,
    /// Half a wave of the cosine.
    Harmonic,
    /// A whole wave of the sine as acceleration.
    Cycloidal,
    /// A polynomial of degree 5, whose acceleration vanishes at both ends.
    Polynomial345,
    /// A polynomial of degree 7, whose jerk vanishes at both ends, too.
    Polynomial4567,
    /// Cycloidal at both ends, a slower sine between: the least torque on a shaft.
    ModifiedSine,
    /// A constant acceleration that begins and ends by waves of the sine: the least acceleration.
    ModifiedTrapezoid,
}

/// A part of the first half of a law, until a time: there it is a polynomial and a wave.
struct Piece {
    until: f64,
    /// The coefficients of the polynomial, that of the constant first.
    polynomial: &'static [f64],
    /// The amplitude, the angular frequency and the phase of the sine.
    wave: [f64; 3],
}

const fn piece(until: f64, polynomial: &'static [f64], wave: [f64; 3]) -> Piece {
    Piece { until, polynomial, wave }
}

/// A polynomial until the middle.
const fn polynomial(coefficients: &'static [f64]) -> Piece {
    piece(0.5, coefficients, [0.0; 3])
}

static LINEAR: [Piece; 1] = [polynomial(&[0.0, 1.0])];
static PARABOLIC: [Piece; 1] = [polynomial(&[0.0, 0.0, 2.0])];
static HARMONIC: [Piece; 1] = [piece(0.5, &[0.5], [-0.5, PI, FRAC_PI_2])];
static CYCLOIDAL: [Piece; 1] = [piece(0.5, &[0.0, 1.0], [-1.0 / TAU, TAU, 0.0])];
static POLYNOMIAL_345: [Piece; 1] = [polynomial(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0])];
static POLYNOMIAL_4567: [Piece; 1] = [polynomial(&[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0])];

/// The mean velocity of the modified sine.
const SINE: f64 = PI / (4.0 + PI);
/// The amplitude of its quick wave.
const QUICK: f64 = 1.0 / (4.0 * (4.0 + PI));
static MODIFIED_SINE: [Piece; 2] = [
    piece(0.125, &[0.0, SINE], [-QUICK, 4.0 * PI, 0.0]),
    piece(0.5, &[2.0 / (4.0 + PI), SINE], [-9.0 * QUICK, 4.0 * PI / 3.0, PI / 3.0]),
];

/// The number by which all numbers of the modified trapezoid are divided.
const TRAPEZOID: f64 = 2.0 + PI;
/// The amplitude of its waves.
const WAVE: f64 = 1.0 / (TAU * TRAPEZOID);
static MODIFIED_TRAPEZOID: [Piece; 3] = [
    piece(0.125, &[0.0, 2.0 / TRAPEZOID], [-WAVE, 4.0 * PI, 0.0]),
    piece(
        0.375,
        &[(PI / 16.0 - 1.0 / TAU) / TRAPEZOID, (2.0 - PI) / TRAPEZOID, 4.0 * PI / TRAPEZOID],
        [0.0; 3],
    ),
    piece(0.5, &[-FRAC_PI_2 / TRAPEZOID, (2.0 + TAU) / TRAPEZOID], [WAVE, 4.0 * PI, 0.0]),
];

impl MotionLaw {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Linear,
        Self::Parabolic,
        Self::Harmonic,
        Self::Cycloidal,
        Self::Polynomial345,
        Self::Polynomial4567,
        Self::ModifiedSine,
        Self::ModifiedTrapezoid,
    ];

    /// Its name in the text of a mechanism.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Parabolic => "parabolic",
            Self::Harmonic => "harmonic",
            Self::Cycloidal => "cycloidal",
            Self::Polynomial345 => "polynomial_345",
            Self::Polynomial4567 => "polynomial_4567",
            Self::ModifiedSine => "modified_sine",
            Self::ModifiedTrapezoid => "modified_trapezoid",
        }
    }

    fn pieces(self) -> &'static [Piece] {
        match self {
            Self::Linear => &LINEAR,
            Self::Parabolic => &PARABOLIC,
            Self::Harmonic => &HARMONIC,
            Self::Cycloidal => &CYCLOIDAL,
            Self::Polynomial345 => &POLYNOMIAL_345,
            Self::Polynomial4567 => &POLYNOMIAL_4567,
            Self::ModifiedSine => &MODIFIED_SINE,
            Self::ModifiedTrapezoid => &MODIFIED_TRAPEZOID,
        }
    }

    /// The times until the middle at which its formula changes, the middle among them. The second half mirrors the first.
    pub fn changes(self) -> impl Iterator<Item = f64> {
        self.pieces().iter().map(|piece| piece.until)
    }

    /// A number that no derivative of this order exceeds in size.
    #[must_use]
    pub fn bound(self, order: u8) -> f64 {
        let of_piece = |piece: &Piece| {
            let [amplitude, frequency, _] = piece.wave;
            let wave = (0..order).fold(amplitude.abs(), |product, _| product * frequency);
            let sizes = differentiated(piece.polynomial, order);
            sizes.fold(0.0, |sum, coefficient| 0.5 * sum + coefficient.abs()) + wave
        };
        let bounds = self.pieces().iter().map(of_piece);
        bounds.fold(0.0, f64::max)
    }

    /// The derivative of this order of the way by the time, for a time from 0 to 1. Of order 0 it is the way itself.
    ///
    /// ```
    /// use mech_core::MotionLaw;
    ///
    /// assert_eq!(MotionLaw::Parabolic.at(0, 0.25), 0.125);
    /// assert_eq!(MotionLaw::Polynomial345.at(1, 0.5), 1.875);
    /// ```
    #[must_use]
    pub fn at<T: Real>(self, order: u8, time: T) -> T {
        if time > T::HALF {
            let mirrored = self.in_first_half(order, T::ONE - time);
            return match order {
                0 => T::ONE - mirrored,
                _ if order.is_multiple_of(2) => -mirrored,
                _ => mirrored,
            };
        }
        self.in_first_half(order, time)
    }

    fn in_first_half<T: Real>(self, order: u8, time: T) -> T {
        let later = |piece: &&Piece| time < T::from_f64(piece.until);
        let pieces = self.pieces();
        let Some(piece) = pieces.iter().find(later).or(pieces.last()) else {
            return T::ZERO;
        };
        let coefficients = differentiated(piece.polynomial, order);
        let sum =
            coefficients.fold(T::ZERO, |sum, coefficient| sum * time + T::from_f64(coefficient));
        let [amplitude, frequency, phase] = piece.wave;
        if amplitude == 0.0 {
            return sum;
        }
        let factor = (0..order).fold(amplitude, |product, _| product * frequency);
        let (sin, cos) = (T::from_f64(frequency) * time + T::from_f64(phase)).sin_cos();
        let wave = match order % 4 {
            0 => sin,
            1 => cos,
            2 => -sin,
            _ => -cos,
        };
        sum + T::from_f64(factor) * wave
    }
}

/// The coefficients of a derivative of a polynomial, that of the highest power first.
fn differentiated(polynomial: &[f64], order: u8) -> impl Iterator<Item = f64> {
    let powers = polynomial.iter().zip(0..u16::MAX).skip(usize::from(order));
    powers.rev().map(move |(coefficient, power)| {
        let factors = (power + 1 - u16::from(order)..=power).map(f64::from);
        factors.fold(*coefficient, |product, factor| product * factor)
    })
}

/// A staircase: at each whole number a step, which is climbed by a motion law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Staircase {
    /// How each step is climbed.
    pub law: MotionLaw,
    /// Whether there is a step at each whole number; else only at zero.
    pub repeats: bool,
    /// The number of differentiations of the climb by its time.
    pub order: u8,
}

impl Staircase {
    /// The staircase that has a step at each whole number.
    #[must_use]
    pub const fn endless(law: MotionLaw, order: u8) -> Self {
        Self { law, repeats: true, order }
    }

    /// The staircase of one step.
    #[must_use]
    pub const fn single(law: MotionLaw, order: u8) -> Self {
        Self { law, repeats: false, order }
    }

    /// Its slope, times the share of a step.
    #[must_use]
    pub const fn slope(self) -> Self {
        Self { order: self.order.saturating_add(1), ..self }
    }

    /// The height, in steps, at a place of which each step takes this share: more than 0, and 1 at most.
    ///
    /// Of a higher order it is the derivative by the place, times as many powers of the share. At a step's ends it is that of what comes.
    /// What is not a number has no height.
    ///
    /// ```
    /// use mech_core::{MotionLaw, Staircase};
    ///
    /// let stairs = Staircase::endless(MotionLaw::Harmonic, 0);
    /// assert_eq!(stairs.at(2.25, 0.5), 2.5);
    /// assert_eq!(stairs.at(2.5, 0.5), 3.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn at<T: Real>(self, place: T, share: T) -> T {
        let step = if self.repeats { floor(place) } else { T::ZERO };
        let time = (place - step) / share;
        let of_step = |height: T| {
            if self.order == 0 { height } else { T::ZERO }
        };
        if time < T::ZERO {
            return of_step(step);
        }
        if time >= T::ONE {
            return of_step(step + T::ONE);
        }
        if self.order == 0 { step + self.law.at(0, time) } else { self.law.at(self.order, time) }
    }
}

/// The greatest whole number that is not greater.
#[inline]
fn floor<T: Real>(of: T) -> T {
    let near = of.round();
    if near > of { near - T::ONE } else { near }
}
