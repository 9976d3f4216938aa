//! The methods that read and set loads, and return the forces of springs.

use crate::emit::Parts;
use crate::emit::accessors::NamedPoint;
use crate::emit::advance::refusal_by;
use crate::emit::emitter::Emitter;
use crate::emit::tokens::{integer, setter};
use crate::model::{Between, Load, LoadKind};
use proc_macro2::TokenStream;
use quote::quote;

/// The field of all loads, and two methods for each; nothing without loads.
pub(super) fn loads(emitter: &Emitter<'_>) -> Parts {
    let actions = &emitter.model.actions;
    if actions.loads.is_empty() {
        return Parts::default();
    }
    let (scalar, count) = (emitter.scalar_path(), integer(actions.load_names().len()));
    let methods = actions.numbered_loads();
    let methods = methods.map(|(first, load)| self::load(emitter, first, load));
    Parts {
        fields: quote!(loads: [#scalar; #count],),
        start: quote!(loads: [0.0; #count],),
        methods: methods.collect(),
        ..Parts::default()
    }
}

/// The statement that binds the loads for a step that takes them.
pub(super) fn bind_loads(emitter: &Emitter<'_>) -> Option<TokenStream> {
    let has_loads = !emitter.model.actions.loads.is_empty();
    has_loads.then(|| quote!(let loads = self.loads;))
}

/// The methods of a load; `first` is the index of its first number.
fn load(emitter: &Emitter<'_>, first: usize, load: &Load) -> TokenStream {
    let Emitter { visibility, scalar, blocked, model, .. } = emitter;
    let name = &load.name;
    let refusal = refusal_by(emitter, &quote!(generated::not_finite(#name)));
    let getter = emitter.ident(name, load.origin);
    let setter = emitter.ident(&setter(name), load.origin);
    let [index, next] = [first, first + 1].map(integer);
    let (kind, value, is_finite, what) = match load.kind {
        LoadKind::Torque(link) => (
            quote!(#scalar),
            quote!(self.loads[#index]),
            quote!(Real::is_finite(load)),
            format!("the torque on link `{}`", model.link(link).name),
        ),
        LoadKind::Force(point) => {
            let NamedPoint { link_name, name, .. } = NamedPoint::new(model, point);
            (
                quote!([#scalar; 2]),
                quote!([self.loads[#index], self.loads[#next]]),
                quote!(Real::is_finite(load[0]) && Real::is_finite(load[1])),
                format!(
                    "the force at point `{name}` of link `{link_name}`, along the scene's x and y"
                ),
            )
        }
    };
    let doc = format!(" Load `{name}`: {what}.");
    let accessor = emitter.constant_accessor(&getter, &doc, &kind, &value);
    let doc = format!(" Sets load `{name}`: {what}.");
    quote! {
        #accessor

        #[doc = #doc]
        ///
        /// # Errors
        /// If it is not finite; the load then stays what it was.
        #visibility fn #setter(&mut self, load: #kind) -> Result<(), #blocked> {
            let is_finite = #is_finite;
            if !is_finite {
                return Result::Err(#refusal);
            }
            #value = load;
            Result::Ok(())
        }
    }
}

/// A method for the force of each spring between points.
pub(super) fn springs(emitter: &Emitter<'_>) -> Parts {
    let springs = emitter.model.actions.springs.iter();
    let methods = springs.filter_map(|spring| {
        let Between::Points(a, b) = spring.between else {
            return None;
        };
        let [from, to] = [a, b].map(|axis| emitter.point(axis));
        let [stiffness, rest] = [spring.stiffness, spring.rest].map(|value| emitter.number(value));
        let name = emitter.ident(&spring.name, spring.origin);
        let doc = format!(
            " The force with which spring `{}` pulls its ends together; negative if it pushes them apart.",
            spring.name
        );
        let value = quote!(generated::pull(#from, #to, #stiffness, #rest));
        Some(emitter.accessor(&name, &doc, &emitter.scalar, &value))
    });
    Parts::methods(methods.collect())
}
