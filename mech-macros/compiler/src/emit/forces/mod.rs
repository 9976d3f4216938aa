//! What the struct of a mechanism has more if forces were asked for.

mod actions;
mod dynamics;
mod inverse_dynamics;

use super::added::Added;
use super::block::scalar;
use super::costs::more;
use super::step::step;
use crate::compiled::ForcePrograms;
use crate::model::Model;
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// What there is to write it with.
struct Writer<'w> {
    places: &'w Places,
    model: &'w Model,
    program: &'w Program,
    visibility: &'w syn::Visibility,
    scalar: TokenStream,
    motors: Literal,
    has_loads: bool,
    /// What a move without rates leaves behind.
    standstill: TokenStream,
    /// What every move ends with.
    record: &'w TokenStream,
}

/// What forces add to a mechanism. `rest` is what velocities leave behind when it is held.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    (program, forced): (&Program, &ForcePrograms),
    visibility: &syn::Visibility,
    (standstill, record): (&TokenStream, &TokenStream),
) -> Added {
    if !model.effects.needs_actions() {
        return Added::default();
    }
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let unmoved = if model.effects.dynamics {
        quote!(self.rates = [0.0; #motors];)
    } else {
        TokenStream::new()
    };
    let loads = model.actions.load_names().len();
    let writer = Writer {
        places,
        model,
        program,
        visibility,
        scalar: scalar(program),
        motors,
        has_loads: loads > 0,
        standstill: quote!(#standstill #unmoved #record),
        record,
    };
    let mut items = Added { ..Added::default() };
    let Writer { scalar, motors, .. } = &writer;
    if loads > 0 {
        let count = Literal::usize_unsuffixed(loads);
        items.fields = quote!(loads: [#krate::generated::#scalar; #count],);
        items.at_rest = quote!(loads: [0.0; #count],);
        items.methods.extend(writer.loads());
    }
    items.methods.extend(writer.springs());
    if let Some(holding) = &forced.holding {
        items.methods.extend(writer.holding(holding));
    }
    if let Some(inverse_dynamics) = &forced.inverse_dynamics {
        items
            .methods
            .extend(writer.inverse_dynamics(inverse_dynamics));
    }
    if let Some(inertia) = &forced.inertia {
        items
            .fields
            .extend(quote!(rates: [#krate::generated::#scalar; #motors],));
        items.at_rest.extend(quote!(rates: [0.0; #motors],));
        items.standstill = unmoved;
        items
            .instance_standstill
            .extend(quote!(instance.rates = [0.0; #motors];));
        items.methods.extend(writer.dynamics(inertia));
    }
    let programs = [
        (&forced.holding, "TORQUES_COST", "the torques that hold it"),
        (&forced.inverse_dynamics, "FORCES_COST", "all forces in it"),
        (
            &forced.inertia,
            "INERTIA_COST",
            "its inertia and what drives it",
        ),
    ];
    for (derived, name, what) in programs {
        if let Some(derived) = derived {
            let cost = more((program, derived), name, what, visibility);
            items.methods.extend(cost);
            items.steps.extend(step(krate, derived));
        }
    }
    items
}

impl Writer<'_> {
    /// The present loads as a variable, where a step takes them.
    fn given_loads(&self) -> TokenStream {
        if self.has_loads {
            quote!(let loads = self.loads;)
        } else {
            TokenStream::new()
        }
    }

    fn blocked(&self) -> TokenStream {
        let Self { scalar, motors, .. } = self;
        quote!(Blocked<[#scalar; #motors]>)
    }
}
