//! Motors that follow laws of the time, and coordinates of joints.

in_both_precisions! {
    {
        /// By everything that laws are made of.
        Lawful {
            link crank; link coupler; link rocker; link slider;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            joint s = prismatic(ground, slider) at (0, 5) along (1, 0);
            motor a = 2 * PI * t + exp(t / 9) * sin(t) - cos(t) * atan(t);
            motor s = t * sqrt(1 + t) / (2 - t) + max(0, min(t, abs(tan(t))));
            effects { velocity; acceleration; }
        }
        /// Without rates, and one motor without a law.
        Swaying {
            link crank; link rod; link block; link arm;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (1, 0.5);
            joint c = revolute(rod, block) at (4, 0);
            joint x = prismatic(ground, block) at (4, 0) along (1, 0);
            joint w = revolute(ground, arm) at (0, 5);
            motor a = 0.3 * sin(2 * PI * t) + max(0, t - 1);
            motor w;
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::BAD;
    use core::hint::black_box;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        let (mut lawful, mut swaying) = (Lawful::new(), Swaying::new());
        for time in [0.0, 0.3, 1.7, 1e6, -0.5, 2.0, -3.0].into_iter().chain(BAD) {
            let time = black_box(time);
            recorder.record("lawful", &lawful.at_time(time));
            recorder.record("lawful", &(lawful.motors(), lawful.poses()));
            recorder.record("lawful", &(lawful.velocities(), lawful.accelerations()));
            recorder.record("swaying", &(swaying.at_time(time), swaying.motors(), swaying.poses()));
        }
        recorder.record("coordinates", &[swaying.b(), swaying.c(), swaying.x(), swaying.a()]);
    }
}
