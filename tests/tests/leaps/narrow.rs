//! A crank that cannot pass in line with the ground, by less than a hundredth of a radian to both sides: where it stops is known in closed
//! form.

use mech_compiler::evaluate::Machine;
use mech_test_support::journeys::Subject;
use mech_test_support::{Dice, cases, seeds};
use std::f64::consts::{PI, TAU};

/// A text, the turn of the crank at its start, and on either side the middle of what it cannot reach and where it stops before it.
fn narrow_zone(dice: &mut Dice) -> (String, f64, [(f64, f64); 2]) {
    // Half of what the crank cannot reach; and whether it points at the far pivot there, or away from it.
    let half = *dice.pick(&[4e-3, 1e-3, 2e-4, 3e-5]) * dice.between(0.5, 1.0);
    let inner = dice.once_in(2);
    let (crank, ground) = (dice.between(0.5, 2.0), dice.between(2.5, 6.0));
    // Coupler and rocker just reach from the crank's end to the far pivot at the ends of the zone.
    let angle = if inner { half } else { PI - half };
    let square = crank * crank + ground * ground - 2.0 * crank * ground * angle.cos();
    let (reach, part) = (square.sqrt(), dice.between(0.0, 1.0));
    let [coupler, rocker] = if inner {
        let rocker = (0.7 + 0.5 * part) * ground;
        [rocker + reach, rocker]
    } else {
        let coupler = (0.35 + 0.3 * part) * reach;
        [coupler, reach - coupler]
    };
    let [x, y] = [0; 2].map(|_| dice.between(-5.0, 5.0));
    let (turned, begin) = (dice.between(-3.0, 3.0), dice.between(0.5, 2.6));
    let (sin, cos) = turned.sin_cos();
    let text = format!(
        "struct M;
        ground {{ point a = ({x:?}, {y:?}); point d = ({:?}, {:?}); }}
        link crank {{ point a = (0, 0); point b = ({crank:?}, 0); }}
        link coupler {{ point b = (0, 0); point c = ({coupler:?}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker:?}, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c);
        joint d = revolute(ground.d, rocker.d);
        motor a; start {{ a = {:?}; coupler near {:?}; }}",
        x + ground * cos,
        y + ground * sin,
        turned + begin,
        turned + 0.4,
    );
    let start = turned + begin;
    let zone = turned + if inner { TAU } else { PI };
    let high = if start > zone { zone + TAU } else { zone };
    let low = high - TAU;
    (text, start, [(low, low + half), (high, high - half)])
}

#[test]
fn a_narrow_dead_zone_is_found() {
    for seed in seeds(cases(40)) {
        let (text, start, limits) = narrow_zone(&mut Dice::new(seed));
        let subject = Subject::of(&text);
        for (beyond, limit) in limits {
            for more in [1e-2, 0.3, 1.0, 2.5, 30.0] {
                let to = beyond + (beyond - start).signum() * more;
                let mut machine = Machine::<f64>::new(&subject.compiled.program);
                let outcome = machine.move_to(&[to]);
                let toward = machine.move_toward(&[to]);
                let at = machine.position().motors[0];
                let stops = outcome.is_err() && !toward.is_ok_and(|stop| stop.is_none());
                assert!(
                    stops && (at - limit).abs() <= 1e-6,
                    "limit {limit}: to {to}: {outcome:?}, it stops at {at}\n{text}"
                );
            }
        }
    }
}
