//! The four-bar linkage as a textbook draws it: the diagram, the path of its coupler point, velocities.

use crate::velocities::CouplerCurve;
use crate::{Diagram, Exhibit, Scene, Showcase};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Mechanism, Overlay, Palette};

/// The trace is that of one turn: after it, every new place is one that it was at before.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Diagram::<CouplerCurve> {
        showcase: Showcase {
            title: "Four-bar linkage, with velocities",
            caption: "What a textbook draws: fixed pivots on hatched stands, links as bars, an arrow \
                      for the motor, the path of the coupler’s tracer point, and the velocities \
                      at a constant rate of the crank. The path is a ring of 720 places in the \
                      struct that every move adds to; the velocities come from the linear system \
                      of the loop, exactly.",
            still: 0.85,
            ..Showcase::untitled()
        },
        move_to: |mechanism, motors| mechanism.move_with(motors, [1.0], [0.0]),
        paint,
    })
}

fn paint(mechanism: &CouplerCurve, scene: &mut Scene) {
    Mechanism::draw(mechanism, scene);
    mechanism.draw_overlay(scene, &Overlay::new().links(true).size(1.4));
    mechanism.draw_velocities(scene, &Arrows::new(1.2, Palette::BLUE).size(1.3));
}
