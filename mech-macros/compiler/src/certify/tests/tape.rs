//! Whatever a program computes somewhere in a box lies in what it computes on the box.

use super::super::Interval;
use super::super::claim::Group;
use super::super::claim::tests;
use super::super::tape::Tape;
use super::models::{chain, exhibit, four_bar, slider_crank};
use proptest::prelude::*;
use std::sync::LazyLock;

use crate::program::Program;

static PROGRAMS: LazyLock<Vec<Program>> = LazyLock::new(|| {
    vec![
        four_bar([4.0, 1.0, 3.5, 3.0], 0.3, 1.0, 1.5),
        four_bar([4.0, 1.0, 2.0, 1.5], 0.0, 0.5, 2.0),
        four_bar([2.0, 1.0, 2.0, 1.0], 0.7, 1.7, 1.7),
        four_bar([2.0, 2.0, 2.0, 2.0], 0.7, 1.7, 1.7),
        slider_crank(1.0, 1.0),
        chain(4),
        exhibit("jansen"),
        exhibit("watt"),
        exhibit("andrews"),
        exhibit("geared_piston"),
        exhibit("rocker_arm"),
    ]
});

/// All tests of a program at once.
fn whole(program: &Program) -> Group {
    Group { motors: (0..program.inputs()).collect(), held: Vec::new(), tests: tests(program) }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn points_are_inside_their_boxes(
        which in 0_usize..11,
        from in -7.0_f64..7.0,
        digits in -12.0_f64..0.8,
        parts in prop::collection::vec(0.0_f64..=1.0, 8),
    ) {
        let program = &PROGRAMS[which];
        let width = 10.0_f64.powf(digits);
        let mut tape = Tape::new(program, &whole(program), &[]);
        let place = vec![Interval::new(from, from + width); program.motors.len()];
        tape.run(&place);
        let all = tape.all();
        for part in parts {
            let at = Interval::point((from + part * width).min(from + width));
            tape.run(&vec![at; program.motors.len()]);
            for ((value, form), (point, _)) in all.iter().zip(tape.all()) {
                for range in [value, form] {
                    let meets = range.low() <= point.high() && point.low() <= range.high();
                    prop_assert!(meets, "{range:?} {point:?} {from} {width} {part}");
                }
            }
        }
    }
}
