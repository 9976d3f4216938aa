//! `solve_many` beside a structure of arrays written by hand, and beside a sequence of `move_to`; one process, interleaved
//! rounds, medians, and the range of several repetitions. `cargo bench -p mech-tests --bench many`
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_lossless,
    reason = "small numbers"
)]

mod common;

use common::{Threshold, compare};
use mech_runtime::Columns;
use mech_runtime::generated::{Reduced, Sines};
use std::hint::black_box;

/// The greatest angle that the polynomials of sine and cosine are trusted with here: both ways are slower beyond.
const LIMIT: f64 = 2000.0;

macro_rules! bench {
    ($float:ident, $tolerance:expr) => {
        mod $float {
            use super::*;

            mech_test_support::four_bar!(struct Emitted: $float; motor a;);

            const GROUND: $float = 4.0;
            const COUPLER: $float = 3.5;
            const ROCKER: $float = 3.0;

            /// Positions are computed in blocks of so many, whose arrays do not leave the nearest cache.
            const BLOCK: usize = 64;
            type Block = [$float; BLOCK];

            /// The structure of arrays as a programmer would write it who knows what a compiler needs to vectorise: arrays of
            /// known length, each an argument of its own. `None` if one of them is blocked.
            #[inline(never)]
            #[allow(
                clippy::too_many_arguments,
                reason = "as arguments the arrays are known not to overlap"
            )]
            fn block(
                angles: &Block,
                crank_cos: &mut Block,
                crank_sin: &mut Block,
                crank_x: &mut Block,
                crank_y: &mut Block,
                coupler_cos: &mut Block,
                coupler_sin: &mut Block,
                coupler_x: &mut Block,
                coupler_y: &mut Block,
                rocker_cos: &mut Block,
                rocker_sin: &mut Block,
                rocker_x: &mut Block,
                rocker_y: &mut Block,
            ) -> Option<()> {
                const NEAR: $float = (COUPLER - ROCKER) * (COUPLER - ROCKER);
                const FAR: $float = (COUPLER + ROCKER) * (COUPLER + ROCKER);
                let mut moves = true;
                for angle in angles {
                    moves &= angle.abs() <= LIMIT as $float;
                }
                if !moves {
                    return None;
                }
                for i in 0..BLOCK {
                    let (sin, cos) = <Reduced as Sines<$float>>::sin_cos(angles[i]);
                    let (dx, dy) = (GROUND - cos, -sin);
                    let square = dx * dx + dy * dy;
                    let area = (FAR - square) * (square - NEAR);
                    moves &= area >= 0.0;
                    let half = 0.5 / square;
                    let along = 0.5 + half * (COUPLER * COUPLER - ROCKER * ROCKER);
                    let across = area.sqrt() * half;
                    let (ax, ay) = (dx * along - dy * across, dy * along + dx * across);
                    crank_cos[i] = cos;
                    crank_sin[i] = sin;
                    crank_x[i] = 0.0;
                    crank_y[i] = 0.0;
                    coupler_cos[i] = ax * (1.0 / COUPLER);
                    coupler_sin[i] = ay * (1.0 / COUPLER);
                    coupler_x[i] = cos;
                    coupler_y[i] = sin;
                    rocker_cos[i] = (ax - dx) * (1.0 / ROCKER);
                    rocker_sin[i] = (ay - dy) * (1.0 / ROCKER);
                    rocker_x[i] = GROUND;
                    rocker_y[i] = 0.0;
                }
                moves.then_some(())
            }

            /// Twelve arrays: cosine, sine, x and y of the crank, the coupler and the rocker.
            #[inline(never)]
            fn by_hand(angles: &[[$float; 1]], columns: &mut [Vec<$float>; 12]) -> Option<()> {
                let (angles, _) = angles.as_flattened().as_chunks::<BLOCK>();
                for (number, angles) in angles.iter().enumerate() {
                    let at = number * BLOCK;
                    let [a, b, c, d, e, f, g, h, i, j, k, l] = columns
                        .each_mut()
                        .map(|column| column.get_mut(at..)?.first_chunk_mut::<BLOCK>());
                    block(angles, a?, b?, c?, d?, e?, f?, g?, h?, i?, j?, k?, l?)?;
                }
                Some(())
            }

            pub(super) fn run(count: usize) {
                assert_eq!(count % BLOCK, 0, "by hand only whole blocks are computed");
                let angles: Vec<[$float; 1]> = (0..count)
                    .map(|step| [(step as $float).to_radians() * 0.7])
                    .collect();
                let emitted = Emitted::new();
                let mut buffer = vec![0.0; 12 * count];
                let mut columns =
                    Columns::<$float, 3>::new(&mut buffer, count).expect("it is large enough");
                let mut arrays: [Vec<$float>; 12] = std::array::from_fn(|_| vec![0.0; count]);

                emitted
                    .solve_many(&angles, &mut columns)
                    .expect("the crank turns");
                by_hand(&angles, &mut arrays).expect("the crank turns");
                for position in 0..count {
                    for link in 0..3 {
                        let pose = columns.pose(link, position).expect("it was computed");
                        for (part, value) in
                            [pose.cos, pose.sin, pose.x, pose.y].into_iter().enumerate()
                        {
                            let off = (value - arrays[4 * link + part][position]).abs();
                            assert!(off < $tolerance, "both compute the same: {off}");
                        }
                    }
                }

                let what = |beside| {
                    format!(
                        "{}, {count} positions, solve_many beside {beside}",
                        stringify!($float)
                    )
                };
                let positions = count as f64;
                compare(
                    &what("SoA by hand"),
                    ["emitted", "by hand"],
                    positions,
                    Threshold::AtMost(1.15),
                    || {
                        assert!(
                            black_box(&emitted)
                                .solve_many(black_box(&angles), black_box(&mut columns))
                                .is_ok()
                        )
                    },
                    || assert!(by_hand(black_box(&angles), black_box(&mut arrays)).is_some()),
                );
                let mut moved = Emitted::new();
                compare(
                    &what("move_to (inverse ratio)"),
                    ["move_to", "many"],
                    positions,
                    Threshold::AtLeast(3.0),
                    || {
                        for angle in black_box(&angles) {
                            assert!(black_box(&mut moved).move_to(*angle).is_ok());
                        }
                    },
                    || {
                        assert!(
                            black_box(&emitted)
                                .solve_many(black_box(&angles), black_box(&mut columns))
                                .is_ok()
                        )
                    },
                );
            }
        }
    };
}

bench!(f64, 1e-13);
bench!(f32, 5e-6);

fn main() {
    for count in [256, 4096] {
        f64::run(count);
        f32::run(count);
    }
}
