//! A plotter of two arms whose motors follow its pen, in both precisions: that of `examples/plotter.rs`.

use mech_runtime::{Real, mechanism};

/// A mechanism whose point is led.
pub trait Led {
    /// A place.
    type Place: Copy;

    /// As it is at the start.
    fn new() -> Self;
    /// The place at a phase in `0.0..1.0` of its motion: a circle.
    fn place(phase: f32) -> Self::Place;
    /// Leads the point there. Whether it could.
    fn lead(&mut self, place: Self::Place) -> bool;
}

macro_rules! plotters {
    ($($visibility:vis $name:ident: $scalar:ident)*) => {
        $(
            mechanism! {
                /// A plotter.
                $visibility struct $name: $scalar;
                link left; link right; link rod;
                link pen { point tip = (0, 4); }
                joint l = revolute(ground, left) at (-1, 0);
                joint r = revolute(ground, right) at (1, 0);
                joint lk = revolute(left, pen) at (-2.4, 1.8);
                joint rk = revolute(right, rod) at (2.4, 1.8);
                joint tip = revolute(pen, rod) at (0, 4);
                motor l;
                motor r;
                follow pen.tip by l, r;
            }

            impl Led for $name {
                type Place = [$scalar; 2];

                fn new() -> Self {
                    Self::new()
                }

                fn place(phase: f32) -> Self::Place {
                    let (sin, cos) = (phase * f32::TURN).sin_cos();
                    [0.6 * cos, 3.4 + 0.4 * sin].map(<$scalar>::from)
                }

                fn lead(&mut self, place: Self::Place) -> bool {
                    self.reach(place).is_ok()
                }
            }
        )*
    };
}

plotters! {
    pub Single: f32
    pub Double: f64
}
