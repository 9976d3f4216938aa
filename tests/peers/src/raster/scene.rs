//! Hexagons and circles, everywhere the same.

use mech_runtime::{Canvas, Outline, Pose};

/// Pixels of a side.
pub const SIDE: u16 = 512;

/// A hexagon or a circle.
#[derive(Clone, Copy)]
pub enum Shape {
    Hexagon([[f64; 2]; 6]),
    Circle([f64; 2], f64),
}

/// Twenty hexagons and ten circles that together cover so many screens.
#[must_use]
pub fn scene(screens: f64) -> Vec<(Shape, u8)> {
    let side = f64::from(SIDE);
    let area = screens * side * side / 30.0;
    let (hexagon, circle) =
        ((area / (1.5 * 3.0_f64.sqrt())).sqrt(), (area / std::f64::consts::PI).sqrt());
    // Places that look random, and are the same in every run.
    let place = |number: f64, factor: f64, reach: f64| {
        reach + (side - 2.0 * reach) * (number * factor).fract()
    };
    (0..30_u8)
        .map(|number| {
            let n = f64::from(number) + 0.5;
            let reach = hexagon.max(circle) + 1.0;
            let center = [place(n, 0.754_877_666, reach), place(n, 0.569_840_291, reach)];
            let shape = if number % 3 == 2 {
                Shape::Circle(center, circle)
            } else {
                Shape::Hexagon(std::array::from_fn(|corner| {
                    let angle = n + corner as f64 * std::f64::consts::FRAC_PI_3;
                    [center[0] + hexagon * angle.cos(), center[1] + hexagon * angle.sin()]
                }))
            };
            (shape, 2 + number % 12)
        })
        .collect()
}

/// Paints it with our own canvases.
pub fn paint(scene: &[(Shape, u8)], canvas: &mut impl Canvas<f64>) {
    let half = f64::from(SIDE) / 2.0;
    let pose = Pose { cos: 1.0, sin: 0.0, x: -half, y: -half };
    for (shape, color) in scene {
        let outline = match shape {
            Shape::Hexagon(corners) => Outline::Polygon(corners),
            Shape::Circle(center, radius) => Outline::Circle { center: *center, radius: *radius },
        };
        canvas.fill(outline, pose, *color);
    }
}
