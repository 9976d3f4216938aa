//! Params of compiled mechanisms: the generated code beside the interpreted program, what is refused, and truths that are known.

mod beside;
mod shapes;
mod zoo {
    //! Mechanisms with params.
    include!(concat!(env!("OUT_DIR"), "/changed.rs"));
}

use mech_compiler::evaluate::{Machine, sensitivities};
use mech_runtime::{Blocked, Cause, Mechanism, Phase, Reached, Real};
use mech_test_support::{
    Case, differences, folder, in_f64, mechanism_of, reach, size, with_ground, with_params,
    worst_gap, worst_stretch,
};
use zoo::{
    Arm, Coupled, FourBar, Geared, Leaning, Lifted, Loose, QuickReturn, Rolling, SliderCrank,
    Tilted, Tilted30,
};

/// A mechanism whose params are given as slices.
trait Changed: Mechanism {
    fn set(&mut self, params: &[f64]) -> bool;
    fn get(&self) -> Vec<f64>;
    /// For each param the rates of every link, in a row.
    fn rates(&self) -> Option<Vec<Vec<f64>>>;
}

macro_rules! changed {
    ($($name:ident: $scalar:ty),*) => {
        $(
            impl Changed for $name {
                fn set(&mut self, params: &[f64]) -> bool {
                    let mut values = self.params();
                    for (value, param) in values.iter_mut().zip(params) {
                        *value = <$scalar as Real>::from_f64(*param);
                    }
                    self.set_params(values).is_ok()
                }

                fn get(&self) -> Vec<f64> {
                    self.params().into_iter().map(Real::to_f64).collect()
                }

                fn rates(&self) -> Option<Vec<Vec<f64>>> {
                    let found = self.sensitivities().ok()?;
                    let row = |links: &[mech_runtime::Velocity<$scalar>]| {
                        links
                            .iter()
                            .flat_map(|link| [link.angular, link.x, link.y])
                            .map(Real::to_f64)
                            .collect()
                    };
                    Some(found.iter().map(|links| row(links)).collect())
                }
            }
        )*
    };
}

changed!(
    FourBar: f64, SliderCrank: f32, QuickReturn: f64, Arm: f64, Coupled: f64, Lifted: f64, Geared: f64, Tilted: f64,
    Leaning: f64, Rolling: f64
);

/// Moves and changes both, to and fro: the same bits, and every joint closed.
fn agree<M>(displacements: &[f64], factors: &[&[f64]])
where
    M: Changed,
    M::Scalar: Real,
{
    let named = |case: &Case| case.name.replace('_', "") == M::NAME.to_lowercase();
    let case = folder("../tests/subjects/changed").into_iter().find(named);
    let (model, compiled) = mechanism_of::<M>(&case.expect("its text").text);
    let sensitive = compiled.sensitive.as_ref().expect("it was asked for");
    let mut machine = Machine::<M::Scalar>::new(&compiled.program);
    let mut mechanism = M::new();
    let epsilon = <M::Scalar as Real>::EPSILON;
    let mut done = 0;
    for round in 0..60 {
        let mut motors = mechanism.motors();
        for (motor, displacement) in motors.as_mut().iter_mut().zip(displacements) {
            *motor += <M::Scalar as Real>::from_f64(*displacement);
        }
        assert_eq!(mechanism.move_to(motors).is_ok(), machine.move_to(motors.as_ref()).is_ok());
        let factors = factors[round % factors.len()];
        let start: Vec<f64> = model.params.values().collect();
        let params: Vec<f64> =
            start.iter().zip(factors).map(|(value, factor)| value * factor).collect();
        let given: Vec<M::Scalar> = params.iter().map(|&value| Real::from_f64(value)).collect();
        let before = mechanism.poses().to_vec();
        let outcomes = [mechanism.set(&params), machine.set_params(&given).is_ok()];
        assert_eq!(outcomes[0], outcomes[1], "{} in round {round}", M::NAME);
        if outcomes[0] {
            done += 1;
        } else {
            assert_eq!(mechanism.poses(), before, "what fails leaves it as it was");
        }
        for (pose, found) in mechanism.poses().iter().zip(&machine.position().poses) {
            assert_eq!(
                [pose.cos, pose.sin, pose.x, pose.y],
                *found,
                "{} in round {round}",
                M::NAME
            );
        }
        let given: Vec<f64> = machine.params().iter().map(|value| value.to_f64()).collect();
        assert_eq!(mechanism.get(), given);
        if model.show.is_none() {
            let there = with_params(&model, &given);
            let poses = with_ground(&there, &in_f64(mechanism.poses()));
            let extent = size(&there) + reach(&poses).max(1.0);
            let open = worst_gap(&there, &poses).max(worst_stretch(&poses));
            assert!(open <= 64.0 * epsilon * extent, "{}: {open:e}", M::NAME);
        }
        let interpreted = sensitivities(sensitive, machine.position()).ok().map(|all| {
            let row = |links: Vec<[M::Scalar; 3]>| {
                links.concat().iter().map(|rate| rate.to_f64()).collect()
            };
            all.into_iter().map(|followed| row(followed.links)).collect::<Vec<Vec<f64>>>()
        });
        assert_eq!(mechanism.rates(), interpreted, "{} in round {round}", M::NAME);
    }
    assert!(done >= 40, "{}: only {done} changes", M::NAME);
}

#[test]
fn generated_code_changes_as_the_interpreted_program_does() {
    agree::<FourBar>(&[0.37], &[&[1.0, 1.2], &[1.3, 1.0], &[0.7, 0.9], &[1.0, 3.0]]);
    agree::<SliderCrank>(&[0.37], &[&[1.5, 1.0], &[1.0, -2.0], &[0.9, 0.0]]);
    agree::<QuickReturn>(&[-0.41], &[&[0.5, 1.0], &[2.0, 1.5], &[1.0, 10.0]]);
    agree::<Arm>(&[0.3, -0.2], &[&[2.0, 0.1], &[-1.0, 1.0], &[10.0, 0.0]]);
    agree::<Coupled>(&[0.05], &[&[1.02], &[1.0], &[0.98]]);
    agree::<Lifted>(&[0.29], &[&[1.0, 0.8], &[1.2, 1.0], &[2.0, 1.0], &[0.5, 1.1]]);
    agree::<Geared>(&[0.37], &[&[1.2], &[0.95], &[1.1]]);
    agree::<Tilted>(&[0.37], &[&[1.5], &[0.0], &[-1.0], &[1.1]]);
    agree::<Leaning>(&[-0.41], &[&[0.5], &[2.0], &[-1.0], &[5.0]]);
    agree::<Rolling>(&[0.1], &[&[1.5], &[0.0], &[-1.0], &[1.1]]);
}

#[test]
fn a_line_is_turned_as_it_might_have_been_declared() {
    let (mut set, mut declared) = (Tilted::new(), Tilted30::new());
    set.set_tilt(30.0_f64.to_radians()).expect("it closes");
    for degrees in (0..=720).step_by(7) {
        let motors = [f64::from(degrees).to_radians()];
        set.move_with(motors, [2.0], [1.0]).expect("a crank turns");
        declared.move_with(motors, [2.0], [1.0]).expect("a crank turns");
        let near = |a: f64, b: f64| {
            assert!((a - b).abs() < 1e-12 * (1.0 + a.abs()), "{a} {b} at {degrees}°");
        };
        near(set.rod_middle().x, declared.rod_middle().x);
        near(set.rod_middle().y, declared.rod_middle().y);
        near(set.x(), declared.x());
        near(set.x_rate(), declared.x_rate());
        near(set.x_acceleration(), declared.x_acceleration());
        near(set.block().rotation.angle(), 0.0);
    }
    // Without a length a direction is none.
    let mut leaning = Leaning::new();
    let before = leaning;
    let blocked = leaning.set_lean(f64::INFINITY).expect_err("no direction");
    assert_eq!(blocked.cause, Cause::NotFinite);
    assert_eq!(leaning, before);
}

#[test]
fn teeth_stay_in_mesh_where_a_param_turns_a_slide() {
    let mut rolling = Rolling::new();
    let start = rolling.wheel().rotation.angle();
    for step in 1..40 {
        let turned = 0.05 * f64::from(step);
        rolling.set_tilt(30.0_f64.to_radians() + turned).expect("it closes");
        let off = rolling.wheel().rotation.angle() - start + 2.0 * turned;
        let turns = off / std::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < 1e-12, "{off}");
    }
}

#[test]
fn an_open_chain_follows_its_lengths_as_geometry_says() {
    let mut arm = Arm::new();
    for (a, b, upper, fore) in
        [(0.3, 1.1, 2.0, 1.5), (-2.0, 0.4, 7.0, 0.01), (50.0, -9.0, -1.0, 0.0)]
    {
        arm.move_to([a, b]).expect("nothing is in the way");
        arm.set_upper(upper).expect("nothing is in the way");
        arm.set_fore(fore).expect("nothing is in the way");
        let [by_upper, by_fore] = arm.ulna_hand_sensitivity().expect("there is no loop");
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
        near(by_upper.x, f64::cos(a));
        near(by_upper.y, f64::sin(a));
        near(by_fore.x, f64::cos(a + b));
        near(by_fore.y, f64::sin(a + b));
        near(arm.ulna_hand().x, upper * f64::cos(a) + fore * f64::cos(a + b));
        let [elbow, _] = arm.ulna_sensitivity().expect("there is no loop");
        assert_eq!((elbow.angular, elbow.x), (0.0, by_upper.x));
    }
}

#[test]
fn points_and_joints_follow_as_differences_say() {
    const STEP: f64 = 1e-3;
    let mut machine = QuickReturn::new();
    for _ in 0..20 {
        machine.move_to([machine.motors()[0] + 0.5]).expect("it turns");
        let at = machine.params();
        let exact = [
            machine.lever_tip_sensitivity().expect("regular").map(|rate| [rate.x, rate.y]),
            machine.b_sensitivity().expect("regular").map(|rate| [rate, 0.0]),
            machine.s_sensitivity().expect("regular").map(|rate| [rate, 0.0]),
        ];
        for param in 0..2 {
            let rows = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|part| {
                let (mut changed, mut params) = (machine, at);
                params[param] += part * STEP;
                changed.set_params(params).expect("it closes");
                let tip = changed.lever_tip();
                [[tip.x, tip.y], [changed.b(), 0.0], [changed.s(), 0.0]]
            });
            for (what, exact) in exact.iter().enumerate() {
                for part in 0..2 {
                    let [found, _] = differences(rows.map(|row| row[what][part]), STEP);
                    assert!(
                        (found - exact[param][part]).abs() < 1e-9,
                        "{what} {param} {part}: {found} {exact:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_does_not_close_is_refused_and_changes_nothing() {
    let mut four_bar = FourBar::new();
    four_bar.move_to([1.0]).expect("it closes");
    let before = four_bar;
    let refused: Result<(), Blocked<f64>> = four_bar.set_rod(0.01);
    let blocked = refused.expect_err("the rod is too short");
    assert_eq!((blocked.cause, blocked.place), (Cause::Open, "`jb`, `jc`, `jd`"));
    assert_eq!(four_bar, before);
    // Pins 1 apart from 4: the rod reaches from the crank's pin to the rocker's circle.
    let pin = [f64::cos(1.0), f64::sin(1.0)];
    let shortest = 3.0 - f64::hypot(4.0 - pin[0], pin[1]);
    assert!((blocked.reached - shortest.abs()).abs() < 1e-7, "{blocked:?}");
    four_bar.set_rod(blocked.reached).expect("it may go up to there");
    let singular = four_bar.sensitivities().expect_err("it is at a dead point");
    assert_eq!(singular.cause, Cause::Singular);
    four_bar.set_rod(3.5).expect("and back");
    assert!((four_bar.coupler_tip() - before.coupler_tip()).norm() < 1e-12);

    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let before = four_bar;
        let blocked = four_bar.set_crank(value).expect_err("it is no number");
        assert_eq!((blocked.cause, blocked.place), (Cause::NotFinite, "crank"));
        assert_eq!(blocked.to_string(), "the value for `crank` is not a finite number");
        assert!(four_bar.set_params([1.0, value]).is_err());
        assert_eq!(four_bar, before);
    }
    for value in [1e300, f64::MAX, -f64::MAX] {
        let before = four_bar;
        assert!(four_bar.set_crank(value).is_err());
        assert_eq!(four_bar, before);
    }
}

#[test]
fn numbers_that_do_not_exist_are_refused() {
    let mut lifted = Lifted::new();
    let before = lifted;
    // √(1 − x²).
    let blocked = lifted.set_x(1.5).expect_err("there is no such root");
    assert!(blocked.reached <= 1.0, "{blocked:?}");
    assert_eq!(lifted, before);
    // A point that nothing else depends on.
    let mut loose = Loose::new();
    let before = loose;
    for x in [1.5, -1.5] {
        assert_eq!(loose.set_x(x).expect_err("there is no such root").cause, Cause::Overflow);
        assert_eq!(loose, before);
    }
    loose.set_x(1e308).expect_err("nor here");
    loose.set_scale(5e307).expect("it is a number");
    let before = loose;
    loose.set_scale(1e308).expect_err("three of it are none");
    assert_eq!(loose, before);
}

#[test]
fn everything_else_goes_on_with_the_params_as_they_are() {
    let mut four_bar = FourBar::new();
    four_bar.set_rod(4.5).expect("it closes");
    let mut buffer = [0.0; 4 * 3 * 2];
    let motors = [[0.1], [0.2]];
    let mut columns = mech_runtime::Columns::new(&mut buffer, 2).expect("there is room");
    four_bar.solve_many(&motors, &mut columns).expect("it turns");
    let mut one = four_bar;
    one.move_to([0.2]).expect("it turns");
    assert_eq!(columns.pose(1, 1), Some(one.poses()[1]));
    let mut all = [four_bar; 3];
    FourBar::move_many(&mut all, &[[0.1], [0.2], [0.3]]).expect("they turn");
    assert_eq!(all[1], one);
    let mut phased = four_bar;
    phased.turn_to([Phase::from_degrees(90.0).expect("a number")]).expect("it turns");
    assert_eq!(FourBar::PARAMS, ["crank", "rod"]);
    assert_eq!((phased.crank(), phased.rod()), (1.0, 4.5));
    let mut there = four_bar;
    there.move_to([std::f64::consts::FRAC_PI_2]).expect("it turns");
    assert!((phased.coupler_tip() - there.coupler_tip()).norm() < 1e-12);
    assert_eq!(there.move_toward([2.0]).expect("a number"), Reached::Target);
    assert_eq!(there.motors(), [2.0]);
    // A change is a move: it leaves everything at rest.
    there.move_with([2.0], [1.0], [0.0]).expect("it turns");
    assert_ne!(there.jd_rate(), 0.0);
    there.set_rod(4.6).expect("it closes");
    assert_eq!(there.jd_rate(), 0.0);
    let influence_coefficients = there.influence_coefficients().expect("regular");
    assert_eq!(influence_coefficients.len(), 1);
}

/// Where a crank is made as long as the ground, the linkage is a parallelogram, which passes its change points as it came.
#[test]
fn a_parallelogram_that_is_made_passes_its_change_points() {
    let mut four_bar = FourBar::new();
    four_bar.set_params([1.0, 4.0]).expect("it closes");
    four_bar.set_params([3.0, 4.0]).expect("it closes");
    let mut before = four_bar.jd();
    for degrees in 41..=800 {
        four_bar
            .move_to([f64::from(degrees).to_radians()])
            .unwrap_or_else(|blocked| panic!("{degrees}: {blocked}"));
        let mut turned = four_bar.jd() - before;
        turned -= std::f64::consts::TAU * (turned / std::f64::consts::TAU).round();
        assert!(turned.abs() < 0.2, "{turned} at {degrees}°");
        before = four_bar.jd();
    }
}
