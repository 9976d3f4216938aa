//! Sizes of wheels that fit where their axes are.

use crate::digits::of_four_digits;
use crate::model::Ratio;
use crate::structure::MeshTrouble;

/// A wheel of fewer teeth than this is none.
const FEWEST_TEETH: u8 = 12;
/// Nor is one so many times as large as the other.
const LARGEST: f64 = 100.0;
/// Ratios are looked for among these numbers.
const MOST_PARTS: u8 = 100;
/// So exactly is a ratio met by whole numbers.
const EXACT: f64 = 1e-9;

/// Returns sizes that would fit a gear, the likely ones first: the same ratio, then one of the wheels as it is.
pub(super) fn fitting_sizes(ratio: Ratio, trouble: MeshTrouble) -> Vec<Ratio> {
    let distance = match trouble {
        MeshTrouble::OneShaft => return Vec::new(),
        MeshTrouble::SmallRing if ratio.turned_out().ring_is_small() => return Vec::new(),
        MeshTrouble::SmallRing => return vec![ratio.turned_out()],
        MeshTrouble::Distance { distance, .. } => distance,
    };
    let [a, b] = ratio.sizes();
    let scale = distance / (a + b).abs();
    let signed = |beside: f64| if a + b < 0.0 { -beside } else { beside };
    let sizes = [[a * scale, b * scale], [a, signed(distance) - a], [signed(distance) - b, b]];
    let radii = sizes.map(|sizes| sizes.map(of_four_digits));
    let radii = radii.map(|[a, b]| Ratio::Radii(a, b));
    let mut all: Vec<Ratio> = radii.into_iter().filter(is_gear).collect();
    let place = all.len().min(1);
    all.splice(place..place, teeth(a, b));
    all
}

/// Whether there are two wheels, at most one of them a ring and that the larger.
fn is_gear(ratio: &Ratio) -> bool {
    let [a, b] = ratio.sizes();
    let sizes = [a, b].iter().all(|size| size.is_normal());
    let [less, more] = [a.abs().min(b.abs()), a.abs().max(b.abs())];
    sizes && more <= LARGEST * less && (a > 0.0 || b > 0.0) && !ratio.ring_is_small()
}

/// Numbers of teeth of this ratio, if it is one of small numbers.
fn teeth(a: f64, b: f64) -> Option<Ratio> {
    let ratio = (b / a).abs();
    let fits = |first: u8, second: u8| {
        (ratio * f64::from(first) - f64::from(second)).abs() <= EXACT * f64::from(second)
    };
    let all = || 1..=MOST_PARTS;
    let (first, second) = all().find_map(|first| {
        let second = all().find(|&second| fits(first, second))?;
        Some((first, second))
    })?;
    let times = i64::from(FEWEST_TEETH.div_ceil(first.min(second)));
    let signed = |part: u8, size: f64| {
        let teeth = times * i64::from(part);
        if size < 0.0 { -teeth } else { teeth }
    };
    Some(Ratio::Teeth(signed(first, a), signed(second, b)))
}
