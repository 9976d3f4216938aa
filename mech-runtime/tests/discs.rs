//! Large circles of the anti-aliased picture cover each pixel as much as they do.

use mech_runtime::{Canvas, Outline, Palette, Pose, Scalar, Smooth, View};
use proptest::prelude::*;

const W: usize = 200;
const H: usize = 160;

/// A picture in which a scene unit is a pixel: how much of each pixel is covered, in 255ths, row by row from below.
fn coverage<T: Scalar>(center: [T; 2], radius: T) -> Vec<[u8; W]> {
    let mut picture = Box::new(Smooth::<W, H>::new());
    picture.set_palette(Palette::default().with(0, [0; 3]).with(1, [255; 3]));
    picture.clear();
    picture.look_at(View::new([100.0, 80.0], 1.0));
    picture.fill(Outline::Circle { center, radius }, Pose::identity(), 1);
    let rows = picture.pixels().iter().rev();
    rows.map(|row| row.map(|pixel| pixel[0])).collect()
}

/// The area within a circle around the origin above a level and between two abscissas, by the antiderivative of its height.
fn area_above(level: f64, [from, to]: [f64; 2], radius: f64) -> f64 {
    let reach = (radius * radius - level * level).max(0.0).sqrt();
    let half = |x: f64| (radius * radius - x * x).max(0.0).sqrt();
    let sum = |x: f64| 0.5 * (x * half(x) + radius * radius * (x / radius).clamp(-1.0, 1.0).asin());
    let within = |limit: f64| [from.clamp(-limit, limit), to.clamp(-limit, limit)];
    let [a, b] = within(reach);
    let above_chord = sum(b) - sum(a) - level * (b - a);
    if level >= 0.0 {
        return above_chord;
    }
    // The parts beside the chord, above and below the diameter.
    let [c, d] = within(radius);
    above_chord + 2.0 * (sum(d) - sum(c) - (sum(b) - sum(a)))
}

fn assert_exact(found: &[[u8; W]], [x, y]: [f64; 2], radius: f64) -> Result<(), TestCaseError> {
    let number = |index: usize| f64::from(u32::try_from(index).expect("small"));
    for (row, pixels) in found.iter().enumerate() {
        for (column, &pixel) in pixels.iter().enumerate() {
            let sides = [number(column) - x, number(column) + 1.0 - x];
            let [low, high] = [number(row) - y, number(row) + 1.0 - y].map(|level| {
                if level < radius {
                    area_above(level, sides, radius)
                } else {
                    0.0
                }
            });
            let error = f64::from(pixel) - 255.0 * (low - high);
            prop_assert!(
                error.abs() <= 1.0,
                "{pixel} of {} at {column}, {row}",
                255.0 * (low - high)
            );
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_large_circle_covers_its_part_of_each_pixel(center in [-20.0..220.0, -40.0..200.0], radius in 3.0..120.0) {
        assert_exact(&coverage(center, radius), center, radius)?;
    }

    #[test]
    fn so_does_one_within_the_margins(radius in 3.0..98.0, place in 0.0..1.0, y in -60.0..220.0) {
        let center = [radius + 1.0 + place * (198.0 - 2.0 * radius), y];
        assert_exact(&coverage(center, radius), center, radius)?;
        let narrow = center.map(<f32 as mech_runtime::Real>::from_f64);
        let center = narrow.map(f64::from);
        let radius = <f32 as mech_runtime::Real>::from_f64(radius);
        assert_exact(&coverage(narrow, radius), center, f64::from(radius))?;
    }
}
