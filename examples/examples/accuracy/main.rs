//! Stub.
use plotters as _;
fn main() {}
