//! The step functions of positions, rates and forces.

use super::inputs::{arguments, step_parameters};
use super::outcome::Outcome;
use super::scope::Scope;
use super::sines::{takes_sines, type_parameter};
use crate::emit::tokens::{integer, position, scalar};
use crate::program::Program;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The parts of a step.
pub(super) struct StepParts<'p> {
    /// The parameter for the last position: `_` if nothing reads it.
    pub(super) last: TokenStream,
    /// The statements that read the inputs and compute everything.
    pub(super) statements: TokenStream,
    /// The new position.
    pub(super) position: TokenStream,
    /// The margins by which loops close.
    pub(super) margins: Margins<'p>,
    /// The margins by which rates are determined.
    pub(super) rate_margins: Margins<'p>,
}

/// Numbers that are negative where a loop fails, and what the loops are called.
pub(super) struct Margins<'p> {
    values: Vec<TokenStream>,
    places: Vec<&'p str>,
    /// The variable that holds all of them, if there is one.
    array: Option<Ident>,
}

impl<'p> FromIterator<(TokenStream, &'p str)> for Margins<'p> {
    fn from_iter<I: IntoIterator<Item = (TokenStream, &'p str)>>(margins: I) -> Self {
        let (values, places) = margins.into_iter().unzip();
        Self { values, places, array: None }
    }
}

impl Margins<'_> {
    /// The same margins, kept in a variable that is an array.
    pub(super) fn in_array(self, array: &Ident) -> Self {
        Self { array: Some(array.clone()), ..self }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The margins as an array.
    fn array(&self) -> TokenStream {
        if let Some(array) = &self.array {
            return quote!(#array);
        }
        let values = &self.values;
        quote!([#(#values),*])
    }

    /// The type of the array.
    fn kind(&self, scalar: &TokenStream) -> TokenStream {
        let count = integer(self.values.len());
        quote!([#scalar; #count])
    }

    /// The statement by which `test` returns an error for the first loop whose margin is negative.
    fn check(&self, test: &TokenStream, margins: &TokenStream) -> TokenStream {
        let places = &self.places;
        quote!(#test(#margins, [#(#places),*])?;)
    }

    /// The statement that tests these margins where they are computed.
    pub(super) fn check_here(&self, test: &TokenStream) -> TokenStream {
        self.check(test, &self.array())
    }
}

/// The results of a function.
#[derive(Default)]
struct Results {
    kinds: Vec<TokenStream>,
    values: Vec<TokenStream>,
    /// The variables to which a caller binds them.
    names: Vec<Ident>,
}

impl Results {
    fn push(&mut self, kind: TokenStream, value: TokenStream, name: &str) {
        self.kinds.push(kind);
        self.values.push(value);
        self.names.push(format_ident!("{name}"));
    }
}

/// A tuple; one element stands for itself.
fn tuple<T: ToTokens>(elements: &[T]) -> TokenStream {
    if let [element] = elements { quote!(#element) } else { quote!((#(#elements),*)) }
}

/// The functions of a step: `step`, and for steps in closed form `position` and `step_reduced`.
pub(super) fn step_functions(parts: &StepParts<'_>, scope: &Scope<'_>) -> TokenStream {
    let outcome = Outcome::of(scope);
    let mut results = Results::default();
    results.push(position(scope.program), parts.position.clone(), "position");
    let what = outcome.as_ref().map(|outcome| outcome.what);
    if let Some(outcome) = outcome {
        results.push(outcome.kind, outcome.value, "rates");
    }
    if scope.program.is_closed() {
        closed_step(parts, results, what, scope)
    } else {
        iterated_step(parts, &results, what, scope.program)
    }
}

/// The function `position` by itself.
pub(super) fn lanes_function(parts: &StepParts<'_>, program: &Program) -> TokenStream {
    let (StepParts { last, statements, margins, .. }, scalar) = (parts, scalar(program.precision));
    let mut results = Results::default();
    results.push(position(program), parts.position.clone(), "position");
    results.push(margins.kind(&scalar), margins.array(), "margins");
    let Results { kinds, values, .. } = results;
    let parameters = step_parameters(last, program);
    let [sines, _] = type_parameter(program);
    quote! {
        /// The position at these motor values, and for each loop a margin: many are computed at once.
        #[inline(always)]
        pub(super) fn position #sines(#parameters) -> (#(#kinds),*) {
            #statements
            (#(#values),*)
        }
    }
}

/// The function of a step with iterations in it.
fn iterated_step(
    parts: &StepParts<'_>,
    results: &Results,
    what: Option<&str>,
    program: &Program,
) -> TokenStream {
    let parameters = step_parameters(&parts.last, program);
    let statements = &parts.statements;
    let what = what.map_or_else(String::new, |what| format!(", and {what}"));
    let doc = format!(" The position at these motor values, close to the last one{what}.");
    let determined =
        program.derived.is_some().then(|| parts.rate_margins.check_here(&quote!(determined)));
    let (kind, value) = (tuple(&results.kinds), tuple(&results.values));
    quote! {
        #[doc = #doc]
        pub(super) fn step(#parameters) -> Result<#kind, Stop> {
            #statements
            #determined
            Ok(#value)
        }
    }
}

/// The functions of a step whose loops are all in closed form: `position` computes whether or not they close, and the others test.
fn closed_step(
    parts: &StepParts<'_>,
    mut results: Results,
    what: Option<&str>,
    scope: &Scope<'_>,
) -> TokenStream {
    let program = scope.program;
    let StepParts { last, statements, margins, rate_margins, .. } = parts;
    let (scalar, arguments) = (scalar(program.precision), arguments(program));
    let [own, parameters] = [last, &quote!(last)].map(|last| step_parameters(last, program));
    let (kind, found) = (tuple(&results.kinds), tuple(&results.names));
    results.push(margins.kind(&scalar), margins.array(), "margins");
    let closes = margins.check(&quote!(closes), &quote!(margins));
    let determined = what.map(|_| {
        results.push(rate_margins.kind(&scalar), rate_margins.array(), "regular");
        rate_margins.check(&quote!(determined), &quote!(regular))
    });
    let Results { kinds, values, names } = results;
    let body = |sines: Option<TokenStream>| {
        quote! {
            let (#(#names),*) = position #sines(last, motors #arguments);
            #closes
            #determined
            Ok(#found)
        }
    };
    let (position_docs, step_docs) = docs(what);
    let [sines, full_range] = type_parameter(program);
    let access = match what {
        None => quote!(pub(super)),
        Some(_) => TokenStream::new(),
    };
    // A function with loops is long: where an angle is beyond the usual range, a call costs little beside it.
    let inline = if scope.has_arrays() && takes_sines(program) {
        quote!(inline(never))
    } else {
        quote!(inline)
    };
    let inline_reduced = if what.is_none() { quote!(inline) } else { quote!(inline(always)) };
    let step_reduced = takes_sines(program).then(|| {
        let body = body(Some(quote!(::<Reduced>)));
        quote! {
            /// The same, where all angles are within the range of the polynomials of sine and cosine.
            #[#inline_reduced]
            pub(super) fn step_reduced(#parameters) -> Result<#kind, Stop> {
                #body
            }
        }
    });
    let body = body(full_range);
    quote! {
        #(#[doc = #position_docs])*
        #[inline(always)]
        #access fn position #sines(#own) -> (#(#kinds),*) {
            #statements
            (#(#values),*)
        }

        #(#[doc = #step_docs])*
        #[#inline]
        pub(super) fn step(#parameters) -> Result<#kind, Stop> {
            #body
        }

        #step_reduced
    }
}

/// The documentation of `position` and of `step`, line by line.
fn docs(what: Option<&str>) -> (Vec<String>, Vec<String>) {
    let (position, step) = match what {
        None => (
            " The position at these motor values, and for each loop a margin: it closes if that is not negative.".to_owned(),
            " The position at these motor values, if every loop closes there.".to_owned(),
        ),
        Some(what) => (
            format!(" The position at these motor values, {what}, and for each loop margins: if they are not negative, it\n closes, and its rates are determined."),
            format!(" The position at these motor values and {what}, if every loop closes there and its rates are\n determined."),
        ),
    };
    let lines = |text: String| text.lines().map(str::to_owned).collect();
    (lines(position), lines(step))
}
