//! Moves that were proved at compile time.

in_both_precisions! {
    {
        /// A straight function of its motor.
        Wiper {
            link crank; link rod; link arm;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (0, 0.5);
            joint c = revolute(rod, arm) at (3, 1);
            joint d = revolute(ground, arm) at (3, 0);
            motor a in 0 deg ..= 360 deg;
        }
        /// With a coordinate that grows, and a motor without a range.
        Winch {
            link drum; link bar; link slide;
            joint a = revolute(ground, drum) at (0, 0);
            joint x = prismatic(ground, bar) at (0, -0.5) along (1, 0);
            joint r = rack(drum, bar, radius 0.5);
            joint s = prismatic(ground, slide) at (0, 3) along (1, 0);
            const FAR = 100;
            motor a in -FAR ..= FAR;
            motor s;
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::{BAD, all_moves};
    use core::hint::black_box;
    use mech_runtime::Real;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<Wiper>(recorder, 0.4);
        all_moves::<Winch>(recorder, 9.0);
        let (mut wiper, mut winch) = (Wiper::new(), Winch::new());
        for value in [0.5, 3.0, 6.25, -0.1].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            if let Some(values) = Wiper::range([value]) {
                wiper.move_within(values);
            }
            if let Some(values) = Winch::range([value, value]) {
                winch.move_within(values);
            }
            recorder.record("within", &(wiper.motors(), wiper.poses(), winch.poses()));
        }
    }
}
