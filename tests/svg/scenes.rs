//! Films of random things: at each of its moments a film shows what a still picture of that moment does, in the same order.

use crate::numbers;
use crate::player::{Player, carried};
use mech_runtime::files::{AnimatedSvg, Sheet, Svg};
use mech_runtime::{Canvas, Outline, Pose, View};
use proptest::prelude::*;
use resvg::usvg::roxmltree::{Document, Node};
use std::f64::consts::TAU;
use std::time::Duration;

/// So long that everything is shown at each moment.
const PERIOD: Duration = Duration::from_secs(100);
/// How far behind its moment a film is looked at, as a part of the period.
const BEHIND: f64 = 1e-5;

/// Something that turns about a place and sways, that may change its size and may not always be there.
#[derive(Clone, Debug)]
struct Thing {
    kind: u8,
    color: u8,
    points: Vec<[f64; 2]>,
    place: [f64; 2],
    sway: f64,
    turns: i32,
    pulse: f64,
    is_in_scene: bool,
    /// When it is there: a bit for each moment.
    there: u64,
}

fn thing() -> impl Strategy<Value = Thing> {
    let corner = prop::array::uniform2(-20.0..20.0);
    let place = prop::array::uniform2(-30.0..30.0);
    let motion = (
        prop_oneof![Just(0.0), -9.0..9.0],
        prop_oneof![Just(0), -4..5_i32],
        prop_oneof![3 => Just(0.0), 1 => 0.01..0.4],
    );
    let there = prop_oneof![3 => Just(u64::MAX), 1 => any::<u64>(), 1 => (0_u32..64).prop_map(|shift| u64::MAX << shift)];
    let form = (0_u8..7, 1_u8..4, prop::collection::vec(corner, 3..6));
    (form, place, motion, any::<bool>(), there).prop_map(
        |((kind, color, points), place, (sway, turns, pulse), is_in_scene, there)| Thing {
            kind,
            color,
            points,
            place,
            sway,
            turns,
            pulse,
            is_in_scene,
            there,
        },
    )
}

impl Thing {
    fn draw(&self, canvas: &mut impl Canvas<f64>, moment: u32, moments: u32) {
        if self.there >> moment & 1 == 0 {
            return;
        }
        let phase = TAU * f64::from(moment) / f64::from(moments);
        let (sin, cos) = (f64::from(self.turns) * phase).sin_cos();
        let [x, y] = [self.place[0] + self.sway * phase.cos(), self.place[1]];
        let turned = Pose { cos, sin, x, y };
        let size = 1.0 + self.pulse * phase.sin();
        let [pose, to_scene] = if self.is_in_scene {
            [Pose::identity(), turned]
        } else {
            [turned, Pose::identity()]
        };
        let point = |[x, y]: [f64; 2]| to_scene.apply([size * x, size * y]);
        let points: Vec<_> = self.points.iter().copied().map(point).collect();
        // A straight line that grows could as well be a trace.
        let steps = (0..).zip(&self.points).map(|(step, [x, y])| {
            [
                12.0 * f64::from(step) + x / 4.0,
                f64::from(step % 2) * 12.0 + y / 4.0,
            ]
        });
        let zigzag: Vec<_> = steps.map(point).collect();
        let outline = match self.kind {
            0 => Outline::Circle {
                center: points[0],
                radius: 5.0 * size,
            },
            1 => Outline::Ring {
                center: points[0],
                radius: 5.0 * size,
                hole: 3.0,
            },
            2 => Outline::Polygon(&points),
            3 => Outline::Winding(&points),
            4 => Outline::Line {
                points: &zigzag,
                width: 1.5,
            },
            5 => Outline::Arc {
                center: points[0],
                start: points[1],
                angle: self.points[2][0] / 4.0,
                width: 1.0,
            },
            _ => return canvas.text(turned.apply(self.points[0]), "text", self.color),
        };
        canvas.fill(outline, pose, self.color);
    }
}

/// What can be said of an element in words, where its points are in the picture, and its lengths.
type Element = (Vec<String>, Vec<[f64; 2]>, Vec<f64>);

fn element(node: &Node<'_, '_>, transform: [f64; 6]) -> Element {
    let name = node.tag_name().name();
    let word = |attribute| node.attribute(attribute).unwrap_or_default().to_owned();
    let mut words = vec![name.to_owned()];
    words.extend(["fill", "stroke", "fill-rule"].map(word));
    let length = |attribute| {
        node.attribute(attribute)
            .map(|text| text.parse().expect("a number"))
    };
    let mut lengths: Vec<f64> = ["r", "stroke-width"]
        .into_iter()
        .filter_map(length)
        .collect();
    let points = match name {
        "circle" => vec![[numbers(node, "cx")[0], numbers(node, "cy")[0]]],
        "text" => {
            words.extend(node.text().map(str::to_owned));
            // Whatever moves, letters stay upright.
            lengths.extend([transform[0], transform[1]]);
            vec![[numbers(node, "x")[0], numbers(node, "y")[0]]]
        }
        "path" => {
            let path = word("d").replace(['M', 'A'], " ");
            let path: Vec<f64> = path
                .split_whitespace()
                .map(|number| number.parse().expect("a number"))
                .collect();
            let [x, y, radius, _, _, is_large, is_right, to_x, to_y] = path[..] else {
                panic!("an arc: {path:?}");
            };
            lengths.extend([radius, is_large, is_right]);
            vec![[x, y], [to_x, to_y]]
        }
        _ => numbers(node, "points").as_chunks::<2>().0.to_vec(),
    };
    (
        words,
        points
            .into_iter()
            .map(|point| carried(transform, point))
            .collect(),
        lengths,
    )
}

fn elements(text: &str, phase: f64) -> Vec<Element> {
    let document = Document::parse(text).expect("well-formed");
    let player = Player::new(&document);
    player
        .seen(phase)
        .iter()
        .map(|(node, transform)| element(node, *transform))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_film_shows_each_moment(things in prop::collection::vec(thing(), 1..6), moments in 1..40_u32) {
        let sheet = Sheet::new(128, 96).look_at(View::new([1.0, -2.0], 1.25));
        let mut film = AnimatedSvg::new(sheet.clone(), PERIOD);
        for moment in 0..moments {
            film.add(|canvas| things.iter().for_each(|thing| thing.draw(canvas, moment, moments)));
        }
        let film = film.finish();
        for moment in 0..moments {
            let mut still = Svg::new(sheet.clone());
            for thing in &things {
                thing.draw(&mut still, moment, moments);
            }
            let wanted = elements(&still.finish(), 0.0);
            let found = elements(&film, f64::from(moment) / f64::from(moments) + BEHIND);
            prop_assert_eq!(found.len(), wanted.len(), "moment {}", moment);
            for (found, wanted) in found.iter().zip(wanted) {
                prop_assert_eq!(&found.0, &wanted.0, "moment {}", moment);
                prop_assert!(found.1.len() == wanted.1.len() && found.2.len() == wanted.2.len());
                let distances = found.1.iter().zip(&wanted.1).map(|(found, wanted)| (found[0] - wanted[0]).hypot(found[1] - wanted[1]));
                let lengths = found.2.iter().zip(&wanted.2).map(|(found, wanted)| (found - wanted).abs());
                let worst = distances.chain(lengths).fold(0.0, f64::max);
                prop_assert!(worst < 0.15, "moment {}: {} pixels, {:?}, not {:?}", moment, worst, found, wanted);
            }
        }
    }
}
