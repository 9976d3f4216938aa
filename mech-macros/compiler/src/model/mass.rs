//! The distribution of mass in a link.

use super::polygon::Moments;
use super::{Figure, Shape, ShapeKind};

/// The mass of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mass {
    /// Its mass, not negative.
    pub mass: f64,
    /// Its centre of mass, in the frame of the link.
    pub center: [f64; 2],
    /// Its moment of inertia about its centre of mass, not negative.
    pub inertia: f64,
}

impl Mass {
    /// The mass of shapes of a density: mass a unit of area. Where shapes overlap, each counts.
    #[must_use]
    pub fn of_shapes(shapes: &[Shape], density: f64) -> Self {
        let parts: Vec<Self> = shapes.iter().map(|shape| Self::of_area(&shape.kind)).collect();
        let whole = Self::together(&parts);
        Self { mass: density * whole.mass, inertia: density * whole.inertia, ..whole }
    }

    /// Some masses as one.
    fn together(parts: &[Self]) -> Self {
        let area: f64 = parts.iter().map(|part| part.mass).sum();
        if area <= 0.0 {
            return Self { mass: 0.0, center: [0.0, 0.0], inertia: 0.0 };
        }
        let along = |axis: usize| {
            parts.iter().map(|part| part.mass * part.center[axis]).sum::<f64>() / area
        };
        let center = [along(0), along(1)];
        let about = |part: &Self| {
            let [x, y] = [part.center[0] - center[0], part.center[1] - center[1]];
            part.inertia + part.mass * (x * x + y * y)
        };
        let inertia: f64 = parts.iter().map(about).sum();
        Self { mass: area, center, inertia }
    }

    /// The area of a shape, as if that were its mass.
    fn of_area(kind: &ShapeKind) -> Self {
        match kind {
            ShapeKind::Circle { center, radius } => {
                let area = std::f64::consts::PI * radius * radius;
                Self { mass: area, center: *center, inertia: 0.5 * area * radius * radius }
            }
            ShapeKind::Ring { center, radius, hole } => {
                let area = std::f64::consts::PI * (radius * radius - hole * hole);
                Self {
                    mass: area,
                    center: *center,
                    inertia: 0.5 * area * (radius * radius + hole * hole),
                }
            }
            ShapeKind::Bar { pins, width } => Self::of_bar(pins, *width),
            ShapeKind::Polygon(corners) => Self::of_polygon(corners),
            ShapeKind::Figure(Figure::Gear { center, radius: Some(radius), .. }) => {
                Self::of_area(&ShapeKind::Circle { center: *center, radius: *radius })
            }
            // A drawing of what weighs nothing.
            ShapeKind::Figure(_) => Self { mass: 0.0, center: [0.0; 2], inertia: 0.0 },
        }
    }

    /// Its straight parts and its two round ends; where it bends, parts overlap on one side as much as they lack on the other.
    fn of_bar(pins: &[[f64; 2]], width: f64) -> Self {
        let half = width / 2.0;
        let mut parts = Vec::new();
        for pair in pins.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let [x, y] = [to[0] - from[0], to[1] - from[1]];
            let length = x.hypot(y);
            parts.push(Self {
                mass: length * width,
                center: [from[0] + x / 2.0, from[1] + y / 2.0],
                inertia: length * width * (length * length + width * width) / 12.0,
            });
        }
        let ends = [(0, 1), (pins.len() - 1, pins.len() - 2)];
        for (end, next) in ends {
            let ([x, y], [u, v]) = (pins[end], pins[next]);
            let length = (x - u).hypot(y - v);
            let area = std::f64::consts::PI * half * half / 2.0;
            // The centre of a half disc lies so far from its straight side.
            let ahead = 4.0 * half / (3.0 * std::f64::consts::PI);
            let along =
                if length > 0.0 { [(x - u) / length, (y - v) / length] } else { [1.0, 0.0] };
            parts.push(Self {
                mass: area,
                center: [x + ahead * along[0], y + ahead * along[1]],
                inertia: area * (half * half / 2.0 - ahead * ahead),
            });
        }
        Self::together(&parts)
    }

    /// Returns the mass of the painted area, measured from its first corner: so an area far from the origin is as exact as a near one.
    fn of_polygon(corners: &[[f64; 2]]) -> Self {
        // An area without corners has no mass, wherever it is.
        let [x0, y0] = corners.first().copied().unwrap_or([0.0, 0.0]);
        let near: Vec<[f64; 2]> = corners.iter().map(|[x, y]| [x - x0, y - y0]).collect();
        let Moments { area, first: [x, y], second } = Moments::of(&near);
        if area == 0.0 {
            return Self { mass: 0.0, center: [x0, y0], inertia: 0.0 };
        }
        let (cx, cy) = (x / area, y / area);
        Self {
            mass: area,
            center: [x0 + cx, y0 + cy],
            inertia: (second - area * (cx * cx + cy * cy)).abs(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Mass, ShapeKind};

    /// The mass of what lies inside, by many small squares.
    fn sample(inside: impl Fn(f64, f64) -> bool) -> Mass {
        const SIDE: f64 = 0.004;
        let [mut mass, mut x, mut y, mut square] = [0.0; 4];
        for row in -750..750 {
            for column in -750..750 {
                let [u, v] = [column, row].map(|n| (f64::from(n) + 0.5) * SIDE);
                if inside(u, v) {
                    mass += SIDE * SIDE;
                    x += SIDE * SIDE * u;
                    y += SIDE * SIDE * v;
                    square += SIDE * SIDE * (u * u + v * v);
                }
            }
        }
        let center = [x / mass, y / mass];
        let inertia = square - mass * (center[0].powi(2) + center[1].powi(2));
        Mass { mass, center, inertia }
    }

    #[track_caller]
    fn assert_near(found: Mass, expected: Mass) {
        let near = |a: f64, b: f64| (a - b).abs() < 2e-3 * (1.0 + b.abs());
        assert!(
            near(found.mass, expected.mass)
                && near(found.center[0], expected.center[0])
                && near(found.center[1], expected.center[1])
                && near(found.inertia, expected.inertia),
            "{found:?} is not {expected:?}"
        );
    }

    #[test]
    fn a_straight_bar_weighs_what_it_covers() {
        let (pins, width) = (vec![[-1.0, 0.5], [1.4, -0.3]], 0.9);
        let [[x, y], [u, v]] = [pins[0], pins[1]];
        let inside = |a: f64, b: f64| {
            let offset = [u - x, v - y];
            let along =
                ((a - x) * offset[0] + (b - y) * offset[1]) / offset[0].hypot(offset[1]).powi(2);
            let along = along.clamp(0.0, 1.0);
            (a - x - along * offset[0]).hypot(b - y - along * offset[1]) <= width / 2.0
        };
        assert_near(Mass::of_area(&ShapeKind::Bar { pins: pins.clone(), width }), sample(inside));
    }

    #[test]
    fn a_ring_weighs_what_it_covers() {
        let (center, radius, hole) = ([0.3, -0.4], 1.5, 0.7);
        let inside =
            |a: f64, b: f64| (hole..=radius).contains(&(a - center[0]).hypot(b - center[1]));
        let ring = ShapeKind::Ring { center, radius, hole };
        assert_near(Mass::of_area(&ring), sample(inside));
    }
}
