//! Motion under forces, by every method.

in_both_precisions! {
    {
        /// One loop.
        Swinging {
            ground { point a = (0, 0); point d = (4, 0); }
            link crank { point a = (0, 0); point b = (1, 0); mass 2 at (0.5, 0) inertia 0.2; }
            link coupler { point b = (0, 0); point c = (3.5, 0); point tip = (2, 1); mass 1 at (1, 0) inertia 0.3; }
            link rocker { point d = (0, 0); point c = (3, 0); mass 0.5 at (1, 0) inertia 0.1; }
            joint a = revolute(ground.a, crank.a);
            joint b = revolute(crank.b, coupler.b);
            joint c = revolute(coupler.c, rocker.c);
            joint d = revolute(ground.d, rocker.d);
            motor a;
            start { coupler near 50 deg; }
            gravity (0, -9.81);
            spring soft = torsional(d) stiffness 3 rest 110 deg;
            damper oil = torsional(b) damping 0.01;
            effects { dynamics; trace coupler.tip 8; }
        }
        /// Two motors that forces move, through dead points perhaps.
        Bouncing {
            ground { point o = (0, 0); point p = (3, 0); point hook = (1.5, 5.5); }
            link left { point shaft = (0, 0); point knee = (2, 0); mass 1 at (1, 0) inertia 0.3; }
            link right { point shaft = (0, 0); point knee = (2, 0); mass 1 at (1, 0) inertia 0.3; }
            link reach { point knee = (0, 0); point tip = (2, 0); mass 0.6 at (1, 0) inertia 0.2; }
            link brace { point knee = (0, 0); point tip = (2, 0); mass 0.6 at (1, 0) inertia 0.2; }
            joint a = revolute(ground.o, left.shaft);
            joint b = revolute(ground.p, right.shaft);
            joint c = revolute(left.knee, reach.knee);
            joint d = revolute(right.knee, brace.knee);
            joint e = revolute(reach.tip, brace.tip);
            motor a;
            motor b;
            start { a = 80 deg; b = 100 deg; reach near 55 deg; }
            gravity (0, -9.81);
            spring coil = linear(reach.tip, ground.hook) stiffness 60 rest 0.5;
            damper pot = linear(reach.tip, ground.hook) damping 0.5;
            effects { velocity; acceleration; dynamics; force; }
        }
        /// Nothing resists its motor where it starts.
        Weightless {
            link crank; link rod; link block { mass 1; }
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (1, 0);
            joint c = revolute(rod, block) at (4, 0);
            joint x = prismatic(ground, block) at (4, 0) along (1, 0);
            motor a;
            effects { dynamics; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::BAD;
    use core::hint::black_box;
    use mech_runtime::{GaussLegendre, Mechanism, Phase, Real};

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        macro_rules! simulated {
            ($mechanism:ty, $motors:literal) => {
                let mut m = <$mechanism>::new();
                let name = <$mechanism>::NAME;
                recorder.record(name, &m.set_rates([black_box(2.0); $motors]));
                for _ in 0..black_box(4) {
                    for method in [GaussLegendre::Order2, GaussLegendre::Order4, GaussLegendre::Order6] {
                        let outcome = m.simulate_by(black_box(method), black_box(0.01), [black_box(0.5); $motors]);
                        recorder.record(name, &(outcome, m.motors(), m.rates()));
                        recorder.record(name, &m.poses());
                    }
                    recorder.record(name, &m.simulate(black_box(-0.02), [0.0; $motors]));
                    recorder.record(name, &(m.energy(), m.motor_accelerations([black_box(1.0); $motors])));
                }
                for bad in [3.0, 30.0].into_iter().chain(BAD) {
                    let bad = Real::from_f64(black_box(bad));
                    recorder.record(name, &(m.simulate(bad, [0.0; $motors]), m.rates()));
                    recorder.record(name, &(m.simulate(0.01, [bad; $motors]), m.rates()));
                    recorder.record(name, &(m.set_rates([bad; $motors]), m.motor_accelerations([bad; $motors])));
                    recorder.record(name, &(m.simulate(0.01, [0.0; $motors]), m.poses()));
                }
            };
        }
        simulated!(Swinging, 1);
        simulated!(Bouncing, 2);
        simulated!(Weightless, 1);
        let mut swinging = Swinging::new();
        let outcome = swinging.turn_to([Phase::from_degrees(black_box(400.0)).unwrap_or_default()]);
        recorder.record("Swinging", &(outcome, swinging.poses()));
        let mut bouncing = Bouncing::new();
        recorder.record("Bouncing", &bouncing.hold_at([1.5, 1.7].map(black_box)));
        recorder.record("Bouncing", &bouncing.forces([0.1, 0.2].map(black_box), [0.0; 2]));
    }
}
