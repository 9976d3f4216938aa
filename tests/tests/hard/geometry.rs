//! Plain geometry in double precision: circles and lines, with no help from the product.

/// A point of a closed dyad, and the sine of its transmission angle with the sign of its side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClosedForm {
    pub(crate) at: [f64; 2],
    pub(crate) sine: f64,
}

/// The coupler–rocker joint of a four-bar `g a b c` at a crank angle, the crank shaft at the origin and the rocker shaft at
/// (g, 0); on the left of the way from the crank pin to the rocker shaft if `left`. A discriminant below zero is zero.
pub(crate) fn four_bar([g, a, b, c]: [f64; 4], angle: f64, left: bool) -> ClosedForm {
    let pin = [a * angle.cos(), a * angle.sin()];
    let half = (angle / 2.0).sin();
    let square = (g - a).powi(2) + 4.0 * g * a * half * half;
    let distance = square.sqrt();
    let outer = (b + c - distance) * (b + c + distance);
    let inner = (distance - (b - c).abs()) * (distance + (b - c).abs());
    let root = (outer * inner).max(0.0).sqrt();
    let root = if left { root } else { -root };
    let along = (square + (b - c) * (b + c)) / (2.0 * square);
    let across = root / (2.0 * square);
    let [u, v] = [g - pin[0], -pin[1]];
    ClosedForm {
        at: [
            pin[0] + along * u - across * v,
            pin[1] + along * v + across * u,
        ],
        sine: root / (2.0 * b * c),
    }
}

/// How far the block of a slider-crank is along its guide, which lies `offset` above the shaft.
pub(crate) fn slider_crank(r: f64, l: f64, offset: f64, angle: f64) -> ClosedForm {
    let height = offset - r * angle.sin();
    let root = ((l - height) * (l + height)).max(0.0).sqrt();
    ClosedForm {
        at: [r * angle.cos() + root, offset],
        sine: root / l,
    }
}

/// A point mirrored in the line through two others.
pub(crate) fn mirrored([x, y]: [f64; 2], [a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    let (u, v) = (c - a, d - b);
    let across = 2.0 * (u * (y - b) - v * (x - a)) / (u * u + v * v);
    [x + across * v, y - across * u]
}

/// Where a function changes its sign.
pub(crate) fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rises = f(high) > 0.0;
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if (f(middle) > 0.0) == rises {
            high = middle;
        } else {
            low = middle;
        }
    }
    f64::midpoint(low, high)
}
