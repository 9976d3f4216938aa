//! What tests and benches of the whole house share.

mod cam;
mod chain;
mod closure;
mod dice;
mod fixtures;
mod folder;
mod grow;
mod house;
pub mod journeys;
pub mod judge;
mod measure;
mod painted;
mod sample;
mod shuffled;
mod simulated;
pub mod sketch;
mod source;
pub mod symmetric;
mod text;
mod varied;

pub use cam::{add_cam, law, model_of_law};
pub use chain::{chain, chain_text, uneven_chain_text};
pub use closure::{coordinate, factor, size, slip, with_ground, worst_gap, worst_stretch};
pub use dice::{Dice, cases, seeds};
pub use fixtures::{GALLERY, four_bar_text, known, known_texts, with_own_params};
pub use folder::{Case, folder, repository};
pub use grow::{Grown, grow, grow_coupled, grow_coupled_from, grow_from, grow_wild, in_own_frames};
pub use house::{House, rustc};
pub use measure::{apart, cross, differences, dot, in_f64, lengths, reach, valley};
pub use painted::painted_outside;
pub use sample::{Sample, coupled_samples, dice, for_all, samples};
pub use shuffled::{
    driven_elsewhere, driven_on_the_ground, on_any_ground, reordered, shuffle, shuffled,
};
pub use simulated::Simulated;
pub use source::{bodies, mechanism_of, mechanisms, model, models, parsed};
pub use text::{part_of, text};
pub use varied::add_axis;
pub use varied::{place, scale, vary, with_params};

use std::fs;
use std::sync::LazyLock;
use std::time::Instant;

/// Medians of two things timed side by side.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Nanoseconds a call of the first.
    pub first: f64,
    /// Nanoseconds a call of the second.
    pub second: f64,
    /// The median of the ratios, first to second, round by round.
    pub ratio: f64,
}

/// Times two things in one process, in turn, because a machine's speed drifts. Medians over the rounds, in each of which both are
/// called as often as there is time for.
pub fn side_by_side(mut first: impl FnMut(), mut second: impl FnMut()) -> Times {
    const ROUNDS: usize = 31;
    let calls = calls(time(&mut first, 1).max(time(&mut second, 1)));
    let mut rounds = Vec::with_capacity(ROUNDS);
    for _ in 0..ROUNDS {
        rounds.push((time(&mut first, calls), time(&mut second, calls)));
    }
    Times {
        first: median(rounds.iter().map(|round| round.0)),
        second: median(rounds.iter().map(|round| round.1)),
        ratio: median(rounds.iter().map(|round| round.0 / round.1)),
    }
}

/// How often something is called in a round that takes so many nanoseconds.
fn calls(nanoseconds: f64) -> u32 {
    const ROUND: f64 = 4e6;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small number")]
    let calls = (ROUND / nanoseconds) as u32;
    calls.clamp(4, 200)
}

/// Nanoseconds a call.
fn time(call: &mut impl FnMut(), calls: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        call();
    }
    start.elapsed().as_secs_f64() * 1e9 / f64::from(calls)
}

/// The value in the middle.
pub fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Milliseconds that this thread was at work, where the system tells: others may work on the same processor. It tells them every few
/// milliseconds.
#[must_use]
pub fn worked() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let told = told.and_then(|told| told.split(' ').next()?.parse::<f64>().ok());
    told.map_or_else(|| START.elapsed().as_secs_f64() * 1e3, |nanoseconds| nanoseconds * 1e-6)
}
