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

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::{BAD, all_moves};
    use core::hint::black_box;
    use mech_runtime::{GaussLegendre, Real};

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<StephensonFar>(recorder, 0.02);
        all_moves::<DoubleButterfly>(recorder, 0.02);
        all_moves::<Rounds>(recorder, 0.01);
        three(recorder);
        six(recorder);
    }

    fn three(recorder: &mut Recorder<impl Listener>) {
        let mut m = StephensonFar::new();
        for value in black_box([0.01, -0.02, 0.03]) {
            let outcome = m.move_with([value], [1.0], [0.5]);
            recorder.record("three-rates", &(outcome, m.velocities()));
            recorder.record("three-rates", &m.accelerations());
            recorder.record("three-influence_coefficients", &m.influence_coefficients());
            recorder.record("three-sensitivities", &m.sensitivities());
            recorder.record("three-tip", &m.coupler_tip_sensitivity());
            recorder.record("three-param", &(m.set_reach(2.2 + value), m.poses()));
        }
        for bad in BAD {
            recorder.record("three-bad", &m.set_reach(Real::from_f64(black_box(bad))));
        }
    }

    fn six(recorder: &mut Recorder<impl Listener>) {
        let mut m = DoubleButterfly::new();
        for value in black_box([0.01, -0.02, 0.03]) {
            let outcome = m.move_with([value], [1.0], [0.5]);
            recorder.record("six-rates", &(outcome, m.velocities()));
            recorder.record("six-rates", &m.accelerations());
            recorder.record("six-hold", &m.hold_at([value]));
            recorder.record("six-forces", &m.forces([value], [-value]));
            recorder.record("six-energy", &(m.energy(), m.motor_accelerations([value])));
            for method in [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6] {
                let outcome = m.simulate_by(black_box(method), 0.002, [value]);
                recorder.record("six-simulated", &(outcome, m.poses()));
            }
        }
        for bad in BAD {
            let bad = Real::from_f64(black_box(bad));
            recorder.record("six-bad", &(m.hold_at([bad]), m.simulate(bad, [bad]), m.set_rates([bad])));
        }
    }
}
