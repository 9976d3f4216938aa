//! The gallery's `PistonDiagram`, in `f32`, moved: it has no shapes to be drawn.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Moved<mech_gallery::diagram::single::PistonDiagram>);
