//! Mechanisms that several tests use.

macro_rules! sources {
    ($($name:literal: $path:literal,)*) => { &[$(($name, include_str!($path)),)*] };
}

/// Names and sources of the gallery's mechanisms, then of the zoo's, which the tests expand too: the last have params.
pub const SOURCES: &[(&str, &str)] = sources![
    "andrews": "../../../examples/gallery/src/mechanisms/andrews.rs",
    "four_bar": "../../../examples/gallery/src/mechanisms/four_bar.rs",
    "geared_piston": "../../../examples/gallery/src/mechanisms/geared_piston.rs",
    "jansen": "../../../examples/gallery/src/mechanisms/jansen.rs",
    "rocker_arm": "../../../examples/gallery/src/mechanisms/rocker_arm.rs",
    "watt": "../../../examples/gallery/src/mechanisms/watt.rs",
    "rolling": "../../tests/zoo/rolling.rs",
    "special": "../../tests/zoo/special.rs",
    "changed": "../../tests/changed/zoo.rs",
];

/// Declares the four-bar with ground 4, crank 1, coupler 3.5 and rocker 3, and with masses. Its motor and more follow its name.
#[macro_export]
macro_rules! four_bar {
    ($(#[$meta:meta])* struct $name:ident: $scalar:ident; $($statements:tt)*) => {
        mech_runtime::mechanism! {
            $(#[$meta])*
            struct $name: $scalar;
            ground { point a = (0, 0); point d = (4, 0); }
            link crank { point a = (0, 0); point b = (1, 0); mass 2 at (0.1, 0); }
            link coupler { point b = (0, 0); point c = (3.5, 0); point tip = (2, 1); mass 1 at (1.7, 0.2); }
            link rocker { point d = (0, 0); point c = (3, 0); mass 1.5 at (1.4, 0); }
            joint a = revolute(ground.a, crank.a);
            joint b = revolute(crank.b, coupler.b);
            joint c = revolute(coupler.c, rocker.c);
            joint d = revolute(ground.d, rocker.d);
            start { coupler near 50 deg; }
            $($statements)*
        }
    };
}

/// The statements of a four-bar with these lengths: ground, crank, coupler and rocker, joined by `ja` to `jd`.
#[must_use]
pub fn four_bar_text([ground, crank, coupler, rocker]: [f64; 4]) -> String {
    format!(
        "struct FourBar;
        ground {{ point a = (0, 0); point d = ({ground}, 0); }}
        link crank {{ point a = (0, 0); point b = ({crank}, 0); }}
        link coupler {{ point b = (0, 0); point c = ({coupler}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker}, 0); }}
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        motor ja; "
    )
}
