//! Shapes and views that a mechanism declares.

use super::recorder::Recorder;
use mech_runtime::{Canvas, Frame, Mechanism, Outline, Palette, Pose, Smooth, raster};
use proptest::prelude::*;

include!(concat!(env!("OUT_DIR"), "/shapes.rs"));

#[test]
fn a_table_has_every_kind_of_outline() {
    const WHEEL: [[f64; 2]; 3] = [[0.0, 1.0], [2.0, 3.0], [4.0, 5.0]];
    const POINTS: &[[f64; 2]] = &[[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]];
    let rows =
        [[1, 2, 3, 1], [0, 3, 0, 0], [2, 4, 2, 3], [3, 5, 1, 0], [4, 6, 5, 0], [5, 255, 4, 0]];
    let numbers = [0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0];
    let expected = [
        Outline::Line { points: &[[1.0, 2.0]], width: 0.5 },
        Outline::Circle { center: [1.0, 2.0], radius: 3.0 },
        Outline::Polygon(&POINTS[1..]),
        Outline::Ring { center: [4.0, 5.0], radius: 6.0, hole: 7.0 },
        Outline::Polygon(&WHEEL),
        Outline::Arc { center: [8.0, 9.0], start: [10.0, 11.0], angle: 12.0, width: 13.0 },
    ];
    let found = mech_runtime::generated::shapes(rows, &numbers, POINTS, &[&WHEEL]);
    for ((shape, row), outline) in found.iter().zip(rows).zip(expected) {
        assert_eq!([shape.link, usize::from(shape.color)], row[..2]);
        assert_eq!(shape.outline, outline);
    }
}

#[test]
fn a_bar_is_painted_as_textbooks_do() {
    let mut barred = Barred::new();
    barred.move_to([0.4, 1.0]).expect("it turns");
    let mut declared = Barred::picture::<160, 120>();
    barred.draw(&mut declared);
    let mut painted = Barred::picture::<160, 120>();
    let identity = Pose::identity();
    painted.fill(Outline::Ring { center: [0.0, 0.0], radius: 0.5, hole: 0.3 }, identity, 1);
    let [crank, arm] = *barred.poses();
    painted.fill(Outline::Ring { center: [1.0, 0.0], radius: 0.75, hole: 0.5 }, arm, 5);
    raster::bar(&mut painted, &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]], crank, 0.5, 2);
    assert!(declared == painted);
    let seen = |color: u8| declared.pixels().as_flattened().contains(&color);
    assert!([1, 2, 5, Palette::darker(2), Palette::INK, Palette::EYE].into_iter().all(seen));
}

#[test]
fn a_picture_is_of_the_quality_that_is_declared() {
    let hard: Frame<64, 48> = Barred::picture();
    let mut soft: Smooth<64, 48> = SoftCrank::picture();
    assert_eq!(hard.view(), Barred::view(64, 48));
    assert_eq!(soft.view(), SoftCrank::view(64, 48));
    SoftCrank::new().draw(&mut soft);
}

/// Joints of a mechanism without shapes: the crank's pin goes round (1, 2), the block slides from 2 to 6 along y = 2.
#[test]
fn the_extent_is_that_of_the_motion() {
    let expected = [[-1.0, 0.0], [6.0, 4.0]];
    let off = SoftCrank::EXTENT.as_flattened().iter().zip(expected.as_flattened());
    let mut off = off.map(|(is, should)| (f64::from(*is) - should).abs());
    assert!(off.all(|off| off < 1e-6), "{:?}", SoftCrank::EXTENT);
}

proptest! {
    #[test]
    fn nothing_is_seen_outside_of_the_extent(angles in prop::collection::vec(-7.0..7.0, 8)) {
        fn check<M: Mechanism<Scalar = f64, Motors = [f64; 1]>>(angles: &[f64]) {
            let mut mechanism = M::new();
            let [low, high] = M::EXTENT;
            let rounding = 1e-6 * (high[0] - low[0]).max(high[1] - low[1]);
            for &angle in angles {
                // What is blocked is not seen.
                let _ = mechanism.move_toward([angle]);
                let mut bounds = M::EXTENT;
                mechanism.draw(&mut Recorder {
                    scale: f64::INFINITY,
                    fill: |outline: Outline<'_, f64>, pose: Pose<f64>, _: u8| {
                        let (low, high) = outline.bounds(pose);
                        for axis in 0..2 {
                            bounds[0][axis] = bounds[0][axis].min(low[axis]);
                            bounds[1][axis] = bounds[1][axis].max(high[axis]);
                        }
                    },
                });
                let off = bounds.as_flattened().iter().zip(M::EXTENT.as_flattened()).map(|(is, should)| (is - should).abs());
                assert!(off.fold(0.0, f64::max) <= rounding, "{} at {angle}: {:?} of {:?}", M::NAME, bounds, M::EXTENT);
            }
        }
        check::<mech_gallery::geared_piston::GearedPiston>(&angles);
        check::<mech_gallery::four_bar::CrankRocker>(&angles);
        check::<mech_gallery::andrews::AndrewsSqueezer>(&angles);
        check::<mech_gallery::jansen::JansenLeg>(&angles);
    }
}
