//! The mechanisms that are measured. Each is declared once: its text is compiled with every method in both precisions, and
//! read again for the reference.

use crate::contestant::Contestant;

/// A mechanism that is measured.
pub(crate) struct Subject {
    /// The name in tables.
    pub(crate) slug: &'static str,
    /// The name in the picture.
    pub(crate) title: &'static str,
    /// The limit of its motor, to which it moves and back, in degrees.
    pub(crate) travel: u16,
    /// Its text, without scalar and method.
    pub(crate) text: &'static str,
    /// All methods in both precisions.
    pub(crate) contestants: Vec<Contestant>,
}

macro_rules! compiled {
    ($name:ident: $scalar:ident, ($($method:tt)+), $($text:tt)*) => {
        mech_runtime::mechanism! {
            struct $name: $scalar;
            $($text)*
            method $($method)+;
        }
    };
}

macro_rules! subject {
    ($module:ident, $slug:literal, $title:literal, $travel:literal, $($text:tt)*) => {
        mod $module {
            use crate::contestant::Contestant;
            use crate::method::{Method, Precision};
            use super::Subject;

            compiled! { ExactSingle: f32, (exact), $($text)* }
            compiled! { ExactDouble: f64, (exact), $($text)* }
            compiled! { LinearSingle: f32, (linear), $($text)* }
            compiled! { LinearDouble: f64, (linear), $($text)* }
            compiled! { OneRoundSingle: f32, (newton(1)), $($text)* }
            compiled! { OneRoundDouble: f64, (newton(1)), $($text)* }
            compiled! { TwoRoundsSingle: f32, (newton(2)), $($text)* }
            compiled! { TwoRoundsDouble: f64, (newton(2)), $($text)* }
            compiled! { ThreeRoundsSingle: f32, (newton(3)), $($text)* }
            compiled! { ThreeRoundsDouble: f64, (newton(3)), $($text)* }
            compiled! { NewtonSingle: f32, (newton), $($text)* }
            compiled! { NewtonDouble: f64, (newton), $($text)* }

            pub(super) fn subject() -> Subject {
                use Method::{Exact, Linear, Newton, Rounds};
                use Precision::{Double, Single};
                Subject {
                    slug: $slug,
                    title: $title,
                    travel: $travel,
                    text: stringify!($($text)*),
                    contestants: vec![
                        Contestant::new::<ExactSingle>(Exact, Single),
                        Contestant::new::<ExactDouble>(Exact, Double),
                        Contestant::new::<LinearSingle>(Linear, Single),
                        Contestant::new::<LinearDouble>(Linear, Double),
                        Contestant::new::<OneRoundSingle>(Rounds(1), Single),
                        Contestant::new::<OneRoundDouble>(Rounds(1), Double),
                        Contestant::new::<TwoRoundsSingle>(Rounds(2), Single),
                        Contestant::new::<TwoRoundsDouble>(Rounds(2), Double),
                        Contestant::new::<ThreeRoundsSingle>(Rounds(3), Single),
                        Contestant::new::<ThreeRoundsDouble>(Rounds(3), Double),
                        Contestant::new::<NewtonSingle>(Newton, Single),
                        Contestant::new::<NewtonDouble>(Newton, Double),
                    ],
                }
            }
        }
    };
}

subject! { four_bar, "four-bar", "Four-bar", 360,
    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point crank_pin = (0, 0); point rocker_pin = (3.5, 0); point tip = (1.75, 1.5); }
    link rocker { point shaft = (0, 0); point pin = (3, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a;
    start { a = 0 deg; rocker near 110 deg; }
}

subject! { slider_crank, "slider-crank", "Slider-crank", 360,
    ground { point shaft = (0, 0); line guide = (0, 0.25) -> (1, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link rod { point big_end = (0, 0); point small_end = (3.5, 0); }
    link block { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, block.pin);
    joint x = prismatic(ground.guide, block.axis);
    motor a;
    start { a = 0 deg; rod near 0 deg; }
}

subject! { quick_return, "quick-return", "Quick return with a sleeve", 360,
    ground { point crank_shaft = (0, 2); point arm_shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link sleeve { point pin = (0, 0); line way = (0, 0) -> (1, 0); }
    link arm { point shaft = (0, 0); line way = (0, 0) -> (1, 0); point tip = (5, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, sleeve.pin);
    joint x = prismatic(arm.way, sleeve.way);
    joint d = revolute(ground.arm_shaft, arm.shaft);
    motor a;
    start { arm near 63 deg; }
}

subject! { watt, "watt", "Watt’s six-bar", 360,
    link crank;
    link coupler;
    link bell_crank;
    link connecting_rod;
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0, 1.2);
    joint c = revolute(coupler, bell_crank) at (3.7, 2.2);
    joint d = revolute(ground, bell_crank) at (4, 0);
    joint e = revolute(bell_crank, connecting_rod) at (6.4, 3);
    joint f = revolute(connecting_rod, rocker) at (8.6, 0.7);
    joint g = revolute(ground, rocker) at (6.7, 0);
    motor a;
}

subject! { jansen, "jansen", "Jansen’s leg", 360,
    link crank;
    link upper_rod;
    link upper_plate;
    link lower_rod;
    link rocker;
    link tie;
    link lower_plate { point foot = (-22.22, -91.74); }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, upper_rod) at (9.61, 11.52);
    joint c = revolute(upper_rod, upper_plate) at (-35.24, 33.61);
    joint d = revolute(ground, upper_plate) at (-38, -7.8);
    joint e = revolute(crank, lower_rod) at (9.61, 11.52);
    joint f = revolute(lower_rod, rocker) at (-20.1, -42.79);
    joint g = revolute(ground, rocker) at (-38, -7.8);
    joint h = revolute(upper_plate, tie) at (-77.75, -2.54);
    joint i = revolute(tie, lower_plate) at (-56.05, -35.42);
    joint j = revolute(rocker, lower_plate) at (-20.1, -42.79);
    motor a;
}

subject! { andrews, "andrews", "Andrews’ squeezer", 360,
    ground { point a = (-0.06934, -0.00227); point b = (-0.03635, 0.03273); point o = (0, 0); }
    link k1 { point o = (0, 0); point tip = (0.007, 0); }
    link k2 { point tip = (0, 0); point e = (-0.028, 0); }
    link k3 { point b = (0, 0); point e = (0, -0.035); point d = (0.02, -0.018); }
    link k4 { point tip = (0, 0); point e = (0, -0.02); }
    link k5 { point a = (0, 0); point tip = (0.04, 0); }
    link k6 { point tip = (0, 0); point e = (0.02, 0); }
    link k7 { point a = (0, 0); point tip = (0, -0.04); }
    joint beta = revolute(ground.o, k1.o);
    joint theta = revolute(k1.tip, k2.tip);
    joint gamma = revolute(ground.b, k3.b);
    joint delta = revolute(ground.a, k5.a);
    joint phi = revolute(k5.tip, k4.tip);
    joint epsilon = revolute(ground.a, k7.a);
    joint omega = revolute(k7.tip, k6.tip);
    joint e2 = revolute(k3.e, k2.e);
    joint e4 = revolute(k3.e, k4.e);
    joint e6 = revolute(k3.e, k6.e);
    motor beta;
    start { beta = -0.061713890014276; k3 near 0.4553; k5 near 0.4874; k7 near 1.2305; }
}

subject! { stephenson, "stephenson", "Stephenson III, loops coupled", 15,
    link crank;
    link coupler { point tip = (2.2, 3.6); }
    link rocker;
    link rod;
    link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (5.6, 4.6);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor g;
    allow coupled;
}

/// All subjects.
pub(crate) fn subjects() -> Vec<Subject> {
    vec![
        four_bar::subject(),
        slider_crank::subject(),
        quick_return::subject(),
        watt::subject(),
        jansen::subject(),
        andrews::subject(),
        stephenson::subject(),
    ]
}
