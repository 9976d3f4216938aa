//! Nanoseconds for the sine and the cosine of one angle, beside libm: `cargo run --release -p mech-core --example speed`.
//!
//! The loops stand in functions of their own, so that their assembly is easily found:
//! `cargo rustc --release -p mech-core --example speed -- --emit asm -C debuginfo=0`.

use mech_core::Phase;
use mech_core::trig::{sin_cos_f32, sin_cos_f64, sin_cos_within_f32, sin_cos_within_f64};
use std::hint::black_box;
use std::time::Instant;

const COUNT: usize = 8192;
const ROUNDS: usize = 2000;

macro_rules! loops {
    ($($name:ident: $angle:ty => $float:ty, $sin_cos:expr;)*) => {$(
        #[inline(never)]
        fn $name(x: &[$angle], sines: &mut [$float], cosines: &mut [$float]) {
            for ((x, sine), cosine) in x.iter().zip(sines).zip(cosines) {
                (*sine, *cosine) = $sin_cos(*x);
            }
        }
    )*};
}

loops! {
    block_f64: f64 => f64, sin_cos_within_f64;
    block_f32: f32 => f32, sin_cos_within_f32;
    scalar_f64: f64 => f64, |x| sin_cos_f64(black_box(x));
    scalar_f32: f32 => f32, |x| sin_cos_f32(black_box(x));
    libm_f64: f64 => f64, |x| libm::sincos(black_box(x));
    libm_f32: f32 => f32, |x| libm::sincosf(black_box(x));
    std_f64: f64 => f64, |x| f64::sin_cos(black_box(x));
    std_f32: f32 => f32, |x| f32::sin_cos(black_box(x));
    phase_f64: Phase => f64, Phase::sin_cos_f64;
    phase_f32: Phase => f32, Phase::sin_cos_f32;
}

/// The best of several times, in nanoseconds for one of `COUNT`.
#[allow(clippy::cast_precision_loss, reason = "it is printed with three digits")]
fn time(mut run: impl FnMut()) -> f64 {
    let per_run = |run: &mut dyn FnMut()| {
        let start = Instant::now();
        for _ in 0..ROUNDS / 10 {
            run();
        }
        start.elapsed().as_secs_f64() * 1e9 / (ROUNDS / 10 * COUNT) as f64
    };
    (0..10).map(|_| per_run(&mut run)).fold(f64::MAX, f64::min)
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "any angles will do"
)]
fn main() {
    let scattered = |i| (i * 40_503 % 65_536) as f64 / 128.0 - 256.0;
    let wide: Vec<f64> = (0..COUNT).map(scattered).collect();
    let narrow: Vec<f32> = wide.iter().map(|x| *x as f32).collect();
    let phases: Vec<Phase> = wide.iter().filter_map(|x| Phase::from_radians(*x)).collect();
    let (mut sines, mut cosines) = (wide.clone(), wide.clone());
    let (mut sines_f32, mut cosines_f32) = (narrow.clone(), narrow.clone());

    macro_rules! report {
        ($($name:ident($x:ident) -> ($sines:ident, $cosines:ident);)*) => {$(
            let best = time(|| $name(black_box(&$x), black_box(&mut $sines), black_box(&mut $cosines)));
            println!("{:12} {best:6.2} ns", stringify!($name));
        )*};
    }
    report! {
        block_f64(wide) -> (sines, cosines);
        scalar_f64(wide) -> (sines, cosines);
        libm_f64(wide) -> (sines, cosines);
        std_f64(wide) -> (sines, cosines);
        phase_f64(phases) -> (sines, cosines);
        block_f32(narrow) -> (sines_f32, cosines_f32);
        scalar_f32(narrow) -> (sines_f32, cosines_f32);
        libm_f32(narrow) -> (sines_f32, cosines_f32);
        std_f32(narrow) -> (sines_f32, cosines_f32);
        phase_f32(phases) -> (sines_f32, cosines_f32);
    }
}
