//! Sizes and differences.

use mech_compiler::model::{LinkId, Model};
use mech_runtime::{Pose, Real};

/// Poses as the interpreter has them: cosine, sine, x and y.
#[must_use]
pub fn in_f64<T: Real>(poses: &[Pose<T>]) -> Vec<[f64; 4]> {
    let numbers = |pose: &Pose<T>| [pose.cos, pose.sin, pose.x, pose.y].map(Real::to_f64);
    poses.iter().map(numbers).collect()
}

/// The greatest difference of any number of two rows of poses.
#[must_use]
pub fn apart(a: &[[f64; 4]], b: &[[f64; 4]]) -> f64 {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// How far from the origin the farthest link is.
#[must_use]
pub fn reach(poses: &[[f64; 4]]) -> f64 {
    let far = poses.iter().map(|[_, _, x, y]| x.hypot(*y));
    far.fold(0.0, f64::max)
}

/// How long each link is: the greatest distance between two of its axes.
pub fn lengths(model: &Model) -> impl Iterator<Item = f64> + '_ {
    model.link_ids().map(|link: LinkId| {
        let own = || model.axes.iter().filter(move |axis| axis.link == link);
        let pairs = own().flat_map(|a| own().map(move |b| [a.at[0] - b.at[0], a.at[1] - b.at[1]]));
        pairs.map(|[x, y]| x.hypot(y)).fold(0.0, f64::max)
    })
}

/// First and second differences of fourth order.
#[must_use]
pub fn differences([a, b, c, d, e]: [f64; 5], step: f64) -> [f64; 2] {
    [
        (a - 8.0 * b + 8.0 * d - e) / (12.0 * step),
        (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * step * step),
    ]
}

/// The product of vectors that is their lengths' where they are parallel.
#[must_use]
pub fn dot([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * c + b * d
}

/// The product of vectors that is zero where they are parallel.
#[must_use]
pub fn cross([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}

/// The bottom of the valley of an energy in which an angle is, found in steps of a ten-thousandth as long as they lead down.
pub fn valley(energy: impl Fn(f64) -> f64, start: f64) -> f64 {
    let step = if energy(start + 1e-6) < energy(start) { 1e-4 } else { -1e-4 };
    let mut here = start;
    while energy(here + step) < energy(here) {
        here += step;
    }
    here
}
