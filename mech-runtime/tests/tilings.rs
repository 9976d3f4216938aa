//! Shapes that share edges leave no gap between them and paint no pixel twice.

use mech_runtime::{Canvas, Frame, Outline, Pose, Scalar, View};
use proptest::prelude::*;

/// Corners of a grid with `COUNT` cells a side over `0..COUNT * CELL`, those inside moved about.
const COUNT: usize = 6;
const CELL: f64 = 11.0;
const SIDE: usize = 66;

fn jittered_grid() -> impl Strategy<Value = Vec<[f64; 2]>> {
    // A quarter of a cell at most, or triangles would turn over.
    let jitters = prop::collection::vec([-0.24..0.24, -0.24..0.24], (COUNT + 1) * (COUNT + 1));
    (jitters, any::<bool>()).prop_map(|(jitters, rounded)| {
        let corner = |(index, jitter): (usize, [f64; 2])| {
            let place = [index % (COUNT + 1), index / (COUNT + 1)];
            std::array::from_fn(|axis| {
                let at_rim = place[axis] == 0 || place[axis] == COUNT;
                #[expect(clippy::cast_precision_loss, reason = "small")]
                let whole = place[axis] as f64;
                let exact = (whole + if at_rim { 0.0 } else { jitter[axis] }) * CELL;
                // In half pixels, corners and edges meet centres every now and then.
                if rounded { (exact * 2.0).round() / 2.0 } else { exact }
            })
        };
        jitters.into_iter().enumerate().map(corner).collect()
    })
}

/// Paints a tile alone, and counts how often each pixel is painted.
fn paint<T: Scalar>(tile: &[[f64; 2]], painted: &mut [[u8; SIDE]; SIDE]) {
    let tile: Vec<_> =
        tile.iter().map(|corner| corner.map(<T as mech_runtime::Real>::from_f64)).collect();
    let mut frame = Frame::<SIDE, SIDE>::new();
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let middle = SIDE as f64 / 2.0;
    frame.look_at(View::new([middle, middle], 1.0));
    frame.fill(Outline::Polygon(&tile), Pose::identity(), 1);
    let pixels = frame.pixels().iter().flatten();
    for (sum, pixel) in painted.iter_mut().flatten().zip(pixels) {
        *sum += *pixel;
    }
}

/// The number of a corner.
const fn corner(column: usize, row: usize) -> usize {
    row * (COUNT + 1) + column
}

proptest! {
    #[test]
    fn tiles_meet_without_gap_or_overlap(corners in jittered_grid(), splits in prop::collection::vec(any::<(bool, bool)>(), COUNT * COUNT)) {
        let mut painted = [[0_u8; SIDE]; SIDE];
        for (cell, (diagonal, reversed)) in splits.into_iter().enumerate() {
            let first = cell / COUNT * (COUNT + 1) + cell % COUNT;
            let [a, b, c, d] = [0, 1, COUNT + 2, COUNT + 1].map(|next| corners[first + next]);
            let mut tiles = if diagonal { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            if reversed {
                tiles[0].reverse();
            }
            for tile in tiles {
                paint::<f64>(&tile, &mut painted);
            }
        }
        prop_assert!(painted.iter().flatten().all(|&times| times == 1));
    }

    #[test]
    fn tiles_meet_whatever_their_forms(corners in jittered_grid(), is_narrow in any::<bool>()) {
        // A comb of four teeth, and a tile for each gap between them and for the rest: its sides go up and down many times, so
        // that it is filled in another way than they are.
        let comb = [
            (0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (6, 3), (5, 3), (5, 1), (4, 1), (4, 5), (3, 5), (3, 2),
            (2, 2), (2, 4), (1, 4), (1, 1), (0, 1),
        ];
        let gaps: [&[(usize, usize)]; 5] = [
            &[(0, 1), (1, 1), (1, 4), (0, 6)],
            &[(2, 2), (3, 2), (3, 5), (2, 4)],
            &[(4, 1), (5, 1), (5, 3), (4, 5)],
            &[(1, 4), (2, 4), (3, 5), (4, 5), (3, 6), (0, 6)],
            &[(4, 5), (5, 3), (6, 3), (6, 6), (3, 6)],
        ];
        let mut painted = [[0_u8; SIDE]; SIDE];
        for tile in gaps.into_iter().chain([comb.as_slice()]) {
            let tile: Vec<_> = tile.iter().map(|&(column, row)| corners[corner(column, row)]).collect();
            if is_narrow {
                paint::<f32>(&tile, &mut painted);
            } else {
                paint::<f64>(&tile, &mut painted);
            }
        }
        prop_assert!(painted.iter().flatten().all(|&times| times == 1));
    }
}
