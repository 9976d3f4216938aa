//! The same loop by every method.

macro_rules! by_every_method {
    ($($name:ident { $($method:tt)* })*) => {
        in_both_precisions! {
            {
                $($name {
                    ground { point a = (0, 0); point d = (4, 0); }
                    link crank { point a = (0, 0); point b = (1, 0); }
                    link coupler { point b = (0, 0); point c = (3.5, 0); point tip = (1.75, 1.5); }
                    link rocker { point d = (0, 0); point c = (3, 0); }
                    joint a = revolute(ground.a, crank.a);
                    joint b = revolute(crank.b, coupler.b);
                    joint c = revolute(coupler.c, rocker.c);
                    joint d = revolute(ground.d, rocker.d);
                    motor a by 0.25;
                    start { rocker near 110 deg; }
                    $($method)*
                })*
            }

            use mech_probes::Listener;
            use crate::recorder::Recorder;
            use crate::moves::all_moves;

            pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
                $(all_moves::<$name>(recorder, 0.25);)*
            }
        }
    };
}

by_every_method! {
    Exact { method exact; }
    Linear { method linear; }
    One { method newton(1); }
    Foreseen { method newton(1) predictor(3); }
    Three { method newton(3); }
    Settled { method newton; }
    Cheapest { accuracy 1e-3; cost cortex_m4f; }
    OnlyTheCrank { show crank; }
    OnlyTheTip { show coupler.tip, d; }
}
