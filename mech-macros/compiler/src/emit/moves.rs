//! The methods that move a mechanism, and what they know beforehand.

use super::block::scalar;
use super::items::ending_with;
use super::many::reduced_range;
use super::module;
use super::params;
use super::scope::number;
use super::step::takes_sines;
use crate::bug::bug;
use crate::model::{JointKind, Model, Motor, Precision};
use crate::plan::Plan;
use crate::program::{self, Program};
use mech_core::journey::Growth;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The step for motor values within reach, and whatever a program finds besides.
pub(super) fn step_reduced(program: &Program) -> TokenStream {
    let module = module::name(program);
    if takes_sines(program) {
        quote!(#module::step_reduced)
    } else {
        quote!(#module::step)
    }
}

/// The same for any motor values.
pub(super) fn step_full(program: &Program) -> TokenStream {
    let module = module::name(program);
    quote!(#module::step)
}

/// The move to a target, and whatever this program finds there from these arguments besides.
pub(super) fn advance_with(
    program: &Program,
    position: &TokenStream,
    target: &TokenStream,
    arguments: &TokenStream,
) -> TokenStream {
    let (step_reduced, step_full) = (step_reduced(program), step_full(program));
    quote! {
        generated::advance_with(
            #position,
            #target,
            &known::MOVE_LIMITS,
            |last, motors| #step_reduced(last, motors #arguments),
            |last, motors| #step_full(last, motors #arguments),
            positions::step,
        )
    }
}

/// What is known about every move.
pub(super) fn limits(model: &Model, program: &Program, plan: &Plan) -> TokenStream {
    let scalar = scalar(program);
    let n = |value: &f64| number(program.precision, *value);
    let inputs: Vec<TokenStream> = inputs(model, program).collect();
    let watched = program.watches.iter().map(|watch| {
        let [sine, rounding_square] =
            [watch.sine, watch.rounding_square].map(Literal::usize_unsuffixed);
        let rates = watch.rates.iter().map(n);
        let iterated = watch.iterated;
        let at_zero = match watch.at_zero {
            program::AtZero::Stay => quote!(AtZero::Stay),
            program::AtZero::ChangeBranch => quote!(AtZero::ChangeBranch),
            program::AtZero::Stop => quote!(AtZero::Stop),
        };
        let closed = program.closed_form(watch.block).map(|closed| &closed.place);
        let newton = program.newton(watch.block).map(|newton| &newton.place);
        let Some(place) = closed.or(newton) else {
            bug!("a block is watched that closes no loop");
        };
        let growth = growth(program.precision, &watch.growth);
        let guessed = watch.guessed;
        quote! {
            Watched {
                sine: #sine,
                rounding_square: #rounding_square,
                rates: [#(#rates),*],
                growth: &[#(#growth),*],
                guessed: #guessed,
                at_zero: #at_zero,
                iterated: #iterated,
                place: #place,
            }
        }
    });
    let follows = program.follows.iter().map(|follow| {
        let rates = follow.rates.iter().map(n);
        let growth = growth(program.precision, &follow.growth);
        quote!(Followed { rates: [#(#rates),*], growth: &[#(#growth),*] })
    });
    let motion_signs = match program.layout.motion_signs {
        None => quote!(Option::None),
        Some(first) => {
            let first = Literal::usize_unsuffixed(first);
            quote!(Option::Some(#first))
        }
    };
    let overflows = program.overflows;
    let stepping = if program.is_function() {
        quote!(Stepping::Afresh)
    } else if program.subdivides() {
        quote!(Stepping::Subdivided)
    } else {
        quote!(Stepping::Onwards)
    };
    let reduced_range = if takes_sines(program) {
        number(program.precision, reduced_range(program, plan))
    } else {
        quote!(#scalar::MAX)
    };
    let max_steps = match &program.max_steps {
        None => quote!(Option::None),
        Some(max_steps) => {
            let max_steps = max_steps.iter().map(n);
            quote!(Option::Some([#(#max_steps),*]))
        }
    };
    let range = match &program.range {
        None => quote!(Option::None),
        Some(range) => {
            let ends = range.iter().map(|ends| {
                let [low, high] = ends.map(|end| bound(program.precision, end));
                quote!([#low, #high])
            });
            quote!(Option::Some([#(#ends),*]))
        }
    };
    let [motors, loops] = [inputs.len(), program.watches.len()].map(Literal::usize_unsuffixed);
    quote! {
        pub(super) const MOVE_LIMITS: MoveLimits<#scalar, #motors, #loops> = MoveLimits {
            inputs: &[#(#inputs),*],
            watched: [#(#watched),*],
            follows: &[#(#follows),*],
            motion_signs: #motion_signs,
            stepping: #stepping,
            overflows: #overflows,
            reduced_range: #reduced_range,
            max_steps: #max_steps,
            range: #range,
        };
    }
}

/// What moves are given: the motors, and after them the params.
fn inputs(model: &Model, program: &Program) -> impl Iterator<Item = TokenStream> {
    let motors = model.motors.iter().zip(&program.motors);
    let motors = motors.map(|(motor, name)| {
        if turns(model, motor) {
            quote!(Input::Turning(#name))
        } else {
            quote!(Input::Sliding(#name))
        }
    });
    let params = program
        .params
        .iter()
        .map(|name| quote!(Input::Param(#name)));
    motors.chain(params)
}

/// What makes something change faster.
fn growth(precision: Precision, growth: &[Growth<f64>]) -> impl Iterator<Item = TokenStream> + '_ {
    growth.iter().map(move |growth| match *growth {
        Growth::Near(index) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(Growth::Near(#index))
        }
        Growth::Far(input, unit) => {
            let (input, unit) = (Literal::usize_unsuffixed(input), number(precision, unit));
            quote!(Growth::Far(#input, #unit))
        }
    })
}

/// An end of a range; a motor without one has infinite ends.
fn bound(precision: Precision, end: f64) -> TokenStream {
    let scalar = match precision {
        Precision::F32 => quote!(f32),
        Precision::F64 => quote!(f64),
    };
    if end == f64::INFINITY {
        quote!(#scalar::INFINITY)
    } else if end == f64::NEG_INFINITY {
        quote!(#scalar::NEG_INFINITY)
    } else {
        number(precision, end)
    }
}

/// The methods of a mechanism that was proved to move through its ranges.
pub(super) fn within(
    program: &Program,
    visibility: &syn::Visibility,
    standstill: &TokenStream,
) -> TokenStream {
    if !program.never_fails() {
        return TokenStream::new();
    }
    let step_reduced = step_reduced(program);
    let scalar = scalar(program);
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let there = if takes_sines(program) {
        quote! {
            // Larger angles are reduced first.
            let there = if Motors::is_within(&target, known::MOVE_LIMITS.reduced_range) {
                #step_reduced(&self.position, target)
            } else {
                positions::step(&self.position, target)
            };
        }
    } else {
        quote!(let there = #step_reduced(&self.position, target);)
    };
    let body = quote! {
        let target = Motors::new(motors.motors());
        #there
        // It was proved that every loop closes there: there is nothing else.
        if let Result::Ok(there) = there {
            self.position = there;
        }
    };
    let (finite, where_unranged) = if program.overflows {
        let most = number(program.precision, program::MODERATE);
        (
            quote!(Motors::is_within(&values, #most)),
            " A motor without a range may go as step_full as 1e15.",
        )
    } else {
        (quote!(Motors::is_finite(&values)), "")
    };
    let about = format!(
        " These values of the motors, in radians or scene units, if all of them are within the declared ranges.{where_unranged}"
    );
    quote! {
        #[doc = #about]
        #[must_use]
        #visibility fn range(motors: [#scalar; #motors]) -> Option<InRange<Self, [#scalar; #motors]>> {
            let values = Motors::new(motors);
            (#finite && MoveLimits::contains(&known::MOVE_LIMITS, &values)).then_some(InRange::tested(motors))
        }

        /// Moves to values of the motors within their declared ranges: it was proved at compile time that nothing is in the
        /// way there, so this cannot fail.
        #[inline]
        #visibility fn move_within(&mut self, motors: InRange<Self, [#scalar; #motors]>) {
            #body
            #standstill
        }
    }
}

/// Whether a motor turns.
fn turns(model: &Model, motor: &Motor) -> bool {
    matches!(model.joint(motor.joint).kind, JointKind::Revolute(..))
}

/// How many motors turn, and how many slide.
pub(super) fn motor_counts(model: &Model) -> [usize; 2] {
    let turning = model.motors.iter().filter(|motor| turns(model, motor));
    let turning = turning.count();
    [turning, model.motors.len() - turning]
}

/// The method that takes phases, if a motor turns.
pub(super) fn turn_to(
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
    standstill: &TokenStream,
) -> TokenStream {
    let [turning, sliding] = motor_counts(model);
    if turning == 0 {
        return TokenStream::new();
    }
    let (step_reduced, refused) = (step_reduced(program), params::refused(program));
    let scalar = scalar(program);
    let literal = Literal::usize_unsuffixed;
    let (mut values, mut phases) = (Vec::new(), TokenStream::new());
    let (mut phase, mut slide) = ((0..).map(literal), (0..).map(literal));
    for ((index, motor), name) in model.motors.iter().enumerate().zip(&program.motors) {
        if turns(model, motor) {
            let (index, phase) = (literal(index), phase.next());
            phases.extend(quote! {
                if let Result::Err(stop) = Motors::turn(&mut target, #index, phases[#phase], #name) {
                    return Result::Err(#refused);
                }
            });
            values.push(quote!(0.0));
        } else {
            let slide = slide.next();
            values.push(quote!(slides[#slide]));
        }
    }
    let told = params::of_motors(
        program,
        quote!(generated::advance(&mut self.position, target, &known::MOVE_LIMITS, #step_reduced, positions::step)),
    );
    let advance = ending_with(told, standstill);
    let start = if program.params.is_empty() {
        quote!(Motors::new([#(#values),*]))
    } else {
        quote!(generated::inputs([#(#values),*], &self.position.motors))
    };
    let [motors, turning, counted] = [turning + sliding, turning, sliding].map(literal);
    let (slides, what) = if sliding == 0 {
        (
            TokenStream::new(),
            " The same with a phase for each motor: exact after any number of turns.",
        )
    } else {
        (
            quote!(, slides: [#scalar; #counted]),
            " The same with phases for the motors that turn, and values for those that slide: exact after any number of turns. Both are \
             in the order of their declaration.",
        )
    };
    quote! {
        #[doc = #what]
        ///
        /// # Errors
        /// If a value is not finite, a phase is beyond 2³¹ turns, or a loop cannot be closed on the way there; the mechanism
        /// then stays where it was.
        #visibility fn turn_to(&mut self, phases: [Phase; #turning] #slides) -> Result<(), Blocked<[#scalar; #motors]>> {
            let mut target = #start;
            #phases
            #advance
        }
    }
}
