//! The step that goes on to rates.

use super::block::scalar;
use super::scope::Scope;
use super::step::{Written, position, takes_sines};
use crate::program::{Motion, Op, Program, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// What a step finds of rates.
pub(super) struct Moved {
    /// The rates of all links.
    result: TokenStream,
    pub(super) margins: Vec<TokenStream>,
    pub(super) places: Vec<String>,
}

/// What a step finds of rates, in its own words.
pub(super) fn moved(motion: &Motion, scope: &Scope<'_>) -> Moved {
    let rates = |name: &TokenStream, all: &[[Value; 3]]| {
        let all = all.iter().map(|rates| {
            let [angular, x, y] = rates.map(|rate| scope.expression(rate));
            quote!(#name { angular: #angular, x: #x, y: #y })
        });
        quote!([#(#all),*])
    };
    let velocities = rates(&quote!(Velocity), &motion.velocities);
    let result = match &motion.accelerations {
        None => velocities,
        Some(accelerations) => {
            let accelerations = rates(&quote!(Acceleration), accelerations);
            quote!((#velocities, #accelerations))
        }
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

/// The rates of the motors, as variables.
pub(super) fn given_rates(program: &Program, scope: &mut Scope<'_>) -> TokenStream {
    let Some(motion) = &program.motion else {
        return TokenStream::new();
    };
    let mut variables = |op: fn(usize) -> Op, what: &str| -> Vec<Ident> {
        let variable = |(motor, name): (usize, &String)| {
            let mut live = program.live_values();
            match live.find(|&value| program.node(value).op == op(motor)) {
                Some(value) => {
                    let name = scope.fresh(&format!("{name}_{what}"));
                    scope.alias(value, name.clone());
                    name
                }
                None => scope.fresh(&format!("_{name}_{what}")),
            }
        };
        program.motors.iter().enumerate().map(variable).collect()
    };
    let rates = variables(Op::Rate, "rate");
    let mut tokens = quote!(let [#(#rates),*] = rates;);
    if motion.accelerations.is_some() {
        let accelerations = variables(Op::Acceleration, "acceleration");
        tokens.extend(quote!(let [#(#accelerations),*] = accelerations;));
    }
    tokens
}

/// The parameters for the rates of the motors, and these as arguments.
pub(super) fn given(program: &Program) -> [TokenStream; 2] {
    let (scalar, count) = (scalar(program), motors(program));
    let second = program
        .motion
        .as_ref()
        .is_some_and(|motion| motion.accelerations.is_some());
    if second {
        let parameters = quote!(rates: [#scalar; #count], accelerations: [#scalar; #count]);
        [parameters, quote!(rates, accelerations)]
    } else {
        [quote!(rates: [#scalar; #count]), quote!(rates)]
    }
}

fn motors(program: &Program) -> Literal {
    Literal::usize_unsuffixed(program.motors.len())
}

/// The type of the rates of all links.
fn rates_type(program: &Program) -> TokenStream {
    let (scalar, links) = (
        scalar(program),
        Literal::usize_unsuffixed(program.links.len()),
    );
    match &program.motion {
        Some(motion) if motion.accelerations.is_some() => {
            quote!(([Velocity<#scalar>; #links], [Acceleration<#scalar>; #links]))
        }
        _ => quote!([Velocity<#scalar>; #links]),
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
    let (position, scalar, found) = (position(program), scalar(program), rates_type(program));
    let [parameters, arguments] = given(program);
    let count = Literal::usize_unsuffixed(program.inputs());
    if !program.is_closed() {
        return quote! {
            /// The position at these motor values, close to the last one, and the rates of all links.
            fn step_with(#last: &#position, motors: Motors<#scalar, #count>, #parameters)
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
    let (sines, anywhere, near) = if takes_sines(program) {
        let near = quote! {
            /// The same, where all angles are within the range of the polynomials of sine and cosine.
            #[inline(always)]
            fn near_with(last: &#position, motors: Motors<#scalar, #count>, #parameters)
                -> Result<(#position, #found), Stop>
            {
                let (position, rates, margins, regular) = position_with::<Within>(last, motors, #arguments);
                closes(margins, [#(#places),*])?;
                determined(regular, [#(#rate_places),*])?;
                Ok((position, rates))
            }
        };
        (quote!(<S: Sines<#scalar>>), quote!(::<Anywhere>), near)
    } else {
        (TokenStream::new(), TokenStream::new(), TokenStream::new())
    };
    quote! {
        /// The position at these motor values, the rates of all links, and for each loop margins: if they are not negative, it
        /// closes, and its rates are determined.
        #[inline(always)]
        fn position_with #sines(#last: &#position, motors: Motors<#scalar, #count>, #parameters)
            -> (#position, #found, [#scalar; #loops], [#scalar; #regular_loops])
        {
            #motors
            #body
            (#result, #rates, [#(#margins),*], [#(#regular),*])
        }

        /// The position at these motor values and the rates of all links, if every loop closes there and its rates are
        /// determined.
        #[inline]
        fn step_with(last: &#position, motors: Motors<#scalar, #count>, #parameters)
            -> Result<(#position, #found), Stop>
        {
            let (position, rates, margins, regular) = position_with #anywhere(last, motors, #arguments);
            closes(margins, [#(#places),*])?;
            determined(regular, [#(#rate_places),*])?;
            Ok((position, rates))
        }

        #near
    }
}
