//! What the benches of speed share: comparisons, repeated to show their spread, printed with their thresholds.

use mech_test_support::{median, side_by_side};

/// How often each comparison is repeated.
const REPEATS: usize = 7;

/// What a ratio of two times should be.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code, reason = "no bench needs all of them")]
pub(crate) enum Threshold {
    /// At most so much.
    AtMost(f64),
    /// At least so much.
    AtLeast(f64),
    /// It is only shown.
    None,
}

impl Threshold {
    fn words(self, ratio: f64) -> String {
        let (text, is_shown) = match self {
            Self::AtMost(limit) => (format!("at most {limit:.2}"), ratio <= limit),
            Self::AtLeast(limit) => (format!("at least {limit:.2}"), ratio >= limit),
            Self::None => return "no threshold".to_owned(),
        };
        if is_shown { text } else { format!("{text}: MISSED") }
    }
}

/// Prints the ratio of the first time to the second: the median of several measurements, and their range.
///
/// `positions` is how many positions a call computes. Gives the ratio, and nanoseconds a position of both.
pub(crate) fn compare(
    what: &str,
    names: [&str; 2],
    positions: f64,
    threshold: Threshold,
    mut first: impl FnMut(),
    mut second: impl FnMut(),
) -> (f64, [f64; 2]) {
    let times: Vec<_> = (0..REPEATS).map(|_| side_by_side(&mut first, &mut second)).collect();
    let ratios = || times.iter().map(|times| times.ratio);
    let ratio = median(ratios());
    let (least, most) = (ratios().fold(f64::INFINITY, f64::min), ratios().fold(0.0, f64::max));
    let each = [
        median(times.iter().map(|times| times.first)) / positions,
        median(times.iter().map(|times| times.second)) / positions,
    ];
    println!(
        "{what:<52} {} {:6.2} ns, {} {:6.2} ns, ratio {ratio:.3} ({least:.3} to {most:.3}; {})",
        names[0],
        each[0],
        names[1],
        each[1],
        threshold.words(ratio)
    );
    (ratio, each)
}
