//! What can be told in words of 64 bits.

use mech_runtime::raster::Area;
use mech_runtime::{
    Acceleration, Blocked, BlockedAt, Forces, Isometry2, Phase, Point2, Pose, Reached, Reaction,
    Scalar, Vector2, Velocity,
};

/// Something that can be told in words of 64 bits: no two of a kind in the same ones.
pub(super) trait Told {
    /// Tells it.
    fn tell(&self, word: &mut impl FnMut(u64));
}

macro_rules! told {
    ($($number:ty: $number_of:expr;)*) => {
        $(
            impl Told for $number {
                fn tell(&self, word: &mut impl FnMut(u64)) {
                    let number_of: fn($number) -> u64 = $number_of;
                    word(number_of(*self));
                }
            }
        )*
    };
}

told! {
    f64: f64::to_bits;
    f32: |number| f64::from(number).to_bits();
    u64: |number| number;
    u32: u64::from;
    u8: u64::from;
    bool: u64::from;
    usize: |number| number as u64;
    i64: i64::cast_unsigned;
}

macro_rules! told_in_parts {
    ($([$($of:tt)*] $kind:ty: $($part:tt),*;)*) => {
        $(
            impl<$($of)*> Told for $kind {
                fn tell(&self, word: &mut impl FnMut(u64)) {
                    $(self.$part.tell(word);)*
                }
            }
        )*
    };
}

told_in_parts! {
    [A: Told, B: Told] (A, B): 0, 1;
    [A: Told, B: Told, C: Told] (A, B, C): 0, 1, 2;
    [T: Told] Pose<T>: cos, sin, x, y;
    [T: Told] Velocity<T>: angular, x, y;
    [T: Told] Acceleration<T>: angular, x, y;
    [T: Told] Reaction<T>: x, y, torque;
    [T: Told + Scalar] Point2<T>: x, y;
    [T: Told + Scalar] Vector2<T>: x, y;
    [T: Told, const M: usize, const J: usize, const L: usize, const D: usize]
        Forces<T, M, J, L, D>: torques, reactions, velocity_ratios, transmission;
    [M: Told] BlockedAt<M>: index, blocked;
    [] Area: x, y, width, height;
}

impl<T: Told + Scalar> Told for Isometry2<T> {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.rotation.re.tell(word);
        self.rotation.im.tell(word);
        self.translation.vector.tell(word);
    }
}

impl Told for Phase {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.turns().tell(word);
        self.fraction().tell(word);
    }
}

impl Told for () {
    fn tell(&self, _: &mut impl FnMut(u64)) {}
}

impl Told for &str {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.len().tell(word);
        crate::panel::sum(self.bytes().map(u16::from)).tell(word);
    }
}

impl<T: Told> Told for [T] {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        for part in self {
            part.tell(word);
        }
    }
}

impl<T: Told, const N: usize> Told for [T; N] {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.as_slice().tell(word);
    }
}

impl<T: Told + ?Sized> Told for &T {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        (**self).tell(word);
    }
}

impl<T: Told> Told for Option<T> {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.is_some().tell(word);
        if let Some(it) = self {
            it.tell(word);
        }
    }
}

impl<T: Told, E: Told> Told for Result<T, E> {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.is_ok().tell(word);
        match self {
            Ok(it) => it.tell(word),
            Err(error) => error.tell(word),
        }
    }
}

impl<M: Told> Told for Blocked<M> {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        self.place.tell(word);
        (self.cause as u8).tell(word);
        self.reached.tell(word);
    }
}

impl<M: Told> Told for Reached<M> {
    fn tell(&self, word: &mut impl FnMut(u64)) {
        match self {
            Self::Target => true.tell(word),
            Self::Limit(blocked) => {
                false.tell(word);
                blocked.tell(word);
            }
        }
    }
}
