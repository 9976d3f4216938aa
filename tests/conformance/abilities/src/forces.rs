//! Forces: at rest, in motion, of springs, dampers and loads, in joints of every kind.

in_both_precisions! {
    {
        /// With everything that acts.
        Press {
            ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); point hook = (2, 2); point far = (-3, 0); line guide = (0, 3) -> (0, 1); }
            link motor { point far = (0, 0); mass 0.2; }
            link crank { point shaft = (0, 0); point pin = (0.5, 0); mass 2 at (0.2, 0) inertia 0.1; }
            link rod { point big = (0, 0); point small = (2, 0); circle (1, 0) radius 0.2; density 7.8; }
            link ram { point pin = (0, 0); line axis = (0, 0) -> (1, 0); mass 3; }
            link valve { line stem = (0, 0) -> (0, 1); mass 0.1; }
            joint drive = revolute(ground.far, motor.far);
            joint turn = revolute(ground.shaft, crank.shaft);
            joint mesh = gear(motor, crank, 10 : 20);
            joint big = revolute(crank.pin, rod.big);
            joint small = revolute(rod.small, ram.pin);
            joint bed = prismatic(ground.bed, ram.axis);
            joint stem = prismatic(ground.guide, valve.stem);
            joint lift = cam(turn, stem, 0.1 * (1 - cos(q)));
            motor drive;
            start { turn = 60 deg; rod near -10 deg; }
            gravity (0, -9.81);
            spring coil = linear(ram.pin, ground.hook) stiffness 40 rest 0.5;
            spring leaf = torsional(big) stiffness 3 rest 0.2;
            damper oil = linear(ram.pin, ground.hook) damping 0.1;
            damper felt = torsional(small) damping 0.1;
            load work = force(ram.pin);
            load twist = torque(rod);
            effects { force; velocity; overlay; }
        }
        /// Two motors, a slot, a weld, a rack and a belt.
        Bench {
            link crank { mass 1 at (0.3, 0.2); }
            link arm { mass 2 at (2, 1) inertia 0.3; }
            link hand { mass 0.3 at (1, 1); point tip = (1, 2); }
            link bar { mass 1 at (5, 0); }
            link pinion { mass 0.2 at (5, 0.5) inertia 0.1; }
            link pulley { mass 0.2 at (8, 0.5) inertia 0.1; }
            joint a = revolute(ground, crank) at (0, 0);
            joint p = slot(crank, arm) at (0.8, 0.6) along (2, 1);
            joint b = revolute(ground, arm) at (3, 0);
            joint w = weld(arm, hand) at (1, 1);
            joint s = prismatic(ground, bar) at (5, 0) along (1, 0);
            joint k = revolute(ground, pinion) at (5, 0.5);
            joint r = rack(pinion, bar, radius 0.5);
            joint u = revolute(ground, pulley) at (8, 0.5);
            joint t = belt(pinion, pulley, 1 : 2);
            motor a;
            motor s;
            gravity (0, -9.81);
            load push = force(hand.tip);
            effects { force; dynamics; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::BAD;
    use core::hint::black_box;
    use mech_runtime::Real;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        press(recorder);
        bench(recorder);
    }

    fn press(recorder: &mut Recorder<impl Listener>) {
        let mut m = Press::new();
        recorder.record("press", &(m.come_to_rest([true]), m.poses()));
        for value in [0.5, 1.0, -2.0, 30.0].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            recorder.record("press", &(m.set_work([value, -value]), m.set_twist(value)));
            recorder.record("press", &(m.hold_at([value]), m.torques(), m.coil()));
            recorder.record("press", &m.forces([value], [black_box(0.5)]));
            recorder.record("press", &m.forces([black_box(2.0)], [value]));
            recorder.record("press", &(m.work_advantage([value, black_box(1.0)]), m.twist_advantage()));
            recorder.record("press", &(m.poses(), m.work(), m.twist()));
        }
    }

    fn bench(recorder: &mut Recorder<impl Listener>) {
        let mut m = Bench::new();
        recorder.record("bench", &(m.come_to_rest([true, false]), m.poses()));
        for value in [0.1, -0.2, 0.3].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            recorder.record("bench", &m.set_push([value, value]));
            recorder.record("bench", &(m.hold_at([value, value]), m.poses()));
            recorder.record("bench", &m.forces([value, value], [value, -value]));
            recorder.record("bench", &(m.push_advantage([value, value]), m.energy()));
            recorder.record("bench", &(m.simulate(black_box(0.01), [value, -value]), m.poses()));
        }
    }
}
