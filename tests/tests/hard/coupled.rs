//! Blocks of loops that wait for each other, up to their singularities; and loops that are redundant.

use crate::bed::Bed;
use mech_runtime::Mechanism;

variants! {
    /// Stephenson III, driven at its second ground pivot.
    stephenson by [exact newton] {
        link crank;
        link coupler;
        link rocker;
        link rod;
        link driver;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.7, 1.2);
        joint c = revolute(coupler, rocker) at (3.6, 2.4);
        joint d = revolute(ground, rocker) at (4, 0);
        joint e = revolute(coupler, rod) at (2.2, 3.6);
        joint f = revolute(rod, driver) at (5.6, 4.6);
        joint g = revolute(ground, driver) at (6.4, 1.6);
        motor g;
        allow coupled;
    } {
        it_comes_near_its_singularity_and_back: near_its_singularity;
    } and by [newton_3] {
        it_goes_and_comes_back_where_a_step_is_too_long_for_the_rounds: there_and_back;
    }
}

variants! {
    double_butterfly by [exact newton] {
        link input;
        link left;
        link right;
        link lower;
        link upper;
        link west;
        link east;
        joint a = revolute(ground, input) at (0, 0);
        joint b = revolute(input, left) at (0.5, 1.2);
        joint c = revolute(left, lower) at (2, 1.6);
        joint d = revolute(left, upper) at (1.4, 3.0);
        joint e = revolute(ground, west) at (3, 0);
        joint f = revolute(west, lower) at (3.2, 1.9);
        joint g = revolute(lower, right) at (5.0, 1.5);
        joint h = revolute(upper, right) at (5.4, 3.3);
        joint i = revolute(right, east) at (6.6, 1.7);
        joint j = revolute(ground, east) at (7, 0);
        motor a;
        allow coupled;
    } {
        it_comes_near_its_singularity_and_back: near_its_singularity;
    }
}

variants! {
    three_cranks by [exact newton] {
        link first;
        link second;
        link third;
        link rail;
        joint a = revolute(ground, first) at (0, 0);
        joint b = revolute(ground, second) at (2, 0);
        joint c = revolute(ground, third) at (4, 0);
        joint d = revolute(first, rail) at (0.5, 1);
        joint e = revolute(second, rail) at (2.5, 1);
        joint f = revolute(third, rail) at (4.5, 1);
        motor a;
        allow redundant;
    } {
        its_rail_swings_in_parallel: swings;
        its_rail_keeps_its_direction_for_a_hundred_turns: rail;
    }
}

fn there_and_back<M: Mechanism>(mut bed: Bed<M>) {
    for degree in (1..=15).chain((0..15).rev()) {
        bed.must(&[f64::from(degree).to_radians()]);
    }
}

/// The same position again, reached from the side of the singularity and from far away.
fn near_its_singularity<M: Mechanism>(bed: Bed<M>) {
    for sign in [1.0, -1.0] {
        let mut bed = bed.fresh();
        let start = bed.clone();
        let Some(stuck) = bed.toward(&[sign * 6.0]) else {
            continue;
        };
        let limit = bed.motor();
        assert_eq!(stuck.reached, [limit]);
        bed.go(&[limit + sign * 0.1])
            .expect_err("it is singular before");
        for digits in 1..=8 {
            let near = limit - sign * 10.0_f64.powi(-digits);
            // In single precision it is not known so well where the limit is.
            let rounding = 64.0 * Bed::<M>::EPSILON * bed.size();
            if (near * sign) < 0.0 || 10.0_f64.powi(-digits) < rounding {
                continue;
            }
            let mut other = start.clone();
            let mut angle = 0.0;
            while (near - angle) * sign > 1e-2 {
                angle += sign * 1e-2;
                other.must(&[angle]);
            }
            other.must(&[near]);
            bed.must(&[near]);
            // Both are on the same branch: near the singularity the branches are a root apart.
            let apart = M::LINKS.iter().map(|link| {
                let (p, q) = (other.pose(link), bed.pose(link));
                (p[2] - q[2])
                    .hypot(p[3] - q[3])
                    .max((p[0] - q[0]).hypot(p[1] - q[1]))
            });
            let apart = apart.fold(0.0, f64::max);
            let root = (near - limit).abs().sqrt();
            let rounding = 64.0 * Bed::<M>::EPSILON;
            let most = rounding * bed.size() * 10.0 / root.max(rounding.sqrt());
            assert!(
                apart <= most,
                "{digits} digits from its limit it is {apart:e} from itself, more than {most:e}"
            );
        }
        bed.must(&[0.0]);
    }
}

/// Its flat positions are at −63.4° and 116.6°.
fn swings<M: Mechanism>(bed: Bed<M>) {
    for step in [1, 7, 30, 90] {
        let mut bed = bed.fresh();
        for number in 0..20 {
            let there: Vec<i32> = (-55..=110).step_by(step).collect();
            for degree in there.iter().chain(there.iter().rev()) {
                bed.must(&[f64::from(degree + number % 5).to_radians()]);
                assert_rail(&mut bed);
            }
        }
    }
}

#[track_caller]
fn assert_rail<M: Mechanism>(bed: &mut Bed<M>) {
    let (sin, cos) = bed.motor().sin_cos();
    // Its drawing has the crank at (0.5, 1).
    let moved = [0.5 * cos - sin - 0.5, 0.5 * sin + cos - 1.0];
    let sine = (0.5 * sin + cos) / 1.25_f64.sqrt();
    bed.assert_at(("rail", [0.0, 0.0]), moved, sine);
    bed.assert_at(("rail", [4.5, 1.0]), [4.5 + moved[0], 1.0 + moved[1]], sine);
}

fn rail<M: Mechanism>(bed: Bed<M>) {
    for step in [1.0, 7.0, 30.0, 45.0, 90.0, 120.0, 180.0] {
        let mut bed = bed.fresh();
        let mut degrees: f64 = 0.0;
        while degrees < 36_000.0 {
            degrees += step;
            bed.must(&[degrees.to_radians()]);
            assert_rail(&mut bed);
        }
    }
}
