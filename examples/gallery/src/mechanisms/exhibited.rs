//! The trait of the mechanisms of the gallery.

use mech_runtime::Mechanism;

/// A mechanism of the gallery.
pub trait Exhibited: Mechanism {
    /// Its name in files and on the command line: `lower-case-with-hyphens`. The same in both precisions.
    const SLUG: &'static str;
    /// The name of the file that declares it.
    const FILE: &'static str;
    /// The Rust source that declares it, by a `mechanism!` that stands by itself.
    const SOURCE: &'static str;

    /// The values of its motors, in radians or scene units, at a phase in `0.0..1.0` of its motion: the same bits on every machine. The
    /// motion continues smoothly from the last phase to the first, and a little beyond.
    fn motion(phase: Self::Scalar) -> Self::Motors;
}
