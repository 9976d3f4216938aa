//! One declaration, two precisions.

use mech_runtime::Mechanism;

/// Declares a mechanism in `f64`, as [`mech_runtime::mechanism!`] does, and in a module `single` in `f32`. The declaration must not name a
/// precision.
macro_rules! mechanism {
    ($(#[$($attribute:tt)*])* $visibility:vis struct $mechanism:ident; $($body:tt)*) => {
        mech_runtime::mechanism! {
            $(#[$($attribute)*])*
            $visibility struct $mechanism: f64;
            $($body)*
        }

        /// The same in single precision.
        $visibility mod single {
            mech_runtime::mechanism! {
                $(#[$($attribute)*])*
                $visibility struct $mechanism: f32;
                $($body)*
            }
        }
    };
}

/// Makes a mechanism [`Exhibited`](crate::Exhibited) in both precisions, from its slug, the file where it stands and the function of its motor values.
macro_rules! exhibited {
    ($mechanism:ident, $slug:literal, $file:literal, $motion:ident) => {
        $crate::mechanisms::precisions::exhibited!(in f64: $mechanism, $slug, $file, $motion);
        $crate::mechanisms::precisions::exhibited!(in f32: single::$mechanism, $slug, $file, $motion);
    };
    (in $float:ident: $mechanism:path, $slug:literal, $file:literal, $motion:ident) => {
        impl $crate::Exhibited for $mechanism {
            const SLUG: &'static str = $slug;
            const FILE: &'static str = $file;
            const SOURCE: &'static str = include_str!($file);

            fn motion(phase: $float) -> Self::Motors {
                $motion(phase)
            }
        }
    };
}

pub(crate) use {exhibited, mechanism};

/// A mechanism of the gallery.
pub trait Exhibited: Mechanism {
    /// Its name in files and on the command line: `lower-case-with-hyphens`. The same in both precisions.
    const SLUG: &'static str;
    /// The name of the file that declares it.
    const FILE: &'static str;
    /// The Rust source that declares it, by a `mechanism!` that stands by itself.
    const SOURCE: &'static str;

    /// The values of its motors, in radians or scene units, at a phase in `0.0..1.0` of its motion: the same bits on every machine. The
    /// motion continues smoothly from the last phase to the first, and a little beyond.
    fn motion(phase: Self::Scalar) -> Self::Motors;
}
