//! A train of gears keeps its exact ratio for ever.

use super::zoo::Clock;
use std::f64::consts::TAU;

#[test]
fn a_clock_train_is_exact_and_does_not_drift() {
    // Ten million turns forwards in leaps, and the same position as after none.
    let mut clock = Clock::new();
    for step in 1..=1_000 {
        clock.move_to([f64::from(step) * 1e4 * TAU]).unwrap();
    }
    let mut fresh = Clock::new();
    fresh.move_to([1e7 * TAU]).unwrap();
    assert_eq!(clock.poses(), fresh.poses());
    // 10⁷ turns times 1/300 · 2/3 of a turn: the exact angle, reduced in whole numbers.
    let turns = -(10_000_000.0_f64 * 2.0 / 900.0 % 1.0);
    let off = (clock.e() - turns * TAU) / TAU;
    assert!((off - off.round()).abs() < 1e-9, "{off:e}");
}
