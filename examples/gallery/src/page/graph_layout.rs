//! Where the vertices and edges of a small graph are drawn: the vertices in rows, the edges as gentle curves between them,
//! each with its label where there is room for it. Nothing is left to chance: the same graph always looks the same.

/// Right and down, in pixels.
pub(crate) type Point = [f64; 2];

/// Free space between the vertices of a row, between rows, and around all.
const GAP: f64 = 36.0;
const ROW_GAP: f64 = 64.0;
const MARGIN: f64 = 14.0;
/// How far apart two edges between the same vertices are, as control points go.
const APART: f64 = 56.0;
/// How far under its first vertex an edge begins, so that round corners leave no gap.
pub(crate) const UNDER: f64 = 8.0;
/// What a curve is sampled at.
const SAMPLES: usize = 32;

/// What is to be laid out.
pub(crate) struct Sketch {
    /// The vertices: their sizes.
    pub(crate) boxes: Vec<Point>,
    /// The row of each vertex.
    pub(crate) rows: Vec<usize>,
    /// The edges: from, to, and the size of the label.
    pub(crate) edges: Vec<(usize, usize, Point)>,
    /// Whether the first row is the lowest.
    pub(crate) upwards: bool,
    /// How far from its last vertex an edge ends: below zero, it ends under it.
    pub(crate) space: f64,
}

/// Where everything is.
pub(crate) struct Layout {
    /// The centres of the vertices.
    pub(crate) centers: Vec<Point>,
    /// The edges, as Bézier curves with one control point.
    pub(crate) curves: Vec<[Point; 3]>,
    /// The centres of their labels.
    pub(crate) labels: Vec<Point>,
    /// The upper left corner of all, and its size.
    pub(crate) view: (Point, Point),
}

/// A rectangle.
#[derive(Clone, Copy)]
pub(crate) struct Area {
    pub(crate) center: Point,
    pub(crate) size: Point,
}

impl Area {
    /// Whether the two have a point in common when there has to be some space between them.
    pub(crate) fn meets(self, other: Self, space: f64) -> bool {
        let apart = |axis: usize| {
            let reach = f64::midpoint(self.size[axis], other.size[axis]) + space;
            (self.center[axis] - other.center[axis]).abs() >= reach
        };
        !apart(0) && !apart(1)
    }

    /// Whether a point is in it or less than so far from it.
    fn holds(self, point: Point, space: f64) -> bool {
        let point = Area {
            center: point,
            size: [0.0; 2],
        };
        self.meets(point, space)
    }
}

impl Layout {
    /// Lays a graph out.
    pub(crate) fn new(sketch: &Sketch) -> Self {
        let centers = settle(sketch);
        let mut whole: Vec<[Point; 3]> = Vec::new();
        for edge in 0..sketch.edges.len() {
            whole.push(route(sketch, &centers, edge));
        }
        let curves: Vec<_> = whole
            .iter()
            .zip(&sketch.edges)
            .map(|(&curve, &(from, to, _))| {
                let ends = [from, to].map(|vertex| area(sketch, &centers, vertex));
                clipped(curve, ends, sketch.space)
            })
            .collect();
        let labels = labels(sketch, &centers, &curves);
        let view = view(sketch, &centers, &curves, &labels);
        Self {
            centers,
            curves,
            labels,
            view,
        }
    }
}

fn area(sketch: &Sketch, centers: &[Point], vertex: usize) -> Area {
    Area {
        center: centers[vertex],
        size: sketch.boxes[vertex],
    }
}

#[expect(clippy::cast_precision_loss, reason = "a few dozen")]
fn number(count: usize) -> f64 {
    count as f64
}

// ---- Vertices --------------------------------------------------------------------------------------------------------

/// The centres of the vertices: each row in its order, spread over the width. Of a few orders to begin with, each improved
/// as long as that helps, the best is taken.
fn settle(sketch: &Sketch) -> Vec<Point> {
    let orders = (0..12).map(|start| {
        let mut rows = rows(sketch);
        for (index, row) in rows.iter_mut().enumerate() {
            let turn = (start * (index + 1)) % row.len();
            row.rotate_left(turn);
        }
        let cost = improve(sketch, &mut rows);
        // Of equals the first, also if they differ by rounding.
        ((cost * 1e6).round(), rows)
    });
    let best = orders.min_by(|(a, _), (b, _)| a.total_cmp(b));
    best.map_or(Vec::new(), |(_, rows)| spread(sketch, &rows))
}

/// Exchanges two vertices of a row at a time, as long as that makes the order better. Returns how bad it still is.
fn improve(sketch: &Sketch, rows: &mut [Vec<usize>]) -> f64 {
    let mut least = tangle(sketch, &spread(sketch, rows));
    loop {
        let before = least;
        for row in 0..rows.len() {
            for right in 1..rows[row].len() {
                for left in 0..right {
                    rows[row].swap(left, right);
                    let now = tangle(sketch, &spread(sketch, rows));
                    if now < least - 1e-9 {
                        least = now;
                    } else {
                        rows[row].swap(left, right);
                    }
                }
            }
        }
        if least == before {
            return least;
        }
    }
}

/// The vertices of each row; no row is empty.
fn rows(sketch: &Sketch) -> Vec<Vec<usize>> {
    let last = sketch.rows.iter().max().map_or(0, |last| last + 1);
    let row = |row| {
        let in_row = |vertex: &usize| sketch.rows[*vertex] == row;
        (0..sketch.boxes.len()).filter(in_row).collect()
    };
    let mut rows: Vec<Vec<usize>> = (0..last).map(row).collect();
    rows.retain(|row| !row.is_empty());
    rows
}

fn spread(sketch: &Sketch, rows: &[Vec<usize>]) -> Vec<Point> {
    let mut centers = vec![[0.0; 2]; sketch.boxes.len()];
    let widths = rows.iter().map(|row| {
        let (boxes, gap) = needs(sketch, row);
        boxes + gap * number(row.len())
    });
    let width = widths.fold(0.0, f64::max);
    let mut y = 0.0;
    for row in rows {
        let (boxes, gap) = needs(sketch, row);
        // A short row need not go from edge to edge.
        let gap = ((width - boxes) / number(row.len())).min(gap * 2.5);
        let height = row
            .iter()
            .map(|&vertex| sketch.boxes[vertex][1])
            .fold(0.0, f64::max);
        let down = y + height / 2.0;
        let down = if sketch.upwards { -down } else { down };
        let mut x = -(boxes + gap * number(row.len() - 1)) / 2.0;
        for &vertex in row {
            let wide = sketch.boxes[vertex][0];
            centers[vertex] = [x + wide / 2.0, down];
            x += wide + gap;
        }
        y += height + ROW_GAP;
    }
    centers
}

/// How much room a row needs: that of its vertices in all, and that between two, for the labels of edges.
fn needs(sketch: &Sketch, row: &[usize]) -> (f64, f64) {
    let boxes = row.iter().map(|&vertex| sketch.boxes[vertex][0]).sum();
    let inside = sketch
        .edges
        .iter()
        .filter(|(from, to, _)| row.contains(from) && row.contains(to));
    let gap = inside
        .map(|(.., label)| label[0] + 24.0)
        .fold(GAP, f64::max);
    (boxes, gap)
}

/// How bad an order is: crossings first, then edges along a row that leap over others, then length, and what does not
/// stand in the order in which it was declared.
fn tangle(sketch: &Sketch, centers: &[Point]) -> f64 {
    let mut cost = number(inversions(centers)) / 500.0;
    for (index, &(a, b, _)) in sketch.edges.iter().enumerate() {
        let [p, q] = [centers[a], centers[b]];
        cost += (p[0] - q[0]).abs() / 1000.0;
        let between = |vertex: usize| {
            let x = centers[vertex][0];
            centers[vertex][1] == p[1] && x > p[0].min(q[0]) && x < p[0].max(q[0])
        };
        if p[1] == q[1] {
            let leapt = (0..centers.len()).filter(|&vertex| between(vertex));
            cost += 0.8 * number(leapt.count());
        }
        let others = sketch.edges[..index].iter();
        let crossed = others.filter(|&&(c, d, _)| {
            let ends = [c, d].iter().all(|end| *end != a && *end != b);
            ends && cross([p, q], [centers[c], centers[d]])
        });
        cost += number(crossed.count());
    }
    cost
}

/// How many pairs of vertices in one row do not stand in their order.
fn inversions(centers: &[Point]) -> usize {
    let later = |(index, center): (usize, &Point)| {
        let before = centers[..index].iter();
        let inverted = before.filter(|other| other[1] == center[1] && other[0] > center[0]);
        inverted.count()
    };
    centers.iter().enumerate().map(later).sum()
}

/// Whether two segments cross.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let side = |[p, q]: [Point; 2], r: Point| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    side([a, b], c) * side([a, b], d) < 0.0 && side([c, d], a) * side([c, d], b) < 0.0
}

// ---- Edges -----------------------------------------------------------------------------------------------------------

/// The curve of an edge, from centre to centre: as straight as possible without running over vertices or over another edge
/// between the same two.
fn route(sketch: &Sketch, centers: &[Point], edge: usize) -> [Point; 3] {
    let (from, to, _) = sketch.edges[edge];
    let others = (0..centers.len()).filter(|&vertex| vertex != from && vertex != to);
    let others: Vec<Area> = others.map(|vertex| area(sketch, centers, vertex)).collect();
    let preferred = preferred_bend(sketch, edge);
    let bends = (0..12).flat_map(|step| [number(step) * 24.0, number(step) * -24.0]);
    let curves = bends.map(|bend| {
        let curve = bent(
            centers[from.min(to)],
            centers[from.max(to)],
            preferred + bend,
        );
        let hits = samples(curve).filter(|&p| others.iter().any(|area| area.holds(p, 8.0)));
        let cost = number(hits.count()) * 1000.0 + crossings(sketch, centers, edge, curve) * 10.0;
        (cost + bend.abs(), curve)
    });
    let best = curves.min_by(|(a, _), (b, _)| a.total_cmp(b));
    let [a, control, b] = best.map_or([[0.0; 2]; 3], |(_, curve)| curve);
    if from <= to {
        [a, control, b]
    } else {
        [b, control, a]
    }
}

/// How many other edges a curve crosses, if those are straight.
fn crossings(sketch: &Sketch, centers: &[Point], edge: usize, curve: [Point; 3]) -> f64 {
    let (from, to, _) = sketch.edges[edge];
    let points: Vec<Point> = samples(curve).collect();
    let crossed = sketch.edges.iter().filter(|&&(a, b, _)| {
        let other = [centers[a], centers[b]];
        let apart = [a, b].iter().all(|end| *end != from && *end != to);
        apart
            && points
                .windows(2)
                .any(|step| cross([step[0], step[1]], other))
    });
    number(crossed.count())
}

/// Edges between the same two vertices fan out.
fn preferred_bend(sketch: &Sketch, edge: usize) -> f64 {
    let pair = |&(from, to, _): &(usize, usize, Point)| (from.min(to), from.max(to));
    let same = |other: &&(usize, usize, Point)| pair(other) == pair(&sketch.edges[edge]);
    let all = sketch.edges.iter().filter(same).count();
    let before = sketch.edges[..edge].iter().filter(same).count();
    (number(before) - number(all - 1) / 2.0) * APART
}

fn bent(a: Point, b: Point, bend: f64) -> [Point; 3] {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let length = dx.hypot(dy).max(1.0);
    let middle = [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])];
    let control = [
        middle[0] - dy / length * bend,
        middle[1] + dx / length * bend,
    ];
    [a, control, b]
}

/// The point of a curve at a parameter from zero to one.
fn at([a, control, b]: [Point; 3], t: f64) -> Point {
    [0, 1].map(|axis| {
        let (first, second) = (
            a[axis] + (control[axis] - a[axis]) * t,
            control[axis] + (b[axis] - control[axis]) * t,
        );
        first + (second - first) * t
    })
}

fn samples(curve: [Point; 3]) -> impl Iterator<Item = Point> {
    (0..=SAMPLES).map(move |sample| at(curve, number(sample) / number(SAMPLES)))
}

/// The part of a curve outside the two vertices it joins.
fn clipped(curve: [Point; 3], [first, last]: [Area; 2], space: f64) -> [Point; 3] {
    let fine = || (0..=256).map(|step| f64::from(step) / 256.0);
    let start = fine().find(|&t| !first.holds(at(curve, t), -UNDER));
    let end = fine().rev().find(|&t| !last.holds(at(curve, t), space));
    match (start, end) {
        (Some(start), Some(end)) if start < end => part(curve, start, end),
        _ => curve,
    }
}

/// The part of a curve from one parameter to another.
fn part(curve: [Point; 3], start: f64, end: f64) -> [Point; 3] {
    let [a, control, b] = curve;
    // The blossom of the curve at both parameters.
    let inner = [0, 1].map(|axis| {
        let (first, second) = (
            a[axis] + (control[axis] - a[axis]) * start,
            control[axis] + (b[axis] - control[axis]) * start,
        );
        first + (second - first) * end
    });
    [at(curve, start), inner, at(curve, end)]
}

// ---- Labels ----------------------------------------------------------------------------------------------------------

/// Each label sits on its edge, as near to the middle as the others, the vertices and the other edges let it.
fn labels(sketch: &Sketch, centers: &[Point], curves: &[[Point; 3]]) -> Vec<Point> {
    let mut placed: Vec<Area> = Vec::new();
    for (edge, &(.., size)) in sketch.edges.iter().enumerate() {
        let places = (0..=30).map(|step| {
            let aside = f64::from(step / 2) / 40.0;
            let t = 0.5 + if step % 2 == 0 { aside } else { -aside };
            let area = Area {
                center: at(curves[edge], t),
                size,
            };
            (
                crowd(sketch, centers, curves, &placed, edge, area) + aside,
                area,
            )
        });
        let best = places.min_by(|(a, _), (b, _)| a.total_cmp(b));
        placed.extend(best.map(|(_, area)| area));
    }
    placed.into_iter().map(|area| area.center).collect()
}

/// How much there is already where a label would be.
fn crowd(
    sketch: &Sketch,
    centers: &[Point],
    curves: &[[Point; 3]],
    placed: &[Area],
    edge: usize,
    label: Area,
) -> f64 {
    let mut vertices = (0..centers.len()).map(|vertex| area(sketch, centers, vertex));
    let on_vertex = vertices.any(|area| label.meets(area, 2.0));
    let on_label = placed.iter().any(|area| label.meets(*area, 2.0));
    let others = curves
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != edge);
    let on_edges = others.filter(|(_, curve)| samples(**curve).any(|p| label.holds(p, 4.0)));
    let on_vertex = f64::from(u8::from(on_vertex));
    let on_label = f64::from(u8::from(on_label));
    on_vertex * 100.0 + on_label * 100.0 + number(on_edges.count())
}

/// The upper left corner and the size of what holds everything.
fn view(
    sketch: &Sketch,
    centers: &[Point],
    curves: &[[Point; 3]],
    labels: &[Point],
) -> (Point, Point) {
    let vertices = centers
        .iter()
        .zip(&sketch.boxes)
        .map(|(&c, &size)| (c, size));
    let labels = labels
        .iter()
        .zip(&sketch.edges)
        .map(|(&c, &(.., size))| (c, size));
    let curves = curves
        .iter()
        .flat_map(|&curve| samples(curve))
        .map(|p| (p, [0.0; 2]));
    let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
    for (center, size) in vertices.chain(labels).chain(curves) {
        for axis in [0, 1] {
            low[axis] = low[axis].min(center[axis] - size[axis] / 2.0 - MARGIN);
            high[axis] = high[axis].max(center[axis] + size[axis] / 2.0 + MARGIN);
        }
    }
    if centers.is_empty() {
        return ([0.0; 2], [0.0; 2]);
    }
    (low, [high[0] - low[0], high[1] - low[1]])
}

#[cfg(test)]
mod tests;
