//! The mechanism of the paper's first figure as a diagram, without any shape.

use crate::{Diagram, Exhibit, Layer, Layers, Scene, Showcase, all_effects};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Overlay, Palette, mechanism};
use std::f64::consts::TAU;

mechanism! {
    /// A piston driven through a pair of gears, with everything that its diagram needs.
    pub struct PistonDiagram;

    ground {
        point pinion_shaft = (-3, 0);
        point wheel_shaft = (0, 0);
        line bore = (0, 0) -> (1, 0);
    }
    link pinion { point shaft = (0, 0); }
    link wheel { point shaft = (0, 0); point pin = (1, 0); }
    link rod { point big_end = (0, 0); point small_end = (4, 0); }
    link piston { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }

    joint d = revolute(ground.pinion_shaft, pinion.shaft);
    joint e = revolute(ground.wheel_shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);

    motor d;
    start { rod near 0 deg; }
    effects { acceleration; overlay; }
}

const LAYERS: Layers = Layers::of(&[
    Layer::Joints,
    Layer::Links,
    Layer::Axes,
    Layer::Motors,
    Layer::Velocities,
    Layer::Accelerations,
]);

/// Two turns of the pinion are one of the wheel.
#[must_use]
pub fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Diagram::<PistonDiagram> {
        showcase: Showcase {
            slug: "geared-piston-diagram",
            title: "Piston driven through gears, as a diagram",
            caption: "The same mechanism without a single shape: `effects { overlay; }` draws pitch \
                      circles with ticks by which they are seen to turn, fixed pivots, the block on \
                      its rail, the motor; blue arrows are velocities, red ones accelerations. \
                      Symbols and lines keep their size in pixels, however large the scene is seen.",
            source: include_str!("diagram.rs"),
            motion: |phase| [phase * 2.0 * TAU],
            frames: 144,
            still: 0.08,
            effects: Some(all_effects!(PistonDiagram)),
        },
        move_to: |mechanism, motors| mechanism.move_with(motors, [2.0], [0.0]),
        paint,
        layers: LAYERS,
    })
}

fn paint(mechanism: &PistonDiagram, scene: &mut Scene) {
    let overlay = Overlay::new().links(true).axes(true).size(1.4);
    mechanism.draw_overlay(scene, &overlay);
    mechanism.draw_accelerations(scene, &Arrows::new(0.6, Palette::RED).size(1.3));
    mechanism.draw_velocities(scene, &Arrows::new(1.0, Palette::BLUE).size(1.3));
}
