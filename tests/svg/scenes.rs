//! Films of random things: at each of its moments a film shows what a still picture of that moment does, in the same order.

use crate::{distance, player};
use mech_runtime::files::{AnimatedSvg, Sheet, Svg};
use mech_runtime::{Canvas, Outline, Pose, View};
use proptest::prelude::*;
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
        let [pose, to_scene] =
            if self.is_in_scene { [Pose::identity(), turned] } else { [turned, Pose::identity()] };
        let point = |[x, y]: [f64; 2]| to_scene.apply([size * x, size * y]);
        let points: Vec<_> = self.points.iter().copied().map(point).collect();
        let outline = match self.kind {
            0 => Outline::Circle { center: points[0], radius: 5.0 * size },
            1 => Outline::Ring { center: points[0], radius: 5.0 * size, hole: 3.0 },
            2 => Outline::Polygon(&points),
            3 => Outline::Winding(&points),
            4 => Outline::Line { points: &points, width: 1.5 },
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

/// The texts of a picture, for which this renderer has no letters, and where they are. Whatever moves, letters stay upright.
fn texts(svg: &str) -> Vec<(&str, [f64; 2])> {
    let mut place = "";
    let mut texts = Vec::new();
    for line in svg.lines() {
        if let Some(transform) = line.strip_prefix("<g transform=\"translate(") {
            place = transform;
        } else if line.starts_with("<text") {
            let (shift, turn) = place.split_once(')').expect("an end");
            assert!(["\">", " rotate(0)\">"].contains(&turn), "{turn}");
            let (x, y) = shift.split_once(',').expect("two numbers");
            texts.push((line, [x, y].map(|number| number.parse().expect("a number"))));
        }
    }
    texts
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
            let phase = f64::from(moment) / f64::from(moments) + BEHIND;
            let (wanted, found) = (still.clone().finish(), player::still(&film, phase));
            let (wanted, found) = (texts(&wanted), texts(&found));
            prop_assert_eq!(wanted.len(), found.len());
            for ((text, [x, y]), (other, [to_x, to_y])) in wanted.into_iter().zip(found) {
                prop_assert_eq!(text, other);
                prop_assert!((to_x - x).hypot(to_y - y) < 0.15);
            }
            let worst = distance(&film, phase, still);
            prop_assert!(worst < 0.15, "moment {}: {} pixels", moment, worst);
        }
    }
}
