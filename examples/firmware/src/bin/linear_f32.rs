//! The four-bar by `method linear`, in `f32`.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Moved<mech_probes::four_bar::LinearSingle>);
