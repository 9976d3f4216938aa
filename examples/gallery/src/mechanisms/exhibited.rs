//! What every mechanism of the gallery has besides being one.

use mech_runtime::Mechanism;

/// A mechanism of the gallery.
pub trait Exhibited: Mechanism {
    /// Its name in files and on the command line: `lower-case-with-hyphens`. The same in both precisions.
    const SLUG: &'static str;
    /// The Rust source that declares it, by a `mechanism!` that stands by itself.
    const SOURCE: &'static str;

    /// The values of its motors (radians, scene units) at a phase in `0.0..1.0` of its motion: the same bits on every machine. What
    /// it does between the last phase and the first again looks like what it does between others, and a little beyond it goes on so.
    fn motion(phase: Self::Scalar) -> Self::Motors;
}
