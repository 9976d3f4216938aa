//! The steps that compute sines and cosines by a type parameter: by polynomials of a reduced range, or for any angle.

use crate::emit::tokens::scalar;
use crate::program::{BlockKind, Op, Program, Value};
use proc_macro2::TokenStream;
use quote::quote;

/// The largest number of values for which straight blocks stand in the step itself. Beyond, each has its own function, because the
/// Rust compiler nests a scope for every `let`.
const MOST_IN_PLACE: usize = 256;

/// The largest number of blocks that are computed in lanes: more would be more code than it is worth.
const MOST_BLOCKS: usize = 32;

/// Whether straight blocks stand in the step itself.
pub(super) fn is_short(program: &Program) -> bool {
    let is_straight = |value: &Value| {
        let block = program.node(*value).block;
        matches!(program.ssa.blocks[block.index()].kind, BlockKind::Straight)
    };
    program.live_values().filter(is_straight).count() <= MOST_IN_PLACE
}

/// Whether many positions are computed in lanes: where each is a function of the motors alone, and not too long.
pub(in crate::emit) fn runs_in_lanes(program: &Program) -> bool {
    let of_motors_alone = program.is_function() && program.params.is_empty();
    of_motors_alone && takes_sines(program) && program.ssa.blocks.len() <= MOST_BLOCKS
}

/// Whether a step computes sines and cosines by a type parameter: where all of them stand in one function, and none is of an angle
/// that a param may make as large as it likes.
pub(in crate::emit) fn takes_sines(program: &Program) -> bool {
    !program.curved && program.is_closed() && is_short(program) && !turns_by_params(program)
}

/// The type parameter and the type argument of a step, if it takes them: `S`, for any angle.
pub(super) fn type_parameter(program: &Program) -> [Option<TokenStream>; 2] {
    let takes_sines = takes_sines(program);
    let scalar = scalar(program.precision);
    [takes_sines.then(|| quote!(<S: Sines<#scalar>>)), takes_sines.then(|| quote!(::<FullRange>))]
}

/// Whether a sine or cosine is of something that depends on a param.
fn turns_by_params(program: &Program) -> bool {
    if program.params.is_empty() {
        return false;
    }
    let dependent = program.depends_on_params();
    let is_dependent = |value: Value| match program.node(value).op {
        Op::Sin(angle) | Op::Cos(angle) => dependent[angle.index()],
        _ => false,
    };
    program.live_values().any(is_dependent)
}
