//! Places for the vertices, edges and labels of a small graph: the vertices in rows, the edges as gentle curves from centre to centre.
//! The same graph always looks the same.

/// Right and down, in pixels.
pub(crate) type Point = [f64; 2];

/// Free space between the vertices of a row, between rows, and around all.
const GAP: f64 = 36.0;
const ROW_GAP: f64 = 64.0;
const MARGIN: f64 = 14.0;
/// The distance between the control points of two edges that join the same vertices.
const APART: f64 = 56.0;
/// The steps in which a curve is sampled.
const SAMPLES: usize = 32;

/// A graph without its names.
pub(crate) struct Sketch {
    /// The vertices: their sizes.
    pub(crate) boxes: Vec<Point>,
    /// The row of each vertex.
    pub(crate) rows: Vec<usize>,
    /// The edges: from, to, and the size of the label.
    pub(crate) edges: Vec<(usize, usize, Point)>,
    /// Whether the first row is the lowest.
    pub(crate) upwards: bool,
    /// Whether edges end before their last vertex, so that the head of an arrow is seen.
    pub(crate) has_arrows: bool,
}

/// The places.
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
    /// Whether the distance between the two is less than this.
    pub(crate) fn meets(self, other: Self, space: f64) -> bool {
        [0, 1].into_iter().all(|axis| {
            let reach = f64::midpoint(self.size[axis], other.size[axis]) + space;
            (self.center[axis] - other.center[axis]).abs() < reach
        })
    }

    /// Whether the distance to a point is less than this.
    fn holds(self, center: Point, space: f64) -> bool {
        let size = [0.0; 2];
        self.meets(Self { center, size }, space)
    }
}

impl Layout {
    /// Lays a graph out.
    pub(crate) fn new(sketch: &Sketch) -> Self {
        let centers = sketch.arrange();
        let boxes = centers.iter().zip(&sketch.boxes);
        let vertices: Vec<_> = boxes.map(|(&center, &size)| Area { center, size }).collect();
        let curves = (0..sketch.edges.len()).map(|edge| sketch.route(&vertices, edge));
        let curves: Vec<_> = curves.collect();
        let labels = sketch.place_labels(&vertices, &curves);
        let view = view(vertices.iter().chain(&labels), &curves);
        Self { centers, curves, labels: labels.iter().map(|label| label.center).collect(), view }
    }
}

#[expect(clippy::cast_precision_loss, reason = "a few dozen")]
fn number(count: usize) -> f64 {
    count as f64
}

impl Sketch {
    /// The centres of the vertices, in the best of a few orders that are improved as far as possible.
    fn arrange(&self) -> Vec<Point> {
        let last = self.rows.iter().max().map_or(0, |last| last + 1);
        let orders = (0..12).map(|start| {
            let row = |row| {
                let in_row = |vertex: &usize| self.rows[*vertex] == row;
                let mut vertices: Vec<_> = (0..self.boxes.len()).filter(in_row).collect();
                let turn = (start * (row + 1)) % vertices.len().max(1);
                vertices.rotate_left(turn);
                vertices
            };
            let mut rows: Vec<Vec<usize>> = (0..last).map(row).collect();
            rows.retain(|row| !row.is_empty());
            // Of orders that differ by rounding, the first is the best.
            ((self.improve(&mut rows) * 1e6).round(), rows)
        });
        let best = orders.min_by(|(a, _), (b, _)| a.total_cmp(b));
        best.map_or(Vec::new(), |(_, rows)| self.spread(&rows))
    }

    /// Exchanges two vertices of a row, as long as that makes the order better. Returns the cost of the order.
    fn improve(&self, rows: &mut [Vec<usize>]) -> f64 {
        let mut best = self.tangle(&self.spread(rows));
        loop {
            let before = best;
            for row in 0..rows.len() {
                for right in 1..rows[row].len() {
                    for left in 0..right {
                        rows[row].swap(left, right);
                        let now = self.tangle(&self.spread(rows));
                        if now < best - 1e-9 {
                            best = now;
                        } else {
                            rows[row].swap(left, right);
                        }
                    }
                }
            }
            if best == before {
                return best;
            }
        }
    }

    /// The centres of the vertices in this order. Labels of edges within a row fit between its vertices.
    fn spread(&self, rows: &[Vec<usize>]) -> Vec<Point> {
        let mut centers = vec![[0.0; 2]; self.boxes.len()];
        let mut y = 0.0;
        for row in rows {
            let inside = |(from, to, _): &&(_, _, Point)| row.contains(from) && row.contains(to);
            let labels = self.edges.iter().filter(inside);
            let gap = labels.map(|edge| edge.2[0] + 24.0).fold(GAP, f64::max);
            let sizes = row.iter().map(|&vertex| self.boxes[vertex]);
            let width: f64 = sizes.clone().map(|size| size[0] + gap).sum();
            let height = sizes.map(|size| size[1]).fold(0.0, f64::max);
            let down = y + height / 2.0;
            let mut x = (gap - width) / 2.0;
            for &vertex in row {
                let wide = self.boxes[vertex][0];
                let down = if self.upwards { -down } else { down };
                centers[vertex] = [x + wide / 2.0, down];
                x += wide + gap;
            }
            y += height + ROW_GAP;
        }
        centers
    }

    /// How bad an order is: crossings first, then edges that pass over vertices of their row, then length.
    fn tangle(&self, centers: &[Point]) -> f64 {
        let mut cost = 0.0;
        for (index, &(a, b, _)) in self.edges.iter().enumerate() {
            let [p, q] = [centers[a], centers[b]];
            let passes = |r: &&Point| {
                p[1] == q[1] && r[1] == p[1] && r[0] > p[0].min(q[0]) && r[0] < p[0].max(q[0])
            };
            let crosses = |&&(c, d, _): &&(usize, usize, _)| {
                [c, d].iter().all(|end| *end != a && *end != b)
                    && cross([p, q], [centers[c], centers[d]])
            };
            cost += 0.8 * number(centers.iter().filter(passes).count())
                + number(self.edges[..index].iter().filter(crosses).count())
                + (p[0] - q[0]).abs() / 1000.0;
        }
        cost
    }

    /// The curve of an edge: as straight as possible, without passing over other vertices. Edges between the same vertices fan out.
    fn route(&self, vertices: &[Area], edge: usize) -> [Point; 3] {
        let (from, to, _) = self.edges[edge];
        let pair = |&(from, to, _): &(usize, usize, Point)| (from.min(to), from.max(to));
        let alike: Vec<_> = (0..self.edges.len())
            .filter(|&other| pair(&self.edges[other]) == pair(&self.edges[edge]))
            .collect();
        let before = alike.iter().take_while(|&&other| other < edge).count();
        let preferred = (number(before) - number(alike.len() - 1) / 2.0) * APART;
        let ends = [from.min(to), from.max(to)].map(|vertex| vertices[vertex].center);
        let others = || (0..vertices.len()).filter(|&vertex| vertex != from && vertex != to);
        let bends = (0..12).flat_map(|step| [number(step) * 24.0, number(step) * -24.0]);
        let curves = bends.map(|bend| {
            let curve = bend_line(ends, preferred + bend);
            let is_hit = |&point: &Point| others().any(|vertex| vertices[vertex].holds(point, 8.0));
            let hits = samples(curve).filter(is_hit).count();
            (number(hits) * 1000.0 + bend.abs(), curve)
        });
        let best = curves.min_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut curve = best.map_or([[0.0; 2]; 3], |(_, curve)| curve);
        if from > to {
            curve.reverse();
        }
        if self.has_arrows {
            let is_free = |point: &Point| !vertices[to].holds(*point, 2.0);
            let tip = (0..=256).map(|step| at(curve, 1.0 - f64::from(step) / 256.0)).find(is_free);
            curve[2] = tip.unwrap_or(curve[2]);
        }
        curve
    }

    /// The places of the labels: each on its edge, as near to the middle as vertices and other labels let it.
    fn place_labels(&self, vertices: &[Area], curves: &[[Point; 3]]) -> Vec<Area> {
        let mut labels: Vec<Area> = Vec::new();
        for (&(.., size), &curve) in self.edges.iter().zip(curves) {
            let shares = (0..=15)
                .flat_map(|step| [0.5 + f64::from(step) / 40.0, 0.5 - f64::from(step) / 40.0]);
            let mut areas = shares.map(|share| Area { center: at(curve, share), size });
            let is_free =
                |area: &Area| !vertices.iter().chain(&labels).any(|other| area.meets(*other, 2.0));
            let center = at(curve, 0.5);
            let label = areas.find(is_free).unwrap_or(Area { center, size });
            labels.push(label);
        }
        labels
    }
}

/// Whether two segments cross.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let side = |[p, q]: [Point; 2], r: Point| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    side([a, b], c) * side([a, b], d) < 0.0 && side([c, d], a) * side([c, d], b) < 0.0
}

/// A curve between two points whose control point lies this far beside their middle.
fn bend_line([a, b]: [Point; 2], bend: f64) -> [Point; 3] {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let length = dx.hypot(dy).max(1.0);
    let [x, y] = [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]));
    [a, [x - dy / length * bend, y + dx / length * bend], b]
}

/// The point of a curve at a parameter from zero to one.
fn at([a, control, b]: [Point; 3], t: f64) -> Point {
    let shares = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
    [0, 1].map(|axis| shares[0] * a[axis] + shares[1] * control[axis] + shares[2] * b[axis])
}

fn samples(curve: [Point; 3]) -> impl Iterator<Item = Point> {
    (0..=SAMPLES).map(move |sample| at(curve, number(sample) / number(SAMPLES)))
}

/// The upper left corner and the size of what holds everything.
fn view<'a>(areas: impl Iterator<Item = &'a Area>, curves: &[[Point; 3]]) -> (Point, Point) {
    let points = curves.iter().flat_map(|&curve| samples(curve));
    let points = points.map(|center| Area { center, size: [0.0; 2] });
    let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
    for Area { center, size } in areas.copied().chain(points) {
        for axis in [0, 1] {
            low[axis] = low[axis].min(center[axis] - size[axis] / 2.0 - MARGIN);
            high[axis] = high[axis].max(center[axis] + size[axis] / 2.0 + MARGIN);
        }
    }
    if low[0] > high[0] {
        return ([0.0; 2], [0.0; 2]);
    }
    (low, [high[0] - low[0], high[1] - low[1]])
}

#[cfg(test)]
mod tests;
