//! The gallery's `LuffingCrane`, in `f64`, moved and drawn.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Drawn<mech_gallery::crane::LuffingCrane>);
