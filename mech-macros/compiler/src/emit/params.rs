//! What params add: the methods that tell and set them, and where points are that depend on them. Inside, a param is an input after
//! the motors; outside, motors and params are apart.

use super::block::scalar;
use super::items::{rested, user_ident};
use super::moves::near;
use super::scope::{ident, number};
use crate::model::{Axis, Formula, FormulaId, Model};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The target of a move to values of the motors, with the params as they are at this position.
pub(super) fn target(program: &Program, position: &TokenStream) -> TokenStream {
    if program.params.is_empty() {
        quote!(Motors::new(motors))
    } else {
        quote!(inputs(motors, &#position.motors))
    }
}

/// The result of a move, as it is told outside.
pub(super) fn told(program: &Program, result: TokenStream) -> TokenStream {
    if program.params.is_empty() {
        result
    } else {
        quote!(#result.map_err(told))
    }
}

/// The message that a mechanism stays where it is, as it is told outside.
pub(super) fn refused(program: &Program) -> TokenStream {
    if program.params.is_empty() {
        quote!(self.position.refuse(stop))
    } else {
        quote!(told(self.position.refuse(stop)))
    }
}

/// The values of the motors among all that is given.
pub(super) fn motors(program: &Program) -> TokenStream {
    if program.params.is_empty() {
        quote!(self.position.motors.total())
    } else {
        quote!(motors_of(self.position.motors.total()))
    }
}

/// What the generated code uses besides.
pub(super) fn imports(krate: &TokenStream, program: &Program, rates: bool) -> TokenStream {
    if program.params.is_empty() {
        return TokenStream::new();
    }
    // Velocities bring these with them.
    let of_rates = (!rates).then(|| quote!(Vector2, Velocity, determined,));
    quote! {
        #[allow(unused_imports, reason = "which of them a mechanism needs depends on what it is made of")]
        use #krate::generated::{
            #of_rates followed, inputs, motors_of, params_of, reached_by_motors, told,
        };
    }
}

/// The methods that tell and set params; nothing without any.
pub(super) fn methods(
    places: &Places,
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
    rest: &TokenStream,
) -> TokenStream {
    if program.params.is_empty() {
        return TokenStream::new();
    }
    let (scalar, near) = (scalar(program), near(program));
    let (motors, names) = (program.motors.len(), &program.params);
    let count = Literal::usize_unsuffixed(names.len());
    let index = |param: usize| Literal::usize_unsuffixed(motors + param);
    let set = rested(
        quote!(advance(&mut self.position, target, &COURSE, #near, step).map_err(|blocked| blocked.map(params_of))),
        rest,
    );
    let given = (0..names.len()).map(|param| {
        let (place, param) = (index(param), Literal::usize_unsuffixed(param));
        quote!(target.values[#place] = params[#param];)
    });
    let mut tokens = quote! {
        /// The names of the params, in the order of their declaration.
        #visibility const PARAMS: [&'static str; #count] = [#(#names),*];

        /// The present values of the params, in the order of their declaration.
        #[must_use]
        #visibility fn params(&self) -> [#scalar; #count] {
            params_of(self.position.motors.values)
        }

        /// Gives the params these values, in the order of their declaration, and assembles everything anew by a continuous change
        /// from where it is; the motors stay where they are.
        ///
        /// # Errors
        /// If a value is not finite, or a loop cannot be closed on the way there: then with the params up to which it could have
        /// gone. The mechanism then stays as it was.
        #visibility fn set_params(&mut self, params: [#scalar; #count]) -> Result<(), Blocked<[#scalar; #count]>> {
            let mut target = self.position.motors;
            #(#given)*
            #set
        }
    };
    for (number, param) in model.params.all().iter().enumerate() {
        let index = index(number);
        let get = user_ident(&param.name, places, param.origin);
        let set = user_ident(&format!("set_{}", param.name), places, param.origin);
        let told = format!(" The present value of param `{}`.", param.name);
        let sets = format!(
            " Gives param `{}` this value and assembles everything anew by a continuous change from where it is; the motors stay \
             where they are.",
            param.name
        );
        let moved = rested(
            quote! {
                advance(&mut self.position, target, &COURSE, #near, step)
                    .map_err(|blocked| blocked.map(|reached| reached[#index]))
            },
            rest,
        );
        tokens.extend(quote! {
            #[doc = #told]
            #[must_use]
            #visibility const fn #get(&self) -> #scalar {
                self.position.motors.values[#index]
            }

            #[doc = #sets]
            ///
            /// # Errors
            /// If the value is not finite, or a loop cannot be closed on the way there: then with the value up to which it could
            /// have gone. The mechanism then stays as it was.
            #visibility fn #set(&mut self, value: #scalar) -> Result<(), Blocked<#scalar>> {
                let mut target = self.position.motors;
                target.values[#index] = value;
                #moved
            }
        });
    }
    tokens
}

/// Where an axis is in its link, as an array: an expression inside a method.
pub(super) fn place(model: &Model, axis: &Axis) -> TokenStream {
    let n = |value: f64| number(model.precision, value);
    if !axis.varies() {
        let [x, y] = axis.at.map(n);
        return quote!([#x, #y]);
    }
    let wanted: Vec<FormulaId> = axis.formulas.iter().flatten().copied().collect();
    let formulas = model.params.needed(&wanted);
    let used = |name: &Ident, param: usize| {
        let reads = |(_, formula): &(FormulaId, Formula)| matches!(formula, Formula::Param(id) if id.index() == param);
        if formulas.iter().any(reads) {
            quote!(#name)
        } else {
            quote!(_)
        }
    };
    let names: Vec<Ident> = model
        .params
        .all()
        .iter()
        .map(|param| ident(&param.name))
        .collect();
    let params = names
        .iter()
        .enumerate()
        .map(|(param, name)| used(name, param));
    let mut known: Vec<(FormulaId, TokenStream)> = Vec::new();
    let mut lets = TokenStream::new();
    for (id, formula) in formulas.iter().copied() {
        let get = |id: FormulaId| {
            let found = known.iter().find(|(known, _)| *known == id);
            found.map_or_else(TokenStream::new, |(_, tokens)| tokens.clone())
        };
        let made = match formula {
            Formula::Constant(value) => {
                let value = n(value);
                known.push((id, value));
                continue;
            }
            Formula::Param(param) => {
                let name = &names[param.index()];
                known.push((id, quote!(#name)));
                continue;
            }
            Formula::Neg(a) => {
                let a = get(a);
                quote!(-#a)
            }
            Formula::Add(a, b) => infix(&get(a), &quote!(+), &get(b)),
            Formula::Sub(a, b) => infix(&get(a), &quote!(-), &get(b)),
            Formula::Mul(a, b) => infix(&get(a), &quote!(*), &get(b)),
            Formula::Div(a, b) => infix(&get(a), &quote!(/), &get(b)),
            Formula::Sqrt(a) => {
                let a = get(a);
                quote!(sqrt(#a))
            }
            Formula::Sin(a) => {
                let a = get(a);
                quote!(sin_cos(#a).0)
            }
            Formula::Cos(a) => {
                let a = get(a);
                quote!(sin_cos(#a).1)
            }
        };
        let name = part_name(&names, known.len());
        lets.extend(quote!(let #name = #made;));
        known.push((id, quote!(#name)));
    }
    let [x, y] = [0, 1].map(|part| {
        let found = axis.formulas[part].and_then(|id| known.iter().find(|(known, _)| *known == id));
        found.map_or_else(|| n(axis.at[part]), |(_, tokens)| tokens.clone())
    });
    quote!({
        let [#(#params),*] = self.params();
        #lets
        [#x, #y]
    })
}

fn infix(a: &TokenStream, sign: &TokenStream, b: &TokenStream) -> TokenStream {
    quote!(#a #sign #b)
}

/// A name that no param has.
fn part_name(params: &[Ident], number: usize) -> Ident {
    let mut name = format_ident!("part_{}", number, span = proc_macro2::Span::mixed_site());
    while params.iter().any(|param| *param == name) {
        name = format_ident!("{}_", name, span = proc_macro2::Span::mixed_site());
    }
    name
}
