//! The gallery's `GearedPiston`, in `f32`, moved and drawn.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Drawn<mech_gallery::geared_piston::single::GearedPiston>);
