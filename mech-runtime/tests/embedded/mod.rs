//! Tests of the bridge to embedded-graphics: see the documentation of `raster::embedded`.

mod drawn_on;
mod heap;
mod painted;
mod panel;
mod sent;
mod shown;
mod wrong;
