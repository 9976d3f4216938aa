//! The emitted closed form of a four-bar beside one written by hand: same geometry, same outputs, same guard, one process,
//! interleaved rounds, medians, and the range of several repetitions. The ratio that counts is the one to the fastest of
//! three hand-written ones, which differ in where they take sine and cosine from. `cargo bench -p mech-tests --bench exact`
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_lossless,
    clippy::neg_cmp_op_on_partial_ord,
    reason = "small numbers; what is not a number must not pass"
)]

mod common;

use common::{Threshold, compare};
use std::hint::black_box;

/// A four-bar: ground 4, crank 1, coupler 3.5, rocker 3.
macro_rules! emitted {
    ($name:ident, $float:ident, $($range:tt)*) => {
        mech_test_support::four_bar!(struct $name: $float; motor a $($range)*;);
    };
}

/// Where the hand-written ones take sine and cosine from.
trait Sines<T> {
    fn sin_cos(angle: T) -> (T, T);
}
struct Ours;
struct Libm;
struct Std;
impl Sines<f64> for Ours {
    #[inline]
    fn sin_cos(angle: f64) -> (f64, f64) {
        mech_runtime::generated::sin_cos(angle)
    }
}
impl Sines<f32> for Ours {
    #[inline]
    fn sin_cos(angle: f32) -> (f32, f32) {
        mech_runtime::generated::sin_cos(angle)
    }
}
impl Sines<f64> for Libm {
    #[inline]
    fn sin_cos(angle: f64) -> (f64, f64) {
        libm::sincos(angle)
    }
}
impl Sines<f32> for Libm {
    #[inline]
    fn sin_cos(angle: f32) -> (f32, f32) {
        libm::sincosf(angle)
    }
}
impl Sines<f64> for Std {
    #[inline]
    fn sin_cos(angle: f64) -> (f64, f64) {
        angle.sin_cos()
    }
}
impl Sines<f32> for Std {
    #[inline]
    fn sin_cos(angle: f32) -> (f32, f32) {
        angle.sin_cos()
    }
}

macro_rules! bench {
    ($float:ident, $tolerance:expr) => {
        pub(crate) mod $float {
            use super::*;

            emitted!(Emitted, $float,);
            emitted!(Ranged, $float, in -1 deg ..= 361 deg);

            /// The same four-bar as a programmer would write it who knows the subject: cosine, sine, x and y of the crank, the
            /// coupler and the rocker.
            struct ByHand {
                poses: [[$float; 4]; 3],
            }

            impl ByHand {
                const GROUND: $float = 4.0;
                const COUPLER: $float = 3.5;
                const ROCKER: $float = 3.0;

                /// The position, and sixteen times the square of the area of the triangle: if that is negative there is none.
                #[inline]
                fn position<S: Sines<$float>>(crank: $float) -> ([[$float; 4]; 3], $float) {
                    const NEAR: $float = (ByHand::COUPLER - ByHand::ROCKER) * (ByHand::COUPLER - ByHand::ROCKER);
                    const FAR: $float = (ByHand::COUPLER + ByHand::ROCKER) * (ByHand::COUPLER + ByHand::ROCKER);
                    let (sin, cos) = S::sin_cos(crank);
                    // From the crank's pin to the rocker's shaft.
                    let (dx, dy) = (Self::GROUND - cos, -sin);
                    let square = dx * dx + dy * dy;
                    let area = (FAR - square) * (square - NEAR);
                    let half = 0.5 / square;
                    let along = 0.5 + half * (Self::COUPLER * Self::COUPLER - Self::ROCKER * Self::ROCKER);
                    let across = area.sqrt() * half;
                    // From the crank's pin to the coupler's other end.
                    let (ax, ay) = (dx * along - dy * across, dy * along + dx * across);
                    let (uc, us) = (ax * (1.0 / Self::COUPLER), ay * (1.0 / Self::COUPLER));
                    let (vc, vs) = ((ax - dx) * (1.0 / Self::ROCKER), (ay - dy) * (1.0 / Self::ROCKER));
                    ([[cos, sin, 0.0, 0.0], [uc, us, cos, sin], [vc, vs, Self::GROUND, 0.0]], area)
                }

                /// Tells whether it moved; it stays where it was if it cannot.
                #[inline]
                fn move_to<S: Sines<$float>>(&mut self, crank: $float) -> bool {
                    if !crank.is_finite() {
                        return false;
                    }
                    let (poses, area) = Self::position::<S>(crank);
                    // So written that what is not a number does not pass.
                    if !(area >= 0.0) {
                        return false;
                    }
                    self.poses = poses;
                    true
                }
            }

            fn angles() -> [$float; 360] {
                std::array::from_fn(|degree| (degree as $float).to_radians())
            }

            /// How much of the last position goes into the next angle in a dependent sequence.
            const PART: $float = $tolerance;

            /// Each value of the motor depends on the last position, by so little that the positions are the same.
            fn dependent<'a, M>(
                mechanism: &'a mut M,
                angles: &'a [$float],
                sine: impl Fn(&M) -> $float + 'a,
                go: impl Fn(&mut M, $float) -> bool + 'a,
            ) -> impl FnMut() + 'a {
                move || {
                    for angle in black_box(angles) {
                        let mechanism = black_box(&mut *mechanism);
                        let angle = *angle + PART * sine(mechanism);
                        assert!(go(mechanism, angle));
                    }
                }
            }

            fn independent<'a, M, A: Copy>(
                mechanism: &'a mut M,
                motors: &'a [A],
                go: impl Fn(&mut M, A) -> bool + 'a,
            ) -> impl FnMut() + 'a {
                move || {
                    for motor in black_box(motors) {
                        assert!(go(black_box(&mut *mechanism), *motor));
                    }
                }
            }

            fn start() -> ByHand {
                ByHand { poses: Emitted::new().poses().map(|pose| [pose.cos, pose.sin, pose.x, pose.y]) }
            }

            pub(crate) fn agree() {
                let (mut emitted, mut ranged, mut by_hand) = (Emitted::new(), Ranged::new(), start());
                for angle in angles() {
                    emitted.move_to([angle]).expect("the crank turns");
                    ranged.move_within(Ranged::range([angle]).expect("it is in the range"));
                    assert!(by_hand.move_to::<Ours>(angle), "the crank turns");
                    assert_eq!(emitted.poses(), ranged.poses(), "the same with a range");
                    for (a, b) in emitted.poses().iter().zip(by_hand.poses) {
                        let off = [a.cos - b[0], a.sin - b[1], a.x - b[2], a.y - b[3]].map($float::abs);
                        assert!(off.iter().all(|off| *off < $tolerance), "both compute the same: {off:?}");
                    }
                }
                assert!(emitted.move_to([$float::NAN]).is_err() && !by_hand.move_to::<Ours>($float::NAN));
            }

            fn against<S: Sines<$float>>(name: &'static str) -> (&'static str, [(f64, [f64; 2]); 2]) {
                let (mut emitted, mut by_hand, angles) = (Emitted::new(), start(), angles());
                let dependent = compare(
                    &format!("{}, each after the last, by hand with {name}", stringify!($float)),
                    ["emitted", "by hand"],
                    360.0,
                    Threshold::None,
                    dependent(&mut emitted, &angles, |m| m.poses()[2].sin, |m, a| m.move_to([a]).is_ok()),
                    dependent(&mut by_hand, &angles, |m| m.poses[2][1], ByHand::move_to::<S>),
                );
                let independent = compare(
                    &format!("{}, independent, by hand with {name}", stringify!($float)),
                    ["emitted", "by hand"],
                    360.0,
                    Threshold::None,
                    independent(&mut emitted, &angles, |m, a| m.move_to([a]).is_ok()),
                    independent(&mut by_hand, &angles, ByHand::move_to::<S>),
                );
                (name, [dependent, independent])
            }

            /// Far apart, so that nothing about the next angle can be guessed from the last ones.
            fn shuffled<S: Sines<$float>>(name: &str) {
                let mut state = 1_u32;
                let angles: Vec<$float> = (0..4096)
                    .map(|_| {
                        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                        ((state >> 8) as $float / 46_603.0).to_radians()
                    })
                    .collect();
                let (mut emitted, mut by_hand) = (Emitted::new(), start());
                compare(
                    &format!("{}, independent, any order, by hand with {name}", stringify!($float)),
                    ["emitted", "by hand"],
                    4096.0,
                    Threshold::None,
                    independent(&mut emitted, &angles, |m, a| m.move_to([a]).is_ok()),
                    independent(&mut by_hand, &angles, ByHand::move_to::<S>),
                );
            }

            /// With a proved range, nothing has to be tested but the range.
            fn within() {
                let (mut ranged, mut by_hand, angles) = (Ranged::new(), start(), angles());
                let inside = angles.map(|angle| Ranged::range([angle]).expect("it is in the range"));
                compare(
                    concat!(stringify!($float), ", independent, move_within, by hand with our sines, guarded"),
                    ["within", "by hand"],
                    360.0,
                    Threshold::None,
                    independent(&mut ranged, &inside, |m, a| {
                        m.move_within(a);
                        true
                    }),
                    independent(&mut by_hand, &angles, ByHand::move_to::<Ours>),
                );
                compare(
                    concat!(stringify!($float), ", independent, move_within, by hand with our sines, unguarded"),
                    ["within", "by hand"],
                    360.0,
                    Threshold::AtMost(1.05),
                    independent(&mut ranged, &inside, |m, a| {
                        m.move_within(a);
                        true
                    }),
                    independent(&mut by_hand, &angles, |m, a| {
                        m.poses = ByHand::position::<Ours>(a).0;
                        true
                    }),
                );
            }

            pub(crate) fn run() {
                agree();
                let against = [against::<Ours>("our sines"), against::<Libm>("libm"), against::<Std>("std")];
                for (index, sequence) in ["each after the last", "independent"].into_iter().enumerate() {
                    let picked = against.iter().map(|(name, times)| (name, times[index].0, times[index].1[1]));
                    let (name, ratio, _) = picked.min_by(|a, b| a.2.total_cmp(&b.2)).expect("three");
                    println!(
                        "=> {}, {sequence}: {ratio:.3} to the fastest by hand, with {name} (at most 1.05{})",
                        stringify!($float),
                        if ratio <= 1.05 { "" } else { ": MISSED" }
                    );
                }
                shuffled::<Ours>("our sines");
                shuffled::<Libm>("libm");
                shuffled::<Std>("std");
                within();
            }
        }
    };
}

bench!(f64, 1e-13);
bench!(f32, 2e-6);

fn main() {
    f64::run();
    f32::run();
}
