//! Loops that wait for each other, with every effect: contracted to three equations, and dense.

in_both_precisions! {
    {
        /// A system of three equations.
        StephensonFar {
            param reach = 2.2;
            link crank;
            link coupler { point tip = (reach, 3.6); }
            link rocker; link rod; link driver;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.7, 1.2);
            joint c = revolute(coupler, rocker) at (3.6, 2.4);
            joint d = revolute(ground, rocker) at (4, 0);
            joint e = revolute(coupler, rod) at (reach, 3.6);
            joint f = revolute(rod, driver) at (5.6, 4.6);
            joint g = revolute(ground, driver) at (6.4, 1.6);
            motor g;
            allow coupled;
            effects { velocity; acceleration; sensitivity; }
        }
        /// A system of six.
        DoubleButterfly {
            link input;
            link left { point p = (1, 2); mass 1 at (1, 2) inertia 0.1; }
            link right { point p = (6, 2); mass 1 at (6, 2) inertia 0.1; }
            link lower; link upper; link west; link east;
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
            gravity (0, -9.81);
            allow coupled;
            effects { velocity; acceleration; force; dynamics; }
        }
        /// The same without masses, by a number of rounds.
        Rounds {
            link input; link left; link right; link lower; link upper; link west; link east;
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
            method newton(2);
            allow coupled;
        }
    }

    use crate::Listener;
    use crate::abilities::teller::Teller;
    use crate::abilities::ways::{BAD, ways};
    use core::hint::black_box;
    use mech_runtime::{GaussLegendre, Real};

    pub(super) fn ask(teller: &mut Teller<impl Listener>) {
        ways::<StephensonFar>(teller, 0.02);
        ways::<DoubleButterfly>(teller, 0.02);
        ways::<Rounds>(teller, 0.01);
        three(teller);
        six(teller);
    }

    fn three(teller: &mut Teller<impl Listener>) {
        let mut m = StephensonFar::new();
        for way in black_box([0.01, -0.02, 0.03]) {
            let outcome = m.move_with([way], [1.0], [0.5]);
            teller.tell("three-rates", &(outcome, m.velocities()));
            teller.tell("three-rates", &m.accelerations());
            teller.tell("three-influence_coefficients", &m.influence_coefficients());
            teller.tell("three-sensitivities", &m.sensitivities());
            teller.tell("three-tip", &m.coupler_tip_sensitivity());
            teller.tell("three-param", &(m.set_reach(2.2 + way), m.poses()));
        }
        for bad in BAD {
            teller.tell("three-bad", &m.set_reach(Real::from_f64(black_box(bad))));
        }
    }

    fn six(teller: &mut Teller<impl Listener>) {
        let mut m = DoubleButterfly::new();
        for way in black_box([0.01, -0.02, 0.03]) {
            let outcome = m.move_with([way], [1.0], [0.5]);
            teller.tell("six-rates", &(outcome, m.velocities()));
            teller.tell("six-rates", &m.accelerations());
            teller.tell("six-hold", &m.hold_at([way]));
            teller.tell("six-forces", &m.forces([way], [-way]));
            teller.tell("six-energy", &(m.energy(), m.motor_accelerations([way])));
            for method in [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6] {
                let outcome = m.simulate_by(black_box(method), 0.002, [way]);
                teller.tell("six-simulated", &(outcome, m.poses()));
            }
        }
        for bad in BAD {
            let bad = Real::from_f64(black_box(bad));
            teller.tell("six-bad", &(m.hold_at([bad]), m.simulate(bad, [bad]), m.set_rates([bad])));
        }
    }
}
