//! The mechanism of the paper's first figure as a diagram, without any shape.

use crate::diagram::PistonDiagram;
use crate::{Diagram, Exhibit, Scene, Showcase};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Overlay, Palette};

/// Two turns of the pinion are one of the wheel.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Diagram::<PistonDiagram> {
        showcase: Showcase {
            title: "Piston driven through gears, as a diagram",
            caption: "The same mechanism without a single shape: `effects { overlay; }` draws pitch \
                      circles with ticks by which they are seen to turn, fixed pivots, the block on \
                      its rail, the motor; blue arrows are velocities, red ones accelerations. \
                      Symbols and lines keep their size in pixels, however large the scene is seen.",
            frames: 144,
            still: 0.08,
            ..Showcase::untitled()
        },
        move_to: |mechanism, motors| mechanism.move_with(motors, [2.0], [0.0]),
        paint,
    })
}

fn paint(mechanism: &PistonDiagram, scene: &mut Scene) {
    let overlay = Overlay::new().links(true).axes(true).size(1.4);
    mechanism.draw_overlay(scene, &overlay);
    mechanism.draw_accelerations(scene, &Arrows::new(0.6, Palette::RED).size(1.3));
    mechanism.draw_velocities(scene, &Arrows::new(1.0, Palette::BLUE).size(1.3));
}
