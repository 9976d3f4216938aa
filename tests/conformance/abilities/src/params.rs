//! Lengths that change, and how everything follows them.

in_both_precisions! {
    {
        /// Two params, an arm, and a slide.
        FourBar {
            param length = 3.5;
            param base = 4;
            const HALF = length / 2;
            ground { point a = (0, 0); point d = (base, 0); line rail = (0, base / 2) -> (1, 0); }
            link crank { point a = (0, 0); point b = (1, 0); }
            link rod { point b = (0, 0); point c = (length, 0); point tip = (HALF, sqrt(length)); }
            link rocker { point d = (0, 0); point c = (3, 0); }
            link slider { line rail = (0, 0) -> (1, 0); }
            joint a = revolute(ground.a, crank.a);
            joint b = revolute(crank.b, rod.b);
            joint c = revolute(rod.c, rocker.c);
            joint d = revolute(ground.d, rocker.d);
            joint s = prismatic(ground.rail, slider.rail);
            motor a;
            motor s;
            start { rod near 50 deg; }
            effects { velocity; acceleration; sensitivity; trace rod.tip 4; }
        }
        /// By an iteration, with a gear and a slot.
        Iterated {
            param x = 0.8;
            link crank; link coupler { point tip = (2, 3); } link rocker; link wheel; link arm;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (x, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            joint e = revolute(ground, wheel) at (7, 0);
            joint mesh = gear(rocker, wheel, 30 : 10);
            joint p = slot(wheel, arm) at (7.5, x) along (1, 1);
            joint q = revolute(ground, arm) at (5, -3);
            motor a;
            method newton;
            effects { sensitivity; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::{BAD, all_moves};
    use core::hint::black_box;
    use mech_runtime::Real;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<FourBar>(recorder, 0.4);
        all_moves::<Iterated>(recorder, 0.2);
        four_bar(recorder);
        iterated(recorder);
    }

    fn four_bar(recorder: &mut Recorder<impl Listener>) {
        let mut m = FourBar::new();
        for value in [3.6, 3.4, 4.0, 0.1, -1.0].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            recorder.record("params", &(m.set_length(value), m.set_base(value), m.params()));
            recorder.record("params", &(m.set_params([value, black_box(4.0)]), m.poses()));
            recorder.record("params", &m.move_with([value, 1.0], [1.0, 1.0], [0.5, 0.5]));
            recorder.record("params", &m.sensitivities());
            let tip = m.rod_tip_sensitivity();
            recorder.record("params", &(tip, m.rod_sensitivity(), m.d_sensitivity()));
        }
    }

    fn iterated(recorder: &mut Recorder<impl Listener>) {
        let mut m = Iterated::new();
        for value in [0.7, 0.9, 1.2, 9.0].into_iter().chain(BAD) {
            let value = Real::from_f64(black_box(value));
            recorder.record("iterated", &(m.set_x(value), m.x(), m.poses()));
            recorder.record("iterated", &(m.coupler_tip_sensitivity(), m.e_sensitivity(), m.p_sensitivity()));
        }
    }
}
