//! SVG, drawn by somebody else: it shows what the rasteriser shows, at any time.

mod moving;
mod player;
mod scenes;
mod still;

use mech_runtime::files::Svg;
use resvg::tiny_skia::{PathSegment, Point};
use resvg::usvg::{Group, Node, Options, Paint, Tree};

/// What is seen of something: how it is painted, its width, and its points in the picture.
type Seen = (String, f32, Vec<Point>);

/// What another renderer would paint of an SVG, from back to front.
fn seen(svg: &str) -> Vec<Seen> {
    fn collect(group: &Group, all: &mut Vec<Seen>) {
        for node in group.children() {
            match node {
                Node::Group(group) => collect(group, all),
                Node::Path(path) => {
                    let color = |paint: &Paint| match paint {
                        Paint::Color(color) => format!("{color:?}"),
                        other => panic!("no colour: {other:?}"),
                    };
                    let fill = path.fill().map(|fill| (fill.rule(), color(fill.paint())));
                    let stroke = path.stroke().map(|stroke| color(stroke.paint()));
                    let width = path.stroke().map_or(0.0, |stroke| stroke.width().get());
                    let mut points = Vec::new();
                    for segment in path.data().segments() {
                        match segment {
                            PathSegment::MoveTo(to) | PathSegment::LineTo(to) => points.push(to),
                            PathSegment::QuadTo(one, to) => points.extend([one, to]),
                            PathSegment::CubicTo(one, other, to) => points.extend([one, other, to]),
                            PathSegment::Close => {}
                        }
                    }
                    path.abs_transform().map_points(&mut points);
                    all.push((format!("{fill:?} {stroke:?}"), width, points));
                }
                other => panic!("no path: {other:?}"),
            }
        }
    }
    let tree = Tree::from_str(svg, &Options::default()).expect("an SVG");
    let mut all = Vec::new();
    collect(tree.root(), &mut all);
    all
}

/// How far what a film shows at a phase is from where a still picture has it, in pixels. Both have the same things in the same order.
#[track_caller]
fn distance(film: &str, phase: f64, wanted: Svg) -> f32 {
    let (found, wanted) = (seen(&player::still(film, phase)), seen(&wanted.finish()));
    let names = |all: &[Seen]| all.iter().map(|(name, ..)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&found), names(&wanted), "at {phase}");
    let mut worst = 0.0_f32;
    for ((_, width, points), (_, other_width, others)) in found.iter().zip(&wanted) {
        assert_eq!(points.len(), others.len(), "at {phase}");
        let distances =
            points.iter().zip(others).map(|(&found, &wanted)| (found - wanted).length());
        worst = distances.fold(worst.max((width - other_width).abs()), f32::max);
    }
    worst
}
