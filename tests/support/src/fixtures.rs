//! Mechanisms that several tests use.

use crate::{bodies, folder, models};
use mech_compiler::model::Model;
use proc_macro2::TokenStream;

macro_rules! gallery {
    ($($name:literal),*) => {
        [$(($name, include_str!(concat!("../../../examples/gallery/src/mechanisms/", $name, ".rs")))),*]
    };
}

/// Names and sources of the gallery's mechanisms.
pub const GALLERY: [(&str, &str); 6] =
    gallery!["andrews", "four_bar", "geared_piston", "jansen", "rocker_arm", "watt"];

/// The gallery's mechanisms and the zoo's, which the tests expand too.
#[must_use]
pub fn known() -> Vec<Model> {
    sources().flat_map(|source| models(&source)).collect()
}

/// Their texts.
#[must_use]
pub fn known_texts() -> Vec<TokenStream> {
    sources().flat_map(|source| bodies(&source)).collect()
}

fn sources() -> impl Iterator<Item = String> {
    let gallery = GALLERY.map(|(_, source)| source.to_owned()).into_iter();
    let zoo = folder("../tests/subjects/zoo").into_iter();
    gallery.chain(zoo.map(|case| case.text))
}

/// Those with params, which the tests expand too.
#[must_use]
pub fn with_own_params() -> Vec<Model> {
    let texts = folder("../tests/subjects/changed").into_iter();
    texts.flat_map(|case| models(&case.text)).collect()
}

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
