//! The modules of the generated code. Nothing of the user's crate is in scope there, so that no constant, macro or trait of theirs
//! can be met by what the functions of a program call their variables.

use crate::program::{Forces, Program};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// What the functions of a program call, and variants and unit structs, which a pattern would mean.
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

/// The types of what they take and give.
const TYPES: [&str; 15] = [
    "Acceleration",
    "Forces",
    "Holding",
    "Inertia",
    "Motors",
    "Pose",
    "Position",
    "Reaction",
    "Real",
    "Result",
    "Sines",
    "Stop",
    "Velocity",
    "f32",
    "f64",
];

/// What their functions and variables are called, whatever the mechanism.
const FIXED: [&str; 15] = [
    "accelerations",
    "before",
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

/// What neither a function nor a variable may be called that is named after something of the user's.
pub(super) fn taken_names() -> impl Iterator<Item = String> {
    CALLED.into_iter().chain(FIXED).map(str::to_owned)
}

/// The module in which the functions of a program stand.
pub(super) fn name(program: &Program) -> Ident {
    let name = if program.sensitivity.is_some() {
        "sensitivity"
    } else {
        match program.motion.as_ref().map(|motion| &motion.forces) {
            None => "positions",
            Some(None) => "rates",
            Some(Some(Forces::Holding(_))) => "holding",
            Some(Some(Forces::InverseDynamics(_))) => "acting",
            Some(Some(Forces::Inertia(_))) => "inertia",
        }
    };
    format_ident!("{}", name)
}

/// A module with functions of a program in it, and what they use.
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
