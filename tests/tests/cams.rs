//! Cams: followers are where the law of their shaft has them, at every rate.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::Shown;
use mech_compiler::program::build;
use mech_compiler::structure::Diagnosis;
use mech_runtime::{Cause, Phase};
use mech_test_support::{
    Sample, add_cam, cases, for_all, model, reach, samples, shuffled, with_ground, worst_gap,
};
use std::f64::consts::{PI, TAU};

mod generated {
    include!(concat!(env!("OUT_DIR"), "/cams.rs"));
}

/// First and second differences of a function round a place.
fn differences(at: impl Fn(f64) -> f64, place: f64) -> [f64; 2] {
    const STEP: f64 = 1e-3;
    let five = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|number| at(place + number * STEP));
    mech_test_support::differences(five, STEP)
}

#[test]
fn a_follower_is_where_its_law_has_it() {
    let law = |q: f64| 0.2 * (1.0 - q.cos()) + (0.1 * (2.0 * q).sin()).max(0.0);
    let mut lifter = generated::Lifter::new();
    for step in -400..400 {
        let angle = 0.037 * f64::from(step);
        lifter.move_with([angle], [1.5], [0.7]).expect("it moves");
        assert!((lifter.h() - law(angle)).abs() < 1e-14);
        assert!((lifter.valve_top().y - (1.5 + law(angle))).abs() < 1e-14);
        // Not where it has a corner.
        if (2.0 * angle).sin().abs() < 0.02 {
            continue;
        }
        let [first, second] = differences(law, angle);
        assert!((lifter.h_rate() - 1.5 * first).abs() < 1e-10, "{angle}");
        let expected = 2.25 * second + 0.7 * first;
        assert!((lifter.h_acceleration() - expected).abs() < 1e-7, "{angle}");
    }
}

#[test]
fn a_cam_drives_what_hangs_on_its_follower() {
    let law = |q: f64| 0.4 * q.sin() * q.sin() - 0.1 * (3.0 * q).cos();
    let at = |m: f64| {
        let mut train = generated::Train::new();
        train.move_to([m]).expect("it moves");
        train
    };
    let mut train = generated::Train::new();
    for step in 0..300 {
        let m = 0.05 * f64::from(step) - 3.0;
        train.move_with([m], [1.0], [0.0]).expect("it moves");
        let lever = law(-m * 2.0 / 3.0);
        assert!((train.l() - lever).abs() < 1e-13, "{m}");
        // The slider-crank that the lever makes with the rod, by hand.
        let (pin_x, pin_y) = (2.0 - 2.0 * lever.sin(), 2.0 * lever.cos());
        let slide = pin_x + (2.5_f64.powi(2) - (3.0 - pin_y).powi(2)).sqrt();
        assert!((train.z() - slide).abs() < 1e-12, "{m}: {} {slide}", train.z());
        let [first, second] = differences(|m| at(m).z(), m);
        assert!((train.z_rate() - first).abs() < 1e-9, "{m}");
        assert!((train.z_acceleration() - second).abs() < 1e-7, "{m}");
    }
}

#[test]
fn a_loop_may_turn_the_shaft() {
    let mut rocking = generated::Rocking::new();
    for step in 0..400 {
        let a = 0.05 * f64::from(step);
        rocking.move_with([a], [1.0], [0.0]).expect("it moves");
        let q = rocking.d();
        assert!((rocking.f() - (q * q + 0.3 * q)).abs() < 1e-13);
        let (rate, second) = (rocking.d_rate(), rocking.d_acceleration());
        let slope = 2.0 * q + 0.3;
        assert!((rocking.f_rate() - slope * rate).abs() < 1e-12);
        let expected = slope * second + 2.0 * rate * rate;
        assert!((rocking.f_acceleration() - expected).abs() < 1e-11);
    }
}

#[test]
fn a_million_turns_do_not_matter() {
    let mut screw = generated::Screw::new();
    let turned = Phase::new(1_000_000, 1 << 62);
    screw.turn_to([turned]).expect("it turns");
    let angle = TAU * 1_000_000.25;
    assert!((screw.n() - 0.001 * angle).abs() < 1e-11);
    // Twice a quarter turn, and the wave in it: exact, since whole turns are not in it.
    let double = PI + 0.25;
    let off = screw.t() - (double - TAU);
    assert!(off.abs() < 1e-14, "{off:e}");
    // The wave of the nut is as exact as its displacement is: sixteen digits of a million turns.
    assert!((screw.w() - angle.sin() / 2.0).abs() < 1e-8);
    let mut lifter = generated::Lifter::new();
    lifter.turn_to([turned]).expect("it turns");
    assert!((lifter.h() - 0.2).abs() < 1e-15);
    lifter.move_to([TAU * 1e7 + 0.5]).expect("it turns");
    let expected = 0.2 * (1.0 - 0.5_f64.cos()) + 0.1 * 1.0_f64.sin();
    assert!((lifter.h() - expected).abs() < 1e-7);
}

#[test]
fn where_the_law_ends_the_mechanism_stays() {
    let mut ending = generated::Ending::new();
    ending.move_to([0.75]).expect("it moves");
    let there = ending;
    let blocked = ending.move_to([1.5]).expect_err("there is no root");
    assert_eq!(blocked.cause, Cause::Overflow);
    assert_eq!(ending, there);
    assert!(ending.move_to([f32::NAN]).is_err());
    assert_eq!(ending, there);
    let x = 0.5 + 0.75_f32.exp() / (0.75 - 3.0);
    assert!((ending.x() - x).abs() < 1e-6);
}

#[test]
fn what_rolls_may_hang_on_a_follower() {
    let mut counting = generated::Counting::new();
    for step in 0..200 {
        let time = 0.007 * f64::from(step);
        counting.at_time(time).expect("it moves");
        let value = 3.0 * (TAU * time).sin();
        assert!((counting.x() - value).abs() < 1e-12);
        let angle = (value / 0.1).rem_euclid(TAU);
        let off = (counting.p() - angle).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-10, "{time}: {off}");
        let rate = TAU * 30.0 * (TAU * time).cos();
        assert!((counting.p_rate() - rate).abs() < 1e-9);
    }
}

#[test]
fn what_cannot_be_followed_is_diagnosed() {
    type Found = fn(&[Diagnosis]) -> bool;
    let cases: [(&str, Found); 4] = [
        ("joint c = cam(s, f, q); joint d = cam(s, f, sin(q)); motor s;", |found| {
            matches!(found, [Diagnosis::Overdetermined { .. } | Diagnosis::Blocked { .. }])
        }),
        ("joint c = cam(s, f, q);", |found| {
            matches!(found, [Diagnosis::NoMotor { freedom: 1, .. }])
        }),
        ("joint c = cam(s, f, q); motor s; motor f;", |found| {
            matches!(found, [Diagnosis::TooManyMotors { .. }])
        }),
        // A law that does not vary holds its follower.
        ("joint c = cam(s, f, 0.5); motor f;", |found| {
            let holds = |one: &Diagnosis| {
                matches!(one, Diagnosis::Blocked { .. } | Diagnosis::TooManyMotors { .. })
            };
            found.iter().any(holds)
        }),
    ];
    for (statements, is_found) in cases {
        let text = format!(
            "struct M; link disk; link lever;
            joint s = revolute(ground, disk) at (0, 0); joint f = revolute(ground, lever) at (3, 0); {statements}"
        );
        let found = compile(&model(&text)).expect_err("it is wrong");
        assert!(is_found(&found), "{statements}: {found:?}");
    }
}

/// How many mechanisms the test tries.
const CASES: u64 = 200;

/// Random mechanisms with random cams: each follower is where its law has it, and what is shown alone moves as in the whole.
#[test]
fn random_followers_are_where_their_laws_have_them() {
    let (mut compiled, mut moved) = (0, 0);
    for_all(CASES, &samples(1..=6), |Sample { grown, mut dice }| {
        let mut model = grown.model;
        let cams: Vec<_> =
            (0..=dice.below(3)).filter_map(|_| add_cam(&mut model, &mut dice)).collect();
        let Some(&last) = cams.last() else { return };
        let name = model.joint(last).name.clone();
        let model = shuffled(&model, &mut dice);
        let last =
            model.joint_ids().find(|&joint| model.joint(joint).name == name).expect("it is there");
        let whole = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}"));
        compiled += 1;
        let link = model.ends(last).1;
        let mut part = model.clone();
        part.show = Some(vec![Shown::Link(link)]);
        assert!(compile(&part).is_ok(), "a part is coherent");
        // Every loop solved by the same steps, whatever is left out.
        let [whole, part] = [&model, &part].map(|one| build(one, &whole.plan));
        let [place, own] = [&whole, &part].map(|one| one.place_of(link).expect("it is shown"));
        let mut machine = Machine::<f64>::new(&whole);
        let mut alone = Machine::<f64>::new(&part);
        for _ in 0..20 {
            let motors: Vec<f64> = machine
                .position()
                .motors
                .iter()
                .map(|motor| motor + dice.between(-0.5, 0.5))
                .collect();
            if machine.move_to(&motors).is_err() {
                continue;
            }
            moved += 1;
            let poses = with_ground(&model, &machine.position().poses);
            let reach = reach(&poses).max(10.0);
            let gap = worst_gap(&model, &poses);
            assert!(gap < 1e-11 * reach, "{gap:e}");
            alone.move_to(&motors).expect("less is in the way");
            assert_eq!(machine.position().poses[place], alone.position().poses[own]);
        }
    });
    println!("{compiled} compiled, {moved} moves");
    assert!(compiled > cases(CASES) / 3 && moved > 3 * cases(CASES));
}
