//! The inputs of a step as parameters, arguments and variables.

use super::scope::Scope;
use super::stages::MOST_LETS;
use crate::emit::tokens::{integer, position, scalar};
use crate::model::{InputId, MotorId};
use crate::program::{Forces, Op, Program, Results};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The type of the motors that a step is given.
pub(super) fn motors_type(program: &Program) -> TokenStream {
    let (scalar, count) = (scalar(program.precision), integer(program.inputs()));
    quote!(Motors<#scalar, #count>)
}

/// All parameters of a step. `last` is its name for the last position.
pub(super) fn step_parameters(last: &TokenStream, program: &Program) -> TokenStream {
    let (position, motors) = (position(program), motors_type(program));
    let others = parameters(program);
    quote!(#last: &#position, motors: #motors #others)
}

/// The parameters of a step beyond its motors, with a comma before each.
pub(in crate::emit) fn parameters(program: &Program) -> TokenStream {
    let scalar = scalar(program.precision);
    let parameter = |array: Array| {
        let (name, count) = (array.name, integer(array.names.len()));
        quote!(, #name: [#scalar; #count])
    };
    arrays(program).into_iter().map(parameter).collect()
}

/// The arguments for these parameters, under the same names.
pub(in crate::emit) fn arguments(program: &Program) -> TokenStream {
    let names = arrays(program).into_iter().map(|array| array.name);
    names.map(|name| quote!(, #name)).collect()
}

/// The statements that read the inputs of a step.
pub(super) fn inputs(scope: &mut Scope<'_>) -> TokenStream {
    let (motors, arrays) = (motors(scope), read_arrays(scope));
    quote!(#motors #arrays)
}

/// The statements that read the motors: for each its value, and where something needs them its whole turns.
fn motors(scope: &mut Scope<'_>) -> TokenStream {
    let program = scope.program;
    let scalar = scalar(program.precision);
    let variable =
        |(motor, name): (usize, &String)| match scope.value_of(Op::Input(InputId::new(motor))) {
            Some(value) => scope.bind(value),
            None => scope.fresh(&format!("_{name}")),
        };
    let variables: Vec<Ident> = program.input_names().enumerate().map(variable).collect();
    let mut tokens = TokenStream::new();
    let mut motors = format_ident!("motors");
    if program.reduces() {
        motors = scope.fresh("reduced");
        let turning = &program.reduced;
        tokens.extend(quote!(let #motors = motors.reduced(&[#(#turning),*]);));
    }
    tokens.extend(quote!(let [#(#variables),*] = #motors.values;));
    let (mut names, mut turns) = (Vec::new(), Vec::new());
    for value in program.live_values() {
        turns.push(match program.node(value).op {
            Op::Turns(motor) => {
                let motor = integer(motor.index());
                quote!(<#scalar as Real>::from_i32(#motors.turns[#motor]))
            }
            Op::PartOfTurns(motor, numerator, denominator) => {
                let motor = integer(motor.index());
                let [numerator, denominator] =
                    [numerator, denominator].map(Literal::i64_unsuffixed);
                quote!(turned::<#scalar>(#motors.turns[#motor], #numerator, #denominator))
            }
            _ => continue,
        });
        names.push(scope.bind(value));
    }
    if names.len() <= MOST_LETS / 2 {
        tokens.extend(quote!(#(let #names = #turns;)*));
    } else {
        tokens.extend(quote!(let [#(#names),*] = [#(#turns),*];));
    }
    tokens
}

/// A parameter of a step beyond its motors: an array of numbers.
struct Array {
    name: Ident,
    /// The names of its numbers.
    names: Vec<String>,
    /// The operation that reads one.
    op: fn(usize) -> Op,
}

/// The parameters of a step beyond its motors.
fn arrays(program: &Program) -> Vec<Array> {
    let array = |name: &str, names: Vec<String>, op: fn(usize) -> Op| Array {
        name: format_ident!("{name}"),
        names,
        op,
    };
    let of_motors = |what: &str| -> Vec<String> {
        let names = program.motors.iter();
        names.map(|name| format!("{name}_{what}")).collect()
    };
    let rates = || array("rates", of_motors("rate"), |motor| Op::Rate(MotorId::new(motor)));
    let accelerations = || {
        let names = of_motors("acceleration");
        array("accelerations", names, |motor| Op::Acceleration(MotorId::new(motor)))
    };
    match program.results() {
        None | Some(Results::Sensitivity(_)) => Vec::new(),
        Some(Results::Rates(found)) if found.accelerations.is_some() => {
            vec![rates(), accelerations()]
        }
        Some(Results::Rates(_)) => vec![rates()],
        Some(Results::Forces { forces, loads }) => {
            let mut arrays = match forces {
                Forces::Holding(_) => Vec::new(),
                Forces::InverseDynamics(_) => vec![rates(), accelerations()],
                Forces::Inertia(_) => vec![rates()],
            };
            if !loads.is_empty() {
                arrays.push(array("loads", loads.clone(), Op::Load));
            }
            arrays
        }
    }
}

/// The statements that read these parameters.
fn read_arrays(scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for Array { name, names, op } in arrays(scope.program) {
        let variable = |(number, wanted): (usize, &String)| match scope.value_of(op(number)) {
            Some(value) => {
                let name = scope.fresh(wanted);
                scope.alias(value, name.clone());
                name
            }
            None => scope.fresh(&format!("_{wanted}")),
        };
        let variables: Vec<Ident> = names.iter().enumerate().map(variable).collect();
        tokens.extend(quote!(let [#(#variables),*] = #name;));
    }
    tokens
}
