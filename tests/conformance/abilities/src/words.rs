//! What can be recorded in words of 64 bits.

use mech_runtime::raster::Area;
use mech_runtime::{
    Acceleration, Blocked, BlockedAt, Forces, Isometry2, Phase, Point2, Pose, Reached, Reaction,
    Scalar, Vector2, Velocity,
};

/// Something that can be recorded in words of 64 bits: no two of a kind in the same ones.
pub(super) trait Words {
    /// Records it.
    fn record(&self, word: &mut impl FnMut(u64));
}

macro_rules! words {
    ($($number:ty: $number_of:expr;)*) => {
        $(
            impl Words for $number {
                fn record(&self, word: &mut impl FnMut(u64)) {
                    let number_of: fn($number) -> u64 = $number_of;
                    word(number_of(*self));
                }
            }
        )*
    };
}

words! {
    f64: f64::to_bits;
    f32: |number| f64::from(number).to_bits();
    u64: |number| number;
    u32: u64::from;
    u8: u64::from;
    bool: u64::from;
    usize: |number| number as u64;
    i64: i64::cast_unsigned;
}

macro_rules! words_in_parts {
    ($([$($of:tt)*] $kind:ty: $($part:tt),*;)*) => {
        $(
            impl<$($of)*> Words for $kind {
                fn record(&self, word: &mut impl FnMut(u64)) {
                    $(self.$part.record(word);)*
                }
            }
        )*
    };
}

words_in_parts! {
    [A: Words, B: Words] (A, B): 0, 1;
    [A: Words, B: Words, C: Words] (A, B, C): 0, 1, 2;
    [T: Words] Pose<T>: cos, sin, x, y;
    [T: Words] Velocity<T>: angular, x, y;
    [T: Words] Acceleration<T>: angular, x, y;
    [T: Words] Reaction<T>: x, y, torque;
    [T: Words + Scalar] Point2<T>: x, y;
    [T: Words + Scalar] Vector2<T>: x, y;
    [T: Words, const M: usize, const J: usize, const L: usize, const D: usize]
        Forces<T, M, J, L, D>: torques, reactions, velocity_ratios, transmission;
    [M: Words] BlockedAt<M>: index, blocked;
    [] Area: x, y, width, height;
}

impl<T: Words + Scalar> Words for Isometry2<T> {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.rotation.re.record(word);
        self.rotation.im.record(word);
        self.translation.vector.record(word);
    }
}

impl Words for Phase {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.turns().record(word);
        self.fraction().record(word);
    }
}

impl Words for () {
    fn record(&self, _: &mut impl FnMut(u64)) {}
}

impl Words for &str {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.len().record(word);
        mech_probes::sum(self.bytes().map(u16::from)).record(word);
    }
}

impl<T: Words> Words for [T] {
    fn record(&self, word: &mut impl FnMut(u64)) {
        for part in self {
            part.record(word);
        }
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.as_slice().record(word);
    }
}

impl<T: Words + ?Sized> Words for &T {
    fn record(&self, word: &mut impl FnMut(u64)) {
        (**self).record(word);
    }
}

impl<T: Words> Words for Option<T> {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.is_some().record(word);
        if let Some(it) = self {
            it.record(word);
        }
    }
}

impl<T: Words, E: Words> Words for Result<T, E> {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.is_ok().record(word);
        match self {
            Ok(it) => it.record(word),
            Err(error) => error.record(word),
        }
    }
}

impl<M: Words> Words for Blocked<M> {
    fn record(&self, word: &mut impl FnMut(u64)) {
        self.place.record(word);
        (self.cause as u8).record(word);
        self.reached.record(word);
    }
}

impl<M: Words> Words for Reached<M> {
    fn record(&self, word: &mut impl FnMut(u64)) {
        match self {
            Self::Target => true.record(word),
            Self::Limit(blocked) => {
                false.record(word);
                blocked.record(word);
            }
        }
    }
}
