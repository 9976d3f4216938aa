//! The four-bar linkage as a textbook draws it: the diagram, the path of its coupler point, velocities.

use crate::{Diagram, Exhibit, FRAMES, Layer, Layers, Scene, Showcase, all_effects};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Mechanism, Overlay, Palette, mechanism};
use std::f64::consts::TAU;

mechanism! {
    /// A crank-rocker, with the path and the velocities of its points.
    pub struct CouplerCurve;

    const PALE_ORANGE = 93; // `Palette::shade(Palette::ORANGE, 13)`
    const RED = 5; // `Palette::RED`

    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler {
        point crank_pin = (0, 0);
        point rocker_pin = (3.5, 0);
        point tracer = (1.5, 1.75);
        polygon [(0, 0), (3.5, 0), (1.5, 1.75)] on plane 1 color PALE_ORANGE;
    }
    link rocker { point shaft = (0, 0); point pin = (3, 0); }

    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);

    motor a;
    start { coupler near 50 deg; }
    effects { acceleration; overlay; trace coupler.tracer 720 color RED; }
}

const LAYERS: Layers = Layers::of(&[
    Layer::Shapes,
    Layer::Joints,
    Layer::Links,
    Layer::Motors,
    Layer::Velocities,
]);

/// The trace is that of one turn: after it, every new place is one that it was at before.
#[must_use]
pub fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Diagram::<CouplerCurve> {
        showcase: Showcase {
            slug: "four-bar-velocities",
            title: "Four-bar linkage, with velocities",
            caption: "What a textbook draws: fixed pivots on hatched stands, links as bars, an arrow \
                      for the motor, the path of the coupler’s tracer point, and the velocities \
                      at a constant rate of the crank. The path is a ring of 720 places in the \
                      struct that every move adds to; the velocities come from the linear system \
                      of the loop, exactly.",
            source: include_str!("velocities.rs"),
            motion: |phase| [phase * TAU],
            frames: FRAMES,
            still: 0.85,
            effects: Some(all_effects!(CouplerCurve)),
        },
        move_to: |mechanism, motors| mechanism.move_with(motors, [1.0], [0.0]),
        paint,
        layers: LAYERS,
    })
}

fn paint(mechanism: &CouplerCurve, scene: &mut Scene) {
    Mechanism::draw(mechanism, scene);
    mechanism.draw_overlay(scene, &Overlay::new().links(true).size(1.4));
    mechanism.draw_velocities(scene, &Arrows::new(1.2, Palette::BLUE).size(1.3));
}
