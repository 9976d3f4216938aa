//! The moves that stand above a text, as formulas without a variable. Steps are in degrees. Each begins at the start.
//!
//! - `moves 20 by 1 -7`: so many steps each; `turns 100 by 1 -7`: steps until it has made so many turns.
//! - `between 1.1 -44.1`: steps for a hundred turns that never come to a change point, but pass it.
//! - `sweep 0 30 -5 by 1 7`: from one angle to the next.
//! - `go PI, 0`: to these values. `at PI / 6: …` looks at one point there.
//! - `wander`: at random, by little and by much, now and then exactly to a change point or past it.
//! - `round PI`: to this change point exactly, to rest there, back and on. `slowly PI`, `beside PI: 1e-5`: in the smallest steps past it.
//! - `nearer 2`: as near as one likes to this dead point, in a leap or step by step, to it and back.
//! - `ends 3, 4: 2`: towards these values it comes to this dead point; `stops`: to this change point, where it stops. `swing 9 between 1, -1`
//!   goes so often to and fro between dead points.
//! - `tries 9 by 1`, `tries 1, 2`: it may refuse such moves, and does one of them, but where it is it is right.
//! - `singular`: near where it is singular the same position is come to again.

use crate::bed::Bed;
use crate::geometry::{Expected, constant};
use mech_compiler::evaluate::Stop;
use mech_compiler::program::Real;
use mech_test_support::Dice;
use std::f64::consts::PI;

fn constants(list: &str) -> impl Iterator<Item = f64> {
    list.split(", ").map(constant)
}

fn words(list: &str) -> Vec<f64> {
    let words = list.split(' ');
    words.map(|word| word.parse().expect("a number")).collect()
}

/// Makes the moves that a fact has, if it has any.
pub(crate) fn make<T: Real>(bed: &Bed<'_, T>, fact: &str) -> bool {
    let (word, rest) = fact.split_once(' ').unwrap_or((fact, ""));
    let steps = || rest.split_once(" by ").expect("numbers and steps");
    let ends = || {
        let (goals, end) = rest.rsplit_once(": ").expect("goals and an end");
        (constants(goals), constant(end))
    };
    match word {
        "by" | "with" | "expanded" | "point" | "seen" | "=" => return false,
        "moves" => {
            let (count, steps) = steps();
            let count: u32 = count.parse().expect("a number");
            for step in words(steps) {
                step_on(bed, step, |number, _| number < count);
            }
        }
        "turns" => {
            let (turns, steps) = steps();
            let most = 360.0 * constant(turns);
            for step in words(steps) {
                step_on(bed, step, |_, degrees| degrees.abs() < most);
            }
        }
        "between" => words(rest).into_iter().for_each(|step| between(bed, step)),
        "sweep" => {
            let (corners, steps) = steps();
            for step in words(steps) {
                sweep(bed.fresh(), &words(corners), step);
            }
        }
        "go" => visit(bed.fresh(), constants(rest)),
        "at" => {
            let (value, point) = rest.split_once(": ").expect("a value and a point");
            let (mut bed, value) = (bed.fresh(), constant(value));
            let degree = 1_f64.to_radians().copysign(value - bed.motor());
            while (value - bed.motor()).abs() > degree.abs() {
                bed.must(bed.motor() + degree);
            }
            bed.must(value);
            bed.assert_at(&Expected::new(point));
        }
        "wander" => wander(bed.fresh()),
        "round" => round(bed.fresh(), constant(rest)),
        "slowly" => {
            for reach in [1e-2, 1e-4, 1e-6, 1e-8] {
                beside(bed.fresh(), constant(rest), 20, reach);
            }
        }
        "beside" => {
            let (place, reach) = rest.split_once(": ").expect("a place and a step");
            beside(bed.fresh(), constant(place), 200, constant(reach));
        }
        "nearer" => nearer(bed, constant(rest)),
        "ends" => {
            let (goals, end) = ends();
            // In double precision within 1e-12, in single as many units of rounding.
            let most = Bed::<T>::roundings(1e-12 / f64::EPSILON);
            let is_end = |stop: &Stop| matches!(stop, Stop::Open(_) | Stop::DeadPoint(_));
            goals.for_each(|goal| ends_at(bed.fresh(), [goal, end, most], is_end));
        }
        "stops" => {
            let (goals, end) = ends();
            let is_stop = |stop: &Stop| matches!(stop, Stop::ChangePoint(_));
            goals.for_each(|goal| ends_at(bed.fresh(), [goal, end, Bed::<T>::hidden()], is_stop));
        }
        "swing" => {
            let (count, goals) = rest.split_once(" between ").expect("a number and goals");
            let (mut bed, goals) = (bed.fresh(), constants(goals).collect::<Vec<f64>>());
            for _ in 0..count.parse().expect("a number") {
                for goal in &goals {
                    assert!(bed.toward(*goal).is_some(), "it comes to {goal}");
                }
            }
        }
        "tries" => tries(bed, rest),
        "singular" => near_its_singularity(bed),
        _ => panic!("no fact: {fact}"),
    }
    true
}

/// Steps of so many degrees from the start, as long as it goes on from a number of steps and from how far they lead.
fn step_on<T: Real>(bed: &Bed<'_, T>, step: f64, goes_on: impl Fn(u32, f64) -> bool) {
    let mut bed = bed.fresh();
    let start = bed.motor().to_degrees();
    let (mut number, mut degrees) = (0, start);
    while goes_on(number, degrees) {
        number += 1;
        degrees = start + step * f64::from(number);
        bed.must(degrees.to_radians());
    }
}

fn between<T: Real>(bed: &Bed<'_, T>, step: f64) {
    let (mut bed, mut degrees) = (bed.fresh(), 60.05_f64);
    while degrees.abs() < 36_000.0 {
        degrees += step;
        if (degrees / 180.0 - (degrees / 180.0).round()).abs() > 1e-4 {
            bed.must(degrees.to_radians());
        }
    }
}

fn sweep<T: Real>(mut bed: Bed<'_, T>, corners: &[f64], step: f64) {
    for ends in corners.windows(2) {
        let (mut degrees, way) = (ends[0], step.copysign(ends[1] - ends[0]));
        while (ends[1] - degrees) * way >= 0.0 {
            bed.must(degrees.to_radians());
            degrees += way;
        }
    }
}

fn visit<T: Real>(mut bed: Bed<'_, T>, values: impl Iterator<Item = f64>) {
    for value in values {
        bed.must(value);
    }
}

fn wander<T: Real>(mut bed: Bed<'_, T>) {
    let mut dice = Dice::new(7);
    let mut angle = 1.0;
    for _ in 0..4000 {
        let quarters = (2.0 * angle / PI).round();
        angle = match dice.below(6) {
            0 => quarters * PI / 2.0,
            1 => (quarters + 1.0) * PI / 2.0,
            2 => quarters * PI / 2.0 + dice.between(-1e-3, 1e-3),
            3 => quarters * PI / 2.0 + dice.between(-1e-7, 1e-7),
            _ => angle + dice.between(-3.0, 3.0),
        };
        if angle.abs() > 40.0 {
            angle = 1.0;
        }
        bed.must(angle);
    }
}

fn round<T: Real>(mut bed: Bed<'_, T>, place: f64) {
    for before in [1.0, 0.1, 1e-3, -1.0, -0.1, -1e-3] {
        for rests in 1..=3 {
            bed.must(place - before);
            for _ in 0..rests {
                bed.must(place);
            }
            bed.must(place - before);
            // To it, and on; and the same back.
            for target in [place, place + before, place, place - 0.5 * before] {
                bed.must(target);
            }
        }
    }
}

fn beside<T: Real>(mut bed: Bed<'_, T>, place: f64, count: i32, reach: f64) {
    for sign in [1.0, -1.0] {
        for number in -count..=count {
            bed.must(place + sign * f64::from(number) * reach);
        }
    }
}

fn nearer<T: Real>(bed: &Bed<'_, T>, limit: f64) {
    let (mut slow, start) = (bed.fresh(), bed.motor());
    let sign = (limit - start).signum();
    for digits in 1..=16 {
        let near = limit - sign * 10.0_f64.powi(-digits);
        bed.fresh().must(near);
        slow.must(near);
        slow.must(start + 0.3 * (limit - start));
        assert!(slow.toward(limit + sign).is_some());
        slow.must(near);
        slow.must(start - 0.1 * (limit - start));
    }
}

/// From the start towards a target, and the limit there.
#[track_caller]
fn ends_at<T: Real>(
    mut bed: Bed<'_, T>,
    [target, limit, most]: [f64; 3],
    is_reason: impl Fn(&Stop) -> bool,
) {
    let start = bed.motor();
    let refused = bed.move_to(target).expect_err("it ends before");
    let stop = bed.toward(target).expect("it ends before");
    let again = bed.move_to(target).expect_err("it is there");
    assert!([refused, stop, again].iter().all(is_reason), "{refused:?}");
    let ends = |bed: &Bed<'_, T>| {
        let off = bed.motor() - limit;
        let at = bed.motor();
        assert!(off.abs() <= most, "to {target}: it ends at {at}, off by {off:e}");
    };
    ends(&bed);
    // It can go back, and comes here again from there.
    bed.must(f64::midpoint(start, limit));
    assert!(bed.toward(target).is_some());
    ends(&bed);
    bed.must(start);
    assert_eq!(bed.toward(start), None);
}

fn tries<T: Real>(bed: &Bed<'_, T>, rest: &str) {
    let (mut right, mut refused) = (0, 0);
    let mut attempt = |bed: &mut Bed<'_, T>, value| {
        match bed.move_to(value) {
            Ok(()) => right += 1,
            Err(_) => refused += 1,
        }
        bed.assert_right();
    };
    if let Some((count, steps)) = rest.split_once(" by ") {
        for step in words(steps) {
            let mut bed = bed.fresh();
            for number in 1..=count.parse::<u32>().expect("a number") {
                attempt(&mut bed, f64::to_radians(step * f64::from(number)));
            }
        }
    } else {
        let mut bed = bed.fresh();
        constants(rest).for_each(|value| attempt(&mut bed, value));
    }
    assert!(right > 0 && refused > 0, "{right} right, {refused} refused");
}

/// The same position again, reached from the side of the singularity and from far away.
fn near_its_singularity<T: Real>(start: &Bed<'_, T>) {
    for sign in [1.0, -1.0] {
        let mut bed = start.fresh();
        if bed.toward(sign * 6.0).is_none() {
            continue;
        }
        let limit = bed.motor();
        bed.move_to(limit + sign * 0.1).expect_err("it is singular before");
        for digits in 1..=8 {
            let near = limit - sign * 10.0_f64.powi(-digits);
            // In single precision it is not known so well where the limit is.
            let hidden = Bed::<T>::roundings(64.0 * bed.size());
            if (near * sign) < 0.0 || 10.0_f64.powi(-digits) < hidden {
                continue;
            }
            let mut other = start.fresh();
            let mut angle = 0.0;
            while (near - angle) * sign > 1e-2 {
                angle += sign * 1e-2;
                other.must(angle);
            }
            other.must(near);
            bed.must(near);
            // Both are on the same branch: near the singularity the branches are a root apart.
            let (here, there) = (other.poses(), bed.poses());
            let pairs = here.iter().zip(&there);
            let apart = pairs.map(|(p, q)| {
                let moved = (p[2] - q[2]).hypot(p[3] - q[3]);
                moved.max((p[0] - q[0]).hypot(p[1] - q[1]))
            });
            let apart = apart.fold(0.0, f64::max);
            let root = (near - limit).abs().sqrt();
            let rounding = Bed::<T>::roundings(64.0);
            let most = rounding * bed.size() * 10.0 / root.max(rounding.sqrt());
            assert!(
                apart <= most,
                "{digits} digits from its limit it is {apart:e} from itself, more than {most:e}"
            );
        }
        bed.must(0.0);
    }
}
