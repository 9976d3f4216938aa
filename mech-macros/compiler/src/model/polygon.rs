//! The area of a polygon that may cross itself: the places inside it by the even-odd rule, as it is painted.

type Point = [f64; 2];

/// Moments of what a polygon covers, about the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Moments {
    pub(super) area: f64,
    /// The integrals of x and y.
    pub(super) first: [f64; 2],
    /// The integral of the squared distance from the origin.
    pub(super) second: f64,
}

impl Moments {
    /// The moments inside the line through these corners and back to the first.
    pub(super) fn of(corners: &[Point]) -> Self {
        let next = corners.iter().cycle().skip(1);
        let edges: Vec<[Point; 2]> = corners
            .iter()
            .zip(next)
            .map(|(from, to)| [*from, *to])
            .filter(|[from, to]| from != to)
            .collect();
        let mut moments = Self::default();
        if is_simple(&edges) {
            for edge in &edges {
                moments.add_triangle(*edge);
            }
            if moments.area < 0.0 {
                moments = moments.negative();
            }
        } else {
            for [[left, right], [upper_left, upper_right]] in trapezoids(&edges) {
                for edge in [
                    [left, right],
                    [right, upper_right],
                    [upper_right, upper_left],
                    [upper_left, left],
                ] {
                    moments.add_triangle(edge);
                }
            }
        }
        moments
    }

    /// Adds the triangle between the origin and an edge; it counts negative if the edge goes clockwise.
    fn add_triangle(&mut self, [[ax, ay], [bx, by]]: [Point; 2]) {
        let twice = ax * by - bx * ay;
        self.area += twice / 2.0;
        self.first[0] += twice * (ax + bx) / 6.0;
        self.first[1] += twice * (ay + by) / 6.0;
        self.second += twice * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
    }

    fn negative(self) -> Self {
        Self { area: -self.area, first: self.first.map(|part| -part), second: -self.second }
    }
}

/// Whether no two edges touch except neighbours at their common corner.
fn is_simple(edges: &[[Point; 2]]) -> bool {
    let count = edges.len();
    let pairs = (0..count).flat_map(|first| (first + 1..count).map(move |second| (first, second)));
    let mut touching = pairs.filter(|&(first, second)| {
        let (a, b) = (edges[first], edges[second]);
        if second == first + 1 {
            folds_back(a, b)
        } else if first == 0 && second + 1 == count {
            folds_back(b, a)
        } else {
            touch(a, b)
        }
    });
    touching.next().is_none()
}

/// Whether an edge goes back along the one before it.
fn folds_back([a, b]: [Point; 2], [_, c]: [Point; 2]) -> bool {
    let along = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    side([a, b], c) == 0.0 && along < 0.0
}

/// Whether two edges have a point in common.
fn touch(a: [Point; 2], b: [Point; 2]) -> bool {
    let apart = |axis: usize| {
        let [[p, q], [r, s]] =
            [a, b].map(|[from, to]| [from[axis].min(to[axis]), from[axis].max(to[axis])]);
        q < r || s < p
    };
    let both_sides =
        |edge: [Point; 2], other: [Point; 2]| side(edge, other[0]) * side(edge, other[1]) <= 0.0;
    !apart(0) && !apart(1) && both_sides(a, b) && both_sides(b, a)
}

/// On which side of an edge a point lies: positive to the left.
fn side([[ax, ay], [bx, by]]: [Point; 2], [x, y]: Point) -> f64 {
    (bx - ax) * (y - ay) - (by - ay) * (x - ax)
}

/// The trapezoids inside by the even-odd rule, each by its lower and its upper side, between the heights at which edges begin,
/// end and cross.
fn trapezoids(edges: &[[Point; 2]]) -> Vec<[[Point; 2]; 2]> {
    let mut heights: Vec<f64> = edges.iter().flatten().map(|corner| corner[1]).collect();
    for (index, &edge) in edges.iter().enumerate() {
        let others = edges[index + 1..].iter();
        heights.extend(others.filter_map(|&other| crossing_height(edge, other)));
    }
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut trapezoids = Vec::new();
    for pair in heights.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        let mut sides: Vec<[f64; 2]> = edges
            .iter()
            .filter(|[from, to]| from[1].min(to[1]) <= low && high <= from[1].max(to[1]))
            .map(|edge| [low, high].map(|height| abscissa(*edge, height)))
            .collect();
        sides.sort_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
        for pair in sides.chunks_exact(2) {
            let [left, right] = [pair[0], pair[1]];
            trapezoids
                .push([[[left[0], low], [right[0], low]], [[left[1], high], [right[1], high]]]);
        }
    }
    trapezoids
}

/// The height at which two edges cross; none if they are parallel or do not meet.
fn crossing_height(a: [Point; 2], b: [Point; 2]) -> Option<f64> {
    let (from, to) = (side(b, a[0]), side(b, a[1]));
    if !touch(a, b) || from == to {
        return None;
    }
    let part = from / (from - to);
    let height = a[0][1] + part * (a[1][1] - a[0][1]);
    height.is_finite().then_some(height)
}

/// Where an edge that is not level is at a height.
fn abscissa([from, to]: [Point; 2], height: f64) -> f64 {
    let part = (height - from[1]) / (to[1] - from[1]);
    from[0] + part * (to[0] - from[0])
}

#[cfg(test)]
mod tests {
    use super::{Moments, Point};
    use proptest::prelude::*;

    fn close_outline(mut corners: Vec<Point>) -> Vec<Point> {
        corners.extend(corners.first().copied());
        corners
    }

    /// Whether a point is inside by the even-odd rule: how many edges lie to the right of it.
    fn is_inside(corners: &[Point], [x, y]: Point) -> bool {
        let crossed = corners.windows(2).filter(|pair| {
            let ([ax, ay], [bx, by]) = (pair[0], pair[1]);
            (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
        });
        crossed.count() % 2 == 1
    }

    /// The moments of many small squares.
    fn sample(corners: &[Point], count: i32) -> Moments {
        let side = 4.0 / f64::from(count);
        let mut moments = Moments::default();
        for row in 0..count {
            for column in 0..count {
                let [x, y] = [column, row].map(|n| -2.0 + (f64::from(n) + 0.5) * side);
                if is_inside(corners, [x, y]) {
                    moments.area += side * side;
                    moments.first[0] += side * side * x;
                    moments.first[1] += side * side * y;
                    moments.second += side * side * (x * x + y * y);
                }
            }
        }
        moments
    }

    fn assert_near(found: Moments, expected: Moments, tolerance: f64) -> Result<(), TestCaseError> {
        let pairs = [
            (found.area, expected.area),
            (found.first[0], expected.first[0]),
            (found.first[1], expected.first[1]),
            (found.second, expected.second),
        ];
        for (found, expected) in pairs {
            prop_assert!((found - expected).abs() < tolerance, "{found} is not {expected}");
        }
        Ok(())
    }

    #[test]
    fn a_star_counts_what_is_painted() {
        let corner = |point: u32| {
            let (sin, cos) = (f64::from(2 * point) * std::f64::consts::TAU / 5.0).sin_cos();
            [cos, sin]
        };
        let star = close_outline((0..5).map(corner).collect());
        let moments = Moments::of(&star);
        // Five points of a pentagram; the pentagon in the middle is crossed twice.
        let radius = f64::midpoint(3.0, -5.0_f64.sqrt());
        let star = 5.0 * radius * 36_f64.to_radians().sin();
        let pentagon = 2.5 * radius * radius * 72_f64.to_radians().sin();
        assert!((moments.area - (star - pentagon)).abs() < 1e-12, "{moments:?}");
    }

    #[test]
    fn what_is_gone_round_twice_is_not_painted() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let twice = close_outline([square, square].concat());
        assert_eq!(Moments::of(&twice), Moments::default());
        let bow = close_outline(vec![[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]]);
        assert_eq!(Moments::of(&bow).area, 2.0);
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]
        #[test]
        fn polygons_count_what_is_painted(corners in prop::collection::vec(prop::array::uniform2(-2.0..2.0), 3..9)) {
            let corners = close_outline(corners);
            assert_near(Moments::of(&corners), sample(&corners, 400), 0.12)?;
        }

        #[test]
        fn polygons_on_a_grid_count_what_is_painted(corners in prop::collection::vec(prop::array::uniform2(-2..3_i32), 3..12)) {
            let corners = close_outline(corners.into_iter().map(|corner| corner.map(f64::from)).collect());
            assert_near(Moments::of(&corners), sample(&corners, 400), 0.12)?;
        }
    }
}
