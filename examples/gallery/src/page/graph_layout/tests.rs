//! Everything has its place, whatever the graph.

use super::{Area, Layout, Point, Sketch};
use crate::exhibits;
use crate::page::graph_svg;

fn areas(centers: &[Point], sizes: impl Iterator<Item = Point>) -> Vec<Area> {
    let areas = centers.iter().zip(sizes);
    areas.map(|(&center, size)| Area { center, size }).collect()
}

fn inside(point: Point, layout: &Layout) -> bool {
    let (low, size) = layout.view;
    (0..2).all(|axis| point[axis] >= low[axis] && point[axis] <= low[axis] + size[axis])
}

fn corners(area: Area) -> impl Iterator<Item = Point> {
    let [[x, y], [w, h]] = [area.center, area.size];
    [(-0.5, -0.5), (0.5, 0.5)].into_iter().map(move |(right, down)| [x + right * w, y + down * h])
}

/// No two vertices meet, no label lies on a vertex or on another label, all is seen; the layout, for more.
fn tidy(sketch: &Sketch) -> Layout {
    let layout = Layout::new(sketch);
    let vertices = areas(&layout.centers, sketch.boxes.iter().copied());
    let labels = areas(&layout.labels, sketch.edges.iter().map(|edge| edge.2));
    assert_eq!(vertices.len(), sketch.boxes.len());
    assert_eq!(labels.len(), sketch.edges.len());
    let all: Vec<Area> = vertices.into_iter().chain(labels).collect();
    for (index, area) in all.iter().enumerate() {
        assert!(corners(*area).all(|corner| inside(corner, &layout)));
        let met = all[..index].iter().position(|other| other.meets(*area, 0.0));
        assert_eq!(met, None, "with number {index}");
    }
    for curve in &layout.curves {
        assert!(super::samples(*curve).all(|point| inside(point, &layout)));
    }
    layout
}

/// Vertices of this row each, joined like this.
fn sketch(rows: &[usize], edges: &[(usize, usize)]) -> Sketch {
    Sketch {
        boxes: vec![[60.0, 30.0]; rows.len()],
        rows: rows.to_vec(),
        edges: edges.iter().map(|&(a, b)| (a, b, [20.0, 17.0])).collect(),
        upwards: true,
        has_arrows: false,
    }
}

#[test]
fn the_gallery_is_tidy() {
    for exhibit in exhibits() {
        let graphs = exhibit.graphs().expect("its source declares it");
        let graphs = [graphs.links, graphs.loops];
        for graph in graphs.iter().filter(|graph| graph_svg::is_readable(graph)) {
            tidy(&graph_svg::sketch(graph));
        }
    }
}

#[test]
fn parallel_edges_part() {
    let layout = tidy(&sketch(&[0, 1], &[(0, 1), (1, 0), (0, 1)]));
    let middle = |curve| super::at(curve, 0.5)[0];
    let mut middles: Vec<f64> = layout.curves.iter().map(|&curve| middle(curve)).collect();
    middles.sort_by(f64::total_cmp);
    assert!(middles.windows(2).all(|two| two[1] - two[0] > 20.0));
}

#[test]
fn edges_go_round_vertices() {
    // Of three in a row, each is joined to both others; and one leads past a row.
    let sketch = sketch(&[0, 1, 1, 1, 2], &[(1, 2), (2, 3), (1, 3), (0, 2), (0, 4)]);
    let layout = tidy(&sketch);
    for (&(from, to, _), &curve) in sketch.edges.iter().zip(&layout.curves) {
        for (vertex, &center) in layout.centers.iter().enumerate() {
            let area = Area { center, size: sketch.boxes[vertex] };
            let hit = super::samples(curve).any(|point| area.holds(point, 0.0));
            assert!(!hit || vertex == from || vertex == to);
        }
    }
}

#[test]
fn crossings_are_undone() {
    let layout = tidy(&sketch(&[0, 0, 0, 1, 1, 1], &[(0, 5), (1, 4), (2, 3)]));
    let x = |vertex: usize| layout.centers[vertex][0];
    for (a, b) in [(0, 5), (1, 4), (2, 3)] {
        assert!((x(a) - x(b)).abs() < 1e-9);
    }
}

#[test]
fn the_same_every_time() {
    let sketch = sketch(&[0, 1, 1, 2, 2], &[(0, 1), (0, 2), (1, 4), (2, 3), (1, 2)]);
    let [one, other] = [Layout::new(&sketch), Layout::new(&sketch)];
    assert_eq!((one.centers, one.curves), (other.centers, other.curves));
    assert_eq!(one.labels, other.labels);
}

#[test]
fn small_graphs() {
    tidy(&sketch(&[], &[]));
    tidy(&sketch(&[3], &[]));
    tidy(&sketch(&[0, 7], &[(0, 1)]));
}
