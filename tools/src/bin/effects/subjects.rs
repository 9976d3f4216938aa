//! The mechanisms, each without effects and with every effect.

use crate::measure::Subject;
use mech_runtime::mechanism;
use std::hint::black_box;

/// The angle of a move: half a degree on, up to a quarter of a turn and back. A tiny part of the last position makes each move depend on
/// the one before.
fn angle(number: u32, last: f64) -> f64 {
    let step = number % 360;
    f64::from(step.min(360 - step)).to_radians() * 0.5 + last * 1e-18
}

/// A module with a mechanism, and a function that moves it once.
macro_rules! subject {
    ($module:ident: { $($text:tt)* } ($mechanism:ident, $motor:ident) => $moved:expr, $more:expr, $name:expr) => {
        mod $module {
            use super::{Subject, angle, black_box, mechanism};

            mechanism! { struct Subject0; $($text)* }

            #[inline(never)]
            fn move_to($mechanism: &mut Subject0, $motor: f64) -> bool {
                $moved.is_ok()
            }

            fn run(moves: u32) -> f64 {
                let mut mechanism = Subject0::new();
                for number in 0..moves {
                    let mechanism = black_box(&mut mechanism);
                    let sine = mechanism.poses().last().map_or(0.0, |pose| pose.sin + pose.x);
                    if !move_to(mechanism, angle(number, sine)) {
                        return f64::NAN;
                    }
                }
                mechanism.poses()[0].x
            }

            pub(super) fn subject() -> Subject {
                let more: fn() -> Option<mech_runtime::Cost> = $more;
                Subject {
                    name: $name,
                    module: stringify!($module),
                    cost: Subject0::COST,
                    more: more(),
                    state: size_of::<Subject0>(),
                    run,
                }
            }
        }
    };
}

/// A module with the trace of a point.
macro_rules! traced {
    ($module:ident ($link:ident.$point:ident): { $($text:tt)* }) => {
        subject!($module: { $($text)* effects { trace $link.$point 256; } } (m, angle) => m.move_to([angle]), || None,
            concat!("position, `trace ", stringify!($link), ".", stringify!($point), " 256`"));
    };
}

/// All variants of a mechanism.
macro_rules! kinds {
    ($position:ident, $velocity:ident, $acceleration:ident, $held:ident, $acted:ident, $driven:ident, $traced:ident $trace:tt, $shown:ident, $show:tt: { $($text:tt)* }) => {
        subject!($position: { $($text)* } (m, angle) => m.move_to([angle]), || None, "position");
        subject!($velocity: { $($text)* effects { velocity; } } (m, angle) => m.move_with([angle], [1.5]),
            || Some(Subject0::RATES_COST), "velocity");
        subject!($acceleration: { $($text)* effects { velocity; acceleration; } }
            (m, angle) => m.move_with([angle], [1.5], [0.5]),
            || Some(Subject0::RATES_COST), "velocity and acceleration");
        subject!($held: { $($text)* effects { force; } } (m, angle) => black_box(m.hold_at([angle])),
            || Some(Subject0::TORQUES_COST), "torque at rest (`hold_at`)");
        subject!($acted: { $($text)* effects { force; } }
            (m, angle) => m.move_to([angle]).and_then(|()| black_box(m.forces([1.5], [0.5]))),
            || Some(Subject0::FORCES_COST), "all forces in motion (`move_to`, then `forces`)");
        subject!($driven: { $($text)* effects { dynamics; } } (m, angle) => m.simulate(1e-3, [angle * 1e-3]),
            || Some(Subject0::INERTIA_COST), "a step of time under forces (`simulate`)");
        traced!($traced $trace: { $($text)* });
        subject!($shown: { $($text)* show $show; } (m, angle) => m.move_to([angle]), || None,
            concat!("position, `show ", stringify!($show), "`"));
    };
}

kinds!(four_bar, four_bar_velocity, four_bar_acceleration, four_bar_held, four_bar_acted, four_bar_driven, four_bar_traced (coupler.c), four_bar_shown, crank: {
    ground { point a = (0, 0); point d = (4, 0); }
    link crank { point a = (0, 0); point b = (1, 0); mass 2 at (0.1, 0) inertia 0.5; }
    link coupler { point b = (0, 0); point c = (3.5, 0); mass 1 at (1.7, 0.2) inertia 1; }
    link rocker { point d = (0, 0); point c = (3, 0); mass 1.5 at (1.4, 0) inertia 1; }
    gravity (0, -9.81);
    joint ja = revolute(ground.a, crank.a);
    joint jb = revolute(crank.b, coupler.b);
    joint jc = revolute(coupler.c, rocker.c);
    joint jd = revolute(ground.d, rocker.d);
    motor ja;
    start { coupler near 50 deg; }
});

kinds!(slider, slider_velocity, slider_acceleration, slider_held, slider_acted, slider_driven, slider_traced (rod.middle), slider_shown, crank: {
    link crank { mass 1 at (0.1, 0) inertia 0.3; }
    link rod { point middle = (2.5, 0.25); mass 0.5 at (2.5, 0.2) inertia 0.4; }
    link block { mass 0.7 at (4, 0.5); }
    gravity (0, -9.81);
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0);
    joint c = revolute(rod, block) at (4, 0.5);
    joint x = prismatic(ground, block) at (4, 0.5) along (1, 0);
    motor a;
});

kinds!(jansen, jansen_velocity, jansen_acceleration, jansen_held, jansen_acted, jansen_driven, jansen_traced (foot.toe), jansen_shown, upper: {
    link crank { mass 1 at (1, 1) inertia 200; }
    link lift { mass 1 at (-13, 22) inertia 200; }
    link drop { mass 1 at (-5, -15) inertia 200; }
    link upper { mass 1 at (-50, 8) inertia 200; }
    link knee { mass 1 at (-29, -25) inertia 200; }
    link shin { mass 1 at (-67, -19) inertia 200; }
    link foot { point toe = (-22.6, -83.8); mass 1 at (-40, -60) inertia 200; }
    gravity (0, -9.81);
    joint o = revolute(ground, crank) at (0, 0);
    joint u = revolute(crank, lift) at (9.61, 11.52);
    joint d = revolute(crank, drop) at (9.61, 11.52);
    joint k = revolute(lift, upper) at (-35.24, 33.61);
    joint g = revolute(ground, upper) at (-38, -7.8);
    joint h = revolute(drop, knee) at (-20.1, -42.79);
    joint i = revolute(ground, knee) at (-38, -7.8);
    joint s = revolute(upper, shin) at (-77.75, -2.54);
    joint f = revolute(shin, foot) at (-56.05, -35.42);
    joint e = revolute(knee, foot) at (-20.1, -42.79);
    motor o;
});

kinds!(andrews, andrews_velocity, andrews_acceleration, andrews_held, andrews_acted, andrews_driven, andrews_traced (k2.e), andrews_shown, k3: {
    ground { point o = (0, 0); point a = (-0.06934, -0.00227); point b = (-0.03635, 0.03273); }
    link k1 { point o = (0, 0); point tip = (0.007, 0); mass 0.04325 at (0.00092, 0) inertia 2.194e-6; }
    link k2 { point tip = (0, 0); point e = (-0.028, 0); mass 0.00365 at (-0.0115, 0) inertia 4.410e-7; }
    link k3 { point b = (0, 0); point e = (0, -0.035); mass 0.02373 at (0.01043, -0.01874) inertia 5.255e-6; }
    link k4 { point e = (0, -0.02); point knee = (0, 0); mass 0.00706 at (0, -0.00579) inertia 5.667e-7; }
    link k5 { point a = (0, 0); point knee = (0.04, 0); mass 0.07050 at (0.02308, 0.00916) inertia 1.169e-5; }
    link k6 { point e = (0.02, 0); point knee = (0, 0); mass 0.00706 at (0.00579, 0) inertia 5.667e-7; }
    link k7 { point a = (0, 0); point knee = (0, -0.04); mass 0.05498 at (-0.00449, -0.01228) inertia 1.912e-5; }
    gravity (0, -9.81);
    joint beta = revolute(ground.o, k1.o);
    joint theta = revolute(k1.tip, k2.tip);
    joint gamma = revolute(ground.b, k3.b);
    joint e3 = revolute(k2.e, k3.e);
    joint delta = revolute(ground.a, k5.a);
    joint phi = revolute(k5.knee, k4.knee);
    joint e4 = revolute(k2.e, k4.e);
    joint epsilon = revolute(ground.a, k7.a);
    joint omega = revolute(k7.knee, k6.knee);
    joint e6 = revolute(k2.e, k6.e);
    motor beta;
    start { beta = 0; k2 near 0; k5 near 0.49; k7 near 1.23; }
});

/// A four-bar whose crank comes to a dead point at 102 degrees, with a motor as it is declared here.
macro_rules! rocking {
    ($module:ident (motor $($motor:tt)*) => ($m:ident, $angle:ident) $moved:expr, $name:expr) => {
        subject!($module: {
            ground { point a = (0, 0); point d = (4, 0); }
            link crank { point a = (0, 0); point b = (1.5, 0); }
            link coupler { point b = (0, 0); point c = (3.4, 0); }
            link rocker { point d = (0, 0); point c = (1.15, 0); }
            joint ja = revolute(ground.a, crank.a);
            joint jb = revolute(crank.b, coupler.b);
            joint jc = revolute(coupler.c, rocker.c);
            joint jd = revolute(ground.d, rocker.d);
            motor $($motor)*;
            start { coupler near 20 deg; }
        } ($m, $angle) => $moved, || None, $name);
    };
}

rocking!(rocking_watched (motor ja) => (m, angle) m.move_to([angle]), "watched: `move_to`");
rocking!(rocking_proved (motor ja in 0 ..= 91 deg) => (m, angle) m.move_to([angle]), "proved: `move_to`");
rocking!(rocking_within (motor ja in 0 ..= 91 deg) => (m, angle) { Subject0::range([angle]).map(|angle| m.move_within(angle)).ok_or(()) },
    "proved: `move_within`");

/// All subjects, by mechanism.
pub(crate) fn subjects() -> [(&'static str, Vec<Subject>); 5] {
    [
        (
            "Four-bar (one loop)",
            vec![
                four_bar::subject(),
                four_bar_velocity::subject(),
                four_bar_acceleration::subject(),
                four_bar_held::subject(),
                four_bar_acted::subject(),
                four_bar_driven::subject(),
                four_bar_traced::subject(),
                four_bar_shown::subject(),
            ],
        ),
        (
            "Slider-crank (one loop)",
            vec![
                slider::subject(),
                slider_velocity::subject(),
                slider_acceleration::subject(),
                slider_held::subject(),
                slider_acted::subject(),
                slider_driven::subject(),
                slider_traced::subject(),
                slider_shown::subject(),
            ],
        ),
        (
            "Jansen's leg (four loops)",
            vec![
                jansen::subject(),
                jansen_velocity::subject(),
                jansen_acceleration::subject(),
                jansen_held::subject(),
                jansen_acted::subject(),
                jansen_driven::subject(),
                jansen_traced::subject(),
                jansen_shown::subject(),
            ],
        ),
        (
            "Andrews' squeezer (three loops)",
            vec![
                andrews::subject(),
                andrews_velocity::subject(),
                andrews_acceleration::subject(),
                andrews_held::subject(),
                andrews_acted::subject(),
                andrews_driven::subject(),
                andrews_traced::subject(),
                andrews_shown::subject(),
            ],
        ),
        (
            "Four-bar with a dead point (one loop), watched or proved",
            vec![rocking_watched::subject(), rocking_proved::subject(), rocking_within::subject()],
        ),
    ]
}
