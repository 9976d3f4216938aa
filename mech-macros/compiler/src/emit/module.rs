//! The modules in which the functions of programs stand. Nothing of the user's crate is in scope there, so no constant, macro or trait
//! of theirs collides with a variable.

use crate::program::{Forces, Program, Results};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The names that no variable may have: of functions that a program calls, and of variants and unit structs. A variable of such a name
/// would be a pattern.
const CALLED: [&str; 20] = [
    "FullRange",
    "Err",
    "None",
    "Ok",
    "Some",
    "Reduced",
    "atan2",
    "before_first",
    "closed",
    "closes",
    "contracts",
    "determined",
    "exp",
    "followed",
    "max",
    "round",
    "sin_cos",
    "solve",
    "sqrt",
    "turned",
];

/// The types of arguments and results.
const TYPES: [&str; 17] = [
    "Acceleration",
    "Forces",
    "Holding",
    "Inertia",
    "MotionLaw",
    "Motors",
    "Pose",
    "Position",
    "Reaction",
    "Real",
    "Result",
    "Sines",
    "Staircase",
    "Stop",
    "Velocity",
    "f32",
    "f64",
];

/// The names of functions and variables that do not depend on the mechanism.
const FIXED: [&str; 16] = [
    "accelerations",
    "before",
    "is_last",
    "last",
    "laws",
    "loads",
    "margins",
    "motors",
    "step_reduced",
    "position",
    "rates",
    "rates_by_params",
    "regular",
    "rounds",
    "sensitivity",
    "step",
];

/// The names that no function or variable may have that is named after something of the user's.
pub(super) fn taken_names() -> impl Iterator<Item = String> {
    CALLED.into_iter().chain(FIXED).map(str::to_owned)
}

/// The name of a program's module.
pub(super) fn name(program: &Program) -> Ident {
    let name = match program.results() {
        None => "positions",
        Some(Results::Rates(_)) => "rates",
        Some(Results::Sensitivity(_)) => "sensitivity",
        Some(Results::Forces { forces, .. }) => match forces {
            Forces::Holding(_) => "holding",
            Forces::InverseDynamics(_) => "acting",
            Forces::Inertia(_) => "inertia",
        },
    };
    format_ident!("{}", name)
}

/// A module with the functions of a program, and the imports that they need.
pub(super) fn module(krate: &TokenStream, name: &Ident, functions: &TokenStream) -> TokenStream {
    let names = CALLED.into_iter().chain(TYPES);
    let names = names.map(|name| format_ident!("{}", name));
    quote! {
        mod #name {
            #[allow(unused_imports, reason = "which of them a mechanism needs depends on what it is made of")]
            use #krate::generated::{#(#names),*};

            #functions
        }
    }
}
