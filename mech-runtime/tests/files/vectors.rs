//! SVG of whatever numbers there are: every number in it is one, and every element ends.

use mech_runtime::files::{AnimatedSvg, Sheet, Svg};
use mech_runtime::{Canvas, Outline, Pose, View};
use proptest::prelude::*;
use std::time::Duration;

/// Something to be drawn: of which kind, and its numbers.
type Drawn = (u8, Vec<f64>, u8);

fn number() -> impl Strategy<Value = f64> + Clone {
    const EXTREMES: [f64; 12] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        1e308,
        -1e154,
        1e31,
        1e29,
        f64::MIN_POSITIVE,
        5e-324,
        -0.0,
    ];
    prop_oneof![3 => -99.0..99.0, 2 => prop::sample::select(&EXTREMES[..]), 1 => any::<f64>()]
}

fn drawings() -> impl Strategy<Value = Vec<Drawn>> {
    let one = (any::<u8>(), prop::collection::vec(number(), 11..18), any::<u8>());
    prop::collection::vec(one, 0..6)
}

fn draw(canvas: &mut impl Canvas<f64>, drawn: &[Drawn]) {
    for (kind, numbers, color) in drawn {
        let [a, b, c, d, cos, sin, x, y] = std::array::from_fn(|index| numbers[index]);
        let points: Vec<[f64; 2]> = numbers[8..].chunks_exact(2).map(|p| [p[0], p[1]]).collect();
        let outline = match kind % 7 {
            0 => Outline::Circle { center: [a, b], radius: c },
            1 => Outline::Ring { center: [a, b], radius: c, hole: d },
            2 => Outline::Polygon(&points),
            3 => Outline::Winding(&points),
            4 => Outline::Line { points: &points, width: a },
            5 => {
                Outline::Arc { center: [a, b], start: [c, d], angle: numbers[8], width: numbers[9] }
            }
            _ => {
                canvas.text([a, b], "<\u{1}a & \"b\">", *color);
                continue;
            }
        };
        let pose = if kind & 128 == 0 { Pose::identity() } else { Pose { cos, sin, x, y } };
        canvas.fill(outline, pose, *color);
    }
}

/// Tests that all numbers are, and that elements begin and end in turn.
fn is_document(text: &str) -> Result<(), TestCaseError> {
    let mut open = Vec::new();
    for element in text.split('<').skip(1) {
        let (tag, _) = element.split_once('>').expect("an end");
        if let Some(name) = tag.strip_prefix('/') {
            prop_assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or_default());
        }
        for part in tag.split(['"', ' ', ',', '(', ')']) {
            prop_assert!(!part.contains("inf") && !part.contains("NaN"), "{}", tag);
            if part.starts_with(|first: char| first.is_ascii_digit() || first == '-') {
                let part = part.trim_end_matches(|last: char| !last.is_ascii_digit());
                if let Ok(number) = part.parse::<f64>() {
                    prop_assert!(number.abs() < 1e38, "{}", tag);
                }
            }
        }
    }
    prop_assert!(open.is_empty(), "{:?}", open);
    Ok(())
}

fn sheet(center: [f64; 2], scale: f64) -> Sheet {
    Sheet::new(64, 48).look_at(View::new(center, scale))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, ..ProptestConfig::default() })]

    #[test]
    fn no_number_is_too_bad_for_a_drawing(drawn in drawings(), center in prop::array::uniform2(number()), scale in number()) {
        for sheet in [sheet([0.0; 2], 1.0), sheet(center, scale)] {
            let mut svg = Svg::new(sheet);
            draw(&mut svg, &drawn);
            is_document(&svg.finish())?;
        }
    }

    #[test]
    fn nor_for_a_film(
        moments in prop::collection::vec(drawings(), 0..5), repeats in 1..4_usize,
        period in prop::sample::select(vec![Duration::ZERO, Duration::from_nanos(1), Duration::from_secs(2), Duration::MAX]),
        center in prop::array::uniform2(number()), scale in number(),
    ) {
        for sheet in [sheet([0.0; 2], 1.0), sheet(center, scale)] {
            let mut svg = AnimatedSvg::new(sheet, period);
            for moment in &moments {
                for _ in 0..repeats {
                    svg.add(|canvas| draw(canvas, moment));
                }
            }
            let text = svg.finish();
            prop_assert!(!text.contains("inf ") && !text.contains("NaN"), "{}", text);
            if !text.contains("<style>") {
                is_document(&text)?;
            }
        }
    }
}
