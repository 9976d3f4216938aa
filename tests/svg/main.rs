//! SVG, drawn by somebody else: it shows what the rasteriser shows, at any time.

mod moving;
mod player;
mod scenes;
mod still;

use mech_runtime::{Outline, Pose, Scalar, Shape, View};
use resvg::usvg::roxmltree::Node;

/// The numbers in an attribute.
fn numbers(node: &Node<'_, '_>, attribute: &str) -> Vec<f64> {
    let text = node.attribute(attribute).expect("an attribute");
    let numbers = text
        .split([' ', ','])
        .map(|number| number.parse().expect("a number"));
    numbers.collect()
}

/// The corners of an element in its own frame; of a circle, its centre and a point to the right of it.
fn points(node: &Node<'_, '_>) -> Vec<[f64; 2]> {
    match node.tag_name().name() {
        "circle" => {
            let [x, y, radius] = ["cx", "cy", "r"].map(|name| numbers(node, name)[0]);
            vec![[x, y], [x + radius, y]]
        }
        "polygon" | "polyline" => numbers(node, "points").as_chunks::<2>().0.to_vec(),
        other => panic!("an element `{other}`"),
    }
}

/// Where the same points of a shape should be, in pixels from the upper left corner of a picture.
fn expected<T: Scalar>(
    shape: &Shape<T>,
    poses: &[Pose<T>],
    view: View,
    size: [f64; 2],
) -> Vec<[f64; 2]> {
    let pose = shape
        .link
        .checked_sub(1)
        .map_or(Pose::identity(), |link| poses[link]);
    let pixel = |point: [T; 2]| {
        let [x, y] = pose.apply(point).map(mech_runtime::Real::to_f64);
        let [center_x, center_y] = view.center();
        [
            size[0] / 2.0 + (x - center_x) * view.scale(),
            size[1] / 2.0 - (y - center_y) * view.scale(),
        ]
    };
    match shape.outline {
        Outline::Circle { center, radius } => {
            vec![pixel(center), pixel([center[0] + radius, center[1]])]
        }
        Outline::Polygon(corners)
        | Outline::Line {
            points: corners, ..
        } => corners.iter().copied().map(pixel).collect(),
        // It is the stroke of its middle circle.
        Outline::Ring {
            center,
            radius,
            hole,
        } => {
            let middle = (radius + hole) * T::from_f64(0.5);
            vec![pixel(center), pixel([center[0] + middle, center[1]])]
        }
        other => panic!("no shape is declared as {other:?}"),
    }
}
