//! The step that goes on to rates.

use super::block::scalar;
use super::scope::Scope;
use super::step::{Written, position, takes_sines};
use crate::program::{Forces, Motion, Op, Program, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// What a step finds of rates.
pub(super) struct Moved {
    /// The rates of all links.
    result: TokenStream,
    pub(super) margins: Vec<TokenStream>,
    pub(super) places: Vec<String>,
}

/// What a step finds of rates or forces, in its own words.
pub(super) fn moved(motion: &Motion, scope: &Scope<'_>) -> Moved {
    let result = match &motion.forces {
        None => rates(motion, scope),
        Some(forces) => self::forces(forces, scope),
    };
    let margins = motion.margins.iter();
    let (margins, places) = margins
        .map(|margin| (scope.expression(margin.margin), margin.place.clone()))
        .unzip();
    Moved {
        result,
        margins,
        places,
    }
}

fn rates(motion: &Motion, scope: &Scope<'_>) -> TokenStream {
    let rates = |name: &TokenStream, all: &[[Value; 3]]| {
        let all = all.iter().map(|rates| {
            let [angular, x, y] = rates.map(|rate| scope.expression(rate));
            quote!(#name { angular: #angular, x: #x, y: #y })
        });
        quote!([#(#all),*])
    };
    let velocities = rates(&quote!(Velocity), &motion.velocities);
    match &motion.accelerations {
        None => velocities,
        Some(accelerations) => {
            let accelerations = rates(&quote!(Acceleration), accelerations);
            quote!((#velocities, #accelerations))
        }
    }
}

fn forces(forces: &Forces<Value>, scope: &Scope<'_>) -> TokenStream {
    let row = |values: &Vec<Value>| {
        let values = values.iter().map(|&value| scope.expression(value));
        quote!([#(#values),*])
    };
    match forces {
        Forces::Holding(torques) => {
            let torques = row(torques);
            quote!(Holding { torques: #torques })
        }
        Forces::InverseDynamics(inverse_dynamics) => {
            let (torques, transmission) = (
                row(&inverse_dynamics.torques),
                row(&inverse_dynamics.transmission),
            );
            let velocity_ratios = inverse_dynamics.velocity_ratios.iter().map(row);
            let reactions = inverse_dynamics.reactions.iter().map(|reaction| {
                let [x, y, torque] = reaction.map(|part| scope.expression(part));
                quote!(Reaction { x: #x, y: #y, torque: #torque })
            });
            quote! {
                Forces {
                    torques: #torques,
                    reactions: [#(#reactions),*],
                    velocity_ratios: [#(#velocity_ratios),*],
                    transmission: #transmission,
                }
            }
        }
        Forces::Inertia(inertia) => {
            let (matrix, drive) = (inertia.matrix.iter().map(row), row(&inertia.drive));
            let [kinetic, potential] = inertia.energy.map(|part| scope.expression(part));
            quote! {
                Inertia { matrix: [#(#matrix),*], drive: #drive, kinetic: #kinetic, potential: #potential }
            }
        }
    }
}

/// Something that a step is given besides the motors' values: a name for it, how many numbers it has, what each is called, and the
/// operation that reads it.
struct Given {
    name: Ident,
    names: Vec<String>,
    op: fn(usize) -> Op,
}

impl Given {
    fn new(name: &str, names: Vec<String>, op: fn(usize) -> Op) -> Self {
        Self {
            name: format_ident!("{}", name),
            names,
            op,
        }
    }
}

/// What a step is given besides the motors' values.
fn all_given(program: &Program) -> Vec<Given> {
    let Some(motion) = program
        .motion
        .as_ref()
        .filter(|_| program.sensitivity.is_none())
    else {
        return Vec::new();
    };
    let of_motors = |what: &str| -> Vec<String> {
        let names = program.motors.iter();
        names.map(|name| format!("{name}_{what}")).collect()
    };
    let rates = || Given::new("rates", of_motors("rate"), Op::Rate);
    let accelerations = || Given::new("accelerations", of_motors("acceleration"), Op::Acceleration);
    let mut given = match &motion.forces {
        None if motion.accelerations.is_none() => vec![rates()],
        None | Some(Forces::InverseDynamics(_)) => vec![rates(), accelerations()],
        Some(Forces::Holding(_)) => Vec::new(),
        Some(Forces::Inertia(_)) => vec![rates()],
    };
    if !motion.loads.is_empty() {
        given.push(Given::new("loads", motion.loads.clone(), Op::Load));
    }
    given
}

/// What a step is given besides the motors' values, as variables.
pub(super) fn given_rates(program: &Program, scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for Given { name, names, op } in all_given(program) {
        let variable = |(number, wanted): (usize, &String)| {
            let mut live = program.live_values();
            match live.find(|&value| program.node(value).op == op(number)) {
                Some(value) => {
                    let name = scope.fresh(wanted);
                    scope.alias(value, name.clone());
                    name
                }
                None => scope.fresh(&format!("_{wanted}")),
            }
        };
        let variables: Vec<Ident> = names.iter().enumerate().map(variable).collect();
        tokens.extend(quote!(let [#(#variables),*] = #name;));
    }
    tokens
}

/// The parameters for what a step is given besides the motors' values, and these as arguments: each with a comma before it.
pub(super) fn given(program: &Program) -> [TokenStream; 2] {
    let scalar = scalar(program);
    let all = all_given(program);
    let parameters = all.iter().map(|Given { name, names, .. }| {
        let count = Literal::usize_unsuffixed(names.len());
        quote!(, #name: [#scalar; #count])
    });
    let arguments = all.iter().map(|Given { name, .. }| quote!(, #name));
    [parameters.collect(), arguments.collect()]
}

/// The type of what is found besides a position, and what it is.
pub(super) fn found(program: &Program) -> (TokenStream, &'static str) {
    let scalar = scalar(program);
    let literal = Literal::usize_unsuffixed;
    let (links, motors) = (literal(program.links.len()), literal(program.motors.len()));
    match program
        .motion
        .as_ref()
        .map(|motion| (&motion.forces, motion.accelerations.is_some()))
    {
        Some((None, true)) => (
            quote!(([Velocity<#scalar>; #links], [Acceleration<#scalar>; #links])),
            "the rates of all links",
        ),
        None | Some((None, false)) => (
            quote!([Velocity<#scalar>; #links]),
            "the rates of all links",
        ),
        Some((Some(Forces::Holding(_)), _)) => {
            (quote!(Holding<#scalar, #motors>), "what holds it there")
        }
        Some((Some(Forces::InverseDynamics(inverse_dynamics)), _)) => {
            // One row for each motor, and there is one at least.
            let loads = inverse_dynamics.velocity_ratios[0].len();
            let sizes = [
                inverse_dynamics.reactions.len(),
                loads,
                inverse_dynamics.transmission.len(),
            ]
            .map(literal);
            (
                quote!(Forces<#scalar, #motors, #(#sizes),*>),
                "the forces in it",
            )
        }
        Some((Some(Forces::Inertia(_)), _)) => (
            quote!(Inertia<#scalar, #motors>),
            "its inertia as the motors feel it",
        ),
    }
}

/// The steps that go on to rates.
pub(super) fn step_with(
    program: &Program,
    written: &Written,
    places: &[&String],
    moved: &Moved,
) -> TokenStream {
    let Written {
        motors,
        body,
        last,
        result,
        margins,
    } = written;
    let Moved {
        result: rates,
        margins: regular,
        places: rate_places,
    } = moved;
    let (position, scalar, (found, what)) = (position(program), scalar(program), found(program));
    let [parameters, arguments] = given(program);
    let count = Literal::usize_unsuffixed(program.inputs());
    if !program.is_closed() {
        let doc =
            format!(" The position at these motor values, close to the last one, and {what}.");
        return quote! {
            #[doc = #doc]
            pub(super) fn step(#last: &#position, motors: Motors<#scalar, #count> #parameters)
                -> Result<(#position, #found), Stop>
            {
                #motors
                #body
                determined([#(#regular),*], [#(#rate_places),*])?;
                Ok((#result, #rates))
            }
        };
    }
    let [loops, regular_loops] = [margins.len(), regular.len()].map(Literal::usize_unsuffixed);
    let (sines, anywhere, step_reduced) = if takes_sines(program) {
        let step_reduced = quote! {
            /// The same, where all angles are within the range of the polynomials of sine and cosine.
            #[inline(always)]
            pub(super) fn step_reduced(last: &#position, motors: Motors<#scalar, #count> #parameters)
                -> Result<(#position, #found), Stop>
            {
                let (position, rates, margins, regular) = position::<Reduced>(last, motors #arguments);
                closes(margins, [#(#places),*])?;
                determined(regular, [#(#rate_places),*])?;
                Ok((position, rates))
            }
        };
        (
            quote!(<S: Sines<#scalar>>),
            quote!(::<FullRange>),
            step_reduced,
        )
    } else {
        (TokenStream::new(), TokenStream::new(), TokenStream::new())
    };
    let doc = format!(
        " The position at these motor values, {what}, and for each loop margins: if they are not negative, it"
    );
    let result_doc = format!(
        " The position at these motor values and {what}, if every loop closes there and its rates are"
    );
    quote! {
        #[doc = #doc]
        /// closes, and its rates are determined.
        #[inline(always)]
        fn position #sines(#last: &#position, motors: Motors<#scalar, #count> #parameters)
            -> (#position, #found, [#scalar; #loops], [#scalar; #regular_loops])
        {
            #motors
            #body
            (#result, #rates, [#(#margins),*], [#(#regular),*])
        }

        #[doc = #result_doc]
        /// determined.
        #[inline]
        pub(super) fn step(last: &#position, motors: Motors<#scalar, #count> #parameters)
            -> Result<(#position, #found), Stop>
        {
            let (position, rates, margins, regular) = position #anywhere(last, motors #arguments);
            closes(margins, [#(#places),*])?;
            determined(regular, [#(#rate_places),*])?;
            Ok((position, rates))
        }

        #step_reduced
    }
}
