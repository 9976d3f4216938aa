//! Velocities and accelerations, of loops of every kind and of what rolls.

in_both_precisions! {
    {
        /// A train that turns a linkage, a slide, a slot and a cam.
        Machine {
            ground {
                point m = (-3, 0); point o = (0, 0); line bore = (0, 0) -> (1, 0); line guide = (0, 3) -> (0, 1); point v = (6, 2);
                line bed = (0, -1) -> (1, 0);
            }
            link pinion { point o = (0, 0); }
            link wheel { point o = (0, 0); point pin = (1, 0); }
            link rod { point big = (0, 0); point small = (4, 0); }
            link piston { point pin = (0, 0); point peg = (0.5, 0.3); line axis = (0, 0) -> (1, 0); }
            link valve { line stem = (0, 0) -> (0, 1); }
            link lever { point v = (0, 0); line way = (0, 0) -> (-1, 0); }
            link bar { line bed = (0, 0) -> (1, 0); }
            link pulley { point v = (0, 0); }
            joint d = revolute(ground.m, pinion.o);
            joint e = revolute(ground.o, wheel.o);
            joint mesh = gear(pinion, wheel, 20 : 40);
            joint f = revolute(wheel.pin, rod.big);
            joint g = revolute(rod.small, piston.pin);
            joint h = prismatic(ground.bore, piston.axis);
            joint i = prismatic(ground.guide, valve.stem);
            joint k = cam(e, i, 0.3 * sin(q) * sin(q));
            joint l = revolute(ground.v, lever.v);
            joint n = slot(piston.peg, lever.way);
            joint p = prismatic(ground.bed, bar.bed);
            joint r = rack(wheel, bar, radius 1);
            joint s = revolute(ground.v, pulley.v);
            joint t = belt(wheel, pulley, 1 : 2);
            motor d;
            start { rod near 0 deg; lever near 45 deg; }
            effects { velocity; acceleration; trace rod.small 5; }
        }
        /// It comes to a dead point.
        Rocking {
            link crank; link coupler { point tip = (2.5, 3); } link rocker;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (1.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            motor a;
            method newton;
            effects { velocity; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::{BAD, all_moves};
    use core::hint::black_box;
    use mech_runtime::{Phase, Real};

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<Machine>(recorder, 0.8);
        all_moves::<Rocking>(recorder, 0.2);
        machine(recorder);
        rocking(recorder);
    }

    fn machine(recorder: &mut Recorder<impl Listener>) {
        let mut m = Machine::new();
        for value in [0.5, -1.0, 7.0, 100.0].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            recorder.record("machine", &m.move_with([value], [black_box(2.0)], [black_box(0.5)]));
            recorder.record("machine", &m.velocities());
            recorder.record("machine", &m.accelerations());
            recorder.record("machine", &(m.rod_small_velocity(), m.rod_small_acceleration(), m.h_rate()));
            recorder.record("machine", &(m.n(), m.n_rate(), m.h_acceleration()));
            recorder.record("machine", &m.influence_coefficients());
            recorder.record("machine", &m.move_with([1.0], [value], [1.0]));
            recorder.record("machine", &m.move_with([1.0], [1.0], [value]));
            for place in m.rod_small_trace().iter() {
                recorder.record("trace", &place);
            }
        }
        m.clear_traces();
        for turns in [0.25, -3.7, 1e9, 1e12] {
            let phase = Phase::from_turns(black_box(turns)).unwrap_or_default();
            recorder.record("machine", &(m.turn_to([phase]), m.poses()));
        }
    }

    fn rocking(recorder: &mut Recorder<impl Listener>) {
        let mut m = Rocking::new();
        let reached = m.move_toward([black_box(9.0)]);
        recorder.record("rocking", &(reached, m.poses()));
        let there = m.motors();
        recorder.record("rocking", &(m.move_with(there, [black_box(1.0)]), m.influence_coefficients()));
        recorder.record("rocking", &(m.coupler(), m.coupler_tip(), m.coupler_tip_velocity()));
    }
}
