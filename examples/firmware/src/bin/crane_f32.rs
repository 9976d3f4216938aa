//! The gallery's `LuffingCrane`, in `f32`, moved and drawn.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Drawn<mech_gallery::crane::single::LuffingCrane>);
