//! Whatever numbers a mechanism is given, in whatever order: it moves, or says why not and is as it was. Nothing panics, and what it
//! tells are numbers.

use super::zoo::Differential;
use mech_runtime::{GaussLegendre, Phase, Pose, Scalar};
use proptest::prelude::*;
use std::fmt::Debug;

include!(concat!(env!("OUT_DIR"), "/bad.rs"));

/// Numbers of which many are none, or are beyond all others.
fn number() -> impl Strategy<Value = f64> + Clone {
    const EXTREMES: [f64; 10] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        -0.0,
        1e19,
        -1e9,
        1e300,
    ];
    prop_oneof![4 => -9.0..9.0, 1 => prop::sample::select(&EXTREMES[..]), 1 => proptest::num::f64::ANY]
}

/// Something that is asked of a mechanism: which, and the numbers that it is given.
fn asked() -> impl Strategy<Value = Vec<(u8, [f64; 4])>> {
    prop::collection::vec((any::<u8>(), prop::array::uniform4(number())), 1..12)
}

/// Tests that it is somewhere.
fn is_somewhere<T: Scalar>(poses: &[Pose<T>]) {
    for pose in poses {
        let numbers = [pose.cos, pose.sin, pose.x, pose.y];
        assert!(
            numbers.map(mech_runtime::Real::to_f64).iter().all(|number| number.is_finite()),
            "{pose:?}"
        );
        let length = numbers[0].to_f64().hypot(numbers[1].to_f64());
        assert!((length - 1.0).abs() < 1e-3, "{pose:?}");
    }
}

/// Tests that everything that was reported is a number.
#[track_caller]
fn are_numbers(value: &impl Debug) {
    let text = format!("{value:?}");
    assert!(!text.contains("inf") && !text.contains("NaN"), "{text}");
}

/// Asks a mechanism, and tells whether it was moved.
fn ask_forced(m: &mut Forced, which: u8, [x, y, z, w]: [f64; 4]) -> bool {
    let before = *m;
    let refused = match which % 15 {
        0 => m.move_to([x]).is_err(),
        1 => m.move_toward([x]).is_err(),
        2 => m.move_with([x], [y], [z]).is_err(),
        3 => m.hold_at([x]).is_err(),
        4 => m.set_push([x, y]).is_err(),
        5 => m.set_twist(x).is_err(),
        6 => m.set_rates([x]).is_err(),
        7 => m.simulate(x, [y]).is_err(),
        8 => {
            let method = [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6]
                [usize::from(which) % 3];
            m.simulate_by(method, 1e-3 * x, [y]).is_err()
        }
        9 => {
            are_numbers(&m.forces([x], [y]).ok());
            are_numbers(&m.motor_accelerations([z]).ok());
            are_numbers(&m.energy().ok());
            assert_eq!(*m, before);
            false
        }
        10 => {
            // An advantage may be infinite.
            let advantages = (m.push_advantage([x, y]).ok(), m.twist_advantage().ok());
            assert!(!format!("{advantages:?}").contains("NaN"));
            are_numbers(&m.torques().ok());
            are_numbers(&m.influence_coefficients().ok());
            assert_eq!(*m, before);
            false
        }
        11 => {
            let phase = Phase::from_turns(x).unwrap_or(Phase::new(i64::MAX, u64::MAX));
            m.turn_to([phase]).is_err()
        }
        12 => {
            let mut buffer = [0.0; 4 * 3 * 4];
            let mut columns = mech_runtime::Columns::new(&mut buffer, 3).expect("there is room");
            let _ = m.solve_many(&[[x], [y], [z], [w]], &mut columns);
            assert_eq!(*m, before);
            false
        }
        13 => m.come_to_rest([x > 0.0]).is_err(),
        _ => {
            let mut all = [*m; 3];
            let _ = Forced::move_many(&mut all, &[[x], [y], [z], [w]]);
            for m in &all {
                is_somewhere(m.poses());
            }
            false
        }
    };
    assert!(!refused || *m == before, "{m:?} was {before:?}");
    is_somewhere(m.poses());
    are_numbers(m);
    are_numbers(&(m.coupler_tip(), m.coupler_tip_velocity(), m.coupler_tip_acceleration()));
    are_numbers(&(m.jd(), m.jd_rate(), m.jd_acceleration(), m.coil()));
    !refused && [0, 1, 2, 3, 7, 8, 11, 13].contains(&(which % 15))
}

fn ask_changing(m: &mut Changing, which: u8, numbers: [f64; 4]) {
    let before = *m;
    #[expect(clippy::cast_possible_truncation, reason = "what is beyond is infinite")]
    let [x, y, z, w] = numbers.map(|number| number as f32);
    let refused = match which % 6 {
        0 => m.move_to([x, y]).is_err(),
        1 => m.move_toward([x, y]).is_err(),
        2 => m.move_with([x, y], [z, w]).is_err(),
        3 => m.set_rod(x).is_err(),
        4 => m.set_params([x]).is_err(),
        _ => {
            are_numbers(&m.sensitivities().ok());
            assert_eq!(*m, before);
            false
        }
    };
    assert!(!refused || *m == before, "{m:?} was {before:?}");
    is_somewhere(m.poses());
}

fn ask_lawful(m: &mut Lawful, which: u8, [x, y, z, w]: [f64; 4]) {
    let before = *m;
    let refused = match which % 4 {
        0 => m.at_time(x).is_err(),
        1 => m.move_to([x, y]).is_err(),
        2 => m.move_toward([x, y]).is_err(),
        _ => m.move_with([x, y], [z, w], [x, z]).is_err(),
    };
    assert!(!refused || *m == before, "{m:?} was {before:?}");
    is_somewhere(m.poses());
}

fn ask_geared(m: &mut Differential, which: u8, [x, y, z, w]: [f64; 4]) {
    let before = *m;
    let refused = match which % 4 {
        0 => m.move_to([x, y]).is_err(),
        1 => m.move_toward([x, y]).is_err(),
        2 => {
            let [s, r] =
                [x, y].map(|turns| Phase::from_turns(turns).unwrap_or(Phase::new(1, u64::MAX)));
            m.turn_to([s, r]).is_err()
        }
        _ => {
            let mut all = [*m; 2];
            let _ = Differential::move_many(&mut all, &[[x, y], [z, w]]);
            for m in &all {
                is_somewhere(m.poses());
            }
            false
        }
    };
    assert!(!refused || *m == before, "{m:?} was {before:?}");
    is_somewhere(m.poses());
}

proptest! {
    #[test]
    fn angles_of_any_size(asked in asked()) {
        let mut geared = Differential::new();
        for (which, numbers) in asked {
            ask_geared(&mut geared, which, numbers);
        }
    }

    #[test]
    fn forces_of_any_size(asked in asked()) {
        let mut forced = Forced::new();
        let mut been = Vec::new();
        for (which, numbers) in asked {
            if ask_forced(&mut forced, which, numbers) {
                been.push(forced.coupler_tip());
            }
            let last = been.len().saturating_sub(16);
            let traced: Vec<_> = forced.coupler_tip_trace().iter().collect();
            prop_assert_eq!(&traced, &been[last..]);
        }
    }

    #[test]
    fn lengths_of_any_size(asked in asked()) {
        let mut changing = Changing::new();
        for (which, numbers) in asked {
            ask_changing(&mut changing, which, numbers);
        }
    }

    #[test]
    fn times_of_any_size(asked in asked()) {
        let mut lawful = Lawful::new();
        for (which, numbers) in asked {
            ask_lawful(&mut lawful, which, numbers);
        }
    }
}
