//! What is drawn besides shapes, where nothing is in scope and names are as awkward as can be.
#![no_std]
#![no_implicit_prelude]
#![deny(warnings, clippy::all, clippy::pedantic)]

extern crate std;

use ::core::assert_eq;
use ::core::iter::DoubleEndedIterator;
use ::mech_runtime::overlay::Arrows;
use ::mech_runtime::{Frame, Overlay, Palette};
use ::std::option::Option::Some;
use ::std::result::Result::Ok;

::mech_runtime::mechanism! {
    /// Its links are called as what the expansion uses.
    pub struct Symbol: f32;

    link spot { point trace = (1.0, 0.5); }
    link arrows;
    link overlay { point record_traces = (4.0, 1.0); }
    joint a = revolute(ground, spot) at (0, 0);
    joint b = revolute(spot, arrows) at (1, 0.5);
    joint c = revolute(arrows, overlay) at (4, 0);
    joint x = prismatic(ground, overlay) at (4, 0) along (1, 0);
    motor a;
    effects { acceleration; overlay; trace spot.trace 8; trace overlay.record_traces 4 on plane 3 color 2; }
}

fn main() {
    let mut mechanism = Symbol::new();
    assert_eq!(mechanism.move_with([0.1], [1.0], [0.0]), Ok(()));
    let mut frame = Frame::<64, 48>::new();
    mechanism.draw(&mut frame);
    mechanism.draw_overlay(&mut frame, &Overlay::new().links(true).axes(true));
    mechanism.draw_velocities(&mut frame, &Arrows::new(2.0, Palette::BLUE));
    mechanism.draw_accelerations(&mut frame, &Arrows::new(2.0, Palette::RED).size(0.5));
    let newest = mechanism.spot_trace_trace().iter().next_back();
    assert_eq!(newest, Some(mechanism.spot_trace()));
    mechanism.clear_traces();
    assert_eq!(mechanism.overlay_record_traces_trace().len(), 0);
    let copy = mechanism;
    assert_eq!(copy, mechanism);
}
