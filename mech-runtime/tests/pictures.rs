//! Tests of pictures: what is painted, on which canvas, and in which files. One program, which is linked and optimised once.

#[cfg(feature = "embedded-graphics")]
mod embedded;
#[cfg(feature = "std")]
mod files;
#[cfg(feature = "std")]
mod heap;
mod looks;
#[cfg(any(feature = "std", feature = "embedded-graphics"))]
mod outlines;
mod overlay;
mod palette;
mod raster;
mod sizes;
mod smooth;
mod stage;
mod tilings;
